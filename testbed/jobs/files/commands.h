// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The subcommands info and convert, as the command line adds them.

#pragma once

#include "testbed/options/request.h"

namespace testbed {

void AddInfoCommand(CLI::App& app, Request& request);
void AddConvertCommand(CLI::App& app, Request& request);

}  // namespace testbed
