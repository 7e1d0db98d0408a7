// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree list`: the scenes with their sizes and what they exercise, in groups, as a table or as JSON.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/catalog.h"
#include "testbed/base/errors.h"
#include "testbed/cli/commands.h"

namespace testbed {

namespace {

using Json = nlohmann::ordered_json;

std::string DescribeSizes(const scenes::SceneInfo& info) {
    if (!info.hasSize) return fmt::format("{}", info.defaultSize);
    return fmt::format("{} ({}..{})", info.defaultSize, info.minSize, info.maxSize);
}

/// A part of the catalogue under a heading of its own.
struct Group {
    const char* name;
    const char* heading;
};
constexpr std::array groups{Group{"benchmark", "the benchmark suite (what `scree bench` runs)"},
                            Group{"classic", "classics, by theme"}, Group{"joint", "one scene per joint"}};

const char* GroupOf(const scenes::SceneInfo& info) {
    if (!info.isClassic) return groups[0].name;
    return info.folder == "joints" ? groups[2].name : groups[1].name;
}

/// The rows of a group; classics that share a theme follow each other.
std::vector<const scenes::SceneInfo*> SelectGroup(std::string_view group) {
    std::vector<const scenes::SceneInfo*> rows;
    std::vector<std::string_view> themes;
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        if (GroupOf(info) != group) continue;
        rows.push_back(&info);
        if (std::ranges::find(themes, info.folder) == themes.end()) themes.push_back(info.folder);
    }
    if (group == groups[1].name) {
        std::ranges::stable_sort(rows, {}, [&](const auto* row) { return std::ranges::find(themes, row->folder); });
    }
    return rows;
}

void PrintTable() {
    for (const Group& group : groups) {
        const std::vector<const scenes::SceneInfo*> rows = SelectGroup(group.name);
        fmt::print("{}{}: {} scenes\n", &group == &groups[0] ? "" : "\n", group.heading, rows.size());
        fmt::print("  {:<22}{:<14}{:<20}{:>6} {:>6}  {}\n", "scene", "theme", "size (legal)", "steps", "shown",
                   "what it is, and tests");
        for (const scenes::SceneInfo* info : rows) {
            fmt::print("  {:<22}{:<14}{:<20}{:>6} {:>6}  {}\n{:72}  {}\n", info->name, info->folder,
                       DescribeSizes(*info), info->steps, info->showStep, info->title, "", info->exercises);
        }
    }
}

void PrintJson() {
    Json list = Json::array();
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        Json row = {{"name", info.name},
                    {"group", GroupOf(info)},
                    {"title", info.title},
                    {"exercises", info.exercises},
                    {"folder", info.folder},
                    {"has_size", info.hasSize},
                    {"default_size", info.defaultSize},
                    {"min_size", info.minSize},
                    {"max_size", info.maxSize},
                    {"steps", info.steps},
                    {"show_step", info.showStep}};
        if (info.sweep) {
            row["sweep"] = {
                {"begin", info.sweep->begin}, {"end", info.sweep->end}, {"increment", info.sweep->increment}};
        }
        list.push_back(std::move(row));
    }
    fmt::print("{}\n", Json{{"schema", 1}, {"scenes", list}}.dump(2));
}

}  // namespace

void AddListCommand(CLI::App& app, Request& request) {
    CLI::App* command = app.add_subcommand("list", "Scenes: parameters, defaults, sizes, what they exercise");
    auto json = std::make_shared<bool>(false);
    command->add_flag("--json", *json, "As JSON");
    command->callback([&request, json] {
        request.action = [json] {
            *json ? PrintJson() : PrintTable();
            return exitDone;
        };
    });
}

}  // namespace testbed
