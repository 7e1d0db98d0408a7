// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Statistics over steps, checked against their definitions; the plot's program; whole files.

#include "testbed/engines/timing.h"
#include "testbed/base/errors.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "testbed/base/output.h"
#include "testbed/base/progress.h"
#include "testbed/jobs/overlap/timing_plot.h"
#include "testbed/picture/png.h"
#include "tests/testbed/program.h"

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

TEST(TimingPlot, DrawsAPictureAndLeavesNothingElse) {
    const ScratchFolder folder;
    const std::vector<TimingSeries> series = {MakeSeries({1, 5, 2}), {"box2d", "box2d", MakeSeries({9, 8, 7}).steps}};
    DrawTimingPlot(series, "it's a 'title' with $signs", folder.GetPath() / "a plot's.png");
    const Image picture = ReadPng(folder.GetPath() / "a plot's.png");
    EXPECT_EQ(picture.width, 1100);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.GetPath()), {}), 1);
    const auto count = [&](int r, int g, int b) {
        return std::count_if(picture.pixels.begin(), picture.pixels.end(),
                             [=](const Color& c) { return c.r == r && c.g == g && c.b == b; });
    };
    EXPECT_GT(count(0, 0, 0xcc), 50) << "three circles in Box2D's blue";
    EXPECT_GT(count(0xcc, 0, 0), 50) << "three squares in our red";
}

TEST(TimingPlot, NamesBox2dsRetestOnlyWhenBox2dIsThere) {
    const std::vector<TimingSeries> ours = {MakeSeries({1})}, theirs = {{"box2d", "box2d", MakeSeries({1}).steps}};
    EXPECT_EQ(MakeTimingScript(ours, "t", "p.png").find("Collide"), std::string::npos);
    EXPECT_NE(MakeTimingScript(theirs, "t", "p.png").find("Collide"), std::string::npos);
}

TEST(OutputFolder, ReplacesWholeFilesAndRemembersThem) {
    const ScratchFolder folder;
    OutputFolder output(folder.GetPath() / "new/deep");
    output.WriteText("a/b.txt", "first");
    output.WriteText("a/b.txt", "second");
    EXPECT_EQ(folder.Read("new/deep/a/b.txt"), "second");
    EXPECT_EQ(output.GetFiles().size(), 2u);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.GetPath() / "new/deep/a"), {}), 1);
}

TEST(OutputFolder, AFileInTheWayIsAFileError) {
    const ScratchFolder folder;
    std::ofstream(folder.GetPath() / "file") << "x";
    EXPECT_THROW(OutputFolder(folder.GetPath() / "file"), FileError);
    EXPECT_THROW(OutputFolder(folder.GetPath() / "file/below"), FileError);
    EXPECT_EQ(folder.Read("file"), "x");
}

TEST(Duration, HasHoursOnlyWhenNeeded) {
    EXPECT_EQ(FormatDuration(0), "0:00");
    EXPECT_EQ(FormatDuration(65.4), "1:05");
    EXPECT_EQ(FormatDuration(7265), "2:01:05");
    EXPECT_EQ(FormatDuration(-3), "0:00");
}

}  // namespace
}  // namespace testbed
