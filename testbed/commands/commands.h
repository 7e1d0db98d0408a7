// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The subcommands of `scree`, one file each: command_<name>.cpp. Each adds itself to the parser; when the user chose
// it, it puts what is to be done into the request, to be run after parsing succeeded.

#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "testbed/context/context.h"

namespace testbed {

/// What the command line asks for.
struct Request {
    std::vector<std::string> arguments;  ///< the whole command line, without the program's name
    ContextOptions contextOptions;
    std::function<int()> action;  ///< of the chosen subcommand; returns an exit code
};

void AddListCommand(CLI::App& app, Request& request);
void AddOverlapCommand(CLI::App& app, Request& request);
void AddRenderCommand(CLI::App& app, Request& request);
void AddMetricsCommand(CLI::App& app, Request& request);
void AddBenchCommand(CLI::App& app, Request& request);
void AddSnapshotCommand(CLI::App& app, Request& request);
void AddDiffCommand(CLI::App& app, Request& request);
void AddMergeCommand(CLI::App& app, Request& request);
void AddViewCommand(CLI::App& app, Request& request);
void AddTradeoffCommand(CLI::App& app, Request& request);
void AddExtremesCommand(CLI::App& app, Request& request);
void AddRequiresCommand(CLI::App& app, Request& request);
void AddEnvCommand(CLI::App& app, Request& request);

}  // namespace testbed
