// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the measured trade comes to: gains over Box2D's default by law, and which bounds the dial meets.

#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "testbed/jobs/tradeoff/trade.h"

namespace testbed {

/// A family of settings that is compared as a whole.
enum class Family { box2d, sequential, soft };
[[nodiscard]] Family FamilyOf(const RunSpec& setting);
/// "Box2D 2.4.1", "Scree, sequential impulses", "Scree, soft step".
[[nodiscard]] std::string NameFamily(Family family);

/// Gains of our settings over Box2D at 8/3 and 60 Hz in one law.
struct LawGain {
    const Law* law = nullptr;
    Gain gain;
    std::optional<RunSpec> cheapest, closest;  ///< what Gain's indices stand for
};
/// One per law whose baseline is among the cases, in the order of GetLaws. `families` are those to choose from.
[[nodiscard]] std::vector<LawGain> CompareWithBaseline(std::span<const TradeCase> cases,
                                                       std::span<const Family> families);

/// Geometric means over the laws where there is a value, and how many those are.
struct Headline {
    std::optional<double> speedUp, errorRatio;
    int laws = 0, withSpeedUp = 0, withErrorRatio = 0;
};
[[nodiscard]] Headline Summarise(std::span<const LawGain> gains);

/// One error of one law with its bounds and what the compared settings reach; none: not measured in this run.
struct BoundRow {
    const Law* law = nullptr;
    const LawError* error = nullptr;
    std::optional<double> game, precise, sequential, box2d;

    [[nodiscard]] std::optional<bool> MeetsGame() const;     ///< none: no bound or not measured
    [[nodiscard]] std::optional<bool> MeetsPrecise() const;  ///< none: no bound or not measured
};
[[nodiscard]] std::vector<BoundRow> CheckBounds(std::span<const TradeCase> cases);

}  // namespace testbed
