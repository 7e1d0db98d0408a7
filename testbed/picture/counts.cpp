// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Snapping for GL, and the difference array with its own snapping.

#include "testbed/picture/counts.h"

#include <algorithm>
#include <cmath>

namespace testbed {

namespace {

/// Number of pixel centres left of `edge` in a row of `size` pixels. SnapRect takes ceil(edge − 0.5); as its oracle,
/// this truncates and compares with the centre itself.
int CountCentresBefore(double edge, int size) {
    if (!(edge > 0.5)) return 0;
    if (edge > size) return size;
    const int whole = static_cast<int>(edge);
    const double centre = whole + 0.5;
    return std::min(size, centre < edge ? whole + 1 : whole);
}

}  // namespace

PixelBox SnapRect(const PixelRect& rect, int width, int height) {
    // A NaN fails every comparison, so clamp would return it: it is turned away first.
    if (!(rect.x0 < rect.x1 && rect.y0 < rect.y1)) return {0, 0, 0, 0};
    const auto snap = [](double edge, int size) {
        return static_cast<int32_t>(std::ceil(std::clamp(edge - 0.5, 0.0, static_cast<double>(size))));
    };
    const PixelBox box{snap(rect.x0, width), snap(rect.y0, height), snap(rect.x1, width), snap(rect.y1, height)};
    if (box.x0 >= box.x1 || box.y0 >= box.y1) return {0, 0, 0, 0};
    return box;
}

CountImage CountRects(std::span<const PixelRect> rects, int width, int height) {
    CountImage image{width, height, {}};
    // One more column and row take the corners that fall on the far edges. Unsigned arithmetic wraps, sums come out
    // right.
    const size_t stride = static_cast<size_t>(width) + 1;
    std::vector<uint32_t> steps(stride * (static_cast<size_t>(height) + 1), 0u);
    for (const PixelRect& rect : rects) {
        if (!(rect.x0 < rect.x1 && rect.y0 < rect.y1)) continue;
        const auto x0 = static_cast<size_t>(CountCentresBefore(rect.x0, width));
        const auto x1 = static_cast<size_t>(CountCentresBefore(rect.x1, width));
        const auto y0 = static_cast<size_t>(CountCentresBefore(rect.y0, height));
        const auto y1 = static_cast<size_t>(CountCentresBefore(rect.y1, height));
        steps[y0 * stride + x0] += 1;
        steps[y0 * stride + x1] -= 1;
        steps[y1 * stride + x0] -= 1;
        steps[y1 * stride + x1] += 1;
    }
    image.counts.resize(static_cast<size_t>(width) * static_cast<size_t>(height));
    for (size_t y = 0; y < static_cast<size_t>(height); ++y) {
        const uint32_t* row = steps.data() + y * stride;
        uint32_t* out = image.counts.data() + y * static_cast<size_t>(width);
        const uint32_t* above = y > 0 ? out - width : nullptr;
        uint32_t along = 0;
        for (size_t x = 0; x < static_cast<size_t>(width); ++x) {
            along += row[x];
            out[x] = along + (above != nullptr ? above[x] : 0u);
        }
    }
    return image;
}

}  // namespace testbed
