// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The regular expression after -g, which chooses among cases by their names.

#pragma once

#include <fmt/format.h>

#include <regex>
#include <string>

#include "testbed/base/errors.h"

namespace testbed {

/// Throws UsageError for what is no regular expression.
[[nodiscard]] inline std::regex CompileFilter(const std::string& filter) {
    try {
        return std::regex(filter);
    } catch (const std::regex_error& error) {
        throw UsageError(fmt::format("-g '{}': not a regular expression: {}", filter, error.what()));
    }
}

}  // namespace testbed
