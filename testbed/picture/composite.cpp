// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// out = (below · (255·k − Σa) + Σ c·a) / (255·k) over the k samples of a pixel, rounded once.

#include "testbed/picture/composite.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>

namespace testbed {

namespace {

struct Sums {
    uint32_t r = 0, g = 0, b = 0, a = 0;
    void Add(const Color& color) {
        const uint32_t alpha = color.a;
        r += color.r * alpha;
        g += color.g * alpha;
        b += color.b * alpha;
        a += alpha;
    }
};

template <uint32_t samplesPerPixel>
Color Over(const Color& below, const Sums& sums) {
    constexpr uint32_t whole = 255 * samplesPerPixel;
    const uint32_t rest = whole - sums.a;
    const auto mix = [rest](uint32_t under, uint32_t over) {
        return static_cast<uint8_t>((under * rest + over + whole / 2) / whole);
    };
    return {mix(below.r, sums.r), mix(below.g, sums.g), mix(below.b, sums.b), 255};
}

/// Most of a layer is empty: whether all samples of a pixel are transparent black, without taking them apart.
template <int supersampling>
bool IsEmpty(const Color* samples, std::ptrdiff_t stride) {
    std::array<uint32_t, supersampling> row{};
    uint32_t bits = 0;
    for (int j = 0; j < supersampling; ++j) {
        std::memcpy(row.data(), samples + j * stride, sizeof row);
        for (const uint32_t sample : row) bits |= sample;
    }
    return bits == 0;
}

template <int supersampling>
void Composite(const Image& samples, Image& picture, int top) {
    const std::ptrdiff_t stride = samples.width;
    for (int y = 0; y < samples.height / supersampling; ++y) {
        Color* out = &picture.At(0, top + y);
        const Color* sample = &samples.At(0, y * supersampling);
        for (int x = 0; x < picture.width; ++x, sample += supersampling) {
            if (IsEmpty<supersampling>(sample, stride)) continue;
            Sums sums;
            for (int j = 0; j < supersampling; ++j) {
                for (int i = 0; i < supersampling; ++i) sums.Add(sample[j * stride + i]);
            }
            out[x] = Over<supersampling * supersampling>(out[x], sums);
        }
    }
}

}  // namespace

void CompositeSamples(const Image& samples, int supersampling, Image& picture) {
    if (samples.height != picture.height * supersampling) {
        throw std::invalid_argument("a layer does not fit its picture");
    }
    CompositeRows(samples, supersampling, picture, 0);
}

void CompositeRows(const Image& samples, int supersampling, Image& picture, int top) {
    const bool isInside = top >= 0 && samples.height <= (picture.height - top) * supersampling;
    if (samples.width != picture.width * supersampling || !isInside) {
        throw std::invalid_argument("a layer does not fit its picture");
    }
    switch (supersampling) {
        case 1:
            return Composite<1>(samples, picture, top);
        case 2:
            return Composite<2>(samples, picture, top);
        case 4:
            return Composite<4>(samples, picture, top);
        default:
            throw std::invalid_argument("supersampling is 1, 2 or 4");
    }
}

void BlendPixel(Color& below, Color color, uint8_t coverage) {
    color.a = static_cast<uint8_t>((color.a * coverage + 127) / 255);
    Sums sums;
    sums.Add(color);
    below = Over<1>(below, sums);
}

void BlendRect(Image& picture, const PixelBox& box, Color color) {
    Sums sums;
    sums.Add(color);
    for (int y = std::max(box.y0, 0); y < std::min(box.y1, picture.height); ++y) {
        for (int x = std::max(box.x0, 0); x < std::min(box.x1, picture.width); ++x) {
            picture.At(x, y) = Over<1>(picture.At(x, y), sums);
        }
    }
}

}  // namespace testbed
