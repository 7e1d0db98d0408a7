// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Colour bars and strips: the bar runs through its colours from end to end, marks that stand close keep their text
// beside each other, and text is made smaller rather than cut off.

#include "testbed/view/annotate.h"

#include <gtest/gtest.h>

#include "testbed/picture/font.h"

namespace testbed {
namespace {

constexpr Color paper{10, 10, 10, 255};

Image DrawBar(const std::vector<BarMark>& marks) {
    Image image(300, 40, paper);
    const auto color = [](double position) { return Color{0, static_cast<uint8_t>(position * 255), 200, 255}; };
    DrawColorBar(image, {{20, 4, 276, 14}, color, marks}, 1);
    return image;
}

/// Pixels of text below the bar's ticks.
int CountInk(const Image& image) {
    int ink = 0;
    for (int y = 17; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) ink += image.At(x, y) == GetTheme(Theme::dark).text ? 1 : 0;
    }
    return ink;
}

TEST(Annotate, BarRunsFromEndToEnd) {
    const Image image = DrawBar({});
    EXPECT_EQ(image.At(20, 8).g, 0);
    EXPECT_EQ(image.At(275, 8).g, 254);
    for (int x = 21; x < 276; ++x) EXPECT_GE(image.At(x, 8).g, image.At(x - 1, 8).g);
    EXPECT_EQ(image.At(18, 8), paper);
    EXPECT_EQ(image.At(277, 8), paper);
}

TEST(Annotate, MarksThatStandCloseKeepTheirText) {
    const std::vector<BarMark> marks{{1, "100"}, {0, "0"}, {0.02, "mean 2"}, {0.04, "other 4"}};
    int separately = 0;
    for (const BarMark& mark : marks) separately += CountInk(DrawBar({mark}));
    EXPECT_EQ(CountInk(DrawBar(marks)), separately);
}

TEST(Annotate, MarksWithoutRoomLoseTheirTextNotTheirTick) {
    const std::string longText(60, 'm');
    const Image image = DrawBar({{0, "0"}, {0.5, longText}});
    EXPECT_EQ(CountInk(image), CountInk(DrawBar({{0, "0"}})));
    EXPECT_EQ(image.At(20 + 128, 15), (Color{255, 255, 255, 255}));
}

TEST(Annotate, TextThatDoesNotFitIsMadeSmaller) {
    const std::string text(40, 'x');
    EXPECT_EQ(FitScale(text, 2, GetTextWidth(text, 2)), 2);
    EXPECT_EQ(FitScale(text, 2, GetTextWidth(text, 2) - 1), 1);
    EXPECT_EQ(FitScale(text, 2, 1), 1);
    EXPECT_EQ(GetLabelScale(1920), 2);
    EXPECT_EQ(GetLabelScale(640), 1);
}

}  // namespace
}  // namespace testbed
