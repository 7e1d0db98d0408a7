// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Statistics over the steps of a run.

#include "testbed/engines/timing.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "testbed/base/csv.h"
#include "testbed/base/statistics.h"

namespace testbed {

bool HasTimes(const TimingSeries& series) {
    const auto isTimed = [](const StepRecord& record) { return record.times.step > 0 || record.times.broadPhase > 0; };
    return std::ranges::any_of(series.steps, isTimed);
}

TimingStats GetBroadPhaseStats(const TimingSeries& series) {
    TimingStats stats;
    if (series.steps.empty()) return stats;
    std::vector<double> times;
    times.reserve(series.steps.size());
    for (const StepRecord& record : series.steps) {
        times.push_back(record.times.broadPhase);
        if (stats.maxStep == 0 || record.times.broadPhase > stats.max) {
            stats.max = record.times.broadPhase;
            stats.maxStep = record.step;
        }
    }
    stats.median = Quantile(times, 0.5);
    stats.p99 = NearestRankQuantile(times, 0.99);
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
    CsvTable table{"engine", "step", "broad_phase_ms", "narrow_phase_ms", "solver_ms", "step_ms", "contacts"};
    const auto ms = [](double time) { return fmt::format("{:.6f}", time); };
    for (const TimingSeries& one : series) {
        for (const StepRecord& record : one.steps) {
            const StepTimes& times = record.times;
            table.AddRow(one.pane, record.step, ms(times.broadPhase), ms(times.narrowPhase), ms(times.solver),
                         ms(times.step), record.contacts);
        }
    }
    return table.GetText();
}

}  // namespace testbed
