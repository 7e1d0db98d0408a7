// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Bodies, fixtures, joints and spawns of every scene against closed formulas, at every size of its sweep, at small
// sizes and above the sweep. The formulas are sums of the published loops worked out by hand, not the builders' code.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "scenes/catalog.h"

namespace {

using scenes::SceneCounts;

struct Totals {
    int staticBodies, dynamicBodies, staticFixtures, movingFixtures;
    int joints = 0, spawns = 0, kinematicBodies = 0;
};

SceneCounts Expect(const Totals& t) {
    return {.staticBodies = t.staticBodies,
            .kinematicBodies = t.kinematicBodies,
            .dynamicBodies = t.dynamicBodies,
            .staticFixtures = t.staticFixtures,
            .movingFixtures = t.movingFixtures,
            .joints = t.joints,
            .spawns = t.spawns};
}

// Σ over i = 0 … 14 of max(0, n − i).
int ColumnBodies(int n) { return n < 15 ? n * (n + 1) / 2 : 15 * n - 105; }

Totals Falling(int n) {
    const int blocks = n <= 300 ? 1 : n / 300 + (n % 300 != 0 ? 1 : 0);
    const int falling = n <= 300 ? ColumnBodies(n) : blocks * ColumnBodies(300);
    return {blocks, falling, blocks, falling};
}

// Three boxes a slice; tables come in pairs of 50, 49, … 1 slices, and after a hundred tables again.
int TableFixtures(int n) {
    const int whole = n / 100;
    const int rest = n % 100;
    const int pairs = rest / 2;
    const int slices = 2 * (50 * pairs - pairs * (pairs - 1) / 2) + (rest % 2 == 1 ? 50 - pairs : 0);
    return 3 * (whole * 2550 + slices);
}

// n² cells less those at most 3 off the diagonal: n + 2(n−1) + 2(n−2) + 2(n−3) of them once n ≥ 3.
int GridBoxes(int n) { return n < 4 ? 0 : n * n - 7 * n + 12; }

// Teeth and disk of each wheel, the rack and its teeth.
int GearFixtures(int n) { return (n + 1) / 2 * (1 + 8) + n / 2 * (1 + 16) + 1 + 9; }

Totals JointSceneTotalsOf(std::string_view name) {
    if (name == "joint-distance") return {1, 5, 1, 5, 5};
    if (name == "joint-friction") return {1, 6, 1, 6, 6};
    if (name == "joint-gear") return {1, 6, 1, 6, 5 + 1 + 3};
    if (name == "joint-motor") return {1 + 4, 5, 1, 5, 5};
    if (name == "joint-mouse") return {1, 3 + 4, 1, 3 + 4, 4};
    if (name == "joint-prismatic") return {1, 4, 1, 4, 4};
    if (name == "joint-pulley") return {1, 6, 1, 6, 3};
    if (name == "joint-revolute") return {1, 6, 1, 6, 5};
    if (name == "joint-weld") return {1, 2 + 4, 2, 2 + 4, 2 + 3};
    if (name == "joint-wheel") return {1, 4 * 3, 1, 4 * 3, 4 * 2};
    ADD_FAILURE() << "no closed formula for " << name;
    return {};
}

Totals ClassicTotalsOf(std::string_view name, int n) {
    if (name == "pyramid") return {1, n * (n + 1) / 2, 1, n * (n + 1) / 2};
    if (name == "box-stack") return {1, 5 * n, 1, 5 * n};
    if (name == "convex-shapes") return {1, 6 * n, 3, 6 * n};
    if (name == "domino-row") return {1, n + 1, 1, n + 1};
    if (name == "bridge") return {1, n + 5, 3, n + 5, n + 1};
    if (name == "chain-heavy-end") return {1, n + 1, 1, n + 1, n + 1};
    if (name == "cantilever") return {1, 3 * (n + 1), 2, 3 * (n + 1), 3 * (n + 1)};
    // Two chains and two walls; seesaw, twelve planks, five boxes, chassis, two wheels.
    if (name == "car") return {1, 1 + 12 + 5 + 3, 4, 1 + 12 + 5 + 3, 1 + 13 + 2};
    if (name == "ragdolls") return {1, 10 * n, 3 + 10, 10 * n, 9 * n};
    if (name == "conveyor") return {1, 9, 6, 9};
    if (name == "pulley") return {1, 2, 3, 2, 1};
    if (name == "gears") return {1, n + 1, 1, GearFixtures(n), n + 1 + n};
    if (name == "slider-crank") return {1, 4, 3, 4, 4};
    if (name == "web") return {1, 12 * n + 1 + 3, 12, 12 * n + 1 + 3, 12 * (n + 1) + 12 * n};
    if (name == "character-corner-cases") {
        return {.staticBodies = 1,
                .dynamicBodies = 4 * 4 + 2,
                .staticFixtures = 40 + 1 + 40 + 1 + 4 * 2,
                .movingFixtures = 4 * (1 + 3 + 1 + 1) + 2 * 3 + 2,
                .kinematicBodies = 2};
    }
    if (name == "sensors") {
        return {.staticBodies = 1,
                .dynamicBodies = n + 1,
                .staticFixtures = 3 + 4,
                .movingFixtures = n + 2 + 1,
                .kinematicBodies = 1};
    }
    if (name == "ray-cast-playground") {
        return {.staticBodies = 1,
                .dynamicBodies = n,
                .staticFixtures = 7,
                .movingFixtures = n + 2 * 2,
                .kinematicBodies = 2};
    }
    if (name == "restitution-row") return {1, n, 1, n};
    if (name == "friction-row") return {1, n, n + 1, n};
    // A chain, five blocks a figure; a sensor and a crate every 6 of 10 m a figure.
    if (name == "platformer") {
        const int places = 10 * n / 6;
        return {1 + 5 * n + places, places + n, 1 + 5 * n + places, places + 2 * n};
    }
    if (name == "cars") return {1, 3 * n, 1, 3 * n, 2 * n};
    if (name == "bin") return {1, n, 3, n};
    if (name == "bullets") return {1, 300 + n, 1, 300 + n};
    return JointSceneTotalsOf(name);
}

Totals TotalsOf(std::string_view name, int n) {
    if (name == "falling-squares" || name == "falling-circles") return Falling(n);
    if (name == "tumbler") return {1, n + 1, 0, n + 4, 1, n};
    if (name == "add-pair") return {0, n + 1, 0, n + 1};
    if (name == "add-pair-400") return {0, 401, 0, 401};
    if (name == "mild-n2") return {1, 2 * n, 1, 5 * n};
    if (name == "n2") return {0, n, 0, n};
    if (name == "multi-fixture") return {1, n, 3, TableFixtures(n)};
    if (name == "mostly-static-single") return {1, n, GridBoxes(n), n};
    if (name == "mostly-static-multi") return {GridBoxes(n), n, GridBoxes(n), n};
    if (name == "diagonal") return {n / 2 * n, 3000, n / 2 * n, 3000};
    if (name == "mixed") return {1, n, 8427, n};
    if (name == "slow-explosion") return {0, n, 0, n};
    if (name == "tiles") return {1, n * (n + 1) / 2, 2000, n * (n + 1) / 2};
    if (name == "big-mobile") {
        int nodes = 1;  // 1 + 2 + 4 + … + 2^n
        for (int depth = 0; depth < n; ++depth) nodes = 2 * nodes + 1;
        return {1, nodes, 0, nodes + (nodes - 1) / 2, nodes, 0};
    }
    return ClassicTotalsOf(name, n);
}

std::set<int> SizesToTest(const scenes::SceneInfo& info) {
    std::set<int> sizes = {info.minSize, info.defaultSize};
    for (int size = info.minSize; size <= std::min(info.maxSize, info.minSize + 20); ++size) sizes.insert(size);
    if (info.sweep) {
        const auto [begin, end, increment] = *info.sweep;
        for (int size = begin; size <= end; size += increment) sizes.insert(size);
        for (int size : {end + 1, end + 2, 2 * end - 1, 2 * end, 3 * end + 7}) {
            if (size <= info.maxSize) sizes.insert(size);
        }
        // The mobile grows as 2^size, so twice its sweep is no legal size.
        sizes.insert(std::min(info.maxSize, end + 3));
    }
    return sizes;
}

TEST(Counts, FollowTheClosedFormulas) {
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        for (int size : SizesToTest(info)) {
            EXPECT_EQ(scenes::Count(scenes::Build(info.name, size)), Expect(TotalsOf(info.name, size)))
                << info.name << " at size " << size;
        }
    }
}

TEST(Counts, PublishedFigures) {
    const SceneCounts tiles = scenes::Count(scenes::Build("tiles", 200));
    EXPECT_EQ(tiles.Fixtures(), 22100);
    EXPECT_EQ(tiles.staticFixtures, 2000);
    EXPECT_EQ(tiles.movingFixtures, 20100);
    EXPECT_EQ(scenes::Count(scenes::Build("falling-squares")).dynamicBodies, 4395);
    EXPECT_EQ(scenes::Count(scenes::Build("big-mobile")).movingFixtures, 6142);
    EXPECT_EQ(scenes::Count(scenes::Build("mostly-static-multi")).staticBodies, 38612);
}

// README's table of scenes: | name | exercises | size: default, sweep, legal | steps | bodies | fixtures | joints |
TEST(Counts, ReadmeTableIsTrue) {
    const auto root = std::filesystem::path(SCREE_SOURCE_DIR);
    std::ifstream readme(root / "scenes" / "README.md");
    ASSERT_TRUE(readme) << "scenes/README.md";
    std::set<std::string> rows;
    for (std::string line; std::getline(readme, line);) {
        if (line.starts_with("| `") && std::ranges::count(line, '|') == 10) rows.insert(line);
    }
    EXPECT_EQ(rows.size(), scenes::Catalog().size());
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        const SceneCounts c = scenes::Count(scenes::Build(info.name));
        std::ostringstream row;
        row << "| `" << info.name << "` | " << info.exercises << " | ";
        if (info.hasSize) {
            row << info.defaultSize << " | ";
            if (info.sweep) {
                row << info.sweep->begin << ":" << info.sweep->end << ":" << info.sweep->increment;
            } else {
                row << "–";
            }
            row << " | " << info.minSize << "…" << info.maxSize;
        } else {
            row << info.defaultSize << " | – | –";
        }
        row << " | " << info.steps << ", " << info.showStep << " | " << c.staticBodies << " + "
            << c.kinematicBodies + c.dynamicBodies << " | " << c.staticFixtures << " + " << c.movingFixtures << " | "
            << c.joints << " |";
        EXPECT_TRUE(rows.contains(row.str())) << "scenes/README.md should have the row\n" << row.str();
    }
}

}  // namespace
