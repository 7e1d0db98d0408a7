// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One face, the extents of the mover along it, an axis from an end of it, and what is left of them after way and turn.

#include "geometry/passage.h"

#include <algorithm>
#include <limits>
#include <span>

#include "scree/convex_shape.h"
#include "scree/time_of_impact.h"

namespace scree {

namespace {

/// What the bound and the search may miss by rounding, a share of the coordinates: four roundings.
constexpr float rounding = 2.5e-7f;

/// A segment on the outline of the still core: the shape itself, seen from the mover's side, or the face that the mover
/// is most in front of.
struct Face {
    Vec2 origin, along, normal;  ///< the normal lies to the left
    float length;
    bool isAll;  ///< nothing of the shape lies elsewhere
};

/// From `b` to `a`, which follow each other counter-clockwise.
Face FaceBetween(Vec2 a, Vec2 b, Vec2 normal, bool isAll) {
    const Vec2 along{normal.y, -normal.x};
    return {b, along, normal, Dot(along, a - b), isAll};
}

Face NearestFace(const Vec2* vertices, const Vec2* normals, int count, Vec2 from) {
    int best = 0;
    float farthest = Dot(normals[0], from - vertices[0]);
    for (int i = 1; i < count; ++i) {
        const float distance = Dot(normals[i], from - vertices[i]);
        if (distance > farthest) farthest = distance, best = i;
    }
    return FaceBetween(vertices[best], vertices[best + 1 < count ? best + 1 : 0], normals[best], false);
}

/// `from` in the coordinates of the shape. A normal of length 0: there is no face.
Face FindFace(const Shape& shape, Vec2 from) {
    switch (shape.GetType()) {
        case Shape::e_edge: {
            const auto& edge = static_cast<const EdgeShape&>(shape);
            const Vec2 along = edge.m_vertex2 - edge.m_vertex1;
            Vec2 normal{along.y, -along.x};
            normal.Normalize();
            if (Dot(normal, from - edge.m_vertex1) >= 0.0f) {
                return FaceBetween(edge.m_vertex1, edge.m_vertex2, normal, true);
            }
            return FaceBetween(edge.m_vertex2, edge.m_vertex1, -normal, true);
        }
        case Shape::e_polygon: {
            const auto& polygon = static_cast<const PolygonShape&>(shape);
            return NearestFace(polygon.m_vertices, polygon.m_normals, polygon.m_count, from);
        }
        case Shape::e_convex: {
            const auto& convex = static_cast<const ConvexShape&>(shape);
            if (convex.m_count >= 2) {
                return NearestFace(convex.m_vertices, convex.m_normals, convex.m_count, from);
            }
            return FaceBetween(convex.m_vertices[0], convex.m_vertices[0], {0.0f, 1.0f}, true);
        }
        default: {
            const Vec2 point = static_cast<const CircleShape&>(shape).m_p;
            Vec2 normal = from - point;
            normal.Normalize();
            return FaceBetween(point, point, normal, true);
        }
    }
}

/// Height above the face and place along it.
struct FacePoint {
    float height, place;
};

/// A core as it lies along a face.
struct Extents {
    float lowest, highest, first, last;
    FacePoint low, beside;  ///< the lowest vertex, and the lower one of its neighbours
    float reachSquared = 0.0f;
    int count;
    FacePoint points[maxConvexVertices];
};

Extents Measure(const DistanceProxy& proxy, const Transform& toFace, Vec2 centre) {
    Extents e;
    FacePoint(&points)[maxConvexVertices] = e.points;
    int lowest = 0;
    const int count = e.count = std::min(proxy.m_count, maxConvexVertices);
    for (int i = 0; i < count; ++i) {
        const Vec2 p = Mul(toFace, proxy.m_vertices[i]);
        points[i] = {p.y, p.x};
        e.reachSquared = Max(e.reachSquared, DistanceSquared(proxy.m_vertices[i], centre));
        if (p.y < points[lowest].height) lowest = i;
    }
    e.lowest = points[lowest].height;
    e.highest = e.lowest;
    e.first = e.last = points[lowest].place;
    for (int i = 0; i < count; ++i) {
        e.highest = Max(e.highest, points[i].height);
        e.first = Min(e.first, points[i].place);
        e.last = Max(e.last, points[i].place);
    }
    const FacePoint& next = points[lowest + 1 < count ? lowest + 1 : 0];
    const FacePoint& previous = points[lowest > 0 ? lowest - 1 : count - 1];
    e.low = points[lowest];
    e.beside = next.height < previous.height ? next : previous;
    return e;
}

/// An upper bound of the distance from a face to the lower side of a core after a shift by `x`, `y`.
float MostDistance(const Extents& e, float length, float x, float y) {
    const auto outside = [&](float from, float to) { return Max(0.0f, Max(from - length, -to)); };
    const float a = e.low.place + x, b = e.beside.place + x;
    const float atVertex = Abs(e.low.height + y) + outside(a, a);
    const float atSide = Max(Abs(e.low.height + y), Abs(e.beside.height + y)) + outside(Min(a, b), Max(a, b));
    return Min(atVertex, atSide);
}

/// The bound of one axis: the gap at the end, and the least of it on the way.
struct Gap {
    float end = -std::numeric_limits<float>::max(), least = end;
    void Try(float gap, float approach) {
        end = Max(end, gap);
        least = Max(least, Min(gap, gap + approach));
    }
};

/// The axis from the nearer end of a face that is all of its shape to the nearest of some points beyond that end.
void TryFromEnd(std::span<const FacePoint> points, float length, float along, float up, Gap& gap) {
    const auto isBeyond = [&](float place) { return place > length || place < 0.0f; };
    const FacePoint* nearest = nullptr;
    float least = std::numeric_limits<float>::max(), end = 0.0f;
    for (const FacePoint& p : points) {
        const float from = p.place < 0.0f ? 0.0f : length, x = p.place - from;
        const float squared = x * x + p.height * p.height;
        if (squared < least && isBeyond(p.place)) nearest = &p, least = squared, end = from;
    }
    if (nearest == nullptr) return;
    Vec2 axis{nearest->place - end, nearest->height};
    axis.Normalize();
    float lowest = std::numeric_limits<float>::max();
    for (const FacePoint& p : points) lowest = Min(lowest, axis.x * p.place + axis.y * p.height);
    gap.Try(lowest - Max(0.0f, axis.x * length), -(axis.x * along + axis.y * up));
}

}  // namespace

Vec2 MiddleOf(const Shape& shape) {
    if (shape.GetType() == Shape::e_circle) return static_cast<const CircleShape&>(shape).m_p;
    MassData mass;
    shape.ComputeMass(&mass, 1.0f);
    return mass.center;
}

float DepthOfMiddle(const Shape& shape) {
    const Vec2 middle = MiddleOf(shape);
    const auto least = [&](const Vec2* vertices, const Vec2* normals, int count) {
        float depth = std::numeric_limits<float>::max();
        for (int i = 0; i < count; ++i) depth = Min(depth, Dot(normals[i], vertices[i] - middle));
        return Max(depth, 0.0f);
    };
    switch (shape.GetType()) {
        case Shape::e_circle:
            return shape.m_radius;
        case Shape::e_polygon: {
            const auto& polygon = static_cast<const PolygonShape&>(shape);
            return least(polygon.m_vertices, polygon.m_normals, polygon.m_count);
        }
        case Shape::e_convex: {
            const auto& convex = static_cast<const ConvexShape&>(shape);
            if (convex.m_count < 3) return convex.m_radius;
            return least(convex.m_vertices, convex.m_normals, convex.m_count) + convex.m_radius;
        }
        default:
            return 0.0f;
    }
}

Clearance BoundClearance(const Passage& p, Watched watched, float lengthScale) {
    DistanceProxy proxy;
    proxy.Set(&p.mover, 0);
    const Transform local = MulT(p.stillPlace, p.moverPlace);
    const Vec2 centre = Mul(local, p.centre);
    const Face face = FindFace(p.still, centre);
    Clearance clearance;
    if (proxy.m_count < 1 || (face.normal.x == 0.0f && face.normal.y == 0.0f)) return clearance;

    // Along the face and above it instead of x and y.
    Rot turned;
    turned.s = -face.along.y, turned.c = face.along.x;
    const Vec2 shift = local.p - face.origin;
    const Transform toFace{{Dot(face.along, shift), Dot(face.normal, shift)}, Mul(turned, local.q)};
    const Vec2 way = MulT(p.stillPlace.q, p.way);
    const float along = Dot(face.along, way), up = Dot(face.normal, way);
    const Extents e = Measure(proxy, toFace, p.centre);
    clearance.reach = std::sqrt(e.reachSquared);
    const float byTurn = p.turn * clearance.reach;

    const float tolerance = toiTolerance * lengthScale;
    const Vec2 far = Abs(local.p) + Abs(face.origin) + 0.5f * (Abs(p.stillPlace.p) + Abs(p.moverPlace.p));
    const float margin = 0.1f * tolerance + rounding * (far.x + far.y + clearance.reach);
    const auto needed = [&](float radii) { return TOITarget(radii, lengthScale) + tolerance + margin; };
    const float radius = p.still.m_radius, near = needed(radius + p.mover.m_radius);

    if (watched != Watched::middle) {
        Gap gap;
        gap.Try(e.lowest, -up);
        if (face.isAll) {
            gap.Try(-e.highest, up);
            gap.Try(e.first - face.length, -along);
            gap.Try(-e.last, along);
            // Along a chain most segments lie beside the mover: their ends are nearest to it.
            if (gap.least - byTurn < near)
                TryFromEnd(std::span(e.points, static_cast<size_t>(e.count)), face.length, along, up, gap);
        }
        clearance.slack = gap.end - near;
        clearance.isSure = gap.least - byTurn >= near;
        if (watched == Watched::cores || clearance.isSure) return clearance;
    }

    const Vec2 middle = Mul(toFace, MiddleOf(p.mover));
    Gap gap;
    gap.Try(middle.y, -up);
    if (face.isAll) gap.Try(-middle.y, up);
    if (face.isAll && gap.least - byTurn < needed(radius)) {
        const FacePoint point{middle.y, middle.x};
        TryFromEnd(std::span(&point, 1), face.length, along, up, gap);
    }
    const bool passes = clearance.middlePasses = gap.least - byTurn >= needed(radius);
    if (watched == Watched::middle) {
        clearance.isSure = passes;
        return clearance;
    }
    // Cores that begin surely within the target, as the search sees it, are held by their contact.
    const float within = near - 2.0f * margin;
    clearance.isSure = passes && MostDistance(e, face.length, -along, -up) + byTurn < within;
    const float held = Min(within - MostDistance(e, face.length, 0.0f, 0.0f), gap.end - needed(radius));
    clearance.slack = Max(clearance.slack, held);
    return clearance;
}

}  // namespace scree
