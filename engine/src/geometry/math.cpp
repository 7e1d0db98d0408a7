// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Sine and cosine of a float angle, and the angle of a vector, with the same bits on every machine: IEEE double
// arithmetic only, no libm. Angle in rad → both values as float, within 1 ulp of the correctly rounded ones below 1e9
// rad; the angle within 1 ulp. Source: additive range reduction (Cody and Waite, "Software Manual for the Elementary
// Functions", 1980, ch. 8). Larger angles are multiplied by the bits of 2/π that matter (Payne and Hanek, SIGNUM
// Newsletter 18(1), 1983).

#include "scree/math.h"

#include <bit>
#include <utility>

#include "base/sin_cos_terms.h"

namespace scree {
namespace {

using namespace sin_cos;

constexpr double halfPi = 0x1.921fb54442d18p+0;

/// An angle as quadrant·π/2 + remainder with |remainder| <= π/4; only the quadrant's two low bits count.
struct Reduced {
    double remainder;
    uint32_t quadrant;
};

Reduced ReduceHuge(float angle) {
    // |angle| = mantissa·2^exponent with an integer mantissa of 24 bits and 6 <= exponent <= 104. Bits of 2/π whose
    // product with 2^exponent is a multiple of 4 turn full circles; the 64 bits that follow are exact to 2^-38 rad.
    constexpr uint64_t bits[3] = {0xa2f9836e4e441529u, 0xfc2757d1f534ddc0u, 0xdb6295993c439041u};
    const uint32_t pattern = std::bit_cast<uint32_t>(angle);
    const uint64_t mantissa = (pattern & 0x7fffffu) | 0x800000u;
    const int exponent = static_cast<int>((pattern >> 23) & 0xffu) - 150;
    const int skip = exponent - 2;
    const int word = skip / 64;
    const int shift = skip % 64;
    uint64_t window = bits[word] << shift;
    if (shift > 0) window |= bits[word + 1] >> (64 - shift);
    const uint64_t product = mantissa * window;  // angle·2/π mod 4, in units of 2^-62
    const uint64_t quadrant = (product + (uint64_t{1} << 61)) >> 62;
    const auto fraction = static_cast<int64_t>(product - (quadrant << 62));
    const double remainder = static_cast<double>(fraction) * (halfPi * 0x1p-62);
    const bool negative = (pattern >> 31) != 0;
    const auto turned = static_cast<uint32_t>(quadrant);
    return negative ? Reduced{-remainder, 0u - turned} : Reduced{remainder, turned};
}

inline Reduced ReduceDirect(float angle) {
    const double x = angle;
    const double shifted = x * twoOverPi + roundingShift;
    const double quadrants = shifted - roundingShift;
    const double r = ((x - quadrants * halfPiHigh) - quadrants * halfPiMid) - quadrants * halfPiLow;
    return {r, static_cast<uint32_t>(std::bit_cast<uint64_t>(shifted))};
}

inline float FlipSign(float value, uint32_t signBit) {
    return std::bit_cast<float>(std::bit_cast<uint32_t>(value) ^ signBit);
}

}  // namespace

SinCosResult SinCos(float angle) {
    if (!std::isfinite(angle)) {
        const float nan = angle - angle;
        return {nan, nan};
    }
    const Reduced reduced = std::abs(angle) < largestDirect ? ReduceDirect(angle) : ReduceHuge(angle);
    const double r = reduced.remainder;
    const double z = r * r;
    const double z2 = z * z;
    const auto sine = static_cast<float>(r * (1.0 + z * ((s0 + s1 * z) + z2 * (s2 + s3 * z))));
    const auto cosine = static_cast<float>((1.0 - 0.5 * z) + z2 * ((c0 + c1 * z) + z2 * c2));
    // Odd quadrants swap the two; the second and third negate the sine, the first and second the cosine.
    const uint32_t q = reduced.quadrant;
    const bool swap = (q & 1u) != 0;
    return {FlipSign(swap ? cosine : sine, (q & 2u) << 30), FlipSign(swap ? sine : cosine, ((q + 1u) & 2u) << 30)};
}

void sin_cos::SinCosOneByOne(const float* angles, int count, float* sines, float* cosines) {
    for (int i = 0; i < count; ++i) {
        const SinCosResult result = SinCos(angles[i]);
        sines[i] = result.sin, cosines[i] = result.cos;
    }
}

float Atan2(float y, float x) {
    if (std::isnan(x) || std::isnan(y)) return x + y;
    double across = std::abs(static_cast<double>(y)), along = std::abs(static_cast<double>(x));
    const bool isSteep = across > along;
    if (isSteep) std::swap(across, along);
    double angle = 0.0;  // of (along, across): 0 to π/4
    if (std::isinf(across)) {
        angle = 0.5 * halfPi;
    } else if (across > 0.0) {
        // atan t = π/4 + atan((t − 1) / (t + 1)) brings t below tan(π/8), where
        // eleven terms of the series leave 1e-10.
        constexpr double tanEighth = 0x1.a827999fcef32p-2;
        const bool isLarge = across > tanEighth * along;
        const double t = isLarge ? (across - along) / (across + along) : across / along;
        const double z = t * t;
        double sum = 0.0;
        for (int odd = 21; odd >= 3; odd -= 2) sum = z * (sum + ((odd & 2) != 0 ? -1.0 : 1.0) / odd);
        angle = t + t * sum + (isLarge ? 0.5 * halfPi : 0.0);
    }
    if (isSteep) angle = halfPi - angle;
    if (std::signbit(x)) angle = 2.0 * halfPi - angle;
    return static_cast<float>(std::signbit(y) ? -angle : angle);
}

}  // namespace scree
