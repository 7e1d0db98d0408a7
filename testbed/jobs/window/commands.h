// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The subcommand view, as the command line adds it.

#pragma once

#include "testbed/options/request.h"

namespace testbed {

void AddViewCommand(CLI::App& app, Request& request);

}  // namespace testbed
