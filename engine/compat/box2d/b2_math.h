// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Vectors, matrices, rotations, transforms and sweeps of Box2D 2.4: the same members, the same functions, the same
// order of evaluation.

#pragma once

#include <math.h>

#include "b2_api.h"
#include "b2_settings.h"

/// Neither infinite nor NaN.
inline bool b2IsValid(float x) { return isfinite(x); }

#define b2Sqrt(x) sqrtf(x)
#define b2Atan2(y, x) atan2f(y, x)

/// A vector of the plane; not initialised by default.
struct B2_API b2Vec2 {
    b2Vec2() {}
    b2Vec2(float xIn, float yIn) : x(xIn), y(yIn) {}

    void SetZero() { x = y = 0.0f; }
    void Set(float x_, float y_) {
        x = x_;
        y = y_;
    }

    b2Vec2 operator-() const { return b2Vec2(-x, -y); }
    /// Component 0 is x, 1 is y.
    float operator()(int32 i) const { return i == 0 ? x : y; }
    float& operator()(int32 i) { return i == 0 ? x : y; }
    void operator+=(const b2Vec2& v) {
        x += v.x;
        y += v.y;
    }
    void operator-=(const b2Vec2& v) {
        x -= v.x;
        y -= v.y;
    }
    void operator*=(float a) {
        x *= a;
        y *= a;
    }

    float Length() const { return b2Sqrt(x * x + y * y); }
    float LengthSquared() const { return x * x + y * y; }
    /// Makes the length 1 and returns the former one; a shorter vector than b2_epsilon stays, result 0.
    float Normalize() {
        const float length = Length();
        if (length < b2_epsilon) return 0.0f;
        *this *= 1.0f / length;
        return length;
    }
    bool IsValid() const { return b2IsValid(x) && b2IsValid(y); }
    /// Turned by +90°.
    b2Vec2 Skew() const { return b2Vec2(-y, x); }

    float x, y;
};

/// A vector with three components.
struct B2_API b2Vec3 {
    b2Vec3() {}
    b2Vec3(float xIn, float yIn, float zIn) : x(xIn), y(yIn), z(zIn) {}

    void SetZero() { x = y = z = 0.0f; }
    void Set(float x_, float y_, float z_) {
        x = x_;
        y = y_;
        z = z_;
    }

    b2Vec3 operator-() const { return b2Vec3(-x, -y, -z); }
    void operator+=(const b2Vec3& v) {
        x += v.x;
        y += v.y;
        z += v.z;
    }
    void operator-=(const b2Vec3& v) {
        x -= v.x;
        y -= v.y;
        z -= v.z;
    }
    void operator*=(float s) {
        x *= s;
        y *= s;
        z *= s;
    }

    float x, y, z;
};

/// A 2×2 matrix by columns.
struct B2_API b2Mat22 {
    b2Mat22() {}
    b2Mat22(const b2Vec2& c1, const b2Vec2& c2) : ex(c1), ey(c2) {}
    b2Mat22(float a11, float a12, float a21, float a22) : ex(a11, a21), ey(a12, a22) {}

    void Set(const b2Vec2& c1, const b2Vec2& c2) {
        ex = c1;
        ey = c2;
    }
    void SetIdentity() { Set(b2Vec2(1.0f, 0.0f), b2Vec2(0.0f, 1.0f)); }
    void SetZero() { Set(b2Vec2(0.0f, 0.0f), b2Vec2(0.0f, 0.0f)); }

    /// Zero if singular.
    b2Mat22 GetInverse() const {
        const float r = ReciprocalDeterminant();
        return b2Mat22(r * ey.y, -r * ey.x, -r * ex.y, r * ex.x);
    }
    /// x of A·x = b; zero if singular.
    b2Vec2 Solve(const b2Vec2& b) const {
        const float r = ReciprocalDeterminant();
        return b2Vec2(r * (ey.y * b.x - ey.x * b.y), r * (ex.x * b.y - ex.y * b.x));
    }

    b2Vec2 ex, ey;

private:
    float ReciprocalDeterminant() const {
        const float det = ex.x * ey.y - ey.x * ex.y;
        return det != 0.0f ? 1.0f / det : det;
    }
};

/// A 3×3 matrix by columns.
struct B2_API b2Mat33 {
    b2Mat33() {}
    b2Mat33(const b2Vec3& c1, const b2Vec3& c2, const b2Vec3& c3) : ex(c1), ey(c2), ez(c3) {}

    void SetZero() {
        ex.SetZero();
        ey.SetZero();
        ez.SetZero();
    }

    /// x of A·x = b; zero if singular.
    b2Vec3 Solve33(const b2Vec3& b) const;
    /// The same for the upper left 2×2 block.
    b2Vec2 Solve22(const b2Vec2& b) const;
    /// The inverse of the upper left 2×2 block, the rest zero; zero if singular.
    void GetInverse22(b2Mat33* M) const;
    /// The inverse of a symmetric matrix; zero if singular.
    void GetSymInverse33(b2Mat33* M) const;

    b2Vec3 ex, ey, ez;
};

/// A rotation as sine and cosine.
struct B2_API b2Rot {
    b2Rot() {}
    explicit b2Rot(float angle) { Set(angle); }

    void Set(float angle) {
        s = sinf(angle);
        c = cosf(angle);
    }
    void SetIdentity() {
        s = 0.0f;
        c = 1.0f;
    }
    float GetAngle() const { return b2Atan2(s, c); }
    b2Vec2 GetXAxis() const { return b2Vec2(c, s); }
    b2Vec2 GetYAxis() const { return b2Vec2(-s, c); }

    float s, c;
};

/// A rigid frame: rotate by q, then shift by p.
struct B2_API b2Transform {
    b2Transform() {}
    b2Transform(const b2Vec2& position, const b2Rot& rotation) : p(position), q(rotation) {}

    void SetIdentity() {
        p.SetZero();
        q.SetIdentity();
    }
    void Set(const b2Vec2& position, float angle) {
        p = position;
        q.Set(angle);
    }

    b2Vec2 p;
    b2Rot q;
};

/// The motion of a body during a step: its centre of mass from c0 to c, its angle from a0 to a.
struct B2_API b2Sweep {
    /// The frame of the body's origin at the share beta of the motion.
    void GetTransform(b2Transform* transform, float beta) const;
    /// Moves the start of the motion to the time alpha.
    void Advance(float alpha);
    /// Takes whole turns off both angles, so that a0 is in [0, 2π).
    void Normalize();

    b2Vec2 localCenter;
    b2Vec2 c0, c;
    float a0, a;
    /// The time of c0 and a0 within the step, 0…1.
    float alpha0;
};

extern B2_API const b2Vec2 b2Vec2_zero;

inline b2Vec2 operator+(const b2Vec2& a, const b2Vec2& b) { return b2Vec2(a.x + b.x, a.y + b.y); }
inline b2Vec2 operator-(const b2Vec2& a, const b2Vec2& b) { return b2Vec2(a.x - b.x, a.y - b.y); }
inline b2Vec2 operator*(float s, const b2Vec2& a) { return b2Vec2(s * a.x, s * a.y); }
inline bool operator==(const b2Vec2& a, const b2Vec2& b) { return a.x == b.x && a.y == b.y; }
inline bool operator!=(const b2Vec2& a, const b2Vec2& b) { return a.x != b.x || a.y != b.y; }
inline b2Vec3 operator+(const b2Vec3& a, const b2Vec3& b) { return b2Vec3(a.x + b.x, a.y + b.y, a.z + b.z); }
inline b2Vec3 operator-(const b2Vec3& a, const b2Vec3& b) { return b2Vec3(a.x - b.x, a.y - b.y, a.z - b.z); }
inline b2Vec3 operator*(float s, const b2Vec3& a) { return b2Vec3(s * a.x, s * a.y, s * a.z); }
inline b2Mat22 operator+(const b2Mat22& A, const b2Mat22& B) { return b2Mat22(A.ex + B.ex, A.ey + B.ey); }

inline float b2Dot(const b2Vec2& a, const b2Vec2& b) { return a.x * b.x + a.y * b.y; }
inline float b2Dot(const b2Vec3& a, const b2Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline float b2Cross(const b2Vec2& a, const b2Vec2& b) { return a.x * b.y - a.y * b.x; }
inline b2Vec2 b2Cross(const b2Vec2& a, float s) { return b2Vec2(s * a.y, -s * a.x); }
inline b2Vec2 b2Cross(float s, const b2Vec2& a) { return b2Vec2(-s * a.y, s * a.x); }
inline b2Vec3 b2Cross(const b2Vec3& a, const b2Vec3& b) {
    return b2Vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
inline float b2Distance(const b2Vec2& a, const b2Vec2& b) { return (a - b).Length(); }
inline float b2DistanceSquared(const b2Vec2& a, const b2Vec2& b) { return (a - b).LengthSquared(); }

/// b2Mul applies a matrix, rotation or frame, b2MulT its transpose (for rotations and frames: the inverse).
inline b2Vec2 b2Mul(const b2Mat22& A, const b2Vec2& v) {
    return b2Vec2(A.ex.x * v.x + A.ey.x * v.y, A.ex.y * v.x + A.ey.y * v.y);
}
inline b2Vec2 b2MulT(const b2Mat22& A, const b2Vec2& v) { return b2Vec2(b2Dot(v, A.ex), b2Dot(v, A.ey)); }
inline b2Mat22 b2Mul(const b2Mat22& A, const b2Mat22& B) { return b2Mat22(b2Mul(A, B.ex), b2Mul(A, B.ey)); }
inline b2Mat22 b2MulT(const b2Mat22& A, const b2Mat22& B) { return b2Mat22(b2MulT(A, B.ex), b2MulT(A, B.ey)); }
inline b2Vec3 b2Mul(const b2Mat33& A, const b2Vec3& v) { return v.x * A.ex + v.y * A.ey + v.z * A.ez; }
inline b2Vec2 b2Mul22(const b2Mat33& A, const b2Vec2& v) {
    return b2Vec2(A.ex.x * v.x + A.ey.x * v.y, A.ex.y * v.x + A.ey.y * v.y);
}
inline b2Rot b2Mul(const b2Rot& q, const b2Rot& r) {
    b2Rot product;
    product.s = q.s * r.c + q.c * r.s;
    product.c = q.c * r.c - q.s * r.s;
    return product;
}
inline b2Rot b2MulT(const b2Rot& q, const b2Rot& r) {
    b2Rot product;
    product.s = q.c * r.s - q.s * r.c;
    product.c = q.c * r.c + q.s * r.s;
    return product;
}
inline b2Vec2 b2Mul(const b2Rot& q, const b2Vec2& v) { return b2Vec2(q.c * v.x - q.s * v.y, q.s * v.x + q.c * v.y); }
inline b2Vec2 b2MulT(const b2Rot& q, const b2Vec2& v) { return b2Vec2(q.c * v.x + q.s * v.y, -q.s * v.x + q.c * v.y); }
inline b2Vec2 b2Mul(const b2Transform& T, const b2Vec2& v) { return b2Mul(T.q, v) + T.p; }
inline b2Vec2 b2MulT(const b2Transform& T, const b2Vec2& v) { return b2MulT(T.q, v - T.p); }
inline b2Transform b2Mul(const b2Transform& A, const b2Transform& B) {
    return b2Transform(b2Mul(A.q, B.p) + A.p, b2Mul(A.q, B.q));
}
inline b2Transform b2MulT(const b2Transform& A, const b2Transform& B) {
    return b2Transform(b2MulT(A.q, B.p - A.p), b2MulT(A.q, B.q));
}

template <typename T>
inline T b2Abs(T a) {
    return a > T(0) ? a : -a;
}
inline b2Vec2 b2Abs(const b2Vec2& a) { return b2Vec2(b2Abs(a.x), b2Abs(a.y)); }
inline b2Mat22 b2Abs(const b2Mat22& A) { return b2Mat22(b2Abs(A.ex), b2Abs(A.ey)); }

template <typename T>
inline T b2Min(T a, T b) {
    return a < b ? a : b;
}
inline b2Vec2 b2Min(const b2Vec2& a, const b2Vec2& b) { return b2Vec2(b2Min(a.x, b.x), b2Min(a.y, b.y)); }

template <typename T>
inline T b2Max(T a, T b) {
    return a > b ? a : b;
}
inline b2Vec2 b2Max(const b2Vec2& a, const b2Vec2& b) { return b2Vec2(b2Max(a.x, b.x), b2Max(a.y, b.y)); }

template <typename T>
inline T b2Clamp(T a, T low, T high) {
    return b2Max(low, b2Min(a, high));
}
inline b2Vec2 b2Clamp(const b2Vec2& a, const b2Vec2& low, const b2Vec2& high) { return b2Max(low, b2Min(a, high)); }

template <typename T>
inline void b2Swap(T& a, T& b) {
    T former = a;
    a = b;
    b = former;
}

/// The smallest power of two above x.
inline uint32 b2NextPowerOfTwo(uint32 x) {
    for (uint32 shift = 1; shift <= 16; shift *= 2) x |= x >> shift;
    return x + 1;
}
inline bool b2IsPowerOfTwo(uint32 x) { return x > 0 && (x & (x - 1)) == 0; }

inline void b2Sweep::GetTransform(b2Transform* transform, float beta) const {
    transform->q.Set((1.0f - beta) * a0 + beta * a);
    transform->p = (1.0f - beta) * c0 + beta * c;
    transform->p -= b2Mul(transform->q, localCenter);
}

inline void b2Sweep::Advance(float alpha) {
    if (alpha0 >= 1.0f) return;  // nothing of the motion is left
    const float beta = (alpha - alpha0) / (1.0f - alpha0);
    c0 += beta * (c - c0);
    a0 += beta * (a - a0);
    alpha0 = alpha;
}

inline void b2Sweep::Normalize() {
    const float turn = 2.0f * b2_pi;
    const float whole = turn * floorf(a0 / turn);
    a0 -= whole;
    a -= whole;
}
