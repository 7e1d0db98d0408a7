// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The table at the end of a run says the same on the screen and in a page; ratios are the baseline's figures by the
// others'.

#include "testbed/jobs/overlap/summary.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "testbed/page/markdown.h"

namespace testbed {
namespace {

/// Panes with random times, and a row for each at one step.
RunSummary MakeRandomSummary(uint32_t seed, int panes) {
    std::mt19937 random(seed);
    const auto any = [&] { return std::uniform_real_distribution<double>(0.5, 50.0)(random); };
    RunSummary summary{"tiles", 20, {}, {}, static_cast<std::size_t>(panes) - 1};
    for (int pane = 0; pane < panes; ++pane) {
        TimingSeries series;
        series.pane = fmt::format("pane-{}", pane);
        for (int step = 1; step <= 7; ++step) {
            StepRecord one;
            one.step = step;
            one.times.broadPhase = any();
            series.steps.push_back(one);
        }
        summary.timing.push_back(series);
        MetricsRow row;
        row.pane = series.pane;
        row.step = 5;
        row.siblingOverlap = any();
        row.areaRatio = any();
        row.overlapMean = any();
        row.overlapMax = 1 + random() % 90;
        summary.rows.push_back(row);
    }
    return summary;
}

std::string MakeText(const RunSummary& summary) {
    return MakeMarkdown(MakeSummaryPage({MakeSummarySection(summary, {})}, "scree overlap tiles"));
}

TEST(Summary, APageHasTheFiguresOfTheScreen) {
    for (uint32_t seed = 0; seed < 20; ++seed) {
        const RunSummary summary = MakeRandomSummary(seed, 2);
        const std::string screen = FormatSummary(summary), page = MakeText(summary);
        const MetricsRow &ours = summary.rows[0], &theirs = summary.rows[1];
        const std::string cells[] = {fmt::format("{:.3f}", ours.siblingOverlap),
                                     fmt::format("{:.3f}", theirs.siblingOverlap),
                                     fmt::format("{:.2f}", theirs.siblingOverlap / ours.siblingOverlap)};
        EXPECT_NE(page.find(fmt::format("| sibling overlap, step 5 | {} |", fmt::join(cells, " | "))),
                  std::string::npos)
            << page;
        for (const std::string& cell : cells) EXPECT_NE(screen.find(cell), std::string::npos) << screen;
        EXPECT_NE(page.find("| quantity | pane-0 | pane-1 | pane-1 / pane-0 |"), std::string::npos) << page;
        EXPECT_TRUE(IsUnedited(page));
    }
}

TEST(Summary, ManyPanesHaveNoRatiosOnThePage) {
    const RunSummary summary = MakeRandomSummary(1, 5);
    EXPECT_EQ(MakeText(summary).find("pane-4 / "), std::string::npos);
    EXPECT_NE(FormatSummary(summary).find("pane-4/pane-0"), std::string::npos);
}

TEST(Summary, NothingThatRanIsNoTable) {
    EXPECT_EQ(FormatSummary({}), "");
    EXPECT_NE(MakeText({}).find("| quantity |"), std::string::npos);
}

}  // namespace
}  // namespace testbed
