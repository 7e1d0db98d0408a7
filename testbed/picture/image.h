// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Pixels in memory, top row first.

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace testbed {

struct Color {
    uint8_t r, g, b, a = 255;
    friend bool operator==(const Color&, const Color&) = default;
};

/// RGBA, 8 bits a channel, not premultiplied, top row first.
struct Image {
    int width = 0, height = 0;
    std::vector<Color> pixels;

    Image() = default;
    Image(int w, int h, Color fill)
        : width(w), height(h), pixels(static_cast<size_t>(w) * static_cast<size_t>(h), fill) {}
    Color& At(int x, int y) {
        return pixels[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)];
    }
    [[nodiscard]] const Color& At(int x, int y) const {
        return pixels[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)];
    }
};

/// How many boxes cover each pixel, top row first.
struct CountImage {
    int width = 0, height = 0;
    std::vector<uint32_t> counts;
};

/// A box in whole pixels, half-open: covers x0 ≤ x < x1, y0 ≤ y < y1, y down.
struct PixelBox {
    int32_t x0, y0, x1, y1;
};

}  // namespace testbed
