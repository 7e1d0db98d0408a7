// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The statistics of `scree bench` follow their definitions, ratios are void exactly where the work differs, and rows
// survive CSV and JSON.

#include "testbed/jobs/bench/row.h"
#include "testbed/base/errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

namespace testbed {
namespace {

StepRecord MakeStep(int step, double ms) {
    StepRecord record;
    record.step = step;
    record.times = {.broadPhase = 0.25 * ms,
                    .narrowPhase = 0.125 * ms,
                    .solver = 0.5 * ms,
                    .islands = 0.125 * ms,
                    .continuous = 0.0625 * ms,
                    .step = ms,
                    .cpu = 2 * ms};
    return record;
}

BenchRun MakeRun(const std::vector<double>& times) {
    BenchRun run;
    for (const double ms : times) run.steps.push_back(MakeStep(static_cast<int>(run.steps.size()) + 1, ms));
    return run;
}

BenchRow MakeRow(const std::string& engine, double totalMs) {
    BenchRow row;
    row.scene = "tiles";
    row.size = 200;
    row.engine = engine;
    row.solver = "si";
    row.steps = 100;
    row.totalMs = totalMs;
    row.cpuMs = 2 * totalMs;
    row.awakeBodySteps = 10000;
    row.touchingSum = 1000;
    return row;
}

TEST(BenchStatistics, TimesAreSumsAndPlacesOfTheSteps) {
    BenchRow row;
    row.awakeBodySteps = 4;
    SetTimes(row, MakeRun({8, 1, 16, 2}));
    EXPECT_EQ(row.steps, 4);
    EXPECT_EQ(row.totalMs, 27.0);
    EXPECT_EQ(row.cpuMs, 54.0);
    EXPECT_EQ(row.medianMs, 2.0) << "the lower of the two in the middle";
    EXPECT_EQ(row.p99Ms, 16.0);
    EXPECT_EQ(row.maxMs, 16.0);
    EXPECT_EQ(row.maxStep, 3);
    EXPECT_EQ(row.stages.broadPhase, 27 * 0.25);
    EXPECT_EQ(row.stages.narrowPhase, 27 * 0.125);
    EXPECT_EQ(row.stages.islands, 27 * 0.125);
    EXPECT_EQ(row.stages.solver, 27 * 0.375) << "without the islands";
    EXPECT_EQ(row.stages.continuous, 27 * 0.0625);
    EXPECT_EQ(row.nsPerBodyStep, 27e6 / 4);
}

TEST(BenchStatistics, OfRepeatsEachStepsMedianStands) {
    std::vector<BenchRun> runs = {MakeRun({1, 20, 3, 4}), MakeRun({10, 2, 30}), MakeRun({5, 6, 7, 8})};
    runs[0].createMs = 9;
    runs[1].createMs = 1;
    runs[2].createMs = 2;
    runs[1].complete = false;
    const BenchRun merged = MergeRepeats(runs);
    ASSERT_EQ(merged.steps.size(), 3u) << "the shortest";
    EXPECT_EQ(merged.steps[0].times.step, 5.0);
    EXPECT_EQ(merged.steps[1].times.step, 6.0);
    EXPECT_EQ(merged.steps[2].times.step, 7.0);
    EXPECT_EQ(merged.steps[1].times.broadPhase, 1.5) << "with its stages";
    EXPECT_EQ(merged.createMs, 2.0);
    EXPECT_FALSE(merged.complete);
    const BenchRun pair[] = {MakeRun({4}), MakeRun({3})};
    EXPECT_EQ(MergeRepeats(pair).steps[0].times.step, 3.0) << "the lower of two";
}

TEST(BenchComparison, RatiosAreBox2dsTimeOverOurs) {
    std::vector<BenchRow> rows = {MakeRow("scree", 10), MakeRow("box2d", 55), MakeRow("scree", 5)};
    rows[2].size = 100;  // no Box2D run of that size
    rows[0].cpuMs = 11;
    CompareWithBaseline(rows, std::vector<std::vector<WorkCounts>>(3));
    EXPECT_EQ(rows[0].ratio, 5.5);
    EXPECT_EQ(rows[0].cpuRatio, 10.0);
    EXPECT_EQ(rows[1].ratio, 1.0);
    EXPECT_EQ(rows[2].ratio, 0.0);
    EXPECT_EQ(FindBaseline(rows, rows[0]), &rows[1]);
    EXPECT_EQ(FindBaseline(rows, rows[2]), nullptr);
}

TEST(BenchComparison, RatiosAreToTheBaselineWithAsManyThreads) {
    std::vector<BenchRow> rows = {MakeRow("scree", 10), MakeRow("scree", 5),  MakeRow("scree", 4),
                                  MakeRow("box2d", 30), MakeRow("box2d", 60), MakeRow("box2d", 20)};
    const int threads[] = {1, 2, 3, 2, 1, 4};
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].threads = threads[i];
    CompareWithBaseline(rows, std::vector<std::vector<WorkCounts>>(rows.size()));
    EXPECT_EQ(rows[0].ratio, 6.0);
    EXPECT_EQ(rows[1].ratio, 6.0);
    EXPECT_EQ(rows[2].ratio, 15.0) << "none has three: that with one";
    // Where the settings are told, a baseline with another of continuous collision does; as many threads come after it.
    for (BenchRow& row : rows) row.settings = "told";
    rows[1].continuous = true;
    EXPECT_EQ(FindBaseline(rows, rows[1]), &rows[3]);
    rows[4].continuous = true;
    EXPECT_EQ(FindBaseline(rows, rows[1]), &rows[4]);
}

TEST(BenchComparison, IsVoidBeyondTheTolerances) {
    // Every step adds as much to both counts; the baseline's are 10,000 and 1,000 after 100 steps.
    const auto countUpTo = [](int64_t awake, int64_t touching, int steps) {
        std::vector<WorkCounts> work;
        for (int i = 1; i <= steps; ++i) work.push_back({awake * i / 100, touching * i / 100});
        return work;
    };
    const auto reason = [&](int64_t awake, int64_t touching, int steps = 100, int baselineSteps = 100) {
        std::vector<BenchRow> rows = {MakeRow("scree", 10), MakeRow("box2d", 50)};
        const std::vector<WorkCounts> work[] = {countUpTo(awake, touching, steps),
                                                countUpTo(10000, 1000, baselineSteps)};
        CompareWithBaseline(rows, work);
        return rows[0].voidReason;
    };
    EXPECT_EQ(reason(10200, 1200), "");
    EXPECT_EQ(reason(9800, 800), "");
    EXPECT_NE(reason(10201, 1000).find("awake"), std::string::npos);
    EXPECT_NE(reason(9799, 1000).find("awake"), std::string::npos);
    EXPECT_NE(reason(10000, 1201).find("touching"), std::string::npos);
    EXPECT_NE(reason(10000, 799).find("touching"), std::string::npos);
    EXPECT_NE(reason(5000, 500).find("; touching"), std::string::npos) << "both";
    // A run that was cut short did the same work as far as it went, or it did not.
    EXPECT_EQ(reason(10000, 1000, 50), "");
    EXPECT_EQ(reason(10000, 1000, 100, 30), "");
    EXPECT_NE(reason(5000, 1000, 50).find("awake body-steps differ by 50.0 % in the first 50 steps"), std::string::npos)
        << reason(5000, 1000, 50);
    EXPECT_NE(reason(10000, 500, 100, 40).find("touching"), std::string::npos);
}

TEST(BenchComparison, ABusyMachineIsNoticed) {
    BenchRow row = MakeRow("scree", 10);
    row.cpuMs = 9.9;
    EXPECT_FALSE(WasBusy(row));
    row.totalMs = 20;
    EXPECT_TRUE(WasBusy(row));
    row.threads = 2;
    EXPECT_FALSE(WasBusy(row)) << "threads wait for each other";
}

TEST(BenchFiles, CsvHasOneCellPerColumn) {
    std::vector<BenchRow> rows = {MakeRow("scree", 0.1), MakeRow("box2d", 55)};
    rows[0].stateHash = 0xab;
    std::istringstream lines(WriteBenchCsv(rows));
    std::vector<std::vector<std::string>> table;
    for (std::string line, cell; std::getline(lines, line);) {
        table.emplace_back();
        for (std::istringstream cells(line); std::getline(cells, cell, ',');) table.back().push_back(cell);
    }
    ASSERT_EQ(table.size(), 3u);
    const auto column = [&](const std::string& name) {
        const auto found = std::find(table[0].begin(), table[0].end(), name);
        EXPECT_NE(found, table[0].end()) << name;
        return static_cast<std::size_t>(found - table[0].begin());
    };
    for (const auto& row : table) EXPECT_EQ(row.size(), table[0].size());
    EXPECT_EQ(table[1][column("total_ms")], "0.1");
    EXPECT_EQ(table[1][column("state_hash")], "00000000000000ab");
    EXPECT_EQ(table[2][column("engine")], "box2d");
    EXPECT_EQ(table[1][column("continuous")], "false");
}

TEST(BenchFiles, JsonLinesReadBackToTheSameRows) {
    BenchRow row = MakeRow("scree", 1.0 / 3.0);
    row.stateHash = std::numeric_limits<uint64_t>::max();
    row.voidReason = "awake \"body-steps\"";
    row.peakBytes = int64_t{5} << 40;
    row.complete = false;
    row.stages.islands = 0.7;
    const std::string line = MakeBenchJson(row).dump();
    const std::vector<BenchRow> back = ReadBenchRows("rows.json", line + "\n\n" + line + "\n");
    ASSERT_EQ(back.size(), 2u);
    EXPECT_EQ(MakeBenchJson(back[1]).dump(), line);
    EXPECT_EQ(back[0].stateHash, row.stateHash);
    EXPECT_EQ(back[0].totalMs, row.totalMs);
    EXPECT_EQ(WriteBenchCsv(back), WriteBenchCsv(std::vector{row, row}));
    // All that depends on the clock stands in "ms".
    EXPECT_TRUE(MakeBenchJson(row).at("ms").contains("total_ms"));
    EXPECT_FALSE(MakeBenchJson(row).contains("total_ms"));
}

TEST(BenchFiles, ABadLineIsNamed) {
    const std::string good = MakeBenchJson(MakeRow("scree", 1)).dump();
    for (const std::string bad : {"{}", "[1]", "{", "{\"scene\": 3}"}) {
        try {
            (void)ReadBenchRows("rows.json", good + "\n" + bad);
            ADD_FAILURE() << bad;
        } catch (const FileError& error) {
            EXPECT_NE(std::string(error.what()).find("rows.json:2:"), std::string::npos) << error.what();
        }
    }
}

}  // namespace
}  // namespace testbed
