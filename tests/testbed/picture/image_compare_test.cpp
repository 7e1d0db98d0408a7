// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The comparison of two pictures: what it must count, and that it cannot pass what differs.

#include "testbed/picture/image_compare.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

namespace testbed {
namespace {

constexpr Color grey{100, 100, 100, 255};

TEST(ImageCompare, EqualPicturesHaveNoDifference) {
    const Image image(7, 5, grey);
    const PixelDifference found = ComparePixels(image, image, {});
    EXPECT_EQ(found.changed, 0);
    EXPECT_EQ(found.maxDifference, 0);
}

TEST(ImageCompare, CountsBoundsAndLargestDifferenceAreThoseOfTheChangedPixels) {
    const Image expected(20, 10, grey);
    Image actual = expected;
    actual.At(3, 2).r = 90;
    actual.At(11, 7).b = 130;
    actual.At(5, 4).g = 101;
    const PixelDifference found = ComparePixels(expected, actual, {});
    EXPECT_EQ(found.changed, 3);
    EXPECT_EQ(found.maxDifference, 30);
    EXPECT_EQ(found.box, (PixelArea{3, 2, 12, 8}));
}

// Each pixel and channel matters, the corners too: one bit anywhere must be seen.
TEST(ImageCompare, OneBitOfAnyChannelIsSeen) {
    const Image expected(9, 6, grey);
    for (int y = 0; y < expected.height; ++y) {
        for (int x = 0; x < expected.width; ++x) {
            for (uint8_t Color::*channel : {&Color::r, &Color::g, &Color::b, &Color::a}) {
                Image actual = expected;
                actual.At(x, y).*channel ^= 1;
                const PixelDifference found = ComparePixels(expected, actual, {});
                ASSERT_EQ(found.changed, 1) << x << ", " << y;
                ASSERT_EQ(found.box, (PixelArea{x, y, x + 1, y + 1}));
            }
        }
    }
}

// Against the definition, pixel by pixel, on random pictures, tolerances and masks.
TEST(ImageCompare, ToleranceAndMaskAgreeWithTheDefinition) {
    std::mt19937 random(5);
    const auto pick = [&random](int last) { return static_cast<int>(random() % static_cast<unsigned>(last + 1)); };
    for (int round = 0; round < 50; ++round) {
        Image a(16, 12, grey), b = a;
        for (Color& color : b.pixels) {
            if (pick(3) == 0) color.g = static_cast<uint8_t>(color.g + pick(12));
        }
        CompareRule rule;
        rule.tolerance = pick(8);
        rule.mask = {{2, 3, 2 + 1 + pick(8), 3 + 1 + pick(6)}, {0, 0, 1, 1}};
        int64_t changed = 0, tolerated = 0, masked = 0;
        for (int y = 0; y < a.height; ++y) {
            for (int x = 0; x < a.width; ++x) {
                const int distance = b.At(x, y).g - a.At(x, y).g;
                bool isMasked = false;
                for (const PixelArea& m : rule.mask) isMasked |= x >= m.x0 && x < m.x1 && y >= m.y0 && y < m.y1;
                if (distance == 0) continue;
                ++(isMasked ? masked : distance <= rule.tolerance ? tolerated : changed);
            }
        }
        const PixelDifference found = ComparePixels(a, b, rule);
        EXPECT_EQ(found.changed, changed);
        EXPECT_EQ(found.tolerated, tolerated);
        EXPECT_EQ(found.masked, masked);
    }
}

TEST(ImageCompare, RefusesPicturesOfDifferentSizes) {
    EXPECT_THROW((void)ComparePixels(Image(3, 4, grey), Image(4, 3, grey), {}), std::invalid_argument);
    EXPECT_THROW((void)MakeDifferencePicture(Image(3, 4, grey), Image(3, 5, grey), {}), std::invalid_argument);
}

TEST(ImageCompare, TheDifferencePictureMarksWhatDiffers) {
    const Image expected(8, 1, grey);
    Image actual = expected;
    actual.At(1, 0).r = 255;  // changed
    actual.At(3, 0).r = 102;  // tolerated
    actual.At(5, 0).r = 255;  // masked
    CompareRule rule;
    rule.tolerance = 2;
    rule.mask = {{5, 0, 6, 1}};
    const Image picture = MakeDifferencePicture(expected, actual, rule);
    const Color plain = picture.At(0, 0);
    EXPECT_EQ(plain, (Color{33, 33, 33, 255}));
    EXPECT_EQ(picture.At(1, 0).r, 255);
    for (const int x : {1, 3, 5}) EXPECT_NE(picture.At(x, 0), plain) << x;
    EXPECT_NE(picture.At(3, 0), picture.At(5, 0));
    EXPECT_EQ(picture.At(7, 0), plain);
}

}  // namespace
}  // namespace testbed
