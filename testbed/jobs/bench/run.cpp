// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of run.h.

#include "testbed/jobs/bench/run.h"

#include <algorithm>
#include <memory>

#include "testbed/engines/engine_run.h"

namespace testbed {
namespace {

/// Slices of a run: few enough that the cold first step of each stays below the 99th percentile of a run of 1000 steps.
constexpr int slices = 8;

/// Of the soft step at its default setting.
constexpr int softSubsteps = 4;

/// One variant under way.
struct Runner {
    std::unique_ptr<EngineRun> engine;
    BenchRun run;
    double spentMs = 0;
    int64_t awake = 0, touching = 0, contacts = 0;
    int peakContacts = 0;
};

Runner MakeRunner(const BenchVariant& variant, const BenchCase& benchCase, const BenchSettings& settings,
                  const scenes::Scene& scene) {
    RunOptions options;
    options.broadPhase = settings.broadPhase;
    options.threads = variant.threads;
    options.substeps = variant.solver == "soft" ? softSubsteps : 0;
    options.continuous = benchCase.continuous;
    return {.engine = MakeRun(variant.engine, scene, options), .run = {}};
}

void StepOnce(Runner& runner) {
    runner.engine->Step();
    const StepTimes times = runner.engine->GetTimes();
    const StepCounts counts = runner.engine->CountStep();
    runner.run.steps.push_back({runner.engine->GetStep(), times, counts.contacts});
    runner.spentMs += times.step;
    runner.awake += counts.awake;
    runner.touching += counts.touching;
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

BenchRow MakeRow(const BenchCase& benchCase, const BenchVariant& variant, const BenchSettings& settings,
                 const scenes::SceneCounts& counts) {
    BenchRow row;
    row.scene = benchCase.info->name;
    row.size = benchCase.size;
    row.fixtures = counts.Fixtures();
    row.joints = counts.joints;
    row.movers = counts.kinematicBodies + counts.dynamicBodies;
    row.engine = variant.engine;
    row.solver = variant.solver;
    row.threads = variant.threads;
    row.continuous = benchCase.continuous;
    row.repeats = settings.repeats;
    return row;
}

/// What every repeat counts alike.
void SetCounts(BenchRow& row, Runner& runner) {
    Snapshot snapshot;
    runner.engine->Capture(snapshot, {.fixtures = false, .contacts = false, .joints = false, .nodes = false});
    row.stateHash = snapshot.stateHash;
    row.peakBytes = runner.engine->GetPeakBytes();
    row.awakeBodySteps = runner.awake;
    row.touchingSum = runner.touching;
    row.contactSum = runner.contacts;
    row.peakContacts = runner.peakContacts;
}

}  // namespace

BenchResult RunBenchCase(const BenchCase& benchCase, const BenchSettings& settings,
                         const std::function<void(int)>& advance) {
    const scenes::Scene scene = scenes::Build(benchCase.info->name, benchCase.size);
    const int steps = settings.maxSteps > 0 ? std::min(settings.maxSteps, scene.steps) : scene.steps;
    const int slice = (steps + slices - 1) / slices;
    BenchResult result;
    for (const BenchVariant& variant : benchCase.variants) {
        result.rows.push_back(MakeRow(benchCase, variant, settings, scenes::Count(scene)));
    }
    std::vector<std::vector<BenchRun>> repeats(benchCase.variants.size());
    for (int repeat = 0; repeat < settings.repeats; ++repeat) {
        std::vector<Runner> runners;
        for (const BenchVariant& variant : benchCase.variants) {
            runners.push_back(MakeRunner(variant, benchCase, settings, scene));
        }
        for (int last = slice; last < steps + slice; last += slice) {
            for (Runner& runner : runners) RunSlice(runner, std::min(last, steps), settings.timeLimitS * 1000, advance);
        }
        for (std::size_t i = 0; i < runners.size(); ++i) {
            SetCounts(result.rows[i], runners[i]);
            runners[i].run.createMs = runners[i].engine->GetCreateMilliseconds();
            repeats[i].push_back(std::move(runners[i].run));
        }
    }
    for (std::size_t i = 0; i < repeats.size(); ++i) {
        BenchRun merged = MergeRepeats(repeats[i]);
        SetTimes(result.rows[i], merged);
        result.timing.push_back({benchCase.variants[i].engine, std::move(merged.steps)});
    }
    CompareWithBox2d(result.rows);
    return result;
}

}  // namespace testbed
