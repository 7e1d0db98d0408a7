// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Numbers survive being written and read, whatever is no number says why, and parts join to what was split.

#include "testbed/base/text.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace testbed {
namespace {

TEST(Text, WholeNumbersReadBack) {
    EXPECT_TRUE(rc::check("int", [](int value) {
        const Parsed<int> parsed = ParseNumber<int>(std::to_string(value));
        RC_ASSERT(static_cast<bool>(parsed));
        RC_ASSERT(*parsed == value);
    }));
}

TEST(Text, RealNumbersReadBack) {
    EXPECT_TRUE(rc::check("double", [](uint64_t bits) {
        const double value = std::bit_cast<double>(bits);
        const Parsed<double> parsed = ParseNumber<double>(fmt::format("{}", value));
        RC_ASSERT(static_cast<bool>(parsed) == std::isfinite(value));
        if (parsed) RC_ASSERT(*parsed == value);
    }));
}

TEST(Text, HashesReadBack) {
    EXPECT_TRUE(rc::check("hash", [](uint64_t hash) {
        RC_ASSERT(FormatHash(hash).size() == 16u);
        RC_ASSERT(*ParseHash(FormatHash(hash)) == hash);
    }));
    EXPECT_EQ(ParseHash("12g").problem, "'12g' is not a hash in hexadecimal digits");
}

TEST(Text, WhatIsNoNumberSaysWhy) {
    for (const auto& [text, problem] : std::vector<std::pair<std::string, std::string>>{
             {"", "a whole number is missing"},
             {"x", "'x' is not a whole number"},
             {"12x", "'12x' is not a whole number"},
             {"1.5", "'1.5' is not a whole number"},
             {" 1", "' 1' is not a whole number"},
             {"+1", "'+1' is not a whole number"},
             {"99999999999", "'99999999999' is beyond the numbers that can be held"}}) {
        EXPECT_EQ(ParseNumber<int>(text).problem, problem);
    }
    EXPECT_EQ(ParseNumber<double>("").problem, "a number is missing");
    EXPECT_EQ(ParseNumber<float>("1e99").problem, "'1e99' is beyond the numbers that can be held");
    EXPECT_EQ(ParseNumber<double>("inf").problem, "'inf' is not finite");
    EXPECT_EQ(ParseNumber<double>("nan").problem, "'nan' is not finite");
    EXPECT_EQ(BeforeCure(ParseNumber<int>("x").problem), "'x' is not a whole number; ");
    EXPECT_EQ(BeforeCure(ParseNumber<int>("1").problem), "");
}

TEST(Text, PartsJoinToWhatWasSplit) {
    EXPECT_TRUE(rc::check("split", [] {
        const auto text = *rc::gen::container<std::string>(rc::gen::elementOf(std::string("ab,\n")));
        std::string joined;
        for (const std::string_view part : Split(text, ',')) {
            RC_ASSERT(part.find(',') == std::string_view::npos);
            joined += std::string(part) + ",";
        }
        RC_ASSERT(joined == text + ",");
    }));
}

TEST(Text, LinesKeepTheirNumbers) {
    std::vector<std::pair<std::size_t, std::string>> lines;
    ForEachLine("one\n\nthree\n", [&](std::size_t number, std::string_view line) { lines.emplace_back(number, line); });
    EXPECT_EQ(lines, (std::vector<std::pair<std::size_t, std::string>>{{1, "one"}, {3, "three"}}));
    ForEachLine("", [](std::size_t, std::string_view) { ADD_FAILURE() << "no line in nothing"; });
}

}  // namespace
}  // namespace testbed
