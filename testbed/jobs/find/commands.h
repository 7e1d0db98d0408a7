// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The subcommand find, as the command line adds it.

#pragma once

#include "testbed/options/request.h"

namespace testbed {

void AddFindCommand(CLI::App& app, Request& request);

}  // namespace testbed
