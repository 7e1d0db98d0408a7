// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Capsules, polygons, rounded polygons, ellipses and sectors: description → ConvexShape. The mass of a rounded outline
// is the sum of three parts: its core, the strips along its sides, and the slices of a disk at its corners. It follows
// Steiner's formula and its second moments. Ellipse and sector have their textbook formulas.

#include "geometry/convex_build.h"
#include "geometry/hull.h"

namespace scree {

namespace {

bool IsPositive(float length) { return std::isfinite(length) && length > 0.0f; }

/// Sums mass data of parts at 1 kg/m².
struct MassSum {
    double area = 0.0, x = 0.0, y = 0.0, inertia = 0.0;

    /// `inertia` about the part's own centre.
    void Add(double partArea, Vec2 center, double partInertia) {
        const double cx = center.x, cy = center.y;
        area += partArea;
        x += partArea * cx;
        y += partArea * cy;
        inertia += partInertia + partArea * (cx * cx + cy * cy);
    }
    [[nodiscard]] MassData Get() const {
        return {static_cast<float>(area),
                {static_cast<float>(x / area), static_cast<float>(y / area)},
                static_cast<float>(inertia)};
    }
};

/// A slice of a disk around `apex`, `turn` rad wide, symmetric about the unit vector `axis`.
void AddSlice(MassSum& sum, Vec2 apex, double radius, double turn, Vec2 axis) {
    if (!(turn > 0.0)) return;
    const double area = 0.5 * turn * radius * radius;
    const double sine = SinCos(static_cast<float>(0.5 * turn)).sin;
    const double offset = 4.0 * radius * sine / (3.0 * turn);
    sum.Add(area, apex + static_cast<float>(offset) * axis, area * (0.5 * radius * radius - offset * offset));
}

MassData RoundedMass(const ConvexShape& shape, float radius) {
    MassSum sum;
    constexpr double wholeTurn = 6.283185307179586;
    if (shape.m_count == 1) AddSlice(sum, shape.m_vertices[0], radius, wholeTurn, {1.0f, 0.0f});
    if (shape.m_count >= 3) {
        const FanMoments core = IntegrateFan(shape.m_vertices, shape.m_count);
        const double own = core.secondMoment - core.area * core.center.LengthSquared();
        sum.Add(core.area, shape.m_vertices[0] + core.center, own);
    }
    for (int i = 0; shape.m_count > 1 && i < shape.m_count; ++i) {
        const int next = i + 1 < shape.m_count ? i + 1 : 0;
        const Vec2 v1 = shape.m_vertices[i], v2 = shape.m_vertices[next];
        const Vec2 n1 = shape.m_normals[i], n2 = shape.m_normals[next];
        const double length = Distance(v1, v2), r = radius;
        sum.Add(length * r, 0.5f * (v1 + v2) + 0.5f * radius * n1, length * r * (length * length + r * r) / 12.0);
        Vec2 middle = n1 + n2;
        if (middle.Normalize() < 1.0e-3f) middle = Cross(1.0f, n1);  // the round end of a capsule
        AddSlice(sum, v2, r, Atan2(std::fabs(Cross(n1, n2)), Dot(n1, n2)), middle);
    }
    return sum.Get();
}

/// The hull of the points; false and a named argument if they do not span an area.
bool SetHull(ConvexShape& shape, const Vec2* points, int count, const char* field) {
    shape.m_badField = field;
    if (points == nullptr || count < 3 || count > maxConvexVertices) return false;
    for (int i = 0; i < count; ++i) {
        if (!points[i].IsValid()) return false;
    }
    shape.m_count = ConvexHull(points, count, shape.m_vertices);
    if (shape.m_count == 0) return false;
    FinishSides(shape);
    const float area = IntegrateFan(shape.m_vertices, shape.m_count).area;
    if (!(area > FLT_EPSILON) || !std::isfinite(area)) return false;
    shape.m_badField = nullptr;
    return true;
}

ConvexShape Finished(ConvexShape shape, const char* field) {
    if (!shape.Validate()) return MakeBadConvex(field);
    return shape;
}

struct Ellipse {
    float a, b;
    Transform xf;

    static Vec2 Support(const void* data, Vec2 direction) {
        const auto& e = *static_cast<const Ellipse*>(data);
        const Vec2 d = MulT(e.xf.q, direction);
        const Vec2 scaled{e.a * d.x, e.b * d.y};
        const float length = scaled.Length();
        return Mul(e.xf, Vec2{e.a * scaled.x / length, e.b * scaled.y / length});
    }
};

struct Sector {
    Vec2 apex, first, last;  ///< unit vectors along the straight sides, counter-clockwise
    float radius;

    static Vec2 Support(const void* data, Vec2 direction) {
        const auto& s = *static_cast<const Sector*>(data);
        if (Cross(s.first, direction) >= 0.0f && Cross(direction, s.last) >= 0.0f) return s.apex + s.radius * direction;
        const float alongFirst = Dot(s.first, direction), alongLast = Dot(s.last, direction);
        if (alongFirst <= 0.0f && alongLast <= 0.0f) return s.apex;
        return s.apex + s.radius * (alongFirst > alongLast ? s.first : s.last);
    }
};

/// Loose enough for rounding far from the origin.
float BoundAround(Vec2 center, float radius) { return 1.001f * (center.Length() + radius); }

}  // namespace

void FinishSides(ConvexShape& shape) {
    for (int i = 0; i < shape.m_count; ++i) {
        const Vec2 v1 = shape.m_vertices[i];
        const Vec2 v2 = shape.m_vertices[i + 1 < shape.m_count ? i + 1 : 0];
        shape.m_normals[i] = Cross(v2 - v1, 1.0f);
        shape.m_normals[i].Normalize();
        if (!shape.IsCurved(i)) shape.m_controls[i] = 0.5f * (v1 + v2);
    }
}

ConvexShape MakeBadConvex(const char* field) {
    ConvexShape shape;
    shape.m_badField = field;
    return shape;
}

ConvexShape MakeCapsule(Vec2 p1, Vec2 p2, float radius) {
    if (!p1.IsValid() || !p2.IsValid()) return MakeBadConvex("MakeCapsule::p1, p2");
    if (!IsPositive(radius)) return MakeBadConvex("MakeCapsule::radius");
    ConvexShape shape;
    shape.m_radius = shape.m_solidRadius = radius;
    shape.m_count = Distance(p1, p2) > FLT_EPSILON * (p1.Length() + radius) ? 2 : 1;
    shape.m_vertices[0] = p1;
    shape.m_vertices[1] = p2;
    FinishSides(shape);
    shape.m_unitMass = RoundedMass(shape, radius);
    return Finished(shape, "MakeCapsule::p1, p2");
}

ConvexShape MakePolygon(const Vec2* points, int count) {
    ConvexShape shape;
    if (!SetHull(shape, points, count, "MakePolygon::points")) return MakeBadConvex("MakePolygon::points");
    shape.m_unitMass = OutlineMass(shape.m_vertices, shape.m_count);
    return Finished(shape, "MakePolygon::points");
}

ConvexShape MakeRoundedPolygon(const Vec2* points, int count, float radius) {
    ConvexShape shape;
    if (!IsPositive(radius)) return MakeBadConvex("MakeRoundedPolygon::radius");
    if (!SetHull(shape, points, count, "MakeRoundedPolygon::points"))
        return MakeBadConvex("MakeRoundedPolygon::points");
    shape.m_radius = shape.m_solidRadius = radius;
    shape.m_unitMass = RoundedMass(shape, radius);
    return Finished(shape, "MakeRoundedPolygon::points");
}

ConvexShape MakeEllipse(float semiAxisX, float semiAxisY, Vec2 center, float angle) {
    constexpr float longest = 1000.0f;
    const float a = semiAxisX, b = semiAxisY;
    if (!IsPositive(a)) return MakeBadConvex("MakeEllipse::semiAxisX");
    if (!IsPositive(b) || !(b <= longest * a && a <= longest * b)) return MakeBadConvex("MakeEllipse::semiAxisY");
    if (!center.IsValid()) return MakeBadConvex("MakeEllipse::center");
    if (!std::isfinite(angle)) return MakeBadConvex("MakeEllipse::angle");
    const Ellipse ellipse{a, b, Transform(center, Rot(angle))};
    ConvexShape shape = MakeFromSupport(
        {.support = Ellipse::Support, .data = &ellipse, .boundingRadius = BoundAround(center, Max(a, b))});
    if (shape.m_badField != nullptr) return MakeBadConvex("MakeEllipse::semiAxisX");
    const float mass = pi * a * b;
    shape.m_unitMass = {mass, center, mass * (0.25f * (a * a + b * b) + center.LengthSquared())};
    return Finished(shape, "MakeEllipse::semiAxisX");
}

ConvexShape MakeCircleSector(float radius, float opening, Vec2 apex, float angle) {
    constexpr float narrowest = 0.01f;
    if (!IsPositive(radius)) return MakeBadConvex("MakeCircleSector::radius");
    if (!(opening >= narrowest && opening <= pi)) return MakeBadConvex("MakeCircleSector::opening");
    if (!apex.IsValid()) return MakeBadConvex("MakeCircleSector::apex");
    if (!std::isfinite(angle)) return MakeBadConvex("MakeCircleSector::angle");
    const Vec2 axis = Rot(angle).GetXAxis();
    const Rot half(0.5f * opening);
    const Sector sector{apex, MulT(half, axis), Mul(half, axis), radius};
    ConvexShape shape =
        MakeFromSupport({.support = Sector::Support, .data = &sector, .boundingRadius = BoundAround(apex, radius)});
    if (shape.m_badField != nullptr) return MakeBadConvex("MakeCircleSector::radius");
    MassSum sum;
    AddSlice(sum, apex, radius, opening, axis);
    shape.m_unitMass = sum.Get();
    return Finished(shape, "MakeCircleSector::radius");
}

}  // namespace scree
