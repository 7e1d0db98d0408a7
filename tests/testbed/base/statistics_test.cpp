// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Quantiles and means against their definitions, on samples of any size and with equal values.

#include "testbed/base/statistics.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace testbed {
namespace {

std::vector<double> MakeValues(std::mt19937& random, int count) {
    std::vector<double> values(static_cast<std::size_t>(count));
    for (double& value : values) value = static_cast<double>(random() % 50);
    return values;
}

TEST(Statistics, TheNearestRankIsTheLeastValueThatItsShareDoesNotExceed) {
    EXPECT_EQ(NearestRankQuantile({}, 0.5), 0.0);
    std::mt19937 random(7);
    for (const int count : {1, 2, 3, 99, 100, 101, 1000}) {
        const std::vector<double> values = MakeValues(random, count);
        for (const double part : {0.5, 0.99, 1.0}) {
            const double quantile = NearestRankQuantile(values, part);
            const auto below = std::count_if(values.begin(), values.end(), [&](double v) { return v < quantile; });
            const auto notAbove = std::count_if(values.begin(), values.end(), [&](double v) { return v <= quantile; });
            // 1e-9 absorbs part × count in double.
            EXPECT_GE(static_cast<double>(notAbove), part * count - 1e-9);
            EXPECT_LT(static_cast<double>(below), part * count - 1e-9);
        }
    }
}

TEST(Statistics, QuantilesBetweenNeighboursFollowTheLineThroughThem) {
    EXPECT_EQ(Quantile({}, 0.5), 0.0);
    EXPECT_TRUE(rc::check("sorted values are the knots of a line", [] {
        std::mt19937 random(*rc::gen::arbitrary<unsigned>());
        std::vector<double> values = MakeValues(random, *rc::gen::inRange(1, 40));
        std::vector<double> sorted = values;
        std::ranges::sort(sorted);
        for (std::size_t i = 0; i + 1 < sorted.size(); ++i) {
            const double share = std::uniform_real_distribution<double>(0.01, 0.99)(random);
            const double part = (static_cast<double>(i) + share) / static_cast<double>(sorted.size() - 1);
            const double expected = sorted[i] + share * (sorted[i + 1] - sorted[i]);
            RC_ASSERT(std::abs(Quantile(values, part) - expected) < 1e-9);
        }
        RC_ASSERT(Quantile(values, 0.0) == sorted.front());
        RC_ASSERT(Quantile(values, 1.0) == sorted.back());
        const double low = sorted[(sorted.size() - 1) / 2], high = sorted[sorted.size() / 2];
        RC_ASSERT(Quantile(values, 0.5) == 0.5 * (low + high));
    }));
}

TEST(Statistics, QuartilesHalveTheHalves) {
    const double values[] = {5.0, 1.0, 4.0, 2.0, 3.0};
    const Quartiles q = FindQuartiles(values);
    EXPECT_DOUBLE_EQ(q.low, 2.0);
    EXPECT_DOUBLE_EQ(q.median, 3.0);
    EXPECT_DOUBLE_EQ(q.high, 4.0);
}

TEST(Statistics, TheGeometricMeanScalesWithItsValues) {
    EXPECT_FALSE(GeometricMean({}));
    EXPECT_TRUE(rc::check("mean of scaled values", [] {
        const auto exponents = *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(-20, 20)));
        const double factor = *rc::gen::inRange(1, 100);
        std::vector<double> values, scaled;
        double sum = 0;
        for (const int exponent : exponents) {
            values.push_back(std::exp2(exponent));
            scaled.push_back(factor * values.back());
            sum += exponent;
        }
        const double mean = std::exp2(sum / static_cast<double>(exponents.size()));
        RC_ASSERT(std::abs(*GeometricMean(values) / mean - 1) < 1e-12);
        RC_ASSERT(std::abs(*GeometricMean(scaled) / (factor * mean) - 1) < 1e-12);
    }));
}

}  // namespace
}  // namespace testbed
