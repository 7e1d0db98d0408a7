// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Bands: the same pixels as drawing the whole picture at once, for any number of threads, samples and rows.

#include "testbed/picture/layer_bands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>

#include "testbed/picture/composite.h"
#include "testbed/picture/rasterizer.h"

namespace testbed {
namespace {

/// Triangles of all sizes, many across several bands, with corners on all edges of the picture.
DrawList MakeList(int width, int height, int supersampling) {
    std::mt19937 random(static_cast<unsigned>(width + height));
    DrawList list;
    list.width = width;
    list.height = height;
    list.supersampling = supersampling;
    const auto pick = [&random](int size) {
        return static_cast<int32_t>(random() % (static_cast<unsigned>(size) + 1));
    };
    for (int i = 0; i < 300; ++i) {
        const int right = width * supersampling * fixedPointOne, bottom = height * supersampling * fixedPointOne;
        const FixedPoint a{pick(right), pick(bottom)};
        const auto near = [&](const FixedPoint& point) {
            const int reach = i % 10 == 0 ? bottom : 40 * fixedPointOne;
            return FixedPoint{std::clamp(point.x + pick(2 * reach) - reach, 0, right),
                              std::clamp(point.y + pick(2 * reach) - reach, 0, bottom)};
        };
        const auto byte = [&random] { return static_cast<uint8_t>(random()); };
        list.triangles.push_back({a, near(a), near(a), {byte(), byte(), byte(), byte()}});
    }
    return list;
}

TEST(LayerBands, EqualTheWholePicture) {
    for (const int supersampling : {1, 2, 4}) {
        for (const auto& [width, height] : {std::pair{90, 200}, std::pair{64, 16}, std::pair{33, 129}}) {
            const DrawList list = MakeList(width, height, supersampling);
            Image samples(width * supersampling, height * supersampling, Color{0, 0, 0, 0});
            RasterizeTriangles(list.triangles, samples);
            Image expected(width, height, Color{51, 60, 70, 255});
            CompositeSamples(samples, supersampling, expected);
            for (const int threads : {1, 2, 5}) {
                Image picture(width, height, Color{51, 60, 70, 255});
                DrawInBands(list, threads, picture);
                EXPECT_TRUE(picture.pixels == expected.pixels) << width << "x" << height << " " << supersampling;
            }
        }
    }
}

TEST(LayerBands, SizesThatDoNotFitAreRefused) {
    Image picture(10, 11, {});
    EXPECT_THROW(DrawInBands(MakeList(10, 10, 1), 1, picture), std::invalid_argument);
}

}  // namespace
}  // namespace testbed
