// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Times and contacts of every step of one pane's run, and their statistics.

#pragma once

#include <span>
#include <string>
#include <vector>

#include "testbed/engines/snapshot.h"

namespace testbed {

struct StepRecord {
    int step = 0;
    StepTimes times;
    int contacts = 0;  ///< kept after the step, touching or not
};

struct TimingSeries {
    std::string pane;               ///< its name
    std::string engine;             ///< that runs in it
    std::vector<StepRecord> steps;  ///< 1, 2, … in order
};

struct TimingStats {
    double median = 0;  ///< ms
    double p99 = 0;     ///< ms; smallest time that at least 99 % of the steps do not exceed
    double max = 0;     ///< ms
    int maxStep = 0;    ///< step of the maximum, the first of equals
};

/// False of a motion that was recorded without times.
[[nodiscard]] bool HasTimes(const TimingSeries& series);

/// Broad-phase time over all steps; zeros when there are none.
[[nodiscard]] TimingStats GetBroadPhaseStats(const TimingSeries& series);

/// Sum of the broad-phase time over first…last, ms; negative when the series does not hold all of these steps.
[[nodiscard]] double SumBroadPhase(const TimingSeries& series, int first, int last);

[[nodiscard]] int GetPeakContacts(const TimingSeries& series);

/// A header, then a row per pane and step with the column names of metrics.csv.
[[nodiscard]] std::string WriteTimingCsv(std::span<const TimingSeries> series);

}  // namespace testbed
