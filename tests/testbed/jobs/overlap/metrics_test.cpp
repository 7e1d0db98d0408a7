// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Rows of metrics: the columns of both files, values that survive the way through a file, and what a row takes from a
// snapshot.

#include "testbed/jobs/overlap/metrics.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "testbed/base/output.h"
#include "testbed/view/picture.h"

using namespace testbed;

namespace {

const std::vector<std::string> columns = {"engine",
                                          "broad_phase",
                                          "threads",
                                          "step",
                                          "bodies",
                                          "proxies",
                                          "nodes",
                                          "height",
                                          "max_balance",
                                          "area_ratio",
                                          "sah_cost",
                                          "sibling_overlap",
                                          "epo",
                                          "overlap_max",
                                          "overlap_mean",
                                          "overlap_p99",
                                          "pairs_reported",
                                          "pairs_true",
                                          "false_pair_ratio",
                                          "contacts",
                                          "touching",
                                          "broad_phase_ms",
                                          "narrow_phase_ms",
                                          "solver_ms",
                                          "step_ms",
                                          "memory_bytes",
                                          "state_hash",
                                          "pane",
                                          "settings"};

std::vector<std::string> Split(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    return cells;
}

MetricsRow MakeRow() {
    MetricsRow row;
    row.engine = "scree";
    row.broadPhase = "keys";
    row.step = 90;
    row.areaRatio = 0.1 + 0.2;  // not a short decimal
    row.overlapMax = 400;
    row.pairsReported = int64_t{1} << 40;
    row.stateHash = 0xFEDCBA9876543210u;  // beyond what a JSON number holds exactly
    row.pane = "ours";
    row.settings = "solver=soft@8";
    return row;
}

/// Two unit boxes of two dynamic bodies that share a border, in a tree of fattened leaves, and a third far away.
Snapshot MakeSnapshot() {
    Snapshot s;
    s.engine = "box2d";
    s.broadPhase = "b2DynamicTree";
    s.step = 7;
    const Box boxes[3] = {{{0, 0}, {1, 1}}, {{1, 0}, {2, 1}}, {{2.05f, 0}, {3, 1}}};
    for (int i = 0; i < 3; ++i) {
        BodyState body{};
        body.index = i;
        body.type = scenes::BodyType::dynamic;
        s.bodies.push_back(body);
        FixtureState fixture{};
        fixture.body = fixture.fixture = i;
        fixture.tight = boxes[i];
        s.fixtures.push_back(fixture);
    }
    s.nodes = {{{{-0.1f, -0.1f}, {3.1f, 1.1f}}, -1, 1, 2, -1, 0},
               {{{-0.1f, -0.1f}, {2.1f, 1.1f}}, 0, 3, 4, -1, 1},
               {{{1.95f, -0.1f}, {3.1f, 1.1f}}, 0, -1, -1, 2, 1},
               {{{-0.1f, -0.1f}, {1.1f, 1.1f}}, 1, -1, -1, 0, 2},
               {{{0.9f, -0.1f}, {2.1f, 1.1f}}, 1, -1, -1, 1, 2}};
    s.pairsReported = 2;
    s.contactCount = 2;
    s.touchingCount = 1;
    s.times = {.broadPhase = 1, .narrowPhase = 2, .solver = 3, .step = 7};
    s.memoryBytes = 1234;
    s.stateHash = 42;
    return s;
}

}  // namespace

TEST(Metrics, CsvHasTheColumnsAndOneLinePerRow) {
    const std::vector<MetricsRow> rows{MakeRow(), MakeRow()};
    std::istringstream text(WriteMetricsCsv(rows));
    std::string line;
    ASSERT_TRUE(std::getline(text, line));
    EXPECT_EQ(Split(line), columns);
    int lines = 0;
    while (std::getline(text, line)) {
        ++lines;
        const std::vector<std::string> cells = Split(line);
        ASSERT_EQ(cells.size(), columns.size());
        EXPECT_EQ(cells[0], "scree");
        EXPECT_EQ(cells[3], "90");
        EXPECT_EQ(std::stod(cells[9]), rows[0].areaRatio) << "must read back to the same bits";
        EXPECT_EQ(cells[16], "1099511627776");
        EXPECT_EQ(cells[26], "fedcba9876543210");
        EXPECT_EQ(cells[27], "ours");
        EXPECT_EQ(cells[28], "solver=soft@8");
    }
    EXPECT_EQ(lines, 2);
}

TEST(Metrics, JsonHasTheHeaderAndTheSameColumnsInOrder) {
    const std::vector<MetricsRow> rows{MakeRow()};
    const auto document = nlohmann::ordered_json::parse(
        WriteMetricsJson({.scene = "tiles", .size = 200, .command = "scree metrics tiles \"x\""}, rows));
    EXPECT_EQ(document["schema"], 1);
    EXPECT_EQ(document["scene"], "tiles");
    EXPECT_EQ(document["size"], 200);
    EXPECT_EQ(document["command"], "scree metrics tiles \"x\"");
    ASSERT_EQ(document["rows"].size(), 1u);
    std::vector<std::string> names;
    for (const auto& [name, value] : document["rows"][0].items()) names.push_back(name);
    EXPECT_EQ(names, columns);
    EXPECT_EQ(document["rows"][0]["area_ratio"].get<double>(), rows[0].areaRatio);
    EXPECT_EQ(document["rows"][0]["overlap_max"], 400);
    EXPECT_EQ(document["rows"][0]["state_hash"], "fedcba9876543210");
}

TEST(Metrics, ARowTakesItsFiguresFromTheSnapshot) {
    OverlapStats overlap;
    overlap.max = 5;
    overlap.mean = 1.5;
    overlap.p99 = 4;
    const MetricsRow row = MeasureSnapshot(MakeSnapshot(), overlap);
    EXPECT_EQ(row.engine, "box2d");
    EXPECT_EQ(row.step, 7);
    EXPECT_EQ(row.bodies, 3);
    EXPECT_EQ(row.proxies, 3);
    EXPECT_EQ(row.nodes, 5);
    EXPECT_EQ(row.height, 2);
    EXPECT_EQ(row.maxBalance, 1);
    EXPECT_EQ(row.overlapMax, 5u);
    EXPECT_EQ(row.overlapMean, 1.5);
    EXPECT_EQ(row.overlapP99, 4u);
    // Boxes 0 and 1 share a border; 1 and 2 overlap only when fattened.
    EXPECT_EQ(row.pairsReported, 2);
    EXPECT_EQ(row.pairsTrue, 1);
    EXPECT_EQ(row.falsePairRatio, 0.5);
    EXPECT_EQ(row.contacts, 2);
    EXPECT_EQ(row.touching, 1);
    EXPECT_EQ(row.broadPhaseMs, 1);
    EXPECT_EQ(row.narrowPhaseMs, 2);
    EXPECT_EQ(row.solverMs, 3);
    EXPECT_EQ(row.stepMs, 7);
    EXPECT_EQ(row.memoryBytes, 1234);
    EXPECT_EQ(row.stateHash, 42u);
}

TEST(Metrics, AlgorithmsWithoutATreeHaveNoTreeFigures) {
    Snapshot s = MakeSnapshot();
    s.nodes.clear();
    s.pairsReported = 0;
    const MetricsRow row = MeasureSnapshot(s, {});
    EXPECT_EQ(row.nodes, 0);
    EXPECT_EQ(row.areaRatio, 0.0);
    EXPECT_EQ(row.falsePairRatio, 0.0);
    EXPECT_EQ(row.pairsTrue, 1);
}

TEST(Metrics, BothFilesAreWrittenWhole) {
    const auto root = std::filesystem::temp_directory_path() / ("scree-metrics-test-" + std::to_string(getpid()));
    std::filesystem::remove_all(root);
    OutputFolder output(root);
    const std::vector<MetricsRow> rows{MakeRow()};
    const MetricsHeader header{.scene = "tiles", .size = 20, .command = "test"};
    SaveMetrics(output, "tiles", header, rows);
    SaveMetrics(output, "tiles", header, rows);  // replaces
    const auto read = [&](const char* name) {
        std::ifstream file(root / "tiles" / name);
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    EXPECT_EQ(read("metrics.csv"), WriteMetricsCsv(rows));
    EXPECT_EQ(read("metrics.json"), WriteMetricsJson(header, rows));
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(root / "tiles")) files += entry.is_regular_file();
    EXPECT_EQ(files, 2) << "a temporary file was left behind";
    std::filesystem::remove_all(root);
}
