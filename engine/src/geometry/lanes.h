// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Four floats handled by one instruction, for kernels that treat four vertices or faces alike. Each lane rounds exactly
// as the scalar expression does, so results do not depend on the width. GCC and Clang vector extensions: SSE2 on
// x86-64, NEON on ARM, plain code elsewhere.

#pragma once

#include <cstring>

#include "scree/math.h"

namespace scree {

using Float4 = float __attribute__((vector_size(16)));

/// Vectors 0…3 as one register of x and one of y.
struct Vec2x4 {
    Float4 x, y;
};

inline Float4 Splat(float value) { return Float4{value, value, value, value}; }

/// Reads four consecutive vectors.
inline Vec2x4 LoadVec2x4(const Vec2* first) {
    Float4 low, high;
    std::memcpy(&low, first, sizeof low);
    std::memcpy(&high, first + 2, sizeof high);
    return {__builtin_shufflevector(low, high, 0, 2, 4, 6), __builtin_shufflevector(low, high, 1, 3, 5, 7)};
}

inline Vec2x4 Mul(Rot q, Vec2x4 v) { return {q.c * v.x - q.s * v.y, q.s * v.x + q.c * v.y}; }
inline Vec2x4 Mul(const Transform& t, Vec2x4 v) {
    return {(t.q.c * v.x - t.q.s * v.y) + t.p.x, (t.q.s * v.x + t.q.c * v.y) + t.p.y};
}
inline Float4 Dot(Vec2x4 a, Vec2x4 b) { return a.x * b.x + a.y * b.y; }
inline Vec2x4 operator-(Vec2x4 a, Vec2x4 b) { return {a.x - b.x, a.y - b.y}; }
inline Float4 Min(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 Max(Float4 a, Float4 b) { return a > b ? a : b; }

/// Vector `I` of the four, in every lane.
template <int I>
Vec2x4 Lane(Vec2x4 v) {
    return {__builtin_shufflevector(v.x, v.x, I, I, I, I), __builtin_shufflevector(v.y, v.y, I, I, I, I)};
}

/// The first `used` lanes of `values`, then `filler`.
inline Float4 FillFrom(Float4 values, int used, float filler) {
    for (int lane = 0; lane < 4; ++lane) values[lane] = lane < used ? values[lane] : filler;
    return values;
}
inline Vec2x4 FillFrom(Vec2x4 v, int used, Vec2 filler) {
    return {FillFrom(v.x, used, filler.x), FillFrom(v.y, used, filler.y)};
}

}  // namespace scree
