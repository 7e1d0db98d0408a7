// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The law of the counts: a pixel's number is the number of rectangles that hold its centre, half-open, whoever counts.
// GL counts by blending on either backend, the CPU by its difference array; a loop goes over every pixel and rectangle.
// And the comparison can fail: three wrong ways of snapping are caught by the same rectangles.

#include "testbed/picture/counts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>

#include "testbed/gl/gl_renderer.h"

namespace testbed {
namespace {

constexpr int pictureWidth = 157;  // neither even nor a multiple of a SIMD width
constexpr int pictureHeight = 91;

std::vector<uint32_t> CountByBruteForce(const std::vector<PixelRect>& rects, int width, int height) {
    std::vector<uint32_t> counts;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            uint32_t count = 0;
            for (const PixelRect& rect : rects) {
                const bool holds = rect.x0 <= x + 0.5 && x + 0.5 < rect.x1 && rect.y0 <= y + 0.5 && y + 0.5 < rect.y1;
                count += holds ? 1u : 0u;
            }
            counts.push_back(count);
        }
    }
    return counts;
}

/// Rectangles of every kind: small, picture-sized, huge, off the picture, reversed, without size, on the half-pixel and
/// whole-pixel grid (where a wrong rule shows), and not finite.
std::vector<PixelRect> MakeRects(unsigned seed) {
    std::mt19937 random(seed);
    const auto uniform = [&random](double from, double to) {
        return from + (to - from) * (static_cast<double>(random()) / 4294967296.0);
    };
    std::vector<PixelRect> rects;
    for (int i = 0; i < 60; ++i) {
        const double x = uniform(-40, 200), y = uniform(-40, 130);
        rects.push_back({x, y, x + uniform(0, 3), y + uniform(0, 3)});
        rects.push_back({x, y, x + uniform(0, 200), y + uniform(0, 200)});
        const double gridX = std::floor(x) + 0.5, gridY = std::floor(y) + 0.5;
        rects.push_back({gridX, gridY, gridX + std::floor(uniform(0, 30)), gridY + std::floor(uniform(0, 30))});
        rects.push_back({std::floor(x), std::floor(y), std::floor(x) + 5, std::floor(y) + 7});
        rects.push_back({x, y, x, y + 10});
        rects.push_back({x, y, x - uniform(0, 9), y + 4});
    }
    const double infinity = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    rects.insert(rects.end(), {{-1e30, -1e30, 1e30, 1e30},
                               {-infinity, 10, infinity, 20},
                               {-1e9, 3, 50, 1e18},
                               {0, 0, pictureWidth, pictureHeight},
                               {156.5, 90.5, 157, 91},
                               {-5, -5, 0.5, 0.5},
                               {-5, -5, std::nextafter(0.5, 1.0), std::nextafter(0.5, 1.0)},
                               {200, 0, 300, 91},
                               {nan, 0, 10, 10},
                               {0, 0, 10, nan}});
    return rects;
}

std::unique_ptr<GlRenderer> MakeGl(Backend backend) { return std::make_unique<GlRenderer>(MakeContext(backend)); }

class CountsOnGl : public testing::TestWithParam<Backend> {};

TEST_P(CountsOnGl, EqualTheDifferenceArrayAndBruteForce) {
    const auto gl = MakeGl(GetParam());
    for (unsigned seed = 1; seed <= 4; ++seed) {
        const std::vector<PixelRect> rects = MakeRects(seed);
        const std::vector<uint32_t> expected = CountByBruteForce(rects, pictureWidth, pictureHeight);
        EXPECT_EQ(CountRects(rects, pictureWidth, pictureHeight).counts, expected) << "CPU, seed " << seed;
        EXPECT_EQ(gl->Count(rects, pictureWidth, pictureHeight).counts, expected) << "GL, seed " << seed;
    }
}

TEST_P(CountsOnGl, EqualTheDifferenceArrayOnALargePictureAfterASmallOne) {
    const auto gl = MakeGl(GetParam());
    (void)gl->Count(MakeRects(1), 64, 64);
    std::vector<PixelRect> rects = MakeRects(7);
    for (PixelRect& rect : rects) rect = {rect.x0 * 12.3, rect.y0 * 12.3, rect.x1 * 12.3, rect.y1 * 12.3};
    EXPECT_EQ(gl->Count(rects, 1920, 1080).counts, CountRects(rects, 1920, 1080).counts);
    EXPECT_EQ(gl->Count({}, 640, 400).counts, std::vector<uint32_t>(640 * 400, 0u));
}

TEST_P(CountsOnGl, DoNotSaturate) {
    const auto gl = MakeGl(GetParam());
    const std::vector<PixelRect> rects(100'000, PixelRect{1, 1, 3, 3});
    const CountImage counts = gl->Count(rects, 8, 8);
    EXPECT_EQ(counts.counts[8 + 1], 100'000u);
    EXPECT_EQ(counts.counts[0], 0u);
}

/// What SnapRect does, with one mistake.
PixelBox SnapWrongly(const PixelRect& rect, int mutation) {
    if (!(rect.x0 < rect.x1 && rect.y0 < rect.y1)) return {0, 0, 0, 0};
    const auto snap = [mutation](double edge, int size, bool isUpper) {
        double pixel = std::ceil(edge - 0.5);
        if (mutation == 0) pixel = std::floor(edge + 0.5);      // a centre on the upper edge counts, on the lower not
        if (mutation == 1 && isUpper) pixel = std::ceil(edge);  // covers pixels it only touches
        if (mutation == 2) pixel = std::floor(edge);            // corner rule instead of centre rule
        return static_cast<int32_t>(std::clamp(pixel, 0.0, static_cast<double>(size)));
    };
    const PixelBox box{snap(rect.x0, pictureWidth, false), snap(rect.y0, pictureHeight, false),
                       snap(rect.x1, pictureWidth, true), snap(rect.y1, pictureHeight, true)};
    if (box.x0 >= box.x1 || box.y0 >= box.y1) return {0, 0, 0, 0};
    return box;
}

TEST_P(CountsOnGl, WrongSnappingIsSeen) {
    const auto gl = MakeGl(GetParam());
    const std::vector<PixelRect> rects = MakeRects(1);
    const CountImage oracle = CountRects(rects, pictureWidth, pictureHeight);
    for (int mutation = 0; mutation < 3; ++mutation) {
        std::vector<PixelBox> boxes;
        for (const PixelRect& rect : rects) boxes.push_back(SnapWrongly(rect, mutation));
        EXPECT_NE(gl->CountBoxes(boxes, pictureWidth, pictureHeight).counts, oracle.counts) << "mutation " << mutation;
    }
}

INSTANTIATE_TEST_SUITE_P(Backends, CountsOnGl, testing::Values(Backend::osmesa, Backend::egl),
                         [](const auto& tested) { return std::string(GetBackendName(tested.param)); });

TEST(Counts, TinyPictures) {
    const std::vector<PixelRect> rects{{0, 0, 1, 1}, {-1, -1, 5, 5}, {0.6, 0, 1, 1}};
    EXPECT_EQ(CountRects(rects, 1, 1).counts, std::vector<uint32_t>{2u});
}

}  // namespace
}  // namespace testbed
