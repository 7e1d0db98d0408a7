// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Farthest vertex plus radius; faces against a way and against a point.

#include "geometry/reach.h"

#include "scree/convex_shape.h"

namespace scree {

namespace {

/// What is lost to rounding, a share of the coordinates: eight roundings.
constexpr float perSize = 5e-7f;

float LargerSize(Vec2 a, Vec2 b) { return Max(Abs(a.x) + Abs(a.y), Abs(b.x) + Abs(b.y)); }

/// Of the largest coordinates of a circle, an edge or a polygon: whatever is computed with a shape looks at all of
/// them.
float SizeOf(const Shape& shape) {
    switch (shape.GetType()) {
        case Shape::e_circle:
            return LargerSize(static_cast<const CircleShape&>(shape).m_p, vec2Zero);
        case Shape::e_edge:
            return LargerSize(static_cast<const EdgeShape&>(shape).m_vertex1,
                              static_cast<const EdgeShape&>(shape).m_vertex2);
        case Shape::e_polygon: {
            const auto& polygon = static_cast<const PolygonShape&>(shape);
            float size = 0.0f;
            for (int i = 0; i < polygon.m_count; ++i) size = Max(size, LargerSize(polygon.m_vertices[i], vec2Zero));
            return size;
        }
        default:
            return 0.0f;
    }
}

/// Between a point and the segment from a to b.
float DistanceToSegment(Vec2 point, Vec2 a, Vec2 b) {
    const Vec2 along = b - a;
    const float lengthSquared = along.LengthSquared();
    const float u = lengthSquared > 0.0f ? Dot(point - a, along) / lengthSquared : 0.0f;
    return Distance(point, a + Clamp(u, 0.0f, 1.0f) * along);
}

/// Of two segments that cross or touch: 0.
float DistanceOfSegments(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const auto areApart = [](Vec2 from, Vec2 to, Vec2 p, Vec2 q) {
        return Cross(to - from, p - from) * Cross(to - from, q - from) > 0.0f;
    };
    if (!areApart(a, b, c, d) && !areApart(c, d, a, b)) {
        const bool areParallel = Cross(b - a, d - c) == 0.0f;
        if (!areParallel) return 0.0f;
    }
    return Min(Min(DistanceToSegment(a, c, d), DistanceToSegment(b, c, d)),
               Min(DistanceToSegment(c, a, b), DistanceToSegment(d, a, b)));
}

}  // namespace

float Reach(const Shape& shape, Vec2 center) {
    float farthest = 0.0f;
    switch (shape.GetType()) {
        case Shape::e_circle:
            farthest = DistanceSquared(static_cast<const CircleShape&>(shape).m_p, center);
            break;
        case Shape::e_edge: {
            const auto& edge = static_cast<const EdgeShape&>(shape);
            farthest = Max(DistanceSquared(edge.m_vertex1, center), DistanceSquared(edge.m_vertex2, center));
            break;
        }
        case Shape::e_convex: {
            const auto& convex = static_cast<const ConvexShape&>(shape);
            for (int i = 0; i < convex.m_count; ++i) {
                farthest = Max(farthest, DistanceSquared(convex.m_vertices[i], center));
            }
            return std::sqrt(farthest) + convex.m_radius + convex.m_error;
        }
        default: {
            const auto& polygon = static_cast<const PolygonShape&>(shape);
            for (int i = 0; i < polygon.m_count; ++i) {
                farthest = Max(farthest, DistanceSquared(polygon.m_vertices[i], center));
            }
            break;
        }
    }
    return std::sqrt(farthest) + shape.m_radius;
}

bool WayIsClear(const Shape& shape, const Transform& xf, Vec2 from, Vec2 to, float radius) {
    const Vec2 a = MulT(xf, from);
    const Vec2 b = MulT(xf, to);
    const float least = radius + shape.m_radius + perSize * (LargerSize(a, b) + LargerSize(from, to) + SizeOf(shape));
    // LeastDistance proves no more than this does: what is kept of the neighbours of a body then changes no result.
    switch (shape.GetType()) {
        case Shape::e_circle:
            return DistanceToSegment(static_cast<const CircleShape&>(shape).m_p, a, b) > least;
        case Shape::e_polygon: {
            const auto& polygon = static_cast<const PolygonShape&>(shape);
            for (int i = 0; i < polygon.m_count; ++i) {
                const Vec2 n = polygon.m_normals[i];
                const float face = Dot(n, polygon.m_vertices[i]);
                if (Min(Dot(n, a), Dot(n, b)) - face > least) return true;
            }
            return false;
        }
        case Shape::e_edge: {
            const auto& edge = static_cast<const EdgeShape&>(shape);
            Vec2 n = edge.m_vertex2 - edge.m_vertex1;
            n = Vec2{n.y, -n.x};
            if (n.Normalize() == 0.0f) return false;
            const float line = Dot(n, edge.m_vertex1);
            const float sideA = Dot(n, a) - line;
            const float sideB = Dot(n, b) - line;
            if (Min(sideA, sideB) > least || Max(sideA, sideB) < -least) return true;
            return DistanceOfSegments(a, b, edge.m_vertex1, edge.m_vertex2) > least;
        }
        default:
            return false;
    }
}

float LeastDistance(const Shape& shape, const Transform& xf, Vec2 point) {
    const Vec2 p = MulT(xf, point);
    // Half as much again as where a way is clear, so that this proves no more.
    const float lost = shape.m_radius + 1.5f * perSize * (LargerSize(p, vec2Zero) + SizeOf(shape));
    switch (shape.GetType()) {
        case Shape::e_circle:
            return Distance(p, static_cast<const CircleShape&>(shape).m_p) - lost;
        case Shape::e_edge: {
            const auto& edge = static_cast<const EdgeShape&>(shape);
            return DistanceToSegment(p, edge.m_vertex1, edge.m_vertex2) - lost;
        }
        case Shape::e_polygon: {
            const auto& polygon = static_cast<const PolygonShape&>(shape);
            float farthest = Dot(polygon.m_normals[0], p - polygon.m_vertices[0]);
            for (int i = 1; i < polygon.m_count; ++i) {
                farthest = Max(farthest, Dot(polygon.m_normals[i], p - polygon.m_vertices[i]));
            }
            return farthest - lost;
        }
        default:
            return 0.0f;
    }
}

}  // namespace scree
