// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Laws that need no oracle: exchanging the shapes or reflecting the plane exchanges or reflects the manifold, and
// nothing depends on where the pair lies.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "tests/geometry/oracle.h"

namespace scree::test {
namespace {

/// A seed drawn by RapidCheck, so that a failure prints the one number that repeats it.
Source DrawSource() { return Source(*rc::gen::resize(1000, rc::gen::arbitrary<uint32_t>())); }

WorldManifold Evaluate(const Manifold& manifold, const Shape& a, const Transform& xfA, const Shape& b,
                       const Transform& xfB) {
    WorldManifold out{};
    out.Initialize(&manifold, xfA, a.m_radius, xfB, b.m_radius);
    return out;
}

void AssertNear(Vec2 a, Vec2 b, float tolerance) {
    RC_ASSERT(Abs(a.x - b.x) <= tolerance);
    RC_ASSERT(Abs(a.y - b.y) <= tolerance);
}

// World points are midpoints of two surface points below 4 m: a few roundings of 2^-22 m each.
constexpr float rounding = 5.0e-6f;

TEST(CollideCircles, SwappingTheCirclesReversesTheManifold) {
    EXPECT_TRUE(rc::check("B against A has the same point and the opposite normal", [] {
        Source source = DrawSource();
        const CircleShape a = RandomCircle(source);
        const CircleShape b = RandomCircle(source);
        Transform xfA, xfB;
        xfA.Set(source.InSquare(1.0f), source.Between(-7.0f, 7.0f));
        xfB.Set(source.InSquare(1.0f), source.Between(-7.0f, 7.0f));
        Manifold forward, backward;
        CollideCircles(&forward, &a, xfA, &b, xfB);
        CollideCircles(&backward, &b, xfB, &a, xfA);
        RC_ASSERT(forward.pointCount == backward.pointCount);
        RC_PRE(forward.pointCount == 1);
        RC_ASSERT(forward.localPoint == backward.points[0].localPoint);
        RC_ASSERT(forward.points[0].localPoint == backward.localPoint);
        const WorldManifold there = Evaluate(forward, a, xfA, b, xfB);
        const WorldManifold back = Evaluate(backward, b, xfB, a, xfA);
        RC_ASSERT(there.normal == -back.normal);
        AssertNear(there.points[0], back.points[0], rounding);
        RC_ASSERT(Abs(there.separations[0] - back.separations[0]) <= rounding);
    }));
}

TEST(CollideCircles, ReflectingThePlaneReflectsTheManifold) {
    EXPECT_TRUE(rc::check("x → −x negates the x of normal and point and nothing else", [] {
        Source source = DrawSource();
        CircleShape a = RandomCircle(source);
        CircleShape b = RandomCircle(source);
        Transform xfA, xfB;
        xfA.Set(source.InSquare(1.0f), source.Between(-7.0f, 7.0f));
        xfB.Set(source.InSquare(1.0f), source.Between(-7.0f, 7.0f));
        Manifold plain, mirrored;
        CollideCircles(&plain, &a, xfA, &b, xfB);
        RC_PRE(plain.pointCount == 1);
        const WorldManifold before = Evaluate(plain, a, xfA, b, xfB);
        for (Transform* xf : {&xfA, &xfB}) {
            xf->p.x = -xf->p.x;
            xf->q.s = -xf->q.s;
        }
        a.m_p.x = -a.m_p.x;
        b.m_p.x = -b.m_p.x;
        CollideCircles(&mirrored, &a, xfA, &b, xfB);
        RC_ASSERT(mirrored.pointCount == 1);
        const WorldManifold after = Evaluate(mirrored, a, xfA, b, xfB);
        RC_ASSERT(after.normal == Vec2(-before.normal.x, before.normal.y));  // exact: negation never rounds
        RC_ASSERT(after.points[0] == Vec2(-before.points[0].x, before.points[0].y));
        RC_ASSERT(after.separations[0] == before.separations[0]);
    }));
}

TEST(CollidePolygons, SwappingThePolygonsKeepsThePointsAndReversesTheNormal) {
    EXPECT_TRUE(rc::check("away from ties, B against A is A against B seen from the other side", [] {
        Source source = DrawSource();
        const PolygonShape a = RandomPolygon(source);
        const PolygonShape b = RandomPolygon(source);
        Transform xfA, xfB;
        xfA.Set(source.InSquare(1.0f), source.Between(-7.0f, 7.0f));
        xfB.Set(source.InSquare(1.0f), source.Between(-7.0f, 7.0f));
        Manifold forward, backward;
        CollidePolygons(&forward, &a, xfA, &b, xfB);
        CollidePolygons(&backward, &b, xfB, &a, xfA);
        // The first polygon is preferred when separations tie; then the reference face changes sides.
        RC_PRE(forward.pointCount > 0 && backward.pointCount > 0 && forward.type != backward.type);
        RC_ASSERT(forward.pointCount == backward.pointCount);
        const WorldManifold there = Evaluate(forward, a, xfA, b, xfB);
        const WorldManifold back = Evaluate(backward, b, xfB, a, xfA);
        AssertNear(there.normal, -back.normal, rounding);
        for (int i = 0; i < forward.pointCount; ++i) {
            AssertNear(there.points[i], back.points[i], rounding);
            const ContactFeature cf = forward.points[i].id.cf;
            const ContactFeature swapped = backward.points[i].id.cf;
            RC_ASSERT(cf.indexA == swapped.indexB && cf.indexB == swapped.indexA);
            RC_ASSERT(cf.typeA == swapped.typeB && cf.typeB == swapped.typeA);
        }
    }));
}

TEST(CollideEdgeAndCircle, ATwoSidedEdgeHasNoDirection) {
    EXPECT_TRUE(rc::check("exchanging the ends of a two-sided edge keeps the world manifold", [] {
        Source source = DrawSource();
        EdgeShape edge, reversed;
        const Vec2 v1 = source.InSquare(1.0f);
        const Vec2 v2 = source.InSquare(1.0f);
        RC_PRE(Distance(v1, v2) > 0.1f);
        edge.SetTwoSided(v1, v2);
        reversed.SetTwoSided(v2, v1);
        const CircleShape circle = RandomCircle(source);
        Transform xfA, xfB;
        xfA.Set(source.InSquare(1.0f), source.Between(-7.0f, 7.0f));
        xfB.Set(source.InSquare(1.0f), source.Between(-7.0f, 7.0f));
        Manifold forward, backward;
        CollideEdgeAndCircle(&forward, &edge, xfA, &circle, xfB);
        CollideEdgeAndCircle(&backward, &reversed, xfA, &circle, xfB);
        RC_ASSERT(forward.pointCount == backward.pointCount);
        RC_PRE(forward.pointCount == 1 && forward.type == backward.type);
        const WorldManifold there = Evaluate(forward, edge, xfA, circle, xfB);
        const WorldManifold back = Evaluate(backward, reversed, xfA, circle, xfB);
        // A centre almost on the edge's line makes the side a matter of rounding.
        RC_PRE(Dot(there.normal, back.normal) > 0.0f);
        // The normal of an end contact is a difference of nearby points: relative errors grow as 1/distance.
        RC_PRE(there.separations[0] + circle.m_radius > 0.05f);
        AssertNear(there.normal, back.normal, 20.0f * rounding);
        AssertNear(there.points[0], back.points[0], 20.0f * rounding);
    }));
}

}  // namespace
}  // namespace scree::test
