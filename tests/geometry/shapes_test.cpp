// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Circle, edge and polygon: mass against closed forms and Box2D 2.4.1, point tests and ray casts against Box2D, boxes
// tight around the sampled outline.

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <vector>

#include "scree/convex_shape.h"
#include "tests/geometry/oracle.h"

namespace scree::test {
namespace {

constexpr int trials = 100000;

/// Calls `check(shape, twin)` with random shapes of the three types in turn.
template <typename Check>
void ForRandomShapes(uint32_t seed, Check check) {
    Source source(seed);
    for (int i = 0; i < trials; ++i) {
        const CircleShape circle = RandomCircle(source);
        check(source, circle, ToBox2d(circle));
        const EdgeShape edge = RandomEdge(source);
        check(source, edge, ToBox2d(edge));
        const PolygonShape polygon = RandomPolygon(source);
        check(source, polygon, ToBox2d(polygon));
    }
}

TEST(Shape, MassAgreesWithBox2d) {
    ForRandomShapes(41, [](Source& source, const Shape& ours, const b2Shape& theirs) {
        const float density = source.Between(0.0f, 10.0f);
        MassData mass;
        b2MassData expected;
        ours.ComputeMass(&mass, density);
        theirs.ComputeMass(&expected, density);
        EXPECT_LE(Abs(mass.mass - expected.mass), allowedGap);
        EXPECT_LE(Gap(mass.center, expected.center), allowedGap);
        EXPECT_LE(Abs(mass.I - expected.I), allowedGap);
    });
}

TEST(Shape, PointTestAgreesWithBox2d) {
    int inside = 0;
    int differing = 0;
    ForRandomShapes(42, [&](Source& source, const Shape& ours, const b2Shape& theirs) {
        const Transform xf = RandomPlacement(source).a;
        // Corners and centres of the grid of placements make points exactly on borders common.
        const Vec2 p = xf.p + (source.Chance(2) ? source.InSquare(1.2f)
                                                : Vec2{0.5f, 0.5f * static_cast<float>(source.Below(3) - 1)});
        const bool hit = ours.TestPoint(xf, p);
        inside += hit;
        differing += hit != theirs.TestPoint(ToBox2d(xf), ToBox2d(p));
    });
    EXPECT_GT(inside, trials / 5);
    EXPECT_LE(differing, static_cast<int>(allowedShare * 3 * trials));
}

TEST(Shape, RayCastAgreesWithBox2d) {
    int hits[Shape::e_polygon + 1] = {};
    int differing = 0;
    ForRandomShapes(43, [&](Source& source, const Shape& ours, const b2Shape& theirs) {
        const Transform xf = RandomPlacement(source).a;
        RayCastInput input;
        input.p1 = xf.p + source.InSquare(3.0f);
        input.p2 = xf.p + (source.Chance(8) ? input.p1 - xf.p : source.InSquare(1.0f));
        if (source.Chance(4)) input.p2.y = input.p1.y;  // parallel to the faces of upright boxes
        input.maxFraction = source.Chance(2) ? 1.0f : source.Between(0.0f, 2.0f);
        const b2RayCastInput twin{ToBox2d(input.p1), ToBox2d(input.p2), input.maxFraction};
        RayCastOutput output{};
        b2RayCastOutput expected;
        const bool hit = ours.RayCast(&output, input, xf);
        const bool expectedHit = theirs.RayCast(&expected, twin, ToBox2d(xf), 0);
        differing += hit != expectedHit;
        if (!hit || !expectedHit) return;
        ++hits[ours.GetType()];
        EXPECT_LE(Abs(output.fraction - expected.fraction), allowedGap);
        EXPECT_LE(Gap(output.normal, expected.normal), allowedGap);
    });
    for (const int count : hits) EXPECT_GT(count, trials / 10);
    EXPECT_LE(differing, static_cast<int>(allowedShare * 3 * trials));
}

/// Box2D takes rays below a third of a millimetre for none.
TEST(Shape, ShortRaysMeetCircles) {
    Source source(44);
    for (int i = 0; i < trials; ++i) {
        CircleShape circle;
        circle.m_radius = source.Size(1e-6f, 1.0f);
        const float length = Min(circle.m_radius * source.Size(1e-3f, 0.9f), 3e-4f),
                    outside = source.Between(0.1f, 0.9f);
        const Vec2 out = source.Direction();
        RayCastInput input;
        input.p1 = (circle.m_radius + outside * length) * out;
        input.p2 = (circle.m_radius - (1.0f - outside) * length) * out;
        input.maxFraction = 1.0f;
        const double x = double{input.p1.x}, y = double{input.p1.y};
        const double rayX = double{input.p2.x} - x, rayY = double{input.p2.y} - y;
        const double rr = rayX * rayX + rayY * rayY, approach = x * rayX + y * rayY;
        const double radius = double{circle.m_radius};
        const double fraction =
            -(approach + std::sqrt(approach * approach - rr * (x * x + y * y - radius * radius))) / rr;
        RayCastOutput output{};
        const bool hit = circle.RayCast(&output, input, Transform(vec2Zero, Rot(0.0f)));
        if (fraction > 0.01 && fraction < 0.99) ASSERT_TRUE(hit) << circle.m_radius << " " << length;
        if (!hit) continue;
        EXPECT_NEAR(double{output.fraction}, fraction, 1e-6) << circle.m_radius << " " << length;
        EXPECT_NEAR(double{Dot(output.normal, out)}, 1.0, 1e-6);
    }
}

struct Point {
    double x, y;
};
double DistanceToSegment(Point p, Point a, Point b) {
    const double x = b.x - a.x, y = b.y - a.y, squared = x * x + y * y;
    const double t = squared > 0.0 ? std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / squared, 0.0, 1.0) : 0.0;
    return std::hypot(a.x + t * x - p.x, a.y + t * y - p.y);
}

/// Rays of up to a hundred kilometres at disks and capsules of about a metre, against distances in double. Near ones
/// are as rough as Box2D's.
TEST(Shape, LongRaysHitWhatIsOnTheirWay) {
    Source source(46);
    int hits = 0, misses = 0;
    for (int i = 0; i < trials; ++i) {
        const Vec2 end = source.InSquare(1.0f);
        const float radius = source.Between(0.1f, 1.0f), length = source.Size(10.0f, 1e5f);
        CircleShape disk;
        disk.m_radius = radius;
        const bool isDisk = source.Chance(2);
        const ConvexShape capsule = MakeCapsule(vec2Zero, end, radius);
        const Shape& shape = isDisk ? static_cast<const Shape&>(disk) : capsule;
        const Vec2 direction = source.Direction(), target = source.InSquare(2.0f);
        const RayCastInput ray{target - length * direction, target + 3.0f * direction, 1.0f};
        RayCastOutput hit{};
        const bool isHit = shape.RayCast(&hit, ray, Transform(vec2Zero, Rot(0.0f)));

        const Point p1{ray.p1.x, ray.p1.y}, p2{ray.p2.x, ray.p2.y}, a{0.0, 0.0};
        const Point b = isDisk ? a : Point{end.x, end.y};
        const bool isFar = std::min(Distance(ray.p1, vec2Zero), Distance(ray.p1, end)) > 100.0f * radius;
        const double rounding = isFar ? 1e-6 + 2.0 * FLT_EPSILON * length : 2e-3 * radius;
        const auto at = [&](double t) { return Point{p1.x + t * (p2.x - p1.x), p1.y + t * (p2.y - p1.y)}; };
        if (isHit) {
            ++hits;
            ASSERT_NEAR(DistanceToSegment(at(hit.fraction), a, b), radius, rounding) << length << " m";
            continue;
        }
        ++misses;
        // The nearest point of the core to the ray is one of its ends, where the ray does not cross it.
        const auto side = [&](Point c) { return (p2.x - p1.x) * (c.y - p1.y) - (p2.y - p1.y) * (c.x - p1.x); };
        ASSERT_GE(side(a) * side(b), 0.0) << length << " m: it crosses the core";
        ASSERT_GE(std::min({DistanceToSegment(a, p1, p2), DistanceToSegment(b, p1, p2), DistanceToSegment(p2, a, b)}),
                  radius - rounding)
            << length << " m";
    }
    EXPECT_GT(hits, trials / 5);
    EXPECT_GT(misses, trials / 5);
}

TEST(Shape, BoxAgreesWithBox2d) {
    ForRandomShapes(44, [](Source& source, const Shape& ours, const b2Shape& theirs) {
        const Transform xf = RandomPlacement(source).a;
        AABB box;
        b2AABB expected;
        ours.ComputeAABB(&box, xf);
        theirs.ComputeAABB(&expected, ToBox2d(xf), 0);
        EXPECT_TRUE(box.IsValid());
        EXPECT_LE(Gap(box.lowerBound, expected.lowerBound), allowedGap);
        EXPECT_LE(Gap(box.upperBound, expected.upperBound), allowedGap);
    });
}

/// Support of a shape's rounded outline along a world direction, in double precision from the definition.
double Support(const std::vector<Vec2>& corners, double radius, const Transform& xf, double nx, double ny) {
    double best = -1.0e30;
    for (const Vec2 v : corners) {
        const double x = static_cast<double>(xf.q.c) * v.x - static_cast<double>(xf.q.s) * v.y + xf.p.x;
        const double y = static_cast<double>(xf.q.s) * v.x + static_cast<double>(xf.q.c) * v.y + xf.p.y;
        best = std::max(best, x * nx + y * ny);
    }
    return best + radius;
}

TEST(Shape, BoxIsTight) {
    ForRandomShapes(45, [](Source& source, const Shape& shape, const b2Shape&) {
        Transform xf;
        xf.Set(source.InSquare(2.0f), source.Between(-pi, pi));
        std::vector<Vec2> corners;
        if (shape.GetType() == Shape::e_circle) {
            corners = {static_cast<const CircleShape&>(shape).m_p};
        } else if (shape.GetType() == Shape::e_edge) {
            const auto& edge = static_cast<const EdgeShape&>(shape);
            corners = {edge.m_vertex1, edge.m_vertex2};
        } else {
            const auto& polygon = static_cast<const PolygonShape&>(shape);
            corners.assign(polygon.m_vertices, polygon.m_vertices + polygon.m_count);
        }
        AABB box;
        shape.ComputeAABB(&box, xf);
        constexpr double tolerance = 2.0e-6;  // a few roundings of coordinates below 6 m
        EXPECT_NEAR(box.upperBound.x, Support(corners, shape.m_radius, xf, 1.0, 0.0), tolerance);
        EXPECT_NEAR(box.upperBound.y, Support(corners, shape.m_radius, xf, 0.0, 1.0), tolerance);
        EXPECT_NEAR(-box.lowerBound.x, Support(corners, shape.m_radius, xf, -1.0, 0.0), tolerance);
        EXPECT_NEAR(-box.lowerBound.y, Support(corners, shape.m_radius, xf, 0.0, -1.0), tolerance);
    });
}

TEST(CircleShape, MassIsThatOfADisk) {
    CircleShape circle;
    circle.m_radius = 0.5f;
    circle.m_p = {3.0f, -4.0f};
    MassData mass;
    circle.ComputeMass(&mass, 2.0f);
    const double m = 2.0 * M_PI * 0.25;
    EXPECT_NEAR(mass.mass, m, 1.0e-6);
    EXPECT_EQ(mass.center, Vec2(3.0f, -4.0f));
    EXPECT_NEAR(mass.I, m * (0.5 * 0.25 + 25.0), 1.0e-5);  // about the origin; 40 rounded to float: 2e-6 a step
}

TEST(EdgeShape, HasNoMass) {
    EdgeShape edge;
    edge.SetTwoSided({1.0f, 2.0f}, {3.0f, 6.0f});
    MassData mass;
    edge.ComputeMass(&mass, 5.0f);
    EXPECT_EQ(mass.mass, 0.0f);
    EXPECT_EQ(mass.I, 0.0f);
    EXPECT_EQ(mass.center, Vec2(2.0f, 4.0f));
}

TEST(PolygonShape, MassOfABoxIsTheTextbookOne) {
    PolygonShape box;
    box.SetAsBox(0.5f, 1.5f, {2.0f, -1.0f}, 0.7f);
    MassData mass;
    box.ComputeMass(&mass, 3.0f);
    const double m = 3.0 * 1.0 * 3.0;
    EXPECT_NEAR(mass.mass, m, 1.0e-5);
    EXPECT_NEAR(mass.center.x, 2.0, 1.0e-6);
    EXPECT_NEAR(mass.center.y, -1.0, 1.0e-6);
    EXPECT_NEAR(mass.I, m * ((1.0 + 9.0) / 12.0 + 5.0), 1.0e-4);  // 52: 4e-6 a rounding, a dozen of them
}

TEST(PolygonShape, MassOfARegularPolygonIsTheTextbookOne) {
    for (int n = 3; n <= maxPolygonVertices; ++n) {
        const double circumradius = 1.25;
        Vec2 points[maxPolygonVertices];
        for (int i = 0; i < n; ++i) {
            const double angle = 2.0 * M_PI * i / n + 0.3;
            points[i] = {static_cast<float>(circumradius * std::cos(angle)),
                         static_cast<float>(circumradius * std::sin(angle))};
        }
        PolygonShape polygon;
        ASSERT_TRUE(polygon.Set(points, n));
        ASSERT_EQ(polygon.m_count, n);
        MassData mass;
        polygon.ComputeMass(&mass, 1.0f);
        const double area = 0.5 * n * circumradius * circumradius * std::sin(2.0 * M_PI / n);
        const double inertia = area * circumradius * circumradius / 6.0 * (2.0 + std::cos(2.0 * M_PI / n));
        // Corners are rounded to float (1e-7 relative), area and inertia scale with their 2nd and 4th power.
        EXPECT_NEAR(mass.mass, area, 4.0e-6);
        EXPECT_NEAR(mass.center.Length(), 0.0, 1.0e-6);
        EXPECT_NEAR(mass.I, inertia, 1.0e-5);
        EXPECT_NEAR(polygon.m_centroid.Length(), 0.0, 1.0e-6);
    }
}

TEST(PolygonShape, AnEmptyShapeIsHarmless) {
    const PolygonShape empty;
    Transform xf;
    xf.SetIdentity();
    MassData mass;
    empty.ComputeMass(&mass, 1.0f);
    EXPECT_EQ(mass.mass, 0.0f);
    EXPECT_FALSE(empty.TestPoint(xf, {0.0f, 0.0f}));
    RayCastOutput output;
    EXPECT_FALSE(empty.RayCast(&output, {{-1.0f, 0.0f}, {1.0f, 0.0f}, 1.0f}, xf));
}

TEST(EdgeShape, ARayFromBehindPassesAOneSidedEdge) {
    EdgeShape edge;
    // v1 → v2 runs to −x, so its right side, the solid one's outside, is +y.
    edge.SetOneSided({2.0f, 0.0f}, {1.0f, 0.0f}, {-1.0f, 0.0f}, {-2.0f, 0.0f});
    Transform xf;
    xf.SetIdentity();
    RayCastOutput output;
    ASSERT_TRUE(edge.RayCast(&output, {{0.0f, 1.0f}, {0.0f, -1.0f}, 1.0f}, xf));
    EXPECT_EQ(output.fraction, 0.5f);
    EXPECT_EQ(output.normal, Vec2(0.0f, 1.0f));
    EXPECT_FALSE(edge.RayCast(&output, {{0.0f, -1.0f}, {0.0f, 1.0f}, 1.0f}, xf));
    edge.SetTwoSided({1.0f, 0.0f}, {-1.0f, 0.0f});
    ASSERT_TRUE(edge.RayCast(&output, {{0.0f, -1.0f}, {0.0f, 1.0f}, 1.0f}, xf));
    EXPECT_EQ(output.normal, Vec2(0.0f, -1.0f));
}

}  // namespace
}  // namespace scree::test
