// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of cores.h.

#include "testbed/jobs/bench/cores.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <functional>
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

/// One number of cores, or one thread: the least times of all repeats, by step.
struct Counted {
    int cores;
    std::vector<CountedStep> steps{};
};

void RunCounted(const scenes::Scene& scene, RunSpec spec, int steps, Counted& counted) {
    LoopMeter meter;
    spec.threads = counted.cores;
    const std::unique_ptr<InteractiveRun> run = MakeRun(scene, spec, {.loops = counted.cores > 1 ? &meter : nullptr});
    const bool isFirst = counted.steps.empty();
    if (isFirst) counted.steps.resize(static_cast<std::size_t>(steps));
    for (CountedStep& least : counted.steps) {
        meter.Begin();
        run->Step();
        const CountedStep times = SplitStep(run->GetTimes().step, meter.GetTimes());
        if (isFirst) {
            least = times;
        } else {
            least.TakeLeast(times);
        }
    }
}

CoresRow MeasureCase(const BenchCase& benchCase, const RunSpec& spec, const BenchEffort& effort,
                     const std::vector<int>& cores) {
    const scenes::Scene scene = benchCase.scene.Build();
    const int steps = effort.maxSteps > 0 ? std::min(effort.maxSteps, scene.steps) : scene.steps;
    std::vector<Counted> all{{1}};
    for (const int count : cores) all.push_back({count});
    for (int repeat = 0; repeat < effort.repeats; ++repeat) {
        for (Counted& counted : all) RunCounted(scene, spec, steps, counted);
    }
    const scenes::SceneCounts counts = scenes::Count(scene);
    CoresRow row{.scene = benchCase.scene.name,
                 .solver = PrintSettings(RunSpec{.solver = spec.solver}),
                 .size = benchCase.scene.size,
                 .steps = steps,
                 .movers = counts.kinematicBodies + counts.dynamicBodies};
    const auto sumOf = [](const Counted& counted, auto&& part) {
        return std::transform_reduce(counted.steps.begin(), counted.steps.end(), 0.0, std::plus(), part);
    };
    const auto most = std::ranges::max_element(all, {}, &Counted::cores);
    const double shared = sumOf(*most, [](const CountedStep& step) { return step.loops.GetWork(); });
    const double apart = sumOf(*most, [](const CountedStep& step) { return step.apart; });
    row.sharedPart = shared / (shared + apart);
    row.loops = sumOf(*most, [](const CountedStep& step) { return 1.0 * step.loops.CountLoops(); }) / steps;
    // The parts' least times lack more of what other programs took than the least times of whole steps.
    row.oneThreadMs = std::min(sumOf(all.front(), [](const CountedStep& step) { return step.apart; }), shared + apart);
    for (std::size_t i = 1; i < all.size(); ++i) {
        const auto predict = [&](const CountedStep& step) { return PredictStep(step, all[i].cores); };
        row.speedUps.push_back(row.oneThreadMs / sumOf(all[i], predict));
    }
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
                  "cores is what no loop has, each loop with its tasks dealt to the cores, and 1 µs for the end of "
                  "each loop. Tasks are dealt in order, each to the core that is free first; there are four for each "
                  "core. Contacts of large islands are solved in chains, each on a core of its own. A part of a chain "
                  "begins 0.1 µs after the parts of others that it follows on. Memory and caches that cores share are "
                  "not in this model."};
    AddFacts(page, command, ToJson(FindProvenance()));
    PageTable table{.caption =
                        "Shared: the part of a step that is in loops. Loops: how many of them a step has. Both are "
                        "those with the most cores. Times of steps and of tasks are the least of the repeats.",
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

CountedStep SplitStep(double stepMs, const LoopTimes& loops) { return {stepMs - loops.GetElapsed(), loops}; }

void CountedStep::TakeLeast(const CountedStep& other) {
    apart = std::min(apart, other.apart);
    loops.TakeLeast(other.loops);
}

double PredictStep(const CountedStep& step, int cores) {
    return step.apart + step.loops.GetSpan(cores) + barrierMs * step.loops.CountLoops();
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
