// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of cores.h.

#include "testbed/jobs/bench/cores.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <memory>
#include <numeric>

#include "testbed/base/errors.h"
#include "testbed/base/text.h"
#include "testbed/engines/engine_run.h"
#include "testbed/engines/provenance.h"
#include "testbed/page/facts.h"
#include "testbed/page/markdown.h"
#include "testbed/page/page.h"

namespace testbed {

namespace {

/// Times of the steps of one run, the least of all repeats.
class LeastTimes {
public:
    explicit LeastTimes(int steps)
        : m_times(static_cast<std::size_t>(steps), std::numeric_limits<double>::infinity()) {}

    void Note(int step, double ms) {
        double& least = m_times[static_cast<std::size_t>(step)];
        least = std::min(least, ms);
    }
    [[nodiscard]] double Sum() const { return std::accumulate(m_times.begin(), m_times.end(), 0.0); }

private:
    std::vector<double> m_times;
};

/// One number of cores, or one thread.
struct Counted {
    int cores;
    LeastTimes times;
    double stepMs = 0.0;  ///< of all steps of all repeats
    LoopTimes loops{};    ///< likewise
};

void RunCounted(const scenes::Scene& scene, RunSpec spec, int steps, Counted& counted) {
    LoopMeter meter;
    spec.threads = counted.cores;
    const std::unique_ptr<InteractiveRun> run = MakeRun(scene, spec, {.loops = counted.cores > 1 ? &meter : nullptr});
    for (int i = 0; i < steps; ++i) {
        meter.Begin();
        run->Step();
        const double ms = run->GetTimes().step;
        const LoopTimes& loops = meter.GetTimes();
        counted.times.Note(i, PredictStep(ms, loops));
        counted.stepMs += ms;
        counted.loops.loops += loops.loops;
        counted.loops.work += loops.work;
        counted.loops.span += loops.span;
    }
}

CoresRow MeasureCase(const BenchCase& benchCase, const RunSpec& spec, const BenchEffort& effort,
                     const std::vector<int>& cores) {
    const scenes::Scene scene = benchCase.scene.Build();
    const int steps = effort.maxSteps > 0 ? std::min(effort.maxSteps, scene.steps) : scene.steps;
    std::vector<Counted> all{{1, LeastTimes(steps)}};
    for (const int count : cores) all.push_back({count, LeastTimes(steps)});
    for (int repeat = 0; repeat < effort.repeats; ++repeat) {
        for (Counted& counted : all) RunCounted(scene, spec, steps, counted);
    }
    const scenes::SceneCounts counts = scenes::Count(scene);
    CoresRow row{.scene = benchCase.scene.name,
                 .solver = PrintSettings(RunSpec{.solver = spec.solver}),
                 .size = benchCase.scene.size,
                 .steps = steps,
                 .movers = counts.kinematicBodies + counts.dynamicBodies};
    row.oneThreadMs = all.front().times.Sum();
    const auto most = std::ranges::max_element(all, {}, &Counted::cores);
    row.sharedPart = most->loops.work / most->stepMs;
    row.loops = static_cast<double>(most->loops.loops) / (steps * effort.repeats);
    for (std::size_t i = 1; i < all.size(); ++i) row.speedUps.push_back(row.oneThreadMs / all[i].times.Sum());
    return row;
}

std::string FormatHeader(const std::vector<int>& cores) {
    std::string line = fmt::format("{:<21}{:>8}{:>8} {:<16}{:>12}{:>9}{:>8}", "scene", "size", "movers", "solver",
                                   "1 thread ms", "shared", "loops");
    for (const int count : cores) line += fmt::format("{:>10}", fmt::format("{} cores", count));
    return line + "\n";
}

std::string FormatRow(const CoresRow& row) {
    std::string line = fmt::format("{:<21}{:>8}{:>8} {:<16}{:>12.1f}{:>9.2f}{:>8.1f}", row.scene, row.size, row.movers,
                                   row.solver, row.oneThreadMs, row.sharedPart, row.loops);
    for (const double speedUp : row.speedUps) line += fmt::format("{:>9.2f}x", speedUp);
    return line + "\n";
}

Page MakeCoresPage(const std::vector<CoresRow>& rows, const std::vector<int>& cores, const std::string& command) {
    Page page{.title = "Many cores",
              .intro =
                  "How many times as fast steps of our engine would be on more cores than the machine has. It is "
                  "counted, not measured: every task of a step runs and is timed on one thread.\n\nThe time with N "
                  "cores is what no loop has, the longest task of each loop, and 1 µs for the end of each loop. "
                  "Memory and caches that cores share are not in this model."};
    AddFacts(page, command, ToJson(FindProvenance()));
    PageTable table{.caption =
                        "Shared: the part of a step that is in loops. Loops: how many of them a step has. Both are "
                        "those with the most cores. Times of a step are the least of the repeats.",
                    .columns = {{.name = "scene"},
                                {.name = "size", .numeric = true},
                                {.name = "movers", .numeric = true},
                                {.name = "solver"},
                                {.name = "one thread", .unit = "ms", .numeric = true},
                                {.name = "shared", .numeric = true},
                                {.name = "loops", .numeric = true}}};
    for (const int count : cores)
        table.columns.push_back({.name = fmt::format("{} cores", count), .unit = "×", .numeric = true});
    for (const CoresRow& row : rows) {
        std::vector<PageCell> cells{row.scene,
                                    PageCell::Number(row.size),
                                    PageCell::Number(row.movers),
                                    row.solver,
                                    PageCell::Number(row.oneThreadMs, 1),
                                    PageCell::Number(row.sharedPart, 2),
                                    PageCell::Number(row.loops, 1)};
        for (const double speedUp : row.speedUps) cells.push_back(PageCell::Number(speedUp, 2));
        table.rows.push_back(cells);
    }
    page.sections.push_back({.title = "Speed-ups", .blocks = {table}});
    return page;
}

/// Checks what was typed.
std::vector<int> ParseCores(const std::string& text) {
    std::vector<int> cores = ParseIntList("--cores", text, "numbers of cores with commas, for example 2,8,16");
    for (const int count : cores) {
        if (count < 2 || count > maxThreads)
            throw UsageError(fmt::format("--cores {}: legal from 2 to {}", count, maxThreads));
    }
    return cores;
}

}  // namespace

double PredictStep(double stepMs, const LoopTimes& loops) {
    return stepMs - loops.work + loops.span + barrierMs * loops.loops;
}

std::vector<CoresRow> MeasureCores(const BenchPlan& plan, const std::vector<int>& cores) {
    std::vector<CoresRow> rows;
    for (const BenchCase& benchCase : plan.cases) {
        for (const Pane& pane : benchCase.panes) {
            if (pane.spec.engine != "scree") continue;
            rows.push_back(MeasureCase(benchCase, pane.spec, plan.effort, cores));
            fmt::print("{}", FormatRow(rows.back()));
            std::fflush(stdout);
        }
    }
    return rows;
}

int RunCores(const BenchArguments& arguments, const Request& request) {
    if (arguments.targets || !arguments.against.empty() || !arguments.from.empty() || !arguments.csv.empty() ||
        !arguments.plots.empty() || !arguments.threads.empty()) {
        throw UsageError("--cores takes none of --targets, --against, --from, --csv, --plots, --threads");
    }
    const std::vector<int> cores = ParseCores(arguments.cores);
    BenchArguments ours = arguments;
    if (ours.settings.engines == SettingArguments().engines) ours.settings.engines = "scree";
    const BenchPlan plan = MakeBenchPlan(ours);
    fmt::print("{}", FormatHeader(cores));
    const std::vector<CoresRow> rows = MeasureCores(plan, cores);
    if (!arguments.markdown.empty())
        WriteMarkdown(arguments.markdown, MakeCoresPage(rows, cores, DescribeCommand(request.arguments)));
    return exitDone;
}

}  // namespace testbed
