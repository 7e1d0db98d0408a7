// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Text on pictures: DejaVu Sans, which is part of the program, antialiased. Glyphs stand at whole pixels and blend in
// integers, so that labels are the same on every machine.

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "testbed/picture/image.h"

namespace testbed {

/// Metrics of a line in pixels at scale 1; at scale s they are s times as large. With capitals of 8 pixels small
/// letters are 6 high and stems 1 wide, so that letters are sharp.
inline constexpr int capHeight = 8, lineHeight = 13;

/// Pixels that a line covers: its first column of ink to its last. Blanks at its ends take none. Text is UTF-8; bytes
/// that are none give U+FFFD, what the font lacks gives a box.
[[nodiscard]] int GetTextWidth(std::string_view text, int scale);

/// Draws one line: its ink begins at column `x`, its capitals reach from row `y` to the baseline at y + capHeight ·
/// scale. `scale` ≥ 1. Clipped to the image.
void DrawText(Image& image, int x, int y, std::string_view text, int scale, Color color);

/// The text if it fits into `width` pixels, else as much of its beginning as fits with "…" behind; empty if nothing
/// does.
[[nodiscard]] std::string CutText(std::string_view text, int scale, int width);

}  // namespace testbed
