// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of viewer.h.

#include "testbed/jobs/window/viewer.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "testbed/engines/engine_list.h"

namespace testbed {

namespace {

constexpr int paneGap = 4;                         // pixels between panes
constexpr int titleHeight = 20;                    // pixels at the top of a pane
constexpr int fitMargin = 16;                      // pixels around a fitted scene
constexpr double minScale = 1e-3, maxScale = 1e5;  // pixels per metre

/// New runs at their first step; the viewer changes only when all of them could be made.
void MakePanes(Viewer& viewer, const SceneInput& scene, std::vector<PaneChoice> choices) {
    std::vector<EnginePane> panes;
    const auto start = std::make_shared<const RunStart>(scene.Start());
    if (start->motion != nullptr) {
        EnginePane& pane = panes.emplace_back();
        pane.name = "as recorded";
        pane.run = std::make_unique<RunHistory>(start->motion, start->step);
    }
    const auto count = std::ranges::count_if(choices, &PaneChoice::isOn);
    const size_t limit = viewer.memoryLimit / static_cast<size_t>(std::max<std::ptrdiff_t>(count, 1));
    for (size_t i = 0; i < choices.size() && start->motion == nullptr; ++i) {
        if (!choices[i].isOn) continue;
        EnginePane& pane = panes.emplace_back();
        pane.name = choices[i].pane.name;
        pane.choice = i;
        pane.run =
            std::make_unique<RunHistory>([start, spec = choices[i].now] { return MakeRun(*start, spec); }, limit);
    }
    for (EnginePane& pane : panes) Capture(viewer, pane);
    viewer.panes = std::move(panes);
    viewer.choices = std::move(choices);
    viewer.scene = scene;
    viewer.names = NamesIn(*start);
    viewer.press.reset();
    viewer.drag.reset();
    viewer.query.reset();
    viewer.pickedBody = -1;
    viewer.bulletCount = 0;
    viewer.follows = false;
    viewer.moments.clear();
    for (size_t i = 0; i < viewer.panes.size(); ++i) RenewWatch(viewer, i);
}

void Rebuild(Viewer& viewer, std::vector<PaneChoice> choices) {
    const SceneInput scene = viewer.scene;
    MakePanes(viewer, scene, std::move(choices));
}

bool IsEdited(const Viewer& viewer, size_t choice) { return !viewer.edited || *viewer.edited == choice; }

}  // namespace

void Capture(Viewer& viewer, EnginePane& pane) {
    pane.run->Capture(pane.snapshot, {.pairs = false});
    pane.snapshot.pane = pane.name;
    pane.hoveredNode = -1;  // of nodes that are no more
    pane.trace.reset();
    if (!viewer.showTimes) pane.snapshot.times = {};
}

std::vector<PaneChoice> MakeChoices(const std::vector<Pane>& panes) {
    std::vector<PaneChoice> choices;
    for (const Pane& pane : panes) choices.push_back({.pane = pane, .isOn = true, .now = pane.spec});
    for (const EngineInfo& engine : GetEngines()) {
        if (std::ranges::any_of(panes, [&](const Pane& pane) { return pane.spec.engine == engine.name; })) continue;
        const RunSpec spec = MakeSpec(engine.name, likeBox2dPreset);
        choices.push_back({.pane = {std::string(engine.name), spec}, .isOn = false, .now = spec});
    }
    return choices;
}

namespace {

void StopAtNoExpression(Viewer& viewer) {
    viewer.conditions.when.clear();
    viewer.whenText.clear();
}

}  // namespace

void LoadScene(Viewer& viewer, const SceneInput& scene) {
    std::vector<PaneChoice> choices = viewer.choices;
    for (PaneChoice& choice : choices) {
        RunSpec spec = choice.pane.spec;
        spec.continuous = choice.now.continuous;
        spec.broadPhase = choice.now.broadPhase;
        choice.now = std::move(spec);
    }
    // Conditions of one scene name bodies that another one does not have.
    if (scene.name != viewer.scene.name && !viewer.panes.empty()) StopAtNoExpression(viewer);
    MakePanes(viewer, scene, std::move(choices));
    const auto* si = std::get_if<SequentialImpulses>(&GetShownSpec(viewer).solver);
    viewer.iterations = si != nullptr ? *si->iterations : Iterations{};
    viewer.mustFit = true;
    viewer.message = fmt::format("{} loaded, {} bodies", scene.name, viewer.panes.front().snapshot.bodies.size());
}

void Restart(Viewer& viewer) {
    Rebuild(viewer, viewer.choices);
    viewer.message = "restarted";
}

void LoadNeighbour(Viewer& viewer, int offset) {
    const auto catalog = scenes::Catalog();
    const auto count = static_cast<std::ptrdiff_t>(catalog.size());
    const std::ptrdiff_t between = offset > 0 ? -1 : 0;
    const std::ptrdiff_t at = viewer.scene.info != nullptr ? viewer.scene.info - catalog.data() : between;
    const scenes::SceneInfo& info = catalog[static_cast<size_t>(((at + offset) % count + count) % count)];
    LoadScene(viewer, MakeInput(info, info.defaultSize));
}

void TogglePane(Viewer& viewer, size_t choice) {
    std::vector<PaneChoice> choices = viewer.choices;
    choices[choice].isOn = !choices[choice].isOn;
    if (std::ranges::none_of(choices, &PaneChoice::isOn)) return;
    Rebuild(viewer, std::move(choices));
    viewer.message = "engines changed: restarted";
}

void SetBroadPhase(Viewer& viewer, std::string_view name) {
    std::vector<PaneChoice> choices = viewer.choices;
    for (size_t i = 0; i < choices.size(); ++i) {
        if (IsEdited(viewer, i)) (void)ApplySetting(choices[i].now, fmt::format("broadPhase={}", name));
    }
    Rebuild(viewer, std::move(choices));
    viewer.message = fmt::format("broad phase {}: restarted", name);
}

const RunSpec& GetShownSpec(const Viewer& viewer) {
    for (const EnginePane& pane : viewer.panes) {
        if (viewer.edited && pane.choice == *viewer.edited) return pane.run->GetSpec();
    }
    return viewer.panes.front().run->GetSpec();
}

void ChangeSettings(Viewer& viewer, const std::function<void(RunSpec&)>& change) {
    std::vector<PaneChoice> choices = viewer.choices;
    for (size_t i = 0; i < choices.size(); ++i) {
        if (!IsEdited(viewer, i)) continue;
        change(choices[i].now);
        if (const std::string problem = FindProblem(choices[i].now); !problem.empty()) {
            throw std::invalid_argument(problem);
        }
    }
    for (size_t i = 0; i < viewer.panes.size(); ++i) {
        const RunSpec& spec = choices[viewer.panes[i].choice].now;
        DoInPane(viewer, i, false, [&](RunHistory& run) { run.Apply(spec); });
    }
    viewer.choices = std::move(choices);
}

void SetIterations(Viewer& viewer, Iterations iterations) {
    ChangeSettings(viewer, [&](RunSpec& spec) {
        if (std::holds_alternative<SequentialImpulses>(spec.solver)) spec.solver = SequentialImpulses{iterations};
    });
    viewer.iterations = iterations;
}

void SetSubsteps(Viewer& viewer, int substeps) {
    ChangeSettings(viewer, [&](RunSpec& spec) {
        if (!FindEngine(spec.engine).abilities.Has(Ability::softSteps)) return;
        spec.solver = substeps > 0 ? Solver(SoftStep{substeps}) : Solver(SequentialImpulses{viewer.iterations});
    });
}

void StepAll(Viewer& viewer) {
    const bool isOdd = !viewer.panes.empty() && viewer.panes.front().run->GetStep() % 2 != 0;
    // In turn first, so that noise of the machine hits all alike.
    for (size_t i = 0; i < viewer.panes.size(); ++i) {
        EnginePane& pane = viewer.panes[isOdd ? viewer.panes.size() - 1 - i : i];
        if (!pane.run->Step()) continue;
        if (pane.history.size() == historyLength) pane.history.erase(pane.history.begin());
        pane.history.push_back(viewer.showTimes ? pane.run->GetTimes() : StepTimes{});
    }
    for (size_t i = 0; i < viewer.panes.size(); ++i) {
        Capture(viewer, viewer.panes[i]);
        if (viewer.panes[i].run->GetStep() > viewer.panes[i].watched) ShowToWatch(viewer, i);
    }
}

void DoInPane(Viewer& viewer, size_t index, bool renews, const std::function<void(RunHistory&)>& action) {
    EnginePane& pane = viewer.panes[index];
    const bool isPast = pane.run->GetStep() < pane.run->GetLastStep() && !pane.run->IsMotion();
    action(*pane.run);
    if (!isPast && !renews) return;
    Capture(viewer, pane);
    RenewWatch(viewer, index);
}

void BeginDrag(Viewer& viewer, const EnginePane& pane, int place, Vec2 point) {
    const BodyState& body = pane.snapshot.bodies[static_cast<size_t>(place)];
    const int index = body.index;
    viewer.pickedBody = index;
    if (pane.run->IsMotion()) return;
    const Vec2 localPoint = ToLocal(body, point);
    for (size_t i = 0; i < viewer.panes.size(); ++i) {
        DoInPane(viewer, i, false, [&](RunHistory& run) {
            run.BeginDrag(index, localPoint);
            run.MoveDrag(point);
        });
    }
    viewer.drag = Drag{index, localPoint, point};
}

void MoveDrag(Viewer& viewer, Vec2 target) {
    if (!viewer.drag || viewer.drag->target == target) return;
    viewer.drag->target = target;
    for (EnginePane& pane : viewer.panes) pane.run->MoveDrag(target);
}

void EndDrag(Viewer& viewer) {
    for (EnginePane& pane : viewer.panes) pane.run->EndDrag();
    viewer.drag.reset();
}

void ShootBullet(Viewer& viewer, Vec2 from, Vec2 velocity) {
    for (size_t i = 0; i < viewer.panes.size(); ++i) {
        DoInPane(viewer, i, true, [&](RunHistory& run) { run.ShootBullet(from, velocity); });
    }
    ++viewer.bulletCount;
    viewer.message = "bullet shot";
}

Camera GetCamera(const Viewer& viewer, const EnginePane& pane) {
    Camera camera;
    camera.x = viewer.cameraX;
    camera.y = viewer.cameraY;
    camera.pixelsPerMetre = viewer.pixelsPerMetre;
    camera.width = pane.area.x1 - pane.area.x0;
    camera.height = pane.area.y1 - pane.area.y0;
    return camera;
}

Vec2 ToWorldPoint(const Camera& camera, double pixelX, double pixelY) {
    return {static_cast<float>(camera.x + (pixelX - camera.width * 0.5) / camera.pixelsPerMetre),
            static_cast<float>(camera.y - (pixelY - camera.height * 0.5) / camera.pixelsPerMetre)};
}

void ZoomAt(Viewer& viewer, const EnginePane& pane, double pixelX, double pixelY, double factor) {
    const double offsetX = pixelX - (pane.area.x1 - pane.area.x0) * 0.5;
    const double offsetY = pixelY - (pane.area.y1 - pane.area.y0) * 0.5;
    const double before = viewer.pixelsPerMetre;
    viewer.pixelsPerMetre = std::clamp(before * factor, minScale, maxScale);
    viewer.cameraX += offsetX / before - offsetX / viewer.pixelsPerMetre;
    viewer.cameraY -= offsetY / before - offsetY / viewer.pixelsPerMetre;
}

void ArrangePanes(Viewer& viewer, const PixelBox& area) {
    const int count = static_cast<int>(viewer.panes.size());
    const auto widthOf = [&](bool isBeside) {
        return std::max(isBeside ? (area.x1 - area.x0 - (count - 1) * paneGap) / count : area.x1 - area.x0, 1);
    };
    const auto heightOf = [&](bool isBeside) {
        return std::max(isBeside ? area.y1 - area.y0 : (area.y1 - area.y0 - (count - 1) * paneGap) / count, 1);
    };
    if (viewer.mustFit) {
        std::vector<const Snapshot*> snapshots;
        for (const EnginePane& pane : viewer.panes) snapshots.push_back(&pane.snapshot);
        FitArea fitArea;
        AddStep(fitArea, snapshots);
        const std::vector<Box> boxes = GetFitBoxes(fitArea);
        const auto fit = [&](bool isBeside) {
            return FitCamera(boxes, widthOf(isBeside), heightOf(isBeside),
                             {fitMargin, fitMargin + titleHeight, fitMargin, fitMargin});
        };
        const Camera beside = fit(true), above = fit(false);
        viewer.isBeside = viewer.look.layout == PaneLayout::automatic ? beside.pixelsPerMetre >= above.pixelsPerMetre
                                                                      : viewer.look.layout == PaneLayout::beside;
        const Camera& camera = viewer.isBeside ? beside : above;
        viewer.pixelsPerMetre = std::clamp(camera.pixelsPerMetre, minScale, maxScale);
        viewer.cameraX = camera.x - camera.offsetX / viewer.pixelsPerMetre;
        viewer.cameraY = camera.y + camera.offsetY / viewer.pixelsPerMetre;
        if (viewer.camera) {
            viewer.pixelsPerMetre = std::clamp(widthOf(viewer.isBeside) / viewer.camera->across, minScale, maxScale);
            viewer.cameraX = viewer.camera->x;
            viewer.cameraY = viewer.camera->y;
            viewer.camera.reset();
        }
        viewer.mustFit = false;
    }
    const int width = widthOf(viewer.isBeside), height = heightOf(viewer.isBeside);
    for (int i = 0; i < count; ++i) {
        const int x = viewer.isBeside ? area.x0 + i * (width + paneGap) : area.x0;
        const int y = viewer.isBeside ? area.y0 : area.y0 + i * (height + paneGap);
        viewer.panes[static_cast<size_t>(i)].area = {x, y, x + width, y + height};
    }
}

int GetTreeHeight(const Viewer& viewer) {
    int height = 0;
    for (const EnginePane& pane : viewer.panes) {
        for (const NodeState& node : pane.snapshot.nodes) height = std::max(height, node.level);
    }
    return height;
}

}  // namespace testbed
