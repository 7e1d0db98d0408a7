// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One stage of whole steps, as the engine's own profile tells it: broad phase with matching of pairs to contacts,
// narrow phase, solver rows. The worlds are recorded scenes that go on running, so that every iteration works on live
// data.

#include "tests/bench/micro.h"

namespace scree::bench {
namespace {

struct Case {
    const char* name;
    const char* scene;
    int size;
    int steps;  ///< taken before
};

constexpr Case cases[] = {{"smoke", "pyramid", 5, 10},
                          {"pyramid-100", "pyramid", 100, 20},
                          {"pyramid-200", "pyramid", 200, 10},
                          {"slow-explosion", "slow-explosion", 6000, 60},
                          {"falling-squares", "falling-squares", 300, 300},
                          {"n2", "n2", 750, 10},
                          {"tiles", "tiles", 200, 80}};

using Stage = double testbed::StepTimes::*;

void BenchStage(benchmark::State& state, const Case& what, Stage stage, bool perContact) {
    const scenes::Scene scene = scenes::Build(what.scene, what.size);
    std::unique_ptr<testbed::EngineRun> run;
    double items = 0;
    int left = 0;
    for (auto _ : state) {
        if (left-- == 0) {
            // Back to the beginning before the scene has become another one.
            run = RunScene(scene, what.steps);
            left = 30;
        }
        run->Step();
        state.SetIterationTime(run->GetTimes().*stage * 1e-3);
        const testbed::StepCounts counts = run->CountStep();
        items += perContact ? counts.contacts : counts.awake;
    }
    SetItems(state, items / static_cast<double>(state.iterations()), perContact ? "contact" : "body");
}

void Register(const std::string& name, const Case& what, Stage stage, bool perContact) {
    benchmark::RegisterBenchmark((name + "/" + what.name).c_str(), [=](benchmark::State& state) {
        BenchStage(state, what, stage, perContact);
    })->UseManualTime();
}

}  // namespace

void RegisterStages() {
    for (const Case& what : cases) {
        Register("stage/broad-phase-and-matching", what, &testbed::StepTimes::broadPhase, false);
        Register("stage/narrow-phase", what, &testbed::StepTimes::narrowPhase, true);
        Register("stage/islands", what, &testbed::StepTimes::islands, false);
        Register("stage/islands-and-solver", what, &testbed::StepTimes::solver, true);
    }
}

}  // namespace scree::bench
