// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree list`: the scenes with their sizes and what they exercise, as a table or as JSON.

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "scenes/catalog.h"
#include "testbed/commands/commands.h"
#include "testbed/commands/exit_code.h"

namespace testbed {

namespace {

using Json = nlohmann::ordered_json;

std::string DescribeSizes(const scenes::SceneInfo& info) {
    if (!info.hasSize) return fmt::format("{}", info.defaultSize);
    return fmt::format("{} ({}..{})", info.defaultSize, info.minSize, info.maxSize);
}

void PrintTable() {
    fmt::print("{:<22}{:<22}{:>6} {:>6}  {}\n", "scene", "size (legal)", "steps", "shown", "what it is, and tests");
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        fmt::print("{:<22}{:<22}{:>6} {:>6}  {}\n{:58}  {}\n", info.name, DescribeSizes(info), info.steps,
                   info.showStep, info.title, "", info.exercises);
    }
}

void PrintJson() {
    Json list = Json::array();
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        Json row = {{"name", info.name},         {"title", info.title},      {"exercises", info.exercises},
                    {"folder", info.folder},     {"has_size", info.hasSize}, {"default_size", info.defaultSize},
                    {"min_size", info.minSize},  {"max_size", info.maxSize}, {"steps", info.steps},
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
