// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the window draws beside the scenes' layers, in both themes: overlays, titles, plots, and the panes.

#pragma once

#include <array>
#include <cstddef>

#include "testbed/jobs/window/viewer.h"
#include "testbed/picture/theme.h"

namespace testbed {

/// As Dear ImGui packs a colour.
using PackedColor = unsigned;

struct WindowColors {
    Color gap;                                      ///< between the panes
    PackedColor query, visitedNode, leaf;           ///< a traced query
    PackedColor path, pathAbove;                    ///< the node under the pointer, those above it
    PackedColor drag;                               ///< the spring that pulls a body
    PackedColor titleStrip, titleText;              ///< of a pane
    PackedColor plot, plotLine, plotText, plotEnd;  ///< times of a stage
    PackedColor scree, box2d;                       ///< the first pane of each engine: titles, plots, readouts
    std::array<PackedColor, 3> more;                ///< further panes, in turn
};

[[nodiscard]] const WindowColors& GetWindowColors(Theme theme);

/// Of one of the viewer's choices.
[[nodiscard]] PackedColor GetPaneColor(const Viewer& viewer, size_t choice);

}  // namespace testbed
