// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Compositing is the mean of the samples over the background, to within one rounding.

#include "testbed/picture/composite.h"

#include <gtest/gtest.h>

#include <random>

namespace testbed {
namespace {

TEST(Composite, IsTheMeanOfTheSamplesOverTheBackground) {
    std::mt19937 random(3);
    const auto byte = [&random] { return static_cast<uint8_t>(random() % 256); };
    for (const int supersampling : {1, 2, 4}) {
        Image samples(7 * supersampling, 5 * supersampling, {0, 0, 0, 0});
        for (Color& sample : samples.pixels) {
            if (random() % 3 != 0) sample = {byte(), byte(), byte(), byte()};
        }
        Image picture(7, 5, {51, 90, 200, 255});
        const Image before = picture;
        CompositeSamples(samples, supersampling, picture);
        for (int y = 0; y < 5; ++y) {
            for (int x = 0; x < 7; ++x) {
                double red = 0;
                for (int j = 0; j < supersampling; ++j) {
                    for (int i = 0; i < supersampling; ++i) {
                        const Color& sample = samples.At(x * supersampling + i, y * supersampling + j);
                        red += (before.At(x, y).r * (255.0 - sample.a) + sample.r * double{1} * sample.a) / 255;
                    }
                }
                EXPECT_NEAR(picture.At(x, y).r, red / (supersampling * supersampling), 0.5 + 1e-9);
                EXPECT_EQ(picture.At(x, y).a, 255);
            }
        }
    }
}

TEST(Composite, OpaqueReplacesAndTransparentKeeps) {
    Image picture(1, 1, {1, 2, 3, 255});
    CompositeSamples(Image(2, 2, {0, 0, 0, 0}), 2, picture);
    EXPECT_EQ(picture.At(0, 0), (Color{1, 2, 3, 255}));
    CompositeSamples(Image(2, 2, {200, 100, 50, 255}), 2, picture);
    EXPECT_EQ(picture.At(0, 0), (Color{200, 100, 50, 255}));
    EXPECT_THROW(CompositeSamples(Image(3, 2, {}), 2, picture), std::invalid_argument);
    EXPECT_THROW(CompositeSamples(Image(3, 3, {}), 3, picture), std::invalid_argument);
}

TEST(Composite, BlendRectClips) {
    Image picture(4, 4, {0, 0, 0, 255});
    BlendRect(picture, {-5, -5, 2, 2}, {255, 255, 255, 255});
    BlendRect(picture, {3, 3, 9, 9}, {100, 100, 100, 255});
    EXPECT_EQ(picture.At(1, 1).r, 255);
    EXPECT_EQ(picture.At(2, 2).r, 0);
    EXPECT_EQ(picture.At(3, 3).r, 100);
}

}  // namespace
}  // namespace testbed
