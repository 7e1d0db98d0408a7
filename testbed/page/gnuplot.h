// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// gnuplot as a helper program: a script in, a picture out. It is started without a shell, so that no file name needs
// quoting for one.

#pragma once

#include <filesystem>
#include <string>

namespace testbed {

/// Throws ToolError unless gnuplot is on PATH: call it before a long run.
void CheckGnuplot();

/// Runs a script that makes the file `picture`, which lies in an existing folder. Throws ToolError with gnuplot's own
/// words.
void RunGnuplot(const std::string& script, const std::filesystem::path& picture);

}  // namespace testbed
