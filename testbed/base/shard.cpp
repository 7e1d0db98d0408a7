// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `--shard I/N`.

#include "testbed/base/shard.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <vector>

#include "testbed/base/errors.h"
#include "testbed/base/text.h"

namespace testbed {

Shard ParseShard(std::string_view text) {
    const std::vector<std::string_view> parts = Split(text, '/');
    const Parsed<int> index = ParseNumber<int>(parts.front()), count = ParseNumber<int>(parts.back());
    if (parts.size() != 2 || !index || !count || *index < 1 || *index > *count || *count > maxShards) {
        throw UsageError(fmt::format("--shard {}: {}give I/N, part I of N with 1 <= I <= N <= {}, for example 1/2",
                                     text, BeforeCure(!index ? index.problem : count.problem), maxShards));
    }
    return {*index, *count};
}

void AddShardOptions(CLI::App& app, ShardArguments& arguments) {
    app.add_option("--shard", arguments.shard, "Only part I of N of the cases; `scree merge` joins the parts' --json")
        ->type_name("I/N")
        ->capture_default_str();
    app.add_option("--json", arguments.json, "Write the results here, one JSON object per line")->type_name("FILE");
}

void AddResumeOption(CLI::App& app, ShardArguments& arguments) {
    app.add_flag("--resume", arguments.resume,
                 "Continue a run that was stopped: its finished cases are in the --json file with .part appended");
}

void CheckResume(const ShardArguments& arguments) {
    if (arguments.resume && arguments.json.empty()) {
        throw UsageError("--resume: give the --json FILE of the run that was stopped");
    }
}

}  // namespace testbed
