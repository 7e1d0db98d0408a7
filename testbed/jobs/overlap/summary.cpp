// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The short table printed at the end of a run.

#include "testbed/jobs/overlap/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <string_view>

namespace testbed {

namespace {

constexpr int labelWidth = 34, cellWidth = 15;

/// One line: a value per engine and, when there are two, how many times the first goes into the second.
void AppendLine(std::string& text, std::string_view label, std::span<const double> values,
                const std::function<std::string(double, std::size_t)>& format) {
    fmt::format_to(std::back_inserter(text), "{:<{}}", label, labelWidth);
    for (std::size_t i = 0; i < values.size(); ++i) {
        fmt::format_to(std::back_inserter(text), "{:>{}}", format(values[i], i), cellWidth);
    }
    if (values.size() == 2) {
        const std::string ratio = values[0] > 0 ? fmt::format("{:.2f}", values[1] / values[0]) : std::string("-");
        fmt::format_to(std::back_inserter(text), "{:>{}}", ratio, cellWidth);
    }
    text += '\n';
}

std::string Whole(double value, std::size_t) { return fmt::format("{:.0f}", value); }
std::string Fine(double value, std::size_t) { return fmt::format("{:.3f}", value); }

/// "step 90" or "max of 5 steps".
std::string DescribeSteps(const RunSummary& summary) {
    std::vector<int> steps;
    for (const MetricsRow& row : summary.rows) steps.push_back(row.step);
    std::sort(steps.begin(), steps.end());
    steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
    return steps.size() == 1 ? fmt::format("step {}", steps.front()) : fmt::format("max of {} steps", steps.size());
}

/// The largest value of each engine's rows.
template <typename Get>
std::vector<double> Largest(const RunSummary& summary, Get get) {
    std::vector<double> values;
    for (const TimingSeries& series : summary.timing) {
        double largest = 0;
        for (const MetricsRow& row : summary.rows) {
            if (row.engine == series.engine) largest = std::max(largest, static_cast<double>(get(row)));
        }
        values.push_back(largest);
    }
    return values;
}

template <typename Get>
std::vector<double> ForEachSeries(const RunSummary& summary, Get get) {
    std::vector<double> values;
    for (const TimingSeries& series : summary.timing) values.push_back(static_cast<double>(get(series)));
    return values;
}

void AppendTreeLines(std::string& text, const RunSummary& summary) {
    const std::string steps = DescribeSteps(summary);
    AppendLine(text, fmt::format("sibling overlap, {}", steps),
               Largest(summary, [](const MetricsRow& row) { return row.siblingOverlap; }), Fine);
    AppendLine(text, fmt::format("overlap count max, {}", steps),
               Largest(summary, [](const MetricsRow& row) { return row.overlapMax; }), Whole);
    AppendLine(text, fmt::format("overlap count mean, {}", steps),
               Largest(summary, [](const MetricsRow& row) { return row.overlapMean; }), Fine);
}

void AppendTimeLines(std::string& text, const RunSummary& summary) {
    const int steps = static_cast<int>(summary.timing.front().steps.size());
    AppendLine(text, fmt::format("peak contacts, steps 1-{}", steps), ForEachSeries(summary, GetPeakContacts), Whole);
    const auto stat = [&](double TimingStats::*member) {
        return ForEachSeries(summary, [=](const TimingSeries& series) { return GetBroadPhaseStats(series).*member; });
    };
    AppendLine(text, "broad phase median, ms", stat(&TimingStats::median), Fine);
    AppendLine(text, "broad phase p99, ms", stat(&TimingStats::p99), Fine);
    AppendLine(text, "broad phase max, ms (step)", stat(&TimingStats::max), [&](double value, std::size_t index) {
        return fmt::format("{:.3f} ({})", value, GetBroadPhaseStats(summary.timing[index]).maxStep);
    });
    const auto addSum = [&](int first, int last) {
        AppendLine(
            text, fmt::format("broad phase sum {}-{}, ms", first, last),
            ForEachSeries(summary, [=](const TimingSeries& series) { return SumBroadPhase(series, first, last); }),
            Fine);
    };
    addSum(1, steps);
    if (steps >= claimLastStep) addSum(claimFirstStep, claimLastStep);
}

}  // namespace

std::string FormatSummary(const RunSummary& summary) {
    if (summary.timing.empty() || summary.timing.front().steps.empty()) return {};
    std::string text = fmt::format("{:<{}}", fmt::format("{}, size {}", summary.scene, summary.size), labelWidth);
    for (const TimingSeries& series : summary.timing) {
        fmt::format_to(std::back_inserter(text), "{:>{}}", series.engine, cellWidth);
    }
    if (summary.timing.size() == 2) {
        fmt::format_to(std::back_inserter(text), "{:>{}}",
                       fmt::format("{}/{}", summary.timing[1].engine, summary.timing[0].engine), cellWidth);
    }
    text += '\n';
    if (!summary.rows.empty()) AppendTreeLines(text, summary);
    AppendTimeLines(text, summary);
    return text;
}

}  // namespace testbed
