// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of run.h.

#include "testbed/jobs/bench/run.h"

#include <algorithm>
#include <memory>
#include <span>

#include "testbed/base/statistics.h"
#include "testbed/engines/engine_run.h"

namespace testbed {
namespace {

/// Slices of a run: few enough that the cold first step of each stays below the 99th percentile of a run of 1000 steps.
constexpr int slices = 8;

/// One pane under way.
struct Runner {
    std::unique_ptr<EngineRun> engine;
    BenchRun run;
    double spentMs = 0;
    WorkCounts work;
    int64_t contacts = 0;
    int peakContacts = 0;
};

void StepOnce(Runner& runner) {
    runner.engine->Step();
    const StepTimes times = runner.engine->GetTimes();
    const StepCounts counts = runner.engine->CountStep();
    runner.run.steps.push_back({runner.engine->GetStep(), times, counts.contacts});
    runner.spentMs += times.step;
    runner.work.awake += counts.awake;
    runner.work.touching += counts.touching;
    runner.run.work.push_back(runner.work);
    runner.contacts += counts.contacts;
    runner.peakContacts = std::max(runner.peakContacts, counts.contacts);
}

/// Steps up to `last`, or until the time is up.
void RunSlice(Runner& runner, int last, double timeLimitMs, const std::function<void(int)>& advance) {
    while (runner.run.complete && runner.engine->GetStep() < last) {
        // At least one step is taken, and a run is not cut after its last.
        if (timeLimitMs > 0 && runner.spentMs >= timeLimitMs) {
            runner.run.complete = false;
            return;
        }
        StepOnce(runner);
        advance(1);
    }
}

/// The name of the solver in a row: "si" and "soft" for the defaults, else as settings write it.
std::string NameForRow(const RunSpec& spec) {
    if (spec.solver == Solver(SoftStep{})) return "soft";
    const SettingKey& solver = FindSettingKey("solver");
    if (const std::string value = solver.print(spec); !value.empty()) return value;
    RunSpec alone{.solver = spec.solver};
    return PrintSettings(alone);
}

BenchRow MakeRow(const BenchCase& benchCase, const Pane& pane, const BenchEffort& effort,
                 const scenes::SceneCounts& counts) {
    BenchRow row;
    row.scene = benchCase.scene.name;
    row.size = benchCase.scene.size;
    row.fixtures = counts.Fixtures();
    row.joints = counts.joints;
    row.movers = counts.kinematicBodies + counts.dynamicBodies;
    row.engine = pane.spec.engine;
    row.solver = NameForRow(pane.spec);
    row.threads = pane.spec.threads;
    row.continuous = pane.spec.continuous;
    row.repeats = effort.repeats;
    row.pane = pane.name;
    row.settings = PrintSettings(pane.spec);
    const bool hasBaseline =
        std::ranges::find(benchCase.panes, benchCase.baseline, &Pane::name) != benchCase.panes.end();
    row.baseline = hasBaseline ? benchCase.baseline : "";
    return row;
}

/// Quartiles of the totals of the repeats, each over as many steps as the shortest took.
void SetSpread(BenchRow& row, std::span<const BenchRun> repeats) {
    std::vector<double> totals;
    for (const BenchRun& run : repeats) {
        totals.push_back(0.0);
        for (int i = 0; i < row.steps; ++i) totals.back() += run.steps[static_cast<std::size_t>(i)].times.step;
    }
    const Quartiles quartiles = FindQuartiles(totals);
    row.totalLowMs = quartiles.low;
    row.totalHighMs = quartiles.high;
}

/// What every repeat counts alike.
void SetCounts(BenchRow& row, Runner& runner) {
    Snapshot snapshot;
    runner.engine->Capture(snapshot, {.fixtures = false, .contacts = false, .joints = false, .nodes = false});
    row.stateHash = snapshot.stateHash;
    row.peakBytes = runner.engine->GetPeakBytes();
    row.awakeBodySteps = runner.work.awake;
    row.touchingSum = runner.work.touching;
    row.contactSum = runner.contacts;
    row.peakContacts = runner.peakContacts;
}

}  // namespace

BenchResult RunBenchCase(const BenchCase& benchCase, const BenchEffort& effort,
                         const std::function<void(int)>& advance) {
    const scenes::Scene scene = benchCase.scene.Build();
    const int steps = effort.maxSteps > 0 ? std::min(effort.maxSteps, scene.steps) : scene.steps;
    const int slice = (steps + slices - 1) / slices;
    BenchResult result;
    for (const Pane& pane : benchCase.panes) {
        result.rows.push_back(MakeRow(benchCase, pane, effort, scenes::Count(scene)));
    }
    std::vector<std::vector<BenchRun>> repeats(benchCase.panes.size());
    for (int repeat = 0; repeat < effort.repeats; ++repeat) {
        std::vector<Runner> runners;
        for (const Pane& pane : benchCase.panes) {
            runners.push_back({.engine = MakeRun(scene, pane.spec), .run = {}, .work = {}});
        }
        for (int last = slice; last < steps + slice; last += slice) {
            // Each repeat begins with another pane, so that none is always the one after a pause.
            for (std::size_t i = 0; i < runners.size(); ++i) {
                Runner& runner = runners[(i + static_cast<std::size_t>(repeat)) % runners.size()];
                RunSlice(runner, std::min(last, steps), effort.timeLimitS * 1000, advance);
            }
        }
        for (std::size_t i = 0; i < runners.size(); ++i) {
            SetCounts(result.rows[i], runners[i]);
            runners[i].run.createMs = runners[i].engine->GetCreateMilliseconds();
            repeats[i].push_back(std::move(runners[i].run));
        }
    }
    std::vector<std::vector<WorkCounts>> work;
    for (std::size_t i = 0; i < repeats.size(); ++i) {
        BenchRun merged = MergeRepeats(repeats[i]);
        SetTimes(result.rows[i], merged);
        SetSpread(result.rows[i], repeats[i]);
        work.push_back(std::move(merged.work));
        const Pane& pane = benchCase.panes[i];
        result.timing.push_back({pane.name, pane.spec.engine, std::move(merged.steps)});
    }
    CompareWithBaseline(result.rows, work);
    return result;
}

}  // namespace testbed
