// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Pareto fronts against a brute force, and gains on points whose answer is plain.

#include "testbed/jobs/tradeoff/pareto.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <utility>
#include <vector>

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

ErrorPoint MakePoint(double cost, std::vector<double> errors) {
    const bool isLost = std::ranges::any_of(errors, [](double error) { return error == failed; });
    return {cost, std::move(errors), isLost};
}

TEST(Gain, ComparesAtEqualAccuracyAndAtEqualCost) {
    const std::vector<ErrorPoint> ours = {MakePoint(10.0, {0.5}), MakePoint(20.0, {0.1}), MakePoint(50.0, {0.01})};
    const Gain gain = Compare(ours, MakePoint(40.0, {0.2}));
    EXPECT_EQ(gain.cheapest, 1u);
    EXPECT_DOUBLE_EQ(*gain.speedUp, 2.0);
    EXPECT_EQ(gain.closest, 1u);
    EXPECT_DOUBLE_EQ(*gain.errorRatio, 2.0);
}

TEST(Gain, CountsEveryError) {
    // Cheap and exact in the first error, far off in the second.
    const std::vector<ErrorPoint> ours = {MakePoint(10.0, {0.001, 0.9}), MakePoint(30.0, {0.05, 0.25})};
    const Gain gain = Compare(ours, MakePoint(60.0, {0.1, 0.5}));
    EXPECT_EQ(gain.cheapest, 1u);
    EXPECT_DOUBLE_EQ(*gain.speedUp, 2.0);
    EXPECT_EQ(gain.closest, 1u);
    EXPECT_DOUBLE_EQ(*gain.errorRatio, 2.0) << "both errors are half";
}

TEST(Gain, WhatIsOutOfReachIsNone) {
    const std::vector<ErrorPoint> ours = {MakePoint(10.0, {0.5}), MakePoint(20.0, {failed})};
    const Gain inaccurate = Compare(ours, MakePoint(40.0, {0.2}));
    EXPECT_FALSE(inaccurate.speedUp);
    EXPECT_DOUBLE_EQ(*inaccurate.errorRatio, 0.4);
    const Gain dear = Compare(ours, MakePoint(5.0, {0.6}));
    EXPECT_FALSE(dear.errorRatio);
    EXPECT_DOUBLE_EQ(*dear.speedUp, 0.5);
}

TEST(Gain, NothingIsAsAccurateAsAFailure) {
    const std::vector<ErrorPoint> ours = {MakePoint(10.0, {failed}), MakePoint(20.0, {3.0})};
    EXPECT_EQ(Compare(ours, MakePoint(30.0, {5.0})).cheapest, 1u);
    EXPECT_EQ(Compare(ours, MakePoint(30.0, {5.0})).closest, 1u);
    const Gain none = Compare(ours, MakePoint(30.0, {failed}));
    EXPECT_FALSE(none.speedUp || none.errorRatio);
    // A failure may also be an error of finite size: then every point says so.
    std::vector<ErrorPoint> fallen = ours;
    fallen[1].failed = true;
    EXPECT_FALSE(Compare(fallen, MakePoint(30.0, {5.0})).speedUp);
}

TEST(Gain, IsThatOfABruteForce) {
    std::mt19937 random(11);
    for (int round = 0; round < 300; ++round) {
        const auto draw = [&] { return 1.0 + static_cast<double>(random() % 5); };
        std::vector<ErrorPoint> points;
        for (int i = 0; i < 10; ++i) points.push_back({draw(), {draw(), draw(), draw()}, random() % 5 == 0});
        const ErrorPoint setting{draw(), {draw(), draw(), draw()}, false};
        double cheapest = failed, best = 0.0;
        for (const ErrorPoint& p : points) {
            if (p.failed) continue;
            double ratio = failed;
            for (std::size_t i = 0; i < 3; ++i) ratio = std::min(ratio, setting.errors[i] / p.errors[i]);
            if (ratio >= 1.0) cheapest = std::min(cheapest, p.cost);
            if (p.cost <= setting.cost) best = std::max(best, ratio);
        }
        const Gain gain = Compare(points, setting);
        EXPECT_EQ(gain.speedUp.value_or(0.0), cheapest == failed ? 0.0 : setting.cost / cheapest);
        EXPECT_EQ(gain.errorRatio.value_or(0.0), best);
    }
}

}  // namespace
}  // namespace testbed
