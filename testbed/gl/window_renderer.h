// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The window's picture: panes with counts and layers, panels over them, all drawn on the graphics side into one target,
// whose rows are those of an Image (top first). The same target becomes the window's content or a screenshot, so that
// both are equal with and without a window.

#pragma once

#include <memory>
#include <span>

#include "testbed/gl/context.h"
#include "testbed/picture/counts.h"
#include "testbed/picture/draw_list.h"
#include "testbed/picture/image.h"

struct ImDrawData;

namespace testbed {

class WindowRenderer {
public:
    /// With the context current, here and in every call. Throws BackendError.
    WindowRenderer(FindFunction find, void* user);
    ~WindowRenderer();

    /// The pixels of Dear ImGui's font, one byte a pixel; call it before the first DrawPanels.
    void SetFont(const unsigned char* coverage, int width, int height);
    /// Starts a picture of one colour.
    void Begin(int width, int height, Color background);
    /// How many rectangles (in pixels of the area) cover each pixel of the area, through a table of colours.
    void DrawCounts(const PixelBox& area, std::span<const PixelRect> rects, std::span<const Color> palette);
    /// Triangles of a list as large as the area, blended over what is there; its texts are not drawn.
    void DrawLayers(const PixelBox& area, const DrawList& list);
    void DrawPanels(const ImDrawData& data);
    /// Copies the picture to the window's own framebuffer.
    void Present();
    [[nodiscard]] Image Read();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace testbed
