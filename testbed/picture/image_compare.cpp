// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Two pictures compared pixel by pixel.

#include "testbed/picture/image_compare.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace testbed {

namespace {

constexpr Color toleratedColor{70, 140, 255, 255}, maskedColor{60, 190, 110, 255};

void CheckSizes(const Image& expected, const Image& actual) {
    if (expected.width != actual.width || expected.height != actual.height) {
        throw std::invalid_argument("pictures of different sizes have no pixels to compare");
    }
}

int Distance(const Color& a, const Color& b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b), std::abs(a.a - b.a)});
}

bool IsMasked(const CompareRule& rule, int x, int y) {
    return std::ranges::any_of(
        rule.mask, [&](const PixelArea& area) { return x >= area.x0 && x < area.x1 && y >= area.y0 && y < area.y1; });
}

bool IsRowEqual(const Image& expected, const Image& actual, int y) {
    const auto width = static_cast<size_t>(expected.width);
    return std::memcmp(&expected.At(0, y), &actual.At(0, y), width * sizeof(Color)) == 0;
}

void Include(PixelArea& box, bool isFirst, int x, int y) {
    if (isFirst) box = {x, y, x + 1, y + 1};
    box = {std::min(box.x0, x), std::min(box.y0, y), std::max(box.x1, x + 1), std::max(box.y1, y + 1)};
}

}  // namespace

PixelDifference ComparePixels(const Image& expected, const Image& actual, const CompareRule& rule) {
    CheckSizes(expected, actual);
    PixelDifference result;
    for (int y = 0; y < expected.height; ++y) {
        if (IsRowEqual(expected, actual, y)) continue;
        for (int x = 0; x < expected.width; ++x) {
            const Color &before = expected.At(x, y), &after = actual.At(x, y);
            if (std::bit_cast<uint32_t>(before) == std::bit_cast<uint32_t>(after)) continue;
            const int distance = Distance(before, after);
            if (IsMasked(rule, x, y)) {
                ++result.masked;
            } else if (distance <= rule.tolerance) {
                ++result.tolerated;
            } else {
                Include(result.box, result.changed == 0, x, y);
                ++result.changed;
                result.maxDifference = std::max(result.maxDifference, distance);
            }
        }
    }
    return result;
}

Image MakeDifferencePicture(const Image& expected, const Image& actual, const CompareRule& rule) {
    CheckSizes(expected, actual);
    Image picture(expected.width, expected.height, Color{0, 0, 0, 255});
    for (int y = 0; y < expected.height; ++y) {
        for (int x = 0; x < expected.width; ++x) {
            const Color& color = expected.At(x, y);
            const int distance = Distance(color, actual.At(x, y));
            const auto grey = static_cast<uint8_t>((color.r + color.g + color.b) / 9);
            Color shown{grey, grey, grey, 255};
            if (distance > 0 && IsMasked(rule, x, y)) {
                shown = maskedColor;
            } else if (distance > rule.tolerance) {
                shown = {255, static_cast<uint8_t>(225 - distance * 180 / 255), 32, 255};
            } else if (distance > 0) {
                shown = toleratedColor;
            }
            picture.At(x, y) = shown;
        }
    }
    return picture;
}

}  // namespace testbed
