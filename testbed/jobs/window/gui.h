// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Dear ImGui without its backends: events in, draw lists out. Nothing is read from or written to disk, and with a fixed
// time between frames the same events give the same lists.

#pragma once

#include <deque>
#include <map>
#include <span>
#include <string>

#include "testbed/jobs/window/input_event.h"
#include "testbed/picture/theme.h"

struct ImDrawData;
struct ImGuiContext;

namespace testbed {

/// A widget's place on the picture, pixels.
struct ItemBox {
    float x0, y0, x1, y1;
};

/// Owns the context of Dear ImGui, of which a process has one.
class Gui {
public:
    Gui();
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    /// The colours of panels from the next frame on.
    void SetTheme(Theme theme);
    /// Coverage of the font's pixels, for the renderer.
    [[nodiscard]] const unsigned char* GetFontPixels(int& width, int& height);
    /// Takes events in order. In one frame a button or key changes at most once, and the pointer does not move after
    /// that. Later events wait for the next frame, so that no click is lost in slow frames.
    void BeginFrame(std::span<const InputEvent> events, int width, int height, double deltaTime);
    [[nodiscard]] const ImDrawData& EndFrame();

private:
    ImGuiContext* m_context;
    Theme m_theme = Theme::dark;
    std::deque<InputEvent> m_waiting;
};

/// Where named widgets were in the last frame they were drawn in: what a script points at.
using Items = std::map<std::string, ItemBox, std::less<>>;

/// Names the widget that was drawn last.
void MarkItem(Items& items, std::string_view name);
/// The same for a slider, without the label on its right, so that shares of its width are shares of its range. Its
/// width was set by PushItemWidth.
void MarkSlider(Items& items, std::string_view name);

}  // namespace testbed
