// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Pareto fronts against a brute force, and gains on points whose answer is plain.

#include "testbed/jobs/tradeoff/pareto.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace testbed {
namespace {

constexpr double failed = std::numeric_limits<double>::infinity();

TEST(Pareto, TheFrontIsWhatNoOtherPointBeats) {
    std::mt19937 random(7);
    for (int round = 0; round < 200; ++round) {
        std::vector<TradePoint> points;
        for (int i = 0; i < 12; ++i) {  // few values, so that ties are common
            points.push_back({1.0 + static_cast<double>(random() % 6), 1.0 + static_cast<double>(random() % 6)});
        }
        if (round % 3 == 0) points[random() % 12].error = failed;
        const std::vector<std::size_t> front = FindFront(points);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const bool beaten = std::ranges::any_of(points, [&](const TradePoint& other) {
                return other.cost <= points[i].cost && other.error <= points[i].error &&
                       (other.cost < points[i].cost || other.error < points[i].error);
            });
            const bool found = std::ranges::any_of(front, [&](std::size_t j) {
                return points[j].cost == points[i].cost && points[j].error == points[i].error;
            });
            EXPECT_EQ(found, !beaten && points[i].error != failed) << round << ": " << i;
        }
        for (std::size_t k = 1; k < front.size(); ++k) {
            EXPECT_LT(points[front[k - 1]].cost, points[front[k]].cost);
            EXPECT_GT(points[front[k - 1]].error, points[front[k]].error);
        }
    }
}

TEST(Pareto, GainsCompareAtEqualAccuracyAndAtEqualCost) {
    const std::vector<TradePoint> ours = {{10.0, 0.5}, {20.0, 0.1}, {50.0, 0.01}};
    const Gain gain = Compare(ours, {40.0, 0.2});
    EXPECT_EQ(gain.cheapest, 1u);
    EXPECT_DOUBLE_EQ(*gain.speedUp, 2.0);
    EXPECT_EQ(gain.closest, 1u);
    EXPECT_DOUBLE_EQ(*gain.errorRatio, 2.0);
    EXPECT_FALSE(gain.IsLost());
}

TEST(Pareto, WhatIsOutOfReachIsLost) {
    const std::vector<TradePoint> ours = {{10.0, 0.5}, {20.0, failed}};
    const Gain inaccurate = Compare(ours, {40.0, 0.2});
    EXPECT_FALSE(inaccurate.speedUp);
    EXPECT_DOUBLE_EQ(*inaccurate.errorRatio, 0.4);
    EXPECT_TRUE(inaccurate.IsLost());
    const Gain dear = Compare(ours, {5.0, 0.6});
    EXPECT_FALSE(dear.errorRatio);
    EXPECT_DOUBLE_EQ(*dear.speedUp, 0.5);
    EXPECT_TRUE(dear.IsLost());
}

TEST(Pareto, AFailedPointIsNeverChosenOverAFiniteOne) {
    const std::vector<TradePoint> ours = {{10.0, failed}, {20.0, 3.0}};
    EXPECT_EQ(Compare(ours, {30.0, 5.0}).cheapest, 1u);
    EXPECT_EQ(Compare(ours, {30.0, 5.0}).closest, 1u);
}

}  // namespace
}  // namespace testbed
