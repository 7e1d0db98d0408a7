// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Programs of others that the testbed runs: whether they are there, and the error when they are not.

#pragma once

#include <stdexcept>
#include <string_view>

namespace testbed {

/// A program that the testbed runs is not installed or failed; the message says what to do. The CLI exits 4.
class ToolError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Whether a program of this name is on PATH.
[[nodiscard]] bool IsInstalled(std::string_view program);

}  // namespace testbed
