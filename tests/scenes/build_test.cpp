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

TEST(Shapes, RegularPolygonsHaveTheirVerticesOnACircle) {
    EXPECT_THROW((void)scenes::RegularPolygon(2, 1.0), std::invalid_argument);
    EXPECT_THROW((void)scenes::RegularPolygon(9, 1.0), std::invalid_argument);
    const scenes::Shape hexagon = scenes::RegularPolygon(6, 2.0, {1.0f, -1.0f});
    ASSERT_EQ(hexagon.Vertices().size(), 6u);
    EXPECT_EQ(hexagon.vertices[0], (scenes::Vec2{3.0f, -1.0f}));
    for (const scenes::Vec2 v : hexagon.Vertices()) EXPECT_NEAR(std::hypot(v.x - 1.0f, v.y + 1.0f), 2.0f, 1e-6f);
    EXPECT_GT(hexagon.vertices[1].y, -1.0f) << "counter-clockwise";
}

TEST(Chains, ChildrenAreTheSegmentsWithTheirNeighboursAsGhosts) {
    scenes::Scene scene;
    scene.chainVertices.push_back({99.0f, 99.0f});  // of another chain
    const scenes::Vec2 v[] = {{0.0f, 0.0f}, {1.0f, 0.0f}, {2.0f, 1.0f}, {2.0f, 3.0f}};
    const scenes::Shape open = scenes::Chain(scene, v);
    ASSERT_EQ(open.ChildCount(), 3);
    EXPECT_FALSE(open.IsLoop());
    // Straight on beyond both ends.
    EXPECT_EQ(scenes::ChildOf(scene, open, 0), scenes::OneSidedEdge({-1.0f, 0.0f}, v[0], v[1], v[2]));
    EXPECT_EQ(scenes::ChildOf(scene, open, 1), scenes::OneSidedEdge(v[0], v[1], v[2], v[3]));
    EXPECT_EQ(scenes::ChildOf(scene, open, 2), scenes::OneSidedEdge(v[1], v[2], v[3], {2.0f, 5.0f}));

    const scenes::Shape loop = scenes::Loop(scene, v);
    ASSERT_EQ(loop.ChildCount(), 4);
    EXPECT_TRUE(loop.IsLoop());
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(scenes::ChildOf(scene, loop, i),
                  scenes::OneSidedEdge(v[(i + 3) % 4], v[i], v[(i + 1) % 4], v[(i + 2) % 4]))
            << i;
    }
    EXPECT_EQ(scene.chainVertices.size(), 9u);
}

TEST(Chains, OtherShapesAreTheirOwnOnlyChild) {
    const scenes::Scene scene;
    const scenes::Shape box = scenes::Box(1.0, 2.0, {3.0f, 4.0f}, 0.5);
    EXPECT_EQ(box.ChildCount(), 1);
    EXPECT_EQ(scenes::ChildOf(scene, box, 0), box);
}

TEST(Chains, TooFewVerticesAreRefused) {
    scenes::Scene scene;
    const scenes::Vec2 v[] = {{0.0f, 0.0f}, {1.0f, 0.0f}};
    EXPECT_THROW((void)scenes::Chain(scene, {v, 1}), std::invalid_argument);
    EXPECT_THROW((void)scenes::Loop(scene, v), std::invalid_argument);
    EXPECT_TRUE(scene.chainVertices.empty());
}

TEST(Shapes, CirclesAndBoxesHaveNoVertices) {
    EXPECT_TRUE(scenes::Circle(1.0).Vertices().empty());
    EXPECT_TRUE(scenes::Box(1.0, 2.0).Vertices().empty());
    EXPECT_EQ(scenes::Edge({1.0f, 0.0f}, {0.0f, 0.0f}).Vertices().size(), 2u);
    EXPECT_FALSE(scenes::Edge({1.0f, 0.0f}, {0.0f, 0.0f}).IsOneSidedEdge());
}

}  // namespace
