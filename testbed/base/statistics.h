// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Quantiles and means of samples in any order.

#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace testbed {

/// Index among `count` > 0 sorted values of the one that the share `part` (0…1) of them does not exceed (nearest rank,
/// counted from 0). part = 0.5: the lower median.
[[nodiscard]] std::size_t NearestRank(std::size_t count, double part);

/// The value at the nearest rank; 0 for none.
[[nodiscard]] double NearestRankQuantile(std::span<const double> values, double part);

/// By linear interpolation between neighbours in order, so that part = 0.5 of an even number of values is the mean of
/// the two in the middle; 0 for none.
[[nodiscard]] double Quantile(std::span<const double> values, double part);

struct Quartiles {
    double low = 0.0, median = 0.0, high = 0.0;
};
/// By linear interpolation.
[[nodiscard]] Quartiles FindQuartiles(std::span<const double> values);

/// exp of the mean of the logarithms; none for no values.
[[nodiscard]] std::optional<double> GeometricMean(std::span<const double> values);

}  // namespace testbed
