// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The short table printed at the end of a run: tree, contacts and broad-phase times of both engines and their ratio.

#pragma once

#include <span>
#include <string>
#include <vector>

#include "testbed/engines/timing.h"
#include "testbed/jobs/overlap/metrics.h"

namespace testbed {

struct RunSummary {
    std::string scene;
    int size = 0;
    std::vector<TimingSeries> timing;  ///< one per engine
    std::vector<MetricsRow> rows;      ///< of the shown steps, all engines; may be empty
};

/// The steps over which the claim of the dissertation (section 3.8, Tiles) is summed.
inline constexpr int claimFirstStep = 70, claimLastStep = 100;

/// Lines of text, each ended by a newline. Where several steps were shown, tree figures are the largest of them.
[[nodiscard]] std::string FormatSummary(const RunSummary& summary);

}  // namespace testbed
