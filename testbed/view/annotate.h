// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What is written on finished pictures: strips of text, colour bars and bars of metres.

#pragma once

#include <cstdint>
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

/// A mark on a colour bar: `position` 0…1 from its left end. A tick has its text below it; any other mark crosses the
/// bar and has its text above, if any.
struct BarMark {
    double position;
    std::string text;
    bool isTick = true;
};

/// Multiples of 1, 2 or 5 times a power of ten from 0 on, `end` ≥ 1 last. There are at most `intervals` ≥ 2 between
/// them, none of them narrower than half of the others.
[[nodiscard]] std::vector<int64_t> ChooseTicks(int64_t end, int intervals);
/// For logarithmic scales: 0, then 1, 2 and 5 times powers of ten, `end` last.
[[nodiscard]] std::vector<int64_t> ChooseLogarithmicTicks(int64_t end);

struct ColorBar {
    PixelBox box;                                 ///< where the colours go
    std::function<Color(double position)> color;  ///< position 0…1
    std::vector<BarMark> marks;                   ///< in order of importance: text that would overlap is left out
};

/// Draws the bar, a line per mark, and the text of those marks that find room.
void DrawColorBar(Image& image, const ColorBar& bar, int scale, Theme theme = Theme::dark);

/// A round length: 1, 2 or 5 times a power of ten.
struct ScaleBar {
    double metres = 0;
    double pixels = 0;  ///< metres · pixelsPerMetre
    std::string text;   ///< "20 m", "5 cm"
};

/// The longest bar of at most `mostPixels`. `pixelsPerMetre` > 0 and finite.
[[nodiscard]] ScaleBar ChooseScaleBar(double pixelsPerMetre, double mostPixels);

/// A bar of metres in the lower left corner of what is above row `bottom`; none where there is no room.
void DrawScaleBar(Image& image, double pixelsPerMetre, int bottom, int scale, Theme theme = Theme::dark);

}  // namespace testbed
