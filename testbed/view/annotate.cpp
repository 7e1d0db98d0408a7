// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Strips and bars at whole pixels.

#include "testbed/view/annotate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <utility>

#include "testbed/picture/composite.h"
#include "testbed/picture/font.h"

namespace testbed {

namespace {

constexpr int fullScaleWidth = 1280;
constexpr int wordSpace = 8;                           // pixels between texts below or above a bar, at scale 1
constexpr double scaleBarShare = 0.2;                  // of a picture's width, at most
constexpr uint8_t backingOpacity = 200;                // of what is behind a bar of metres
constexpr int leastExponent = -12, mostExponent = 15;  // of lengths

struct LengthUnit {
    int exponent;
    const char* name;
};
constexpr LengthUnit lengthUnits[] = {{3, "km"}, {0, "m"}, {-2, "cm"}, {-3, "mm"}, {-6, "µm"}, {-9, "nm"}};

/// Exact from −22 to 22, up to one rounding below 0.
double PowerOfTen(int exponent) {
    double power = 1;
    for (int i = 0; i < std::abs(exponent); ++i) power *= 10;
    return exponent < 0 ? 1 / power : power;
}

}  // namespace

int GetLabelScale(int width) { return width >= fullScaleWidth ? 2 : 1; }

int GetStripHeight(int lines, int scale) { return (lines * lineHeight + 4) * scale; }

int FitScale(const std::string& text, int scale, int width) {
    while (scale > 1 && GetTextWidth(text, scale) > width) --scale;
    return scale;
}

std::vector<int64_t> ChooseTicks(int64_t end, int intervals) {
    int64_t step = 1;
    for (int64_t power = 1; step * intervals < end; power *= 10) {
        for (const int64_t factor : {1, 2, 5}) {
            step = factor * power;
            if (step * intervals >= end) break;
        }
    }
    std::vector<int64_t> ticks;
    for (int64_t tick = 0; tick == 0 || 2 * (end - tick) >= step; tick += step) ticks.push_back(tick);
    ticks.push_back(end);
    return ticks;
}

std::vector<int64_t> ChooseLogarithmicTicks(int64_t end) {
    std::vector<int64_t> ticks{0};
    for (int64_t power = 1; power < end; power *= 10) {
        for (const int64_t factor : {1, 2, 5}) {
            if (factor * power < end) ticks.push_back(factor * power);
        }
    }
    ticks.push_back(end);
    return ticks;
}

void DrawColorBar(Image& image, const ColorBar& bar, int scale, Theme theme) {
    const ThemeColors& colors = GetTheme(theme);
    const PixelBox& box = bar.box;
    const int width = box.x1 - box.x0;
    BlendRect(image, {box.x0 - 1, box.y0 - 1, box.x1 + 1, box.y1 + 1}, colors.faintText);
    for (int x = 0; x < width; ++x) {
        BlendRect(image, {box.x0 + x, box.y0, box.x0 + x + 1, box.y1}, bar.color((x + 0.5) / width));
    }
    std::vector<std::pair<int, int>> below, above;  // columns taken by text
    const int room = wordSpace * scale;
    for (const BarMark& mark : bar.marks) {
        const int x = box.x0 + static_cast<int>(mark.position * (width - 1) + 0.5);
        const int begin = std::min(x - scale / 2, box.x1 - scale);
        BlendRect(image, {begin, mark.isTick ? box.y1 : box.y0 - 2 * scale, begin + scale, box.y1 + 2 * scale},
                  colors.label);
        if (mark.text.empty()) continue;
        auto& taken = mark.isTick ? below : above;
        const int textWidth = GetTextWidth(mark.text, scale);
        // At its mark; what is above may also stand after another mark's text.
        std::vector<int> places{x - textWidth / 2};
        if (!mark.isTick) {
            places.insert(places.end(), {x, x - textWidth});
            for (const auto& range : taken) places.push_back(range.second + room);
        }
        for (const int wanted : places) {
            const int left = std::clamp(wanted, box.x0, std::max(box.x0, box.x1 - textWidth));
            const bool overlaps = std::any_of(taken.begin(), taken.end(), [&](const auto& range) {
                return left < range.second + room && range.first < left + textWidth + room;
            });
            if (overlaps || textWidth > width) continue;
            const int y = mark.isTick ? box.y1 + 3 * scale : box.y0 - (3 + capHeight) * scale;
            DrawText(image, left, y, mark.text, scale, colors.text);
            taken.emplace_back(left, left + textWidth);
            break;
        }
    }
}

ScaleBar ChooseScaleBar(double pixelsPerMetre, double mostPixels) {
    int exponent = leastExponent;
    while (exponent < mostExponent && PowerOfTen(exponent + 1) * pixelsPerMetre <= mostPixels) ++exponent;
    int factor = 1;
    for (const int larger : {2, 5}) {
        if (larger * PowerOfTen(exponent) * pixelsPerMetre <= mostPixels) factor = larger;
    }
    const auto unit = std::find_if(std::begin(lengthUnits), std::end(lengthUnits) - 1,
                                   [exponent](const LengthUnit& one) { return one.exponent <= exponent; });
    const double metres = exponent < 0 ? factor / PowerOfTen(-exponent) : factor * PowerOfTen(exponent);
    return {metres, metres * pixelsPerMetre,
            fmt::format("{:g} {}", factor * PowerOfTen(exponent - unit->exponent), unit->name)};
}

void DrawScaleBar(Image& image, double pixelsPerMetre, int bottom, int scale, Theme theme) {
    const ThemeColors& colors = GetTheme(theme);
    const ScaleBar bar = ChooseScaleBar(pixelsPerMetre, image.width * scaleBarShare);
    const int length = static_cast<int>(bar.pixels + 0.5), edge = 4 * scale, space = 5 * scale;
    const int width = length + scale + space + GetTextWidth(bar.text, scale) + 2 * edge;
    const int height = capHeight * scale + 2 * edge;
    if (width > image.width || height > bottom || length < 1) return;
    Color backing = colors.strip;
    backing.a = backingOpacity;
    BlendRect(image, {0, bottom - height, width, bottom}, backing);
    // From the left edge of the left end to the left edge of the right end.
    const int top = bottom - height + edge, base = bottom - edge;
    BlendRect(image, {edge, base - scale, edge + length + scale, base}, colors.label);
    for (const int x : {edge, edge + length}) BlendRect(image, {x, top, x + scale, base - scale}, colors.label);
    DrawText(image, edge + length + scale + space, top, bar.text, scale, colors.label);
}

}  // namespace testbed
