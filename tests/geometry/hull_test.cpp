// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// PolygonShape::Set: the outline contains every point, is convex and counter-clockwise, equals Box2D 2.4.1's, and input
// that makes no polygon leaves the shape as it was.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <limits>
#include <vector>

#include "tests/geometry/oracle.h"

namespace scree::test {
namespace {

/// Points on a coarse grid, so that duplicates and collinear triples are common.
rc::Gen<std::vector<Vec2>> GridPoints() {
    const auto coordinate = rc::gen::map(rc::gen::inRange(-4, 5), [](int i) { return 0.25f * static_cast<float>(i); });
    const auto point = rc::gen::map(rc::gen::pair(coordinate, coordinate),
                                    [](const std::pair<float, float>& p) { return Vec2(p.first, p.second); });
    return rc::gen::mapcat(rc::gen::inRange(3, maxPolygonVertices + 1), [point](int count) {
        return rc::gen::container<std::vector<Vec2>>(static_cast<size_t>(count), point);
    });
}

bool HasArea(const std::vector<Vec2>& points) {
    for (const Vec2 a : points) {
        for (const Vec2 b : points) {
            for (const Vec2 c : points) {
                if (Cross(b - a, c - a) != 0.0f) return true;
            }
        }
    }
    return false;
}

TEST(PolygonShape, SetMakesTheConvexHull) {
    EXPECT_TRUE(rc::check("hull of grid points", [] {
        const std::vector<Vec2> points = *GridPoints();
        PolygonShape polygon;
        const bool made = polygon.Set(points.data(), static_cast<int>(points.size()));
        RC_ASSERT(made == HasArea(points));  // arithmetic on this grid is exact
        if (!made) return;
        for (int i = 0; i < polygon.m_count; ++i) {
            const Vec2 v = polygon.m_vertices[i];
            const Vec2 next = polygon.m_vertices[(i + 1) % polygon.m_count];
            const Vec2 afterNext = polygon.m_vertices[(i + 2) % polygon.m_count];
            RC_ASSERT(Cross(next - v, afterNext - next) > 0.0f);  // strictly convex, counter-clockwise
            int copies = 0;
            for (const Vec2 p : points) {
                RC_ASSERT(Cross(next - v, p - v) >= 0.0f);  // everything inside
                copies += p == v;
            }
            RC_ASSERT(copies > 0);  // a corner is one of the points
            RC_ASSERT(Abs(polygon.m_normals[i].Length() - 1.0f) < 1.0e-6f);
            RC_ASSERT(Abs(Dot(polygon.m_normals[i], next - v)) < 1.0e-6f);
            RC_ASSERT(Cross(polygon.m_normals[i], next - v) > 0.0f);  // outwards
        }
        RC_ASSERT(polygon.Validate());
    }));
}

TEST(PolygonShape, SetAgreesWithBox2d) {
    Source source(31);
    int compared = 0;
    for (int i = 0; i < 100000; ++i) {
        const int count = 3 + source.Below(6);
        Vec2 points[maxPolygonVertices];
        b2Vec2 twins[maxPolygonVertices];
        const int kind = source.Below(3);
        for (int k = 0; k < count; ++k) {
            points[k] = source.InSquare(2.0f);
            if (kind == 1) points[k] = {std::round(2.0f * points[k].x), std::round(2.0f * points[k].y)};
            // Close to the welding distance of an earlier point.
            if (kind == 2 && k > 0 && source.Chance(3)) points[k] = points[k - 1] + source.InSquare(linearSlop);
            twins[k] = ToBox2d(points[k]);
        }
        PolygonShape ours;
        if (!ours.Set(points, count)) continue;  // Box2D asserts or makes a box of its own choosing
        ++compared;
        b2PolygonShape theirs;
        theirs.Set(twins, count);
        ASSERT_EQ(ours.m_count, theirs.m_count);
        for (int k = 0; k < ours.m_count; ++k) {
            EXPECT_EQ(Gap(ours.m_vertices[k], theirs.m_vertices[k]), 0.0f);
            EXPECT_LE(Gap(ours.m_normals[k], theirs.m_normals[k]), allowedGap);
        }
        // Box2D sums corners before dividing by three, we sum sides: a few roundings of numbers below 4.
        EXPECT_LE(Gap(ours.m_centroid, theirs.m_centroid), 4.0e-6f);
    }
    EXPECT_GT(compared, 90000);
}

class BadInput : public testing::Test {
protected:
    BadInput() {
        m_polygon.SetAsBox(0.25f, 0.75f);
        m_before = m_polygon;
    }
    void ExpectRefused(const std::vector<Vec2>& points) {
        EXPECT_FALSE(m_polygon.Set(points.data(), static_cast<int>(points.size())));
        ExpectUnchanged();
    }
    void ExpectUnchanged() const {
        ASSERT_EQ(m_polygon.m_count, m_before.m_count);
        EXPECT_EQ(m_polygon.m_centroid, m_before.m_centroid);
        for (int i = 0; i < m_before.m_count; ++i) {
            EXPECT_EQ(m_polygon.m_vertices[i], m_before.m_vertices[i]);
            EXPECT_EQ(m_polygon.m_normals[i], m_before.m_normals[i]);
        }
    }
    PolygonShape m_polygon, m_before;
};

TEST_F(BadInput, TooFewOrTooManyPointsChangeNothing) {
    ExpectRefused({});
    ExpectRefused({{0.0f, 0.0f}, {1.0f, 0.0f}});
    std::vector<Vec2> nine;
    for (int i = 0; i < 9; ++i) nine.push_back(Rot(0.69f * static_cast<float>(i)).GetXAxis());
    ExpectRefused(nine);
    EXPECT_FALSE(m_polygon.Set(nullptr, 4));
    EXPECT_FALSE(m_polygon.Set(nine.data(), -1));
    ExpectUnchanged();
}

TEST_F(BadInput, NonFinitePointsChangeNothing) {
    for (const float bad : {NAN, INFINITY, -INFINITY}) {
        ExpectRefused({{0.0f, 0.0f}, {1.0f, 0.0f}, {bad, 1.0f}});
        ExpectRefused({{0.0f, bad}, {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}});
    }
    const float huge = std::numeric_limits<float>::max();
    ExpectRefused({{-huge, -huge}, {huge, -huge}, {0.0f, huge}});  // finite points, infinite sides
}

TEST_F(BadInput, PointsWithoutAreaChangeNothing) {
    ExpectRefused({{0.0f, 0.0f}, {1.0f, 1.0f}, {2.0f, 2.0f}, {-5.0f, -5.0f}});
    ExpectRefused({{1.0f, 2.0f}, {1.0f, 2.0f}, {1.0f, 2.0f}});
    ExpectRefused({{0.0f, 0.0f}, {0.001f, 0.0f}, {0.0f, 0.001f}});  // all within the welding distance
    ExpectRefused({{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 0.001f}});    // two of three welded
}

TEST_F(BadInput, HalfExtentsThatAreNotPositiveChangeNothing) {
    for (const float bad : {0.0f, -1.0f, NAN, INFINITY}) {
        m_polygon.SetAsBox(bad, 1.0f);
        m_polygon.SetAsBox(1.0f, bad);
        m_polygon.SetAsBox(bad, 1.0f, {0.0f, 0.0f}, 0.0f);
        ExpectUnchanged();
    }
    m_polygon.SetAsBox(1.0f, 1.0f, {NAN, 0.0f}, 0.0f);
    m_polygon.SetAsBox(1.0f, 1.0f, {0.0f, 0.0f}, INFINITY);
    ExpectUnchanged();
}

TEST_F(BadInput, NearlyCollinearPointsGiveAValidPolygonOrNone) {
    // Whatever rounding makes of them, the caller never gets a shape that is not convex.
    Source source(32);
    for (int i = 0; i < 200000; ++i) {
        const Vec2 direction = Rot(source.Between(-pi, pi)).GetXAxis();
        const Vec2 origin = source.InSquare(source.Chance(2) ? 1.0f : 1000.0f);
        const int count = 3 + source.Below(6);
        Vec2 points[maxPolygonVertices];
        for (int k = 0; k < count; ++k) {
            points[k] = origin + source.Between(-3.0f, 3.0f) * direction + source.InSquare(1.0e-6f);
        }
        if (m_polygon.Set(points, count)) {
            EXPECT_TRUE(m_polygon.Validate());
            m_polygon = m_before;
        } else {
            ExpectUnchanged();
        }
    }
}

TEST(PolygonShape, ValidateRefusesWhatIsNotConvex) {
    PolygonShape polygon;
    EXPECT_FALSE(polygon.Validate());  // empty
    polygon.SetAsBox(1.0f, 1.0f);
    EXPECT_TRUE(polygon.Validate());
    PolygonShape dented = polygon;
    dented.m_vertices[1] = {-0.5f, 0.5f};
    EXPECT_FALSE(dented.Validate());
    PolygonShape clockwise = polygon;
    std::swap(clockwise.m_vertices[0], clockwise.m_vertices[2]);
    EXPECT_FALSE(clockwise.Validate());
    polygon.m_vertices[3].y = NAN;
    EXPECT_FALSE(polygon.Validate());
}

}  // namespace
}  // namespace scree::test
