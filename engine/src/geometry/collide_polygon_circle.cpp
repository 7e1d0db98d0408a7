// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A polygon A and a disk B → at most one contact point, on the face nearest to the disk's centre or on one of that
// face's corners. Voronoi regions of the face as in Box2D 2.4, whose manifold it reproduces bit for bit.

#include <cfloat>

#include "scree/collision.h"

namespace scree {
namespace {

void SetPoint(Manifold* manifold, Vec2 localNormal, Vec2 localPoint, Vec2 centerB) {
    manifold->type = Manifold::e_faceA;
    manifold->localNormal = localNormal;
    manifold->localPoint = localPoint;
    manifold->pointCount = 1;
    manifold->points[0].localPoint = centerB;
    manifold->points[0].id.key = 0;
}

void CollideCorner(Manifold* manifold, Vec2 corner, Vec2 center, float radius, Vec2 centerB) {
    if (!(DistanceSquared(center, corner) <= radius * radius)) return;
    Vec2 normal = center - corner;
    normal.Normalize();
    SetPoint(manifold, normal, corner, centerB);
}

}  // namespace

void CollidePolygonAndCircle(Manifold* manifold, const PolygonShape* polygonA, const Transform& xfA,
                             const CircleShape* circleB, const Transform& xfB) {
    manifold->pointCount = 0;
    const Vec2 center = MulT(xfA, Mul(xfB, circleB->m_p));  // in A
    const float radius = polygonA->m_radius + circleB->m_radius;
    const int count = polygonA->m_count;

    int face = 0;
    float separation = -FLT_MAX;
    for (int i = 0; i < count; ++i) {
        const float s = Dot(polygonA->m_normals[i], center - polygonA->m_vertices[i]);
        if (!(s <= radius)) return;
        if (s > separation) {
            separation = s;
            face = i;
        }
    }

    const Vec2 v1 = polygonA->m_vertices[face];
    const Vec2 v2 = polygonA->m_vertices[face + 1 < count ? face + 1 : 0];
    const Vec2 normal = polygonA->m_normals[face];
    const Vec2 faceCenter = 0.5f * (v1 + v2);
    if (separation < FLT_EPSILON) {  // centre inside: corners do not matter
        SetPoint(manifold, normal, faceCenter, circleB->m_p);
    } else if (Dot(center - v1, v2 - v1) <= 0.0f) {
        CollideCorner(manifold, v1, center, radius, circleB->m_p);
    } else if (Dot(center - v2, v1 - v2) <= 0.0f) {
        CollideCorner(manifold, v2, center, radius, circleB->m_p);
    } else if (Dot(center - faceCenter, normal) <= radius) {
        SetPoint(manifold, normal, faceCenter, circleB->m_p);
    }
}

}  // namespace scree
