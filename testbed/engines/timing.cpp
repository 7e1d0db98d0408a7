// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Statistics over the steps of a run.

#include "testbed/engines/timing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace testbed {

TimingStats GetBroadPhaseStats(const TimingSeries& series) {
    TimingStats stats;
    if (series.steps.empty()) return stats;
    std::vector<double> sorted;
    sorted.reserve(series.steps.size());
    for (const StepRecord& record : series.steps) {
        sorted.push_back(record.times.broadPhase);
        if (stats.maxStep == 0 || record.times.broadPhase > stats.max) {
            stats.max = record.times.broadPhase;
            stats.maxStep = record.step;
        }
    }
    std::sort(sorted.begin(), sorted.end());
    const std::size_t count = sorted.size();
    stats.median = 0.5 * (sorted[(count - 1) / 2] + sorted[count / 2]);
    stats.p99 = sorted[(count * 99 + 99) / 100 - 1];
    return stats;
}

double SumBroadPhase(const TimingSeries& series, int first, int last) {
    double sum = 0;
    int found = 0;
    for (const StepRecord& record : series.steps) {
        if (record.step < first || record.step > last) continue;
        sum += record.times.broadPhase;
        ++found;
    }
    return found == last - first + 1 ? sum : -1;
}

int GetPeakContacts(const TimingSeries& series) {
    int peak = 0;
    for (const StepRecord& record : series.steps) peak = std::max(peak, record.contacts);
    return peak;
}

std::string WriteTimingCsv(std::span<const TimingSeries> series) {
    std::string text = "engine,step,broad_phase_ms,narrow_phase_ms,solver_ms,step_ms,contacts\n";
    for (const TimingSeries& one : series) {
        for (const StepRecord& record : one.steps) {
            const StepTimes& times = record.times;
            fmt::format_to(std::back_inserter(text), "{},{},{:.6f},{:.6f},{:.6f},{:.6f},{}\n", one.pane, record.step,
                           times.broadPhase, times.narrowPhase, times.solver, times.step, record.contacts);
        }
    }
    return text;
}

}  // namespace testbed
