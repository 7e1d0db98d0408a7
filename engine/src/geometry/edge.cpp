// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The line segment: setters, ray cast and box. Shape and placement → the answer in world coordinates. An edge is
// massless and has no inside. Box2D 2.4's rule: a ray that comes from behind passes through a one-sided edge.

#include "scree/shape.h"

namespace scree {

void EdgeShape::SetOneSided(Vec2 v0, Vec2 v1, Vec2 v2, Vec2 v3) {
    m_vertex0 = v0;
    m_vertex1 = v1;
    m_vertex2 = v2;
    m_vertex3 = v3;
    m_oneSided = true;
}

void EdgeShape::SetTwoSided(Vec2 v1, Vec2 v2) {
    m_vertex1 = v1;
    m_vertex2 = v2;
    m_oneSided = false;
}

bool EdgeShape::TestPoint(const Transform&, Vec2) const { return false; }

bool EdgeShape::RayCast(RayCastOutput* output, const RayCastInput& input, const Transform& xf) const {
    const Vec2 p1 = MulT(xf.q, input.p1 - xf.p);
    const Vec2 p2 = MulT(xf.q, input.p2 - xf.p);
    const Vec2 ray = p2 - p1;
    const Vec2 along = m_vertex2 - m_vertex1;
    Vec2 normal{along.y, -along.x};  // to the right of v1 → v2
    normal.Normalize();

    // p1 + t·ray lies on the line where dot(normal, v1 − p1 − t·ray) = 0.
    const float behind = Dot(normal, m_vertex1 - p1);
    if (m_oneSided && behind > 0.0f) return false;
    const float slope = Dot(normal, ray);
    if (slope == 0.0f) return false;
    const float t = behind / slope;
    if (!(0.0f <= t && t <= input.maxFraction)) return false;

    const float lengthSquared = Dot(along, along);
    if (lengthSquared == 0.0f) return false;
    const float s = Dot((p1 + t * ray) - m_vertex1, along) / lengthSquared;
    if (!(0.0f <= s && s <= 1.0f)) return false;

    output->fraction = t + 0.0f;  // never −0
    output->normal = behind > 0.0f ? -Mul(xf.q, normal) : Mul(xf.q, normal);
    return true;
}

void EdgeShape::ComputeAABB(AABB* aabb, const Transform& xf) const {
    const Vec2 v1 = Mul(xf, m_vertex1);
    const Vec2 v2 = Mul(xf, m_vertex2);
    const Vec2 skin{m_radius, m_radius};
    aabb->lowerBound = Min(v1, v2) - skin;
    aabb->upperBound = Max(v1, v2) + skin;
}

void EdgeShape::ComputeMass(MassData* massData, float) const {
    massData->mass = 0.0f;
    massData->center = 0.5f * (m_vertex1 + m_vertex2);
    massData->I = 0.0f;
}

}  // namespace scree
