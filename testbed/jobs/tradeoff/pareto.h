// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Error against cost: which settings no other beats, and how one engine's choice compares with another's setting at
// equal accuracy and at equal cost.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace testbed {

/// A setting by what it costs and how far off it is. Errors are floored at their rounding, so they are above 0.
struct TradePoint {
    double cost = 0.0;   ///< any unit, > 0
    double error = 0.0;  ///< any unit, > 0; infinity: it failed
};

/// Indices of the points that no other point equals or beats in both, by rising cost. Failed points are never among
/// them.
[[nodiscard]] std::vector<std::size_t> FindFront(std::span<const TradePoint> points);

/// A setting by what it costs and all that it gets wrong.
struct ErrorPoint {
    double cost = 0.0;           ///< any unit, > 0
    std::vector<double> errors;  ///< of every point the same ones, each > 0
    bool failed = false;         ///< it is no worse or better than others: nothing of the scenario was left to measure
};

/// Whether no error of `one` is above that of `other`.
[[nodiscard]] bool IsAsAccurate(const ErrorPoint& one, const ErrorPoint& other);
/// How many times smaller the errors of `one` are than those of `other`: of the error that gains least.
[[nodiscard]] double CompareErrors(const ErrorPoint& one, const ErrorPoint& other);

/// What a choice of settings gains over one setting. Points that failed are never chosen, and nothing is gained over a
/// setting that failed.
struct Gain {
    std::optional<std::size_t> cheapest;  ///< the cheapest point that is at least as accurate; none: no point is
    std::optional<std::size_t> closest;   ///< the most accurate point that costs no more; none: all cost more
    std::optional<double> speedUp;        ///< cost of the setting over that of `cheapest`
    std::optional<double> errorRatio;     ///< CompareErrors of `closest` and the setting
};
[[nodiscard]] Gain Compare(std::span<const ErrorPoint> points, const ErrorPoint& setting);

}  // namespace testbed
