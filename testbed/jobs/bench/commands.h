// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The subcommand bench, as the command line adds it.

#pragma once

#include "testbed/options/request.h"

namespace testbed {

void AddBenchCommand(CLI::App& app, Request& request);

}  // namespace testbed
