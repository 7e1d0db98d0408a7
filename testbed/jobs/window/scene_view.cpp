// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of scene_view.h.

#include "testbed/jobs/window/scene_view.h"

#include <fmt/format.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>
#include <exception>

#include "testbed/jobs/window/input_event.h"
#include "testbed/jobs/window/panels.h"
#include "testbed/jobs/window/window_colors.h"
#include "testbed/view/scene_layers.h"

namespace testbed {

namespace {

constexpr float clickDistance = 4;  // pixels that a click may move
constexpr float bulletSpeed = 100;  // m/s: below the 2 m a step at which both engines cap
constexpr float zoomPerScroll = 1.15f;
constexpr size_t maxHighlighted = 20000;  // nodes of a trace that are drawn
constexpr ImU32 noFill = 0;

bool IsInside(const PixelBox& box, float x, float y) {
    return x >= static_cast<float>(box.x0) && x < static_cast<float>(box.x1) && y >= static_cast<float>(box.y0) &&
           y < static_cast<float>(box.y1);
}

/// The pane under the pointer, or null.
EnginePane* FindPane(Viewer& viewer) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantCaptureMouse) return nullptr;
    for (EnginePane& pane : viewer.panes) {
        if (IsInside(pane.area, io.MousePos.x, io.MousePos.y)) return &pane;
    }
    return nullptr;
}

/// The world point of a pixel of the picture, seen from a pane.
Vec2 PointAt(const Viewer& viewer, const EnginePane& pane, float x, float y) {
    return ToWorldPoint(GetCamera(viewer, pane), double{x} - pane.area.x0, double{y} - pane.area.y0);
}

Box MakeQueryBox(Vec2 center, float size) {
    const float half = size / 2;
    return {{center.x - half, center.y - half}, {center.x + half, center.y + half}};
}

/// From the left border of the pane under the pointer, at the pointer's height; without one from the middle.
void Shoot(Viewer& viewer) {
    const EnginePane* pane = FindPane(viewer);
    const bool isPointed = pane != nullptr;
    if (!pane) pane = &viewer.panes.front();
    const float middle = static_cast<float>(pane->area.y0 + pane->area.y1) / 2;
    const float y = isPointed ? ImGui::GetIO().MousePos.y : middle;
    ShootBullet(viewer, PointAt(viewer, *pane, static_cast<float>(pane->area.x0), y), {bulletSpeed, 0});
}

void HandleKeys(Viewer& viewer) {
    const auto isPressed = [](int code) { return ImGui::IsKeyPressed(code, false); };
    const auto isHeld = [](int code) { return ImGui::IsKeyPressed(code, true); };
    if (isPressed('P')) {
        viewer.isPaused = !viewer.isPaused;
        viewer.playsBackward = false;
    }
    if (isPressed('J')) PlayBackward(viewer, viewer.isPaused || !viewer.playsBackward);
    if (isHeld(key::left)) GoToStep(viewer, GetStep(viewer) - 1);
    if (isHeld(key::right)) {
        viewer.isPaused = true;
        StepAll(viewer);
    }
    if (isPressed(key::home)) GoToStep(viewer, GetFirstStep(viewer));
    if (isPressed(key::end)) GoToStep(viewer, GetLastStep(viewer));
    if (isPressed('I')) {
        viewer.showsInspector = !viewer.showsInspector;
        viewer.mustTurnPage = true;
    }
    if (isPressed('O')) {
        viewer.isPaused = true;
        StepAll(viewer);
    }
    if (isPressed('R')) Restart(viewer);
    if (isPressed('[')) LoadNeighbour(viewer, -1);
    if (isPressed(']')) LoadNeighbour(viewer, 1);
    if (isPressed('F')) viewer.mustFit = true;
    if (isPressed('H')) viewer.look.panels = !viewer.look.panels;
    if (isPressed('B')) Shoot(viewer);
    if (isPressed(key::f12)) viewer.wantsScreenshot = true;
    if (isPressed(key::escape)) {
        viewer.query.reset();
        viewer.pickedBody = -1;
    }
}

/// Picks the body at a pixel; drags it as well, if asked.
void GrabBody(Viewer& viewer, const EnginePane& pane, float x, float y, bool drags) {
    const Vec2 point = PointAt(viewer, pane, x, y);
    const int place = FindBodyAt(pane.snapshot, point);
    if (place < 0) return;
    viewer.pickedBody = pane.snapshot.bodies[static_cast<size_t>(place)].index;
    if (drags) BeginDrag(viewer, pane, place, point);
}

void BeginPress(Viewer& viewer, EnginePane& pane, int button) {
    const ImVec2 at = ImGui::GetIO().MousePos;
    viewer.press = Press{static_cast<size_t>(&pane - viewer.panes.data()), at.x, at.y, button, false};
    if (button != 0) return;
    GrabBody(viewer, pane, at.x, at.y, GetStep(viewer) == GetLastStep(viewer));
}

void ContinuePress(Viewer& viewer) {
    const ImGuiIO& io = ImGui::GetIO();
    Press& press = *viewer.press;
    const bool hadMoved = press.hasMoved;
    press.hasMoved |= std::hypot(io.MousePos.x - press.x, io.MousePos.y - press.y) >= clickDistance;
    // In the past a press alone changes nothing: what came later would be forgotten for a look at a body.
    if (press.hasMoved && !hadMoved && press.button == 0 && !viewer.drag) {
        GrabBody(viewer, viewer.panes[press.pane], press.x, press.y, true);
    }
    if (viewer.drag) {
        MoveDrag(viewer, PointAt(viewer, viewer.panes[press.pane], io.MousePos.x, io.MousePos.y));
    } else if (press.hasMoved) {
        viewer.cameraX -= double{io.MouseDelta.x} / viewer.pixelsPerMetre;
        viewer.cameraY += double{io.MouseDelta.y} / viewer.pixelsPerMetre;
    }
}

void EndPress(Viewer& viewer) {
    const Press press = *viewer.press;
    if (viewer.drag) EndDrag(viewer);
    if (press.button == 0 && !press.hasMoved) {
        viewer.query = PointAt(viewer, viewer.panes[press.pane], press.x, press.y);
    }
    viewer.press.reset();
}

void HandleMouse(Viewer& viewer) {
    const ImGuiIO& io = ImGui::GetIO();
    if (viewer.press) {
        if (ImGui::IsMouseDown(viewer.press->button)) {
            ContinuePress(viewer);
        } else {
            EndPress(viewer);
        }
    }
    EnginePane* pane = FindPane(viewer);
    if (!pane) return;
    if (io.MouseWheel != 0) {
        ZoomAt(viewer, *pane, double{io.MousePos.x} - pane->area.x0, double{io.MousePos.y} - pane->area.y0,
               std::pow(double{zoomPerScroll}, double{io.MouseWheel}));
    }
    for (const int button : {0, 1, 2}) {
        if (!viewer.press && ImGui::IsMouseClicked(button)) BeginPress(viewer, *pane, button);
    }
}

/// Draws in one pane's pixels.
class PaneOverlay {
public:
    PaneOverlay(const Viewer& viewer, const EnginePane& pane)
        : m_viewer(viewer),
          m_pane(pane),
          m_camera(GetCamera(viewer, pane)),
          m_colors(GetWindowColors(viewer.look.theme)),
          m_list(*ImGui::GetBackgroundDrawList()) {}

    void Draw(const DrawList& layers) {
        const PixelBox& area = m_pane.area;
        m_list.PushClipRect({static_cast<float>(area.x0), static_cast<float>(area.y0)},
                            {static_cast<float>(area.x1), static_cast<float>(area.y1)});
        for (const TextItem& text : layers.texts) {
            const Color c = text.color;
            m_list.AddText({static_cast<float>(area.x0 + text.x), static_cast<float>(area.y0 + text.y)},
                           IM_COL32(c.r, c.g, c.b, c.a), text.text.c_str());
        }
        DrawTrace();
        DrawHovered();
        DrawDrag();
        DrawTitle();
        m_list.PopClipRect();
    }

private:
    [[nodiscard]] ImVec2 ToPixel(double x, double y) const {
        return {static_cast<float>(m_camera.ToPixelX(x) + m_pane.area.x0),
                static_cast<float>(m_camera.ToPixelY(y) + m_pane.area.y0)};
    }
    [[nodiscard]] ImVec2 ToPixel(Vec2 point) const { return ToPixel(double{point.x}, double{point.y}); }
    [[nodiscard]] const NodeState& GetNode(int node) const { return m_pane.snapshot.nodes[static_cast<size_t>(node)]; }
    void AddBox(const Box& box, ImU32 fill, ImU32 line, float width) {
        const ImVec2 lower = ToPixel(box.lower.x, box.upper.y), upper = ToPixel(box.upper.x, box.lower.y);
        if ((fill & IM_COL32_A_MASK) != 0) m_list.AddRectFilled(lower, upper, fill);
        m_list.AddRect(lower, upper, line, 0, 0, width);
    }
    void DrawTrace();
    void DrawHovered();
    void DrawDrag();
    void DrawTitle();

    const Viewer& m_viewer;
    const EnginePane& m_pane;
    Camera m_camera;
    const WindowColors& m_colors;
    ImDrawList& m_list;
};

void PaneOverlay::DrawTrace() {
    if (!m_viewer.query || !m_pane.trace) return;
    const auto& visited = m_pane.trace->visited;
    for (size_t i = 0; i < std::min(visited.size(), maxHighlighted); ++i) {
        const NodeState& node = GetNode(visited[i]);
        AddBox(node.box, node.child1 < 0 ? m_colors.leaf : noFill, m_colors.visitedNode, 1);
    }
    const ImVec2 at = ToPixel(*m_viewer.query);
    m_list.AddLine({at.x - 6, at.y}, {at.x + 6, at.y}, m_colors.query);
    m_list.AddLine({at.x, at.y - 6}, {at.x, at.y + 6}, m_colors.query);
    if (m_viewer.querySize > 0) AddBox(MakeQueryBox(*m_viewer.query, m_viewer.querySize), noFill, m_colors.query, 2);
}

void PaneOverlay::DrawHovered() {
    if (m_pane.hoveredNode < 0) return;
    for (const int node : GetPath(m_pane.snapshot.nodes, m_pane.hoveredNode)) {
        const bool isLast = node == m_pane.hoveredNode;
        AddBox(GetNode(node).box, noFill, isLast ? m_colors.path : m_colors.pathAbove, isLast ? 2.0f : 1.0f);
    }
}

void PaneOverlay::DrawDrag() {
    if (!m_viewer.drag) return;
    const int place = FindBody(m_pane.snapshot, m_viewer.drag->body);
    if (place < 0) return;
    const ImVec2 from = ToPixel(ToWorld(m_pane.snapshot.bodies[static_cast<size_t>(place)], m_viewer.drag->localPoint));
    const ImVec2 to = ToPixel(m_viewer.drag->target);
    m_list.AddLine(from, to, m_colors.drag, 2);
    m_list.AddCircleFilled(from, 4, m_colors.drag);
}

void PaneOverlay::DrawTitle() {
    const Snapshot& s = m_pane.snapshot;
    std::string title = fmt::format("{}  {}", m_pane.name, s.broadPhase);
    std::string numbers = fmt::format("{} bodies  {} contacts", s.bodies.size(), s.contactCount);
    if (m_pane.run->IsExact()) {
        numbers += fmt::format("  {} nodes", s.nodes.size());
    } else {
        title += fmt::format("  kept frame of step {}", s.step);
    }
    const auto x = static_cast<float>(m_pane.area.x0), y = static_cast<float>(m_pane.area.y0);
    const float width = ImGui::CalcTextSize((title + "   " + numbers).c_str()).x + 16;
    m_list.AddRectFilled({x, y}, {x + width, y + 20}, m_colors.titleStrip);
    m_list.AddText({x + 6, y + 3}, GetPaneColor(m_viewer, m_pane.choice), title.c_str());
    m_list.AddText({x + 6 + ImGui::CalcTextSize((title + "   ").c_str()).x, y + 3}, m_colors.titleText,
                   numbers.c_str());
}

}  // namespace

void HandleInput(Viewer& viewer) {
    try {
        if (!ImGui::GetIO().WantTextInput) HandleKeys(viewer);
        HandleMouse(viewer);
    } catch (const std::exception& error) {
        viewer.message = error.what();
    }
}

void UpdateFindings(Viewer& viewer) {
    const EnginePane* pointed = viewer.press ? nullptr : FindPane(viewer);
    const bool showsNodes = viewer.look.overlap || viewer.look.layers.Has(Layer::bvh);
    for (EnginePane& pane : viewer.panes) {
        pane.hoveredNode = -1;
        if (&pane == pointed && showsNodes) {
            const ImVec2 at = ImGui::GetIO().MousePos;
            pane.hoveredNode = FindNodeAt(pane.snapshot, viewer.look.nodes, PointAt(viewer, pane, at.x, at.y));
        }
        pane.trace.reset();
        if (viewer.query) pane.trace = TraceQuery(pane.snapshot.nodes, MakeQueryBox(*viewer.query, viewer.querySize));
    }
}

std::vector<DrawList> BuildPaneLists(const Viewer& viewer) {
    std::vector<DrawList> lists;
    for (const EnginePane& pane : viewer.panes) {
        lists.push_back(BuildDrawList(pane.snapshot, GetCamera(viewer, pane),
                                      {.layers = viewer.look.layers,
                                       .nodes = viewer.look.nodes,
                                       .supersampling = viewer.look.smooth ? 2 : 1,
                                       .theme = viewer.look.theme,
                                       .isOverCounts = viewer.look.overlap}));
    }
    return lists;
}

std::vector<PixelRect> ProjectNodes(const Viewer& viewer, const EnginePane& pane) {
    std::vector<PixelRect> rects;
    if (!viewer.look.overlap) return rects;
    const Camera camera = GetCamera(viewer, pane);
    for (const NodeState& node : pane.snapshot.nodes) {
        if (IsSelected(viewer.look.nodes, node)) rects.push_back(ProjectBox(node.box, 0, camera));
    }
    return rects;
}

std::vector<Color> MakeLookPalette(const ViewerLook& look) {
    // Beyond this the alpha style has no colours left: 1 − 0.005 to the 1,000th is below 1/100.
    constexpr uint32_t alphaCounts = 1000;
    const bool isAlpha = look.style == Style::alpha;
    return MakePalette(look.style, double{look.opacity}, isAlpha ? alphaCounts : static_cast<uint32_t>(look.scaleMax),
                       look.theme);
}

void DrawOverlay(const Viewer& viewer, std::span<const DrawList> lists) {
    for (size_t i = 0; i < viewer.panes.size(); ++i) PaneOverlay(viewer, viewer.panes[i]).Draw(lists[i]);
}

}  // namespace testbed
