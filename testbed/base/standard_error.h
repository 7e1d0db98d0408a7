// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a program says beside its results. That nobody can hear it is no reason to stop: standard error may be closed,
// full, or a pipe whose reader went away.

#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

namespace testbed {

/// Prints what fmt::format makes of the arguments to standard error; what does not arrive there is dropped.
template <typename... Arguments>
void PrintError(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    const std::string text = fmt::format(format, std::forward<Arguments>(arguments)...);
    // fmt::print would throw.
    (void)std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace testbed
