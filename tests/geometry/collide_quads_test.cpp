// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Eight pairs of small polygons, or of one and a disk, at once against the scalar functions one by one. They give the
// same bits, on every instruction set, whatever shares a batch.

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "geometry/collide_quads.h"
#include "tests/geometry/oracle.h"
#include "tests/geometry/same_manifold.h"

namespace scree {

namespace test {
namespace {

PolygonShape RandomQuad(Source& source) {
    PolygonShape polygon;
    do polygon = RandomPolygon(source);
    while (!IsQuad(polygon));
    if (source.Chance(3)) {
        const Vec2 corners[] = {{-0.6f, -0.3f}, {0.5f, -0.4f}, {0.1f, 0.7f}};
        EXPECT_TRUE(polygon.Set(corners, 3));
    }
    return polygon;
}

struct Pair {
    PolygonShape a, b;
    Placement placement;
};

Pair RandomPair(Source& source) {
    Pair pair{RandomQuad(source), RandomQuad(source), RandomPlacement(source)};
    if (source.Chance(3)) {
        BringNearTouching(source, pair.placement, [&](const Transform& xfB) {
            Manifold manifold;
            CollidePolygons(&manifold, &pair.a, pair.placement.a, &pair.b, xfB);
            return manifold.pointCount;
        });
    }
    return pair;
}

TEST(CollideQuads, GivesTheBitsOfCollidePolygons) {
    constexpr int trials = 30000;
    Source source(21);
    int touching = 0, twoPoints = 0;
    for (int trial = 0; trial < trials; ++trial) {
        std::vector<Pair> pairs;
        for (int count = 1 + source.Below(quadLanes); count > 0; --count) {
            pairs.push_back(pairs.empty() || source.Chance(2) ? RandomPair(source) : pairs.back());
        }
        for (QuadBatch batch : {QuadBatch(), QuadBatch(GetBaseQuadKernels())}) {
            for (size_t i = 0; i < pairs.size(); ++i) {
                const Pair& p = pairs[i];
                batch.Add(static_cast<int>(i), p.a, p.placement.a, p.b, p.placement.b);
            }
            batch.Collide();
            ASSERT_EQ(batch.Size(), static_cast<int>(pairs.size()));
            for (int i = 0; i < batch.Size(); ++i) {
                const Pair& p = pairs[static_cast<size_t>(batch.GetId(i))];
                Manifold expected, found;
                CollidePolygons(&expected, &p.a, p.placement.a, &p.b, p.placement.b);
                batch.Write(i, found);
                ASSERT_NO_FATAL_FAILURE(ExpectSame(expected, found)) << "trial " << trial << ", pair " << i;
                touching += expected.pointCount > 0 ? 1 : 0;
                twoPoints += expected.pointCount == 2 ? 1 : 0;
            }
        }
    }
    // The comparison is worth something only if all outcomes are common.
    EXPECT_GT(touching, trials);
    EXPECT_GT(twoPoints, trials / 2);
    EXPECT_GT(trials * quadLanes - touching, trials);
}

struct DiskPair {
    PolygonShape a;
    CircleShape b;
    Placement placement;
};

DiskPair RandomDiskPair(Source& source) {
    DiskPair pair{RandomQuad(source), RandomCircle(source), RandomPlacement(source)};
    if (source.Chance(3)) {
        BringNearTouching(source, pair.placement, [&](const Transform& xfB) {
            Manifold manifold;
            CollidePolygonAndCircle(&manifold, &pair.a, pair.placement.a, &pair.b, xfB);
            return manifold.pointCount;
        });
    }
    return pair;
}

TEST(CollideQuads, GivesTheBitsOfCollidePolygonAndCircle) {
    constexpr int trials = 30000;
    Source source(22);
    int touching = 0, atCorners = 0;
    for (int trial = 0; trial < trials; ++trial) {
        std::vector<DiskPair> pairs;
        for (int count = 1 + source.Below(quadLanes); count > 0; --count) {
            pairs.push_back(pairs.empty() || source.Chance(2) ? RandomDiskPair(source) : pairs.back());
        }
        for (QuadDiskBatch batch : {QuadDiskBatch(), QuadDiskBatch(GetBaseQuadKernels())}) {
            for (size_t i = 0; i < pairs.size(); ++i) {
                const DiskPair& p = pairs[i];
                batch.Add(static_cast<int>(i), p.a, p.placement.a, p.b, p.placement.b);
            }
            batch.Collide();
            for (int i = 0; i < batch.Size(); ++i) {
                const DiskPair& p = pairs[static_cast<size_t>(batch.GetId(i))];
                Manifold expected, found;
                CollidePolygonAndCircle(&expected, &p.a, p.placement.a, &p.b, p.placement.b);
                batch.Write(i, found);
                ASSERT_NO_FATAL_FAILURE(ExpectSame(expected, found)) << "trial " << trial << ", pair " << i;
                if (expected.pointCount == 0) continue;
                ++touching;
                for (int corner = 0; corner < p.a.m_count; ++corner) {
                    if (expected.localPoint == p.a.m_vertices[corner]) ++atCorners;
                }
            }
        }
    }
    EXPECT_GT(touching, trials);
    EXPECT_GT(atCorners, trials / 4);
    EXPECT_GT(touching - atCorners, trials / 4);
    EXPECT_GT(trials * quadLanes - touching, trials);
}

TEST(CollideQuads, LeavesImpulsesAlone) {
    PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    Transform low, high;
    low.SetIdentity();
    high.Set({0.1f, 0.99f}, 0.0f);
    Manifold manifold;
    for (ManifoldPoint& p : manifold.points) p.normalImpulse = 3.0f, p.tangentImpulse = -2.0f;
    QuadBatch batch;
    batch.Add(7, box, low, box, high);
    batch.Collide();
    EXPECT_EQ(batch.GetId(0), 7);
    batch.Write(0, manifold);
    ASSERT_EQ(manifold.pointCount, 2);
    for (const ManifoldPoint& p : manifold.points) {
        EXPECT_EQ(p.normalImpulse, 3.0f);
        EXPECT_EQ(p.tangentImpulse, -2.0f);
    }
}

TEST(CollideQuads, TouchesNothingAtANonFinitePlacement) {
    PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    const Transform fine(Vec2{0.0f, 0.0f}, Rot(0.3f));
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        Transform broken = fine;
        broken.p.x = bad;
        QuadBatch batch;
        batch.Add(0, box, fine, box, broken);
        batch.Add(1, box, fine, box, fine);
        batch.Collide();
        Manifold manifold;
        batch.Write(0, manifold);
        EXPECT_EQ(manifold.pointCount, 0);
        batch.Write(1, manifold);
        EXPECT_EQ(manifold.pointCount, 2) << "the neighbour is not affected";

        CircleShape disk;
        disk.m_radius = 0.2f;
        QuadDiskBatch disks;
        disks.Add(0, box, fine, disk, broken);
        disks.Add(1, box, fine, disk, fine);
        disks.Collide();
        disks.Write(0, manifold);
        EXPECT_EQ(manifold.pointCount, 0);
        disks.Write(1, manifold);
        EXPECT_EQ(manifold.pointCount, 1) << "the neighbour is not affected";
    }
}

TEST(CollideQuads, TakesSmallPolygonsOnly) {
    PolygonShape polygon;
    polygon.SetAsBox(1.0f, 1.0f);
    EXPECT_TRUE(IsQuad(polygon));
    const Vec2 five[] = {{1.0f, 0.0f}, {0.3f, 0.9f}, {-0.8f, 0.6f}, {-0.8f, -0.6f}, {0.3f, -0.9f}};
    ASSERT_TRUE(polygon.Set(five, 5));
    ASSERT_EQ(polygon.m_count, 5);
    EXPECT_FALSE(IsQuad(polygon));
    EXPECT_FALSE(IsQuad(CircleShape()));
}

}  // namespace
}  // namespace test
}  // namespace scree
