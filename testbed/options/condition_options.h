// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The conditions of a session as options: what `find` lists, and what others mark.

#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "testbed/moments/moment.h"
#include "testbed/options/session.h"

namespace testbed {

/// As typed.
struct ConditionArguments {
    std::optional<int> pileOn;
    bool tunnel = false, nonFinite = false, jitter = false, marks = false;
    std::optional<double> overlap, speed, spin, spike, jointGap, awake;
    std::string escape, diverge;
    std::vector<std::string> when;
    double longer = 0, distance = 0;
};
/// `group`: the heading above them.
void AddConditionOptions(CLI::App& app, ConditionArguments& arguments,
                         const std::string& group = "Conditions (tunnel and non-finite if none is given)");

/// Conditions with the names by which they are asked for.
struct AskedConditions {
    std::vector<std::string> names;
    Conditions conditions;
};
/// What conditions know of that at which they look.
struct WatchedFacts {
    const std::vector<std::string>& names;  ///< of bodies, by index
    bool hasContacts = true, hasTimes = true;
};
/// Those that were asked for; tunnel and non-finite if none was. Throws UsageError for what cannot be meant, and for a
/// motion that was recorded without what they look at.
[[nodiscard]] AskedConditions MakeConditions(const ConditionArguments& arguments, const SessionArguments& opened,
                                             const SceneInput& input, const WatchedFacts& facts);
[[nodiscard]] AskedConditions MakeConditions(const ConditionArguments& arguments, const SessionArguments& opened,
                                             const SceneInput& input, const Session& session);
/// Those, and the marks of a track as well: for what shows a session rather than judges it.
[[nodiscard]] AskedConditions MakeConditionsAndMarks(const ConditionArguments& arguments,
                                                     const SessionArguments& opened, const SceneInput& input,
                                                     const Session& session);
/// Whether any was asked for.
[[nodiscard]] bool IsAnyAsked(const ConditionArguments& arguments);

}  // namespace testbed
