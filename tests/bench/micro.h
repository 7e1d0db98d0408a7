// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the micro-benchmarks share. Each file registers its own; names read kernel/variant/data.

#pragma once

#include <benchmark/benchmark.h>

#include <memory>
#include <string>

#include "scenes/catalog.h"
#include "testbed/engines/engine_run.h"

namespace scree::bench {

void RegisterBroadPhase();
void RegisterCollide();
void RegisterStages();
void RegisterJoints();
void RegisterQueries();
void RegisterRollback();

/// A scene that has run for `steps` steps in our engine.
inline std::unique_ptr<testbed::EngineRun> RunScene(const scenes::Scene& scene, int steps) {
    std::unique_ptr<testbed::EngineRun> run =
        testbed::MakeRun(scene, testbed::MakeSpec("scree", testbed::likeBox2dPreset));
    for (int i = 0; i < steps; ++i) run->Step();
    return run;
}

/// Reports ns per item instead of per iteration.
inline void SetItems(benchmark::State& state, double itemsPerIteration, const char* name) {
    using benchmark::Counter;
    state.counters[name] = itemsPerIteration;
    state.counters[std::string("s/") + name] =
        Counter(itemsPerIteration, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

}  // namespace scree::bench
