// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The CPU rasteriser and OpenGL agree on every sample, on both backends, in every colour. Triangles are random, with
// edges that run through sample centres, without area, and as large as the picture.

#include "testbed/picture/rasterizer.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "testbed/gl/renderer.h"

namespace testbed {
namespace {

constexpr Color transparent{0, 0, 0, 0};

std::vector<Triangle> MakeTriangles(unsigned seed, int width, int height) {
    std::mt19937 random(seed);
    const auto below = [&random](int limit) { return static_cast<int32_t>(random() % static_cast<unsigned>(limit)); };
    const auto byte = [&below] { return static_cast<uint8_t>(below(256)); };
    std::vector<Triangle> triangles;
    for (int i = 0; i < 600; ++i) {
        const int grid = i % 3 == 0 ? 1 : (i % 3 == 1 ? 128 : 256);  // the coarse grids put edges through centres
        const int spread = i % 4 == 0 ? 4000 : 9;                    // samples
        const auto near = [&](int32_t center, int size) {
            const int32_t value = center + below(2 * spread * fixedPointOne) - spread * fixedPointOne;
            return std::clamp(value / grid * grid, 0, size * fixedPointOne);
        };
        const int32_t x = below(width * fixedPointOne), y = below(height * fixedPointOne);
        triangles.push_back({{near(x, width), near(y, height)},
                             {near(x, width), near(y, height)},
                             {near(x, width), near(y, height)},
                             {byte(), byte(), byte(), byte()}});
    }
    return triangles;
}

size_t CountDifferences(const Image& first, const Image& second) {
    size_t differences = 0;
    for (size_t i = 0; i < first.pixels.size(); ++i) differences += first.pixels[i] == second.pixels[i] ? 0u : 1u;
    return differences;
}

class TrianglesOnGl : public testing::TestWithParam<Backend> {};

TEST_P(TrianglesOnGl, EqualTheCpuRasterizer) {
    const auto gl = MakeRenderer(GetParam());
    const auto cpu = MakeRenderer(Backend::cpu);
    unsigned seed = 1;
    for (const auto& [width, height] : {std::pair{97, 61}, std::pair{640, 400}, std::pair{3840, 2160}}) {
        const std::vector<Triangle> triangles = MakeTriangles(seed++, width, height);
        Image expected(width, height, transparent), actual(width, height, transparent);
        cpu->Draw(triangles, expected);
        gl->Draw(triangles, actual);
        EXPECT_EQ(CountDifferences(expected, actual), 0u) << width << "x" << height;
    }
}

TEST_P(TrianglesOnGl, SingleTrianglesOnTheSampleGridAgree) {
    // One at a time on a tiny target, corners on multiples of half a sample: every tie of the edge rule occurs.
    const auto gl = MakeRenderer(GetParam());
    constexpr int size = 4;
    Image expected(size, size, transparent), actual(size, size, transparent);
    std::mt19937 random(11);
    const auto corner = [&random] {
        return FixedPoint{static_cast<int32_t>(random() % 9) * 128, static_cast<int32_t>(random() % 9) * 128};
    };
    for (int i = 0; i < 2000; ++i) {
        const std::vector<Triangle> triangles{{corner(), corner(), corner(), {1, 2, 3, 4}}};
        std::fill(expected.pixels.begin(), expected.pixels.end(), transparent);
        RasterizeTriangles(triangles, expected);
        gl->Draw(triangles, actual);
        ASSERT_EQ(CountDifferences(expected, actual), 0u)
            << triangles[0].a.x << "," << triangles[0].a.y << " " << triangles[0].b.x << "," << triangles[0].b.y << " "
            << triangles[0].c.x << "," << triangles[0].c.y;
    }
}

TEST_P(TrianglesOnGl, EveryByteOfAColourComesBack) {
    const auto gl = MakeRenderer(GetParam());
    std::vector<Triangle> triangles;
    for (int i = 0; i < 256; ++i) {
        const auto value = static_cast<uint8_t>(i);
        const auto other = static_cast<uint8_t>(255 - i);
        const int32_t x = i * fixedPointOne;
        triangles.push_back({{x, 0}, {x + fixedPointOne, 0}, {x, 2 * fixedPointOne}, {value, other, value, other}});
    }
    Image image(256, 2, transparent);
    gl->Draw(triangles, image);
    for (int i = 0; i < 256; ++i) {
        const auto value = static_cast<uint8_t>(i);
        const auto other = static_cast<uint8_t>(255 - i);
        EXPECT_EQ(image.At(i, 0), (Color{value, other, value, other})) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Backends, TrianglesOnGl, testing::Values(Backend::osmesa, Backend::egl),
                         [](const auto& tested) { return std::string(GetBackendName(tested.param)); });

TEST(Rasterizer, TrianglesThatShareAnEdgeCoverEachSampleOnce) {
    // A fan around an inner point tiles the square exactly: no gap, no overlap. Overlap is seen by drawing one triangle
    // at a time on its own.
    constexpr int size = 16;
    constexpr int32_t side = size * fixedPointOne;
    std::mt19937 random(5);
    for (int i = 0; i < 200; ++i) {
        const auto inner = [&random] {
            return static_cast<int32_t>(random() % size) * fixedPointOne + fixedPointOne / 2;
        };
        const FixedPoint center{inner(), inner()};
        const std::vector<FixedPoint> square{{0, 0}, {side, 0}, {side, side}, {0, side}};
        std::vector<int> covered(size * size, 0);
        for (size_t k = 0; k < 4; ++k) {
            Image image(size, size, transparent);
            RasterizeTriangles(std::vector<Triangle>{{center, square[k], square[(k + 1) % 4], {9, 9, 9, 9}}}, image);
            for (size_t p = 0; p < covered.size(); ++p) covered[p] += image.pixels[p].a == 9 ? 1 : 0;
        }
        ASSERT_EQ(covered, std::vector<int>(size * size, 1));
    }
}

}  // namespace
}  // namespace testbed
