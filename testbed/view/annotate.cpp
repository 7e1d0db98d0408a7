// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Strips and bars at whole pixels.

#include "testbed/view/annotate.h"

#include <algorithm>
#include <utility>

#include "testbed/picture/composite.h"
#include "testbed/picture/font.h"

namespace testbed {

namespace {

constexpr int fullScaleWidth = 1280;

}  // namespace

int GetLabelScale(int width) { return width >= fullScaleWidth ? 2 : 1; }

int GetStripHeight(int lines, int scale) { return (lines * lineHeight + 4) * scale; }

int FitScale(const std::string& text, int scale, int width) {
    while (scale > 1 && GetTextWidth(text, scale) > width) --scale;
    return scale;
}

void DrawColorBar(Image& image, const ColorBar& bar, int scale, Theme theme) {
    const ThemeColors& colors = GetTheme(theme);
    const PixelBox& box = bar.box;
    const int width = box.x1 - box.x0;
    BlendRect(image, {box.x0 - 1, box.y0 - 1, box.x1 + 1, box.y1 + 1}, colors.faintText);
    for (int x = 0; x < width; ++x) {
        BlendRect(image, {box.x0 + x, box.y0, box.x0 + x + 1, box.y1}, bar.color((x + 0.5) / width));
    }
    std::vector<std::pair<int, int>> taken;
    for (const BarMark& mark : bar.marks) {
        const int x = box.x0 + static_cast<int>(mark.position * (width - 1) + 0.5);
        BlendRect(image, {x, box.y1 - 3 * scale, x + scale, box.y1 + 2 * scale}, colors.label);
        const int textWidth = GetTextWidth(mark.text, scale);
        const int room = 2 * glyphAdvance * scale;
        // Under its tick if possible, else to the right of it, else to the left, else after another mark's text.
        std::vector<int> places{x - textWidth / 2, x, x - textWidth};
        for (const auto& range : taken) places.push_back(range.second + room);
        for (const int wanted : places) {
            const int left = std::clamp(wanted, box.x0, std::max(box.x0, box.x1 - textWidth));
            const bool overlaps = std::any_of(taken.begin(), taken.end(), [&](const auto& range) {
                return left < range.second + room && range.first < left + textWidth + room;
            });
            if (overlaps) continue;
            DrawText(image, left, box.y1 + 3 * scale, mark.text, scale, colors.text);
            taken.emplace_back(left, left + textWidth);
            break;
        }
    }
}

}  // namespace testbed
