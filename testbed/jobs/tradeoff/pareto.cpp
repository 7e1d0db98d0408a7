// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of pareto.h.

#include "testbed/jobs/tradeoff/pareto.h"

#include <algorithm>
#include <cmath>
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

Gain Compare(std::span<const TradePoint> points, const TradePoint& setting) {
    Gain gain;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const TradePoint& p = points[i];
        if (p.error <= setting.error && (!gain.cheapest || p.cost < points[*gain.cheapest].cost)) gain.cheapest = i;
        if (p.cost <= setting.cost && (!gain.closest || p.error < points[*gain.closest].error)) gain.closest = i;
    }
    // Where the setting itself failed, any point is as accurate and the ratio of errors says nothing.
    if (gain.cheapest) gain.speedUp = setting.cost / points[*gain.cheapest].cost;
    if (gain.closest && std::isfinite(setting.error)) gain.errorRatio = setting.error / points[*gain.closest].error;
    return gain;
}

}  // namespace testbed
