// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Tight boxes of placed shapes, inline for loops over many fixtures. The shapes' own ComputeAABB are these functions,
// so a box has the same bits wherever it is made.

#pragma once

#include <cstring>

#include "geometry/lanes.h"
#include "scree/shape.h"

namespace scree {

inline AABB BoxOf(const CircleShape& circle, const Transform& xf) {
    const Vec2 center = xf.p + Mul(xf.q, circle.m_p);
    const Vec2 radius{circle.m_radius, circle.m_radius};
    return {center - radius, center + radius};
}

/// The first four vertices side by side, the others one by one: nearly all polygons are boxes.
inline AABB BoxOf(const PolygonShape& polygon, const Transform& xf) {
    Vec2x4 corners = LoadVec2x4(polygon.m_vertices);
    if (polygon.m_count < 4) corners = FillFrom(corners, polygon.m_count, polygon.m_vertices[0]);
    const Vec2x4 placed = Mul(xf, corners);
    // Two vertices of one coordinate against the other two, then both coordinates together: {x, y, x, y}.
    const Float4 low = Min(__builtin_shufflevector(placed.x, placed.y, 0, 1, 4, 5),
                           __builtin_shufflevector(placed.x, placed.y, 2, 3, 6, 7));
    const Float4 high = Max(__builtin_shufflevector(placed.x, placed.y, 0, 1, 4, 5),
                            __builtin_shufflevector(placed.x, placed.y, 2, 3, 6, 7));
    const Float4 smallest =
        Min(__builtin_shufflevector(low, low, 0, 2, 0, 2), __builtin_shufflevector(low, low, 1, 3, 1, 3));
    const Float4 largest =
        Max(__builtin_shufflevector(high, high, 0, 2, 0, 2), __builtin_shufflevector(high, high, 1, 3, 1, 3));
    Float4 both = __builtin_shufflevector(smallest, largest, 0, 1, 4, 5);
    for (int i = 4; i < polygon.m_count; ++i) {
        const Vec2 v = Mul(xf, polygon.m_vertices[i]);
        const Vec2 lower = Min(Vec2{both[0], both[1]}, v), upper = Max(Vec2{both[2], both[3]}, v);
        both = Float4{lower.x, lower.y, upper.x, upper.y};
    }
    const float skin = polygon.m_radius;
    both += Float4{-skin, -skin, skin, skin};
    AABB box;
    std::memcpy(&box, &both, sizeof box);
    return box;
}

}  // namespace scree
