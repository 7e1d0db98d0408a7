// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Time of impact: never later than the first touch found by dense sampling in double, and never before the shapes are
// near. It is as that of Box2D 2.4.1 where that sees the touch. Shapes are fast, thin, long, tiny, spinning and far
// away. Degenerate input ends.

#include <gtest/gtest.h>

#include <limits>

#include "tests/geometry/convex_oracle.h"

namespace scree::test {
namespace {

/// Distance of the cores at time t, in double.
double DistanceAt(const TOIInput& input, double t) {
    return OutlineDistance(Place(input.proxyA, input.sweepA, t), Place(input.proxyB, input.sweepB, t));
}

double TargetOf(const TOIInput& input) {
    return static_cast<double>(TOITarget(input.proxyA.m_radius + input.proxyB.m_radius));
}

TOIOutput Find(const TOIInput& input) {
    TOIOutput output;
    TimeOfImpact(&output, &input);
    return output;
}

b2TOIOutput FindTwin(const TOIInput& input, const AnyShape& a, const AnyShape& b) {
    b2TOIInput twin;
    twin.proxyA = TwinProxyOf(a);
    twin.proxyB = TwinProxyOf(b);
    twin.sweepA = ToBox2d(input.sweepA);
    twin.sweepB = ToBox2d(input.sweepB);
    twin.tMax = input.tMax;
    b2TOIOutput output;
    b2TimeOfImpact(&output, &twin);
    return output;
}

/// Checks a result against `samples` samples of the distance. `rounding`, m: positions are float, times too.
void ExpectFirstTouch(const TOIInput& input, const TOIOutput& output, int samples, double rounding) {
    const double target = TargetOf(input);
    const double end = static_cast<double>(output.t);
    ASSERT_NE(output.state, TOIOutput::e_failed);
    ASSERT_NE(output.state, TOIOutput::e_unknown);
    ASSERT_GE(output.t, 0.0f);
    ASSERT_LE(output.t, input.tMax);
    if (output.state == TOIOutput::e_overlapped) {
        ASSERT_EQ(output.t, 0.0f);
        ASSERT_LE(DistanceAt(input, 0.0), rounding);
        return;
    }
    if (output.state == TOIOutput::e_touching) {
        ASSERT_LE(DistanceAt(input, end), target + static_cast<double>(toiTolerance) + rounding) << "too early";
    } else {
        ASSERT_EQ(output.t, input.tMax);
    }
    if (output.t == 0.0f) return;
    for (int i = 0; i <= samples; ++i) {
        const double t = end * i / samples;
        ASSERT_GE(DistanceAt(input, t), target - rounding) << "too late: touches at " << t << " of " << end;
    }
}

/// B flies towards A, both turn, by up to `turn` rad.
TOIInput RandomMotion(Source& source, const AnyShape& a, const AnyShape& b, float turn, float overshoot) {
    TOIInput input{ProxyOf(a), ProxyOf(b), {}, {}, 1.0f};
    const Vec2 fromA = source.InSquare(1.0f);
    const Vec2 fromB = source.InSquare(4.0f);
    const bool isStatic = source.Chance(2);
    const float angleA = source.Between(-7.0f, 7.0f);
    input.sweepA = MakeSweep(fromA, isStatic ? fromA : fromA + source.InSquare(0.5f), angleA,
                             isStatic ? angleA : angleA + turn * source.Between(-1.0f, 1.0f));
    const float angleB = source.Between(-7.0f, 7.0f);
    input.sweepB = MakeSweep(fromB, source.InSquare(2.0f) - overshoot * fromB, angleB,
                             angleB + turn * source.Between(-1.0f, 1.0f));
    if (source.Chance(3)) input.sweepA.localCenter = source.InSquare(0.5f);
    if (source.Chance(3)) input.sweepB.localCenter = source.InSquare(0.5f);
    if (source.Chance(4)) std::swap(input.sweepA, input.sweepB);
    return input;
}

TEST(TimeOfImpact, IsTheFirstTouchOfDenseSampling) {
    Source source(221);
    int states[5] = {};
    for (int i = 0; i < 12000; ++i) {
        const AnyShape a = AnyShape::Random(source);
        const AnyShape b = AnyShape::Random(source);
        const float turn = source.Chance(3) ? 0.0f : (source.Chance(2) ? 0.3f : 6.0f);
        const TOIInput input = RandomMotion(source, a, b, turn, source.Between(0.0f, 2.0f));
        const TOIOutput output = Find(input);
        ++states[output.state];
        // Coordinates below 20 m: 2e-6 m each; angles below 14 rad: 1e-6 rad on 3 m.
        ASSERT_NO_FATAL_FAILURE(ExpectFirstTouch(input, output, 150, 1.0e-5)) << i;
    }
    EXPECT_GT(states[TOIOutput::e_touching], 3000);
    EXPECT_GT(states[TOIOutput::e_separated], 1000);
    EXPECT_GT(states[TOIOutput::e_overlapped], 100);
}

TEST(TimeOfImpact, AgreesWithBox2dOnSlowTurns) {
    constexpr int trials = 100000;
    Source source(222);
    int missed = 0;
    int apartInTime = 0;
    for (int i = 0; i < trials; ++i) {
        const AnyShape a = AnyShape::Random(source);
        const AnyShape b = AnyShape::Random(source);
        const TOIInput input = RandomMotion(source, a, b, 0.2f, source.Between(0.0f, 2.0f));
        const TOIOutput ours = Find(input);
        const b2TOIOutput theirs = FindTwin(input, a, b);
        ASSERT_EQ(ours.state == TOIOutput::e_overlapped, theirs.state == b2TOIOutput::e_overlapped) << i;
        const double touch = TargetOf(input) + static_cast<double>(toiTolerance);
        if (ours.state == TOIOutput::e_touching && theirs.state != b2TOIOutput::e_touching) {
            // Box2D's axis opens again before the end of the step, or it gave up; ours touches indeed.
            ASSERT_LE(DistanceAt(input, static_cast<double>(ours.t)), touch + 1.0e-5) << i;
            ++missed;
        } else if (ours.state == TOIOutput::e_separated && theirs.state == b2TOIOutput::e_touching) {
            // A graze inside the tolerance may be told either way.
            ASSERT_NO_FATAL_FAILURE(ExpectFirstTouch(input, ours, 400, 1.0e-5)) << i;
            ++missed;
        } else if (ours.t > theirs.t + 1.0e-6f) {
            // Later than Box2D only as far as the tolerance reaches: near, but not nearer than the target.
            for (int k = 0; k <= 20; ++k) {
                const double t = static_cast<double>(theirs.t) + (static_cast<double>(ours.t - theirs.t) * k) / 20.0;
                ASSERT_GE(DistanceAt(input, t), TargetOf(input) - 1.0e-5) << i;
            }
        }
        apartInTime += std::fabs(ours.t - theirs.t) > 0.01f;
    }
    EXPECT_LT(missed, trials / 500);
    EXPECT_LT(apartInTime, trials / 200);
}

TEST(TimeOfImpact, StopsEveryShotAtAWall) {
    // Phases of the flight × speeds × thicknesses × shapes × angles, at 60 steps a second; the wall stands still at 0.
    const AnyShape shots[] = {AnyShape::Circle(0.1f), AnyShape::Box(0.1f, 0.1f), AnyShape::Box(0.5f, 0.0005f),
                              AnyShape::Edge({-0.5f, 0.0f}, {0.5f, 0.0f})};
    int shot = 0;
    TOIStats stats;
    for (const float thickness : {0.001f, 0.01f, 0.1f, 1.0f}) {
        const AnyShape wall = AnyShape::Box(0.5f * thickness, 1000.0f);
        for (const float speed : {50.0f, 119.0f, 1000.0f, 10000.0f}) {
            for (const float slant : {0.0f, 0.25f * pi, 80.0f / 180.0f * pi}) {
                for (const float spin : {0.0f, 0.5f, 12.0f}) {
                    for (int phase = 0; phase < 33; ++phase) {
                        const AnyShape& body = shots[shot++ % 4];
                        const Vec2 step = (speed / 60.0f) * Vec2{std::cos(slant), std::sin(slant)};
                        // Far enough on both sides that the shot starts free and ends free.
                        const float margin = 0.5f * thickness + 0.6f;
                        if (step.x < 2.0f * margin) continue;
                        const float start = -margin - (step.x - 2.0f * margin) * static_cast<float>(phase) / 32.0f;
                        TOIInput input{ProxyOf(wall), ProxyOf(body), MakeSweep(vec2Zero, vec2Zero), {}, 1.0f};
                        input.sweepB = MakeSweep({start, 0.0f}, Vec2{start, 0.0f} + step, 0.3f, 0.3f + spin);
                        const TOIOutput output = Find(input);
                        stats.Add(output);
                        ASSERT_EQ(output.state, TOIOutput::e_touching) << thickness << " " << speed << " " << phase;
                        // 170 m travelled in floats of time: 1e-5 m.
                        ASSERT_NO_FATAL_FAILURE(ExpectFirstTouch(input, output, 40, 5.0e-5));
                    }
                }
            }
        }
    }
    EXPECT_GT(stats.calls, 1000);
    EXPECT_LE(stats.maxIterations, 20);
    EXPECT_LE(stats.maxRootIterations, 200);
}

TEST(TimeOfImpact, HoldsFarFromTheOrigin) {
    // Floats are 0.0078 m apart at 1e5 m. What is given is taken exactly, so the answer is as good as near the origin.
    Source source(223);
    int touching = 0;
    for (int i = 0; i < 4000; ++i) {
        const AnyShape a = AnyShape::Random(source);
        const AnyShape b = AnyShape::Random(source);
        TOIInput input = RandomMotion(source, a, b, source.Chance(2) ? 0.0f : 0.5f, 1.0f);
        const float distance = source.Chance(2) ? 1.0e5f : 1.0e4f;
        const Vec2 far{distance, -distance};
        for (Sweep* sweep : {&input.sweepA, &input.sweepB}) {
            sweep->c0 += far;
            sweep->c += far;
        }
        const TOIOutput output = Find(input);
        touching += output.state == TOIOutput::e_touching;
        ASSERT_NO_FATAL_FAILURE(ExpectFirstTouch(input, output, 100, 1.0e-5)) << i;
    }
    EXPECT_GT(touching, 1000);

    // The same for ground far from the origin of its body.
    const AnyShape ground = AnyShape::Edge({99990.0f, 0.0f}, {100010.0f, 0.0f});
    const AnyShape box = AnyShape::Box(0.5f, 0.5f);
    TOIInput input{ProxyOf(ground), ProxyOf(box), MakeSweep(vec2Zero, vec2Zero), {}, 1.0f};
    input.sweepB = MakeSweep({100000.0f, 20.0f}, {100000.0f, -20.0f}, 0.0f, 0.5f);
    const TOIOutput output = Find(input);
    EXPECT_EQ(output.state, TOIOutput::e_touching);
    ASSERT_NO_FATAL_FAILURE(ExpectFirstTouch(input, output, 200, 1.0e-5));
}

TEST(TimeOfImpact, HoldsForTinyAndLongShapes) {
    Source source(224);
    const AnyShape shapes[] = {AnyShape::Circle(1.0e-4f),
                               AnyShape::Box(0.004f, 0.004f),
                               AnyShape::Box(100.0f, 0.001f),
                               AnyShape::Edge({-500.0f, 0.0f}, {500.0f, 0.0f}),
                               AnyShape::Edge({0.0f, 0.0f}, {0.006f, 0.0f}),
                               AnyShape::Circle(50.0f)};
    int touching = 0;
    TOIStats stats;
    for (int i = 0; i < 6000; ++i) {
        const AnyShape& a = shapes[source.Below(6)];
        const AnyShape& b = shapes[source.Below(6)];
        const TOIInput input = RandomMotion(source, a, b, source.Chance(2) ? 0.0f : 1.0f, 1.0f);
        const TOIOutput output = Find(input);
        stats.Add(output);
        touching += output.state == TOIOutput::e_touching;
        // 500 m at an angle of up to 8 rad in float: 5e-7 rad, 2.5e-4 m.
        ASSERT_NO_FATAL_FAILURE(ExpectFirstTouch(input, output, 100, 5.0e-4)) << i;
    }
    EXPECT_GT(touching, 1000);
}

TEST(TimeOfImpact, SpinsEndAndAreNeverLate) {
    Source source(225);
    const AnyShape rod = AnyShape::Box(1.0f, 0.01f);
    const AnyShape box = AnyShape::Box(0.5f, 0.5f);
    TOIStats stats;
    int failed = 0;
    for (int i = 0; i < 2000; ++i) {
        const AnyShape& other = source.Chance(2) ? rod : box;
        const TOIInput input =
            RandomMotion(source, rod, other, source.Between(1.0f, 170.0f), source.Between(0.0f, 1.0f));
        const TOIOutput output = Find(input);
        stats.Add(output);
        if (output.state == TOIOutput::e_failed) {
            // Out of evaluations: all up to t is still free.
            ++failed;
            for (int k = 0; k < 500; ++k) {
                ASSERT_GE(DistanceAt(input, static_cast<double>(output.t) * k / 500), TargetOf(input) - 1.0e-4);
            }
            continue;
        }
        // Angles up to 350 rad in float: 1.5e-5 rad on 2 m.
        ASSERT_NO_FATAL_FAILURE(ExpectFirstTouch(input, output, 1000, 1.0e-4)) << i;
    }
    EXPECT_EQ(failed, 0);
    EXPECT_LE(stats.maxIterations, 256);
}

TEST(TimeOfImpact, ReportsTheStateAtTheStart) {
    const AnyShape box = AnyShape::Box(0.5f, 0.5f);
    const Sweep still = MakeSweep(vec2Zero, vec2Zero);
    TOIInput input{ProxyOf(box), ProxyOf(box), still, still, 1.0f};
    TOIOutput output = Find(input);
    EXPECT_EQ(output.state, TOIOutput::e_overlapped) << "identical shapes";
    EXPECT_EQ(output.t, 0.0f);

    // At rest on each other, cores 0.01 m apart, moving on or away.
    for (const float path : {-1.0f, 0.0f, 1.0f}) {
        input.sweepB = MakeSweep({0.0f, 1.005f}, {0.0f, 1.005f + path});
        output = Find(input);
        EXPECT_EQ(output.state, TOIOutput::e_touching) << path;
        EXPECT_EQ(output.t, 0.0f);
    }
    // Apart and without motion.
    input.sweepB = MakeSweep({0.0f, 1.5f}, {0.0f, 1.5f});
    output = Find(input);
    EXPECT_EQ(output.state, TOIOutput::e_separated);
    EXPECT_EQ(output.t, 1.0f);
    input.tMax = 0.0f;
    EXPECT_EQ(Find(input).state, TOIOutput::e_separated);
    EXPECT_EQ(Find(input).t, 0.0f);
}

TEST(TimeOfImpact, RespectsTMax) {
    const AnyShape ball = AnyShape::Circle(0.5f);
    TOIInput input{ProxyOf(ball), ProxyOf(ball), MakeSweep(vec2Zero, vec2Zero), {}, 1.0f};
    input.sweepB = MakeSweep({10.0f, 0.0f}, {-10.0f, 0.0f});
    const TOIOutput whole = Find(input);
    ASSERT_EQ(whole.state, TOIOutput::e_touching);
    // Cores 1 − 0.015 m apart after 10 − 0.985 m of 20.
    EXPECT_NEAR(whole.t, 9.015f / 20.0f, toiTolerance / 20.0f);
    input.tMax = 0.4f;
    EXPECT_EQ(Find(input).state, TOIOutput::e_separated);
    EXPECT_EQ(Find(input).t, 0.4f);
}

TEST(TimeOfImpact, DegenerateInputEnds) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float inf = std::numeric_limits<float>::infinity();
    const AnyShape box = AnyShape::Box(0.5f, 0.5f);
    const AnyShape point = AnyShape::Edge({0.0f, 0.0f}, {0.0f, 0.0f});
    TOIInput input{ProxyOf(box), ProxyOf(point), MakeSweep(vec2Zero, vec2Zero), {}, 1.0f};
    input.sweepB = MakeSweep({3.0f, 0.0f}, {-3.0f, 0.0f}, 0.0f, 3.0f);
    EXPECT_EQ(Find(input).state, TOIOutput::e_touching) << "an edge without length";

    for (const float bad : {nan, inf, -inf}) {
        for (int field = 0; field < 7; ++field) {
            TOIInput broken = input;
            float* fields[] = {&broken.sweepB.c0.x, &broken.sweepB.c.y,           &broken.sweepB.a0, &broken.sweepB.a,
                               &broken.sweepA.c.x,  &broken.sweepA.localCenter.x, &broken.sweepA.a};
            *fields[field] = bad;
            const TOIOutput output = Find(broken);
            EXPECT_EQ(output.state, TOIOutput::e_failed) << field << " " << bad;
            EXPECT_EQ(output.t, 0.0f);
        }
    }
    input.tMax = nan;
    EXPECT_EQ(Find(input).state, TOIOutput::e_failed);
    input.tMax = -1.0f;
    EXPECT_EQ(Find(input).state, TOIOutput::e_failed);
    input.tMax = 1.0f;
    const Vec2 notANumber[3] = {{nan, 0.0f}, {nan, 1.0f}, {nan, nan}};
    input.proxyB.Set(notANumber, 3, 0.01f);
    EXPECT_EQ(Find(input).state, TOIOutput::e_failed);
    input.proxyB = DistanceProxy{};
    EXPECT_EQ(Find(input).state, TOIOutput::e_failed) << "an empty proxy";
}

TEST(TimeOfImpact, HugeMotionsEnd) {
    Source source(226);
    for (int i = 0; i < 5000; ++i) {
        const AnyShape a = AnyShape::Random(source);
        const AnyShape b = AnyShape::Random(source);
        TOIInput input = RandomMotion(source, a, b, 1.0f, 1.0f);
        const float size = std::pow(10.0f, source.Between(0.0f, 37.0f));
        input.sweepB.c = size * source.InSquare(1.0f);
        if (source.Chance(2)) input.sweepB.a = size * source.Between(-1.0f, 1.0f);
        if (source.Chance(2)) input.sweepA.c = size * source.InSquare(1.0f);
        const TOIOutput output = Find(input);
        ASSERT_NE(output.state, TOIOutput::e_unknown);
        ASSERT_LE(output.iterations, 256);
        ASSERT_LE(output.rootIterations, 4097);
        ASSERT_TRUE(output.t >= 0.0f && output.t <= 1.0f);
    }
}

TEST(TOIStats, AddsUp) {
    TOIStats stats;
    TOIOutput output{};
    output.iterations = 3;
    output.rootIterations = 7;
    output.distanceCalls = 4;
    output.distanceIterations = 9;
    output.maxDistanceIterations = 5;
    stats.Add(output);
    output.iterations = 1;
    output.maxDistanceIterations = 6;
    stats.Add(output);
    EXPECT_EQ(stats.calls, 2);
    EXPECT_EQ(stats.iterations, 4);
    EXPECT_EQ(stats.maxIterations, 3);
    EXPECT_EQ(stats.rootIterations, 14);
    EXPECT_EQ(stats.maxRootIterations, 7);
    EXPECT_EQ(stats.distanceCalls, 8);
    EXPECT_EQ(stats.distanceIterations, 18);
    EXPECT_EQ(stats.maxDistanceIterations, 6);
}

TEST(Sweep, MovesLinearlyAndKeepsItsPath) {
    Source source(227);
    for (int i = 0; i < 10000; ++i) {
        Sweep sweep = MakeSweep(source.InSquare(5.0f), source.InSquare(5.0f), source.Between(-50.0f, 50.0f),
                                source.Between(-50.0f, 50.0f));
        sweep.localCenter = source.InSquare(1.0f);
        b2Sweep twin = ToBox2d(sweep);
        if (source.Chance(2)) {
            const float alpha = source.Between(0.0f, 0.9f);
            sweep.Advance(alpha);
            twin.Advance(alpha);
        }
        if (source.Chance(2)) {
            sweep.Normalize();
            twin.Normalize();
        }
        ASSERT_EQ(sweep.alpha0, twin.alpha0);
        ASSERT_EQ(sweep.a0, twin.a0);
        ASSERT_EQ(sweep.a, twin.a);
        ASSERT_TRUE(SameBits(sweep.c0, twin.c0));
        const float beta = source.Between(0.0f, 1.0f);
        Transform xf;
        b2Transform expected;
        sweep.GetTransform(&xf, beta);
        twin.GetTransform(&expected, beta);
        // Sine and cosine may differ in the last bit.
        ASSERT_LE(Gap(xf.p, expected.p), 1.0e-6f);
        ASSERT_NEAR(xf.q.s, expected.q.s, 1.0e-6f);
        ASSERT_NEAR(xf.q.c, expected.q.c, 1.0e-6f);
    }
    Sweep done = MakeSweep({1.0f, 0.0f}, {2.0f, 0.0f});
    done.alpha0 = 1.0f;
    done.Advance(1.0f);
    EXPECT_EQ(done.c0.x, 1.0f);
}

}  // namespace
}  // namespace scree::test
