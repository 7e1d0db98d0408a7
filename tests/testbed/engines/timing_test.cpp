// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Statistics over steps, checked against their definitions; the table of all steps.

#include "testbed/engines/timing.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <string>
#include <vector>

namespace testbed {
namespace {

TimingSeries MakeSeries(const std::vector<int>& times) {
    TimingSeries series{"scree", "scree", {}};
    for (std::size_t i = 0; i < times.size(); ++i) {
        StepRecord record;
        record.step = static_cast<int>(i) + 1;
        record.times.broadPhase = times[i];
        record.contacts = times[i] / 2;
        series.steps.push_back(record);
    }
    return series;
}

TEST(TimingStats, FollowTheirDefinitions) {
    EXPECT_TRUE(rc::check("median, p99, max", [] {
        const auto times = *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 50)));
        const TimingSeries series = MakeSeries(times);
        const TimingStats stats = GetBroadPhaseStats(series);
        const auto countAtMost = [&](double limit) {
            return std::count_if(times.begin(), times.end(), [=](int time) { return time <= limit; });
        };
        const auto total = static_cast<long>(times.size());
        RC_ASSERT(stats.max == *std::max_element(times.begin(), times.end()));
        RC_ASSERT(times[static_cast<std::size_t>(stats.maxStep) - 1] == stats.max);
        RC_ASSERT(100 * countAtMost(stats.p99) >= 99 * total);
        RC_ASSERT(100 * countAtMost(stats.p99 - 0.5) < 99 * total);
        RC_ASSERT(2 * countAtMost(stats.median) >= total);
        RC_ASSERT(2 * (total - countAtMost(stats.median)) <= total);
        RC_ASSERT(GetPeakContacts(series) == static_cast<int>(stats.max) / 2);
    }));
}

TEST(TimingStats, SumNeedsAllItsSteps) {
    const TimingSeries series = MakeSeries({1, 2, 3, 4});
    EXPECT_EQ(SumBroadPhase(series, 2, 4), 9);
    EXPECT_LT(SumBroadPhase(series, 2, 5), 0);
    EXPECT_LT(SumBroadPhase(series, 70, 100), 0);
}

}  // namespace
}  // namespace testbed
