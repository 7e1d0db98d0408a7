// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The plot of broad-phase times: its picture, and what it says of Box2D.

#include "testbed/jobs/overlap/timing_plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "testbed/picture/png.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

TimingSeries MakeSeries(const char* engine, const std::vector<int>& times) {
    TimingSeries series{engine, engine, {}};
    for (const int time : times) {
        StepRecord record;
        record.step = static_cast<int>(series.steps.size()) + 1;
        record.times.broadPhase = time;
        series.steps.push_back(record);
    }
    return series;
}

TEST(TimingPlot, DrawsAPictureAndLeavesNothingElse) {
    const ScratchFolder folder;
    const std::vector<TimingSeries> series = {MakeSeries("scree", {1, 5, 2}), MakeSeries("box2d", {9, 8, 7})};
    DrawPlot(MakeTimingPlot(series, "it's a 'title' with $signs"), "pngcairo", folder.GetPath() / "a plot's.png");
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

TEST(TimingPlot, TheFirstStepDoesNotFlattenTheRest) {
    const std::vector<TimingSeries> steep = {MakeSeries("scree", {15, 2, 1}), MakeSeries("box2d", {52, 23, 20})};
    const Plot plot = MakeTimingPlot(steep, "t");
    EXPECT_EQ(plot.most, 23);
    const std::string script = MakePlotScript(plot, "svg", "p.svg");
    EXPECT_NE(script.find("\"step 1: 52.0\""), std::string::npos) << script;
    EXPECT_EQ(script.find("step 1: 15"), std::string::npos) << "it is within the scale";
    const std::vector<TimingSeries> even = {MakeSeries("scree", {15, 2, 1}), MakeSeries("box2d", {20, 23, 20})};
    EXPECT_EQ(MakeTimingPlot(even, "t").most, 0);
    const ScratchFolder folder;
    DrawPlot(plot, "pngcairo", folder.GetPath() / "p.png");
    EXPECT_EQ(ReadPng(folder.GetPath() / "p.png").width, 1100);
}

TEST(TimingPlot, NamesBox2dsRetestOnlyWhenBox2dIsThere) {
    const std::vector<TimingSeries> ours = {MakeSeries("scree", {1})}, theirs = {MakeSeries("box2d", {1})};
    EXPECT_EQ(MakeTimingPlot(ours, "t").note, "");
    EXPECT_NE(MakeTimingPlot(theirs, "t").note.find("Collide"), std::string::npos);
}

}  // namespace
}  // namespace testbed
