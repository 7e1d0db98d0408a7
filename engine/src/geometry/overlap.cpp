// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Do two convex shapes overlap? GJK in 2D: "A Fast Procedure for Computing the Distance Between Complex Objects in
// Three-Dimensional Space" (Gilbert, Johnson, Keerthi 1988), on the Minkowski difference of the cores, with the two
// radii added up at the end.

#include <array>

#include "geometry/collide.h"

namespace scree {

namespace {

/// The core of a shape: a point, a segment or a polygon; its radius is apart.
struct Core {
    const Vec2* vertices;
    int count;
    Transform xf;
    std::array<Vec2, 2> storage;
};

void FillCore(const Shape& shape, const Transform& xf, Core& core) {
    core.xf = xf;
    core.vertices = core.storage.data();
    switch (shape.GetType()) {
        case Shape::e_circle:
            core.storage[0] = static_cast<const CircleShape&>(shape).m_p;
            core.count = 1;
            break;
        case Shape::e_edge:
            core.storage = {static_cast<const EdgeShape&>(shape).m_vertex1,
                            static_cast<const EdgeShape&>(shape).m_vertex2};
            core.count = 2;
            break;
        default:
            core.vertices = static_cast<const PolygonShape&>(shape).m_vertices;
            core.count = static_cast<const PolygonShape&>(shape).m_count;
            break;
    }
}

/// The world vertex farthest along `direction`.
Vec2 Support(const Core& core, Vec2 direction) {
    const Vec2 local = MulT(core.xf.q, direction);
    int best = 0;
    for (int i = 1; i < core.count; ++i) {
        if (Dot(core.vertices[i], local) > Dot(core.vertices[best], local)) best = i;
    }
    return Mul(core.xf, core.vertices[best]);
}

struct Simplex {
    Vec2 points[3];
    int count;
};

/// Keeps the part of the simplex nearest to the origin and returns that nearest point. A triangle that contains the
/// origin stays whole.
Vec2 NearestOnSegment(Simplex& s) {
    const Vec2 a = s.points[0], b = s.points[1];
    const Vec2 d = b - a;
    const float along = -Dot(a, d);
    if (along <= 0.0f) {
        s.count = 1;
        return a;
    }
    if (along >= Dot(d, d)) {
        s.points[0] = b;
        s.count = 1;
        return b;
    }
    return a + (along / Dot(d, d)) * d;
}

Vec2 NearestOnTriangle(Simplex& s) {
    const float area = Cross(s.points[1] - s.points[0], s.points[2] - s.points[0]);
    bool inside = area != 0.0f;
    for (int i = 0; i < 3 && inside; ++i) {
        const Vec2 a = s.points[i], b = s.points[(i + 1) % 3];
        inside = Cross(b - a, -a) * area >= 0.0f;
    }
    if (inside) return vec2Zero;
    Simplex best{};
    Vec2 nearest = vec2Zero;
    for (int i = 0; i < 3; ++i) {
        Simplex side{{s.points[i], s.points[(i + 1) % 3], vec2Zero}, 2};
        const Vec2 p = NearestOnSegment(side);
        if (i == 0 || p.LengthSquared() < nearest.LengthSquared()) {
            nearest = p;
            best = side;
        }
    }
    s = best;
    return nearest;
}

/// Squared distance of the cores; 0 when they overlap.
float CoreDistanceSquared(const Core& a, const Core& b) {
    Simplex simplex{{Mul(a.xf, a.vertices[0]) - Mul(b.xf, b.vertices[0]), vec2Zero, vec2Zero}, 1};
    Vec2 nearest = simplex.points[0];
    // Each round either ends or comes strictly nearer; polygons have at most 8 × 8 vertex pairs.
    for (int round = 0; round < maxPolygonVertices * maxPolygonVertices; ++round) {
        const float distanceSquared = nearest.LengthSquared();
        if (distanceSquared == 0.0f) return 0.0f;
        const Vec2 next = Support(a, -nearest) - Support(b, nearest);
        // No vertex lies nearer along −nearest: the distance is found (relative to float rounding).
        if (distanceSquared - Dot(next, nearest) <= 1e-6f * distanceSquared) return distanceSquared;
        simplex.points[simplex.count++] = next;
        const Vec2 candidate = simplex.count == 2 ? NearestOnSegment(simplex) : NearestOnTriangle(simplex);
        if (candidate.LengthSquared() >= distanceSquared) return distanceSquared;
        nearest = candidate;
    }
    return nearest.LengthSquared();
}

}  // namespace

bool TestOverlap(const Shape& shapeA, const Transform& xfA, const Shape& shapeB, const Transform& xfB) {
    Core a, b;
    FillCore(shapeA, xfA, a);
    FillCore(shapeB, xfB, b);
    const float radius = shapeA.m_radius + shapeB.m_radius;
    return CoreDistanceSquared(a, b) <= radius * radius;
}

}  // namespace scree
