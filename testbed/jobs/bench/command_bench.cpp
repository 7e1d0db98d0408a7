// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree bench`: scenes timed in every engine, interleaved in one process; totals, single steps, stages, memory.

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "testbed/base/case_lines.h"
#include "testbed/base/errors.h"
#include "testbed/base/memory.h"
#include "testbed/base/output.h"
#include "testbed/base/process.h"
#include "testbed/base/progress.h"
#include "testbed/engines/engine_list.h"
#include "testbed/engines/provenance.h"
#include "testbed/jobs/bench/against.h"
#include "testbed/jobs/bench/commands.h"
#include "testbed/jobs/bench/cores.h"
#include "testbed/jobs/bench/files.h"
#include "testbed/jobs/bench/games.h"
#include "testbed/jobs/bench/object_bytes.h"
#include "testbed/jobs/bench/plan.h"
#include "testbed/jobs/bench/run.h"
#include "testbed/jobs/bench/table.h"
#include "testbed/jobs/bench/targets.h"
#include "testbed/options/options.h"
#include "testbed/page/markdown.h"

namespace testbed {

namespace {

BenchResult RunOne(const BenchCase& benchCase, const BenchEffort& effort) {
    const int steps = effort.maxSteps > 0 ? std::min(effort.maxSteps, benchCase.scene.steps) : benchCase.scene.steps;
    Progress progress(fmt::format("{} {}", benchCase.scene.name, benchCase.scene.size),
                      static_cast<double>(steps) * effort.repeats * static_cast<double>(benchCase.panes.size()));
    BenchResult result = RunBenchCase(benchCase, effort, [&](int count) { progress.Advance(count); });
    progress.Finish(fmt::format("{} steps", result.rows.front().steps));
    return result;
}

void Print(const std::string& text) {
    fmt::print("{}", text);
    std::fflush(stdout);
}

/// Runs the shard's cases, printing each as it is done.
void RunCases(const BenchPlan& plan, BenchFiles& files, CaseLines& lines) {
    Print(FormatBenchHeader());
    if (const std::vector<BenchRow> before = ReadBenchRows("--resume", lines.GetText()); !before.empty()) {
        Print(FormatBenchRows(before));
        files.Add({before, {}});
    }
    for (std::size_t i = 0; i < plan.cases.size(); ++i) {
        if (!plan.shard.Contains(i) || lines.Has(i)) continue;
        const BenchResult result = RunOne(plan.cases[i], plan.effort);
        Print(FormatBenchRows(result.rows));
        for (const BenchRow& row : result.rows) lines.Add(i, MakeBenchJson(row));
        files.Add(result);
    }
}

/// Other processes that keep cores busy, until they go.
class Neighbours {
public:
    explicit Neighbours(int count) {
        for (int i = 0; i < count; ++i) {
            const std::error_code error = m_processes.emplace_back().Fork([]() -> int {
                const volatile bool goesOn = true;
                while (goesOn) {
                }
                return 0;
            });
            if (!error) continue;
            KillAll();  // they would be waited for, and never end by themselves
            throw std::system_error(error, fmt::format("--neighbours: cannot start process {}", i + 1));
        }
    }
    Neighbours(const Neighbours&) = delete;
    Neighbours& operator=(const Neighbours&) = delete;
    ~Neighbours() { KillAll(); }

private:
    void KillAll() {
        for (Process& process : m_processes) process.Kill();
    }

    std::vector<Process> m_processes;
};

/// Of every engine that runs.
std::string DescribeBytes(const BenchPlan& plan) {
    std::string text;
    for (const EngineInfo& engine : GetEngines()) {
        const auto& panes = plan.cases.front().panes;
        const bool runs = std::ranges::any_of(panes, [&](const Pane& pane) { return pane.spec.engine == engine.name; });
        if (runs) text += FormatObjectBytes(engine.name, MeasureObjectBytes(engine.name));
    }
    return text;
}

int CompareBuilds(const BenchArguments& arguments, const Request& request) {
    const AgainstPlan plan = MakeAgainstPlan(arguments);
    std::optional<OutputFolder> folder;
    if (!arguments.output.empty()) folder.emplace(arguments.output);
    const AgainstResult result = RunAgainst(plan);
    Print(FormatAgainst(result));
    const Page page = MakeAgainstPage(result, DescribeCommand(request.arguments));
    if (folder) {
        folder->WriteText("index.html", MakePage(page));
        Print(FormatFiles(folder->GetFiles()));
    }
    if (!arguments.markdown.empty()) WriteMarkdown(arguments.markdown, page);
    const auto isSlower = [&](const AgainstRow& row) { return IsSlower(row, arguments.atLeast); };
    return std::ranges::any_of(result.rows, isSlower) ? exitDiffers : exitDone;
}

int RunBench(const BenchArguments& arguments, const Request& request) {
    KeepFreedMemory();
    CheckNeighbours(arguments);
    const Neighbours neighbours(arguments.neighbours);
    if (arguments.games) return RunGames(arguments, request);
    if (!arguments.cores.empty()) return RunCores(arguments, request);
    if (!arguments.against.empty()) return CompareBuilds(arguments, request);
    const BenchPlan plan = MakeBenchPlan(arguments);
    BenchFiles files({.csv = arguments.csv, .plots = arguments.plots, .output = arguments.output});
    std::vector<nlohmann::ordered_json> made{ToJson(FindProvenance())};
    CaseLines lines("bench", plan.cases.size(), made.front());
    CheckResume(arguments.shard);
    if (arguments.from.empty()) lines.Keep(arguments.shard.json, arguments.shard.resume);
    std::string notes = FormatBenchNotes();
    if (arguments.from.empty()) {
        RunCases(plan, files, lines);
        if (plan.shard.IsFirst()) notes += DescribeBytes(plan);
    } else {
        MergedLines merged = ReadCaseText(arguments.from, "bench");
        const std::vector<BenchRow> rows = ReadBenchRows(arguments.from, merged.text);
        made = std::move(merged.made);
        Print(FormatBenchHeader() + FormatBenchRows(rows));
        files.Add({rows, {}});
    }
    Print(notes);
    std::vector<TargetResult> targets;
    if (arguments.targets) {
        targets = JudgeTargets(files.GetRows());
        Print(FormatTargets(targets));
    }
    lines.Finish();
    const BenchReport report{DescribeCommand(request.arguments), files.GetRows(), targets, {}, notes, made};
    Print(files.Write(report));
    if (!arguments.markdown.empty()) WriteMarkdown(arguments.markdown, MakeBenchPage(report));
    return HasMiss(targets) ? exitDiffers : exitDone;
}

}  // namespace

void AddBenchCommand(CLI::App& app, Request& request) {
    CLI::App* command = app.add_subcommand("bench", "Times of whole runs, single steps and stages in every engine");
    auto arguments = std::make_shared<BenchArguments>();
    AddBenchOptions(*command, *arguments);
    command->callback(
        [&request, arguments] { request.action = [&request, arguments] { return RunBench(*arguments, request); }; });
}

}  // namespace testbed
