// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Boxes shaped for vectors of four: a box is kept as {lx, ly, −ux, −uy}. So a union is one lane-wise minimum, and an
// overlap test is one lane-wise "less or equal".

#pragma once

#include <cstdint>
#include <limits>

#include "base/simd.h"
#include "scree/math.h"

namespace scree::broadphase {

/// A box with its upper corner negated.
struct Bounds {
    float lx, ly, nux, nuy;
};

inline constexpr float infinity = std::numeric_limits<float>::infinity();
/// Neutral for unions; overlaps nothing.
inline constexpr Bounds emptyBounds{infinity, infinity, infinity, infinity};

constexpr Bounds ToBounds(const AABB& b) { return {b.lowerBound.x, b.lowerBound.y, -b.upperBound.x, -b.upperBound.y}; }
constexpr AABB ToAabb(const Bounds& b) { return {{b.lx, b.ly}, {-b.nux, -b.nuy}}; }

SCREE_KERNEL F4 Load(const Bounds& b) { return Load4(reinterpret_cast<const float*>(&b)); }
SCREE_KERNEL void Store(Bounds& b, F4 v) { Store4(reinterpret_cast<float*>(&b), v); }
SCREE_KERNEL F4 Load(const AABB& b) { return NegateUpper4(Load4(reinterpret_cast<const float*>(&b))); }

/// The other side of an overlap test: {ux, uy, −lx, −ly}.
SCREE_KERNEL F4 ProbeOf(F4 bounds) { return Negate4(SwapHalves4(bounds)); }
/// Whether the box (in the form of Bounds) and the box the probe was made of overlap, borders included.
SCREE_KERNEL bool Overlaps(F4 bounds, F4 probe) { return Bits4(LessEqual4(bounds, probe)) == 15u; }
/// {sx, sy, −sx, −sy} with s = lower + upper, twice the centre: the minimum over many boxes bounds their centres.
SCREE_KERNEL F4 CentreOf(F4 bounds) { return bounds - SwapHalves4(bounds); }
/// Half of the perimeter.
constexpr float HalfPerimeter(const Bounds& b) { return -((b.lx + b.nux) + (b.ly + b.nuy)); }

}  // namespace scree::broadphase
