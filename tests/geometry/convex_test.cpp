// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Convex shapes alone and in pairs. Closed forms of mass and box, ray casts against dense outlines, manifolds against
// distances. Agreement with the circle and the polygon where both can say the same.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <functional>
#include <iostream>
#include <memory>
#include <vector>

#include "geometry/collide.h"
#include "geometry/reach.h"
#include "scree/distance.h"
#include "scree/scree.h"
#include "tests/geometry/oracle.h"

namespace scree::test {
namespace {

const Transform identity(vec2Zero, Rot(0.0f));

/// |x/a|⁴ + |y/b|⁴ = 1 has the support point where the gradient points along the direction.
struct Superellipse {
    float a = 1.0f, b = 0.5f;

    static Vec2 Support(const void* data, Vec2 d) {
        const auto& s = *static_cast<const Superellipse*>(data);
        const float u = std::pow(std::fabs(s.a * d.x), 1.0f / 3.0f), v = std::pow(std::fabs(s.b * d.y), 1.0f / 3.0f);
        const float scale = std::pow(u * u * u * u + v * v * v * v, -0.25f);
        return {std::copysign(s.a * u * scale, d.x), std::copysign(s.b * v * scale, d.y)};
    }
};

ConvexShape MakeSuperellipse(const Superellipse& data) {
    return MakeFromSupport({.support = Superellipse::Support, .data = &data, .boundingRadius = 2.0f});
}

std::vector<Vec2> RegularPoints(int count, float radius) {
    std::vector<Vec2> points;
    for (int i = 0; i < count; ++i) {
        points.push_back(radius * Rot(2.0f * pi * static_cast<float>(i) / static_cast<float>(count)).GetXAxis());
    }
    return points;
}

const Vec2 boxPoints[4] = {{-0.5f, -0.3f}, {0.5f, -0.3f}, {0.5f, 0.3f}, {-0.5f, 0.3f}};

/// Mass data by counting the cells of a fine grid whose centres the shape contains.
MassData CountCells(const Shape& shape, float halfWidth) {
    constexpr int cells = 1000;
    const double size = 2.0 * halfWidth / cells;
    double area = 0, x = 0, y = 0, inertia = 0;
    for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
            const double px = -halfWidth + (i + 0.5) * size, py = -halfWidth + (j + 0.5) * size;
            if (!shape.TestPoint(identity, {static_cast<float>(px), static_cast<float>(py)})) continue;
            area += size * size;
            x += size * size * px;
            y += size * size * py;
            inertia += size * size * (px * px + py * py);
        }
    }
    return {static_cast<float>(area),
            {static_cast<float>(x / area), static_cast<float>(y / area)},
            static_cast<float>(inertia)};
}

struct Named {
    const char* name;
    ConvexShape shape;
};

std::vector<Named> AllConvex() {
    static const Superellipse data;
    return {{"capsule", MakeCapsule({-0.5f, 0.1f}, {0.6f, 0.2f}, 0.3f)},
            {"disk", MakeCapsule({0.2f, 0.1f}, {0.2f, 0.1f}, 0.4f)},
            {"box", MakePolygon(boxPoints, 4)},
            {"32-gon", MakePolygon(RegularPoints(32, 0.7f).data(), 32)},
            {"64-gon", MakePolygon(RegularPoints(64, 0.9f).data(), 64)},
            {"rounded box", MakeRoundedPolygon(boxPoints, 4, 0.2f)},
            {"rounded triangle", MakeRoundedPolygon(RegularPoints(3, 0.6f).data(), 3, 0.1f)},
            {"ellipse", MakeEllipse(1.0f, 0.4f, {0.1f, -0.1f}, 0.3f)},
            {"thin ellipse", MakeEllipse(0.1f, 1.0f)},
            {"sector", MakeCircleSector(0.9f, 1.2f, {-0.2f, 0.1f}, 0.7f)},
            {"half disk", MakeCircleSector(0.8f, pi, {0.0f, 0.0f}, -0.4f)},
            {"superellipse", MakeSuperellipse(data)}};
}

TEST(Convex, EveryDescriptionMakesAValidShape) {
    for (const Named& n : AllConvex()) {
        EXPECT_EQ(n.shape.m_badField, nullptr) << n.name << ": " << n.shape.m_badField;
        EXPECT_TRUE(n.shape.Validate()) << n.name;
        // The core of a curved shape lies inside by at most a thousandth of the shape's size.
        AABB box;
        n.shape.ComputeAABB(&box, identity);
        const Vec2 extent = box.upperBound - box.lowerBound;
        EXPECT_LE(n.shape.m_error, 1.0e-3f * Max(extent.x, extent.y)) << n.name;
        std::cout << n.name << ": " << n.shape.m_count << " vertices, error " << n.shape.m_error << " m\n";
    }
}

TEST(Convex, MassIsThatOfTheAreaInside) {
    for (const Named& n : AllConvex()) {
        MassData mass;
        n.shape.ComputeMass(&mass, 2.0f);
        const MassData counted = CountCells(n.shape, 1.2f);
        // The grid resolves the outline to 2.4 mm / 2 on either side, and TestPoint leaves out the arcs.
        const float share = 4.0e-3f;
        EXPECT_NEAR(mass.mass, 2.0f * counted.mass, share * mass.mass) << n.name;
        EXPECT_NEAR(mass.I, 2.0f * counted.I, 2.0f * share * mass.I) << n.name;
        EXPECT_LT(Distance(mass.center, counted.center), 2.0e-3f) << n.name;
    }
}

TEST(Convex, MassHasTheClosedForm) {
    MassData mass;
    MakeEllipse(2.0f, 0.5f).ComputeMass(&mass, 3.0f);
    EXPECT_FLOAT_EQ(mass.mass, 3.0f * pi);
    EXPECT_FLOAT_EQ(mass.I, 3.0f * pi * (4.0f + 0.25f) / 4.0f);

    MakeCircleSector(2.0f, pi).ComputeMass(&mass, 1.0f);
    EXPECT_FLOAT_EQ(mass.mass, 2.0f * pi);
    EXPECT_NEAR(mass.center.x, 8.0f / (3.0f * pi), 1e-6f);
    EXPECT_NEAR(mass.I, 2.0f * pi * 2.0f, 1e-5f);

    // A capsule: box of length L and height 2r, and a disk cut in two.
    const float L = 3.0f, r = 0.5f;
    MakeCapsule({-1.5f, 0.0f}, {1.5f, 0.0f}, r).ComputeMass(&mass, 1.0f);
    const float disk = pi * r * r, box = 2.0f * r * L, offset = 4.0f * r / (3.0f * pi);
    EXPECT_NEAR(mass.mass, disk + box, 1e-5f);
    const float ends = disk * (0.5f * r * r + L * L / 4.0f + L * offset);
    EXPECT_NEAR(mass.I, box * (L * L + 4.0f * r * r) / 12.0f + ends, 1e-4f);

    // Steiner: area + perimeter·r + π r².
    MakeRoundedPolygon(boxPoints, 4, 0.2f).ComputeMass(&mass, 1.0f);
    EXPECT_NEAR(mass.mass, 0.6f + 3.2f * 0.2f + pi * 0.04f, 1e-5f);

    PolygonShape polygon;
    ASSERT_TRUE(polygon.Set(boxPoints, 4));
    MassData expected;
    polygon.ComputeMass(&expected, 1.0f);
    MakePolygon(boxPoints, 4).ComputeMass(&mass, 1.0f);
    EXPECT_FLOAT_EQ(mass.mass, expected.mass);
    EXPECT_FLOAT_EQ(mass.I, expected.I);
}

TEST(Convex, ArcsFollowTheSmoothOutline) {
    // The support point of the arcs against the function they were made of: a thousand directions.
    const Superellipse super;
    const ConvexShape ellipse = MakeEllipse(1.0f, 0.4f), fourth = MakeSuperellipse(super);
    float worstEllipse = 0.0f, worstFourth = 0.0f;
    for (int i = 0; i < 1000; ++i) {
        const Vec2 d = Rot(0.00628f * static_cast<float>(i)).GetXAxis();
        const float reach = std::sqrt(d.x * d.x + 0.16f * d.y * d.y);
        worstEllipse = Max(worstEllipse, Abs(Dot(d, ellipse.GetSupportPoint(d)) - reach));
        const float reachFourth = Dot(d, Superellipse::Support(&super, d));
        worstFourth = Max(worstFourth, Abs(Dot(d, fourth.GetSupportPoint(d)) - reachFourth));
    }
    std::cout << "support off by " << worstEllipse << " m (ellipse), " << worstFourth << " m (superellipse)\n";
    EXPECT_LT(worstEllipse, 2.0e-5f);
    EXPECT_LT(worstFourth, 0.25f * fourth.m_error);  // its curvature runs from 0 to a peak: the hardest case
}

TEST(Convex, BoxOfATurnedEllipseIsExact) {
    const ConvexShape ellipse = MakeEllipse(2.0f, 0.5f);
    for (int i = 0; i < 50; ++i) {
        const Transform xf({3.0f, -2.0f}, Rot(0.13f * static_cast<float>(i)));
        AABB box;
        ellipse.ComputeAABB(&box, xf);
        const float c = xf.q.c, s = xf.q.s;
        EXPECT_NEAR(box.upperBound.x, 3.0f + polygonRadius + std::sqrt(4.0f * c * c + 0.25f * s * s), 1e-4f);
        EXPECT_NEAR(box.lowerBound.y, -2.0f - polygonRadius - std::sqrt(4.0f * s * s + 0.25f * c * c), 1e-4f);
    }
}

TEST(Convex, RaysEnterWhereTheInsideBegins) {
    Source source(7);
    for (const Named& n : AllConvex()) {
        int hits = 0;
        for (int trial = 0; trial < 200; ++trial) {
            const Transform xf(source.InSquare(1.0f), Rot(source.Between(-pi, pi)));
            const RayCastInput ray{source.InSquare(3.0f), source.InSquare(3.0f), 1.0f};
            RayCastOutput hit;
            const bool found = n.shape.RayCast(&hit, ray, xf);
            if (n.shape.TestPoint(xf, ray.p1)) {
                EXPECT_FALSE(found) << n.name;
                continue;
            }
            const auto inside = [&](float t) { return n.shape.TestPoint(xf, (1.0f - t) * ray.p1 + t * ray.p2); };
            float first = 2.0f;
            for (int i = 0; i <= 4000 && first > 1.0f; ++i) {
                if (inside(static_cast<float>(i) / 4000.0f)) first = static_cast<float>(i) / 4000.0f;
            }
            if (!found) {
                EXPECT_GT(first, 1.0f) << n.name;
                continue;
            }
            ++hits;
            // A sample may step over a grazed corner, never find the inside before the hit.
            EXPECT_GE(first, hit.fraction - 1e-5f) << n.name;
            if (first <= 1.0f && inside(first + 0.002f)) {
                EXPECT_GE(hit.fraction, first - 1.1f / 4000.0f) << n.name;
            }
            EXPECT_NEAR(hit.normal.Length(), 1.0f, 1e-5f);
            EXPECT_LT(Dot(hit.normal, ray.p2 - ray.p1), 0.0f);
        }
        EXPECT_GT(hits, 10) << n.name;
    }
}

TEST(Convex, ACapsuleWithoutLengthIsACircle) {
    CircleShape circle;
    circle.m_p = {0.2f, 0.1f};
    circle.m_radius = 0.4f;
    const ConvexShape disk = MakeCapsule(circle.m_p, circle.m_p, 0.4f);
    MassData mass, expected;
    disk.ComputeMass(&mass, 1.5f);
    circle.ComputeMass(&expected, 1.5f);
    EXPECT_FLOAT_EQ(mass.mass, expected.mass);
    EXPECT_FLOAT_EQ(mass.I, expected.I);
    Source source(3);
    for (int i = 0; i < 2000; ++i) {
        const Placement at = RandomPlacement(source);
        const PolygonShape polygon = RandomPolygon(source);
        Manifold a, b;
        CollideConvex(&a, &polygon, at.a, &disk, at.b);
        CollidePolygonAndCircle(&b, &polygon, at.a, &circle, at.b);
        WorldManifold wa, wb;
        wa.Initialize(&a, at.a, polygon.m_radius, at.b, 0.4f);
        wb.Initialize(&b, at.a, polygon.m_radius, at.b, 0.4f);
        if (a.pointCount != b.pointCount) {
            // Only within rounding of the first touch.
            EXPECT_GT((a.pointCount > 0 ? wa : wb).separations[0], -1e-3f);
            continue;
        }
        if (a.pointCount == 1) {
            EXPECT_NEAR(wa.separations[0], wb.separations[0], 1e-3f);
        }
    }
}

/// All shapes that can meet: the convex ones, circle, box, polygon, two-sided edge.
std::vector<std::unique_ptr<Shape>> AllShapes() {
    std::vector<std::unique_ptr<Shape>> all;
    for (const Named& n : AllConvex()) all.push_back(std::make_unique<ConvexShape>(n.shape));
    CircleShape circle;
    circle.m_radius = 0.6f;
    all.push_back(std::make_unique<CircleShape>(circle));
    PolygonShape polygon;
    polygon.SetAsBox(0.5f, 0.8f);
    all.push_back(std::make_unique<PolygonShape>(polygon));
    EdgeShape edge;
    edge.SetTwoSided({-1.0f, 0.1f}, {0.9f, -0.1f});
    all.push_back(std::make_unique<EdgeShape>(edge));
    return all;
}

float GapOf(const Shape& a, const Transform& xfA, const Shape& b, const Transform& xfB) {
    DistanceInput input;
    input.proxyA.Set(&a, 0);
    input.proxyB.Set(&b, 0);
    input.transformA = xfA;
    input.transformB = xfB;
    input.useRadii = false;
    SimplexCache cache;
    DistanceOutput output;
    Distance(&output, &cache, &input);
    return output.distance - input.proxyA.m_radius - input.proxyB.m_radius;
}

float ErrorOf(const Shape& shape) {
    return shape.GetType() == Shape::e_convex ? static_cast<const ConvexShape&>(shape).m_error : 0.0f;
}

TEST(Convex, EveryShapeTouchesEveryOtherAtItsDistance) {
    const auto shapes = AllShapes();
    EXPECT_TRUE(rc::check("manifold and distance agree", [&] {
        Source source(*rc::gen::arbitrary<uint32_t>());
        for (const auto& a : shapes) {
            for (const auto& b : shapes) {
                if (a->GetType() != Shape::e_convex && b->GetType() != Shape::e_convex) continue;
                const Transform xfA(source.InSquare(1.0f), Rot(source.Between(-pi, pi)));
                const Transform xfB(source.InSquare(1.5f), Rot(source.Between(-pi, pi)));
                const CollideEntry entry = FindCollide(a->GetType(), b->GetType());
                RC_ASSERT(entry.function != nullptr);
                Manifold m;
                if (entry.swap) {
                    entry.function(m, *b, xfB, *a, xfA);
                } else {
                    entry.function(m, *a, xfA, *b, xfB);
                }
                const float gap = GapOf(*a, xfA, *b, xfB);
                const float slack = ErrorOf(*a) + ErrorOf(*b) + 2e-5f;
                RC_ASSERT(gap <= slack || m.pointCount == 0);
                RC_ASSERT(gap > -1e-5f || m.pointCount > 0);
                if (m.pointCount == 0) continue;
                WorldManifold w;
                entry.swap ? w.Initialize(&m, xfB, b->m_radius, xfA, a->m_radius)
                           : w.Initialize(&m, xfA, a->m_radius, xfB, b->m_radius);
                RC_ASSERT(std::fabs(w.normal.Length() - 1.0f) < 1e-4f);
                float deepest = w.separations[0];
                if (m.pointCount == 2) deepest = Min(deepest, w.separations[1]);
                const bool shallow = gap + a->m_radius + b->m_radius > 0.001f;
                // A tenth of the slop by the preference for one face; arcs reach beyond the core by the error.
                if (shallow) RC_ASSERT(std::fabs(deepest - gap) < slack + 0.1f * linearSlop + 1e-5f);
                // Deep: moved out along the normal by the depth, the cores are apart.
                const Vec2 out = (entry.swap ? -1.0f : 1.0f) * (-deepest + 0.002f + 2.0f * slack) * w.normal;
                const Transform moved(xfB.p + out, xfB.q);
                RC_ASSERT(GapOf(*a, xfA, *b, moved) > -1e-3f);
            }
        }
    }));
}

TEST(Convex, ReachBoundsEveryPoint) {
    for (const Named& n : AllConvex()) {
        for (const Vec2 center : {Vec2{0.0f, 0.0f}, Vec2{0.4f, -0.3f}}) {
            float farthest = 0.0f;
            for (int i = 0; i < 500; ++i) {
                const Vec2 d = Rot(0.01257f * static_cast<float>(i)).GetXAxis();
                farthest = Max(farthest, Distance(n.shape.GetSupportPoint(d) + n.shape.m_radius * d, center));
            }
            EXPECT_GE(Reach(n.shape, center), farthest - 1e-5f) << n.name;
            EXPECT_LE(Reach(n.shape, center), farthest + 0.02f) << n.name;
        }
    }
}

}  // namespace
}  // namespace scree::test
