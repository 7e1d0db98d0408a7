// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree extremes`: every case under every setting in a process of its own, graded.

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <vector>

#include "testbed/base/case_lines.h"
#include "testbed/base/errors.h"
#include "testbed/base/filter.h"
#include "testbed/base/json_lines.h"
#include "testbed/base/json_print.h"
#include "testbed/base/nearest.h"
#include "testbed/base/output.h"
#include "testbed/base/progress.h"
#include "testbed/base/shard.h"
#include "testbed/engines/engine_list.h"
#include "testbed/engines/panes.h"
#include "testbed/engines/provenance.h"
#include "testbed/jobs/extremes/child.h"
#include "testbed/jobs/extremes/commands.h"
#include "testbed/jobs/extremes/report.h"
#include "testbed/jobs/extremes/run_case.h"
#include "testbed/options/options.h"
#include "testbed/page/facts.h"
#include "testbed/page/markdown.h"

namespace testbed {

namespace {

struct ExtremesArguments {
    bool quick = false, full = false, standing = false, list = false;
    std::string filter;
    std::string from;
    std::string markdown;
    std::string output = "out/extremes";
    double limit = 0.0;  ///< 0: by quick and full
    int jobs = 2;
    SettingArguments settings{.engines = ""};
    ShardArguments shard;
    std::string runCase, setting;  ///< internal: run this one here
};

/// What --standing stands for, where -g or --engines is not given: what must stand, at every mark, beside the others.
ExtremesArguments ChooseStanding(ExtremesArguments arguments) {
    if (arguments.filter.empty()) arguments.filter = "^(built flush|loads|loops|machines)$";
    if (arguments.settings.engines.empty()) {
        arguments.settings.engines =
            "game=scree:accuracy=game,fine=scree:accuracy=fine,precise=scree:accuracy=precise,"
            "tolerant=scree:tolerance=0.01,si=scree:solver=si@8/3,box2d";
        if (IsBuilt("box2d3")) arguments.settings.engines += ",box2d3:solver=soft@4";
    }
    return arguments;
}

/// The settings that every case runs under. A name begins with its engine's.
std::vector<Pane> ChooseSettings(const SettingArguments& arguments) {
    const bool isOwnList = arguments.engines.empty();
    std::string all = "box2d,scree,soft=scree:solver=soft@4";
    if (IsBuilt("box2d3")) all += ",box2d3";
    std::vector<Pane> settings = ParsePanes(isOwnList ? all : arguments.engines, arguments.typed, "solver=si@8/3");
    for (Pane& pane : settings) {
        const bool isPlain = isOwnList || pane.name == pane.spec.engine;
        pane.name = pane.spec.engine + " " + (isPlain ? NameSolver(pane.spec) : pane.name);
    }
    return settings;
}

/// Cases whose name or group the expression finds; hidden ones only by their exact name.
std::vector<const ExtremeCase*> ChooseCases(const std::string& filter) {
    std::vector<const ExtremeCase*> chosen;
    const std::regex expression = CompileFilter(filter);
    for (const ExtremeCase& one : GetExtremeCases()) {
        const bool found = std::regex_search(one.name, expression) || std::regex_search(one.group, expression);
        if (one.hidden ? one.name == filter : found) chosen.push_back(&one);
    }
    if (chosen.empty()) {
        throw UsageError(fmt::format("-g '{}' finds no case; `scree extremes --list` shows all", filter));
    }
    return chosen;
}

struct Job {
    const ExtremeCase* one;
    std::string setting;
    std::size_t number;
};

double FindLimit(const ExtremesArguments& arguments) {
    if (arguments.limit > 0.0) return arguments.limit;
    return arguments.full ? 60.0 : arguments.quick ? 5.0 : 10.0;
}

/// In the child: runs the case and tells the outcome and the picture on stdout.
int RunOneHere(const ExtremesArguments& arguments) {
    const auto one = std::ranges::find(GetExtremeCases(), arguments.runCase, &ExtremeCase::name);
    const std::vector<Pane> settings = ChooseSettings(arguments.settings);
    const auto setting = std::ranges::find(settings, arguments.setting, &Pane::name);
    if (one == GetExtremeCases().end() || setting == settings.end()) {
        throw UsageError(fmt::format("no such case and setting: '{}', '{}'", arguments.runCase, arguments.setting));
    }
    const double limit = FindLimit(arguments);
    LimitThisProcess(limit);
    // A long case cuts itself short, so that only one that hangs in a step meets the limit.
    const CaseBudget budget{.quick = arguments.quick, .cpuSeconds = (arguments.quick ? 0.2 : 0.7) * limit};
    const CaseRun run = RunCase(*one, setting->spec, budget);
    nlohmann::ordered_json told;
    told["outcome"] = ToJson(run.outcome);
    told["picture"] = run.picture;
    fmt::print("{}\n", PrintJson(told));
    return exitDone;
}

ExtremeResult JudgeEnd(const Job& job, ChildEnd end, std::string& picture) {
    ExtremeResult result{
        .name = job.one->name, .setting = job.setting, .ending = end.ending, .outcome = {}, .verdict = {}};
    const auto told = nlohmann::ordered_json::parse(end.output, nullptr, false);
    if (told.is_object() && told.contains("outcome")) {
        result.outcome = OutcomeFromJson(told["outcome"]);
        picture = told.value("picture", "");
    } else {
        result.ending.output = false;
    }
    result.verdict = GradeCase(*job.one, result.ending, result.outcome);
    if (result.verdict.grade == Grade::abort && !end.words.empty()) {
        // Assertions name the engine's source with the folder it was built in.
        const std::size_t folder = end.words.rfind('/');
        result.verdict.reasons.push_back(folder == std::string::npos ? end.words : end.words.substr(folder + 1));
        result.outcome.note = result.verdict.reasons.back();
    }
    return result;
}

std::vector<ExtremeResult> RunAll(const ExtremesArguments& arguments, std::span<const Job> jobs, CaseLines& lines,
                                  std::map<std::string, std::string>& pictures) {
    const double limit = FindLimit(arguments);
    std::vector<ChildJob> children;
    for (const Job& job : jobs) {
        ChildJob child{.arguments = {"extremes", "--run-case", job.one->name, "--setting", job.setting, "--limit",
                                     fmt::format("{}", limit)},
                       // Waiting counts here, and a busy machine makes everything wait.
                       .wallSeconds = 10.0 * limit};
        if (arguments.quick) child.arguments.emplace_back("--quick");
        for (const TypedSetting& one : arguments.settings.typed) {
            child.arguments.insert(child.arguments.end(), {"--set", one.setting});
        }
        if (!arguments.settings.engines.empty()) {
            child.arguments.insert(child.arguments.end(), {"--engines", arguments.settings.engines});
        }
        children.push_back(child);
    }
    Progress progress("extremes", static_cast<double>(std::max<std::size_t>(1, jobs.size())));
    RunChildren(children, arguments.jobs, [&](std::size_t i, const ChildEnd& end) {
        std::string picture;
        const ExtremeResult result = JudgeEnd(jobs[i], end, picture);
        lines.Add(jobs[i].number, ToJson(result));
        if (!picture.empty()) pictures[result.name + "/" + result.setting] = picture;
        progress.Advance(1.0);
    });
    progress.Finish(fmt::format("{} runs", jobs.size()));
    std::vector<ExtremeResult> results;
    ParseJsonLines("--resume", lines.GetText(), "extremes",
                   [&](const auto& fields) { results.push_back(ExtremeResultFromJson(fields)); });
    return results;
}

std::vector<ExtremeResult> ReadResults(const std::string& file, std::vector<nlohmann::ordered_json>& made) {
    std::vector<ExtremeResult> results;
    made =
        ReadCaseLines(file, "extremes", [&](const auto& fields) { results.push_back(ExtremeResultFromJson(fields)); });
    return results;
}

void PrintCases(std::span<const ExtremeCase* const> cases) {
    for (const ExtremeCase* one : cases) fmt::print("{:24} {:22} {}\n", one->name, one->group, one->what);
}

int RunExtremes(const ExtremesArguments& typed, const Request& request) {
    const ExtremesArguments arguments = typed.standing ? ChooseStanding(typed) : typed;
    if (!arguments.runCase.empty()) return RunOneHere(arguments);
    if (arguments.quick && arguments.full) throw UsageError("--quick and --full exclude each other");
    const std::vector<const ExtremeCase*> cases = ChooseCases(arguments.filter);
    if (arguments.list) {
        PrintCases(cases);
        return exitDone;
    }
    const std::vector<Pane> settings = ChooseSettings(arguments.settings);
    const Shard shard = ParseShard(arguments.shard.shard);
    std::vector<Job> jobs;
    std::size_t number = 0;
    for (const ExtremeCase* one : cases) {
        for (const Pane& setting : settings) {
            if (one->abuse && !CanAbuse(setting.spec.engine)) continue;
            if (shard.Contains(number)) jobs.push_back({one, setting.name, number});
            ++number;
        }
    }
    if (arguments.from.empty()) {
        fmt::print("{} runs: {} cases, {} settings\n", number, cases.size(), settings.size());
        std::fflush(stdout);
    }
    OutputFolder output(arguments.output);
    std::vector<nlohmann::ordered_json> made{ToJson(FindProvenance())};
    std::map<std::string, std::string> pictures;
    CaseLines lines("extremes", number, made.front());
    CheckResume(arguments.shard);
    if (arguments.from.empty()) lines.Keep(arguments.shard.json, arguments.shard.resume);
    std::erase_if(jobs, [&](const Job& job) { return lines.Has(job.number); });
    const std::vector<ExtremeResult> results =
        arguments.from.empty() ? RunAll(arguments, jobs, lines, pictures) : ReadResults(arguments.from, made);
    lines.Finish();
    output.WriteText("cases.csv", MakeExtremesCsv(results));
    Page page = MakeExtremesPage(results, pictures, DescribeCommand(request.arguments));
    AddFacts(page, made);
    output.WriteText("index.html", MakePage(page));
    if (!arguments.markdown.empty()) WriteMarkdown(arguments.markdown, page);
    fmt::print("{}", FormatExtremes(results));
    for (const std::string& file : output.GetFiles()) fmt::print("{}\n", file);
    const auto breaks = [](const ExtremeResult& r) {
        return r.setting.starts_with("scree") &&
               (r.verdict.grade == Grade::abort || r.verdict.grade == Grade::nonFinite);
    };
    return std::ranges::any_of(results, breaks) ? exitDiffers : exitDone;
}

}  // namespace

void AddExtremesCommand(CLI::App& app, Request& request) {
    CLI::App* command = app.add_subcommand("extremes", "Stability at the extremes: cases graded in every engine");
    auto arguments = std::make_shared<ExtremesArguments>();
    command->add_flag("--quick", arguments->quick, "Shorter runs, at most 5 s of processor time each");
    command->add_flag("--full", arguments->full, "At most 60 s of processor time each instead of 10");
    command->add_flag("--standing", arguments->standing,
                      "What must stand, at which setting: the groups built flush, loads, loops and machines, at every "
                      "mark of our engine, at its 8/3, and in the others; -g and --engines replace their part");
    command->add_flag("--list", arguments->list, "Only show the cases");
    command
        ->add_option("-g,--only", arguments->filter,
                     "Only the cases whose name or group matches this regular expression")
        ->type_name("REGEX");
    command
        ->add_option("--limit", arguments->limit,
                     "Limit of processor time per run, s; 10 if not given, 5 with --quick, 60 with --full")
        ->check(AboveZero());
    command->add_option("--jobs", arguments->jobs, "Number of runs at the same time")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    command
        ->add_option("--from", arguments->from, "Run nothing; make the report of a file that --json wrote, no pictures")
        ->type_name("FILE");
    command->add_option("-o,--output", arguments->output, "Folder for the report")
        ->type_name("DIR")
        ->capture_default_str();
    AddMarkdownOption(*command, arguments->markdown);
    AddSetOption(*command, arguments->settings, "Applied in all engines. A case keeps the settings that it is about");
    AddEnginesOption(*command, arguments->settings,
                     "Instead of box2d 8/3, scree 8/3, scree soft 4 and, where it is built in, box2d3 soft 4");
    AddShardOptions(*command, arguments->shard);
    AddResumeOption(*command, arguments->shard);
    command->footer("Exits with 1 when our engine aborts, hangs or goes non-finite in a case.");
    command->add_option("--run-case", arguments->runCase)->group("");
    command->add_option("--setting", arguments->setting)->group("");
    command->callback(
        [&request, arguments] { request.action = [&request, arguments] { return RunExtremes(*arguments, request); }; });
}

}  // namespace testbed
