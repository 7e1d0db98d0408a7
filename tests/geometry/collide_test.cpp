// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Every collision function against Box2D 2.4.1: type, point count, feature ids and local coordinates are equal. That
// holds on random placements, on grids full of ties, in deep overlap, far from the origin and on the verge of touching.

#include <gtest/gtest.h>

#include "tests/geometry/oracle.h"

namespace scree::test {
namespace {

constexpr int trials = 150000;

/// Runs one pair of kernels over the placements; `makeA` and `makeB` draw shapes.
template <typename MakeA, typename MakeB, typename Ours, typename Theirs>
void Compare(const char* name, uint32_t seed, MakeA makeA, MakeB makeB, Ours ours, Theirs theirs) {
    Source source(seed);
    Tally tally(name);
    for (int i = 0; i < trials; ++i) {
        const auto a = makeA(source);
        const auto b = makeB(source);
        const auto boxA = ToBox2d(a);
        const auto boxB = ToBox2d(b);
        Placement placement = RandomPlacement(source);
        b2Manifold expected;
        if (source.Chance(4)) {
            BringNearTouching(source, placement, [&](const Transform& xfB) {
                theirs(&expected, &boxA, ToBox2d(placement.a), &boxB, ToBox2d(xfB));
                return expected.pointCount;
            });
        }
        Manifold manifold;
        theirs(&expected, &boxA, ToBox2d(placement.a), &boxB, ToBox2d(placement.b));
        ours(&manifold, &a, placement.a, &b, placement.b);
        tally.Add(manifold, expected);
    }
    EXPECT_LE(tally.DifferingShare(), allowedShare);
    EXPECT_LE(tally.LargestGap(), allowedGap);
    // The comparison is worth something only if all outcomes are common.
    EXPECT_GT(tally.WithPoints(0), trials / 20);
    EXPECT_GT(tally.WithPoints(1) + tally.WithPoints(2), trials / 20);
}

TEST(CollideCircles, AgreesWithBox2d) {
    Compare("circles", 1, RandomCircle, RandomCircle, CollideCircles, b2CollideCircles);
}

TEST(CollidePolygonAndCircle, AgreesWithBox2d) {
    Compare("polygon and circle", 2, RandomPolygon, RandomCircle, CollidePolygonAndCircle, b2CollidePolygonAndCircle);
}

TEST(CollidePolygons, AgreesWithBox2d) {
    Compare("polygons", 3, RandomPolygon, RandomPolygon, CollidePolygons, b2CollidePolygons);
}

TEST(CollideEdgeAndCircle, AgreesWithBox2d) {
    Compare("edge and circle", 4, RandomEdge, RandomCircle, CollideEdgeAndCircle, b2CollideEdgeAndCircle);
}

TEST(CollideEdgeAndPolygon, AgreesWithBox2d) {
    Compare("edge and polygon", 5, RandomEdge, RandomPolygon, CollideEdgeAndPolygon, b2CollideEdgeAndPolygon);
}

/// Boxes resting on boxes: the commonest contact of all, shifted sideways and tilted within the solver's tolerances.
TEST(CollidePolygons, AgreesWithBox2dOnRestingBoxes) {
    Source source(6);
    Tally tally("resting boxes");
    for (int i = 0; i < trials; ++i) {
        PolygonShape a, b;
        a.SetAsBox(0.5f, 0.5f);
        b.SetAsBox(source.Chance(2) ? 0.5f : source.Between(0.1f, 2.0f), 0.5f);
        const float turn = 0.5f * pi * static_cast<float>(source.Below(4));
        Transform xfA, xfB;
        xfA.Set(source.InSquare(50.0f), source.Between(-0.01f, 0.01f));
        const Vec2 offset{source.Chance(4) ? 0.0f : source.Between(-1.0f, 1.0f), 1.0f + source.Between(-0.02f, 0.03f)};
        xfB.Set(xfA.p + offset, turn + (source.Chance(4) ? 0.0f : source.Between(-0.01f, 0.01f)));
        const b2PolygonShape boxA = ToBox2d(a);
        const b2PolygonShape boxB = ToBox2d(b);
        Manifold manifold;
        b2Manifold expected;
        CollidePolygons(&manifold, &a, xfA, &b, xfB);
        b2CollidePolygons(&expected, &boxA, ToBox2d(xfA), &boxB, ToBox2d(xfB));
        tally.Add(manifold, expected);
    }
    EXPECT_LE(tally.DifferingShare(), allowedShare);
    EXPECT_LE(tally.LargestGap(), allowedGap);
    EXPECT_GT(tally.WithPoints(2), trials / 4);
}

/// Box2D's answer to a placement that is not finite is "apart"; anything else would spread NaN through the world.
TEST(Collide, TouchesNothingAtANonFinitePlacement) {
    Source source(7);
    const Transform fine(Vec2{0.0f, 0.0f}, Rot(0.3f));
    for (const float bad : {NAN, INFINITY, -INFINITY}) {
        for (int component = 0; component < 3; ++component) {
            Transform broken = fine;
            if (component == 0) broken.p.x = bad;
            if (component == 1) broken.p.y = bad;
            if (component == 2) broken.q.s = bad;
            const CircleShape circle = RandomCircle(source);
            const PolygonShape polygon = RandomPolygon(source);
            const EdgeShape edge = RandomEdge(source);
            Manifold manifold;
            CollideCircles(&manifold, &circle, fine, &circle, broken);
            EXPECT_EQ(manifold.pointCount, 0);
            CollidePolygonAndCircle(&manifold, &polygon, fine, &circle, broken);
            EXPECT_EQ(manifold.pointCount, 0);
            CollidePolygons(&manifold, &polygon, fine, &polygon, broken);
            EXPECT_EQ(manifold.pointCount, 0);
            CollideEdgeAndCircle(&manifold, &edge, fine, &circle, broken);
            EXPECT_EQ(manifold.pointCount, 0);
            CollideEdgeAndPolygon(&manifold, &edge, fine, &polygon, broken);
            EXPECT_EQ(manifold.pointCount, 0);
        }
    }
}

}  // namespace
}  // namespace scree::test
