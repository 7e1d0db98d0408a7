// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The inspector as a panel: values in two columns, those that can be changed as fields.

#include <fmt/format.h>
#include <imgui/imgui.h>
#include <imgui/imgui_stdlib.h>

#include <algorithm>
#include <exception>

#include "testbed/jobs/window/inspector.h"
#include "testbed/jobs/window/panels.h"
#include "testbed/jobs/window/window_colors.h"

namespace testbed {

namespace {

constexpr float nameWidth = 132;  // pixels of the left column

std::string ItemName(std::string_view value) {
    std::string name = fmt::format("edit.{}", value);
    std::ranges::replace(name, ' ', '-');
    return name;
}

void Change(Viewer& viewer, std::string_view name, std::string_view text) {
    try {
        EditBody(viewer, ParseEdit(name, text));
    } catch (const std::exception& error) {
        viewer.message = error.what();
    }
}

void DrawName(const std::string& name) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", name.c_str());
    ImGui::SameLine(nameWidth);
    ImGui::SetNextItemWidth(-1);
}

/// A field that becomes an edit on Enter, a switch, or a list of the types.
void DrawField(Viewer& viewer, Items& items, const RunValue& value) {
    DrawName(value.name);
    const std::string id = "##" + value.name;
    if (value.value == "yes" || value.value == "no") {
        bool isOn = value.value == "yes";
        if (ImGui::Checkbox(id.c_str(), &isOn)) Change(viewer, value.name, isOn ? "yes" : "no");
        MarkItem(items, ItemName(value.name));
    } else if (value.name == "type") {
        constexpr const char* types[]{"static", "kinematic", "dynamic"};
        const bool isOpen = ImGui::BeginCombo(id.c_str(), value.value.c_str());
        MarkItem(items, ItemName(value.name));
        if (!isOpen) return;
        for (const char* type : types) {
            if (ImGui::Selectable(type, value.value == type)) Change(viewer, value.name, type);
            MarkItem(items, fmt::format("type.{}", type));
        }
        ImGui::EndCombo();
    } else {
        std::string text = value.value;
        constexpr auto flags = ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll;
        if (ImGui::InputText(id.c_str(), &text, flags)) Change(viewer, value.name, text);
        MarkItem(items, ItemName(value.name));
    }
}

void DrawValue(const RunValue& value) {
    ImGui::TextDisabled("%s", value.name.c_str());
    ImGui::SameLine(nameWidth);
    ImGui::TextUnformatted(value.value.c_str());
}

void DrawParts(Viewer& viewer, Items& items, const char* title, const std::vector<InspectedPart>& parts) {
    const std::string heading = fmt::format("{}: {}###{}", title, parts.size(), title);
    const bool isOpen = ImGui::CollapsingHeader(heading.c_str(), ImGuiTreeNodeFlags_DefaultOpen);
    MarkItem(items, fmt::format("inspect.{}", title));
    if (!isOpen) return;
    ImGui::PushID(title);
    for (size_t i = 0; i < parts.size(); ++i) {
        const InspectedPart& part = parts[i];
        ImGui::PushID(static_cast<int>(i));
        // The number alone tells them apart: counts in the title change.
        const bool isPartOpen = ImGui::TreeNodeEx("part", ImGuiTreeNodeFlags_SpanAvailWidth, "%s", part.title.c_str());
        MarkItem(items, fmt::format("inspect.{}.{}", title, i));
        if (isPartOpen) {
            if (part.otherBody >= 0) {
                if (ImGui::SmallButton(fmt::format("go to {}", NameOfBody(viewer, part.otherBody)).c_str())) {
                    viewer.pickedBody = part.otherBody;
                }
                MarkItem(items, fmt::format("inspect.{}.{}.go", title, i));
            }
            for (const RunValue& value : part.values) DrawValue(value);
            ImGui::TreePop();
        }
        ImGui::PopID();
    }
    ImGui::PopID();
}

void DrawPick(Viewer& viewer, Items& items) {
    ImGui::SetNextItemWidth(-1);
    if (ImGui::InputTextWithHint("##pick", "name or number of a body", &viewer.pickText,
                                 ImGuiInputTextFlags_EnterReturnsTrue)) {
        PickBody(viewer, viewer.pickText);
    }
    MarkItem(items, "inspect.pick");
}

void DrawPaneChoice(Viewer& viewer, Items& items) {
    if (viewer.panes.size() < 2) return;
    for (size_t i = 0; i < viewer.panes.size(); ++i) {
        const EnginePane& pane = viewer.panes[i];
        if (i > 0) ImGui::SameLine();
        ImGui::PushStyleColor(ImGuiCol_Text, GetPaneColor(viewer, pane.choice));
        if (ImGui::RadioButton(pane.name.c_str(), viewer.inspectedPane == i)) viewer.inspectedPane = i;
        ImGui::PopStyleColor();
        MarkItem(items, fmt::format("inspect.pane.{}", pane.name));
    }
}

}  // namespace

void DrawInspector(Viewer& viewer, Items& items) {
    DrawPick(viewer, items);
    DrawPaneChoice(viewer, items);
    const EnginePane& pane = viewer.panes[std::min(viewer.inspectedPane, viewer.panes.size() - 1)];
    const Inspection inspection = Inspect(viewer, pane);
    if (inspection.title.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
        ImGui::TextWrapped("Press a body in a pane, or name it above, to see its values, shapes, contacts and joints.");
        ImGui::PopStyleColor();
        return;
    }
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(inspection.title.c_str());
    ImGui::SameLine();
    ImGui::Checkbox("follow", &viewer.follows);
    MarkItem(items, "inspect.follow");
    ImGui::BeginChild("values");
    const bool canChange = !pane.run->IsMotion();
    if (!pane.run->IsExact()) {
        ImGui::TextWrapped("A frame that was kept: the engine itself is at step %d.", pane.run->GetLastStep());
    }
    for (const RunValue& value : inspection.values) {
        if (canChange && IsEditable(value.name)) {
            DrawField(viewer, items, value);
        } else {
            DrawValue(value);
        }
    }
    DrawParts(viewer, items, "shapes", inspection.shapes);
    DrawParts(viewer, items, "contacts", inspection.contacts);
    DrawParts(viewer, items, "joints", inspection.joints);
    ImGui::EndChild();
}

}  // namespace testbed
