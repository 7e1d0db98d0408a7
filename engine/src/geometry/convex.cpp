// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The general convex shape: validation, support, point test, ray cast, box and mass. Shape and placement → the answer
// in world coordinates. Where the outline is a polygon, rays are clipped by half planes (Cyrus and Beck, Computers &
// Graphics 3, 1978). A rounded outline is the union of its sides, moved out, and of disks at its vertices.

#include "geometry/convex_curve.h"

namespace scree {

namespace {

int FarthestVertex(const ConvexShape& shape, Vec2 direction) {
    int best = 0;
    for (int i = 1; i < shape.m_count; ++i) {
        if (Dot(shape.m_vertices[i], direction) > Dot(shape.m_vertices[best], direction)) best = i;
    }
    return best;
}

int Next(const ConvexShape& shape, int i) { return i + 1 < shape.m_count ? i + 1 : 0; }

bool IsInsideCore(const ConvexShape& shape, Vec2 local) {
    if (shape.m_count < 3) return false;
    for (int i = 0; i < shape.m_count; ++i) {
        if (!(Dot(shape.m_normals[i], local - shape.m_vertices[i]) <= 0.0f)) return false;
    }
    return true;
}

float SegmentDistanceSquared(Vec2 p, Vec2 a, Vec2 b) {
    const Vec2 along = b - a;
    const float length = along.LengthSquared();
    const float t = length > 0.0f ? Clamp(Dot(p - a, along) / length, 0.0f, 1.0f) : 0.0f;
    return DistanceSquared(p, a + t * along);
}

bool IsInside(const ConvexShape& shape, Vec2 local) {
    if (IsInsideCore(shape, local)) return true;
    const float squared = shape.m_solidRadius * shape.m_solidRadius;
    for (int i = 0; squared > 0.0f && i < shape.m_count; ++i) {
        if (SegmentDistanceSquared(local, shape.m_vertices[i], shape.m_vertices[Next(shape, i)]) <= squared)
            return true;
    }
    return false;
}

/// Where a ray crosses a side, moved out by the solid radius, from outside.
void HitSide(const ConvexShape& shape, int side, const RayCastInput& ray, RayCastOutput& best) {
    const Vec2 normal = shape.m_normals[side];
    const Vec2 v1 = shape.m_vertices[side] + shape.m_solidRadius * normal;
    const Vec2 v2 = shape.m_vertices[Next(shape, side)] + shape.m_solidRadius * normal;
    const Vec2 path = ray.p2 - ray.p1;
    const float slope = Dot(normal, path);
    if (!(slope < 0.0f)) return;
    const float fraction = Dot(normal, v1 - ray.p1) / slope;
    if (!(0.0f <= fraction && fraction <= best.fraction)) return;
    const float along = Dot(ray.p1 + fraction * path - v1, v2 - v1);
    if (0.0f <= along && along <= DistanceSquared(v1, v2)) best = {normal, fraction};
}

}  // namespace

bool ConvexShape::Validate() const {
    if (m_count < 1 || m_count > maxConvexVertices || !std::isfinite(m_unitMass.I)) return false;
    for (int i = 0; i < m_count; ++i) {
        if (!m_vertices[i].IsValid() || !m_normals[i].IsValid() || !m_controls[i].IsValid()) return false;
    }
    for (int i = 0; m_count > 1 && i < m_count; ++i) {
        const Vec2 side = m_vertices[Next(*this, i)] - m_vertices[i];
        if (side.LengthSquared() == 0.0f) return false;
        for (int j = 0; j < m_count; ++j) {
            // The finest arcs are straight to rounding.
            const float rounding = 1.0e-6f * side.Length() * (Distance(m_vertices[j], m_vertices[i]) + side.Length());
            if (!(Cross(side, m_vertices[j] - m_vertices[i]) >= -rounding)) return false;
        }
    }
    return true;
}

Vec2 ConvexShape::GetSupportPoint(Vec2 direction) const {
    return FindCurvePoint(*this, direction, FarthestVertex(*this, direction)).point;
}

bool ConvexShape::TestPoint(const Transform& xf, Vec2 p) const { return IsInside(*this, MulT(xf.q, p - xf.p)); }

bool ConvexShape::RayCast(RayCastOutput* output, const RayCastInput& input, const Transform& xf) const {
    const RayCastInput ray{MulT(xf.q, input.p1 - xf.p), MulT(xf.q, input.p2 - xf.p), input.maxFraction};
    if (IsInside(*this, ray.p1)) return false;
    RayCastOutput best{vec2Zero, input.maxFraction};
    if (m_solidRadius == 0.0f) {
        float enter = 0.0f, leave = input.maxFraction;
        const Vec2 path = ray.p2 - ray.p1;
        for (int i = 0; i < m_count; ++i) {
            const float depth = Dot(m_normals[i], m_vertices[i] - ray.p1);
            const float slope = Dot(m_normals[i], path);
            if (slope == 0.0f && depth < 0.0f) return false;
            if (slope < 0.0f && depth < enter * slope) {
                enter = depth / slope;
                best.normal = m_normals[i];
            } else if (slope > 0.0f && depth < leave * slope) {
                leave = depth / slope;
            }
            if (leave < enter) return false;
        }
        best.fraction = enter;
    } else {
        CircleShape disk;
        disk.m_radius = m_solidRadius;
        const Transform identity(vec2Zero, Rot(0.0f));
        for (int i = 0; i < m_count; ++i) {
            if (m_count > 1) HitSide(*this, i, ray, best);
            disk.m_p = m_vertices[i];
            RayCastOutput hit;
            if (disk.RayCast(&hit, {ray.p1, ray.p2, best.fraction}, identity)) best = hit;
        }
    }
    if (best.normal == vec2Zero) return false;
    output->fraction = best.fraction + 0.0f;  // never −0
    output->normal = Mul(xf.q, best.normal);
    return true;
}

void ConvexShape::ComputeAABB(AABB* aabb, const Transform& xf) const {
    const Vec2 skin{m_radius, m_radius};
    if (m_curvedSides == 0) {
        Vec2 lowest = Mul(xf, m_vertices[0]), highest = lowest;
        for (int i = 1; i < m_count; ++i) {
            const Vec2 v = Mul(xf, m_vertices[i]);
            lowest = Min(lowest, v), highest = Max(highest, v);
        }
        *aabb = {lowest - skin, highest + skin};
        return;
    }
    const Vec2 alongX = MulT(xf.q, Vec2{1.0f, 0.0f});
    const Vec2 alongY = MulT(xf.q, Vec2{0.0f, 1.0f});
    aabb->lowerBound = Vec2{Mul(xf, GetSupportPoint(-alongX)).x, Mul(xf, GetSupportPoint(-alongY)).y} - skin;
    aabb->upperBound = Vec2{Mul(xf, GetSupportPoint(alongX)).x, Mul(xf, GetSupportPoint(alongY)).y} + skin;
}

void ConvexShape::ComputeMass(MassData* massData, float density) const {
    *massData = {density * m_unitMass.mass, m_unitMass.center, density * m_unitMass.I};
}

}  // namespace scree
