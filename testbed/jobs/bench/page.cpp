// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of page.h.

#include "testbed/jobs/bench/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "testbed/page/facts.h"
#include "testbed/page/stacked_bars.h"

namespace testbed {
namespace {

PageTable MakeTable(std::span<const BenchRow> rows) {
    PageTable table{
        .columns = {{.name = "scene"},
                    {.name = "size", .numeric = true},
                    {.name = "engine"},
                    {.name = "solver"},
                    {.name = "threads", .numeric = true},
                    {.name = "total", .unit = "ms", .numeric = true},
                    {.name = "quartiles", .unit = "ms", .hint = "of the repeats' totals"},
                    {.name = "ratio", .unit = "×", .numeric = true, .hint = "the baseline's total / this one's"},
                    {.name = "ratio, processor", .unit = "×", .numeric = true},
                    {.name = "create", .unit = "ms", .numeric = true},
                    {.name = "median", .unit = "ms", .numeric = true, .group = "one step"},
                    {.name = "p99", .unit = "ms", .numeric = true, .group = "one step"},
                    {.name = "max", .unit = "ms", .numeric = true, .group = "one step"},
                    {.name = "broad phase", .unit = "ms", .numeric = true, .group = "stages"},
                    {.name = "narrow phase", .unit = "ms", .numeric = true, .group = "stages"},
                    {.name = "islands", .unit = "ms", .numeric = true, .group = "stages"},
                    {.name = "solver", .unit = "ms", .numeric = true, .group = "stages"},
                    {.name = "continuous", .unit = "ms", .numeric = true, .group = "stages"},
                    {.name = "body and step", .unit = "ns", .numeric = true},
                    {.name = "contacts", .numeric = true, .hint = "most at the end of a step"},
                    {.name = "memory", .unit = "MB", .numeric = true, .hint = "heap, most held"},
                    {.name = "settings"}},
        .filter = true};
    for (const BenchRow& row : rows) {
        const bool isVoid = !row.voidReason.empty();
        PageCell total = PageCell::Number(row.totalMs, 1);
        if (!row.complete) total.text = "≥ " + total.text;
        PageCell ratio;
        if (!row.IsBaseline() && row.ratio > 0) {
            const PageTone tone = isVoid ? PageTone::warning : row.ratio >= 1 ? PageTone::good : PageTone::bad;
            ratio = PageCell::Number(row.ratio, 2, tone);
            if (isVoid) ratio.text += " void";
            ratio.hint = row.voidReason;
        }
        const StageTotals& s = row.stages;
        table.rows.push_back({row.scene,
                              PageCell::Number(row.size),
                              row.GetName() + (row.continuous ? ", continuous" : ""),
                              row.solver,
                              PageCell::Number(row.threads),
                              total,
                              fmt::format("{:.1f} … {:.1f}", row.totalLowMs, row.totalHighMs),
                              ratio,
                              row.cpuRatio > 0 && !row.IsBaseline() ? PageCell::Number(row.cpuRatio, 2) : PageCell(),
                              PageCell::Number(row.createMs, 1),
                              PageCell::Number(row.medianMs, 3),
                              PageCell::Number(row.p99Ms, 3),
                              PageCell::Number(row.maxMs, 3),
                              PageCell::Number(s.broadPhase, 1),
                              PageCell::Number(s.narrowPhase, 1),
                              PageCell::Number(s.islands, 1),
                              PageCell::Number(s.solver, 1),
                              PageCell::Number(s.continuous, 1),
                              PageCell::Number(row.nsPerBodyStep),
                              PageCell::Number(row.peakContacts),
                              PageCell::Number(static_cast<double>(row.peakBytes) / 1e6, 2),
                              row.settings});
    }
    return table;
}

/// Of processor times, which other programs do not lengthen; of wall times where ours has several threads.
double FairRatio(const BenchRow& row) { return row.threads == 1 && row.cpuRatio > 0 ? row.cpuRatio : row.ratio; }

/// One line a row: what most readers want to know.
PageTable MakeSummary(std::span<const BenchRow> rows) {
    PageTable table{.title = "In short",
                    .caption =
                        "The ratio is the baseline's time over the row's: processor time with one thread, wall time "
                        "with several. Void ratios compare unlike work.",
                    .columns = {{.name = "scene"},
                                {.name = "size", .numeric = true},
                                {.name = "engine"},
                                {.name = "solver"},
                                {.name = "threads", .numeric = true},
                                {.name = "total", .unit = "ms", .numeric = true},
                                {.name = "quartiles", .unit = "ms"},
                                {.name = "ratio", .unit = "×", .numeric = true},
                                {.name = "void"}}};
    for (const BenchRow& row : rows) {
        PageCell ratio, total = PageCell::Number(row.totalMs, 1);
        if (!row.complete) total.text = "≥ " + total.text;
        if (!row.IsBaseline() && row.ratio > 0) {
            const double value = FairRatio(row);
            ratio = PageCell::Number(value, 2, value >= 1 ? PageTone::good : PageTone::bad);
            if (!row.voidReason.empty()) ratio.tone = PageTone::warning;
        }
        table.rows.push_back({row.scene, PageCell::Number(row.size),
                              row.GetName() + (row.continuous ? ", continuous" : ""), row.solver,
                              PageCell::Number(row.threads), total,
                              fmt::format("{:.1f} … {:.1f}", row.totalLowMs, row.totalHighMs), ratio, row.voidReason});
    }
    return table;
}

PageTable MakeTargetsTable(std::span<const TargetResult> targets) {
    PageTable table{.columns = {{.name = "verdict"},
                                {.name = "target"},
                                {.name = "scene"},
                                {.name = "measured", .numeric = true},
                                {.name = "needed", .numeric = true},
                                {.name = "setting"}},
                    .filter = true};
    for (const TargetResult& t : targets) {
        constexpr const char* names[] = {"met", "missed", "void", "not measured"};
        constexpr PageTone tones[] = {PageTone::good, PageTone::bad, PageTone::warning, PageTone::muted};
        const auto verdict = static_cast<std::size_t>(t.verdict);
        PageCell name(names[verdict]);
        name.tone = tones[verdict];
        PageCell needed = PageCell::Number(t.needed, 3);
        needed.text = (t.atLeast ? "≥ " : "≤ ") + needed.text;
        const bool isMeasured = t.needed != 0;
        table.rows.push_back({name, t.law, t.scene, isMeasured ? PageCell::Number(t.measured, 3) : PageCell(),
                              isMeasured ? needed : PageCell(), t.note});
    }
    return table;
}

/// What the time of each scene's largest size went into, a figure a scene: each has its own axis.
PageFigures MakeStageFigures(std::span<const BenchRow> rows) {
    PageFigures figures;
    std::vector<std::pair<std::string, int>> scenes;  // with the largest size
    for (const BenchRow& row : rows) {
        const auto found = std::ranges::find(scenes, row.scene, &std::pair<std::string, int>::first);
        if (found == scenes.end()) {
            scenes.emplace_back(row.scene, row.size);
        } else {
            found->second = std::max(found->second, row.size);
        }
    }
    for (const auto& [scene, size] : scenes) {
        StackedBars bars{.unit = "ms",
                         .parts = {"broad phase", "narrow phase", "islands", "solver", "continuous", "rest"},
                         .bars = {}};
        for (const BenchRow& row : rows) {
            if (row.scene != scene || row.size != size) continue;
            const StageTotals& s = row.stages;
            const double stages = s.broadPhase + s.narrowPhase + s.islands + s.solver + s.continuous;
            std::string label = row.GetName();
            if (row.GetName() == row.engine && !row.solver.empty()) label += " " + row.solver;
            if (row.threads > 1) label += fmt::format(", {} threads", row.threads);
            if (row.continuous) label += ", continuous";
            bars.bars.push_back(
                {label,
                 {s.broadPhase, s.narrowPhase, s.islands, s.solver, s.continuous, std::max(row.totalMs - stages, 0.0)},
                 !row.complete});
        }
        figures.figures.push_back({.title = fmt::format("{}, size {}: stages of all steps", scene, size),
                                   .svg = DrawStackedBars(bars),
                                   .alternative = fmt::format("Bars of the stages of {}, stacked", scene)});
    }
    return figures;
}

/// The rows of one engine under one solver that are not void.
struct RatiosOfPane {
    std::string name;
    double sum = 0;  ///< of logarithms
    int count = 0, faster = 0;
    const BenchRow* best = nullptr;
    const BenchRow* worst = nullptr;

    void Add(const BenchRow& row) {
        const double ratio = FairRatio(row);
        sum += std::log(ratio);
        ++count;
        faster += ratio >= 1;
        if (best == nullptr || ratio > FairRatio(*best)) best = &row;
        if (worst == nullptr || ratio < FairRatio(*worst)) worst = &row;
    }
};

/// What is rare in a row stands in its name.
std::string NameOfPane(const BenchRow& row) {
    return fmt::format("{} {}{}{}", row.GetName(), row.solver,
                       row.threads > 1 ? fmt::format(", {} threads", row.threads) : "",
                       row.continuous ? ", continuous" : "");
}

PageTiles MakeTiles(std::span<const BenchRow> rows) {
    std::vector<RatiosOfPane> panes;
    std::string rival;
    for (const BenchRow& row : rows) {
        if (row.IsBaseline()) rival = row.GetName();
        if (row.IsBaseline() || FairRatio(row) <= 0 || !row.voidReason.empty()) continue;
        const std::string name = NameOfPane(row);
        auto pane = std::ranges::find(panes, name, &RatiosOfPane::name);
        if (pane == panes.end()) pane = panes.insert(pane, {.name = name});
        pane->Add(row);
    }
    PageTiles tiles;
    for (const RatiosOfPane& pane : panes) {
        tiles.tiles.push_back(
            {pane.name, fmt::format("{:.2f}", std::exp(pane.sum / pane.count)), "×",
             fmt::format(
                 "as fast as {} on geometric mean, from {:.2f} in {} to {:.2f} in {}; faster in {} of {} rows that "
                 "are not void",
                 rival, FairRatio(*pane.worst), pane.worst->scene, FairRatio(*pane.best), pane.best->scene, pane.faster,
                 pane.count)});
    }
    return tiles;
}

}  // namespace

Page MakeBenchPage(const BenchReport& report) {
    Page page{.title = "Bench", .intro = "All engines run in one process, a slice of steps each in turn."};
    page.facts.push_back({"command", report.command});
    const PageTiles tiles = MakeTiles(report.rows);
    PageSection table{.title = "Times", .intro = report.notes, .blocks = {}};
    if (!tiles.tiles.empty()) table.blocks.emplace_back(tiles);
    table.blocks.emplace_back(MakeSummary(report.rows));
    page.sections.push_back(std::move(table));
    page.sections.push_back({.title = "All columns", .blocks = {MakeTable(report.rows)}, .folded = true});
    if (std::ranges::any_of(report.rows, WasBusy)) {
        page.sections.front().blocks.insert(
            page.sections.front().blocks.begin(),
            PageNote{
                "The machine had other work in this run: some totals are far above the processor's time. Trust the "
                "ratios of processor time.",
                PageTone::warning});
    }
    AddFacts(page, report.made);
    if (!report.targets.empty()) {
        page.sections.push_back({.title = "Targets", .blocks = {MakeTargetsTable(report.targets)}});
    }
    if (!report.rows.empty()) {
        page.sections.push_back(
            {.title = "Stages",
             .intro = "What the time went into. What belongs to no stage is the rest: calls, events, sleeping.",
             .blocks = {MakeStageFigures(report.rows)}});
    }
    if (!report.plots.empty()) {
        PageFigures figures;
        for (const std::filesystem::path& plot : report.plots) {
            figures.figures.push_back({.title = plot.stem().string(), .file = plot});
        }
        page.sections.push_back({.title = "Plots", .blocks = {figures}});
    }
    return page;
}

}  // namespace testbed
