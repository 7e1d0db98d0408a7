// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The functions of 3×3 matrices, by cofactors.

#include "../box2d/b2_math.h"

const b2Vec2 b2Vec2_zero(0.0f, 0.0f);

namespace {

float ReciprocalOrZero(float x) { return x != 0.0f ? 1.0f / x : 0.0f; }

}  // namespace

b2Vec3 b2Mat33::Solve33(const b2Vec3& b) const {
    const float r = ReciprocalOrZero(b2Dot(ex, b2Cross(ey, ez)));
    return b2Vec3(r * b2Dot(b, b2Cross(ey, ez)), r * b2Dot(ex, b2Cross(b, ez)), r * b2Dot(ex, b2Cross(ey, b)));
}

b2Vec2 b2Mat33::Solve22(const b2Vec2& b) const { return b2Mat22(b2Vec2(ex.x, ex.y), b2Vec2(ey.x, ey.y)).Solve(b); }

void b2Mat33::GetInverse22(b2Mat33* M) const {
    const b2Mat22 inverse = b2Mat22(b2Vec2(ex.x, ex.y), b2Vec2(ey.x, ey.y)).GetInverse();
    M->SetZero();
    M->ex.Set(inverse.ex.x, inverse.ex.y, 0.0f);
    M->ey.Set(inverse.ey.x, inverse.ey.y, 0.0f);
}

void b2Mat33::GetSymInverse33(b2Mat33* M) const {
    // The rows of the inverse are the cross products of the columns over the determinant; by symmetry its columns too.
    const float r = ReciprocalOrZero(b2Dot(ex, b2Cross(ey, ez)));
    M->ex = r * b2Cross(ey, ez);
    M->ey = r * b2Cross(ez, ex);
    M->ez = r * b2Cross(ex, ey);
}
