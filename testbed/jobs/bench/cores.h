// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree bench --cores`: what a step would gain on more cores than the machine has. Work and span of every step are
// counted on one thread (engines/loop_meter.h), for as many tasks a loop as there are cores.

#pragma once

#include <vector>

#include "testbed/engines/loop_meter.h"
#include "testbed/jobs/bench/plan.h"
#include "testbed/options/request.h"

namespace testbed {

/// Where the time of a step went.
struct CountedStep {
    double apart = 0.0;  ///< in no loop, ms
    LoopTimes loops{};

    /// Keeps the least time of each part. Both must be of the same step.
    void TakeLeast(const CountedStep& other);
};

[[nodiscard]] CountedStep SplitStep(double stepMs, const LoopTimes& loops);

/// How long a step takes on so many cores, ms: what is in no loop, the loops dealt to the cores, and the barriers.
[[nodiscard]] double PredictStep(const CountedStep& step, int cores);

/// A scene with one solver.
struct CoresRow {
    std::string scene, solver;
    int size = 0, steps = 0, movers = 0;
    double oneThreadMs = 0.0;        ///< all steps
    double sharedPart = 0.0;         ///< of a step's time that is in loops, with the most cores
    double loops = 0.0;              ///< a step, likewise
    std::vector<double> speedUps{};  ///< by number of cores: time of one thread over the predicted one
};

/// Runs the cases; times of a step are the least of the repeats, which all take the same steps. Throws UsageError.
[[nodiscard]] std::vector<CoresRow> MeasureCores(const BenchPlan& plan, const std::vector<int>& cores);

/// Measures, prints and writes what the arguments ask for. Throws UsageError.
int RunCores(const BenchArguments& arguments, const Request& request);

}  // namespace testbed
