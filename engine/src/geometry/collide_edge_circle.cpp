// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// An edge A and a disk B → at most one contact point, by the Voronoi region of the segment that holds the disk's
// centre. On one-sided edges the corner regions belong to the neighbour if the centre projects onto it (ghost vertices,
// as in Box2D 2.4).

#include "geometry/clip.h"
#include "scree/collision.h"

namespace scree {
namespace {

void CollideCorner(Manifold* manifold, Vec2 corner, int cornerIndex, Vec2 centerB) {
    manifold->type = Manifold::e_circles;
    manifold->localNormal.SetZero();
    manifold->localPoint = corner;
    manifold->pointCount = 1;
    manifold->points[0].localPoint = centerB;
    manifold->points[0].id.key = MakeContactKey(cornerIndex, ContactFeature::e_vertex, 0, ContactFeature::e_vertex);
}

}  // namespace

void CollideEdgeAndCircle(Manifold* manifold, const EdgeShape* edgeA, const Transform& xfA, const CircleShape* circleB,
                          const Transform& xfB) {
    manifold->pointCount = 0;
    const Vec2 center = MulT(xfA, Mul(xfB, circleB->m_p));  // in A
    const Vec2 v1 = edgeA->m_vertex1;
    const Vec2 v2 = edgeA->m_vertex2;
    const Vec2 along = v2 - v1;
    Vec2 normal{along.y, -along.x};  // to the right of v1 → v2
    const float side = Dot(normal, center - v1);
    const bool oneSided = edgeA->m_oneSided;
    if (oneSided && side < 0.0f) return;

    const float toEnd = Dot(along, v2 - center);
    const float fromStart = Dot(along, center - v1);
    const float radius = edgeA->m_radius + circleB->m_radius;
    const float radiusSquared = radius * radius;

    if (fromStart <= 0.0f) {
        if (!(DistanceSquared(center, v1) <= radiusSquared)) return;
        if (oneSided && Dot(v1 - edgeA->m_vertex0, v1 - center) > 0.0f) return;
        CollideCorner(manifold, v1, 0, circleB->m_p);
        return;
    }
    if (toEnd <= 0.0f) {
        if (!(DistanceSquared(center, v2) <= radiusSquared)) return;
        if (oneSided && Dot(edgeA->m_vertex3 - v2, center - v2) > 0.0f) return;
        CollideCorner(manifold, v2, 1, circleB->m_p);
        return;
    }

    const Vec2 nearest = (1.0f / Dot(along, along)) * (toEnd * v1 + fromStart * v2);
    if (!(DistanceSquared(center, nearest) <= radiusSquared)) return;
    if (side < 0.0f) normal = -normal;
    normal.Normalize();
    manifold->type = Manifold::e_faceA;
    manifold->localNormal = normal;
    manifold->localPoint = v1;
    manifold->pointCount = 1;
    manifold->points[0].localPoint = circleB->m_p;
    manifold->points[0].id.key = MakeContactKey(0, ContactFeature::e_face, 0, ContactFeature::e_vertex);
}

}  // namespace scree
