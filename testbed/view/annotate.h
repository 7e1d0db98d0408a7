// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What is written on finished pictures: strips of text and colour bars.

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "testbed/picture/image.h"
#include "testbed/picture/theme.h"

namespace testbed {

/// Font scale of a picture's labels: twice the font's size from 1280 pixels on.
[[nodiscard]] int GetLabelScale(int width);
/// Height of a strip that holds `lines` lines at a scale, pixels.
[[nodiscard]] int GetStripHeight(int lines, int scale);
/// The largest scale not above `scale` at which the text fits into `width` pixels, at least 1.
[[nodiscard]] int FitScale(const std::string& text, int scale, int width);

/// A mark on a colour bar: `position` 0…1 from its left end.
struct BarMark {
    double position;
    std::string text;
};

struct ColorBar {
    PixelBox box;                                 ///< where the colours go; the marks' text goes below
    std::function<Color(double position)> color;  ///< position 0…1
    std::vector<BarMark> marks;                   ///< in order of importance: text that would overlap is left out
};

/// Draws the bar, a tick per mark, and the text of those marks that find room.
void DrawColorBar(Image& image, const ColorBar& bar, int scale, Theme theme = Theme::dark);

}  // namespace testbed
