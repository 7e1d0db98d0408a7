// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Two convex polygons → up to two contact points. Separating axis test over the faces of both, then the most opposed
// face of the other polygon is clipped against the reference face (E. Catto, "Contact Manifolds", GDC 2007). Choices
// and rounding follow Box2D 2.4, so manifolds agree bit for bit. The search differs: it tests four faces at a time
// against each vertex of the other polygon, without a branch.

#include <cfloat>

#include "geometry/clip.h"
#include "geometry/polygon_preference.h"
#include "geometry/vectors4.h"
#include "scree/collision.h"

namespace scree {
namespace {

/// The face of one polygon along which the other lies farthest outside (or least deep inside).
struct FaceQuery {
    int face;
    float separation;
};

/// Vertices and normals, four to a register. Lanes beyond the vertex count repeat vertex 0, which changes no minimum
/// over vertices and, as the first of equals wins, no choice of a face.
template <int Chunks>
struct PolygonLanes {
    Vector4 vertices[Chunks];
    Vector4 normals[Chunks];
};

template <int Chunks>
SCREE_INLINE PolygonLanes<Chunks> LoadLanes(const PolygonShape& polygon) {
    PolygonLanes<Chunks> out;
    for (int k = 0; k < Chunks; ++k) {
        out.vertices[k] = LoadVectors4(&polygon.m_vertices[4 * k].x);
        out.normals[k] = LoadVectors4(&polygon.m_normals[4 * k].x);
    }
    const int used = polygon.m_count - 4 * (Chunks - 1);
    if (used < 4) {
        out.vertices[Chunks - 1] = FirstLanes4(used, out.vertices[Chunks - 1], SplatVector4(polygon.m_vertices[0]));
        out.normals[Chunks - 1] = FirstLanes4(used, out.normals[Chunks - 1], SplatVector4(polygon.m_normals[0]));
    }
    return out;
}

/// The largest of four, the first of several.
SCREE_INLINE FaceQuery Largest(F4 lanes) {
    const float values[] = {GetLane4<0>(lanes), GetLane4<1>(lanes), GetLane4<2>(lanes), GetLane4<3>(lanes)};
    const FaceQuery low = values[1] > values[0] ? FaceQuery{1, values[1]} : FaceQuery{0, values[0]};
    const FaceQuery high = values[3] > values[2] ? FaceQuery{3, values[3]} : FaceQuery{2, values[2]};
    return high.separation > low.separation ? high : low;
}

/// The vertices' signed distances from four faces, the smallest for each face.
SCREE_INLINE F4 DeepestVertex(Vector4 vertices, Vector4 faceNormals, Vector4 faceCorners) {
    const F4 d0 = Dot4(faceNormals, SplatLane4<0>(vertices) - faceCorners);
    const F4 d1 = Dot4(faceNormals, SplatLane4<1>(vertices) - faceCorners);
    const F4 d2 = Dot4(faceNormals, SplatLane4<2>(vertices) - faceCorners);
    const F4 d3 = Dot4(faceNormals, SplatLane4<3>(vertices) - faceCorners);
    return Min4(Min4(d0, d1), Min4(d2, d3));
}

/// `toOther` maps the polygon's frame to the other's.
template <int Chunks, int OtherChunks>
SCREE_INLINE FaceQuery FindMaxSeparation(const PolygonLanes<Chunks>& polygon, const PolygonLanes<OtherChunks>& other,
                                         const Transform& toOther) {
    const Placement4 placement = SplatPlacement4(toOther);
    FaceQuery best{0, -FLT_MAX};
    for (int k = 0; k < Chunks; ++k) {
        const Vector4 normals = Mul4(placement.q, polygon.normals[k]);
        const Vector4 corners = Mul4(placement, polygon.vertices[k]);
        F4 deepest = DeepestVertex(other.vertices[0], normals, corners);
        if constexpr (OtherChunks > 1) deepest = Min4(deepest, DeepestVertex(other.vertices[1], normals, corners));
        const FaceQuery found = Largest(deepest);
        if (found.separation > best.separation) best = {4 * k + found.face, found.separation};
    }
    return best;
}

/// Both polygons' best faces; b is not computed, and `apart` true, if A's face already separates them.
struct AxisSearch {
    FaceQuery a, b;
    bool apart;
};

template <int ChunksA, int ChunksB>
AxisSearch SearchAxes(const PolygonShape& polygonA, const Transform& xfA, const PolygonShape& polygonB,
                      const Transform& xfB) {
    const PolygonLanes<ChunksA> lanesA = LoadLanes<ChunksA>(polygonA);
    const PolygonLanes<ChunksB> lanesB = LoadLanes<ChunksB>(polygonB);
    const float radius = polygonA.m_radius + polygonB.m_radius;
    AxisSearch out{{}, {}, true};
    out.a = FindMaxSeparation(lanesA, lanesB, MulT(xfB, xfA));
    if (out.a.separation > radius) return out;
    out.b = FindMaxSeparation(lanesB, lanesA, MulT(xfA, xfB));
    out.apart = out.b.separation > radius;
    return out;
}

AxisSearch SearchAxes(const PolygonShape& polygonA, const Transform& xfA, const PolygonShape& polygonB,
                      const Transform& xfB) {
    if (polygonA.m_count <= 4) {
        return polygonB.m_count <= 4 ? SearchAxes<1, 1>(polygonA, xfA, polygonB, xfB)
                                     : SearchAxes<1, 2>(polygonA, xfA, polygonB, xfB);
    }
    return polygonB.m_count <= 4 ? SearchAxes<2, 1>(polygonA, xfA, polygonB, xfB)
                                 : SearchAxes<2, 2>(polygonA, xfA, polygonB, xfB);
}

/// A polygon, its placement and, for the reference one, the face in question.
struct Side {
    const PolygonShape& polygon;
    const Transform& xf;
    int face;
};

int NextVertex(const PolygonShape& polygon, int i) { return i + 1 < polygon.m_count ? i + 1 : 0; }

/// The incident face: the one whose normal opposes the reference normal most, in world coordinates.
ClipSegment FindIncidentFace(const Side& reference, const Side& incident) {
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
    return {{Mul(incident.xf, incident.polygon.m_vertices[best]),
             MakeContactKey(reference.face, ContactFeature::e_face, best, ContactFeature::e_vertex)},
            {Mul(incident.xf, incident.polygon.m_vertices[next]),
             MakeContactKey(reference.face, ContactFeature::e_face, next, ContactFeature::e_vertex)}};
}

/// Clips the incident face against the reference face and keeps what lies within `radius` of it.
void ClipFaces(Manifold* manifold, const Side& reference, const Side& incident, float radius) {
    ClipSegment segment = FindIncidentFace(reference, incident);

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
    const auto keep = [&](const ClipVertex& end) {
        if (!(Dot(normal, end.v) - frontOffset <= radius)) return;
        ManifoldPoint& point = manifold->points[manifold->pointCount++];
        point.localPoint = MulT(incident.xf, end.v);
        point.id.key = flipped ? SwapContactKey(end.key) : end.key;
    };
    keep(segment.first);
    keep(segment.second);
}

}  // namespace

void CollidePolygons(Manifold* manifold, const PolygonShape* polygonA, const Transform& xfA,
                     const PolygonShape* polygonB, const Transform& xfB) {
    manifold->pointCount = 0;
    const float radius = polygonA->m_radius + polygonB->m_radius;
    const AxisSearch search = SearchAxes(*polygonA, xfA, *polygonB, xfB);
    if (search.apart) return;

    const float preference = ReferencePreference(radius);
    const Side sideA{*polygonA, xfA, search.a.face};
    const Side sideB{*polygonB, xfB, search.b.face};
    const bool flipped = search.b.separation > search.a.separation + preference;
    manifold->type = flipped ? Manifold::e_faceB : Manifold::e_faceA;
    ClipFaces(manifold, flipped ? sideB : sideA, flipped ? sideA : sideB, radius);
}

}  // namespace scree
