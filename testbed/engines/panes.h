// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Which engines run beside each other under which settings, and which of them the others are compared with. Written
//   [NAME=]ENGINE[:KEY=VALUE]…,…
// a comma separates panes, a colon the settings of a pane: scree,scree:solver=soft@8:threads=2,fine=scree:accuracy=fine
// No pane begins with a number: after a comma it continues a value, as in scree:gravity=0,-20,box2d.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "testbed/engines/run_spec.h"

namespace testbed {

struct Pane {
    std::string name;  ///< of its files, columns and curves: letters, digits, and ._- between them
    RunSpec spec;
};

/// What runs beside each other.
struct Panes {
    std::vector<Pane> panes;
    std::size_t baseline = 0;         ///< index of the pane that the others are compared with
    std::optional<RunSpec> source{};  ///< whose motion all broad phases follow; none: every run simulates for itself
};

/// The base of commands that show engines beside each other: like for like.
inline constexpr std::string_view comparisonBase = "preset=like-box2d";

/// A setting as it was typed, and where.
struct TypedSetting {
    std::string setting;      ///< KEY=VALUE
    std::string source;       ///< what a message about it begins with: "--set solver=soft", "--threads 2"
    bool isOptional = false;  ///< no fault where no engine of the run has it
};

/// The panes in the order typed. Every pane starts from its engine's own defaults. Then `base` (as PrintSettings writes
/// it) and `common` apply as far as its engine has them, then its own settings. A pane without a name gets its
/// engine's, and its own settings where another pane has that. So scree:solver=soft@8 is scree-soft-8, and a second
/// scree is scree-2. Throws UsageError for what cannot be read, and for a setting that no pane (or not the pane that
/// names it) can have. It also throws for two panes that were given one name.
[[nodiscard]] std::vector<Pane> ParsePanes(std::string_view text, std::span<const TypedSetting> common = {},
                                           std::string_view base = {});

/// The common settings in one engine; UsageError for one that it does not have.
[[nodiscard]] RunSpec ParseSpec(std::string_view engine, std::span<const TypedSetting> common,
                                std::string_view base = {});

/// Index of the pane that the others are compared with: the one of that name. UsageError with the nearest one if there
/// is none. For an empty name it is the first of Box2D 2.4, else of Box2D 3, else the first.
[[nodiscard]] std::size_t FindBaseline(std::span<const Pane> panes, std::string_view name = {});

}  // namespace testbed
