// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `--shard I/N`: a command with many independent cases takes every N-th of them. So N processes on one machine or many
// share the work. Cases are numbered from 0 in the order of the whole, unsharded run. Every case writes one or more
// JSON lines that carry its number (base/case_lines.h), and `scree merge` joins the files of all shards.
//
//     std::string shardText; std::string json;              // in the arguments of the command
//     AddShardOptions(*command, arguments.shard);           // --shard I/N and --json FILE
//     const Shard shard = ParseShard(arguments.shard.shard);
//     for (std::size_t i = 0; i < cases.size(); ++i) { if (shard.Contains(i)) … }

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace CLI {
class App;  // its header costs seconds in every file
}

namespace testbed {

/// Part `index` of `count`, counted from 1; 1/1 is everything.
struct Shard {
    int index = 1, count = 1;

    /// Whether the case with this number, from 0, is this shard's.
    [[nodiscard]] bool Contains(std::size_t caseNumber) const {
        return caseNumber % static_cast<std::size_t>(count) == static_cast<std::size_t>(index - 1);
    }
    /// Exactly one shard answers for what belongs to no single case.
    [[nodiscard]] bool IsFirst() const { return index == 1; }
};

/// More parts than any job array has are a slip of the finger.
inline constexpr int maxShards = 100'000;

/// "I/N" with 1 ≤ I ≤ N ≤ maxShards. Throws UsageError.
[[nodiscard]] Shard ParseShard(std::string_view text);

/// As typed.
struct ShardArguments {
    std::string shard = "1/1";
    std::string json;     ///< file for the JSON lines; empty: none
    bool resume = false;  ///< take over what a stopped run left of that file
};
/// --shard I/N and --json FILE.
void AddShardOptions(CLI::App& app, ShardArguments& arguments);
/// --resume, for commands whose cases take long.
void AddResumeOption(CLI::App& app, ShardArguments& arguments);
/// Throws UsageError for --resume without --json.
void CheckResume(const ShardArguments& arguments);

}  // namespace testbed
