// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// How large and how small numbers may get before single precision gives out: squares, boxes and inverses of what stays
// within are finite.

#pragma once

#include "state/bodies.h"

namespace scree {

/// Bound of coordinates, m, of speeds, m/s, and of spins, rad/s.
inline constexpr float farthest = 1e18f;
/// Bounds of the mass of a fixture or a body, kg, if it has any.
inline constexpr float leastMass = 1e-30f, mostMass = 1e30f;
/// Bound of the inertia of a fixture, kg·m²: those of a hundred have a finite sum.
inline constexpr float mostInertia = 1e36f;
/// Shorter steps count as 0, s: the inverse of a small part of one must be finite.
inline constexpr float shortestStep = 1e-30f;
/// Impulses of a step so much shorter than this one tell nothing about it: they are not taken over.
inline constexpr float mostStepRatio = 1000.0f;

/// False for NaN, too.
inline bool IsInRange(float x) { return Abs(x) <= farthest; }
inline bool IsInRange(Vec2 v) { return IsInRange(v.x) && IsInRange(v.y); }
/// A state that a body may be left in by a step.
inline bool IsInRange(const Position& p, const Velocity& v) {
    return IsInRange(p.c) && IsInRange(p.a) && IsInRange(v.v) && IsInRange(v.w);
}

/// 1 / x; 0 where that is of no use: x is not above 0, or it or its inverse is not finite.
inline float UsableInverse(float x) {
    const float inverse = 1.0f / x;
    return x > 0.0f && std::isfinite(x) && std::isfinite(inverse) ? inverse : 0.0f;
}

}  // namespace scree
