// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of plan.h.

#include "testbed/jobs/bench/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "testbed/base/nearest.h"
#include "testbed/jobs/bench/targets.h"
#include "testbed/options/options.h"

namespace testbed {

namespace {

constexpr std::array<std::string_view, 3> solverNames = {"si", "soft", "both"};
constexpr int maxRepeats = 1000;

/// The sizes to run a scene at.
std::vector<int> ChooseSizes(const scenes::SceneInfo& info, const std::string& text) {
    if (text == "default" || (text == "sweep" && !info.sweep)) return {info.defaultSize};
    std::vector<int> sizes;
    if (text == "sweep") {
        for (int n = info.sweep->begin; n <= info.sweep->end; n += info.sweep->increment) sizes.push_back(n);
        return sizes;
    }
    for (const int size :
         ParseIntList("--sizes", text, "default, sweep or sizes with commas, for example 1000,10000")) {
        sizes.push_back(CheckedSize(info, size));
    }
    return sizes;
}

std::vector<const scenes::SceneInfo*> ChooseScenes(const std::vector<std::string>& names) {
    std::vector<const scenes::SceneInfo*> chosen;
    for (const std::string& name : names) {
        const scenes::SceneInfo* info = &FindScene(name);
        if (std::find(chosen.begin(), chosen.end(), info) == chosen.end()) chosen.push_back(info);
    }
    if (!names.empty()) return chosen;
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        if (!info.isClassic && info.sweep) chosen.push_back(&info);
    }
    return chosen;
}

std::vector<std::string> ChooseSolvers(const std::string& text) {
    if (std::find(solverNames.begin(), solverNames.end(), text) == solverNames.end()) {
        throw UsageError(DescribeUnknown("solver", text, solverNames));
    }
    if (text == "both") return {"si", "soft"};
    return {text};
}

std::vector<int> ChooseThreads(const std::string& text) {
    const std::vector<int> threads = ParseIntList("--threads", text, "numbers with commas, for example 1,2");
    for (const int count : threads) {
        if (count < 1 || count > maxThreads) {
            throw UsageError(fmt::format("--threads {}: legal from 1 to {}", count, maxThreads));
        }
    }
    return threads;
}

std::vector<BenchVariant> MakeVariants(const BenchArguments& arguments) {
    std::vector<BenchVariant> variants;
    const std::vector<std::string> solvers = ChooseSolvers(arguments.solver);
    const std::vector<int> threads = ChooseThreads(!arguments.threads.empty() ? arguments.threads
                                                   : arguments.targets        ? "1,2"
                                                                              : "1");
    for (const std::string& engine : ParseEngines(arguments.engines)) {
        if (engine == "box2d") {
            variants.push_back({engine});
            continue;
        }
        for (const std::string& solver : solvers) {
            for (const int count : threads) variants.push_back({engine, solver, count});
        }
    }
    return variants;
}

std::vector<BenchVariant> OnlyOurs(std::vector<BenchVariant> variants) {
    std::erase_if(variants, [](const BenchVariant& variant) { return variant.engine == "box2d"; });
    return variants;
}

BenchSettings MakeSettings(const BenchArguments& arguments) {
    if (arguments.repeats < 1 || arguments.repeats > maxRepeats) {
        throw UsageError(fmt::format("--repeat {}: legal from 1 to {}", arguments.repeats, maxRepeats));
    }
    if (arguments.steps < 0 || arguments.steps > maxStep) {
        throw UsageError(fmt::format("--steps {}: legal from 1 to {}", arguments.steps, maxStep));
    }
    if (!(arguments.timeLimitS >= 0)) {
        throw UsageError(fmt::format("--time-limit {}: give seconds, 0 for none", arguments.timeLimitS));
    }
    return {arguments.repeats, arguments.steps, arguments.timeLimitS, arguments.broadPhase};
}

}  // namespace

void AddBenchOptions(CLI::App& app, BenchArguments& arguments) {
    app.add_option("SCENE", arguments.scenes, "Scenes; the whole published suite if none is given");
    app.add_option("--sizes", arguments.sizes, "default, sweep (the published sizes), or sizes with commas")
        ->capture_default_str();
    app.add_option("--engines", arguments.engines, "Engines to run: scree, box2d or both with a comma")
        ->capture_default_str();
    app.add_option("--solver", arguments.solver,
                   "Solver of the engine scree: si (sequential impulses, 8/3), soft (soft step, 4 sub-steps), or both")
        ->capture_default_str();
    app.add_option("--threads", arguments.threads,
                   "Threads of the engine scree, one or more numbers; 1 if not given, 1,2 with --targets")
        ->capture_default_str();
    app.add_option("--broad-phase", arguments.broadPhase, "Algorithm of the engine scree")->capture_default_str();
    app.add_flag("--continuous", arguments.continuous, "Turn continuous collision on");
    app.add_option("--repeat", arguments.repeats, "Runs of everything; the median of each step's times stands for them")
        ->capture_default_str();
    app.add_option("--steps", arguments.steps, "Steps at most; the scene's own number if not given");
    app.add_option("--time-limit", arguments.timeLimitS,
                   "Seconds after which a run of one scene in one engine is stopped: its total is then shown with ≥");
    app.add_option("--csv", arguments.csv, "Write all rows to this file")->type_name("FILE");
    app.add_option(
           "--plots", arguments.plots,
           "Draw SVG and PNG into this folder: total over fixtures where there are several sizes, broad phase of "
           "every step of the largest")
        ->type_name("DIR");
    app.add_option("-o,--output", arguments.output, "Folder for all of it: bench.csv, plots/, index.html")
        ->type_name("DIR");
    app.add_flag("--targets", arguments.targets,
                 "Judge the speed to reach, also with continuous collision on; exit 1 when a target is missed or void");
    app.add_option("--from", arguments.from, "Show and judge the rows of a --json file instead of running")
        ->type_name("FILE");
    AddShardOptions(app, arguments.shard);
}

BenchPlan MakeBenchPlan(const BenchArguments& arguments) {
    BenchPlan plan{{}, ParseShard(arguments.shard.shard), MakeSettings(arguments)};
    const std::vector<BenchVariant> variants = MakeVariants(arguments);
    CheckBroadPhase(arguments.broadPhase);
    for (const scenes::SceneInfo* info : ChooseScenes(arguments.scenes)) {
        for (const int size : ChooseSizes(*info, arguments.sizes)) {
            plan.cases.push_back({info, size, arguments.continuous, variants});
            // The cost of continuous collision is judged on ours alone.
            if (!arguments.targets || arguments.continuous || !IsContinuousTarget(info->name)) continue;
            plan.cases.push_back({info, size, true, OnlyOurs(variants)});
        }
    }
    return plan;
}

}  // namespace testbed
