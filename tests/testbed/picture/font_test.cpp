// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The font has every printable ASCII character, no two alike, and draws them where it is told, clipped.

#include "testbed/picture/font.h"

#include <gtest/gtest.h>

#include <map>

namespace testbed {
namespace {

TEST(Font, CoversAsciiWithDistinctGlyphs) {
    std::map<std::array<uint8_t, glyphHeight>, char> seen;
    for (char character = ' '; character <= '~'; ++character) {
        const auto& glyph = GetGlyph(character);
        EXPECT_TRUE(seen.emplace(glyph, character).second) << character << " looks like " << seen[glyph];
        bool isBlank = true;
        for (const uint8_t row : glyph) {
            EXPECT_LT(row, 1 << glyphWidth) << character;
            isBlank = isBlank && row == 0;
        }
        EXPECT_EQ(isBlank, character == ' ') << character;
    }
    EXPECT_EQ(GetGlyph('\xC3'), GetGlyph('\n')) << "what it lacks is one hollow box";
    EXPECT_FALSE(seen.contains(GetGlyph('\n')));
}

TEST(Font, DrawsScaledPixelsAndClips) {
    const Color ink{9, 9, 9, 255}, paper{0, 0, 0, 255};
    Image image(40, 20, paper);
    DrawText(image, 2, 1, "L", 2, ink);
    EXPECT_EQ(image.At(2, 1), ink);  // the stem's top
    EXPECT_EQ(image.At(3, 2), ink);
    EXPECT_EQ(image.At(4, 1), paper);
    EXPECT_EQ(image.At(2 + 2 * 4, 1 + 2 * 6), ink);  // the foot's end
    DrawText(image, -3, -3, "WW", 3, ink);
    DrawText(image, 38, 18, "WW", 3, ink);
    DrawText(image, 500, 500, "W", 1, ink);
}

TEST(Font, WidthLeavesOutTheLastGap) {
    EXPECT_EQ(GetTextWidth("", 2), 0);
    EXPECT_EQ(GetTextWidth("a", 1), glyphWidth);
    EXPECT_EQ(GetTextWidth("abc", 2), (2 * glyphAdvance + glyphWidth) * 2);
}

}  // namespace
}  // namespace testbed
