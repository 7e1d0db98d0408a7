// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of pareto.h.

#include "testbed/jobs/tradeoff/pareto.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

namespace testbed {

std::vector<std::size_t> FindFront(std::span<const TradePoint> points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        return points[a].cost != points[b].cost ? points[a].cost < points[b].cost : points[a].error < points[b].error;
    });
    std::vector<std::size_t> front;
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order) {
        if (points[i].error < least) {
            least = points[i].error;
            front.push_back(i);
        }
    }
    return front;
}

bool IsAsAccurate(const ErrorPoint& one, const ErrorPoint& other) {
    return std::ranges::equal(one.errors, other.errors, std::less_equal{});
}

double CompareErrors(const ErrorPoint& one, const ErrorPoint& other) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < one.errors.size(); ++i) least = std::min(least, other.errors[i] / one.errors[i]);
    return least;
}

Gain Compare(std::span<const ErrorPoint> points, const ErrorPoint& setting) {
    Gain gain;
    if (setting.failed) return gain;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const ErrorPoint& p = points[i];
        if (p.failed) continue;
        if (IsAsAccurate(p, setting) && (!gain.cheapest || p.cost < points[*gain.cheapest].cost)) gain.cheapest = i;
        if (p.cost > setting.cost) continue;
        const double ratio = CompareErrors(p, setting);
        if (gain.errorRatio && ratio <= *gain.errorRatio) continue;
        gain.closest = i;
        gain.errorRatio = ratio;
    }
    if (gain.cheapest) gain.speedUp = setting.cost / points[*gain.cheapest].cost;
    return gain;
}

}  // namespace testbed
