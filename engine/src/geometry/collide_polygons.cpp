// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Two convex polygons → up to two contact points. Separating axis test over the faces of both, then the most opposed
// face of the other polygon is clipped against the reference face (E. Catto, "Computing Distance", GDC 2010; E. Catto,
// "Contact Manifolds", GDC 2007). Choices and rounding follow Box2D 2.4, so manifolds agree bit for bit; the search
// differs: it tests four faces at a time against each vertex of the other polygon.

#include <cfloat>

#include "geometry/clip.h"
#include "geometry/lanes.h"
#include "scree/collision.h"

namespace scree {
namespace {

/// The face of one polygon along which the other lies farthest outside (or least deep inside).
struct FaceQuery {
    int face;
    float separation;
};

/// The largest of four, the first of several.
FaceQuery Largest(Float4 values) {
    const FaceQuery low = values[1] > values[0] ? FaceQuery{1, values[1]} : FaceQuery{0, values[0]};
    const FaceQuery high = values[3] > values[2] ? FaceQuery{3, values[3]} : FaceQuery{2, values[2]};
    return high.separation > low.separation ? high : low;
}

/// How deep the deepest of the vertices lies behind each of four faces (negative: behind).
Float4 DeepestVertex(const PolygonShape& polygon, Vec2x4 faceNormals, Vec2x4 faceCorners) {
    Float4 deepest = Splat(FLT_MAX);
    for (int first = 0; first < polygon.m_count; first += 4) {
        // Vertex 0 in the lanes beyond the count changes no minimum.
        const int used = polygon.m_count - first;
        const Vec2x4 v = FillFrom(LoadVec2x4(polygon.m_vertices + first), used, polygon.m_vertices[0]);
        const Float4 d0 = Dot(faceNormals, Lane<0>(v) - faceCorners);
        const Float4 d1 = Dot(faceNormals, Lane<1>(v) - faceCorners);
        const Float4 d2 = Dot(faceNormals, Lane<2>(v) - faceCorners);
        const Float4 d3 = Dot(faceNormals, Lane<3>(v) - faceCorners);
        deepest = Min(deepest, Min(Min(d0, d1), Min(d2, d3)));
    }
    return deepest;
}

/// `toOther` maps the polygon's frame to the other's.
FaceQuery FindMaxSeparation(const PolygonShape& polygon, const PolygonShape& other, const Transform& toOther) {
    FaceQuery best{0, -FLT_MAX};
    for (int first = 0; first < polygon.m_count; first += 4) {
        const Vec2x4 normals = Mul(toOther.q, LoadVec2x4(polygon.m_normals + first));
        const Vec2x4 corners = Mul(toOther, LoadVec2x4(polygon.m_vertices + first));
        const Float4 separations = DeepestVertex(other, normals, corners);
        const FaceQuery found = Largest(FillFrom(separations, polygon.m_count - first, -FLT_MAX));
        if (found.separation > best.separation) best = {first + found.face, found.separation};
    }
    return best;
}

/// A polygon, its placement and, for the reference one, the face in question.
struct Side {
    const PolygonShape& polygon;
    const Transform& xf;
    int face;
};

int NextVertex(const PolygonShape& polygon, int i) { return i + 1 < polygon.m_count ? i + 1 : 0; }

/// The incident face: the one whose normal opposes the reference normal most, in world coordinates.
void FindIncidentFace(ClipVertex segment[2], const Side& reference, const Side& incident) {
    const Vec2 normal = MulT(incident.xf.q, Mul(reference.xf.q, reference.polygon.m_normals[reference.face]));
    int best = 0;
    float smallest = FLT_MAX;
    for (int i = 0; i < incident.polygon.m_count; ++i) {
        const float d = Dot(normal, incident.polygon.m_normals[i]);
        if (d < smallest) {
            smallest = d;
            best = i;
        }
    }
    const int next = NextVertex(incident.polygon, best);
    segment[0] = {Mul(incident.xf, incident.polygon.m_vertices[best]),
                  MakeContactID(reference.face, ContactFeature::e_face, best, ContactFeature::e_vertex)};
    segment[1] = {Mul(incident.xf, incident.polygon.m_vertices[next]),
                  MakeContactID(reference.face, ContactFeature::e_face, next, ContactFeature::e_vertex)};
}

/// Clips the incident face against the reference face and keeps what lies within `radius` of it.
void ClipFaces(Manifold* manifold, const Side& reference, const Side& incident, float radius) {
    ClipVertex segment[2];
    FindIncidentFace(segment, reference, incident);

    const int corner1 = reference.face;
    const int corner2 = NextVertex(reference.polygon, corner1);
    const Vec2 local1 = reference.polygon.m_vertices[corner1];
    const Vec2 local2 = reference.polygon.m_vertices[corner2];
    Vec2 localTangent = local2 - local1;
    localTangent.Normalize();
    const Vec2 tangent = Mul(reference.xf.q, localTangent);
    const Vec2 normal = Cross(tangent, 1.0f);
    const Vec2 v1 = Mul(reference.xf, local1);
    const Vec2 v2 = Mul(reference.xf, local2);

    // The side planes are moved out by the skin: rounded corners also touch beyond the face's ends.
    if (!ClipSegmentToLine(segment, -tangent, -Dot(tangent, v1) + radius, corner1)) return;
    if (!ClipSegmentToLine(segment, tangent, Dot(tangent, v2) + radius, corner2)) return;

    manifold->localNormal = Cross(localTangent, 1.0f);
    manifold->localPoint = 0.5f * (local1 + local2);
    const float frontOffset = Dot(normal, v1);
    const bool flipped = manifold->type == Manifold::e_faceB;
    int count = 0;
    for (const ClipVertex& end : segment) {
        if (!(Dot(normal, end.v) - frontOffset <= radius)) continue;
        ManifoldPoint& point = manifold->points[count++];
        point.localPoint = MulT(incident.xf, end.v);
        point.id = flipped ? SwapContactID(end.id) : end.id;
    }
    manifold->pointCount = static_cast<int8_t>(count);
}

}  // namespace

void CollidePolygons(Manifold* manifold, const PolygonShape* polygonA, const Transform& xfA,
                     const PolygonShape* polygonB, const Transform& xfB) {
    manifold->pointCount = 0;
    const float radius = polygonA->m_radius + polygonB->m_radius;
    const FaceQuery a = FindMaxSeparation(*polygonA, *polygonB, MulT(xfB, xfA));
    if (a.separation > radius) return;
    const FaceQuery b = FindMaxSeparation(*polygonB, *polygonA, MulT(xfA, xfB));
    if (b.separation > radius) return;

    // A needs to be clearly worse to lose: two faces nearly in one plane would otherwise alternate as the reference.
    constexpr float preference = 0.1f * linearSlop;
    const Side sideA{*polygonA, xfA, a.face};
    const Side sideB{*polygonB, xfB, b.face};
    if (b.separation > a.separation + preference) {
        manifold->type = Manifold::e_faceB;
        ClipFaces(manifold, sideB, sideA, radius);
    } else {
        manifold->type = Manifold::e_faceA;
        ClipFaces(manifold, sideA, sideB, radius);
    }
}

}  // namespace scree
