// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The subcommands that belong to no job: what is there, what the machine has, and joining the files of shards.

#pragma once

#include "testbed/options/request.h"

namespace testbed {

void AddListCommand(CLI::App& app, Request& request);
void AddMergeCommand(CLI::App& app, Request& request);
void AddManCommand(CLI::App& app, Request& request);
void AddEnvCommand(CLI::App& app, Request& request);

}  // namespace testbed
