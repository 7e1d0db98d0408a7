// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The measurements of the laws on made-up trajectories. An exact one measures 0, a disturbed one what it was disturbed
// by. The closed forms agree with numbers known from elsewhere.

#include "testbed/engines/measure.h"

#include <gtest/gtest.h>

#include <numbers>

namespace testbed {
namespace {

BodyReading Moving(Point centre, Point velocity, double spin, double mass, double inertia) {
    BodyReading b;
    b.centre = centre;
    b.velocity = velocity;
    b.spin = spin;
    b.mass = mass;
    b.inertia = inertia;
    return b;
}

TEST(Measure, SumsWhatIsConserved) {
    const std::vector<BodyReading> bodies = {Moving({1.0, 2.0}, {3.0, 0.0}, 2.0, 2.0, 0.5),
                                             Moving({0.0, -1.0}, {0.0, 4.0}, 0.0, 1.0, 7.0)};
    const Invariants sum = SumInvariants(bodies);
    EXPECT_DOUBLE_EQ(sum.momentum.x, 6.0);
    EXPECT_DOUBLE_EQ(sum.momentum.y, 4.0);
    EXPECT_DOUBLE_EQ(sum.kinetic, 9.0 + 1.0 + 8.0);
    EXPECT_DOUBLE_EQ(sum.angular, 2.0 * (1.0 * 0.0 - 2.0 * 3.0) + 0.5 * 2.0);
}

TEST(Measure, DriftKeepsTheWorstAndGainIgnoresLoss) {
    const Invariants start{100.0, 10.0, {4.0, 3.0}};
    DriftWatch drift(start, 5.0, 10.0);
    drift.Add(start);
    EXPECT_EQ(drift.GetMomentum(), 0.0);
    EXPECT_EQ(drift.GetAngular(), 0.0);
    EXPECT_EQ(drift.GetGain(), 0.0);
    drift.Add({103.0, 10.5, {4.0, 3.5}});
    drift.Add({90.0, 9.0, {4.0, 3.0}});
    EXPECT_DOUBLE_EQ(drift.GetMomentum(), 0.1);
    EXPECT_DOUBLE_EQ(drift.GetAngular(), 0.1);
    EXPECT_NEAR(drift.GetGain(), 0.03, 1e-15);
    EXPECT_DOUBLE_EQ(drift.GetEnergy(), 0.9);
}

TEST(Measure, PassesOfASampledCosineAreAPeriodApart) {
    FallingPasses passes;
    const double period = 1.7;
    for (int i = 0; i < 300; ++i) {
        const double t = i / 60.0;
        passes.Add(t, std::cos(2.0 * std::numbers::pi * t / period));
    }
    ASSERT_GE(passes.GetTimes().size(), 2u);
    // Linear interpolation of a sine within one sample: (ωh)³/(72√3)/ω, about 1e-6 s.
    EXPECT_NEAR(passes.GetTimes()[0], 0.25 * period, 1e-5);
    EXPECT_NEAR(passes.GetTimes()[1] - passes.GetTimes()[0], period, 1e-5);
}

TEST(Measure, ApexesOfAnExactBounceAreExactBetweenSamples) {
    ApexFinder finder;
    const double speed = 9.3;  // off the floor; the apex is v²/2g
    for (int i = 0; i < 150; ++i) {
        const double t = 0.004 + i / 60.0, flight = 2.0 * speed / gravity, s = std::fmod(t, flight);
        finder.Add(speed * s - 0.5 * gravity * s * s, speed - gravity * s);
    }
    ASSERT_EQ(finder.GetApexes().size(), 1u);
    EXPECT_NEAR(finder.GetApexes()[0], speed * speed / (2.0 * gravity), 1e-12);
}

TEST(Measure, BisectionFindsTheEdge) {
    EXPECT_NEAR(Bisect(0.8, 1.2, 20, [](double x) { return x >= 1.0371; }), 1.0371, 0.4 / (1 << 20));
}

TEST(Measure, PendulumPeriodAgreesWithTheKnownOne) {
    const double mass = 0.1, inertia = mass * (1.0 + 0.01) / 12.0 + mass * 0.25;
    EXPECT_NEAR(PendulumPeriod(inertia, mass, 0.5, 0.5 * std::numbers::pi), 1.91727, 5e-6);
    // Small swings: 2π√(I/mgd), and the series' next term is amplitude²/16.
    const double small = 2.0 * std::numbers::pi * std::sqrt(inertia / (mass * gravity * 0.5));
    EXPECT_NEAR(PendulumPeriod(inertia, mass, 0.5, 0.1) / small, 1.0 + 0.01 / 16.0, 1e-6);
}

TEST(Measure, CatenaryOfFortyLinksAgreesWithTheKnownOne) {
    const Catenary bridge = SolveCatenary(40, 32.0);
    EXPECT_NEAR(bridge.sag, 10.6210, 5e-5);
    EXPECT_NEAR(bridge.endPull, 24.1443, 5e-5);
    double span = 0.0, climb = 0.0;
    for (const double angle : bridge.angle) {
        span += std::cos(angle);
        climb += std::sin(angle);
    }
    EXPECT_NEAR(span, 32.0, 1e-9);
    EXPECT_NEAR(climb, 0.0, 1e-9);
}

TEST(Measure, OrderIsTheLogarithmOfTheRatio) {
    EXPECT_DOUBLE_EQ(GetOrder(0.4, 0.2), 1.0);
    EXPECT_DOUBLE_EQ(GetOrder(0.4, 0.1), 2.0);
}

TEST(Measure, CollisionsKeepMomentumAndTheRatioOfSpeedsAlongTheNormal) {
    const Point v{2.0, 0.5}, normal{0.8, -0.6};
    const double ratio = 7.0, e = 0.4;
    const Point light = AfterCollision(v, normal, ratio, e);
    const Point heavy = (1.0 / ratio) * (v - light);  // by momentum
    EXPECT_NEAR(Dot(heavy - light, normal), e * Dot(v, normal), 1e-12);
    EXPECT_NEAR(Cross(light - v, normal), 0.0, 1e-12);
    const Point equal = AfterCollision({2.0, 0.0}, {1.0, 0.0}, 1.0, 1.0);
    EXPECT_NEAR(Length(equal), 0.0, 1e-15);
}

TEST(Measure, ReadingsTurnPointsInDouble) {
    BodyReading b;
    b.origin = {1.0, 2.0};
    b.cos = 0.0;
    b.sin = 1.0;
    EXPECT_DOUBLE_EQ(b.ToWorld({3.0, 4.0}).x, -3.0);
    EXPECT_DOUBLE_EQ(b.ToWorld({3.0, 4.0}).y, 5.0);
    EXPECT_TRUE(b.IsFinite());
    b.spin = std::nan("");
    EXPECT_FALSE(b.IsFinite());
}

}  // namespace
}  // namespace testbed
