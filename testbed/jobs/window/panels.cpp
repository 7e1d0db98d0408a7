// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Layout, the bar at the top, and the panels of the solver and of what is drawn.

#include "testbed/jobs/window/panels.h"

#include <fmt/format.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "scree/broad_phase_kind.h"
#include "testbed/engines/engine_list.h"
#include "testbed/jobs/window/window_colors.h"

namespace testbed {

namespace {

constexpr int barHeight = 34, leftWidth = 236, rightWidth = 312, bottomHeight = 156, timeHeight = 108,
              solverHeight = 320;  // pixels

constexpr ImGuiWindowFlags panelFlags = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                        ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                        ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav;

bool BeginPanel(const char* title, const PixelBox& box, ImGuiWindowFlags flags = 0) {
    ImGui::SetNextWindowPos({static_cast<float>(box.x0), static_cast<float>(box.y0)});
    ImGui::SetNextWindowSize({static_cast<float>(box.x1 - box.x0), static_cast<float>(box.y1 - box.y0)});
    return ImGui::Begin(title, nullptr, panelFlags | flags);
}

/// Runs what a widget asked for; a refusal becomes the message.
template <typename Action>
void Try(Viewer& viewer, Action&& action) {
    try {
        action();
    } catch (const std::exception& error) {
        viewer.message = error.what();
    }
}

bool Button(Items& items, const char* label, const char* name) {
    const bool isPressed = ImGui::Button(label);
    MarkItem(items, name);
    return isPressed;
}

void DrawBar(Viewer& viewer, Items& items) {
    if (Button(items, viewer.isPaused ? "Play P" : "Pause P", "pause")) {
        viewer.isPaused = !viewer.isPaused;
        viewer.playsBackward = false;
    }
    ImGui::SameLine();
    if (Button(items, "Step O", "step")) {
        viewer.isPaused = true;
        StepAll(viewer);
    }
    ImGui::SameLine();
    if (Button(items, "Restart R", "restart")) Try(viewer, [&] { Restart(viewer); });
    ImGui::SameLine();
    if (Button(items, "[ Previous", "previous")) Try(viewer, [&] { LoadNeighbour(viewer, -1); });
    ImGui::SameLine();
    if (Button(items, "Next ]", "next")) Try(viewer, [&] { LoadNeighbour(viewer, 1); });
    ImGui::SameLine();
    if (Button(items, "Fit F", "fit")) viewer.mustFit = true;
    ImGui::SameLine();
    if (Button(items, "Screenshot F12", "screenshot")) viewer.wantsScreenshot = true;
    for (size_t i = 0; i < viewer.choices.size(); ++i) {
        ImGui::SameLine(0, i == 0 ? 18.0f : -1.0f);
        bool isOn = viewer.choices[i].isOn;
        const std::string name = viewer.choices[i].pane.name;
        ImGui::PushStyleColor(ImGuiCol_Text, GetPaneColor(viewer, i));
        if (ImGui::Checkbox(name.c_str(), &isOn)) Try(viewer, [&] { TogglePane(viewer, i); });
        ImGui::PopStyleColor();
        MarkItem(items, fmt::format("engine.{}", name));
    }
    ImGui::SameLine(0, 18);
    ImGui::AlignTextToFramePadding();
    const int step = viewer.panes.empty() ? 0 : viewer.panes.front().snapshot.step;
    std::string status = fmt::format("{}  step {}", viewer.scene.name, step);
    if (viewer.isPaused) status += "  paused";
    if (viewer.framesPerSecond > 0) status += fmt::format("  {:.0f} fps", viewer.framesPerSecond);
    ImGui::TextUnformatted(status.c_str());
    if (!viewer.message.empty()) {
        ImGui::SameLine(0, 18);
        ImGui::TextDisabled("%s", viewer.message.c_str());
    }
}

/// Of the edited pane of our engine, else of the first.
std::string GetBroadPhase(const Viewer& viewer) {
    std::string found;
    for (size_t i = 0; i < viewer.choices.size(); ++i) {
        const RunSpec& spec = viewer.choices[i].now;
        if (!FindEngine(spec.engine).abilities.Has(Ability::broadPhases)) continue;
        if (found.empty() || viewer.edited == i) found = spec.broadPhase;
    }
    return found;
}

/// Which pane the settings are of, where one engine runs in several.
void DrawEdited(Viewer& viewer, Items& items) {
    const bool isSeveral = viewer.choices.size() > GetEngines().size();
    if (!isSeveral) return;
    const auto name = [&](std::optional<size_t> choice) {
        return choice ? viewer.choices[*choice].pane.name : std::string("all panes");
    };
    ImGui::SetNextItemWidth(-1);
    const bool isOpen = ImGui::BeginCombo("##edited", name(viewer.edited).c_str());
    MarkItem(items, "solver.pane");
    if (!isOpen) return;
    const auto offer = [&](std::optional<size_t> choice) {
        if (ImGui::Selectable(name(choice).c_str(), choice == viewer.edited)) viewer.edited = choice;
        MarkItem(items, fmt::format("pane.{}", choice ? name(choice) : "all"));
    };
    offer(std::nullopt);
    for (size_t i = 0; i < viewer.choices.size(); ++i) offer(i);
    ImGui::EndCombo();
}

void DrawSolver(Viewer& viewer, Items& items) {
    DrawEdited(viewer, items);
    const RunSpec before = GetShownSpec(viewer);
    RunSpec s = before;
    const auto* si = std::get_if<SequentialImpulses>(&s.solver);
    const auto* soft = std::get_if<SoftStep>(&s.solver);
    const Iterations shownIterations = si != nullptr ? *si->iterations : viewer.iterations;
    const int shownSubsteps = soft != nullptr ? soft->substeps : 0;
    Iterations iterations = shownIterations;
    int substeps = shownSubsteps;
    ImGui::PushItemWidth(112);
    ImGui::SliderInt("velocity its", &iterations.velocity, 1, 50);
    MarkSlider(items, "solver.velocity");
    ImGui::SliderInt("position its", &iterations.position, 0, 20);
    MarkSlider(items, "solver.position");
    ImGui::SliderInt("soft steps", &substeps, 0, 16, substeps == 0 ? "off" : "%d");
    MarkSlider(items, "solver.substeps");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("scree only; off: sequential impulses with the iterations");
    float hertz = static_cast<float>(1 / *s.timeStep);
    if (ImGui::SliderFloat("steps per s", &hertz, 15, 480, "%.0f", ImGuiSliderFlags_Logarithmic)) {
        s.timeStep = double{1 / std::clamp(hertz, 10.0f, 10000.0f)};
    }
    MarkSlider(items, "solver.hertz");
    ImGui::SliderFloat("gravity x", &s.gravity->x, -30, 30, "%.1f");
    MarkSlider(items, "solver.gravity-x");
    ImGui::SliderFloat("gravity y", &s.gravity->y, -30, 30, "%.1f");
    MarkSlider(items, "solver.gravity-y");
    ImGui::Checkbox("sleeping", &s.sleeping);
    MarkItem(items, "solver.sleeping");
    ImGui::Checkbox("warm starting", &s.warmStarting);
    MarkItem(items, "solver.warm-starting");
    ImGui::Checkbox("continuous", &s.continuous);
    MarkItem(items, "solver.continuous");
    iterations.velocity = std::clamp(iterations.velocity, 1, 200);
    iterations.position = std::clamp(iterations.position, 0, 200);
    substeps = std::clamp(substeps, 0, 64);
    if (iterations != shownIterations) Try(viewer, [&] { SetIterations(viewer, iterations); });
    if (substeps != shownSubsteps) Try(viewer, [&] { SetSubsteps(viewer, substeps); });
    // Only what was changed: other panes may have other settings.
    const auto put = [&](auto member) {
        if (s.*member == before.*member) return;
        Try(viewer, [&] { ChangeSettings(viewer, [&](RunSpec& spec) { spec.*member = s.*member; }); });
    };
    put(&RunSpec::timeStep);
    put(&RunSpec::gravity);
    put(&RunSpec::sleeping);
    put(&RunSpec::warmStarting);
    put(&RunSpec::continuous);

    ImGui::PopItemWidth();
    ImGui::TextUnformatted("broad phase of scree");
    const std::string broadPhase = GetBroadPhase(viewer);
    ImGui::SetNextItemWidth(-1);
    const bool isOpen = ImGui::BeginCombo("##broad-phase", broadPhase.c_str(), ImGuiComboFlags_HeightLarge);
    MarkItem(items, "solver.broad-phase");
    if (!isOpen) return;
    for (const std::string_view name : scree::broadPhaseNames) {
        if (ImGui::Selectable(std::string(name).c_str(), name == broadPhase)) {
            Try(viewer, [&] { SetBroadPhase(viewer, name); });
        }
        MarkItem(items, fmt::format("broad-phase.{}", name));
    }
    ImGui::EndCombo();
}

void DrawLayerSwitches(Viewer& viewer, Items& items) {
    Layers& layers = viewer.look.layers;
    ImGui::Columns(2, nullptr, false);
    for (const LayerInfo& layer : layerTable) {
        bool isOn = layers.Has(layer.layer);
        if (ImGui::Checkbox(layer.name, &isOn)) layers.Set(layer.layer, isOn);
        MarkItem(items, fmt::format("layer.{}", layer.name));
        ImGui::NextColumn();
    }
    ImGui::Checkbox("overlap", &viewer.look.overlap);
    MarkItem(items, "layer.overlap");
    ImGui::Columns(1);
}

void DrawNodeSelection(Viewer& viewer, Items& items) {
    using Kind = NodeSelection::Kind;
    NodeSelection& nodes = viewer.look.nodes;
    int kind = static_cast<int>(nodes.kind);
    ImGui::SetNextItemWidth(130);
    if (ImGui::Combo("nodes", &kind, "internal\0leaves\0all\0levels\0")) nodes.kind = static_cast<Kind>(kind);
    MarkItem(items, "nodes.kind");
    const int height = std::max(GetTreeHeight(viewer), 1);
    int first = nodes.kind == Kind::levels ? nodes.firstLevel : 0;
    int last = nodes.kind == Kind::levels ? nodes.lastLevel : height;
    ImGui::PushItemWidth(130);
    const bool firstMoved = ImGui::SliderInt("first level", &first, 0, height);
    MarkSlider(items, "nodes.first");
    const bool lastMoved = ImGui::SliderInt("last level", &last, 0, height);
    MarkSlider(items, "nodes.last");
    ImGui::PopItemWidth();
    if (!firstMoved && !lastMoved) return;
    first = std::clamp(first, 0, height);
    last = std::clamp(last, 0, height);
    nodes = {Kind::levels, firstMoved ? first : std::min(first, last), firstMoved ? std::max(first, last) : last};
}

void DrawLook(Viewer& viewer, Items& items) {
    ViewerLook& look = viewer.look;
    ImGui::PushItemWidth(130);
    int style = static_cast<int>(look.style);
    if (ImGui::Combo("style", &style, "alpha\0heat\0bands\0log\0")) look.style = static_cast<Style>(style);
    MarkItem(items, "look.style");
    if (look.style == Style::alpha) {
        ImGui::SliderFloat("opacity", &look.opacity, 0.005f, 1, "%.3f", ImGuiSliderFlags_Logarithmic);
        MarkSlider(items, "look.opacity");
    } else {
        ImGui::SliderInt("scale end", &look.scaleMax, 2, 400);
        MarkSlider(items, "look.scale");
    }
    int layout = static_cast<int>(look.layout);
    if (ImGui::Combo("panes", &layout, "automatic\0beside\0above\0")) {
        look.layout = static_cast<PaneLayout>(layout);
        viewer.mustFit = true;
    }
    MarkItem(items, "look.layout");
    ImGui::SliderFloat("query size, m", &viewer.querySize, 0, 20, "%.1f");
    MarkSlider(items, "query.size");
    ImGui::PopItemWidth();
    ImGui::Checkbox("smooth edges", &look.smooth);
    MarkItem(items, "look.smooth");
    ImGui::SameLine();
    bool isLight = look.theme == Theme::light;
    if (ImGui::Checkbox("light", &isLight)) look.theme = isLight ? Theme::light : Theme::dark;
    MarkItem(items, "look.light");
    look.opacity = std::clamp(look.opacity, 0.005f, 1.0f);
    look.scaleMax = std::clamp(look.scaleMax, 2, 4000);
    viewer.querySize = std::clamp(viewer.querySize, 0.0f, 10000.0f);
}

/// The panel on the right: how the scenes look, or the picked body.
void DrawSide(Viewer& viewer, Items& items) {
    if (!ImGui::BeginTabBar("side")) return;
    const bool mustTurn = std::exchange(viewer.mustTurnPage, false);
    const auto flags = [&](bool isInspector) {
        return mustTurn && viewer.showsInspector == isInspector ? ImGuiTabItemFlags_SetSelected
                                                                : ImGuiTabItemFlags_None;
    };
    const bool isView = ImGui::BeginTabItem("View", nullptr, flags(false));
    MarkItem(items, "side.view");
    if (isView) {
        if (!mustTurn) viewer.showsInspector = false;
        DrawLayerSwitches(viewer, items);
        ImGui::Separator();
        DrawNodeSelection(viewer, items);
        ImGui::Separator();
        DrawLook(viewer, items);
        ImGui::Separator();
        DrawFindings(viewer);
        ImGui::EndTabItem();
    }
    const bool isInspector = ImGui::BeginTabItem("Inspect I", nullptr, flags(true));
    MarkItem(items, "side.inspect");
    if (isInspector) {
        if (!mustTurn) viewer.showsInspector = true;
        DrawInspector(viewer, items);
        ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
}

}  // namespace

PixelBox GetSceneArea(const Viewer& viewer, int width, int height) {
    if (!viewer.look.panels) return {0, 0, width, height};
    const int x1 = std::max(leftWidth + 1, width - rightWidth),
              y1 = std::max(barHeight + 1, height - bottomHeight - timeHeight);
    return {leftWidth, barHeight, x1, y1};
}

void DrawPanels(Viewer& viewer, Items& items, int width, int height) {
    items.clear();
    if (!viewer.look.panels) return;
    const PixelBox scene = GetSceneArea(viewer, width, height);
    if (BeginPanel("bar", {0, 0, width, barHeight}, ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoScrollbar)) {
        DrawBar(viewer, items);
    }
    ImGui::End();
    const int solverTop = std::max(barHeight + 1, height - solverHeight);
    if (BeginPanel("Scenes", {0, barHeight, leftWidth, solverTop})) DrawScenesPanel(viewer, items);
    ImGui::End();
    if (BeginPanel("Solver", {0, solverTop, leftWidth, height})) DrawSolver(viewer, items);
    ImGui::End();
    if (BeginPanel("##side", {scene.x1, barHeight, width, height}, ImGuiWindowFlags_NoTitleBar)) {
        DrawSide(viewer, items);
    }
    ImGui::End();
    const int timesTop = std::min(scene.y1 + timeHeight, height - 1);
    if (BeginPanel("##time-bar", {leftWidth, scene.y1, scene.x1, timesTop},
                   ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoScrollbar)) {
        DrawTimeBar(viewer, items);
    }
    ImGui::End();
    if (BeginPanel("Times", {leftWidth, timesTop, scene.x1, height})) DrawTimesPanel(viewer);
    ImGui::End();
}

}  // namespace testbed
