// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The reference of the command line as one Markdown page, made from what --help knows.

#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace testbed {

/// Every command with its arguments, options, defaults and exit codes. The same on every machine.
[[nodiscard]] std::string MakeCommandReference(const CLI::App& program);

}  // namespace testbed
