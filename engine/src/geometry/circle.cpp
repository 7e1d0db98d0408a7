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

namespace {

/// |toStart + t·ray|² = radius², solved for rr·t in numbers of that type.
template <typename Real>
bool HitDisk(Vec2 toStart, Vec2 ray, float radius, float maxFraction, RayCastOutput* output) {
    const auto dot = [](Vec2 a, Vec2 b) { return Real{a.x} * b.x + Real{a.y} * b.y; };
    const Real outside = dot(toStart, toStart) - Real{radius} * radius;
    const Real approach = dot(toStart, ray);
    const Real rr = dot(ray, ray);
    const Real discriminant = approach * approach - rr * outside;
    if (discriminant < Real{0} || !(rr > Real{0})) return false;

    const Real scaled = -(approach + std::sqrt(discriminant));
    // Written so that NaN misses; a start inside gives a negative first root.
    if (!(Real{0} <= scaled && scaled <= maxFraction * rr)) return false;
    const Real fraction = scaled / rr;
    output->fraction = static_cast<float>(fraction) + 0.0f;  // never −0
    output->normal = {static_cast<float>(toStart.x + fraction * ray.x),
                      static_cast<float>(toStart.y + fraction * ray.y)};
    output->normal.Normalize();
    return true;
}

}  // namespace

bool CircleShape::RayCast(RayCastOutput* output, const RayCastInput& input, const Transform& xf) const {
    // So many radii away a rounding of the square of the way is a thousandth of that of the radius, and from some
    // thousand on all of it. Box2D has no short rays. What is left gets its bits.
    constexpr float farRadii = 100.0f;
    const Vec2 toStart = input.p1 - (xf.p + Mul(xf.q, m_p));
    const Vec2 ray = input.p2 - input.p1;
    const float far = farRadii * m_radius;
    const bool isPlain = Dot(toStart, toStart) <= far * far && Dot(ray, ray) >= FLT_EPSILON;
    return isPlain ? HitDisk<float>(toStart, ray, m_radius, input.maxFraction, output)
                   : HitDisk<double>(toStart, ray, m_radius, input.maxFraction, output);
}

void CircleShape::ComputeAABB(AABB* aabb, const Transform& xf) const { *aabb = BoxOf(*this, xf); }

void CircleShape::ComputeMass(MassData* massData, float density) const {
    massData->mass = density * pi * m_radius * m_radius;
    massData->center = m_p;
    massData->I = massData->mass * (0.5f * m_radius * m_radius + Dot(m_p, m_p));
}

}  // namespace scree
