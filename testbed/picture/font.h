// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Text on pictures: a bitmap font of our own, drawn at whole pixels, so that labels are the same on every machine.

#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "testbed/picture/image.h"

namespace testbed {

inline constexpr int glyphWidth = 5, glyphHeight = 9;  ///< pixels; the last two rows are for descenders
inline constexpr int glyphAdvance = 6, lineHeight = 11;

/// Rows of a glyph, top first; bit 4 is its left pixel. Characters outside ASCII 32…126 give a hollow box.
[[nodiscard]] const std::array<uint8_t, glyphHeight>& GetGlyph(char character);

/// Width of a line in pixels, without the gap after the last character. UTF-8 beyond ASCII counts one box per byte.
[[nodiscard]] int GetTextWidth(std::string_view text, int scale);

/// Draws one line with its top left corner at (x, y), `scale` ≥ 1 pixels per font pixel, clipped to the image.
void DrawText(Image& image, int x, int y, std::string_view text, int scale, Color color);

}  // namespace testbed
