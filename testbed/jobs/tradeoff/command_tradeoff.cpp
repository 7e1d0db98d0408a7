// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree tradeoff`: laws of mechanics under every setting of every engine, error against cost.

#include <fmt/format.h>

#include <cstdio>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "testbed/base/case_lines.h"
#include "testbed/base/errors.h"
#include "testbed/base/filter.h"
#include "testbed/base/json_lines.h"
#include "testbed/base/output.h"
#include "testbed/base/progress.h"
#include "testbed/base/shard.h"
#include "testbed/engines/provenance.h"
#include "testbed/jobs/tradeoff/commands.h"
#include "testbed/jobs/tradeoff/report.h"
#include "testbed/options/options.h"
#include "testbed/options/scene_input.h"
#include "testbed/page/facts.h"
#include "testbed/page/gnuplot.h"
#include "testbed/page/markdown.h"

namespace testbed {

namespace {

struct TradeArguments {
    bool quick = false;
    bool count = false;
    std::string filter;
    std::string from;
    std::string markdown;
    std::string output = "out/tradeoff";
    std::vector<std::string> scenes;  ///< in place of the laws
    std::optional<int> size;
    std::optional<double> seconds;  ///< of each scene; none: GetSceneSeconds
    InputArguments input;
    SettingArguments settings{.engines = ""};
    ShardArguments shard;
};

/// Laws whose name the expression finds. Throws UsageError for a bad one and for one that finds none.
std::vector<const Law*> ChooseLaws(const std::string& filter) {
    std::vector<const Law*> chosen;
    const std::regex expression = CompileFilter(filter);
    for (const Law& law : GetLaws()) {
        if (std::regex_search(law.name, expression)) chosen.push_back(&law);
    }
    if (!chosen.empty()) return chosen;
    std::string names;
    for (const Law& law : GetLaws()) names += (names.empty() ? "" : ", ") + law.name;
    throw UsageError(fmt::format("-g '{}' finds no law; there are: {}", filter, names));
}

Effort GetEffort(const TradeArguments& arguments) { return arguments.quick ? Effort::quick : Effort::full; }

std::vector<RunSpec> ChooseGrid(const TradeArguments& arguments) {
    return ChooseGrid(GetEffort(arguments), arguments.settings.engines, arguments.settings.typed);
}

/// A scene of the user's, and what it is run with.
struct PlannedScene {
    scenes::Scene scene;
    std::vector<RunSpec> settings;
    std::string leftOut;
    double seconds = 0.0;
};

/// In place of the laws where scenes were given. Throws UsageError and FileError.
std::vector<PlannedScene> ChooseScenes(const TradeArguments& arguments) {
    if (arguments.scenes.empty()) {
        if (arguments.size) throw UsageError("--size: it is the size of a SCENE, and none was given");
        if (arguments.seconds) throw UsageError("--seconds: laws have their own times; give a SCENE");
        return {};
    }
    if (!arguments.filter.empty()) throw UsageError("-g chooses laws, and none runs where a SCENE is given");
    if (!arguments.from.empty()) throw UsageError("--from measures nothing; leave SCENE out");
    if (arguments.seconds && !(*arguments.seconds >= leastSceneSeconds && *arguments.seconds <= mostSceneSeconds)) {
        throw UsageError(
            fmt::format("--seconds {}: from {} to {}", *arguments.seconds, leastSceneSeconds, mostSceneSeconds));
    }
    std::vector<PlannedScene> planned;
    const std::vector<RunSpec> grid = ChooseGrid(arguments);
    for (const SceneInput& input : ChooseScenes(arguments.scenes, arguments.size, arguments.input)) {
        PlannedScene one{.scene = input.Build(), .settings = {}, .leftOut = {}};
        one.scene.name = input.name;
        one.settings = ChooseForScene(one.scene, grid, one.leftOut);
        one.seconds = arguments.seconds.value_or(GetSceneSeconds(one.scene, GetEffort(arguments)));
        planned.push_back(std::move(one));
    }
    return planned;
}

TradePlan MakePlan(const TradeArguments& arguments) {
    return {.effort = GetEffort(arguments), .repeats = arguments.quick ? 3 : 9};
}

/// Runs the shard's cases of scenes and notes each as a line.
void MeasureScenes(const TradeArguments& arguments, std::span<const PlannedScene> scenes, CaseLines& lines) {
    const TradePlan plan = MakePlan(arguments);
    const Shard shard = ParseShard(arguments.shard.shard);
    std::size_t number = 0;
    for (const PlannedScene& one : scenes) {
        std::vector<bool> isWanted;
        std::vector<std::size_t> numbers;
        for (std::size_t i = 0; i < one.settings.size(); ++i, ++number) {
            isWanted.push_back(shard.Contains(number) && !lines.Has(number));
            if (isWanted.back()) numbers.push_back(number);
        }
        if (numbers.empty()) continue;
        Progress progress(one.scene.name, CountSceneWork(one.settings, isWanted, plan, one.seconds));
        const std::vector<TradeCase> cases = MeasureScene(one.scene, one.settings, isWanted, plan, one.seconds,
                                                          one.leftOut, [&](double work) { progress.Advance(work); });
        progress.Finish(fmt::format("{} settings", cases.size()));
        for (std::size_t i = 0; i < cases.size(); ++i) lines.Add(numbers[i], ToJson(cases[i]));
    }
}

/// Runs the shard's cases of laws and notes each as a line.
void MeasureLaws(const TradeArguments& arguments, CaseLines& lines) {
    const TradePlan plan = MakePlan(arguments);
    const std::vector<RunSpec> grid = ChooseGrid(arguments);
    const Shard shard = ParseShard(arguments.shard.shard);
    std::size_t number = 0;
    for (const Law* law : ChooseLaws(arguments.filter)) {
        std::vector<RunSpec> settings;
        std::vector<std::size_t> numbers;
        for (const RunSpec& setting : grid) {
            if (shard.Contains(number) && !lines.Has(number)) {
                settings.push_back(setting);
                numbers.push_back(number);
            }
            ++number;
        }
        if (settings.empty()) continue;
        Progress progress(law->name, static_cast<double>(settings.size()) * (1 + plan.repeats));
        const std::vector<TradeCase> cases = MeasureTrade(*law, settings, plan, [&] { progress.Advance(1.0); });
        progress.Finish(fmt::format("{} settings", cases.size()));
        for (std::size_t i = 0; i < cases.size(); ++i) lines.Add(numbers[i], ToJson(cases[i]));
    }
}

/// Runs what is to be measured, and returns it with what was there before.
std::vector<TradeCase> MeasureAll(const TradeArguments& arguments, std::span<const PlannedScene> scenes,
                                  CaseLines& lines) {
    if (scenes.empty()) {
        MeasureLaws(arguments, lines);
    } else {
        MeasureScenes(arguments, scenes, lines);
    }
    std::vector<TradeCase> all;
    ParseJsonLines("--resume", lines.GetText(), "tradeoff",
                   [&](const auto& fields) { AddCase(all, TradeCaseFromJson(fields)); });
    return all;
}

/// The cases of a file that --json or `scree merge` wrote.
std::vector<TradeCase> ReadCases(const std::string& file, std::vector<nlohmann::ordered_json>& made) {
    std::vector<TradeCase> cases;
    made = ReadCaseLines(file, "tradeoff", [&](const auto& fields) { AddCase(cases, TradeCaseFromJson(fields)); });
    return cases;
}

void WriteReport(OutputFolder& output, std::span<const TradeCase> cases, std::span<const nlohmann::ordered_json> made,
                 const std::string& command, const std::string& markdown) {
    output.WriteText("cases.csv", MakeTradeCsv(cases));
    output.WriteText("bounds.csv", MakeBoundsCsv(cases));
    std::filesystem::path plots;
    for (const Law* law : LawsOf(cases)) {
        const std::filesystem::path relative = std::filesystem::path("plots") / (law->name + ".svg");
        output.WriteBy(relative,
                       [&](const std::filesystem::path& place) { DrawPlot(MakeTradePlot(*law, cases), "svg", place); });
        plots = output.Prepare(relative).parent_path();
    }
    Page page = MakeTradePage(cases, plots, command);
    AddFacts(page, made);
    output.WriteText("index.html", MakePage(page));
    if (!markdown.empty()) WriteMarkdown(markdown, page);
}

int RunTradeoff(const TradeArguments& arguments, const Request& request) {
    const std::vector<PlannedScene> scenes = ChooseScenes(arguments);
    const std::size_t settings = ChooseGrid(arguments).size();
    std::size_t count = 0;
    for (const PlannedScene& one : scenes) count += one.settings.size();
    if (scenes.empty()) count = ChooseLaws(arguments.filter).size() * settings;
    const Shard shard = ParseShard(arguments.shard.shard);
    if (!scenes.empty()) {
        fmt::print("{} cases: {} scene{}, {} settings\n", count, scenes.size(), scenes.size() == 1 ? "" : "s",
                   settings);
    } else if (arguments.from.empty()) {
        fmt::print("{} cases: {} laws, {} settings\n", count, ChooseLaws(arguments.filter).size(), settings);
    }
    std::fflush(stdout);
    if (arguments.count) return exitDone;
    CheckGnuplot();
    OutputFolder output(arguments.output);
    std::vector<nlohmann::ordered_json> made{ToJson(FindProvenance())};
    CaseLines lines("tradeoff", count, made.front());
    CheckResume(arguments.shard);
    if (arguments.from.empty()) lines.Keep(arguments.shard.json, arguments.shard.resume);
    const std::vector<TradeCase> cases =
        arguments.from.empty() ? MeasureAll(arguments, scenes, lines) : ReadCases(arguments.from, made);
    lines.Finish();
    if (shard.count > 1) {
        output.WriteText(fmt::format("cases-{}-of-{}.csv", shard.index, shard.count), MakeTradeCsv(cases));
        fmt::print("shard {} of {}: {} cases; join the --json files with `scree merge` and give them to --from\n",
                   shard.index, shard.count, cases.size());
        return exitDone;
    }
    WriteReport(output, cases, made, DescribeCommand(request.arguments), arguments.markdown);
    fmt::print("{}", FormatTrade(cases));
    for (const std::string& file : output.GetFiles()) {
        if (!file.ends_with(".svg")) fmt::print("{}\n", file);
    }
    return HasMiss(CheckBounds(cases)) ? exitDiffers : exitDone;
}

}  // namespace

void AddTradeoffCommand(CLI::App& app, Request& request) {
    CLI::App* command =
        app.add_subcommand("tradeoff", "Speed against accuracy: laws of mechanics, or your scene, in every engine");
    command->footer("Exits with 1 when a bound of the dial was missed.");
    auto arguments = std::make_shared<TradeArguments>();
    command->add_option("SCENE", arguments->scenes,
                        DescribeSceneArgument("Scenes in place of the laws, measured against finer runs"));
    command->add_option("--size", arguments->size, "Size of a scene that `scree list` shows; its default if not given");
    command
        ->add_option("--seconds", arguments->seconds,
                     "Simulated time of each scene; its whole run if not given, at most 4 s, with --quick 2 s")
        ->type_name("S");
    AddFormatOption(*command, arguments->input);
    command->add_flag("--quick", arguments->quick, "Fewer settings, repeats and runs of each law");
    command->add_flag("--count", arguments->count, "Only print the number of cases");
    command->add_option("-g,--only", arguments->filter, "Only the laws whose name matches this regular expression")
        ->type_name("REGEX");
    command->add_option("--from", arguments->from, "Measure nothing; make the report of a file that --json wrote")
        ->type_name("FILE");
    command->add_option("-o,--output", arguments->output, "Folder for the report")
        ->type_name("DIR")
        ->capture_default_str();
    AddMarkdownOption(*command, arguments->markdown);
    AddSetOption(*command, arguments->settings,
                 "Applied to all settings but Box2D's default, which they are compared with. A law about speed or "
                 "continuous collision keeps the caps it needs");
    AddEnginesOption(*command, arguments->settings,
                     "These settings instead of the grid; Box2D's default runs in any case");
    AddShardOptions(*command, arguments->shard);
    AddResumeOption(*command, arguments->shard);
    command->callback(
        [&request, arguments] { request.action = [&request, arguments] { return RunTradeoff(*arguments, request); }; });
}

}  // namespace testbed
