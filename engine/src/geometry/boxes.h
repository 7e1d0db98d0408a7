// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Tight boxes of placed shapes, inline for loops over many fixtures. The shapes' own ComputeAABB are these functions, so
// a box has the same bits wherever it is made.

#pragma once

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
    const auto half = [](Float4 v) { return __builtin_shufflevector(v, v, 2, 3, 0, 1); };
    const Float4 lowX = Min(placed.x, half(placed.x)), lowY = Min(placed.y, half(placed.y));
    const Float4 highX = Max(placed.x, half(placed.x)), highY = Max(placed.y, half(placed.y));
    Vec2 lower{Min(lowX[0], lowX[1]), Min(lowY[0], lowY[1])};
    Vec2 upper{Max(highX[0], highX[1]), Max(highY[0], highY[1])};
    for (int i = 4; i < polygon.m_count; ++i) {
        const Vec2 v = Mul(xf, polygon.m_vertices[i]);
        lower = Min(lower, v);
        upper = Max(upper, v);
    }
    const Vec2 skin{polygon.m_radius, polygon.m_radius};
    return {lower - skin, upper + skin};
}

}  // namespace scree
