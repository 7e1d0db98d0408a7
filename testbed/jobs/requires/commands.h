// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The subcommand requires, as the command line adds it.

#pragma once

#include "testbed/options/request.h"

namespace testbed {

void AddRequiresCommand(CLI::App& app, Request& request);

}  // namespace testbed
