// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of gui.h, for Dear ImGui 1.86, which wants states, not events.

#include "testbed/jobs/window/gui.h"

#include <imgui/imgui.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cfloat>
#include <utility>

namespace testbed {

namespace {

void MapKeys(ImGuiIO& io) {
    constexpr std::array<std::pair<ImGuiKey_, int>, 22> keys{{{ImGuiKey_Tab, key::tab},
                                                              {ImGuiKey_LeftArrow, key::left},
                                                              {ImGuiKey_RightArrow, key::right},
                                                              {ImGuiKey_UpArrow, key::up},
                                                              {ImGuiKey_DownArrow, key::down},
                                                              {ImGuiKey_PageUp, key::pageUp},
                                                              {ImGuiKey_PageDown, key::pageDown},
                                                              {ImGuiKey_Home, key::home},
                                                              {ImGuiKey_End, key::end},
                                                              {ImGuiKey_Insert, key::insert},
                                                              {ImGuiKey_Delete, key::del},
                                                              {ImGuiKey_Backspace, key::backspace},
                                                              {ImGuiKey_Space, key::space},
                                                              {ImGuiKey_Enter, key::enter},
                                                              {ImGuiKey_Escape, key::escape},
                                                              {ImGuiKey_KeyPadEnter, key::keypadEnter},
                                                              {ImGuiKey_A, 'A'},
                                                              {ImGuiKey_C, 'C'},
                                                              {ImGuiKey_V, 'V'},
                                                              {ImGuiKey_X, 'X'},
                                                              {ImGuiKey_Y, 'Y'},
                                                              {ImGuiKey_Z, 'Z'}}};
    for (const auto& [name, code] : keys) io.KeyMap[name] = code;
}

void SetColors(Theme theme) {
    ImVec4* colors = ImGui::GetStyle().Colors;
    if (theme == Theme::dark) {
        ImGui::StyleColorsDark();
        colors[ImGuiCol_WindowBg] = {0.105f, 0.11f, 0.125f, 1};
        colors[ImGuiCol_Border] = {0.25f, 0.26f, 0.29f, 1};
        colors[ImGuiCol_TitleBg] = colors[ImGuiCol_TitleBgActive] = {0.16f, 0.17f, 0.2f, 1};
    } else {
        ImGui::StyleColorsLight();
        colors[ImGuiCol_WindowBg] = {0.95f, 0.95f, 0.955f, 1};
        colors[ImGuiCol_Border] = {0.72f, 0.73f, 0.75f, 1};
        colors[ImGuiCol_TitleBg] = colors[ImGuiCol_TitleBgActive] = {0.85f, 0.86f, 0.88f, 1};
    }
}

void SetStyle() {
    SetColors(Theme::dark);
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 0;
    style.FrameRounding = 3;
    style.GrabRounding = 3;
    style.WindowBorderSize = 1;
    style.WindowPadding = {8, 6};
    style.ItemSpacing = {6, 4};
    style.IndentSpacing = 14;
    style.ScrollbarSize = 11;
}

/// What has changed in this frame, so that it may not change again.
struct Changed {
    bool button = false;
    std::bitset<key::count> keys;
};

bool MustWait(const InputEvent& event, const Changed& changed) {
    switch (event.kind) {
        case InputEvent::Kind::move:
        case InputEvent::Kind::leave:
        case InputEvent::Kind::button:
            return changed.button;
        case InputEvent::Kind::key:
            return changed.keys[static_cast<size_t>(event.code)];
        case InputEvent::Kind::scroll:
        case InputEvent::Kind::text:
            return false;
    }
    return false;
}

void Take(const InputEvent& event, ImGuiIO& io, Changed& changed) {
    switch (event.kind) {
        case InputEvent::Kind::move:
            io.MousePos = {event.x, event.y};
            break;
        case InputEvent::Kind::leave:
            io.MousePos = {-FLT_MAX, -FLT_MAX};
            break;
        case InputEvent::Kind::button:
            io.MouseDown[event.code] = event.isDown;
            changed.button = true;
            break;
        case InputEvent::Kind::scroll:
            io.MouseWheelH += event.x;
            io.MouseWheel += event.y;
            break;
        case InputEvent::Kind::key:
            io.KeysDown[event.code] = event.isDown;
            changed.keys.set(static_cast<size_t>(event.code));
            break;
        case InputEvent::Kind::text:
            io.AddInputCharacter(static_cast<unsigned>(event.code));
            break;
    }
}

}  // namespace

Gui::Gui() : m_context(ImGui::CreateContext()) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    io.MousePos = {-FLT_MAX, -FLT_MAX};
    MapKeys(io);
    SetStyle();
}

Gui::~Gui() { ImGui::DestroyContext(m_context); }

void Gui::SetTheme(Theme theme) {
    if (theme != m_theme) SetColors(theme);
    m_theme = theme;
}

const unsigned char* Gui::GetFontPixels(int& width, int& height) {
    unsigned char* pixels = nullptr;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    return pixels;
}

void Gui::BeginFrame(std::span<const InputEvent> events, int width, int height, double deltaTime) {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    io.DeltaTime = std::max(static_cast<float>(deltaTime), 1e-5f);
    m_waiting.insert(m_waiting.end(), events.begin(), events.end());
    Changed changed;
    while (!m_waiting.empty() && !MustWait(m_waiting.front(), changed)) {
        Take(m_waiting.front(), io, changed);
        m_waiting.pop_front();
    }
    io.KeyCtrl = io.KeysDown[key::leftControl] || io.KeysDown[key::rightControl];
    io.KeyShift = io.KeysDown[key::leftShift] || io.KeysDown[key::rightShift];
    io.KeyAlt = io.KeysDown[key::leftAlt] || io.KeysDown[key::rightAlt];
    io.KeySuper = io.KeysDown[key::leftSuper] || io.KeysDown[key::rightSuper];
    ImGui::NewFrame();
}

const ImDrawData& Gui::EndFrame() {
    ImGui::Render();
    return *ImGui::GetDrawData();
}

void MarkItem(Items& items, std::string_view name) {
    const ImVec2 lower = ImGui::GetItemRectMin(), upper = ImGui::GetItemRectMax();
    items[std::string(name)] = {lower.x, lower.y, upper.x, upper.y};
}

void MarkSlider(Items& items, std::string_view name) {
    const ImVec2 lower = ImGui::GetItemRectMin(), upper = ImGui::GetItemRectMax();
    items[std::string(name)] = {lower.x, lower.y, lower.x + ImGui::CalcItemWidth(), upper.y};
}

}  // namespace testbed
