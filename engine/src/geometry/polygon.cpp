// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The convex polygon: construction, validation, point test, ray cast, box and mass. Points or half extents → vertices,
// normals, centroid; shape and placement → the answer in world coordinates. Sources: integrals over a fan of triangles
// (area, first and second moments); clipping of a ray by half planes (Cyrus and Beck, Computers & Graphics 3, 1978).

#include <cfloat>

#include "geometry/boxes.h"
#include "geometry/hull.h"
#include "geometry/moments.h"
#include "scree/shape.h"

namespace scree {
namespace {

bool IsPositive(float length) { return std::isfinite(length) && length > 0.0f; }

}  // namespace

bool PolygonShape::Set(const Vec2* points, int count) {
    if (points == nullptr || count < 3 || count > maxPolygonVertices) return false;
    for (int i = 0; i < count; ++i) {
        if (!points[i].IsValid()) return false;
    }
    PolygonShape made;
    made.m_radius = m_radius;
    made.m_count = ConvexHull(points, count, made.m_vertices);
    if (made.m_count == 0) return false;
    for (int i = 0; i < made.m_count; ++i) {
        const Vec2 side = made.m_vertices[i + 1 < made.m_count ? i + 1 : 0] - made.m_vertices[i];
        made.m_normals[i] = Cross(side, 1.0f);
        made.m_normals[i].Normalize();
    }
    const FanMoments moments = IntegrateFan(made.m_vertices, made.m_count);
    // Below float epsilon the division by the area loses the centroid; infinite coordinates differences end here too.
    if (!(moments.area > FLT_EPSILON) || !std::isfinite(moments.area)) return false;
    made.m_centroid = moments.center + made.m_vertices[0];
    if (!made.Validate()) return false;
    *this = made;
    return true;
}

void PolygonShape::SetAsBox(float hx, float hy) {
    if (!IsPositive(hx) || !IsPositive(hy)) return;
    m_count = 4;
    m_vertices[0] = {-hx, -hy};
    m_vertices[1] = {hx, -hy};
    m_vertices[2] = {hx, hy};
    m_vertices[3] = {-hx, hy};
    m_normals[0] = {0.0f, -1.0f};
    m_normals[1] = {1.0f, 0.0f};
    m_normals[2] = {0.0f, 1.0f};
    m_normals[3] = {-1.0f, 0.0f};
    m_centroid.SetZero();
}

void PolygonShape::SetAsBox(float hx, float hy, Vec2 center, float angle) {
    if (!IsPositive(hx) || !IsPositive(hy) || !center.IsValid() || !std::isfinite(angle)) return;
    SetAsBox(hx, hy);
    const Transform xf(center, Rot(angle));
    for (int i = 0; i < m_count; ++i) {
        m_vertices[i] = Mul(xf, m_vertices[i]);
        m_normals[i] = Mul(xf.q, m_normals[i]);
    }
    m_centroid = center;
}

bool PolygonShape::Validate() const {
    if (m_count < 3 || m_count > maxPolygonVertices || !m_centroid.IsValid()) return false;
    for (int i = 0; i < m_count; ++i) {
        if (!m_vertices[i].IsValid() || !m_normals[i].IsValid()) return false;
    }
    for (int i = 0; i < m_count; ++i) {
        const int next = i + 1 < m_count ? i + 1 : 0;
        const Vec2 side = m_vertices[next] - m_vertices[i];
        for (int j = 0; j < m_count; ++j) {
            if (j == i || j == next) continue;
            if (!(Cross(side, m_vertices[j] - m_vertices[i]) >= 0.0f)) return false;
        }
    }
    return true;
}

bool PolygonShape::TestPoint(const Transform& xf, Vec2 p) const {
    const Vec2 local = MulT(xf.q, p - xf.p);
    for (int i = 0; i < m_count; ++i) {
        if (!(Dot(m_normals[i], local - m_vertices[i]) <= 0.0f)) return false;
    }
    return m_count > 0;
}

bool PolygonShape::RayCast(RayCastOutput* output, const RayCastInput& input, const Transform& xf) const {
    const Vec2 start = MulT(xf.q, input.p1 - xf.p);
    const Vec2 end = MulT(xf.q, input.p2 - xf.p);
    const Vec2 ray = end - start;

    // The part of the ray inside all half planes seen so far is [enter, leave].
    float enter = 0.0f;
    float leave = input.maxFraction;
    int face = -1;
    for (int i = 0; i < m_count; ++i) {
        const float depth = Dot(m_normals[i], m_vertices[i] - start);
        const float slope = Dot(m_normals[i], ray);
        if (slope == 0.0f) {
            if (depth < 0.0f) return false;
        } else if (slope < 0.0f && depth < enter * slope) {  // depth/slope > enter, without the division
            enter = depth / slope;
            face = i;
        } else if (slope > 0.0f && depth < leave * slope) {
            leave = depth / slope;
        }
        if (leave < enter) return false;
    }
    if (face < 0) return false;
    output->fraction = enter;
    output->normal = Mul(xf.q, m_normals[face]);
    return true;
}

void PolygonShape::ComputeAABB(AABB* aabb, const Transform& xf) const { *aabb = BoxOf(*this, xf); }

void PolygonShape::ComputeMass(MassData* massData, float density) const {
    *massData = {};
    if (m_count < 3) return;
    const FanMoments moments = IntegrateFan(m_vertices, m_count);
    massData->mass = density * moments.area;
    massData->center = moments.center + m_vertices[0];
    // From the fan's apex to the centre of mass, and on to the body's origin (parallel axes, twice).
    massData->I = density * moments.secondMoment +
                  massData->mass * (Dot(massData->center, massData->center) - Dot(moments.center, moments.center));
}

}  // namespace scree
