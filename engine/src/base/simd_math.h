// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Plane vectors, rotations and placements, four or eight side by side, for kernels: the arithmetic of scree/math.h,
// lane by lane, with the same bits. That header is not included: its functions, compiled for one processor, could be
// called on another.

#pragma once

#include "base/simd.h"
#include "base/sin_cos_terms.h"

namespace scree {
inline namespace SCREE_SIMD_SET {

struct Vector4 {
    F4 x, y;
};
SCREE_KERNEL Vector4 operator-(Vector4 a, Vector4 b) { return {a.x - b.x, a.y - b.y}; }
SCREE_KERNEL F4 Dot4(Vector4 a, Vector4 b) { return a.x * b.x + a.y * b.y; }
SCREE_KERNEL Vector4 SplatVector4(float x, float y) { return {Splat4(x), Splat4(y)}; }
/// Four vectors that lie one behind the other: x, y, x, y, …
SCREE_KERNEL Vector4 LoadVectors4(const float* xy) {
    const F4 low = Load4(xy), high = Load4(xy + 4);
    return {Shuffle4<0, 2, 0, 2>(low, high), Shuffle4<1, 3, 1, 3>(low, high)};
}
/// One vector in all lanes.
template <int lane>
SCREE_KERNEL Vector4 SplatLane4(Vector4 v) {
    return {SplatLane4<lane>(v.x), SplatLane4<lane>(v.y)};
}
/// The lanes of `a` below `count`, then those of `b`.
SCREE_KERNEL Vector4 FirstLanes4(int count, Vector4 a, Vector4 b) {
    return {FirstLanes4(count, a.x, b.x), FirstLanes4(count, a.y, b.y)};
}

struct Rotation4 {
    F4 s, c;
};
SCREE_KERNEL Vector4 Mul4(Rotation4 q, Vector4 v) { return {q.c * v.x - q.s * v.y, q.s * v.x + q.c * v.y}; }

struct Placement4 {
    Vector4 p;
    Rotation4 q;
};
SCREE_KERNEL Vector4 Mul4(const Placement4& t, Vector4 v) {
    const Vector4 turned = Mul4(t.q, v);
    return {turned.x + t.p.x, turned.y + t.p.y};
}

SCREE_KERNEL F8 Abs8(F8 a) { return Max8(a, Splat8(0.0f) - a); }
SCREE_KERNEL F8 Minus8(F8 a) { return Splat8(-1.0f) * a; }
/// Rows of 1 and 0 as a mask.
SCREE_KERNEL Mask8 IsSet8(const float* row) { return Greater8(Load8(row), Splat8(0.5f)); }

struct Vector8 {
    F8 x, y;
};
SCREE_KERNEL Vector8 LoadVector8(const float* x, const float* y) { return {Load8(x), Load8(y)}; }
SCREE_KERNEL Vector8 operator+(Vector8 a, Vector8 b) { return {a.x + b.x, a.y + b.y}; }
SCREE_KERNEL Vector8 operator-(Vector8 a, Vector8 b) { return {a.x - b.x, a.y - b.y}; }
SCREE_KERNEL Vector8 operator*(F8 s, Vector8 a) { return {s * a.x, s * a.y}; }
SCREE_KERNEL F8 Dot8(Vector8 a, Vector8 b) { return a.x * b.x + a.y * b.y; }
SCREE_KERNEL F8 Cross8(Vector8 a, Vector8 b) { return a.x * b.y - a.y * b.x; }
/// The speed of the point at `arm` from the centre of a body that turns at `w`.
SCREE_KERNEL Vector8 Cross8(F8 w, Vector8 arm) { return {Splat8(0.0f) - w * arm.y, w * arm.x}; }
SCREE_KERNEL Vector8 Select8(Mask8 mask, Vector8 yes, Vector8 no) {
    return {Select8(mask, yes.x, no.x), Select8(mask, yes.y, no.y)};
}

struct Rotation8 {
    F8 s, c;
};
SCREE_KERNEL Vector8 Mul8(Rotation8 q, Vector8 v) { return {q.c * v.x - q.s * v.y, q.s * v.x + q.c * v.y}; }
SCREE_KERNEL Vector8 MulT8(Rotation8 q, Vector8 v) { return {q.c * v.x + q.s * v.y, q.c * v.y - q.s * v.x}; }

/// Sines and cosines of four angles below half a quadrant, and the quadrants from −2 to 2 that belong to them.
SCREE_KERNEL void SinCosOfRemainder(D4 angle, D4& sine, D4& cosine, D4& quadrant) {
    using namespace sin_cos;
    const D4 shift = SplatD4(roundingShift), one = SplatD4(1.0);
    const D4 quadrants = (angle * SplatD4(twoOverPi) + shift) - shift;
    const D4 r =
        ((angle - quadrants * SplatD4(halfPiHigh)) - quadrants * SplatD4(halfPiMid)) - quadrants * SplatD4(halfPiLow);
    const D4 z = r * r, z2 = z * z;
    sine = r * (one + z * ((SplatD4(s0) + SplatD4(s1) * z) + z2 * (SplatD4(s2) + SplatD4(s3) * z)));
    cosine = (one - SplatD4(0.5) * z) + z2 * ((SplatD4(c0) + SplatD4(c1) * z) + z2 * SplatD4(c2));
    quadrant = quadrants - SplatD4(4.0) * ((quadrants * SplatD4(0.25) + shift) - shift);
}

[[maybe_unused]] SCREE_NOINLINE static Rotation8 SinCosOneByOne8(F8 angle) {
    constexpr int lanes = 8;
    alignas(32) float angles[lanes], sines[lanes], cosines[lanes];
    Store8(angles, angle);
    sin_cos::SinCosOneByOne(angles, lanes, sines, cosines);
    return {Load8(sines), Load8(cosines)};
}

/// The rotations by angles: the bits of SinCos.
SCREE_KERNEL Rotation8 SinCos8(F8 angle) {
    if (!AllSet8(Greater8(Splat8(sin_cos::largestDirect), Abs8(angle)))) return SinCosOneByOne8(angle);
    D4 lower, upper, sineLower, sineUpper, cosineLower, cosineUpper, quadrantLower, quadrantUpper;
    SplitF8(angle, lower, upper);
    SinCosOfRemainder(lower, sineLower, cosineLower, quadrantLower);
    SinCosOfRemainder(upper, sineUpper, cosineUpper, quadrantUpper);
    const F8 sine = JoinF8(sineLower, sineUpper), cosine = JoinF8(cosineLower, cosineUpper);
    const F8 quadrant = JoinF8(quadrantLower, quadrantUpper), square = quadrant * quadrant;
    const F8 one = Splat8(1.0f), minusOne = Splat8(-1.0f), half = Splat8(0.5f), minusHalf = Splat8(-0.5f);
    const Mask8 isOdd = And8(Greater8(square, half), Greater8(Splat8(2.0f), square));
    const Mask8 isTwo = Greater8(square, Splat8(2.0f));
    const F8 signOfSine = Select8(Or8(isTwo, Greater8(minusHalf, quadrant)), minusOne, one);
    const F8 signOfCosine = Select8(Or8(isTwo, Greater8(quadrant, half)), minusOne, one);
    return {signOfSine * Select8(isOdd, cosine, sine), signOfCosine * Select8(isOdd, sine, cosine)};
}

struct Placement8 {
    Vector8 p;
    Rotation8 q;
};
SCREE_KERNEL Vector8 Mul8(const Placement8& t, Vector8 v) { return Mul8(t.q, v) + t.p; }
SCREE_KERNEL Vector8 MulT8(const Placement8& t, Vector8 v) { return MulT8(t.q, v - t.p); }
SCREE_KERNEL Placement8 MulT8(const Placement8& a, const Placement8& b) {
    return {MulT8(a.q, b.p - a.p), {a.q.c * b.q.s - a.q.s * b.q.c, a.q.c * b.q.c + a.q.s * b.q.s}};
}
SCREE_KERNEL Placement8 Select8(Mask8 mask, const Placement8& yes, const Placement8& no) {
    return {Select8(mask, yes.p, no.p), {Select8(mask, yes.q.s, no.q.s), Select8(mask, yes.q.c, no.q.c)}};
}

/// The vector scaled to length 1; left alone where it is shorter than `least`.
SCREE_KERNEL Vector8 Normalize8(Vector8 v, F8 least) {
    const F8 one = Splat8(1.0f), length = Sqrt8(Dot8(v, v));
    const Mask8 isLong = GreaterEqual8(length, least);
    return Select8(isLong, one / Select8(isLong, length, one), one) * v;
}

}  // namespace SCREE_SIMD_SET
}  // namespace scree
