// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Colour bars and strips. The bar runs through its colours from end to end, ticks are round numbers and no texts
// overlap. Text is made smaller rather than cut off, and bars of metres are as long as they say.

#include "testbed/view/annotate.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "testbed/picture/font.h"
#include "testbed/view/camera.h"

namespace testbed {
namespace {

constexpr Color paper{10, 10, 10, 255};

constexpr PixelBox barBox{20, 20, 276, 30};

Image DrawBar(const std::vector<BarMark>& marks) {
    Image image(300, 60, paper);
    const auto color = [](double position) { return Color{0, static_cast<uint8_t>(position * 255), 200, 255}; };
    DrawColorBar(image, {barBox, color, marks}, 1);
    return image;
}

/// Pixels of text above and below the bar and its marks.
int CountInk(const Image& image) {
    int ink = 0;
    for (int y = 0; y < image.height; ++y) {
        if (y >= barBox.y0 - 2 && y < barBox.y1 + 2) continue;
        for (int x = 0; x < image.width; ++x) ink += image.At(x, y) == paper ? 0 : 1;
    }
    return ink;
}

TEST(Annotate, BarRunsFromEndToEnd) {
    const Image image = DrawBar({});
    EXPECT_EQ(image.At(20, 24).g, 0);
    EXPECT_EQ(image.At(275, 24).g, 254);
    for (int x = 21; x < 276; ++x) EXPECT_GE(image.At(x, 24).g, image.At(x - 1, 24).g);
    EXPECT_EQ(image.At(18, 24), paper);
    EXPECT_EQ(image.At(277, 24), paper);
}

TEST(Annotate, MarksThatStandCloseKeepTheirTextAboveTheBar) {
    const std::vector<BarMark> marks{{0, "mean 1", false}, {0.02, "mean 2", false}, {0.04, "other 4", false}};
    int separately = 0;
    for (const BarMark& mark : marks) separately += CountInk(DrawBar({mark}));
    EXPECT_EQ(CountInk(DrawBar(marks)), separately);
}

TEST(Annotate, TicksWithoutRoomLoseTheirTextNotTheirLine) {
    const std::string longText(60, 'm');
    const Image image = DrawBar({{0, "0"}, {0.5, longText}});
    EXPECT_EQ(CountInk(image), CountInk(DrawBar({{0, "0"}})));
    EXPECT_EQ(image.At(barBox.x0 + 128, barBox.y1 + 1), (Color{255, 255, 255, 255}));
    EXPECT_EQ(CountInk(DrawBar({{0.5, "12345"}, {0.51, "67890"}})), CountInk(DrawBar({{0.5, "12345"}})));
}

TEST(Annotate, TicksAreRoundAndApart) {
    EXPECT_TRUE(rc::check("ticks", [] {
        const int64_t end = *rc::gen::inRange<int64_t>(1, int64_t{1} << *rc::gen::inRange(1, 40));
        const int intervals = *rc::gen::inRange(2, 9);
        const std::vector<int64_t> ticks = ChooseTicks(end, intervals);
        RC_ASSERT(ticks.front() == 0 && ticks.back() == end);
        RC_ASSERT(static_cast<int>(ticks.size()) <= intervals + 1);
        if (ticks.size() == 2) return;
        int64_t step = ticks[1];
        for (size_t i = 1; i + 1 < ticks.size(); ++i) RC_ASSERT(ticks[i] == static_cast<int64_t>(i) * step);
        RC_ASSERT(2 * (end - ticks[ticks.size() - 2]) >= step);
        while (step % 10 == 0) step /= 10;
        RC_ASSERT(step == 1 || step == 2 || step == 5);
    }));
    EXPECT_EQ(ChooseTicks(148, 5), (std::vector<int64_t>{0, 50, 100, 148}));
    EXPECT_EQ(ChooseTicks(17, 5), (std::vector<int64_t>{0, 5, 10, 17}));
    EXPECT_EQ(ChooseLogarithmicTicks(30), (std::vector<int64_t>{0, 1, 2, 5, 10, 20, 30}));
}

TEST(Annotate, BarsOfMetresAreRoundAndAsLongAsTheySay) {
    EXPECT_TRUE(rc::check("metres", [] {
        const int width = *rc::gen::inRange(200, 4000);
        const double across = std::pow(10.0, *rc::gen::inRange(-600, 900) / 100.0);
        const Camera camera = MakeCamera({*rc::gen::inRange(-100, 100) * 1.0, 3, across}, width, 100);
        const ScaleBar bar = ChooseScaleBar(camera.pixelsPerMetre, width * 0.2);
        const double drawn = camera.ToPixelX(camera.x + bar.metres) - camera.ToPixelX(camera.x);
        RC_ASSERT(std::abs(drawn - bar.pixels) < 1e-3);  // of a pixel: a length of 1e-7 m was added to 100 m
        RC_ASSERT(bar.pixels <= width * 0.2 * (1 + 1e-9) && bar.pixels > width * 0.08 * (1 - 1e-9));
        std::istringstream text(bar.text);
        double number = 0;
        std::string unit;
        text >> number >> unit;
        const std::map<std::string, double> units{{"km", 1e3},  {"m", 1},     {"cm", 1e-2},
                                                  {"mm", 1e-3}, {"µm", 1e-6}, {"nm", 1e-9}};
        RC_ASSERT(units.contains(unit));
        RC_ASSERT(std::abs(number * units.at(unit) / bar.metres - 1) < 1e-12);
        RC_ASSERT(number >= 1);
        while (number >= 10) number /= 10;
        RC_ASSERT(number == 1 || number == 2 || number == 5);
    }));
}

TEST(Annotate, TheDrawnBarOfMetresIsRoundedToWholePixels) {
    EXPECT_TRUE(rc::check("drawn", [] {
        const double pixelsPerMetre = std::pow(10.0, *rc::gen::inRange(-300, 300) / 100.0);
        const int scale = *rc::gen::inRange(1, 3);
        Image image(900, 100, {0, 0, 0, 255});
        DrawScaleBar(image, pixelsPerMetre, 100, scale);
        const Color line = GetTheme(Theme::dark).label;
        const int row = 100 - 4 * scale - 1;  // the bar itself
        int first = 0;
        while (first < 900 && !(image.At(first, row) == line)) ++first;
        int last = first;
        while (last + 1 < 900 && image.At(last + 1, row) == line) ++last;
        const double length = ChooseScaleBar(pixelsPerMetre, 180).pixels;
        RC_ASSERT(std::abs(last + 1 - scale - first - length) <= 0.5);
    }));
    Image small(40, 20, paper);
    DrawScaleBar(small, 1, 10, 2);
    EXPECT_TRUE(std::ranges::all_of(small.pixels, [](const Color& color) { return color == paper; })) << "no room";
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
