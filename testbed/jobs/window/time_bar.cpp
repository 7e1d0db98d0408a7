// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The bar below the panes: where in time the window is, ways to get elsewhere, what the way back costs in memory, break
// conditions, and what they found as marks.

#include <fmt/format.h>
#include <imgui/imgui.h>
#include <imgui/imgui_stdlib.h>

#include <algorithm>
#include <exception>

#include "testbed/jobs/window/panels.h"
#include "testbed/jobs/window/window_colors.h"

namespace testbed {

namespace {

template <typename Action>
void TryInTime(Viewer& viewer, Action&& action) {
    try {
        action();
    } catch (const std::exception& error) {
        viewer.message = error.what();
    }
}

bool TimeButton(Items& items, const char* label, const char* name, const char* tip) {
    const bool isPressed = ImGui::Button(label);
    MarkItem(items, name);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tip);
    ImGui::SameLine();
    return isPressed;
}

void DrawButtons(Viewer& viewer, Items& items) {
    const int step = GetStep(viewer);
    if (TimeButton(items, "|<", "time.first", "to the first step, Home")) GoToStep(viewer, GetFirstStep(viewer));
    if (TimeButton(items, "<", "time.back", "one step back, Left")) GoToStep(viewer, step - 1);
    const bool goesBack = !viewer.isPaused && viewer.playsBackward;
    if (TimeButton(items, goesBack ? "||##back" : "<<", "time.backwards", "play backwards, J")) {
        PlayBackward(viewer, !goesBack);
    }
    const bool goesOn = !viewer.isPaused && !viewer.playsBackward;
    if (TimeButton(items, goesOn ? "||##on" : ">>", "time.play", "play, P")) {
        viewer.playsBackward = false;
        viewer.isPaused = goesOn;
    }
    if (TimeButton(items, ">", "time.forward", "one step on, Right")) {
        viewer.isPaused = true;
        StepAll(viewer);
    }
    if (TimeButton(items, ">|", "time.last", "to the last step, End")) GoToStep(viewer, GetLastStep(viewer));
    ImGui::AlignTextToFramePadding();
    ImGui::Text("step %d of %d", GetStep(viewer), GetLastStep(viewer));
    const EnginePane& pane = viewer.panes.front();
    if (pane.run->IsMotion()) return;
    ImGui::SameLine(0, 18);
    size_t bytes = 0;
    for (const EnginePane& one : viewer.panes) bytes += one.run->GetBytes();
    constexpr double mega = 1 << 20;
    ImGui::TextDisabled("%.1f of %.0f MB, one in %d steps", static_cast<double>(bytes) / mega,
                        static_cast<double>(viewer.memoryLimit) / mega, pane.run->GetSpacing());
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip(
            "kept to go back: images of scree, from which the steps between are made again,\n"
            "and frames of other engines; beyond the limit they lie farther apart");
    }
}

void DrawScrubber(Viewer& viewer, Items& items) {
    ImGui::SetNextItemWidth(-1);
    int step = GetStep(viewer);
    const int first = GetFirstStep(viewer), last = std::max(GetLastStep(viewer), first + 1);
    if (ImGui::SliderInt("##time", &step, first, last, "")) GoToStep(viewer, std::min(step, GetLastStep(viewer)));
    MarkItem(items, "time.scrub");
    const ImVec2 lower = ImGui::GetItemRectMin(), upper = ImGui::GetItemRectMax();
    const float grab = ImGui::GetStyle().GrabMinSize;
    const float x0 = lower.x + 2 + grab / 2, x1 = upper.x - 2 - grab / 2;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const BreakMoment& one : viewer.moments) {
        const float share = static_cast<float>(one.moment.step - first) / static_cast<float>(last - first);
        const float x = x0 + std::clamp(share, 0.0f, 1.0f) * (x1 - x0);
        list.AddRectFilled({x - 1, lower.y}, {x + 1, upper.y}, GetWindowColors(viewer.look.theme).drag);
    }
}

void DrawBreaks(Viewer& viewer, Items& items) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("stop when");
    ImGui::SameLine();
    constexpr float saveWidth = 196;
    ImGui::SetNextItemWidth(std::max(60.0f, ImGui::GetContentRegionAvail().x - saveWidth));
    if (ImGui::InputTextWithHint("##when", "body(3).y < -5, contacts(\"player\", \"lava\") > 0 ...", &viewer.whenText,
                                 ImGuiInputTextFlags_EnterReturnsTrue)) {
        TryInTime(viewer, [&] { StopWhen(viewer, viewer.whenText); });
    }
    MarkItem(items, "time.when");
    ImGui::SameLine();
    if (TimeButton(items, "Save scene", "save.scene", "what is seen, as a *.scene.json in the current folder")) {
        TryInTime(viewer, [&] { SaveScene(viewer); });
    }
    if (TimeButton(items, "Save track", "save.track", "all steps with all that was done, as a *.track of each pane")) {
        TryInTime(viewer, [&] { SaveTracks(viewer); });
    }
    ImGui::NewLine();
}

/// What was found at this step, else how much there is.
void DrawMoments(const Viewer& viewer) {
    for (const BreakMoment& one : viewer.moments) {
        if (one.moment.step != GetStep(viewer)) continue;
        const std::string text = DescribeMoment(viewer, one);
        ImGui::TextUnformatted(text.c_str());
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text.c_str());
        return;
    }
    if (!viewer.moments.empty()) ImGui::TextDisabled("moments found: %d", static_cast<int>(viewer.moments.size()));
}

}  // namespace

void DrawTimeBar(Viewer& viewer, Items& items) {
    TryInTime(viewer, [&] { DrawButtons(viewer, items); });
    TryInTime(viewer, [&] { DrawScrubber(viewer, items); });
    DrawBreaks(viewer, items);
    DrawMoments(viewer);
}

}  // namespace testbed
