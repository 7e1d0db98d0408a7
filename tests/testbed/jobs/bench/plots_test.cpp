// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Which rows become which curves.

#include "testbed/jobs/bench/plots.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace testbed {
namespace {

BenchRow MakeRow(const char* scene, int movers, const char* engine, double nsPerBodyStep) {
    BenchRow row;
    row.scene = scene;
    row.size = row.movers = movers;
    row.engine = engine;
    row.solver = "si";
    row.threads = 1;
    row.nsPerBodyStep = nsPerBodyStep;
    return row;
}

TEST(CostPlot, HasACurveForEachSceneWithSizesFarApart) {
    const BenchRow rows[] = {MakeRow("tiles", 10000, "scree", 60),  MakeRow("tiles", 10000, "box2d", 900),
                             MakeRow("n2", 100, "scree", 5000),     MakeRow("n2", 750, "scree", 6000),
                             MakeRow("tiles", 100000, "scree", 90), MakeRow("tiles", 100000, "box2d", 1500)};
    const Plot plot = MakeCostPlot(rows);
    ASSERT_EQ(plot.curves.size(), 3u) << "n2's sizes lie less than a factor of ten apart";
    EXPECT_EQ(plot.curves[0].title, "tiles, Scree");
    EXPECT_EQ(plot.curves[1].title, "tiles, Box2D");
    ASSERT_EQ(plot.curves[0].points.size(), 2u);
    EXPECT_EQ(plot.curves[0].points[1].x, 100000.0);
    EXPECT_EQ(plot.curves[0].points[1].y, 90.0);
    EXPECT_TRUE(plot.logarithmic);
    EXPECT_FALSE(plot.note.empty()) << "Box2D's asserts";
    // The yardstick starts where the first curve does: log(1e5) / log(1e4) = 5/4.
    ASSERT_EQ(plot.curves[2].points.size(), 2u);
    EXPECT_NEAR(plot.curves[2].points[0].y, 60.0, 1e-9);
    EXPECT_NEAR(plot.curves[2].points[1].y, 75.0, 1e-9);
}

TEST(CostPlot, IsEmptyWithoutSuchSizes) {
    const BenchRow rows[] = {MakeRow("tiles", 10000, "scree", 60), MakeRow("tiles", 20000, "scree", 61)};
    EXPECT_TRUE(MakeCostPlot(rows).curves.empty());
    EXPECT_TRUE(MakeCostPlot({}).curves.empty());
}

TEST(TotalsPlot, MarksRunsThatWereStopped) {
    std::vector<BenchRow> rows;
    for (const int size : {100, 200}) {
        for (const char* engine : {"scree", "box2d"}) {
            rows.push_back(MakeRow("n2", size, engine, 0));
            rows.back().fixtures = size;
            rows.back().totalMs = engine[0] == 's' ? size : 10.5 * size;
        }
    }
    const std::string mark = "at least this";
    EXPECT_EQ(MakePlotScript(MakeTotalsPlot(rows), "svg", "p.svg").find(mark), std::string::npos);
    rows[3].complete = false;
    const std::string script = MakePlotScript(MakeTotalsPlot(rows), "svg", "p.svg");
    EXPECT_NE(script.find(mark), std::string::npos);
    EXPECT_NE(script.find("$least << END\n200 2100\nEND"), std::string::npos) << script;
    EXPECT_NE(script.find("100 1050\n200 2100\n"), std::string::npos) << "it stays on its curve\n" << script;
}

}  // namespace
}  // namespace testbed
