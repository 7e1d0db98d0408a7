// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The numbers behind the scenes: sine and cosine against the C library, the random generator against reference values.

#include "scenes/build.h"

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <cmath>
#include <stdexcept>

namespace {

TEST(SinCos, AgreesWithTheCLibrary) {
    // Both are within 1 ulp of the truth (1.1e-16 near 1), and the series' rounding adds a few.
    static constexpr double tolerance = 1e-15;
    EXPECT_TRUE(rc::check("sine and cosine", [] {
        const double angle = *rc::gen::inRange<std::int64_t>(-1'000'000'000, 1'000'000'001) * 1e-3;
        const auto [sin, cos] = scenes::SinCos(angle);
        RC_ASSERT(std::abs(sin - std::sin(angle)) <= tolerance);
        RC_ASSERT(std::abs(cos - std::cos(angle)) <= tolerance);
    }));
    for (int k = -40; k <= 40; ++k) {  // around the seams of the reduction
        for (double nudge : {-1e-9, 0.0, 1e-9}) {
            const double angle = k * 0.78539816339744830962 + nudge;
            const auto [sin, cos] = scenes::SinCos(angle);
            EXPECT_NEAR(sin, std::sin(angle), tolerance) << angle;
            EXPECT_NEAR(cos, std::cos(angle), tolerance) << angle;
        }
    }
}

TEST(Random, IsPcg32) {
    // The published check values of the one-sequence generator seeded with 42 (pcg-cpp, check-pcg32_oneseq).
    scenes::Random random(42);
    for (std::uint32_t expected : {0xc2f57bd6u, 0x6b07c4a9u, 0x72b7b29bu, 0x44215383u, 0xf5af5eadu, 0x68beb632u})
        EXPECT_EQ(random.Next(), expected);
}

TEST(Random, IsUniform) {
    // 64,000 draws into 64 bins: chi-square of 63 degrees of freedom, mean 63, deviation 11.2; 120 is five deviations.
    scenes::Random random(7);
    int bins[64] = {};
    for (int i = 0; i < 64000; ++i) {
        const double value = random.Uniform(-6.0, 0.0);
        ASSERT_GE(value, -6.0);
        ASSERT_LT(value, 0.0);
        ++bins[static_cast<int>((value + 6.0) / 6.0 * 64.0)];
    }
    double chiSquare = 0.0;
    for (int count : bins) chiSquare += (count - 1000.0) * (count - 1000.0) / 1000.0;
    EXPECT_LT(chiSquare, 120.0);
}

TEST(Shapes, PolygonsHaveThreeToEightVertices) {
    const scenes::Vec2 v{};
    EXPECT_THROW((void)scenes::Polygon({v, v}), std::invalid_argument);
    EXPECT_THROW((void)scenes::Polygon({v, v, v, v, v, v, v, v, v}), std::invalid_argument);
    EXPECT_EQ(scenes::Polygon({v, v, v, v, v, v, v, v}).Vertices().size(), 8u);
}

TEST(Shapes, CirclesAndBoxesHaveNoVertices) {
    EXPECT_TRUE(scenes::Circle(1.0).Vertices().empty());
    EXPECT_TRUE(scenes::Box(1.0, 2.0).Vertices().empty());
    EXPECT_EQ(scenes::Edge({1.0f, 0.0f}, {0.0f, 0.0f}).Vertices().size(), 2u);
}

}  // namespace
