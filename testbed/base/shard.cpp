// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `--shard I/N`.

#include "testbed/base/shard.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "testbed/base/errors.h"

namespace testbed {

namespace {

/// The whole text as a number, else 0.
int ParsePart(std::string_view text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? value : 0;
}

}  // namespace

Shard ParseShard(std::string_view text) {
    const std::size_t slash = std::min(text.find('/'), text.size());
    Shard shard;
    shard.index = ParsePart(text.substr(0, slash));
    shard.count = slash < text.size() ? ParsePart(text.substr(slash + 1)) : 0;
    if (shard.index < 1 || shard.count < 1 || shard.index > shard.count || shard.count > maxShards) {
        throw UsageError(
            fmt::format("--shard {}: give I/N, part I of N with 1 <= I <= N <= {}, for example 1/2", text, maxShards));
    }
    return shard;
}

void AddShardOptions(CLI::App& app, ShardArguments& arguments) {
    app.add_option("--shard", arguments.shard, "Only part I of N of the cases; `scree merge` joins the parts' --json")
        ->type_name("I/N")
        ->capture_default_str();
    app.add_option("--json", arguments.json, "Write the results here, one JSON object per line")->type_name("FILE");
}

}  // namespace testbed
