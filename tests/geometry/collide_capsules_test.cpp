// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Capsules and rounded polygons with each other, with edges and with plain polygons. Manifolds against distances in
// double precision, closed forms where sides lie along each other, and the same bits whatever shares a batch.

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "geometry/collide_quads.h"
#include "tests/geometry/convex_oracle.h"
#include "tests/geometry/same_manifold.h"

namespace scree::test {
namespace {

struct Pair {
    std::unique_ptr<Shape> a, b;  ///< at least one is convex
    Placement placement;
    float size;  ///< of the shapes, m
};

Vec2 EndOf(Source& source, Vec2 start, float size) {
    return start + source.Size(0.01f, 1.0f) * size * source.Direction();
}

/// Corners of a box, or three to eight free ones.
PolygonShape RandomCorners(Source& source, float size) {
    PolygonShape polygon;
    polygon.SetAsBox(source.Size(0.05f, 1.0f) * size, source.Size(0.05f, 1.0f) * size, source.InSquare(0.5f * size),
                     source.Between(-pi, pi));
    if (source.Chance(2)) return polygon;
    Vec2 corners[maxPolygonVertices];
    const int count = 3 + source.Below(source.Chance(2) ? 2 : 6);
    do {
        for (Vec2& corner : std::span(corners).first(static_cast<size_t>(count))) corner = source.InSquare(size);
    } while (!polygon.Set(corners, count));
    return polygon;
}

std::unique_ptr<Shape> RandomShape(Source& source, float size) {
    const int kind = source.Below(7);
    const Vec2 start = source.InSquare(0.5f * size);
    const float radius = source.Size(0.01f, 0.5f) * size;
    if (kind <= 2) return std::make_unique<ConvexShape>(MakeCapsule(start, EndOf(source, start, size), radius));
    if (kind == 3) {
        EdgeShape edge;
        edge.SetTwoSided(start, EndOf(source, start, 2.0f * size));
        return std::make_unique<EdgeShape>(edge);
    }
    const PolygonShape polygon = RandomCorners(source, size);
    if (kind == 4) return std::make_unique<PolygonShape>(polygon);
    return std::make_unique<ConvexShape>(MakeRoundedPolygon(polygon.m_vertices, polygon.m_count, radius));
}

Outline CoreOf(const Shape& shape, const Transform& xf) {
    DistanceProxy proxy;
    proxy.Set(&shape, 0);
    return Place(proxy, xf);
}

double DistanceOf(const Pair& pair) {
    return OutlineDistance(CoreOf(*pair.a, pair.placement.a), CoreOf(*pair.b, pair.placement.b));
}

/// Free poses, sides along each other, and cores that are as far apart as they may be to touch, or a little nearer or
/// farther.
Pair RandomPair(Source& source) {
    const float size = source.Size(0.05f, 20.0f);
    Pair pair{nullptr, nullptr, {}, size};
    const auto isConvex = [](const Shape& shape) { return shape.GetType() == Shape::e_convex; };
    do {
        pair.a = RandomShape(source, size), pair.b = RandomShape(source, size);
    } while (!isConvex(*pair.a) && !isConvex(*pair.b));
    if (pair.b->GetType() == Shape::e_edge) std::swap(pair.a, pair.b);
    DistanceProxy a, b;
    a.Set(pair.a.get(), 0), b.Set(pair.b.get(), 0);
    Placement& at = pair.placement;
    at.a.Set(source.InSquare(size), source.Between(-7.0f, 7.0f));
    at.b.Set(at.a.p + source.InSquare(1.5f * size), source.Between(-7.0f, 7.0f));
    if (source.Chance(3)) {
        const Vec2 along = a.m_vertices[1] - a.m_vertices[0], side = b.m_vertices[1] - b.m_vertices[0];
        const float turn = std::atan2(along.y, along.x) - std::atan2(side.y, side.x);
        at.b.q.Set(at.a.q.GetAngle() + turn + (source.Chance(2) ? pi : 0.0f) + source.Size(1e-7f, 1e-2f));
    }
    if (!source.Chance(4)) {
        // From where a point of one core lies on the other's, in some direction.
        const float share = source.Between(0.0f, 1.0f);
        const Vec2 onB = (1.0f - share) * b.m_vertices[0] + share * b.m_vertices[1];
        const Vec2 start = Mul(at.a, a.m_vertices[source.Below(a.m_count)]) - Mul(at.b.q, onB);
        const Vec2 direction = source.Direction();
        const double wanted = source.Chance(4) ? 0.0 : pair.a->m_radius + pair.b->m_radius;
        float near = 0.0f, far = 8.0f * size;
        for (int i = 0; i < 30; ++i) {
            const float middle = 0.5f * (near + far);
            at.b.p = start + middle * direction;
            (DistanceOf(pair) <= wanted ? near : far) = middle;
        }
        const float jitter = source.Size(1e-6f, 0.3f) * pair.b->m_radius;
        at.b.p = start + (near + source.Between(-jitter, jitter)) * direction;
    }
    return pair;
}

Manifold Collide(const Pair& pair) {
    Manifold manifold;
    CollideConvex(&manifold, pair.a.get(), pair.placement.a, pair.b.get(), pair.placement.b);
    return manifold;
}

/// How far B lies in front of A along a direction.
double GapAlong(Vec2d direction, const Outline& a, const Outline& b) {
    double farthest = -1e30, nearest = 1e30;
    for (const Vec2d& v : a) farthest = std::max(farthest, Dot(direction, v));
    for (const Vec2d& v : b) nearest = std::min(nearest, Dot(direction, v));
    return nearest - farthest;
}

/// How far the cores are apart along the side that separates them most; negative: how deep they are in each other.
double MostSeparation(const Outline& a, const Outline& b) {
    double most = -1e30;
    const auto ask = [&](const Outline& of, double sign) {
        for (size_t i = 0; i < of.size(); ++i) {
            const Vec2d along = of[(i + 1) % of.size()] - of[i];
            const Vec2d normal = sign / Length(along) * Vec2d{along.y, -along.x};
            most = std::max(most, GapAlong(normal, a, b));
        }
    };
    ask(a, 1.0), ask(b, -1.0);
    return most;
}

TEST(CollideCapsules, TouchWhereTheirCoresAreNear) {
    constexpr int trials = 60000;
    Source source(31);
    int apart = 0, corners = 0, faces = 0, twoPoints = 0, deep = 0;
    for (int trial = 0; trial < trials; ++trial) {
        const Pair pair = RandomPair(source);
        const Outline a = CoreOf(*pair.a, pair.placement.a), b = CoreOf(*pair.b, pair.placement.b);
        const double distance = OutlineDistance(a, b), radius = pair.a->m_radius + pair.b->m_radius;
        const double rounding = 2e-6 * pair.size, preference = 0.1 * linearSlop;
        const Manifold manifold = Collide(pair);
        SCOPED_TRACE(testing::Message() << "trial " << trial << ", size " << pair.size << ", distance " << distance
                                        << ", radius " << radius << ", other " << pair.a->GetType());
        if (Abs(distance - radius) > rounding) {
            ASSERT_EQ(manifold.pointCount > 0, distance < radius);
        }
        if (manifold.pointCount == 0) {
            ++apart;
            continue;
        }
        WorldManifold world;
        world.Initialize(&manifold, pair.placement.a, pair.a->m_radius, pair.placement.b, pair.b->m_radius);
        const Vec2d normal = ToDouble(world.normal);
        ASSERT_NEAR(Length(normal), 1.0, 1e-4);
        double nearest = world.separations[0];
        if (manifold.pointCount == 2) {
            ++twoPoints;
            nearest = std::min<double>(nearest, world.separations[1]);
            ASSERT_NE(manifold.points[0].id.key, manifold.points[1].id.key);
        }
        (manifold.type == Manifold::e_circles ? corners : faces) += 1;
        if (distance > preference + rounding) {
            // A face may be taken though another axis separates a little more.
            ASSERT_NEAR(nearest, distance - radius, preference + rounding);
            ASSERT_GE(GapAlong(normal, a, b), distance - 2.0 * preference - rounding);
        } else {
            ++deep;
            ASSERT_NEAR(nearest, MostSeparation(a, b) - radius, 2.0 * preference + rounding);
        }
        for (int i = 0; i < manifold.pointCount; ++i) {
            ASSERT_LE(world.separations[i], rounding);
            // The point is the middle between both surfaces.
            const double halfGap = 0.5 * Abs(world.separations[i]) + rounding;
            const Vec2d p = ToDouble(world.points[i]);
            for (const auto& [core, skin] : {std::pair(&a, pair.a->m_radius), std::pair(&b, pair.b->m_radius)}) {
                const double away = OutlineDistance({p}, *core);
                ASSERT_LE(away, skin + halfGap + 2.0 * preference) << "point " << i;
            }
        }
    }
    // The comparison is worth something only if all outcomes are common.
    std::cout << apart << " apart, " << corners << " at corners, " << faces << " at faces, " << twoPoints
              << " of these with two points, " << deep << " deep\n";
    for (const int count : {apart, corners, faces, twoPoints, deep}) EXPECT_GT(count, trials / 50);
}

TEST(CollideCapsules, HaveTwoPointsWhereSidesLieAlongEachOther) {
    Source source(32);
    for (int trial = 0; trial < 2000; ++trial) {
        // A lies on the x axis from 0 to `length`, B above it from `first` to `last`.
        const float length = source.Between(0.2f, 4.0f), radius = source.Between(0.05f, 0.4f);
        const float first = source.Between(-2.0f, 0.9f * length), last = first + source.Between(0.2f, 4.0f);
        const float from = Max(first, 0.0f), to = Min(last, length);
        if (to - from < 0.01f) continue;
        PolygonShape box;
        box.SetAsBox(0.5f * length, 0.5f, {0.5f * length, -0.5f}, 0.0f);
        EdgeShape edge;
        edge.SetTwoSided({0.0f, 0.0f}, {length, 0.0f});
        const ConvexShape lower = MakeCapsule({0.0f, 0.0f}, {length, 0.0f}, radius);
        const Shape* const others[] = {&box, &edge, &lower};
        const Shape& a = *others[source.Below(3)];
        const float depth = source.Between(0.0f, 0.9f) * radius, height = a.m_radius + radius - depth;
        const Vec2 ends[2] = {{first, height}, {last, height}};
        const bool isBackwards = source.Chance(2);
        const ConvexShape b = MakeCapsule(ends[isBackwards ? 1 : 0], ends[isBackwards ? 0 : 1], radius);
        const Transform place(source.InSquare(3.0f), Rot(source.Between(-pi, pi)));
        Manifold manifold;
        CollideConvex(&manifold, &a, place, &b, place);
        ASSERT_EQ(manifold.pointCount, 2) << "trial " << trial;
        WorldManifold world;
        world.Initialize(&manifold, place, a.m_radius, place, b.m_radius);
        float places[2];
        for (int i = 0; i < 2; ++i) {
            places[i] = MulT(place, world.points[i]).x;
            EXPECT_NEAR(world.separations[i], -depth, 1e-5f);
        }
        EXPECT_NEAR(Min(places[0], places[1]), from, 2e-5f) << "trial " << trial;
        EXPECT_NEAR(Max(places[0], places[1]), to, 2e-5f) << "trial " << trial;
        EXPECT_NEAR(Dot(world.normal, place.q.GetYAxis()), 1.0f, 1e-5f);
    }
}

TEST(CollideCapsules, HaveTheSameBitsInEveryBatch) {
    Source source(33);
    int touching[2][2] = {}, all = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        std::vector<Pair> pairs;
        for (int i = 1 + source.Below(4 * quadLanes); i > 0; --i) pairs.push_back(RandomPair(source));
        for (const QuadKernels& kernels : {GetQuadKernels(), GetBaseQuadKernels()}) {
            std::optional<CoreBatch> batches[2][2];
            const auto compare = [&](CoreBatch& batch, int& count) {
                batch.Collide();
                for (int lane = 0; lane < batch.Size(); ++lane) {
                    const Manifold expected = Collide(pairs[static_cast<size_t>(batch.GetId(lane))]);
                    Manifold found;
                    batch.Write(lane, found);
                    ExpectSame(expected, found);
                    count += found.pointCount > 0 ? 1 : 0;
                }
                batch.Clear();
            };
            for (size_t i = 0; i < pairs.size(); ++i) {
                const Pair& p = pairs[i];
                const CorePair kinds(*p.a, *p.b);
                if (!kinds.GoTogether()) continue;
                const auto a = static_cast<size_t>(kinds.a), b = static_cast<size_t>(kinds.b);
                if (!batches[a][b]) batches[a][b].emplace(kinds, kernels);
                batches[a][b]->Add(static_cast<int>(i), *p.a, p.placement.a, *p.b, p.placement.b);
                ++all;
                if (batches[a][b]->IsFull()) compare(*batches[a][b], touching[a][b]);
            }
            for (size_t a = 0; a < 2; ++a) {
                for (size_t b = 0; b < 2; ++b) {
                    if (batches[a][b]) compare(*batches[a][b], touching[a][b]);
                }
            }
            if (HasFatalFailure()) FAIL() << "trial " << trial;
        }
    }
    for (const auto& ofA : touching) {
        for (const int count : ofA) EXPECT_GT(count, all / 50);
    }
}

TEST(CollideCapsules, TouchNothingAtANonFinitePlacement) {
    const ConvexShape capsule = MakeCapsule({-0.5f, 0.0f}, {0.5f, 0.0f}, 0.2f);
    PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    const Transform fine(Vec2{0.0f, 0.1f}, Rot(0.3f));
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        Transform broken = fine;
        broken.p.x = bad;
        for (const Shape* a : {static_cast<const Shape*>(&capsule), static_cast<const Shape*>(&box)}) {
            CoreBatch batch(CorePair(*a, capsule));
            batch.Add(0, *a, fine, capsule, broken);
            batch.Add(1, *a, fine, capsule, fine);
            batch.Collide();
            Manifold manifold;
            batch.Write(0, manifold);
            EXPECT_EQ(manifold.pointCount, 0);
            batch.Write(1, manifold);
            EXPECT_GT(manifold.pointCount, 0) << "the neighbour is not affected";
        }
    }
}

}  // namespace
}  // namespace scree::test
