// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What sine and cosine are computed with, one at a time (geometry/math.cpp) and eight at a time (base/simd_math.h), to
// the same bits.

#pragma once

namespace scree::sin_cos {

inline constexpr double twoOverPi = 0x1.45f306dc9c883p-1;
// π/2 in three parts. The first two hold 23 bits each. So their product with a quadrant number below 2^30 is exact, and
// the subtractions cancel without rounding. The only rounding of the reduction is in the last part.
inline constexpr double halfPiHigh = 0x1.921fb4p+0;
inline constexpr double halfPiMid = 0x1.4442dp-24;
inline constexpr double halfPiLow = 0x1.8469898cc517p-48;
/// Adding it pushes the fraction out of a double: what stays in the low mantissa bits is the nearest integer.
inline constexpr double roundingShift = 0x1.8p+52;
/// Smaller angles are reduced by these parts, rad.
inline constexpr float largestDirect = 1.0e9f;
/// Sines and cosines of any angles, one by one.
void SinCosOneByOne(const float* angles, int count, float* sines, float* cosines);
/// A rotation may be turned on by less than that by adding what is at right angles to it: it grows by an ulp at most.
inline constexpr float largestTurn = 0x1p-12f;
// Near-minimax polynomials on |r| <= π/4 in r²: sin r = r + r³·S(r²), relative error 2e-11; cos r = 1 − r²/2 +
// r⁴·C(r²), error 8e-10, both far below half an ulp of float (3e-8).
inline constexpr double s0 = -0x1.555555545dd83p-3, s1 = 0x1.11110deeb33b2p-7;
inline constexpr double s2 = -0x1.a013a6edc8f34p-13, s3 = 0x1.6dbdd26f56d2dp-19;
inline constexpr double c0 = 0x1.555554414e3a6p-5, c1 = -0x1.6c12d2887c343p-10, c2 = 0x1.9bd86445fb99bp-16;

}  // namespace scree::sin_cos
