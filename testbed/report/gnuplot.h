// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// gnuplot as a helper program: a script in, a picture out. It is started without a shell, so that no file name needs
// quoting for one.

#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace testbed {

/// A program that the testbed runs is not installed; the message names the Debian package. The CLI exits 4.
class ToolError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Throws ToolError unless gnuplot is on PATH: call it before a long run.
void CheckGnuplot();

/// A gnuplot string literal.
[[nodiscard]] std::string QuoteForGnuplot(std::string_view text);

/// Runs a script that makes the file `picture`, which lies in an existing folder. Throws ToolError with gnuplot's own
/// words.
void RunGnuplot(const std::string& script, const std::filesystem::path& picture);

}  // namespace testbed
