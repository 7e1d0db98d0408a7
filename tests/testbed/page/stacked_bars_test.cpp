// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Bars are as long as their parts say, and no text leaves the picture or meets another one.

#include "testbed/page/stacked_bars.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <map>
#include <numeric>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "testbed/picture/font.h"

namespace testbed {
namespace {

/// The numbers of all elements that match, as groups 1 and on.
std::vector<std::vector<std::string>> FindAll(const std::string& svg, const std::string& pattern) {
    std::vector<std::vector<std::string>> found;
    const std::regex regex(pattern);
    for (std::sregex_iterator it(svg.begin(), svg.end(), regex), end; it != end; ++it) {
        std::vector<std::string> groups;
        for (std::size_t i = 1; i < it->size(); ++i) groups.push_back((*it)[i]);
        found.push_back(groups);
    }
    return found;
}

StackedBars MakeRandomBars() {
    StackedBars bars{.unit = "ms", .parts = {"broad phase", "solver", "rest"}, .bars = {}};
    const int count = *rc::gen::inRange(1, 8);
    const double scale = std::pow(10.0, *rc::gen::inRange(-3, 6));
    for (int i = 0; i < count; ++i) {
        StackedBar bar{.label = std::string(static_cast<std::size_t>(*rc::gen::inRange(1, 40)), 'm'), .parts = {}};
        for (int k = 0; k < 3; ++k) bar.parts.push_back(*rc::gen::inRange(0, 1000) * scale);
        bars.bars.push_back(bar);
    }
    bars.bars.front().parts[0] += scale;
    return bars;
}

TEST(StackedBars, PartsAreAsLongAsTheySay) {
    EXPECT_TRUE(rc::check("lengths", [] {
        const StackedBars bars = MakeRandomBars();
        const auto rects = FindAll(DrawStackedBars(bars),
                                   R"re(<rect x="([\d.]+)" y="(\d+)" width="([\d.]+)" height="16" fill="([^"]+)"/>)re");
        RC_ASSERT(rects.size() == bars.bars.size() * 3);
        double longest = 0, sum = 0;
        for (const StackedBar& bar : bars.bars) {
            const double length = std::accumulate(bar.parts.begin(), bar.parts.end(), 0.0);
            if (length > longest) longest = length;
        }
        for (std::size_t i = 0; i < rects.size(); ++i) {
            const StackedBar& bar = bars.bars[i / 3];
            if (i % 3 == 0) sum = 0;
            const double x = std::stod(rects[i][0]) - std::stod(rects[i - i % 3][0]);
            RC_ASSERT(std::abs(x - sum / longest * 460) < 0.02);
            RC_ASSERT(std::abs(std::stod(rects[i][2]) - bar.parts[i % 3] / longest * 460) < 0.02);
            sum += bar.parts[i % 3];
        }
    }));
}

TEST(StackedBars, TextsStayInsideAndApart) {
    EXPECT_TRUE(rc::check("texts", [] {
        const std::string svg = DrawStackedBars(MakeRandomBars());
        const auto size = FindAll(svg, R"re(viewBox="0 0 (\d+) (\d+)")re").at(0);
        std::map<std::string, std::vector<std::pair<double, double>>> rows;
        for (const auto& text : FindAll(svg, R"re(<text x="([\d.]+)" y="([\d.]+)" text-anchor="(\w+)">([^<]*)<)re")) {
            const double width = GetTextWidth(text[3], 1) * 12.0 / 11;
            const double x = std::stod(text[0]);
            const double begin = text[2] == "start" ? x : text[2] == "end" ? x - width : x - width / 2;
            RC_ASSERT(begin >= -0.5 && begin + width <= std::stod(size[0]) + 0.5);
            RC_ASSERT(std::stod(text[1]) <= std::stod(size[1]));
            for (const auto& [from, to] : rows[text[1]]) RC_ASSERT(begin >= to || begin + width <= from);
            rows[text[1]].emplace_back(begin, begin + width);
        }
        RC_ASSERT(rows.size() >= 3u);
    }));
}

}  // namespace
}  // namespace testbed
