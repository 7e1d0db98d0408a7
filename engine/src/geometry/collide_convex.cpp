// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Two convex shapes of any kind → up to two contact points. Straight cores with up to four corners go through the
// vector kernel (collide_quads.h), with the same meaning. For others GJK on the straight cores gives the normal while
// they are apart, a separating axis test over all sides when they overlap. Then straight sides are clipped against each
// other (E. Catto, "Contact Manifolds", GDC 2007); corners touch as disks; arcs touch in one point, found by putting
// the circles that bend like them side by side. Manifold layout of Box2D 2.4, so the solver sees nothing new.

#include <cfloat>

#include "geometry/clip.h"
#include "geometry/collide_quads.h"
#include "geometry/convex_curve.h"
#include "geometry/distance.h"
#include "geometry/edge_seam.h"
#include "geometry/polygon_preference.h"

namespace scree {

namespace {

/// Below this distance of the cores the direction between them is mostly rounding.
constexpr float shallowest = convexPreference;
/// A side this close to the best axis is taken: two sides nearly in one plane would otherwise alternate.
constexpr float preference = convexPreference;
/// Rounds in which a touch of curves is refined.
constexpr int refinements = 4;

/// A core with its sides, in its body's coordinates.
struct Outline {
    const Vec2* vertices;
    const Vec2* normals;
    int count;
    float radius, error;
    const ConvexShape* convex;  ///< null: all sides straight
    bool oneSided;              ///< only side 0 exists
    Vec2 edgeNormals[2];
    DistanceProxy proxy;

    [[nodiscard]] bool IsCurved(int side) const { return convex != nullptr && convex->IsCurved(side); }
    [[nodiscard]] int Next(int i) const { return i + 1 < count ? i + 1 : 0; }
};

void MakeOutline(Outline& out, const Shape& shape) {
    out.proxy.Set(&shape, 0);
    out.vertices = out.proxy.m_vertices;
    out.count = out.proxy.m_count;
    out.radius = shape.m_radius;
    out.error = 0.0f;
    out.convex = nullptr;
    out.oneSided = false;
    out.normals = out.edgeNormals;
    switch (shape.GetType()) {
        case Shape::e_edge: {
            const auto& edge = static_cast<const EdgeShape&>(shape);
            out.edgeNormals[0] = Cross(edge.m_vertex2 - edge.m_vertex1, 1.0f);
            out.edgeNormals[0].Normalize();
            out.edgeNormals[1] = -out.edgeNormals[0];
            out.oneSided = edge.m_oneSided;
            break;
        }
        case Shape::e_polygon:
            out.normals = static_cast<const PolygonShape&>(shape).m_normals;
            break;
        case Shape::e_convex:
            out.convex = &static_cast<const ConvexShape&>(shape);
            out.normals = out.convex->m_normals;
            out.error = out.convex->m_error;
            break;
        default:
            break;
    }
}

/// One of the two shapes, placed.
struct Side {
    const Outline& outline;
    const Transform& xf;
    int face = -1;                ///< the side that looks at the other shape most, −1 for a point
    float separation = -FLT_MAX;  ///< of the other core's vertices from that side
};

/// How far `other` stays in front of a side.
float SeparationOf(const Side& side, int face, const Side& other, const Transform& toSide) {
    const Vec2 normal = side.outline.normals[face];
    const Vec2 local = MulT(toSide.q, normal);
    float nearest = FLT_MAX;
    for (int i = 0; i < other.outline.count; ++i) nearest = Min(nearest, Dot(local, other.outline.vertices[i]));
    return nearest + Dot(normal, toSide.p - side.outline.vertices[face]);
}

/// The side whose normal is closest to the world direction.
int FindFace(const Side& side, Vec2 direction) {
    const Outline& o = side.outline;
    if (o.count < 2) return -1;
    const Vec2 local = MulT(side.xf.q, direction);
    int best = 0;
    for (int i = 1; !o.oneSided && i < o.count; ++i) {
        if (Dot(o.normals[i], local) > Dot(o.normals[best], local)) best = i;
    }
    return best;
}

/// The side that separates most, when the cores overlap.
void FindDeepFace(Side& side, const Side& other) {
    const Transform toSide = MulT(side.xf, other.xf);
    const int faces = side.outline.count < 2 ? 0 : (side.outline.oneSided ? 1 : side.outline.count);
    for (int i = 0; i < faces; ++i) {
        const float separation = SeparationOf(side, i, other, toSide);
        if (separation > side.separation) {
            side.separation = separation;
            side.face = i;
        }
    }
}

/// The axis of least separation, and where it was found.
struct Axis {
    Vec2 normal;  ///< from A to B, world
    float separation;
    int vertexA, vertexB;  ///< a nearest pair of vertices
    bool isApart;          ///< the cores do not overlap
    bool isBetween;        ///< these two are the nearest points
};

Vec2 FaceNormal(const Side& side) { return Mul(side.xf.q, side.outline.normals[side.face]); }

int FarthestVertex(const Side& side, Vec2 direction) {
    return side.outline.proxy.GetSupport(MulT(side.xf.q, direction));
}

/// Fills the faces of both sides. False if the shapes are apart.
bool FindAxis(Side& a, Side& b, float reach, Axis& axis) {
    const PlacedCores placed = PlaceCores(a.outline.proxy, a.xf, b.outline.proxy, b.xf);
    SimplexCache cache;
    const Nearest nearest = FindNearest(placed.a, placed.b, placed.xfB, cache);
    if (!(nearest.distance <= reach)) return false;
    axis = {Mul(a.xf.q, nearest.normal), nearest.distance,        nearest.indexA[0],
            nearest.indexB[0],           nearest.distance > 0.0f, nearest.count == 1};
    const bool isPoints = a.outline.count == 1 && b.outline.count == 1;
    if (nearest.distance > shallowest || isPoints) {
        a.face = FindFace(a, axis.normal);
        b.face = FindFace(b, -axis.normal);
        if (a.face >= 0) a.separation = SeparationOf(a, a.face, b, MulT(a.xf, b.xf));
        if (b.face >= 0) b.separation = SeparationOf(b, b.face, a, MulT(b.xf, a.xf));
        return true;
    }
    FindDeepFace(a, b);
    FindDeepFace(b, a);
    const bool useB = a.face < 0 || b.separation > a.separation + preference;
    axis.separation = useB ? b.separation : a.separation;
    axis.normal = useB ? -FaceNormal(b) : FaceNormal(a);
    axis.vertexA = FarthestVertex(a, axis.normal);
    axis.vertexB = FarthestVertex(b, -axis.normal);
    return true;
}

CurvePoint Outermost(const Side& side, Vec2 direction) {
    const Vec2 local = MulT(side.xf.q, direction);
    const int vertex = side.outline.proxy.GetSupport(local);
    CurvePoint out{side.outline.vertices[vertex], 0.0f};
    if (side.outline.convex != nullptr) out = FindCurvePoint(*side.outline.convex, local, vertex);
    out.point = Mul(side.xf, out.point);
    return out;
}

void SetPoint(Manifold& manifold, Vec2 world, const Side& incident, uint32_t key) {
    ManifoldPoint& point = manifold.points[manifold.pointCount++];
    point.localPoint = MulT(incident.xf, world);
    point.id.key = key;
}

/// A straight side of one shape against the other. False if what lies over it does not come as near as `limit`.
bool TouchFace(Manifold& manifold, const Side& reference, const Side& incident, bool flipped, float limit) {
    const Outline& ref = reference.outline;
    const Outline& inc = incident.outline;
    const float radius = ref.radius + inc.radius;
    const int corner1 = reference.face, corner2 = ref.Next(corner1);
    const Vec2 normal = FaceNormal(reference);
    const Vec2 v1 = Mul(reference.xf, ref.vertices[corner1]);
    const Vec2 v2 = Mul(reference.xf, ref.vertices[corner2]);
    manifold.type = flipped ? Manifold::e_faceB : Manifold::e_faceA;
    manifold.localNormal = ref.normals[corner1];
    manifold.localPoint = 0.5f * (ref.vertices[corner1] + ref.vertices[corner2]);
    float nearest = FLT_MAX;
    const auto keep = [&](Vec2 p, uint32_t key) {
        const float separation = Dot(normal, p - v1);
        if (!(separation <= radius)) return;
        nearest = Min(nearest, separation);
        SetPoint(manifold, p, incident, flipped ? SwapContactKey(key) : key);
    };

    const int face = FindFace(incident, -normal);
    if (face < 0 || inc.IsCurved(face)) {
        keep(Outermost(incident, -normal).point,
             MakeContactKey(corner1, ContactFeature::e_face, curveFeature, ContactFeature::e_vertex));
        return nearest <= limit;
    }
    const int next = inc.Next(face);
    ClipSegment segment{{Mul(incident.xf, inc.vertices[face]),
                         MakeContactKey(corner1, ContactFeature::e_face, face, ContactFeature::e_vertex)},
                        {Mul(incident.xf, inc.vertices[next]),
                         MakeContactKey(corner1, ContactFeature::e_face, next, ContactFeature::e_vertex)}};
    Vec2 tangent = v2 - v1;
    tangent.Normalize();
    if (!ClipSegmentToLine(segment, -tangent, -Dot(tangent, v1), corner1)) return false;
    if (!ClipSegmentToLine(segment, tangent, Dot(tangent, v2), corner2)) return false;
    keep(segment.first.v, segment.first.key);
    keep(segment.second.v, segment.second.key);
    return nearest <= limit;
}

/// The nearest points of two cores that are apart.
void TouchNearest(Manifold& manifold, const Side& a, const Side& b, const Axis& axis, uint32_t key) {
    const PlacedCores placed = PlaceCores(a.outline.proxy, a.xf, b.outline.proxy, b.xf);
    SimplexCache cache;
    const Nearest nearest = FindNearest(placed.a, placed.b, placed.xfB, cache);
    const NearestPoints points = FindNearestPoints(placed.a, placed.b, placed.xfB, nearest);
    manifold.type = Manifold::e_faceA;
    manifold.localNormal = MulT(a.xf.q, axis.normal);
    manifold.localPoint = points.onA + placed.a.origin;
    SetPoint(manifold, Mul(a.xf, points.onB + placed.a.origin), b, key);
}

/// Of the corners that are about as far out along the normal those that are nearest to each other: sides that lie in
/// one line may meet end to end.
void TakeNearestTied(const Side& a, const Side& b, Vec2 normal, Vec2& onA, Vec2& onB) {
    const float mostA = Dot(normal, onA), leastB = Dot(normal, onB);
    float nearest = FLT_MAX;
    for (int i = 0; i < a.outline.count; ++i) {
        const Vec2 cornerA = Mul(a.xf, a.outline.vertices[i]);
        if (Dot(normal, cornerA) < mostA - preference) continue;
        for (int j = 0; j < b.outline.count; ++j) {
            const Vec2 cornerB = Mul(b.xf, b.outline.vertices[j]);
            const float away = DistanceSquared(cornerA, cornerB);
            if (Dot(normal, cornerB) > leastB + preference || away >= nearest) continue;
            nearest = away;
            onA = cornerA, onB = cornerB;
        }
    }
}

/// Corners and arcs: one point.
void TouchPoint(Manifold& manifold, const Side& a, const Side& b, const Axis& axis, bool isCorners) {
    Vec2 normal = axis.normal;
    CurvePoint onA = Outermost(a, normal), onB = Outermost(b, -normal);
    const uint32_t key = MakeContactKey(curveFeature, ContactFeature::e_vertex, curveFeature, ContactFeature::e_vertex);
    const bool isStraight = onA.bendRadius + onB.bendRadius == 0.0f;
    if (isStraight && axis.isApart) {
        if (!isCorners || !axis.isBetween) return TouchNearest(manifold, a, b, axis, key);
        manifold.type = Manifold::e_circles;
        manifold.localNormal.SetZero();
        manifold.localPoint = a.outline.vertices[axis.vertexA];
        SetPoint(manifold, Mul(b.xf, b.outline.vertices[axis.vertexB]), b,
                 MakeContactKey(axis.vertexA, ContactFeature::e_vertex, axis.vertexB, ContactFeature::e_vertex));
        return;
    }
    if (isStraight) TakeNearestTied(a, b, normal, onA.point, onB.point);
    // The core's normal is right to half the turn of one arc; exact for circles after one round, for others after few.
    // The separation along any direction is at most the distance, so the direction that separates most is the best.
    float separation = Dot(normal, onB.point - onA.point);
    Vec2 next = normal;
    for (int round = 0; round < refinements && onA.bendRadius + onB.bendRadius > 0.0f; ++round) {
        next = (onB.point + onB.bendRadius * next) - (onA.point - onA.bendRadius * next);
        if (next.Normalize() == 0.0f) break;
        const CurvePoint nextA = Outermost(a, next), nextB = Outermost(b, -next);
        const float nextSeparation = Dot(next, nextB.point - nextA.point);
        if (!(nextSeparation > separation)) break;
        normal = next;
        separation = nextSeparation;
        onA = nextA;
        onB = nextB;
    }
    if (!(separation <= a.outline.radius + b.outline.radius)) return;
    manifold.type = Manifold::e_faceA;
    manifold.localNormal = MulT(a.xf.q, normal);
    manifold.localPoint = MulT(a.xf, onA.point);
    SetPoint(manifold, onB.point, b, key);
}

/// Lets a one-sided edge refuse an axis that belongs to its neighbour, or bend it to its own normal. False: no contact.
bool ApplySeam(const EdgeShape& edge, Side& a, const Side& b, Axis& axis) {
    Vec2 along = edge.m_vertex2 - edge.m_vertex1;
    along.Normalize();
    const Vec2 local = MulT(a.xf.q, axis.normal);
    const Seam seam = JudgeSeam(edge, along, local);
    if (seam == Seam::drop) return false;
    if (seam == Seam::keep && Dot(local, a.outline.normals[0]) > 0.0f) return true;
    axis.normal = FaceNormal(a);
    axis.separation = a.separation = SeparationOf(a, 0, b, MulT(a.xf, b.xf));
    return true;
}

Vec2 CenterOf(const Outline& outline) {
    if (outline.convex != nullptr) return outline.convex->m_unitMass.center;
    Vec2 sum = vec2Zero;
    for (int i = 0; i < outline.count; ++i) sum += outline.vertices[i];
    return (1.0f / static_cast<float>(outline.count)) * sum;
}

}  // namespace

void CollideConvex(Manifold* manifold, const Shape* shapeA, const Transform& xfA, const Shape* shapeB,
                   const Transform& xfB) {
    if (const CorePair kinds(*shapeA, *shapeB); kinds.GoTogether()) {
        CoreBatch batch(kinds);
        batch.Add(0, *shapeA, xfA, *shapeB, xfB);
        batch.Collide();
        return batch.Write(0, *manifold);
    }
    manifold->pointCount = 0;
    Outline outlineA, outlineB;
    MakeOutline(outlineA, *shapeA);
    MakeOutline(outlineB, *shapeB);
    if (outlineA.oneSided) {
        const Vec2 center = MulT(xfA, Mul(xfB, CenterOf(outlineB)));
        if (Dot(outlineA.normals[0], center - outlineA.vertices[0]) < 0.0f) return;
    }
    Side a{outlineA, xfA}, b{outlineB, xfB};
    Axis axis;
    if (!FindAxis(a, b, outlineA.radius + outlineB.radius + outlineA.error + outlineB.error, axis)) return;
    if (outlineA.oneSided && !ApplySeam(*static_cast<const EdgeShape*>(shapeA), a, b, axis)) return;

    const float needed = axis.separation - preference, limit = axis.separation + preference;
    const bool useA = a.face >= 0 && !outlineA.IsCurved(a.face) && a.separation >= needed;
    const bool useB = b.face >= 0 && !outlineB.IsCurved(b.face) && b.separation >= needed;
    if (useA && TouchFace(*manifold, a, b, false, limit)) return;
    manifold->pointCount = 0;
    if (!useA && useB && TouchFace(*manifold, b, a, true, limit)) return;
    manifold->pointCount = 0;
    TouchPoint(*manifold, a, b, axis, !useA && !useB);
}

}  // namespace scree
