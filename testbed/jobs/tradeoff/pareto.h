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

/// What a choice of settings gains over one setting.
struct Gain {
    std::optional<std::size_t> cheapest;  ///< the cheapest point that is at least as accurate; none: no point is
    std::optional<std::size_t> closest;   ///< the most accurate point that costs no more; none: all cost more
    std::optional<double> speedUp;        ///< cost of the setting over that of `cheapest`
    std::optional<double> errorRatio;     ///< error of the setting over that of `closest`

    /// Whether the setting is beaten in neither way, or one of them is out of reach.
    [[nodiscard]] bool IsLost() const { return !speedUp || *speedUp < 1.0 || !errorRatio || *errorRatio < 1.0; }
};
[[nodiscard]] Gain Compare(std::span<const TradePoint> points, const TradePoint& setting);

}  // namespace testbed
