// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Laws of the command line's small parts: edit distance, step ranges, the recorded command.

#include "testbed/options/options.h"
#include "testbed/base/errors.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#include "testbed/base/nearest.h"

namespace testbed {
namespace {

TEST(EditDistance, KnownDistances) {
    EXPECT_EQ(EditDistance("", "abc"), 3);
    EXPECT_EQ(EditDistance("kitten", "sitting"), 3);
    EXPECT_EQ(EditDistance("siez", "size"), 1) << "neighbours swapped";
    EXPECT_EQ(EditDistance("Tiles", "tiles"), 0) << "case does not count";
}

TEST(EditDistance, IsSymmetricBoundedAndZeroOnlyForEqualWords) {
    const auto word = rc::gen::container<std::string>(rc::gen::inRange('a', static_cast<char>('d' + 1)));
    EXPECT_TRUE(rc::check("edit distance", [&] {
        const std::string a = *word, b = *word;
        const int distance = EditDistance(a, b);
        RC_ASSERT(distance == EditDistance(b, a));
        RC_ASSERT((distance == 0) == (a == b));
        RC_ASSERT(distance <= static_cast<int>(std::max(a.size(), b.size())));
        RC_ASSERT(distance >= std::abs(static_cast<int>(a.size()) - static_cast<int>(b.size())));
    }));
}

TEST(EditDistance, OneChangeCostsOne) {
    EXPECT_TRUE(rc::check("one deletion", [] {
        std::string a = *rc::gen::nonEmpty(rc::gen::container<std::string>(rc::gen::inRange('a', 'z')));
        const std::size_t place = *rc::gen::inRange<std::size_t>(0, a.size());
        std::string b = a;
        b.erase(place, 1);
        RC_ASSERT(EditDistance(a, b) == 1);
    }));
}

TEST(NearestName, FindsEveryKnownWordAfterOneTypingError) {
    constexpr std::array<std::string_view, 4> names = {"internal", "leaves", "brute-force", "sweep-and-prune"};
    for (const std::string_view name : names) {
        for (std::size_t i = 0; i < name.size(); ++i) {
            std::string typed(name);
            typed[i] = '#';
            EXPECT_EQ(NearestName(typed, names), name);
        }
    }
    EXPECT_EQ(NearestName("x", {}), "");
}

TEST(StepRange, ReadsBackWhatWasWritten) {
    EXPECT_TRUE(rc::check("A:B:S", [] {
        const int first = *rc::gen::inRange(1, 1000), more = *rc::gen::inRange(0, 1000),
                  stride = *rc::gen::inRange(1, 50);
        const StepRange range = ParseSteps(
            std::to_string(first) + ":" + std::to_string(first + more) + ":" + std::to_string(stride), false);
        int contained = 0;
        for (int step = 0; step <= first + more + stride; ++step) contained += range.Contains(step) ? 1 : 0;
        RC_ASSERT(contained == range.Count());
        RC_ASSERT(range.Contains(first));
        RC_ASSERT(!range.Contains(first - 1));
    }));
}

TEST(StepRange, ACountMeansTheFirstSteps) {
    const StepRange range = ParseSteps("12", true);
    EXPECT_EQ(range.first, 1);
    EXPECT_EQ(range.last, 12);
    EXPECT_EQ(range.Count(), 12);
    EXPECT_THROW((void)ParseSteps("12", false), UsageError);
    for (const char* wrong : {"", ":", "1:", ":2", "1:2:", "1.5", "-1:3", "1:2:-1", "99999999999"}) {
        EXPECT_THROW((void)ParseSteps(wrong, true), UsageError) << wrong;
    }
}

TEST(DescribeCommand, LeavesOutTheFolder) {
    EXPECT_EQ(DescribeCommand({"overlap", "tiles", "-o", "/home/x", "--size", "5"}), "scree overlap tiles --size 5");
    EXPECT_EQ(DescribeCommand({"overlap", "tiles", "--output", "/home/x"}), "scree overlap tiles");
    EXPECT_EQ(DescribeCommand({"overlap", "--output=/home/x", "tiles"}), "scree overlap tiles");
    EXPECT_EQ(DescribeCommand({"overlap", "-o/home/x", "tiles", "--opacity", "1"}), "scree overlap tiles --opacity 1");
}

}  // namespace
}  // namespace testbed
