// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of viewer.h.

#include "testbed/jobs/window/viewer.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace testbed {

namespace {

constexpr int paneGap = 4;                         // pixels between panes
constexpr int titleHeight = 20;                    // pixels at the top of a pane
constexpr int fitMargin = 16;                      // pixels around a fitted scene
constexpr double minScale = 1e-3, maxScale = 1e5;  // pixels per metre

void Capture(Viewer& viewer, EnginePane& pane) {
    pane.run->Capture(pane.snapshot, {.pairs = false});
    if (!viewer.showTimes) pane.snapshot.times = {};
}

/// New runs at step 0; the viewer changes only when all of them could be made.
void MakePanes(Viewer& viewer, const scenes::Scene& scene, const std::array<bool, 2>& engines,
               const std::string& broadPhase) {
    RunOptions options;
    options.broadPhase = broadPhase;
    options.continuous = viewer.settings.continuous;
    std::vector<EnginePane> panes;
    for (size_t i = 0; i < viewerEngines.size(); ++i) {
        if (!engines[i]) continue;
        EnginePane& pane = panes.emplace_back();
        pane.engine = viewerEngines[i];
        pane.run = MakeInteractiveRun(pane.engine, scene, options);
    }
    for (EnginePane& pane : panes) Capture(viewer, pane);
    viewer.panes = std::move(panes);
    viewer.engines = engines;
    viewer.broadPhase = broadPhase;
    viewer.press.reset();
    viewer.drag.reset();
    viewer.query.reset();
    viewer.pickedBody = -1;
    viewer.bulletCount = 0;
}

/// From the beginning with other engines or another broad phase, keeping the settings that the user chose.
void Rebuild(Viewer& viewer, const std::array<bool, 2>& engines, const std::string& broadPhase) {
    const SolverSettings settings = viewer.settings;
    MakePanes(viewer, scenes::Build(viewer.info->name, viewer.size), engines, broadPhase);
    ApplySettings(viewer, settings);
}

}  // namespace

void LoadScene(Viewer& viewer, const scenes::SceneInfo& info, int size) {
    MakePanes(viewer, scenes::Build(info.name, size), viewer.engines, viewer.broadPhase);
    viewer.info = &info;
    viewer.size = size;
    viewer.settings = viewer.panes.front().run->GetSettings();
    viewer.mustFit = true;
    viewer.message = fmt::format("{} loaded, {} bodies", info.name, viewer.panes.front().snapshot.bodies.size());
}

void Restart(Viewer& viewer) {
    Rebuild(viewer, viewer.engines, viewer.broadPhase);
    viewer.message = "restarted";
}

void LoadNeighbour(Viewer& viewer, int offset) {
    const auto catalog = scenes::Catalog();
    const auto count = static_cast<std::ptrdiff_t>(catalog.size());
    const std::ptrdiff_t at = viewer.info - catalog.data();
    const scenes::SceneInfo& info = catalog[static_cast<size_t>(((at + offset) % count + count) % count)];
    LoadScene(viewer, info, info.defaultSize);
}

void ToggleEngine(Viewer& viewer, size_t engine) {
    std::array<bool, 2> engines = viewer.engines;
    engines[engine] = !engines[engine];
    if (!engines[0] && !engines[1]) return;
    Rebuild(viewer, engines, viewer.broadPhase);
    viewer.message = "engines changed: restarted";
}

void SetBroadPhase(Viewer& viewer, std::string_view name) {
    Rebuild(viewer, viewer.engines, std::string(name));
    viewer.message = fmt::format("broad phase {}: restarted", name);
}

void ApplySettings(Viewer& viewer, const SolverSettings& settings) {
    for (EnginePane& pane : viewer.panes) pane.run->Apply(settings);
    viewer.settings = settings;
}

void StepAll(Viewer& viewer) {
    const bool isOdd = !viewer.panes.empty() && viewer.panes.front().run->GetStep() % 2 != 0;
    // In turn first, so that noise of the machine hits both alike.
    for (size_t i = 0; i < viewer.panes.size(); ++i) {
        EnginePane& pane = viewer.panes[isOdd ? viewer.panes.size() - 1 - i : i];
        pane.run->Step();
        if (pane.history.size() == historyLength) pane.history.erase(pane.history.begin());
        pane.history.push_back(viewer.showTimes ? pane.run->GetTimes() : StepTimes{});
    }
    for (EnginePane& pane : viewer.panes) Capture(viewer, pane);
}

void BeginDrag(Viewer& viewer, const EnginePane& pane, int body, Vec2 point) {
    const Vec2 localPoint = ToLocal(pane.snapshot.bodies[static_cast<size_t>(body)], point);
    for (EnginePane& other : viewer.panes) {
        other.run->BeginDrag(body, localPoint);
        other.run->MoveDrag(point);
    }
    viewer.drag = Drag{body, localPoint, point};
    viewer.pickedBody = body;
}

void MoveDrag(Viewer& viewer, Vec2 target) {
    if (!viewer.drag) return;
    viewer.drag->target = target;
    for (EnginePane& pane : viewer.panes) pane.run->MoveDrag(target);
}

void EndDrag(Viewer& viewer) {
    for (EnginePane& pane : viewer.panes) pane.run->EndDrag();
    viewer.drag.reset();
}

void ShootBullet(Viewer& viewer, Vec2 from, Vec2 velocity) {
    for (EnginePane& pane : viewer.panes) {
        pane.run->ShootBullet(from, velocity);
        Capture(viewer, pane);
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
        std::vector<Box> boxes;
        for (const EnginePane& pane : viewer.panes) {
            for (const FixtureState& fixture : pane.snapshot.fixtures) boxes.push_back(fixture.tight);
        }
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
