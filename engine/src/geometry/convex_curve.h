// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The curved outline of a ConvexShape: direction → the outermost point and how sharply the outline bends there.

#pragma once

#include <initializer_list>

#include "scree/convex_shape.h"

namespace scree {

/// In the id of a contact where a curve touches: it stays the same contact while it rolls.
inline constexpr int curveFeature = 255;

/// A point of the outline.
struct CurvePoint {
    Vec2 point;
    float bendRadius;  ///< of the arc it lies on, m; 0 at a corner
};

/// The outermost point along `direction` (any length), given the outermost vertex of the core.
inline CurvePoint FindCurvePoint(const ConvexShape& shape, Vec2 direction, int vertex) {
    const int before = vertex > 0 ? vertex - 1 : shape.m_count - 1;
    for (const int side : {vertex, before}) {
        if (!shape.IsCurved(side)) continue;
        const Vec2 v0 = shape.m_vertices[side];
        const Vec2 v2 = shape.m_vertices[side + 1 < shape.m_count ? side + 1 : 0];
        Vec2 e0 = shape.m_controls[side] - v0;
        Vec2 e1 = v2 - shape.m_controls[side];
        // The tangent of the arc, (1 − u)·e0 + u·e1, is perpendicular to the direction at the outermost point.
        const float rise = Dot(direction, e0), fall = Dot(direction, e1);
        if (!(rise > 0.0f && fall < 0.0f)) continue;
        const float u = rise / (rise - fall);
        const Vec2 a = v0 + u * e0, b = shape.m_controls[side] + u * e1;
        e0.Normalize();
        e1.Normalize();
        return {a + u * (b - a), Distance(v0, v2) / Distance(e0, e1)};
    }
    return {shape.m_vertices[vertex], 0.0f};
}

}  // namespace scree
