// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Runs one scene at one size in several engines and settings, in one process: a case in, one row per pane out. They
// take turns in slices of steps. So a disturbance of the machine hits all alike, and each engine keeps its data in the
// caches for a slice. Counts are taken between the timed steps.

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "testbed/engines/panes.h"
#include "testbed/jobs/bench/row.h"
#include "testbed/options/scene_input.h"

namespace testbed {

/// A scene at a size, to be run in all of the panes.
struct BenchCase {
    SceneInput scene;
    std::vector<Pane> panes;
    std::string baseline = "box2d";  ///< name of the pane that the others are compared with
};

/// How long a case is measured.
struct BenchEffort {
    int repeats = 1;
    int maxSteps = 0;       ///< 0: the scene's own number
    double timeLimitS = 0;  ///< of one pane's steps in one repeat; 0: none
};

/// The rows of a case and the merged times of every step, one per pane, in their order.
struct BenchResult {
    std::vector<BenchRow> rows;
    std::vector<TimingSeries> timing;
};

/// Runs a case; calls advance(n) after every n steps of a pane. Rows are compared with the case's own baseline.
[[nodiscard]] BenchResult RunBenchCase(const BenchCase& benchCase, const BenchEffort& effort,
                                       const std::function<void(int)>& advance);

}  // namespace testbed
