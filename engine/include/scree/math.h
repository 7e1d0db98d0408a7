// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Small vectors, rotations and transforms with Box2D 2.4's names. Everything is single precision and evaluated in the
// order written (the build turns fused contraction off), so results agree on every machine.

#pragma once

#include <cmath>
#include <cstdint>

#include "scree/api.h"
#include "scree/settings.h"

namespace scree {

/// A 2D column vector, m unless said otherwise. Not initialised by default.
struct Vec2 {
    float x, y;

    Vec2() = default;
    constexpr Vec2(float xIn, float yIn) : x(xIn), y(yIn) {}

    constexpr void SetZero() { x = 0.0f, y = 0.0f; }
    constexpr void Set(float xIn, float yIn) { x = xIn, y = yIn; }

    constexpr Vec2 operator-() const { return {-x, -y}; }
    constexpr void operator+=(Vec2 v) { x += v.x, y += v.y; }
    constexpr void operator-=(Vec2 v) { x -= v.x, y -= v.y; }
    constexpr void operator*=(float s) { x *= s, y *= s; }

    [[nodiscard]] float Length() const { return std::sqrt(x * x + y * y); }
    [[nodiscard]] constexpr float LengthSquared() const { return x * x + y * y; }
    /// Scales to length 1 and returns the former length; a vector shorter than float epsilon is left alone, result 0.
    float Normalize();
    /// True if neither component is infinite or NaN.
    [[nodiscard]] bool IsValid() const { return std::isfinite(x) && std::isfinite(y); }
    /// The vector turned by +90°: dot(Skew(v), w) == cross(v, w).
    [[nodiscard]] constexpr Vec2 Skew() const { return {-y, x}; }
};

inline constexpr Vec2 vec2Zero{0.0f, 0.0f};

constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2 operator*(float s, Vec2 a) { return {s * a.x, s * a.y}; }
constexpr bool operator==(Vec2 a, Vec2 b) { return a.x == b.x && a.y == b.y; }

constexpr float Dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
constexpr float Cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
constexpr Vec2 Cross(Vec2 a, float s) { return {s * a.y, -s * a.x}; }
constexpr Vec2 Cross(float s, Vec2 a) { return {-s * a.y, s * a.x}; }

constexpr float Min(float a, float b) { return a < b ? a : b; }
constexpr float Max(float a, float b) { return a > b ? a : b; }
constexpr Vec2 Min(Vec2 a, Vec2 b) { return {Min(a.x, b.x), Min(a.y, b.y)}; }
constexpr Vec2 Max(Vec2 a, Vec2 b) { return {Max(a.x, b.x), Max(a.y, b.y)}; }
constexpr float Abs(float a) { return a > 0.0f ? a : -a; }
constexpr Vec2 Abs(Vec2 a) { return {Abs(a.x), Abs(a.y)}; }
constexpr float Clamp(float a, float low, float high) { return Max(low, Min(a, high)); }

inline float Distance(Vec2 a, Vec2 b) { return (a - b).Length(); }
constexpr float DistanceSquared(Vec2 a, Vec2 b) { return (a - b).LengthSquared(); }

inline float Vec2::Normalize() {
    const float length = Length();
    if (length < 1.1920929e-7f) return 0.0f;
    const float inv = 1.0f / length;
    x *= inv;
    y *= inv;
    return length;
}

struct SinCosResult {
    float sin, cos;
};

/// Sine and cosine of an angle in rad, the same bits on every machine; within 1 ulp for |angle| < 1e9 (math.cpp).
SCREE_API SinCosResult SinCos(float angle);
/// The angle of the vector (x, y) in [−π, π], rad, the same bits on every
/// machine; within 1 ulp. 0 for (0, 0).
SCREE_API float Atan2(float y, float x);

/// A rotation as sine and cosine.
struct Rot {
    float s, c;

    Rot() = default;
    /// Rotation by `angle` rad, counter-clockwise.
    explicit Rot(float angle) { Set(angle); }
    void Set(float angle) {
        const SinCosResult r = SinCos(angle);
        s = r.sin;
        c = r.cos;
    }
    constexpr void SetIdentity() { s = 0.0f, c = 1.0f; }
    /// The angle in (−π, π], rad.
    [[nodiscard]] float GetAngle() const { return Atan2(s, c); }
    [[nodiscard]] constexpr Vec2 GetXAxis() const { return {c, s}; }
    [[nodiscard]] constexpr Vec2 GetYAxis() const { return {-s, c}; }
};

/// Rotates a vector.
constexpr Vec2 Mul(Rot q, Vec2 v) { return {q.c * v.x - q.s * v.y, q.s * v.x + q.c * v.y}; }
/// Rotates a vector backwards.
constexpr Vec2 MulT(Rot q, Vec2 v) { return {q.c * v.x + q.s * v.y, -q.s * v.x + q.c * v.y}; }
inline Rot Mul(Rot q, Rot r) {
    Rot out;
    out.s = q.s * r.c + q.c * r.s;
    out.c = q.c * r.c - q.s * r.s;
    return out;
}
inline Rot MulT(Rot q, Rot r) {
    Rot out;
    out.s = q.c * r.s - q.s * r.c;
    out.c = q.c * r.c + q.s * r.s;
    return out;
}

/// A rigid frame: rotate by q, then shift by p.
struct Transform {
    Vec2 p;
    Rot q;

    Transform() = default;
    Transform(Vec2 position, Rot rotation) : p(position), q(rotation) {}
    void SetIdentity() {
        p.SetZero();
        q.SetIdentity();
    }
    void Set(Vec2 position, float angle) {
        p = position;
        q.Set(angle);
    }
};

constexpr Vec2 Mul(const Transform& t, Vec2 v) {
    return {(t.q.c * v.x - t.q.s * v.y) + t.p.x, (t.q.s * v.x + t.q.c * v.y) + t.p.y};
}
constexpr Vec2 MulT(const Transform& t, Vec2 v) { return MulT(t.q, v - t.p); }
/// The frame b seen from the frame a: MulT(a, b) maps b's coordinates to a's.
inline Transform MulT(const Transform& a, const Transform& b) { return {MulT(a.q, b.p - a.p), MulT(a.q, b.q)}; }
inline Transform Mul(const Transform& a, const Transform& b) { return {Mul(a.q, b.p) + a.p, Mul(a.q, b.q)}; }

/// A 2×2 matrix by columns.
struct Mat22 {
    Vec2 ex, ey;

    /// Solves A·x = b; a singular matrix gives the zero vector.
    [[nodiscard]] Vec2 Solve(Vec2 b) const {
        float det = ex.x * ey.y - ey.x * ex.y;
        if (det != 0.0f) det = 1.0f / det;
        return {det * (ey.y * b.x - ey.x * b.y), det * (ex.x * b.y - ex.y * b.x)};
    }
    /// The inverse; a singular matrix gives zero.
    [[nodiscard]] Mat22 GetInverse() const {
        float det = ex.x * ey.y - ey.x * ex.y;
        if (det != 0.0f) det = 1.0f / det;
        Mat22 out;
        out.ex = {det * ey.y, -det * ex.y};
        out.ey = {-det * ey.x, det * ex.x};
        return out;
    }
};

constexpr Vec2 Mul(const Mat22& m, Vec2 v) { return {m.ex.x * v.x + m.ey.x * v.y, m.ex.y * v.x + m.ey.y * v.y}; }

/// An axis-aligned bounding box, closed: boxes that only share a border overlap.
struct AABB {
    Vec2 lowerBound, upperBound;

    [[nodiscard]] bool IsValid() const {
        return lowerBound.IsValid() && upperBound.IsValid() && lowerBound.x <= upperBound.x &&
               lowerBound.y <= upperBound.y;
    }
    [[nodiscard]] constexpr Vec2 GetCenter() const { return 0.5f * (lowerBound + upperBound); }
    /// Half widths.
    [[nodiscard]] constexpr Vec2 GetExtents() const { return 0.5f * (upperBound - lowerBound); }
    [[nodiscard]] constexpr float GetPerimeter() const {
        return 2.0f * ((upperBound.x - lowerBound.x) + (upperBound.y - lowerBound.y));
    }
    /// Grows to the union with another box.
    constexpr void Combine(const AABB& b) {
        lowerBound = Min(lowerBound, b.lowerBound);
        upperBound = Max(upperBound, b.upperBound);
    }
    [[nodiscard]] constexpr bool Contains(const AABB& b) const {
        return lowerBound.x <= b.lowerBound.x && lowerBound.y <= b.lowerBound.y && b.upperBound.x <= upperBound.x &&
               b.upperBound.y <= upperBound.y;
    }
};

constexpr bool TestOverlap(const AABB& a, const AABB& b) {
    return a.lowerBound.x <= b.upperBound.x && b.lowerBound.x <= a.upperBound.x && a.lowerBound.y <= b.upperBound.y &&
           b.lowerBound.y <= a.upperBound.y;
}
constexpr AABB Union(const AABB& a, const AABB& b) {
    return {Min(a.lowerBound, b.lowerBound), Max(a.upperBound, b.upperBound)};
}

/// The motion of a body's centre of mass over one step, and where that centre lies in the body. In between, centre and
/// angle move linearly.
struct Sweep {
    Vec2 localCenter;     ///< centre of mass in body coordinates
    Vec2 c0, c;           ///< centre at alpha0 and at the end of the step, world
    float a0, a;          ///< angle at alpha0 and at the end of the step, rad, not wrapped
    float alpha0 = 0.0f;  ///< the part of the step already done, in [0, 1): where c0 and a0 hold

    /// The body's frame (its origin, not its centre) at the fraction beta of what is left: 0 is alpha0, 1 the end.
    void GetTransform(Transform* xf, float beta) const;
    /// Moves the start to the fraction alpha of the step, alpha0 <= alpha <= 1. Where nothing is left to interpolate
    /// (alpha0 = 1), only alpha0 changes.
    void Advance(float alpha);
    /// Turns both angles by the same number of full circles so that a0 lies in [0, 2π).
    void Normalize();
};

inline void Sweep::GetTransform(Transform* xf, float beta) const {
    const float left = 1.0f - beta;
    xf->q.Set(left * a0 + beta * a);
    xf->p = (left * c0 + beta * c) - Mul(xf->q, localCenter);
}

inline void Sweep::Advance(float alpha) {
    if (alpha0 < 1.0f) {
        const float beta = (alpha - alpha0) / (1.0f - alpha0);
        c0 += beta * (c - c0);
        a0 += beta * (a - a0);
    }
    alpha0 = alpha;
}

inline void Sweep::Normalize() {
    const float circle = 2.0f * pi;
    const float turned = circle * std::floor(a0 / circle);
    a0 -= turned;
    a -= turned;
}

}  // namespace scree
