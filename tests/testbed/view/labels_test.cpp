// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Scales: every numbered tick stands at its number's place and colour. Panes beside each other have letters of one
// size.

#include "testbed/view/labels.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/testbed/view/sample_snapshot.h"

namespace testbed {
namespace {

TEST(Labels, TicksOfACountScaleStandAtTheirNumbers) {
    EXPECT_TRUE(rc::check("ticks of counts", [] {
        PictureOptions options;
        options.style = *rc::gen::element(Style::alpha, Style::heat, Style::bands, Style::log);
        const auto scaleMax = static_cast<uint32_t>(*rc::gen::inRange(1, 3000));
        const ColorBar bar = MakeCountBar({0, 0, 500, 10}, scaleMax, options);
        const std::vector<Color> palette =
            MakePalette(options.style, GetOpacity(options, scaleMax), scaleMax, options.theme);
        uint32_t end = 0;
        for (const BarMark& mark : bar.marks) {
            const std::string digits = mark.text.starts_with("≥ ") ? mark.text.substr(4) : mark.text;
            const auto number = static_cast<uint32_t>(std::stoul(digits));
            if (end == 0) end = number;  // the end comes first
            RC_ASSERT(number <= end);
            RC_ASSERT(mark.position == GetScalePosition(options.style, number, end));
            RC_ASSERT(bar.color(mark.position) == palette[number]);
        }
        RC_ASSERT(bar.marks.size() >= 2u);
        RC_ASSERT(end == scaleMax || (options.style == Style::alpha && palette[end] == palette.back()));
    }));
}

/// Rows of a footer's left half with ink, from the top.
std::vector<int> FindTextRows(const Image& image) {
    std::vector<int> rows;
    const Color strip = GetTheme(Theme::dark).strip;
    for (int y = image.height - GetFooterHeight(image.width); y < image.height; ++y) {
        bool hasInk = false;
        for (int x = 0; x < image.width / 3; ++x) hasInk = hasInk || !(image.At(x, y) == strip);
        if (hasInk) rows.push_back(y);
    }
    return rows;
}

TEST(Labels, AllPanesHaveLettersOfOneSize) {
    const Snapshot first = MakeSampleSnapshot(8, 4, "scree"), second = MakeSampleSnapshot(8, 4, "box2d");
    const std::string note(90, 'n');  // fits the strip at no scale but the smallest
    const PaneInput inputs[]{{&first, "n"}, {&second, note}};
    PictureOptions options;
    options.width = 1600;
    options.height = 900;
    PictureMaker maker(Backend::cpu);
    const OverlapResult result = maker.MakeOverlap(inputs, options);
    const PaneInput alone[]{{&first, "n"}};
    const std::vector<int> rows = FindTextRows(result.panes[0].image);
    EXPECT_NE(rows, FindTextRows(maker.MakeOverlap(alone, options).panes[0].image)) << "the note is too long";
    ASSERT_GE(rows.size(), 16u);
    EXPECT_EQ(rows.front(), FindTextRows(result.panes[1].image).front());
}

}  // namespace
}  // namespace testbed
