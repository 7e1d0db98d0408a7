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

/// Why a law says nothing about the trade, or that it does.
enum class Standing {
    compared,
    cannotTrade,    ///< no number of iterations changes Box2D's errors: what is measured is the speed of free bodies
    baselineFails,  ///< nothing is as accurate as a column that has fallen
};

/// One law: what our settings and what Box2D's own gain by the same rule over Box2D at 8/3 and 60 Hz.
struct LawGain {
    const Law* law = nullptr;
    Standing standing = Standing::compared;
    Gain ours, box2d, box2d3;                  ///< of the last one nothing where it was not measured
    std::optional<RunSpec> cheapest, closest;  ///< what the indices of `ours` stand for

    /// Where both engines choose their settings: cost of Box2D's cheapest over that of ours, both at least as accurate
    /// as Box2D at 8/3; none: ours reaches it with no setting.
    [[nodiscard]] std::optional<double> GetSpeedUp() const;
    /// Errors of Box2D's most accurate setting over those of ours, both at the cost of Box2D at 8/3 or less.
    [[nodiscard]] std::optional<double> GetErrorRatio() const;
    /// Whether the law is compared and one of both is below 1 or out of reach.
    [[nodiscard]] bool IsLost() const;
    /// Whether Box2D 3 is as accurate as Box2D at 8/3 for less than ours, and whether it is closer at that cost.
    [[nodiscard]] bool IsBox2d3Faster() const;
    [[nodiscard]] bool IsBox2d3Closer() const;
};
/// One per law whose baseline is among the cases, in the order of GetLaws. `families` are those of ours to choose from.
[[nodiscard]] std::vector<LawGain> CompareWithBaseline(std::span<const TradeCase> cases,
                                                       std::span<const Family> families);

/// Medians over the laws that are compared. What is out of reach counts as below all others.
struct Headline {
    std::optional<double> speedUp, errorRatio;
    int laws = 0;                    ///< that are compared
    int fasterIn = 0, closerIn = 0;  ///< of these: at least 1
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
/// Whether a bound was missed.
[[nodiscard]] bool HasMiss(std::span<const BoundRow> rows);

}  // namespace testbed
