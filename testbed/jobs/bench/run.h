// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Runs one scene at one size in several engines and settings within one process, in slices of steps taken in turn, so
// that a disturbance of the machine hits all alike while each engine's data stays in the caches for a slice. A case in,
// one row per variant out. What is counted is counted between the timed steps.

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scenes/catalog.h"
#include "testbed/jobs/bench/row.h"

namespace testbed {

/// An engine and its setting.
struct BenchVariant {
    std::string engine;
    std::string solver = "si";
    int threads = 1;
};

/// A scene at a size, to be run in all of the variants.
struct BenchCase {
    const scenes::SceneInfo* info = nullptr;
    int size = 0;
    bool continuous = false;
    std::vector<BenchVariant> variants;
};

struct BenchSettings {
    int repeats = 1;
    int maxSteps = 0;       ///< 0: the scene's own number
    double timeLimitS = 0;  ///< of one variant's steps in one repeat; 0: none
    std::string broadPhase = "auto";
};

/// The rows of a case and the merged times of every step, one per variant, in the order of the variants.
struct BenchResult {
    std::vector<BenchRow> rows;
    std::vector<TimingSeries> timing;
};

/// Runs a case; calls advance(n) after every n steps of a variant. Rows are compared with the case's own Box2D row.
[[nodiscard]] BenchResult RunBenchCase(const BenchCase& benchCase, const BenchSettings& settings,
                                       const std::function<void(int)>& advance);

}  // namespace testbed
