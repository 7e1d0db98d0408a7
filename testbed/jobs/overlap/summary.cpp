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
#include <utility>

#include "testbed/engines/engine_list.h"
#include "testbed/engines/provenance.h"
#include "testbed/page/facts.h"

namespace testbed {

namespace {

constexpr int labelWidth = 34, cellWidth = 15;

/// What is known of every pane.
struct Line {
    std::string label;
    std::vector<double> values;     ///< by pane
    std::vector<std::string> text;  ///< likewise
};

std::string NameRatio(const RunSummary& summary, std::size_t pane, std::string_view between) {
    return fmt::format("{}{}{}", summary.timing[summary.baseline].pane, between, summary.timing[pane].pane);
}
std::string FormatRatio(const RunSummary& summary, const Line& line, std::size_t pane) {
    const double value = line.values[pane];
    return value > 0 ? fmt::format("{:.2f}", line.values[summary.baseline] / value) : "-";
}

/// Below a heading of so many characters; a wide one makes its column wide.
void AddCell(std::string& text, const std::string& cell, std::size_t heading = 0) {
    const std::size_t width = std::max<std::size_t>(cellWidth, std::max(heading, cell.size()) + 2);
    fmt::format_to(std::back_inserter(text), "{:>{}}", cell, width);
}

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

using Format = std::function<std::string(double, std::size_t)>;

void AddLine(std::vector<Line>& lines, std::string label, std::vector<double> values, const Format& format) {
    Line line{std::move(label), std::move(values), {}};
    for (std::size_t i = 0; i < line.values.size(); ++i) line.text.push_back(format(line.values[i], i));
    lines.push_back(std::move(line));
}

void AppendTreeLines(std::vector<Line>& lines, const RunSummary& summary) {
    const std::string steps = DescribeSteps(summary);
    AddLine(lines, fmt::format("sibling overlap, {}", steps),
            Largest(summary, [](const MetricsRow& row) { return row.siblingOverlap; }), Fine);
    AddLine(lines, fmt::format("area ratio, {}", steps),
            Largest(summary, [](const MetricsRow& row) { return row.areaRatio; }), Whole);
    AddLine(lines, fmt::format("overlap count max, {}", steps),
            Largest(summary, [](const MetricsRow& row) { return row.overlapMax; }), Whole);
    AddLine(lines, fmt::format("overlap count mean, {}", steps),
            Largest(summary, [](const MetricsRow& row) { return row.overlapMean; }), Fine);
}

void AppendTimeLines(std::vector<Line>& lines, const RunSummary& summary) {
    const int steps = static_cast<int>(summary.timing.front().steps.size());
    AddLine(lines, fmt::format("peak contacts, steps 1-{}", steps), ForEachSeries(summary, GetPeakContacts), Whole);
    const auto stat = [&](double TimingStats::*member) {
        return ForEachSeries(summary, [=](const TimingSeries& series) { return GetBroadPhaseStats(series).*member; });
    };
    AddLine(lines, "broad phase median, ms", stat(&TimingStats::median), Time);
    AddLine(lines, "broad phase p99, ms", stat(&TimingStats::p99), Time);
    AddLine(lines, "broad phase max, ms (step)", stat(&TimingStats::max), [&](double value, std::size_t index) {
        if (!(value > 0)) return std::string("-");
        return fmt::format("{:.3f} ({})", value, GetBroadPhaseStats(summary.timing[index]).maxStep);
    });
    const auto addSum = [&](int first, int last) {
        AddLine(lines, fmt::format("broad phase sum {}-{}, ms", first, last),
                ForEachSeries(summary, [=](const TimingSeries& series) { return SumBroadPhase(series, first, last); }),
                Time);
    };
    addSum(1, steps);
    if (steps >= claimLastStep) addSum(claimFirstStep, claimLastStep);
}

std::vector<Line> ListLines(const RunSummary& summary) {
    std::vector<Line> lines;
    if (summary.timing.empty() || summary.timing.front().steps.empty()) return lines;
    if (!summary.rows.empty()) AppendTreeLines(lines, summary);
    AppendTimeLines(lines, summary);
    return lines;
}

}  // namespace

std::string FormatSummary(const RunSummary& summary) {
    const std::vector<Line> lines = ListLines(summary);
    if (lines.empty()) return {};
    const std::vector<TimingSeries>& panes = summary.timing;
    std::string text = fmt::format("{:<{}}", fmt::format("{}, size {}", summary.scene, summary.size), labelWidth);
    const auto endLine = [&](const std::function<void(std::size_t)>& addRatio) {
        for (std::size_t i = 0; i < panes.size(); ++i) {
            if (i != summary.baseline) addRatio(i);
        }
        text += '\n';
    };
    for (const TimingSeries& pane : panes) AddCell(text, pane.pane);
    endLine([&](std::size_t i) { AddCell(text, NameRatio(summary, i, "/")); });
    for (const Line& line : lines) {
        fmt::format_to(std::back_inserter(text), "{:<{}}", line.label, labelWidth);
        for (std::size_t i = 0; i < panes.size(); ++i) AddCell(text, line.text[i], panes[i].pane.size());
        endLine(
            [&](std::size_t i) { AddCell(text, FormatRatio(summary, line, i), NameRatio(summary, i, "/").size()); });
    }
    return text;
}

PageSection MakeSummarySection(const RunSummary& summary, const Panes& panes) {
    // With more panes the table would be too wide.
    constexpr std::size_t mostWithRatios = 3;
    const bool hasRatios = summary.timing.size() <= mostWithRatios;
    PageTable table{.columns = {{.name = "quantity"}}};
    for (const TimingSeries& pane : summary.timing) table.columns.push_back({.name = pane.pane, .numeric = true});
    const auto forOthers = [&](const std::function<void(std::size_t)>& visit) {
        for (std::size_t i = 0; hasRatios && i < summary.timing.size(); ++i) {
            if (i != summary.baseline) visit(i);
        }
    };
    forOthers([&](std::size_t i) { table.columns.push_back({.name = NameRatio(summary, i, " / "), .numeric = true}); });
    std::string settings = FormatSettings(panes);
    if (!settings.empty()) settings.pop_back();  // the end of a line
    for (const Line& line : ListLines(summary)) {
        std::vector<PageCell> row{line.label};
        row.insert(row.end(), line.text.begin(), line.text.end());
        forOthers([&](std::size_t i) { row.emplace_back(FormatRatio(summary, line, i)); });
        table.rows.push_back(std::move(row));
    }
    return {.title = fmt::format("{}, size {}", summary.scene, summary.size), .intro = settings, .blocks = {table}};
}

Page MakeSummaryPage(std::vector<PageSection> sections, const std::string& command) {
    Page page{.title = "Trees of broad phases",
              .intro =
                  "How much the nodes of each engine's tree overlap, and the times of its broad phase.\n\nSibling "
                  "overlap is the area in which the two children of a node overlap, summed over all nodes, as a "
                  "multiple of the root's area. The overlap count of a pixel is the number of nodes that cover "
                  "it.",
              .sections = std::move(sections)};
    AddFacts(page, command, ToJson(FindProvenance()));
    return page;
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
