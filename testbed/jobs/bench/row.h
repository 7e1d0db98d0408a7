// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What `scree bench` measured of one scene at one size in one engine and setting, as a row. Step records of all repeats
// in, statistics out. Rows as CSV and as JSON have the same columns in the same order.

#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "testbed/engines/timing.h"

namespace testbed {

/// Stages summed over a run, ms.
struct StageTotals {
    double broadPhase = 0;
    double narrowPhase = 0;
    double islands = 0;  ///< Box2D: in `solver`
    double solver = 0;   ///< islands left out, except Box2D's
    double continuous = 0;
};

/// A row; the fields are the columns, in order.
struct BenchRow {
    std::string scene;
    int size = 0;
    int fixtures = 0;  ///< static and moving, spawned ones included: the x axis of the plots
    int joints = 0;
    int movers = 0;  ///< bodies that are not static
    std::string engine;
    std::string solver;  ///< "si": the scene's iterations; "soft": 4 sub-steps; others as settings write them: "soft@8"
    int threads = 1;
    bool continuous = false;
    int repeats = 1;
    int steps = 0;         ///< taken
    bool complete = true;  ///< false: stopped at the time limit, all totals are lower bounds
    double createMs = 0;   ///< world, bodies, fixtures, joints; also those that are spawned between steps
    double totalMs = 0;    ///< sum of the single steps, the first included
    double totalLowMs = 0, totalHighMs = 0;  ///< quartiles of the repeats' totals
    double cpuMs = 0;                        ///< processor time of the same steps, all threads together
    double medianMs = 0;                     ///< of a step
    double p99Ms = 0;
    double maxMs = 0;
    int maxStep = 0;  ///< step of the maximum
    StageTotals stages;
    double nsPerBodyStep = 0;  ///< total / awakeBodySteps
    int64_t awakeBodySteps = 0;
    int64_t touchingSum = 0;  ///< touching contacts, summed over the steps
    int64_t contactSum = 0;   ///< contacts kept, summed over the steps
    int peakContacts = 0;
    int64_t peakBytes = 0;           ///< heap held by the engine
    uint64_t stateHash = 0;          ///< after the last step; written as 16 hexadecimal digits
    double ratio = 0;                ///< the baseline's total / this one's; 0: no such run
    double cpuRatio = 0;             ///< the same of the processor times: steady on a busy machine
    std::string voidReason;          ///< not empty: the ratio does not compare the same work
    std::string pane;                ///< its name; empty: the engine's
    std::string settings;            ///< how it was run, as PrintSettings writes it
    std::string baseline = "box2d";  ///< name of the pane that the ratio compares with; empty: none

    [[nodiscard]] const std::string& GetName() const { return pane.empty() ? engine : pane; }
    [[nodiscard]] bool IsBaseline() const { return GetName() == baseline; }
};

/// What runs that do the same have in common.
struct WorkCounts {
    int64_t awake = 0;     ///< body-steps
    int64_t touching = 0;  ///< contacts, summed over the steps
};

/// One run of a row: what was recorded of every step.
struct BenchRun {
    double createMs = 0;
    std::vector<StepRecord> steps;
    bool complete = true;
    std::vector<WorkCounts> work;  ///< up to the end of each step
};

/// One run out of several repeats. A step does the same work in each repeat, since the simulation is deterministic. The
/// repeat with the (lower) median time of a step stands for it, with all its stages. Cut to the shortest run. `runs` is
/// not empty.
[[nodiscard]] BenchRun MergeRepeats(std::span<const BenchRun> runs);

/// Fills in everything that follows from the steps: counts of steps, times, statistics.
void SetTimes(BenchRow& row, const BenchRun& run);

/// Fills in `ratio` and `voidReason` of every row from its baseline's row. A ratio is void where in the steps that both
/// took, also where one was stopped, awake body-steps differ by more than 2 % or touching contacts by more than 20 %.
/// `work` by row, as BenchRun has it.
void CompareWithBaseline(std::span<BenchRow> rows, std::span<const std::vector<WorkCounts>> work);

/// Whether the machine had other work: the steps of one thread took much longer than the processor worked on them.
[[nodiscard]] bool WasBusy(const BenchRow& row);

/// The baseline's row of the same scene and size; of the same continuous setting and number of threads if there is one,
/// else with the fewest threads. Null: none.
[[nodiscard]] const BenchRow* FindBaseline(std::span<const BenchRow> rows, const BenchRow& row);

/// A line of column names, then a line per row; numbers read back to the same values.
[[nodiscard]] std::string WriteBenchCsv(std::span<const BenchRow> rows);

/// One row as an object for a line of JSON: counts by the names of their columns, and all that depends on the clock in
/// an object "ms".
[[nodiscard]] nlohmann::ordered_json MakeBenchJson(const BenchRow& row);

/// The rows of a file that `scree bench --json` or `scree merge` wrote. Throws FileError that names file and line.
[[nodiscard]] std::vector<BenchRow> ReadBenchRows(const std::string& file, const std::string& text);

}  // namespace testbed
