// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of plan.h.

#include "testbed/jobs/bench/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "testbed/base/text.h"
#include "testbed/jobs/bench/against.h"
#include "testbed/jobs/bench/targets.h"
#include "testbed/options/options.h"

namespace testbed {

namespace {

constexpr int maxRepeats = 1000;

/// `count` of the published sizes, as evenly spread as they lie, the largest among them; 0: all.
std::vector<int> PickSizes(const scenes::Sweep& sweep, int count) {
    const int published = (sweep.end - sweep.begin) / sweep.increment + 1;
    const int picked = count == 0 ? published : std::min(count, published);
    std::vector<int> sizes;
    for (int i = 1; i <= picked; ++i) {
        const int number = (published * i + picked - 1) / picked;  // from 1
        sizes.push_back(sweep.begin + (number - 1) * sweep.increment);
    }
    return sizes;
}

/// The count of "sweep" (0: all) and "sweep@COUNT"; none for other texts. Throws UsageError.
std::optional<int> ReadSweep(std::string_view text) {
    constexpr std::string_view all = "sweep", some = "sweep@";
    if (text == all) return 0;
    if (!text.starts_with(some)) return std::nullopt;
    const Parsed<int> count = ParseNumber<int>(text.substr(some.size()));
    if (!count || *count < 1)
        throw UsageError(fmt::format("--sizes {}: after @ comes a number of sizes, 1 or more", text));
    return *count;
}

/// A scene at every size that is asked for. Throws UsageError.
std::vector<SceneInput> ChooseSizes(const std::string& given, const BenchArguments& arguments) {
    const std::string& text = arguments.sizes;
    std::vector<SceneInput> scenes{ChooseScene(given, std::nullopt, arguments.input)};
    const scenes::SceneInfo* info = scenes.front().info;
    if (text == "default") return scenes;
    if (const std::optional<int> count = ReadSweep(text)) {
        if (info == nullptr || !info->sweep) return scenes;
        scenes.clear();
        for (const int size : PickSizes(*info->sweep, *count)) scenes.push_back(MakeInput(*info, size));
        return scenes;
    }
    scenes.clear();
    for (const int size :
         ParseIntList("--sizes", text, "default, sweep, sweep@COUNT or sizes with commas, for example 1000,10000")) {
        scenes.push_back(ChooseScene(given, size, arguments.input));
    }
    return scenes;
}

/// What was typed, each once, or the published suite.
std::vector<std::string> ListScenes(const std::vector<std::string>& names) {
    std::vector<std::string> chosen;
    for (const std::string& name : names) {
        if (std::find(chosen.begin(), chosen.end(), name) == chosen.end()) chosen.push_back(name);
    }
    if (!names.empty()) return chosen;
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        if (!info.isClassic && info.sweep) chosen.emplace_back(info.name);
    }
    return chosen;
}

/// KEY=VALUE for every value of a list with commas. Throws UsageError that names the option.
std::vector<std::string> ListSettings(const std::string& key, const std::string& option, const std::string& list) {
    // In si@4,2 the comma stands in a value: what is no number begins one.
    std::vector<std::string> values;
    bool isNumber = true;
    for (const std::string_view part : Split(list, ',')) {
        const bool wasNumber = std::exchange(isNumber, static_cast<bool>(ParseNumber<double>(part)));
        if (isNumber && !wasNumber) {
            values.back() += fmt::format("/{}", part);
        } else {
            values.emplace_back(part);
        }
    }
    std::vector<std::string> settings;
    for (const std::string& value : values) {
        RunSpec spec;
        settings.push_back(fmt::format("{}={}", key, value));
        (void)ApplySetting(spec, settings.back(), option + " " + list);
    }
    return settings;
}

/// Every pane once for each solver and number of threads that it does not choose itself, as far as its engine has them.
std::vector<Pane> ChoosePanes(const BenchArguments& arguments) {
    const std::vector<std::string> solvers =
        ListSettings("solver", "--solver", arguments.solver == "both" ? "si,soft" : arguments.solver);
    const std::vector<std::string> threads = ListSettings("threads", "--threads",
                                                          !arguments.threads.empty() ? arguments.threads
                                                          : arguments.targets        ? "1,2"
                                                                                     : "1");
    // A preset sets everything: the choice comes after the last one, before what was typed after that.
    const std::vector<TypedSetting>& typed = arguments.settings.typed;
    const auto put = [&](const std::string& solver, const std::string& count) {
        std::vector<TypedSetting> all = typed;
        const auto last = std::find_if(all.rbegin(), all.rend(), [](const TypedSetting& setting) {
            return setting.setting.starts_with("preset=");
        });
        all.insert(last.base(), {{solver, "--solver", true}, {count, "--threads", true}});
        return all;
    };
    std::vector<std::vector<Pane>> choices;
    for (const std::string& solver : solvers) {
        for (const std::string& count : threads) {
            choices.push_back(ParsePanes(arguments.settings.engines, put(solver, count), comparisonBase));
        }
    }
    std::vector<Pane> panes;
    for (std::size_t i = 0; i < choices.front().size(); ++i) {
        const auto first = panes.end() - panes.begin();
        for (const std::vector<Pane>& choice : choices) {
            const auto isSame = [&](const Pane& pane) { return pane.spec == choice[i].spec; };
            if (std::none_of(panes.begin() + first, panes.end(), isSame)) panes.push_back(choice[i]);
        }
    }
    return panes;
}

/// What the cost of continuous collision is judged on: our engine with it on.
std::vector<Pane> MakeContinuous(std::vector<Pane> panes) {
    std::erase_if(panes, [](const Pane& pane) { return pane.spec.engine != "scree"; });
    for (Pane& pane : panes) pane.spec.continuous = true;
    return panes;
}

constexpr int maxNeighbours = 1024;

int CheckRepeats(int repeats) {
    if (repeats >= 1 && repeats <= maxRepeats) return repeats;
    throw UsageError(fmt::format("--repeat {}: legal from 1 to {}", repeats, maxRepeats));
}

BenchEffort MakeEffort(const BenchArguments& arguments) {
    const int repeats = CheckRepeats(arguments.repeats.value_or(3));
    if (arguments.steps < 0 || arguments.steps > maxStep) {
        throw UsageError(fmt::format("--steps {}: legal from 1 to {}", arguments.steps, maxStep));
    }
    return {repeats, arguments.steps, arguments.timeLimitS};
}

}  // namespace

void AddBenchOptions(CLI::App& app, BenchArguments& arguments) {
    app.add_option("SCENE", arguments.scenes,
                   DescribeSceneArgument("Scenes") + "; the whole published suite if none is given");
    AddFormatOption(app, arguments.input);
    app.add_option("--sizes", arguments.sizes,
                   "default, sweep (the published sizes), sweep@COUNT (so many of them), or sizes with commas")
        ->capture_default_str();
    AddEnginesOption(app, arguments.settings, "");
    app.add_option("--baseline", arguments.settings.baseline,
                   "Name of the pane that the others are compared with; box2d's or else box2d3's if not given")
        ->type_name("NAME");
    AddSetOption(app, arguments.settings, comparisonNote);
    app.add_option("--solver", arguments.solver,
                   "Solvers to try, as --set solver takes them, with commas: si (sequential impulses, 8/3), soft (soft "
                   "step, 4 sub-steps), soft@8, or both")
        ->capture_default_str();
    app.add_option("--threads", arguments.threads,
                   "Threads of the engine scree, one or more numbers; 1 if not given, 1,2 with --targets")
        ->capture_default_str();
    AddSettingFlags(app, arguments.settings, {"broadPhase", "continuous"});
    app.add_option(
        "--repeat", arguments.repeats,
        "Repeats of everything, of which the median of each step's times counts; 3 if not given, 9 with --against");
    app.add_option(
           "--against", arguments.against,
           "Another build of this program (its folder or the file): the same cases in both in turn, a ratio with "
           "an interval of 95 % and whether both came to the same states; engines: scree if not given")
        ->type_name("BUILD");
    app.add_option(
           "--at-least", arguments.atLeast,
           "With --against: exit 1 if a case has less than this share of the other build's speed, with 95 % confidence")
        ->type_name("RATIO")
        ->check(AboveZero())
        ->needs("--against");
    app.add_option("--steps", arguments.steps, "Largest number of steps; the scene's own if not given");
    app.add_option("--time-limit", arguments.timeLimitS,
                   "Seconds after which a run of one scene in one engine is stopped: its total is then shown with ≥")
        ->check(ZeroOrAbove());
    app.add_option("--csv", arguments.csv, "Write all rows to this file")->type_name("FILE");
    app.add_option(
           "--plots", arguments.plots,
           "Draw SVG and PNG into this folder: total over fixtures where there are several sizes, broad phase of "
           "every step of the largest")
        ->type_name("DIR");
    app.add_option("-o,--output", arguments.output, "Folder for all results: bench.csv, plots/, index.html")
        ->type_name("DIR");
    AddMarkdownOption(app, arguments.markdown);
    app.add_option("--neighbours", arguments.neighbours,
                   "So many other processes keep a core busy each while it measures, as on a machine that one shares; "
                   "0 if not given")
        ->type_name("N");
    app.add_flag(
        "--targets", arguments.targets,
        "Compare with the targets of speed, also with continuous collision on; exit 1 when a target is missed or void");
    app.add_flag("--games", arguments.games,
                 "The second suite: what games do, with default settings, in every engine of this build in turn. "
                 "SCENE names its cases; --repeat, --steps, --output and --markdown apply");
    app.add_option("--cores", arguments.cores,
                   "Work and span instead of times: how much faster our engine would be on so many cores, counted on "
                   "one thread; --solver, --set, --repeat, --steps and --markdown apply")
        ->type_name("LIST");
    app.add_option("--from", arguments.from, "Show and judge the rows of a --json file instead of running")
        ->type_name("FILE");
    AddShardOptions(app, arguments.shard);
    AddResumeOption(app, arguments.shard);
}

void CheckNeighbours(const BenchArguments& arguments) {
    if (arguments.neighbours < 0 || arguments.neighbours > maxNeighbours) {
        throw UsageError(fmt::format("--neighbours {}: legal from 0 to {}", arguments.neighbours, maxNeighbours));
    }
    if (arguments.neighbours > 0 && (!arguments.from.empty() || !arguments.cores.empty())) {
        throw UsageError("--neighbours disturbs times, and --from and --cores take none: leave it out");
    }
}

AgainstPlan MakeAgainstPlan(const BenchArguments& arguments) {
    if (arguments.targets || !arguments.from.empty() || !arguments.csv.empty() || !arguments.plots.empty() ||
        !arguments.shard.json.empty() || ParseShard(arguments.shard.shard).count != 1) {
        throw UsageError(
            "--against takes none of --targets, --from, --csv, --plots, --json, --shard; -o and --markdown write it");
    }
    AgainstPlan plan{FindBuiltProgram(arguments.against),
                     ListScenes(arguments.scenes),
                     {},
                     CheckRepeats(arguments.repeats.value_or(9))};
    (void)MakeBenchPlan(arguments);  // what this build refuses is not tried in both
    const auto add = [&plan](std::string option, std::string value) {
        plan.options.push_back(std::move(option));
        plan.options.push_back(std::move(value));
    };
    add("--engines", arguments.settings.engines == SettingArguments().engines ? "scree" : arguments.settings.engines);
    add("--solver", arguments.solver);  // "both" as it is: a list is new to older builds
    if (!arguments.threads.empty()) add("--threads", arguments.threads);
    if (arguments.sizes != "default") add("--sizes", arguments.sizes);
    if (arguments.steps > 0) add("--steps", fmt::format("{}", arguments.steps));
    if (arguments.timeLimitS > 0) add("--time-limit", fmt::format("{}", arguments.timeLimitS));
    if (!arguments.input.format.empty()) add("--format", arguments.input.format);
    for (const TypedSetting& one : arguments.settings.typed) add("--set", one.setting);
    return plan;
}

BenchPlan MakeBenchPlan(const BenchArguments& arguments) {
    BenchPlan plan{{}, ParseShard(arguments.shard.shard), MakeEffort(arguments)};
    const std::vector<Pane> panes = ChoosePanes(arguments);
    const std::string baseline = panes[FindBaseline(panes, arguments.settings.baseline)].name;
    const bool isContinuous = std::ranges::any_of(panes, [](const Pane& pane) { return pane.spec.continuous; });
    for (const std::string& given : ListScenes(arguments.scenes)) {
        for (const SceneInput& scene : ChooseSizes(given, arguments)) {
            plan.cases.push_back({scene, panes, baseline});
            if (!arguments.targets || isContinuous || !IsContinuousTarget(scene.name)) continue;
            plan.cases.push_back({scene, MakeContinuous(panes), "box2d"});
        }
    }
    return plan;
}

}  // namespace testbed
