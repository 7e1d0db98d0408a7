// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The subcommands snapshot and diff, as the command line adds them.

#pragma once

#include "testbed/options/request.h"

namespace testbed {

void AddSnapshotCommand(CLI::App& app, Request& request);
void AddDiffCommand(CLI::App& app, Request& request);

}  // namespace testbed
