// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// An edge A and a polygon B → up to two contact points. Separating axis test over the edge's two sides and the
// polygon's faces in A's frame, ghost vertices to drop or bend normals at the seams of one-sided edges (E. Catto,
// "Ghost Collisions", box2d.org, June 2020), then clipping. Choices and rounding follow Box2D 2.4.

#include <cfloat>
#include <initializer_list>

#include "geometry/clip.h"
#include "geometry/edge_seam.h"
#include "geometry/polygon_preference.h"
#include "scree/collision.h"

namespace scree {
namespace {

/// The polygon in the edge's frame.
struct LocalPolygon {
    Vec2 vertices[maxPolygonVertices];
    Vec2 normals[maxPolygonVertices];
    int count;
};

LocalPolygon ToEdgeFrame(const PolygonShape& polygon, const Transform& xf) {
    LocalPolygon out;
    out.count = polygon.m_count;
    for (int i = 0; i < out.count; ++i) {
        out.vertices[i] = Mul(xf, polygon.m_vertices[i]);
        out.normals[i] = Mul(xf.q, polygon.m_normals[i]);
    }
    return out;
}

/// A direction from the edge to the polygon and the gap along it.
struct Axis {
    Vec2 normal;
    float separation;
    int face;  ///< face of the polygon, −1 for the edge's own normal
};

Axis FindEdgeAxis(const LocalPolygon& polygon, Vec2 v1, Vec2 edgeNormal) {
    Axis best{{0.0f, 0.0f}, -FLT_MAX, -1};
    for (const Vec2 normal : {edgeNormal, -edgeNormal}) {
        float deepest = FLT_MAX;
        for (int i = 0; i < polygon.count; ++i) deepest = Min(Dot(normal, polygon.vertices[i] - v1), deepest);
        if (deepest > best.separation) {
            best.normal = normal;
            best.separation = deepest;
        }
    }
    return best;
}

Axis FindPolygonAxis(const LocalPolygon& polygon, Vec2 v1, Vec2 v2) {
    Axis best{{0.0f, 0.0f}, -FLT_MAX, 0};
    for (int i = 0; i < polygon.count; ++i) {
        const Vec2 normal = -polygon.normals[i];
        const float s = Min(Dot(normal, polygon.vertices[i] - v1), Dot(normal, polygon.vertices[i] - v2));
        if (s > best.separation) best = {normal, s, i};
    }
    return best;
}

/// The face that is clipped against, with its two side planes given by `tangent` (from v1 to v2).
struct ReferenceFace {
    Vec2 v1, v2, normal, tangent;
    int corner1, corner2;
};

/// Clips the incident face at both ends of the reference face; the ends here carry no skin, so that neighbouring edges
/// of a chain do not both claim a contact.
bool ClipToFace(ClipSegment& segment, const ReferenceFace& face) {
    const Vec2 backwards = -face.tangent;
    return ClipSegmentToLine(segment, backwards, Dot(backwards, face.v1), face.corner1) &&
           ClipSegmentToLine(segment, face.tangent, Dot(face.tangent, face.v2), face.corner2);
}

void ClipAgainstEdge(Manifold* manifold, const ReferenceFace& face, const LocalPolygon& polygon, const Transform& xf,
                     float radius) {
    manifold->type = Manifold::e_faceA;
    int incident = 0;
    float smallest = Dot(face.normal, polygon.normals[0]);
    for (int i = 1; i < polygon.count; ++i) {
        const float d = Dot(face.normal, polygon.normals[i]);
        if (d < smallest) {
            smallest = d;
            incident = i;
        }
    }
    const int next = incident + 1 < polygon.count ? incident + 1 : 0;
    ClipSegment segment{
        {polygon.vertices[incident], MakeContactKey(0, ContactFeature::e_face, incident, ContactFeature::e_vertex)},
        {polygon.vertices[next], MakeContactKey(0, ContactFeature::e_face, next, ContactFeature::e_vertex)}};
    if (!ClipToFace(segment, face)) return;

    manifold->localNormal = face.normal;
    manifold->localPoint = face.v1;
    const auto keep = [&](const ClipVertex& end) {
        if (!(Dot(face.normal, end.v - face.v1) <= radius)) return;
        ManifoldPoint& point = manifold->points[manifold->pointCount++];
        point.localPoint = MulT(xf, end.v);
        point.id.key = end.key;
    };
    keep(segment.first);
    keep(segment.second);
}

void ClipAgainstPolygon(Manifold* manifold, const EdgeShape& edge, const LocalPolygon& local,
                        const PolygonShape& polygon, int faceIndex) {
    manifold->type = Manifold::e_faceB;
    ReferenceFace face;
    face.corner1 = faceIndex;
    face.corner2 = faceIndex + 1 < local.count ? faceIndex + 1 : 0;
    face.v1 = local.vertices[face.corner1];
    face.v2 = local.vertices[face.corner2];
    face.normal = local.normals[faceIndex];
    face.tangent = {-face.normal.y, face.normal.x};
    ClipSegment segment{
        {edge.m_vertex2, MakeContactKey(1, ContactFeature::e_vertex, faceIndex, ContactFeature::e_face)},
        {edge.m_vertex1, MakeContactKey(0, ContactFeature::e_vertex, faceIndex, ContactFeature::e_face)}};
    if (!ClipToFace(segment, face)) return;

    manifold->localNormal = polygon.m_normals[faceIndex];
    manifold->localPoint = polygon.m_vertices[faceIndex];
    const float radius = polygon.m_radius + edge.m_radius;
    const auto keep = [&](const ClipVertex& end) {
        if (!(Dot(face.normal, end.v - face.v1) <= radius)) return;
        ManifoldPoint& point = manifold->points[manifold->pointCount++];
        point.localPoint = end.v;
        point.id.key = SwapContactKey(end.key);
    };
    keep(segment.first);
    keep(segment.second);
}

}  // namespace

void CollideEdgeAndPolygon(Manifold* manifold, const EdgeShape* edgeA, const Transform& xfA,
                           const PolygonShape* polygonB, const Transform& xfB) {
    manifold->pointCount = 0;
    const Transform xf = MulT(xfA, xfB);
    const Vec2 v1 = edgeA->m_vertex1;
    const Vec2 v2 = edgeA->m_vertex2;
    Vec2 along = v2 - v1;
    along.Normalize();
    const Vec2 edgeNormal{along.y, -along.x};  // to the right of v1 → v2
    if (edgeA->m_oneSided && Dot(edgeNormal, Mul(xf, polygonB->m_centroid) - v1) < 0.0f) return;

    const LocalPolygon polygon = ToEdgeFrame(*polygonB, xf);
    const float radius = polygonB->m_radius + edgeA->m_radius;
    const Axis edgeAxis = FindEdgeAxis(polygon, v1, edgeNormal);
    if (edgeAxis.separation > radius) return;
    const Axis polygonAxis = FindPolygonAxis(polygon, v1, v2);
    if (polygonAxis.separation > radius) return;

    // Like CollidePolygons' preference for A, but relative as well: deep overlaps jitter more.
    constexpr float relativePreference = 0.98f;
    const float absolutePreference = 2.0f * ReferencePreference(radius);
    Axis axis = edgeAxis;
    if (polygonAxis.separation - radius > relativePreference * (edgeAxis.separation - radius) + absolutePreference) {
        axis = polygonAxis;
    }
    if (edgeA->m_oneSided) {
        const Seam seam = JudgeSeam(*edgeA, along, axis.normal);
        if (seam == Seam::drop) return;
        if (seam == Seam::useEdgeNormal) axis = edgeAxis;
    }
    if (axis.face < 0) {
        ClipAgainstEdge(manifold, {v1, v2, axis.normal, along, 0, 1}, polygon, xf, radius);
    } else {
        ClipAgainstPolygon(manifold, *edgeA, polygon, *polygonB, axis.face);
    }
}

}  // namespace scree
