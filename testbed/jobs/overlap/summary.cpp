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

#include "testbed/engines/engine_list.h"

namespace testbed {

namespace {

constexpr int labelWidth = 34, cellWidth = 15;

/// Lays lines out: a value per pane, then how many times each pane's goes into the baseline's.
class Table {
public:
    explicit Table(const RunSummary& summary) : m_baseline(summary.baseline) {
        for (const TimingSeries& series : summary.timing) m_names.push_back(series.pane);
        m_text = fmt::format("{:<{}}", fmt::format("{}, size {}", summary.scene, summary.size), labelWidth);
        for (const std::string& name : m_names) AddCell(name);
        for (std::size_t i = 0; i < m_names.size(); ++i) {
            if (i != m_baseline) AddCell(GetRatioName(i));
        }
        m_text += '\n';
    }

    void AddLine(std::string_view label, std::span<const double> values,
                 const std::function<std::string(double, std::size_t)>& format) {
        fmt::format_to(std::back_inserter(m_text), "{:<{}}", label, labelWidth);
        for (std::size_t i = 0; i < values.size(); ++i) AddCell(format(values[i], i), m_names[i].size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (i == m_baseline) continue;
            AddCell(values[i] > 0 ? fmt::format("{:.2f}", values[m_baseline] / values[i]) : std::string("-"),
                    GetRatioName(i).size());
        }
        m_text += '\n';
    }

    [[nodiscard]] const std::string& GetText() const { return m_text; }

private:
    [[nodiscard]] std::string GetRatioName(std::size_t i) const { return m_names[m_baseline] + "/" + m_names[i]; }
    /// Below a heading of so many characters; a wide one makes its column wide.
    void AddCell(const std::string& text, std::size_t heading = 0) {
        const std::size_t width = std::max<std::size_t>(cellWidth, std::max(heading, text.size()) + 2);
        fmt::format_to(std::back_inserter(m_text), "{:>{}}", text, width);
    }

    std::size_t m_baseline;
    std::vector<std::string> m_names;
    std::string m_text;
};

std::string Whole(double value, std::size_t) { return fmt::format("{:.0f}", value); }
std::string Fine(double value, std::size_t) { return fmt::format("{:.3f}", value); }
std::string Time(double value, std::size_t) { return value > 0 ? fmt::format("{:.3f}", value) : "-"; }

/// "step 90" or "max of 5 steps".
std::string DescribeSteps(const RunSummary& summary) {
    std::vector<int> steps;
    for (const MetricsRow& row : summary.rows) steps.push_back(row.step);
    std::sort(steps.begin(), steps.end());
    steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
    return steps.size() == 1 ? fmt::format("step {}", steps.front()) : fmt::format("max of {} steps", steps.size());
}

/// The largest value of each pane's rows.
template <typename Get>
std::vector<double> Largest(const RunSummary& summary, Get get) {
    std::vector<double> values;
    for (const TimingSeries& series : summary.timing) {
        double largest = 0;
        for (const MetricsRow& row : summary.rows) {
            if (row.pane == series.pane) largest = std::max(largest, static_cast<double>(get(row)));
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

void AppendTreeLines(Table& table, const RunSummary& summary) {
    const std::string steps = DescribeSteps(summary);
    table.AddLine(fmt::format("sibling overlap, {}", steps),
                  Largest(summary, [](const MetricsRow& row) { return row.siblingOverlap; }), Fine);
    table.AddLine(fmt::format("overlap count max, {}", steps),
                  Largest(summary, [](const MetricsRow& row) { return row.overlapMax; }), Whole);
    table.AddLine(fmt::format("overlap count mean, {}", steps),
                  Largest(summary, [](const MetricsRow& row) { return row.overlapMean; }), Fine);
}

void AppendTimeLines(Table& table, const RunSummary& summary) {
    const int steps = static_cast<int>(summary.timing.front().steps.size());
    table.AddLine(fmt::format("peak contacts, steps 1-{}", steps), ForEachSeries(summary, GetPeakContacts), Whole);
    const auto stat = [&](double TimingStats::*member) {
        return ForEachSeries(summary, [=](const TimingSeries& series) { return GetBroadPhaseStats(series).*member; });
    };
    table.AddLine("broad phase median, ms", stat(&TimingStats::median), Time);
    table.AddLine("broad phase p99, ms", stat(&TimingStats::p99), Time);
    table.AddLine("broad phase max, ms (step)", stat(&TimingStats::max), [&](double value, std::size_t index) {
        if (!(value > 0)) return std::string("-");
        return fmt::format("{:.3f} ({})", value, GetBroadPhaseStats(summary.timing[index]).maxStep);
    });
    const auto addSum = [&](int first, int last) {
        table.AddLine(
            fmt::format("broad phase sum {}-{}, ms", first, last),
            ForEachSeries(summary, [=](const TimingSeries& series) { return SumBroadPhase(series, first, last); }),
            Time);
    };
    addSum(1, steps);
    if (steps >= claimLastStep) addSum(claimFirstStep, claimLastStep);
}

}  // namespace

std::string FormatSummary(const RunSummary& summary) {
    if (summary.timing.empty() || summary.timing.front().steps.empty()) return {};
    Table table(summary);
    if (!summary.rows.empty()) AppendTreeLines(table, summary);
    AppendTimeLines(table, summary);
    return table.GetText();
}

std::string FormatSettings(const Panes& panes) {
    std::string text;
    for (const Pane& pane : panes.panes) {
        std::string settings = PrintSettings(pane.spec);
        if (pane.spec.engine == recordedEngine) settings = "with the times of the program that recorded it";
        fmt::format_to(std::back_inserter(text), "{}{} {}", text.empty() ? "settings: " : "; ", pane.name,
                       settings.empty() ? "preset=own" : settings);
    }
    return text + "\n";
}

}  // namespace testbed
