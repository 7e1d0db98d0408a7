// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The panels of the scenes, of the times, and of what the pointer found.

#include <fmt/format.h>
#include <imgui/imgui.h>
#include <imgui/imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <exception>
#include <set>

#include "testbed/jobs/window/panels.h"
#include "testbed/jobs/window/window_colors.h"

namespace testbed {

namespace {

bool ContainsWord(std::string_view text, std::string_view word) {
    const auto isSame = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    };
    return std::search(text.begin(), text.end(), word.begin(), word.end(), isSame) != text.end();
}

bool Matches(const scenes::SceneInfo& info, std::string_view search) {
    return ContainsWord(info.name, search) || ContainsWord(info.title, search) || ContainsWord(info.folder, search);
}

void Load(Viewer& viewer, const scenes::SceneInfo& info, int size) {
    try {
        LoadScene(viewer, MakeInput(info, size));
    } catch (const std::exception& error) {
        viewer.message = error.what();
    }
}

void DrawSize(Viewer& viewer, Items& items) {
    const scenes::SceneInfo* info = viewer.scene.info;
    if (info == nullptr || !info->hasSize) {
        ImGui::TextDisabled("one size");
        return;
    }
    int size = viewer.scene.size;
    ImGui::SetNextItemWidth(120);
    ImGui::InputInt("size", &size, 0, 0, ImGuiInputTextFlags_EnterReturnsTrue);
    const bool isDone = ImGui::IsItemDeactivatedAfterEdit();
    MarkItem(items, "scene.size");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%d to %d, then Enter", info->minSize, info->maxSize);
    if (isDone && size != viewer.scene.size) Load(viewer, *info, size);
}

/// A plot's stage.
struct Stage {
    const char* name;
    double StepTimes::*time;
};

constexpr std::array<Stage, 4> stages{{{"step", &StepTimes::step},
                                       {"broad phase", &StepTimes::broadPhase},
                                       {"narrow phase", &StepTimes::narrowPhase},
                                       {"solver", &StepTimes::solver}}};

/// The end of a time axis: 1, 2 or 5 times a power of ten.
double RoundUp(double value) {
    if (!(value > 0)) return 0.01;
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (value <= factor * power) return factor * power;
    }
    return 10 * power;
}

void DrawStage(const Viewer& viewer, const Stage& stage, ImVec2 lower, ImVec2 upper) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const WindowColors& colors = GetWindowColors(viewer.look.theme);
    list.AddRectFilled(lower, upper, colors.plot);
    double top = 0;
    for (const EnginePane& pane : viewer.panes) {
        for (const StepTimes& times : pane.history) top = std::max(top, times.*stage.time);
    }
    top = RoundUp(top);
    const float plotTop = lower.y + 17;
    for (const EnginePane& pane : viewer.panes) {
        std::vector<ImVec2> points;
        for (size_t i = 0; i < pane.history.size(); ++i) {
            const auto age = static_cast<float>(pane.history.size() - 1 - i);
            const float x = upper.x - 2 - age * (upper.x - lower.x - 4) / static_cast<float>(historyLength - 1);
            const auto share = static_cast<float>(pane.history[i].*stage.time / top);
            points.emplace_back(x, upper.y - 2 - share * (upper.y - plotTop - 3));
        }
        list.AddPolyline(points.data(), static_cast<int>(points.size()), GetPaneColor(viewer, pane.choice), 0, 1);
    }
    list.AddLine({lower.x, plotTop}, {upper.x, plotTop}, colors.plotLine);
    list.AddText({lower.x + 4, lower.y + 2}, colors.plotText, stage.name);
    const std::string end = fmt::format("{:g} ms", top);
    list.AddText({upper.x - 4 - ImGui::CalcTextSize(end.c_str()).x, lower.y + 2}, colors.plotEnd, end.c_str());
}

void WriteNode(const EnginePane& pane) {
    const NodeState& node = pane.snapshot.nodes[static_cast<size_t>(pane.hoveredNode)];
    const bool isLeaf = node.child1 < 0;
    const Box& box = node.box;
    ImGui::TextWrapped("%s node %d, level %d, %s", pane.name.c_str(), pane.hoveredNode, node.level,
                       isLeaf ? fmt::format("leaf of fixture {}", node.fixture).c_str()
                              : fmt::format("{} leaves", CountLeaves(pane.snapshot.nodes, pane.hoveredNode)).c_str());
    ImGui::TextWrapped("%s", DescribePath(pane.snapshot.nodes, pane.hoveredNode).c_str());
    ImGui::TextWrapped("box %.2f %.2f to %.2f %.2f", static_cast<double>(box.lower.x), static_cast<double>(box.lower.y),
                       static_cast<double>(box.upper.x), static_cast<double>(box.upper.y));
}

void WriteBody(const Viewer& viewer) {
    for (const EnginePane& pane : viewer.panes) {
        const int place = FindBody(pane.snapshot, viewer.pickedBody);
        if (place < 0) continue;
        const BodyState& body = pane.snapshot.bodies[static_cast<size_t>(place)];
        ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(GetPaneColor(viewer, pane.choice)), "%s  x %.2f  y %.2f%s",
                           NameOfBody(viewer, viewer.pickedBody).c_str(), static_cast<double>(body.position.x),
                           static_cast<double>(body.position.y), body.awake ? "" : "  asleep");
    }
}

}  // namespace

void DrawScenesPanel(Viewer& viewer, Items& items) {
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##search", "search", &viewer.search);
    MarkItem(items, "scene.search");
    DrawSize(viewer, items);
    ImGui::Separator();
    ImGui::BeginChild("list");
    std::set<std::string_view> drawn;
    for (const scenes::SceneInfo& theme : scenes::Catalog()) {
        if (!drawn.insert(theme.folder).second) continue;
        const auto isShown = [&](const scenes::SceneInfo& info) {
            return info.folder == theme.folder && Matches(info, viewer.search);
        };
        if (std::ranges::none_of(scenes::Catalog(), isShown)) continue;
        if (!viewer.search.empty()) ImGui::SetNextItemOpen(true);
        const bool holdsCurrent = viewer.scene.info != nullptr && theme.folder == viewer.scene.info->folder;
        const bool isOpen = ImGui::TreeNodeEx(std::string(theme.folder).c_str(),
                                              holdsCurrent ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
        MarkItem(items, fmt::format("theme.{}", theme.folder));
        if (!isOpen) continue;
        for (const scenes::SceneInfo& info : scenes::Catalog()) {
            if (!isShown(info)) continue;
            if (ImGui::Selectable(std::string(info.name).c_str(), &info == viewer.scene.info)) {
                Load(viewer, info, info.defaultSize);
            }
            MarkItem(items, fmt::format("scene.{}", info.name));
            if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(info.title).c_str());
        }
        ImGui::TreePop();
    }
    ImGui::EndChild();
}

void DrawTimesPanel(const Viewer& viewer) {
    const ImVec2 corner = ImGui::GetCursorScreenPos(), space = ImGui::GetContentRegionAvail();
    constexpr float gap = 6;
    const float width = (space.x - gap * static_cast<float>(stages.size() - 1)) / static_cast<float>(stages.size());
    if (width < 20 || space.y < 30) return;
    for (size_t i = 0; i < stages.size(); ++i) {
        const float x = std::floor(corner.x + static_cast<float>(i) * (width + gap));
        DrawStage(viewer, stages[i], {x, corner.y}, {std::floor(x + width), corner.y + space.y});
    }
}

void DrawFindings(const Viewer& viewer) {
    if (viewer.pickedBody >= 0) WriteBody(viewer);
    for (const EnginePane& pane : viewer.panes) {
        if (pane.trace) {
            ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(GetPaneColor(viewer, pane.choice)),
                               "query: %d visited, %d tested,\n%d of %d leaves",
                               static_cast<int>(pane.trace->visited.size()), pane.trace->tested, pane.trace->leaves,
                               static_cast<int>(pane.snapshot.fixtures.size()));
        }
    }
    bool hasNode = false;
    for (const EnginePane& pane : viewer.panes) {
        if (pane.hoveredNode < 0) continue;
        WriteNode(pane);
        hasNode = true;
    }
    if (!hasNode && viewer.pickedBody < 0 && !viewer.query) {
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
        ImGui::TextWrapped(
            "Drag a body with the mouse, drag the ground to pan, scroll to zoom. Click a point to trace a query. Point "
            "at a node to see it. B shoots a bullet, H hides the panels.");
        ImGui::PopStyleColor();
    }
}

}  // namespace testbed
