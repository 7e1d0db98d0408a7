// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Slow references in double for distance and time of impact. Convex cores are placed in the world, and their distance
// is found by trying every vertex against every side. Also a source of shapes with their twins in Box2D 2.4.1.

#pragma once

#include <box2d/b2_distance.h>
#include <box2d/b2_time_of_impact.h>

#include <algorithm>
#include <vector>

#include "scree/time_of_impact.h"
#include "tests/geometry/oracle.h"

namespace scree::test {

struct Vec2d {
    double x, y;
};

inline Vec2d operator+(Vec2d a, Vec2d b) { return {a.x + b.x, a.y + b.y}; }
inline Vec2d operator-(Vec2d a, Vec2d b) { return {a.x - b.x, a.y - b.y}; }
inline Vec2d operator*(double s, Vec2d a) { return {s * a.x, s * a.y}; }
inline double Dot(Vec2d a, Vec2d b) { return a.x * b.x + a.y * b.y; }
inline double Cross(Vec2d a, Vec2d b) { return a.x * b.y - a.y * b.x; }
inline double Length(Vec2d a) { return std::sqrt(Dot(a, a)); }
inline Vec2d ToDouble(Vec2 v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }

/// The vertices of a core in the world.
using Outline = std::vector<Vec2d>;

/// A proxy placed by a transform, whose rotation is taken as it is.
inline Outline Place(const DistanceProxy& proxy, const Transform& xf) {
    Outline out;
    for (int i = 0; i < proxy.m_count; ++i) {
        const Vec2d v = ToDouble(proxy.m_vertices[i]);
        const double s = xf.q.s, c = xf.q.c;
        out.push_back(Vec2d{c * v.x - s * v.y, s * v.x + c * v.y} + ToDouble(xf.p));
    }
    return out;
}

/// A proxy on its sweep at time t.
inline Outline Place(const DistanceProxy& proxy, const Sweep& sweep, double t) {
    Outline out;
    const double angle = sweep.a0 + t * (static_cast<double>(sweep.a) - static_cast<double>(sweep.a0));
    const double s = std::sin(angle), c = std::cos(angle);
    const Vec2d centre = ToDouble(sweep.c0) + t * (ToDouble(sweep.c) - ToDouble(sweep.c0));
    for (int i = 0; i < proxy.m_count; ++i) {
        const Vec2d v = ToDouble(proxy.m_vertices[i]) - ToDouble(sweep.localCenter);
        out.push_back(Vec2d{c * v.x - s * v.y, s * v.x + c * v.y} + centre);
    }
    return out;
}

inline double PointSegmentDistance(Vec2d p, Vec2d a, Vec2d b) {
    const Vec2d e = b - a;
    const double squared = Dot(e, e);
    const double t = squared > 0.0 ? std::clamp(Dot(p - a, e) / squared, 0.0, 1.0) : 0.0;
    return Length(p - (a + t * e));
}

inline bool SegmentsCross(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
    const double c1 = Cross(b - a, c - a), c2 = Cross(b - a, d - a);
    const double d1 = Cross(d - c, a - c), d2 = Cross(d - c, b - c);
    return c1 * c2 < 0.0 && d1 * d2 < 0.0;
}

inline bool IsInside(Vec2d p, const Outline& o) {
    if (o.size() < 3) return false;
    for (size_t i = 0; i < o.size(); ++i) {
        if (Cross(o[(i + 1) % o.size()] - o[i], p - o[i]) < 0.0) return false;
    }
    return true;
}

/// Distance of two convex outlines; 0 when they overlap.
inline double OutlineDistance(const Outline& a, const Outline& b) {
    if (IsInside(a[0], b) || IsInside(b[0], a)) return 0.0;
    double best = Length(a[0] - b[0]);
    for (size_t i = 0; i < a.size(); ++i) {
        const Vec2d a0 = a[i], a1 = a[(i + 1) % a.size()];
        for (size_t j = 0; j < b.size(); ++j) {
            const Vec2d b0 = b[j], b1 = b[(j + 1) % b.size()];
            if (SegmentsCross(a0, a1, b0, b1)) return 0.0;
            best = std::min({best, PointSegmentDistance(a0, b0, b1), PointSegmentDistance(b0, a0, a1)});
        }
    }
    return best;
}

/// A shape of any of the three types, and its twin.
class AnyShape {
public:
    explicit AnyShape(const CircleShape& s) : m_type(Shape::e_circle), m_circle(s), m_circleTwin(ToBox2d(s)) {}
    explicit AnyShape(const EdgeShape& s) : m_type(Shape::e_edge), m_edge(s), m_edgeTwin(ToBox2d(s)) {}
    explicit AnyShape(const PolygonShape& s) : m_type(Shape::e_polygon), m_polygon(s), m_polygonTwin(ToBox2d(s)) {}

    static AnyShape Box(float hx, float hy) {
        PolygonShape box;
        box.SetAsBox(hx, hy);
        return AnyShape(box);
    }
    static AnyShape Circle(float radius) {
        CircleShape circle;
        circle.m_radius = radius;
        return AnyShape(circle);
    }
    static AnyShape Edge(Vec2 v1, Vec2 v2) {
        EdgeShape edge;
        edge.SetTwoSided(v1, v2);
        return AnyShape(edge);
    }
    static AnyShape Random(Source& source) {
        const int kind = source.Below(3);
        if (kind == 0) return AnyShape(RandomCircle(source));
        if (kind == 1) return AnyShape(RandomEdge(source));
        return AnyShape(RandomPolygon(source));
    }

    [[nodiscard]] const Shape& Ours() const {
        if (m_type == Shape::e_circle) return m_circle;
        if (m_type == Shape::e_edge) return m_edge;
        return m_polygon;
    }
    [[nodiscard]] const b2Shape& Theirs() const {
        if (m_type == Shape::e_circle) return m_circleTwin;
        if (m_type == Shape::e_edge) return m_edgeTwin;
        return m_polygonTwin;
    }

private:
    Shape::Type m_type;
    CircleShape m_circle;
    EdgeShape m_edge;
    PolygonShape m_polygon;
    b2CircleShape m_circleTwin;
    b2EdgeShape m_edgeTwin;
    b2PolygonShape m_polygonTwin;
};

inline DistanceProxy ProxyOf(const AnyShape& shape) {
    DistanceProxy proxy;
    proxy.Set(&shape.Ours(), 0);
    return proxy;
}

inline b2DistanceProxy TwinProxyOf(const AnyShape& shape) {
    b2DistanceProxy proxy;
    proxy.Set(&shape.Theirs(), 0);
    return proxy;
}

inline b2Sweep ToBox2d(const Sweep& sweep) {
    b2Sweep out;
    out.localCenter = ToBox2d(sweep.localCenter);
    out.c0 = ToBox2d(sweep.c0);
    out.c = ToBox2d(sweep.c);
    out.a0 = sweep.a0;
    out.a = sweep.a;
    out.alpha0 = sweep.alpha0;
    return out;
}

/// A sweep without rotation about the body's origin, unless given.
inline Sweep MakeSweep(Vec2 from, Vec2 to, float angleFrom = 0.0f, float angleTo = 0.0f) {
    return {.localCenter = vec2Zero, .c0 = from, .c = to, .a0 = angleFrom, .a = angleTo, .alpha0 = 0.0f};
}

}  // namespace scree::test
