// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of frame.h.

#include "testbed/jobs/window/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "testbed/base/json_print.h"
#include "testbed/base/text.h"
#include "testbed/engines/engine_list.h"
#include "testbed/jobs/window/inspector.h"
#include "testbed/jobs/window/panels.h"
#include "testbed/jobs/window/scene_view.h"
#include "testbed/jobs/window/window_colors.h"

namespace testbed {

namespace {

using nlohmann::ordered_json;

ordered_json ToJson(Vec2 v) { return {v.x, v.y}; }
ordered_json ToJson(const Box& box) { return {box.lower.x, box.lower.y, box.upper.x, box.upper.y}; }

ordered_json ToJson(const RunValues& values) {
    ordered_json json = ordered_json::object();
    for (const RunValue& value : values) json[value.name] = value.value;
    return json;
}

ordered_json ToJson(const std::vector<InspectedPart>& parts) {
    ordered_json json = ordered_json::array();
    for (const InspectedPart& part : parts) json.push_back({{"title", part.title}, {"values", ToJson(part.values)}});
    return json;
}

ordered_json DescribePane(const Viewer& viewer, const EnginePane& pane) {
    const Snapshot& s = pane.snapshot;
    ordered_json json{{"engine", s.engine},
                      {"pane", pane.name},
                      {"settings", PrintSettings(viewer.choices[pane.choice].now)},
                      {"broad_phase", s.broadPhase},
                      {"step", s.step},
                      {"bodies", s.bodies.size()},
                      {"contacts", s.contactCount},
                      {"nodes", s.nodes.size()},
                      {"state_hash", FormatHash(s.stateHash)},
                      {"area", {pane.area.x0, pane.area.y0, pane.area.x1, pane.area.y1}}};
    json["exact"] = pane.run->IsExact();
    json["memory"] = pane.run->GetBytes();
    if (const int place = FindBody(s, viewer.pickedBody); place >= 0) {
        const BodyState& body = s.bodies[static_cast<size_t>(place)];
        const Inspection inspection = Inspect(viewer, pane);
        json["inspected"] = {{"title", inspection.title},
                             {"values", ToJson(inspection.values)},
                             {"shapes", ToJson(inspection.shapes)},
                             {"contacts", ToJson(inspection.contacts)},
                             {"joints", ToJson(inspection.joints)}};
        json["picked"] = {
            {"position", ToJson(body.position)}, {"velocity", ToJson(body.linearVelocity)}, {"awake", body.awake}};
    }
    if (pane.hoveredNode >= 0) {
        const NodeState& node = s.nodes[static_cast<size_t>(pane.hoveredNode)];
        json["hovered"] = {{"node", pane.hoveredNode},
                           {"level", node.level},
                           {"path", DescribePath(s.nodes, pane.hoveredNode)},
                           {"box", ToJson(node.box)},
                           {"leaves", CountLeaves(s.nodes, pane.hoveredNode)}};
    }
    if (pane.trace) {
        json["trace"] = {
            {"visited", pane.trace->visited.size()}, {"tested", pane.trace->tested}, {"leaves", pane.trace->leaves}};
    }
    return json;
}

/// The picked body in the middle of the panes.
void Follow(Viewer& viewer) {
    if (!viewer.follows) return;
    const Snapshot& snapshot = viewer.panes[std::min(viewer.inspectedPane, viewer.panes.size() - 1)].snapshot;
    const int place = FindBody(snapshot, viewer.pickedBody);
    if (place < 0) return;
    viewer.cameraX = double{snapshot.bodies[static_cast<size_t>(place)].position.x};
    viewer.cameraY = double{snapshot.bodies[static_cast<size_t>(place)].position.y};
}

ordered_json DescribeTime(const Viewer& viewer) {
    ordered_json moments = ordered_json::array();
    for (const BreakMoment& one : viewer.moments) {
        moments.push_back({{"pane", viewer.panes[one.pane].name},
                           {"condition", one.moment.condition},
                           {"step", one.moment.step},
                           {"bodies", one.moment.bodies}});
    }
    return {
        {"step", GetStep(viewer)},           {"first_step", GetFirstStep(viewer)}, {"last_step", GetLastStep(viewer)},
        {"backwards", viewer.playsBackward}, {"memory_limit", viewer.memoryLimit}, {"moments", moments}};
}

}  // namespace

void DrawFrame(Viewer& viewer, Gui& gui, Items& items, WindowRenderer& renderer, const FrameInput& input) {
    gui.SetTheme(viewer.look.theme);
    gui.BeginFrame(input.events, input.width, input.height, input.deltaTime);
    const auto arrange = [&] { ArrangePanes(viewer, GetSceneArea(viewer, input.width, input.height)); };
    arrange();
    HandleInput(viewer);
    Advance(viewer);
    StopIfFound(viewer);
    Follow(viewer);
    arrange();  // a key may have changed panes or panels
    UpdateFindings(viewer);
    DrawPanels(viewer, items, input.width, input.height);
    StopIfFound(viewer);  // a panel may have stepped
    Follow(viewer);
    UpdateFindings(viewer);
    arrange();  // and so may a panel
    const std::vector<DrawList> lists = BuildPaneLists(viewer);
    DrawOverlay(viewer, lists);
    const ImDrawData& panels = gui.EndFrame();

    renderer.Begin(input.width, input.height, GetWindowColors(viewer.look.theme).gap);
    const std::vector<Color> palette = MakeLookPalette(viewer.look);
    for (size_t i = 0; i < viewer.panes.size(); ++i) {
        const EnginePane& pane = viewer.panes[i];
        renderer.DrawCounts(pane.area, ProjectNodes(viewer, pane), palette);
        renderer.DrawLayers(pane.area, lists[i]);
    }
    renderer.DrawPanels(panels);
}

std::string WriteState(const Viewer& viewer) {
    const RunSpec& s = GetShownSpec(viewer);
    const auto* si = std::get_if<SequentialImpulses>(&s.solver);
    const auto* soft = std::get_if<SoftStep>(&s.solver);
    const Iterations iterations = si != nullptr ? *si->iterations : viewer.iterations;
    const auto ours = std::ranges::find_if(viewer.choices, [](const PaneChoice& choice) {
        return FindEngine(choice.pane.spec.engine).abilities.Has(Ability::broadPhases);
    });
    ordered_json layers = ordered_json::array();
    for (const LayerInfo& layer : layerTable) {
        if (viewer.look.layers.Has(layer.layer)) layers.push_back(layer.name);
    }
    ordered_json json{{"scene", viewer.scene.name},
                      {"size", viewer.scene.size},
                      {"paused", viewer.isPaused},
                      {"broad_phase", ours == viewer.choices.end() ? "" : ours->now.broadPhase},
                      {"settings",
                       {{"time_step", static_cast<float>(*s.timeStep)},
                        {"velocity_iterations", iterations.velocity},
                        {"position_iterations", iterations.position},
                        {"substeps", soft != nullptr ? soft->substeps : 0},
                        {"gravity", ToJson(*s.gravity)},
                        {"sleeping", s.sleeping},
                        {"warm_starting", s.warmStarting},
                        {"continuous", s.continuous}}},
                      {"camera", {viewer.cameraX, viewer.cameraY, viewer.pixelsPerMetre}},
                      {"layers", layers},
                      {"overlap", viewer.look.overlap},
                      {"nodes", GetNodeSelectionName(viewer.look.nodes)},
                      {"style", GetStyleName(viewer.look.style)},
                      {"theme", GetThemeName(viewer.look.theme)},
                      {"panels", viewer.look.panels},
                      {"search", viewer.search},
                      {"bullets", viewer.bulletCount},
                      {"picked_body", viewer.pickedBody},
                      {"follows", viewer.follows},
                      {"time", DescribeTime(viewer)},
                      {"dragging", viewer.drag.has_value()},
                      {"message", viewer.message}};
    if (viewer.query) json["query"] = {{"point", ToJson(*viewer.query)}, {"size", viewer.querySize}};
    json["engines"] = ordered_json::array();
    for (const EnginePane& pane : viewer.panes) json["engines"].push_back(DescribePane(viewer, pane));
    return PrintJson(json, 1) + "\n";
}

}  // namespace testbed
