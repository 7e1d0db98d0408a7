// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The disk: point test, ray cast, box and mass. Shape and placement → the answer in world coordinates. Formulas: the
// quadratic of a ray against a circle; I = m(r²/2 + |p|²) by the parallel-axis theorem.

#include <cfloat>

#include "geometry/boxes.h"
#include "scree/shape.h"

namespace scree {

bool CircleShape::TestPoint(const Transform& xf, Vec2 p) const {
    const Vec2 center = xf.p + Mul(xf.q, m_p);
    return DistanceSquared(p, center) <= m_radius * m_radius;
}

bool CircleShape::RayCast(RayCastOutput* output, const RayCastInput& input, const Transform& xf) const {
    const Vec2 toStart = input.p1 - (xf.p + Mul(xf.q, m_p));
    const Vec2 ray = input.p2 - input.p1;
    // |toStart + t·ray|² = radius², solved for rr·t.
    const float outside = Dot(toStart, toStart) - m_radius * m_radius;
    const float approach = Dot(toStart, ray);
    const float rr = Dot(ray, ray);
    const float discriminant = approach * approach - rr * outside;
    if (discriminant < 0.0f || rr < FLT_EPSILON) return false;

    const float scaled = -(approach + std::sqrt(discriminant));
    // Written so that NaN misses; a start inside gives a negative first root.
    if (!(0.0f <= scaled && scaled <= input.maxFraction * rr)) return false;
    const float fraction = scaled / rr;
    output->fraction = fraction + 0.0f;  // never −0
    output->normal = toStart + fraction * ray;
    output->normal.Normalize();
    return true;
}

void CircleShape::ComputeAABB(AABB* aabb, const Transform& xf) const { *aabb = BoxOf(*this, xf); }

void CircleShape::ComputeMass(MassData* massData, float density) const {
    massData->mass = density * pi * m_radius * m_radius;
    massData->center = m_p;
    massData->I = massData->mass * (0.5f * m_radius * m_radius + Dot(m_p, m_p));
}

}  // namespace scree
