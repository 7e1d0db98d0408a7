// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the command line asks for. A command adds itself to the parser. When the user chose it, it puts what is to be
// done into the request, to be run after parsing succeeded.

#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "testbed/gl/context.h"

namespace testbed {

/// What the command line asks for.
struct Request {
    std::vector<std::string> arguments;  ///< the whole command line, without the program's name
    ContextOptions contextOptions;
    std::function<int()> action;  ///< of the chosen subcommand; returns an exit code
};

}  // namespace testbed
