// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the window draws beside the scenes' layers, in both themes: overlays, titles, plots, and the two engines.

#pragma once

#include <string_view>

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
    PackedColor scree, box2d;                       ///< the engines: titles, plots, readouts

    [[nodiscard]] PackedColor GetEngine(std::string_view engine) const { return engine == "scree" ? scree : box2d; }
};

[[nodiscard]] const WindowColors& GetWindowColors(Theme theme);

}  // namespace testbed
