// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Colour tables: the alpha look is the closed form of blending, every style starts at the background and ends at its
// brightest, and differences are blue below, red above.

#include "testbed/picture/palette.h"

#include <gtest/gtest.h>

#include <cmath>

namespace testbed {
namespace {

TEST(Palette, AlphaIsTheClosedFormOfBlending) {
    const double opacity = 0.04;
    const std::vector<Color> palette = MakePalette(Style::alpha, opacity, 500);
    ASSERT_EQ(palette.size(), 501u);
    for (size_t n = 0; n < palette.size(); ++n) {
        const double covered = 1 - std::pow(1 - opacity, static_cast<double>(n));
        // Half a step for rounding, and one part in 10^9 for the product against std::pow.
        EXPECT_NEAR(palette[n].r, 51 + (255 - 51) * covered, 0.5 + 1e-9);
        EXPECT_NEAR(palette[n].g, 51 * (1 - covered), 0.5 + 1e-9);
        EXPECT_EQ(palette[n].g, palette[n].b);
    }
    EXPECT_EQ(palette.front(), backgroundColor);
    EXPECT_EQ(palette.back(), (Color{255, 0, 0, 255}));
}

TEST(Palette, StylesRunFromTheBackgroundToTheirEnd) {
    for (const Style style : {Style::heat, Style::log}) {
        const std::vector<Color> palette = MakePalette(style, 0.04, 300);
        EXPECT_EQ(palette.front(), backgroundColor);
        EXPECT_EQ(palette.back(), (Color{252, 255, 190, 255}));
    }
    EXPECT_LT(GetScalePosition(Style::heat, 3, 300), 0.02);
    EXPECT_GT(GetScalePosition(Style::log, 3, 300), 0.2) << "few layers are seen";
    EXPECT_EQ(GetScalePosition(Style::log, 300, 300), 1);
    EXPECT_EQ(GetScalePosition(Style::log, 0, 300), 0);
}

TEST(Palette, OnALightBackgroundLightnessFalls) {
    for (const Style style : {Style::alpha, Style::heat, Style::log}) {
        const std::vector<Color> palette = MakePalette(style, 0.04, 300, Theme::light);
        EXPECT_EQ(palette.front(), GetTheme(Theme::light).background);
        const auto lightness = [](const Color& color) {
            return 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b;
        };
        for (size_t n = 1; n < palette.size(); ++n) {
            // Each channel is rounded once.
            EXPECT_LE(lightness(palette[n]), lightness(palette[n - 1]) + 1) << GetStyleName(style) << " " << n;
        }
    }
    EXPECT_EQ(GetDifferenceColor(0, 50, Theme::light), GetTheme(Theme::light).background);
    EXPECT_GT(GetDifferenceColor(-20, 50, Theme::light).b, GetDifferenceColor(-20, 50, Theme::light).r);
    EXPECT_GT(GetDifferenceColor(20, 50, Theme::light).r, GetDifferenceColor(20, 50, Theme::light).b);
}

TEST(Palette, BandsHaveHardEdgesAndEqualWidth) {
    const std::vector<Color> palette = MakePalette(Style::bands, 0.04, 80);
    EXPECT_EQ(palette[0], backgroundColor);
    int changes = 0;
    for (size_t n = 2; n < palette.size(); ++n) changes += palette[n] == palette[n - 1] ? 0 : 1;
    EXPECT_EQ(changes, 7);
    EXPECT_EQ(palette[1], palette[10]);
    EXPECT_FALSE(palette[10] == palette[11]);
    EXPECT_EQ(MakePalette(Style::bands, 0.04, 1).size(), 2u);
}

TEST(Palette, CountsAboveTheScaleTakeTheLastColour) {
    const std::vector<Color> palette = MakePalette(Style::heat, 0.04, 10);
    const Image image = ColorCounts({3, 1, {0, 10, 4'000'000'000u}}, palette);
    EXPECT_EQ(image.At(0, 0), backgroundColor);
    EXPECT_EQ(image.At(1, 0), palette[10]);
    EXPECT_EQ(image.At(2, 0), palette[10]);
}

TEST(Palette, DifferencesAreBlueBelowAndRedAbove) {
    EXPECT_EQ(GetDifferenceColor(0, 50), backgroundColor);
    for (int64_t value = 1; value <= 60; ++value) {
        const Color above = GetDifferenceColor(value, 50), below = GetDifferenceColor(-value, 50);
        EXPECT_GT(above.r, above.b) << value;
        EXPECT_GT(below.b, below.r) << value;
    }
    EXPECT_EQ(GetDifferenceColor(60, 50), GetDifferenceColor(50, 50));
    EXPECT_EQ(GetDifferenceColor(-60, 50), GetDifferenceColor(-50, 50));
    const Image image = ColorDifference({3, 1, {0, 5, 7}}, {3, 1, {9, 5, 0}}, 9);
    EXPECT_EQ(image.At(0, 0), GetDifferenceColor(-9, 9));
    EXPECT_EQ(image.At(1, 0), backgroundColor);
    EXPECT_EQ(image.At(2, 0), GetDifferenceColor(7, 9));
    EXPECT_THROW((void)ColorDifference({1, 1, {0}}, {2, 1, {0, 0}}, 9), std::invalid_argument);
}

TEST(Palette, StyleNamesReadBack) {
    for (const Style style : {Style::alpha, Style::heat, Style::bands, Style::log}) {
        EXPECT_EQ(ParseStyle(GetStyleName(style)), style);
    }
    EXPECT_THROW((void)ParseStyle("rainbow"), std::invalid_argument);
}

}  // namespace
}  // namespace testbed
