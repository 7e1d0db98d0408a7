// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Tight boxes of placed shapes, inline for loops over many fixtures. The shapes' own ComputeAABB are these functions,
// so a box has the same bits wherever it is made.

#pragma once

#include "base/compiler.h"
#include "geometry/vectors4.h"
#include "scree/shape.h"

namespace scree {

SCREE_INLINE AABB BoxOf(const CircleShape& circle, const Transform& xf) {
    const Vec2 center = xf.p + Mul(xf.q, circle.m_p);
    const Vec2 radius{circle.m_radius, circle.m_radius};
    return {center - radius, center + radius};
}

/// The first four vertices side by side, the others one by one: nearly all polygons are boxes.
SCREE_INLINE AABB BoxOf(const PolygonShape& polygon, const Transform& xf) {
    Vector4 corners = LoadVectors4(&polygon.m_vertices[0].x);
    if (polygon.m_count < 4) corners = FirstLanes4(polygon.m_count, corners, SplatVector4(polygon.m_vertices[0]));
    const Vector4 placed = Mul4(SplatPlacement4(xf), corners);
    // Two vertices of one coordinate against the other two, then both coordinates together: {x, y, x, y}.
    const F4 first = Shuffle4<0, 1, 0, 1>(placed.x, placed.y), second = Shuffle4<2, 3, 2, 3>(placed.x, placed.y);
    const F4 low = Min4(first, second), high = Max4(first, second);
    const F4 smallest = Min4(Shuffle4<0, 2, 0, 2>(low, low), Shuffle4<1, 3, 1, 3>(low, low));
    const F4 largest = Max4(Shuffle4<0, 2, 0, 2>(high, high), Shuffle4<1, 3, 1, 3>(high, high));
    F4 both = Shuffle4<0, 1, 0, 1>(smallest, largest);
    for (int i = 4; i < polygon.m_count; ++i) {
        const Vec2 v = Mul(xf, polygon.m_vertices[i]);
        const F4 twice = Set4(v.x, v.y, v.x, v.y);
        both = Shuffle4<0, 1, 2, 3>(Min4(both, twice), Max4(both, twice));
    }
    const float skin = polygon.m_radius;
    AABB box;
    Store4(reinterpret_cast<float*>(&box), both + Set4(-skin, -skin, skin, skin));
    return box;
}

}  // namespace scree
