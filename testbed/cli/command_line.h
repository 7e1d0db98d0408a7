// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The program `scree`: command line in, exit code out. It knows the subcommands, turns every error into one line with
// what, where and the cure, and names the nearest known word for an unknown one.

#pragma once

#include <string>
#include <vector>

#include "testbed/gl/context.h"

namespace testbed {

/// Runs one command; `arguments` without the program's name. `contextOptions` says where the GL libraries are.
[[nodiscard]] int RunCommandLine(const std::vector<std::string>& arguments, const ContextOptions& contextOptions = {});

}  // namespace testbed
