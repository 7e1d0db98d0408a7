// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of statistics.h.

#include "testbed/base/statistics.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace testbed {

std::size_t NearestRank(std::size_t count, double part) {
    return static_cast<std::size_t>(std::max(1.0, std::ceil(part * static_cast<double>(count)))) - 1;
}

double NearestRankQuantile(std::span<const double> values, double part) {
    if (values.empty()) return 0.0;
    std::vector<double> sorted(values.begin(), values.end());
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(NearestRank(sorted.size(), part));
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
}

double Quantile(std::span<const double> values, double part) {
    if (values.empty()) return 0.0;
    std::vector<double> sorted(values.begin(), values.end());
    const double place = part * static_cast<double>(sorted.size() - 1);
    const auto below = sorted.begin() + static_cast<std::ptrdiff_t>(place);
    std::nth_element(sorted.begin(), below, sorted.end());
    const double low = *below, share = place - std::floor(place);
    if (share == 0.0) return low;
    return std::lerp(low, *std::min_element(below + 1, sorted.end()), share);
}

Quartiles FindQuartiles(std::span<const double> values) {
    return {Quantile(values, 0.25), Quantile(values, 0.5), Quantile(values, 0.75)};
}

std::optional<double> GeometricMean(std::span<const double> values) {
    if (values.empty()) return std::nullopt;
    double sum = 0.0;
    for (const double value : values) sum += std::log(value);
    return std::exp(sum / static_cast<double>(values.size()));
}

}  // namespace testbed
