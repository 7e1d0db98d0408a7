// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Manual pages for man(1), made from what --help knows.

#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace testbed {

/// A page and the file that it belongs into.
struct ManualPage {
    std::string file{};  ///< "scree-find.1"
    std::string text{};  ///< in the man macros of roff
};

/// The page of the program, then one of each command in its order. `version` stands at their foot.
[[nodiscard]] std::vector<ManualPage> MakeManual(const CLI::App& program, const std::string& version);

}  // namespace testbed
