// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One face, the extents of the mover along it, an axis from an end of it, and what is left of them after way and turn.

#include "geometry/passage.h"

#include <algorithm>
#include <limits>
#include <span>

#include "base/index.h"
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
    float size;  ///< of the shape's largest coordinates: a search looks at all of them
};

float SizeOf(Vec2 a) { return Abs(a.x) + Abs(a.y); }

/// From `b` to `a`, which follow each other counter-clockwise.
Face FaceBetween(Vec2 a, Vec2 b, Vec2 normal, bool isAll) {
    const Vec2 along{normal.y, -normal.x};
    return {b, along, normal, Dot(along, a - b), isAll, Max(SizeOf(a), SizeOf(b))};
}

Face NearestFace(const Vec2* vertices, const Vec2* normals, int count, Vec2 from) {
    int best = 0;
    float farthest = Dot(normals[0], from - vertices[0]), size = SizeOf(vertices[0]);
    for (int i = 1; i < count; ++i) {
        const float distance = Dot(normals[i], from - vertices[i]);
        if (distance > farthest) farthest = distance, best = i;
        size = Max(size, SizeOf(vertices[i]));
    }
    Face face = FaceBetween(vertices[best], vertices[best + 1 < count ? best + 1 : 0], normals[best], false);
    face.size = size;
    return face;
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

/// What follows from the points.
void Measure(Extents& e) {
    const FacePoint(&points)[maxConvexVertices] = e.points;
    int lowest = 0;
    const int count = e.count;
    for (int i = 1; i < count; ++i) {
        if (points[i].height < points[lowest].height) lowest = i;
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
}

/// The end of a motion along a face taken back to its start.
struct Return {
    FacePoint centre;  ///< about which the mover turns, at the end
    float along, up;   ///< the way
    Rot turn;          ///< back
    [[nodiscard]] FacePoint operator()(FacePoint p) const {
        const float x = p.place - centre.place, y = p.height - centre.height;
        return {centre.height - up + (turn.s * x + turn.c * y), centre.place - along + (turn.c * x - turn.s * y)};
    }
};

/// Rotation by −`angle`; of small ones by the series, which rounding covers.
Rot TurnBack(float angle) {
    if (Abs(angle) > 0.25f) return Rot(-angle);
    const float square = angle * angle;
    Rot turn;
    turn.s = -angle * (1.0f - square * (1.0f / 6.0f) * (1.0f - square * (1.0f / 20.0f)));
    turn.c = 1.0f - 0.5f * square * (1.0f - square * (1.0f / 12.0f) * (1.0f - square * (1.0f / 30.0f)));
    return turn;
}

/// A mover at both ends of its way.
struct Ends {
    Extents start, end;
};

void MeasureEnds(const DistanceProxy& proxy, const Transform& toFace, Vec2 centre, const Return& back, Ends& ends) {
    const int count = ends.start.count = ends.end.count = std::min(proxy.m_count, maxConvexVertices);
    for (int i = 0; i < count; ++i) {
        const Vec2 p = Mul(toFace, proxy.m_vertices[i]);
        ends.end.points[i] = {p.y, p.x};
        ends.start.points[i] = back(ends.end.points[i]);
        ends.end.reachSquared = Max(ends.end.reachSquared, DistanceSquared(proxy.m_vertices[i], centre));
    }
    Measure(ends.end), Measure(ends.start);
}

/// An upper bound of the distance from a face to the lower side of a core.
float MostDistance(const Extents& e, float length) {
    const auto outside = [&](float from, float to) { return Max(0.0f, Max(from - length, -to)); };
    const float a = e.low.place, b = e.beside.place;
    const float atVertex = Abs(e.low.height) + outside(a, a);
    const float atSide = Max(Abs(e.low.height), Abs(e.beside.height)) + outside(Min(a, b), Max(a, b));
    return Min(atVertex, atSide);
}

/// The bound of one axis: the gap at the end, and the least of it on the way.
struct Gap {
    float end = -std::numeric_limits<float>::max(), least = end;
    void Try(float atEnd, float atStart) {
        end = Max(end, atEnd);
        least = Max(least, Min(atEnd, atStart));
    }
};

/// How far some points lie beyond a segment along an axis.
float GapAlong(Vec2 axis, std::span<const FacePoint> points, float length) {
    float lowest = std::numeric_limits<float>::max();
    for (const FacePoint& p : points) lowest = Min(lowest, axis.x * p.place + axis.y * p.height);
    return lowest - Max(0.0f, axis.x * length);
}

/// Points of a mover at both ends of its way.
struct Points {
    std::span<const FacePoint> start, end;
};
void TryAxis(Vec2 axis, const Points& points, float length, Gap& gap) {
    gap.Try(GapAlong(axis, points.end, length), GapAlong(axis, points.start, length));
}

/// The axis from the nearer end of a face that is all of its shape to the nearest of some points beyond that end.
void TryFromEnd(const Points& points, float length, Gap& gap) {
    const auto isBeyond = [&](float place) { return place > length || place < 0.0f; };
    const FacePoint* nearest = nullptr;
    float least = std::numeric_limits<float>::max(), end = 0.0f;
    for (const FacePoint& p : points.end) {
        const float from = p.place < 0.0f ? 0.0f : length, x = p.place - from;
        const float squared = x * x + p.height * p.height;
        if (squared < least && isBeyond(p.place)) nearest = &p, least = squared, end = from;
    }
    if (nearest == nullptr) return;
    Vec2 axis{nearest->place - end, nearest->height};
    axis.Normalize();
    TryAxis(axis, points, length, gap);
}

/// Outward normals of a core's sides, in its own coordinates; vertex i begins side i. Empty: there are none.
std::span<const Vec2> SideNormals(const Shape& shape) {
    if (shape.GetType() == Shape::e_polygon) {
        const auto& polygon = static_cast<const PolygonShape&>(shape);
        return {polygon.m_normals, static_cast<size_t>(polygon.m_count)};
    }
    if (shape.GetType() == Shape::e_convex) {
        const auto& convex = static_cast<const ConvexShape&>(shape);
        if (convex.m_count >= 3) return {convex.m_normals, static_cast<size_t>(convex.m_count)};
    }
    return {};
}

/// The side of a core that a segment is least behind of.
struct Side {
    float gap = -std::numeric_limits<float>::max();  ///< signed distance of the segment along the normal
    int index = 0;
    Vec2 normal{0.0f, 1.0f};
    void Try(float candidate, int at, Vec2 n) {
        if (candidate > gap) gap = candidate, index = at, normal = n;
    }
};

/// That side of a core.
Side FindSide(const Extents& e, std::span<const Vec2> normals, const Rot& turn, float length) {
    Side side;
    for (int i = 0; i < e.count; ++i) {
        const Vec2 n = Mul(turn, normals[static_cast<size_t>(i)]);
        side.Try(Min(0.0f, n.x * length) - (n.x * e.points[i].place + n.y * e.points[i].height), i, n);
    }
    return side;
}

/// An upper bound of the distance of a core from a segment; below 0 they overlap by so much.
float MostBySide(const Extents& e, const Side& side, float length) {
    const float deepest = Max(side.gap, Max(e.lowest, -e.highest));
    if (deepest <= 0.0f) return deepest;  // no side of either parts them
    const auto placeOn = [&](float place, float height) { return side.normal.x * height - side.normal.y * place; };
    const auto placeOf = [&](int i) { return placeOn(e.points[i].place, e.points[i].height); };
    const float begin = placeOf(side.index), end = placeOf(side.index + 1 < e.count ? side.index + 1 : 0);
    const float at = placeOn(side.normal.x < 0.0f ? length : 0.0f, 0.0f);
    return Abs(side.gap) + Max(0.0f, Max(begin - at, at - end));
}

/// A disk against a segment by the axis from the nearest point of the segment: what most wheels and balls need.
/// Nothing unless it is sure of the cores.
bool BoundDisk(const EdgeShape& edge, Vec2 point, Vec2 way, float byTurn, float near, Clearance& clearance) {
    const Vec2 along = edge.m_vertex2 - edge.m_vertex1;
    const float lengthSquared = Dot(along, along);
    const float share = lengthSquared > 0.0f ? Dot(point - edge.m_vertex1, along) / lengthSquared : 0.0f;
    const Vec2 apart = point - (edge.m_vertex1 + Clamp(share, 0.0f, 1.0f) * along);
    const float distance = apart.Length();
    // The distance before the way, times that after it.
    const float before = distance * distance - Dot(apart, way);
    if (!(distance - byTurn >= near && before >= (near + byTurn) * distance)) return false;
    clearance.slack = distance - near;
    clearance.isSure = true;
    return true;
}

}  // namespace

Vec2 MiddleOf(const Shape& shape) {
    if (shape.GetType() == Shape::e_circle) return static_cast<const CircleShape&>(shape).m_p;
    MassData mass;
    shape.ComputeMass(&mass, 1.0f);
    return mass.center;
}

float MiddlePartOf(const Shape& shape) {
    constexpr float part = 0.25f;
    const Vec2* vertices = nullptr;
    int count = 0;
    if (shape.GetType() == Shape::e_polygon) {
        const auto& polygon = static_cast<const PolygonShape&>(shape);
        vertices = polygon.m_vertices, count = polygon.m_count;
    } else if (shape.GetType() == Shape::e_convex) {
        const auto& convex = static_cast<const ConvexShape&>(shape);
        vertices = convex.m_vertices, count = convex.m_count;
    }
    if (count < 3) return 0.0f;
    if (count % 2 != 0) return part;
    // Opposite vertices have one middle.
    const int half = count / 2;
    const Vec2 twice = vertices[0] + vertices[half];
    const float most = 1e-6f * DistanceSquared(vertices[0], vertices[half]);
    for (int i = 1; i < half; ++i) {
        if (DistanceSquared(vertices[i] + vertices[i + half], twice) > most) return part;
    }
    return 0.0f;
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
    const Transform local = MulT(p.stillPlace, p.moverPlace);
    const Vec2 way = MulT(p.stillPlace.q, p.way);
    const float tolerance = toiTolerance * lengthScale;
    /// `size` of the still shape.
    const auto marginOf = [&](float size, float reach) {
        const Vec2 far = Abs(local.p) + 0.5f * (Abs(p.stillPlace.p) + Abs(p.moverPlace.p));
        return 0.1f * tolerance + rounding * (far.x + far.y + size + reach);
    };
    Clearance clearance;
    if (p.mover.GetType() == Shape::e_circle && p.still.GetType() == Shape::e_edge && watched != Watched::middle) {
        const auto& edge = static_cast<const EdgeShape&>(p.still);
        const Vec2 point = static_cast<const CircleShape&>(p.mover).m_p;
        const float reach = point == p.centre ? 0.0f : Distance(point, p.centre);
        const float margin = marginOf(SizeOf(edge.m_vertex1) + SizeOf(edge.m_vertex2), reach + p.mover.m_radius);
        const float near = TOITarget(p.still.m_radius + p.mover.m_radius, lengthScale) + tolerance + margin;
        clearance.reach = reach;
        if (BoundDisk(edge, Mul(local, point), way, Abs(p.turn) * reach, near, clearance)) return clearance;
        clearance = {};
    }
    DistanceProxy proxy;
    proxy.Set(&p.mover, 0);
    const Face face = FindFace(p.still, Mul(local, p.centre));
    if (proxy.m_count < 1 || (face.normal.x == 0.0f && face.normal.y == 0.0f)) return clearance;

    // Along the face and above it instead of x and y.
    Rot turned;
    turned.s = -face.along.y, turned.c = face.along.x;
    const Vec2 shift = local.p - face.origin;
    const Transform toFace{{Dot(face.along, shift), Dot(face.normal, shift)}, Mul(turned, local.q)};
    const Vec2 pivot = Mul(toFace, p.centre);
    const Return back{{pivot.y, pivot.x}, Dot(face.along, way), Dot(face.normal, way), TurnBack(p.turn)};
    Ends ends;
    MeasureEnds(proxy, toFace, p.centre, back, ends);
    const Extents &start = ends.start, &end = ends.end;
    clearance.reach = std::sqrt(end.reachSquared);
    // What a point's height on its turning way may fall below those at both ends.
    const auto sagOf = [&](float reach) { return reach * (Abs(p.turn) < pi ? 0.125f * p.turn * p.turn : 2.0f); };
    const float margin = marginOf(face.size, clearance.reach);
    const auto needed = [&](float radii) { return TOITarget(radii, lengthScale) + tolerance + margin; };
    const float radius = p.still.m_radius, near = needed(radius + p.mover.m_radius), sag = sagOf(clearance.reach);

    Side sideAtStart, sideAtEnd;
    bool hasSides = false;
    if (watched != Watched::middle) {
        Gap gap;
        gap.Try(end.lowest, start.lowest);
        if (face.isAll) {
            gap.Try(-end.highest, -start.highest);
            gap.Try(end.first - face.length, start.first - face.length);
            gap.Try(-end.last, -start.last);
            const Points points{std::span(start.points, ToSize(start.count)), std::span(end.points, ToSize(end.count))};
            const std::span<const Vec2> normals = SideNormals(p.mover);
            hasSides = gap.least - sag < near && !normals.empty() && normals.size() == points.end.size();
            if (hasSides) {
                sideAtStart = FindSide(start, normals, Mul(back.turn, toFace.q), face.length);
                sideAtEnd = FindSide(end, normals, toFace.q, face.length);
                TryAxis(-sideAtStart.normal, points, face.length, gap);
                TryAxis(-sideAtEnd.normal, points, face.length, gap);
            }
            // Along a chain most segments lie beside the mover: their ends are nearest to it.
            if (gap.least - sag < near) TryFromEnd(points, face.length, gap);
        }
        clearance.slack = gap.end - near;
        clearance.isSure = gap.least - sag >= near;
        if (watched == Watched::cores || clearance.isSure) return clearance;
    }

    const Vec2 middle = MiddleOf(p.mover), atFace = Mul(toFace, middle);
    const FacePoint middleAtEnd{atFace.y, atFace.x}, middleAtStart = back(middleAtEnd);
    const float part = MiddlePartOf(p.mover), fromCentre = Distance(middle, p.centre);
    // No vertex of the part is farther from the centre than this.
    const float middleSag = sagOf(fromCentre + part * (clearance.reach + fromCentre));
    const auto shrunk = [&](float of, float outer) { return of + part * (outer - of); };
    Gap gap;
    gap.Try(shrunk(middleAtEnd.height, end.lowest), shrunk(middleAtStart.height, start.lowest));
    if (face.isAll) gap.Try(-shrunk(middleAtEnd.height, end.highest), -shrunk(middleAtStart.height, start.highest));
    if (face.isAll && part == 0.0f && gap.least - middleSag < needed(radius)) {
        TryFromEnd({std::span(&middleAtStart, 1), std::span(&middleAtEnd, 1)}, face.length, gap);
    }
    const bool passes = clearance.middlePasses = gap.least - middleSag >= needed(radius);
    if (watched == Watched::middle) {
        clearance.isSure = passes;
        return clearance;
    }
    // Cores that begin surely within the target, as the search sees it, are held by their contact.
    const float within = near - 2.0f * margin;
    const auto mostOf = [&](const Extents& e, const Side& side) {
        const float most = MostDistance(e, face.length);
        return hasSides ? Min(most, MostBySide(e, side, face.length)) : most;
    };
    clearance.isSure = passes && mostOf(start, sideAtStart) < within;
    const float held = Min(within - mostOf(end, sideAtEnd), gap.end - needed(radius));
    clearance.slack = Max(clearance.slack, held);
    return clearance;
}

}  // namespace scree
