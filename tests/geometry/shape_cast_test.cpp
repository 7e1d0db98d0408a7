// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Linear shape cast: against marching in double, against Box2D 2.4.1, in closed form, and with degenerate input.

#include <gtest/gtest.h>

#include <limits>

#include "tests/geometry/convex_oracle.h"

namespace scree::test {
namespace {

constexpr double tolerance = 0.5 * static_cast<double>(linearSlop);
// Coordinates below 20 m in float.
constexpr double rounding = 1.0e-5;

struct Trial {
    AnyShape shapeA, shapeB;
    ShapeCastInput input;

    explicit Trial(Source& source) : shapeA(AnyShape::Random(source)), shapeB(AnyShape::Random(source)) {
        input.proxyA = ProxyOf(shapeA);
        input.proxyB = ProxyOf(shapeB);
        input.transformA.Set(source.InSquare(1.0f), source.Between(-7.0f, 7.0f));
        input.transformB.Set(source.InSquare(4.0f), source.Between(-7.0f, 7.0f));
        input.translationB = source.InSquare(2.0f) - source.Between(0.0f, 2.0f) * input.transformB.p;
    }
    [[nodiscard]] bool CastTwin(b2ShapeCastOutput& output) const {
        b2ShapeCastInput twin;
        twin.proxyA = TwinProxyOf(shapeA);
        twin.proxyB = TwinProxyOf(shapeB);
        twin.transformA = ToBox2d(input.transformA);
        twin.transformB = ToBox2d(input.transformB);
        twin.translationB = ToBox2d(input.translationB);
        return b2ShapeCast(&output, &twin);
    }
};

double Target(const ShapeCastInput& input) {
    const float radii = Max(input.proxyA.m_radius, polygonRadius) + Max(input.proxyB.m_radius, polygonRadius);
    return static_cast<double>(Max(polygonRadius, radii - polygonRadius));
}

Outline Move(Outline outline, Vec2d by) {
    for (Vec2d& v : outline) v = v + by;
    return outline;
}

double DistanceAt(const ShapeCastInput& input, double lambda) {
    return OutlineDistance(Place(input.proxyA, input.transformA),
                           Move(Place(input.proxyB, input.transformB), lambda * ToDouble(input.translationB)));
}

/// The first lambda at which the cores are `target` apart, by marching and bisection; 2 if none is found.
double March(const ShapeCastInput& input, double target) {
    constexpr int steps = 300;
    for (int i = 1; i <= steps; ++i) {
        double free = static_cast<double>(i - 1) / steps, hit = static_cast<double>(i) / steps;
        if (DistanceAt(input, hit) > target) continue;
        for (int k = 0; k < 30; ++k) {
            const double middle = 0.5 * (free + hit);
            (DistanceAt(input, middle) > target ? free : hit) = middle;
        }
        return hit;
    }
    return 2.0;
}

TEST(ShapeCast, IsTheFirstTouchOfMarching) {
    Source source(231);
    int hits = 0;
    int misses = 0;
    for (int i = 0; i < 10000; ++i) {
        const Trial trial(source);
        const ShapeCastInput& input = trial.input;
        const double target = Target(input);
        const double start = DistanceAt(input, 0.0);
        if (start <= target + tolerance + rounding) continue;
        ShapeCastOutput output;
        const bool isHit = ShapeCast(&output, &input);
        const double first = March(input, target);
        const double length = static_cast<double>(input.translationB.Length());
        if (!isHit) {
            ++misses;
            ASSERT_EQ(output.lambda, 1.0f);
            ASSERT_EQ(output.normal, vec2Zero);
            ASSERT_TRUE(first > 1.0 || DistanceAt(input, 1.0) > target - rounding) << i << " touches at " << first;
            continue;
        }
        ++hits;
        const double lambda = static_cast<double>(output.lambda);
        ASSERT_LE(lambda, first + rounding / length) << i << " too late";
        ASSERT_GE(DistanceAt(input, lambda), target - rounding) << i << " too deep";
        ASSERT_LE(DistanceAt(input, lambda), target + tolerance + rounding) << i << " too early";
        ASSERT_NEAR(output.normal.Length(), 1.0f, 1.0e-5f);
        // The point lies on A's surface, and B's core is straight ahead of it.
        const Outline a = Place(input.proxyA, input.transformA);
        const double radiusA = static_cast<double>(Max(input.proxyA.m_radius, polygonRadius));
        ASSERT_NEAR(OutlineDistance(a, {ToDouble(output.point)}), radiusA, rounding) << i;
        const Outline b = Move(Place(input.proxyB, input.transformB), lambda * ToDouble(input.translationB));
        const double ahead = DistanceAt(input, lambda) - radiusA;
        ASSERT_NEAR(OutlineDistance(b, {ToDouble(output.point) + ahead * ToDouble(output.normal)}), 0.0, 1.0e-4) << i;
    }
    EXPECT_GT(hits, 3000);
    EXPECT_GT(misses, 1000);
}

TEST(ShapeCast, AgreesWithBox2d) {
    constexpr int trials = 100000;
    Source source(232);
    int told = 0;
    int apart = 0;
    int touchingAtStart = 0;
    for (int i = 0; i < trials; ++i) {
        const Trial trial(source);
        ShapeCastOutput ours;
        b2ShapeCastOutput theirs;
        const bool isHit = ShapeCast(&ours, &trial.input);
        const bool isTwinHit = trial.CastTwin(theirs);
        const double target = Target(trial.input);
        if (DistanceAt(trial.input, 0.0) <= target + tolerance + rounding) {
            touchingAtStart += isHit != isTwinHit;
            continue;
        }
        if (isHit != isTwinHit) {
            ++told;
            if (isHit) {
                ASSERT_LE(DistanceAt(trial.input, static_cast<double>(ours.lambda)), target + tolerance + rounding)
                    << i;
            } else {
                ASSERT_GT(March(trial.input, target - rounding), 1.0) << i;
            }
            continue;
        }
        if (!isHit) continue;
        // Either may stop anywhere within the tolerance, which a slanted approach stretches.
        const double path = std::fabs(ours.lambda - theirs.lambda) * trial.input.translationB.Length();
        const Vec2 direction = (1.0f / trial.input.translationB.Length()) * trial.input.translationB;
        const double slant = std::max(-static_cast<double>(Dot(ours.normal, direction)), 1.0e-3);
        apart += path > 2.0 * tolerance / slant + rounding;
    }
    std::cout << "told apart " << told << ", lambdas apart " << apart << ", at the start " << touchingAtStart << "\n";
    EXPECT_LT(told, trials / 200);
    EXPECT_LT(apart, trials / 1000);
    EXPECT_LT(touchingAtStart, trials / 100);
}

TEST(ShapeCast, MeetsTheClosedForm) {
    // Balls of 0.5 m: cores that come within 1 − polygonRadius.
    const AnyShape ball = AnyShape::Circle(0.5f);
    ShapeCastInput input{ProxyOf(ball), ProxyOf(ball), {}, {}, {-20.0f, 0.0f}};
    input.transformA.SetIdentity();
    input.transformB.Set({10.0f, 0.6f}, 0.0f);
    ShapeCastOutput output;
    ASSERT_TRUE(ShapeCast(&output, &input));
    const double reach = 1.0 - static_cast<double>(polygonRadius);
    const double side = std::sqrt(reach * reach - 0.36);
    EXPECT_NEAR(20.0 * static_cast<double>(output.lambda), 10.0 - side, tolerance * reach / side);
    EXPECT_NEAR(output.normal.x, side / reach, 0.005);
    EXPECT_NEAR(output.point.Length(), 0.5f, 1.0e-5f);

    input.transformB.p.y = 1.0f;
    EXPECT_FALSE(ShapeCast(&output, &input)) << "passes by";
    input.transformB.p.y = 0.6f;
    input.translationB = {20.0f, 0.0f};
    EXPECT_FALSE(ShapeCast(&output, &input)) << "flies away";
    input.translationB = {-9.0f, 0.0f};
    EXPECT_FALSE(ShapeCast(&output, &input)) << "stops short";
}

TEST(ShapeCast, HoldsFarFromTheOrigin) {
    const AnyShape ground = AnyShape::Edge({-1.0f, 0.0f}, {1.0f, 0.0f});
    const AnyShape box = AnyShape::Box(0.5f, 0.5f);
    ShapeCastInput input{ProxyOf(ground), ProxyOf(box), {}, {}, {0.0f, -8.0f}};
    input.transformA.Set({1.0e5f, 1.0e5f}, 0.0f);
    input.transformB.Set({1.0e5f, 1.0e5f + 4.5f}, 0.0f);
    ShapeCastOutput output;
    ASSERT_TRUE(ShapeCast(&output, &input));
    EXPECT_NEAR(output.lambda, (4.0f - polygonRadius) / 8.0f, 1.0e-6f);
}

TEST(ShapeCast, DegenerateInputEnds) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const AnyShape box = AnyShape::Box(0.5f, 0.5f);
    const AnyShape point = AnyShape::Edge({0.0f, 0.0f}, {0.0f, 0.0f});
    ShapeCastInput input{ProxyOf(box), ProxyOf(box), {}, {}, {1.0f, 0.0f}};
    input.transformA.SetIdentity();
    input.transformB.SetIdentity();
    ShapeCastOutput output;
    EXPECT_FALSE(ShapeCast(&output, &input)) << "identical shapes overlap";
    EXPECT_EQ(output.lambda, 1.0f);

    input.transformB.p = {3.0f, 0.0f};
    input.translationB = vec2Zero;
    EXPECT_FALSE(ShapeCast(&output, &input)) << "no motion";

    input.proxyB = ProxyOf(point);
    input.translationB = {-4.0f, 0.0f};
    EXPECT_TRUE(ShapeCast(&output, &input)) << "an edge without length";
    EXPECT_NEAR(output.lambda, (2.5f - polygonRadius) / 4.0f, 1.0e-3f);

    for (float* field : {&input.translationB.x, &input.transformB.p.y, &input.transformA.q.s}) {
        const float good = *field;
        *field = nan;
        EXPECT_FALSE(ShapeCast(&output, &input));
        *field = good;
    }
    input.translationB = {-3.0e38f, 0.0f};
    ShapeCast(&output, &input);
    EXPECT_TRUE(output.lambda >= 0.0f && output.lambda <= 1.0f);
    input.proxyA = DistanceProxy{};
    EXPECT_FALSE(ShapeCast(&output, &input)) << "an empty proxy";
}

}  // namespace
}  // namespace scree::test
