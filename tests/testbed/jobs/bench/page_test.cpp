// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The numbers that head a bench page.

#include "testbed/jobs/bench/page.h"

#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "testbed/jobs/bench/row.h"

namespace testbed {
namespace {

BenchRow MakeRatio(const std::string& scene, const std::string& engine, const std::string& solver, double ratio) {
    BenchRow row;
    row.scene = scene;
    row.engine = engine;
    row.solver = solver;
    row.ratio = row.cpuRatio = ratio;
    return row;
}

TEST(BenchPage, HeadsEachEngineAndSolverByItsOwnMean) {
    std::vector<BenchRow> rows{MakeRatio("tiles", "scree", "si", 4.0),   MakeRatio("tiles", "scree", "soft", 3.0),
                               MakeRatio("tiles", "box2d", "si", 0.0),   MakeRatio("tiles", "box2d3", "soft", 0.5),
                               MakeRatio("tumbler", "scree", "si", 9.0), MakeRatio("tumbler", "scree", "soft", 0.75),
                               MakeRatio("tumbler", "box2d3", "soft", 8)};
    rows.back().voidReason = "touching contacts differ by 30 %";
    const Page page = MakeBenchPage({.command = "", .rows = rows, .targets = {}, .plots = {}, .notes = "", .made = {}});
    const auto& tiles = std::get<PageTiles>(page.sections.front().blocks.front()).tiles;
    ASSERT_EQ(tiles.size(), 3u);
    EXPECT_EQ(tiles[0].label, "scree si");
    EXPECT_EQ(tiles[0].value, "6.00");
    EXPECT_EQ(tiles[1].label, "scree soft");
    EXPECT_EQ(tiles[1].value, "1.50");
    EXPECT_NE(tiles[1].note.find("from 0.75 in tumbler to 3.00 in tiles; faster in 1 of 2"), std::string::npos);
    EXPECT_EQ(tiles[2].label, "box2d3 soft");
    EXPECT_EQ(tiles[2].value, "0.50") << "a void row does not count";
}

}  // namespace
}  // namespace testbed
