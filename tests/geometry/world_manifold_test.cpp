// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// WorldManifold against Box2D 2.4.1 for every manifold type, and the geometry it promises: points midway between two
// surfaces that are `separation` apart along a unit normal from A to B.

#include <gtest/gtest.h>

#include "tests/geometry/oracle.h"

namespace scree::test {
namespace {

b2Manifold ToBox2d(const Manifold& manifold) {
    b2Manifold out;
    out.type = static_cast<b2Manifold::Type>(manifold.type);
    out.pointCount = manifold.pointCount;
    out.localNormal = test::ToBox2d(manifold.localNormal);
    out.localPoint = test::ToBox2d(manifold.localPoint);
    for (int i = 0; i < manifold.pointCount; ++i) {
        out.points[i].localPoint = test::ToBox2d(manifold.points[i].localPoint);
    }
    return out;
}

TEST(WorldManifold, AgreesWithBox2dForEveryType) {
    Source source(11);
    int seen[3] = {0, 0, 0};
    float largest = 0.0f;
    for (int i = 0; i < 200000; ++i) {
        const int type = source.Below(3);
        Manifold manifold;
        manifold.type = static_cast<Manifold::Type>(type);
        manifold.pointCount = static_cast<int8_t>(type == Manifold::e_circles ? 1 : source.Below(3));
        manifold.localNormal = Rot(source.Between(-pi, pi)).GetXAxis();
        manifold.localPoint = source.InSquare(1.0f);
        for (ManifoldPoint& point : manifold.points) point.localPoint = source.InSquare(1.0f);
        Placement placement = RandomPlacement(source);
        if (source.Chance(50)) {  // concentric circles
            placement.b = placement.a;
            manifold.points[0].localPoint = manifold.localPoint;
        }
        const float radiusA = source.Between(0.0f, 1.0f);
        const float radiusB = source.Between(0.0f, 1.0f);
        WorldManifold ours{};
        b2WorldManifold theirs;
        theirs.normal.SetZero();
        ours.Initialize(&manifold, placement.a, radiusA, placement.b, radiusB);
        const b2Manifold twin = ToBox2d(manifold);
        theirs.Initialize(&twin, test::ToBox2d(placement.a), radiusA, test::ToBox2d(placement.b), radiusB);
        largest = Max(largest, Gap(ours.normal, theirs.normal));
        for (int k = 0; k < manifold.pointCount; ++k) {
            ++seen[type];
            largest = Max(largest, Gap(ours.points[k], theirs.points[k]));
            largest = Max(largest, Abs(ours.separations[k] - theirs.separations[k]));
        }
    }
    for (const int count : seen) EXPECT_GT(count, 10000);
    EXPECT_LE(largest, allowedGap);
}

TEST(WorldManifold, DescribesTheGapBetweenTwoDisks) {
    Source source(12);
    for (int i = 0; i < 20000; ++i) {
        const CircleShape a = RandomCircle(source);
        const CircleShape b = RandomCircle(source);
        Transform xfA, xfB;
        xfA.Set(source.InSquare(1.0f), source.Between(-pi, pi));
        xfB.Set(source.InSquare(1.0f), source.Between(-pi, pi));
        Manifold manifold;
        CollideCircles(&manifold, &a, xfA, &b, xfB);
        if (manifold.pointCount == 0) continue;
        WorldManifold world;
        world.Initialize(&manifold, xfA, a.m_radius, xfB, b.m_radius);
        const Vec2 between = Mul(xfB, b.m_p) - Mul(xfA, a.m_p);
        // Coordinates below 3 m: a handful of roundings of 2.4e-7 m.
        constexpr float tolerance = 3.0e-6f;
        EXPECT_NEAR(world.normal.Length(), 1.0f, tolerance);
        EXPECT_NEAR(Cross(world.normal, between), 0.0f, tolerance);
        EXPECT_GE(Dot(world.normal, between), 0.0f);
        EXPECT_NEAR(world.separations[0], between.Length() - a.m_radius - b.m_radius, tolerance);
        const float fromA = Dot(world.points[0] - Mul(xfA, a.m_p), world.normal);
        EXPECT_NEAR(fromA, a.m_radius + 0.5f * world.separations[0], tolerance);
    }
}

TEST(WorldManifold, LeavesItselfAloneWithoutPoints) {
    Manifold manifold;
    WorldManifold world{{3.0f, 4.0f}, {}, {5.0f, 6.0f}};
    Transform xf;
    xf.SetIdentity();
    world.Initialize(&manifold, xf, 1.0f, xf, 1.0f);
    EXPECT_EQ(world.normal, Vec2(3.0f, 4.0f));
    EXPECT_EQ(world.separations[0], 5.0f);
}

}  // namespace
}  // namespace scree::test
