// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// How Distance and ShapeCast hand two placed proxies to GJK: in A's frame, counted from A's first vertex.

#pragma once

#include "geometry/gjk.h"

namespace scree {

/// Two proxies in A's frame.
struct PlacedCores {
    Core a, b;
    Transform xfB;  ///< B in A's frame, counted from a.origin
};

/// Both proxies must have vertices.
inline PlacedCores PlaceCores(const DistanceProxy& proxyA, const Transform& xfA, const DistanceProxy& proxyB,
                              const Transform& xfB) {
    // Ground often lies far from its body's origin. Counted from one of its vertices, everything near it is small, and
    // the difference of two large floats of like size is exact.
    const Vec2 origin = proxyA.m_vertices[0];
    const Transform relative = MulT(xfA, xfB);
    return {Core(proxyA.m_vertices, proxyA.m_count, origin),
            Core(proxyB.m_vertices, proxyB.m_count, vec2Zero),
            {relative.p - origin, relative.q}};
}

}  // namespace scree
