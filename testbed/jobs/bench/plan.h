// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What `scree bench` is to run: options as typed in, a checked list of cases out.

#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "testbed/base/shard.h"
#include "testbed/jobs/bench/run.h"
#include "testbed/options/options.h"

namespace testbed {

/// As typed.
struct BenchArguments {
    std::vector<std::string> scenes;
    InputArguments input;
    std::string sizes = "default";
    SettingArguments settings;
    std::string solver = "both";
    std::string threads;         ///< empty: 1, with targets 1,2
    std::optional<int> repeats;  ///< 3, and 9 rounds against another build
    std::string against;         ///< a build to compare with instead of engines
    double atLeast = 0;          ///< with it: the ratio that no case may surely miss
    int steps = 0;
    double timeLimitS = 0;
    ShardArguments shard;
    int neighbours = 0;  ///< processes that only keep cores busy meanwhile
    bool targets = false;
    bool games = false;  ///< the cases of games instead of scenes
    std::string cores;   ///< numbers of cores to count work and span for, instead of times
    std::string from;    ///< rows to judge and show instead of a run
    std::string csv, plots, output, markdown;
};

struct BenchPlan {
    std::vector<BenchCase> cases;  ///< of the whole run
    Shard shard;
    BenchEffort effort;
};

/// Throws UsageError for a number of neighbours that is not legal, or where nothing is timed.
void CheckNeighbours(const BenchArguments& arguments);

struct AgainstPlan;
/// What is asked of two builds. Throws UsageError for what only one can be asked.
[[nodiscard]] AgainstPlan MakeAgainstPlan(const BenchArguments& arguments);

void AddBenchOptions(CLI::App& app, BenchArguments& arguments);

/// The cases in the catalogue's order of scenes, or in the order typed; sizes ascending as given. Without names: the
/// published suite, that is all scenes with a sweep that are no classics. Throws UsageError.
[[nodiscard]] BenchPlan MakeBenchPlan(const BenchArguments& arguments);

}  // namespace testbed
