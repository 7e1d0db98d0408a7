// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Smooth collision at the seams of one-sided edges: a contact axis and the ghost vertices → whether this edge or its
// neighbour owns the contact (E. Catto, "Ghost Collisions", box2d.org, June 2020; thresholds of Box2D 2.4).

#pragma once

#include <cstdint>

#include "scree/shape.h"

namespace scree {

/// What a ghost vertex says about an axis that leans over its end of a one-sided edge.
enum class Seam : uint8_t { keep, useEdgeNormal, drop };

inline Seam JudgeSeam(const EdgeShape& edge, Vec2 along, Vec2 axis) {
    // On a convex corner, axes beyond the neighbour's normal belong to the neighbour; the tolerance is on the sine of
    // the angle past it. On a concave corner nothing can be touched but the edge's face.
    constexpr float sineTolerance = 0.1f;
    if (Dot(axis, along) <= 0.0f) {
        Vec2 before = edge.m_vertex1 - edge.m_vertex0;
        before.Normalize();
        if (!(Cross(before, along) >= 0.0f)) return Seam::useEdgeNormal;
        return Cross(axis, Vec2{before.y, -before.x}) > sineTolerance ? Seam::drop : Seam::keep;
    }
    Vec2 after = edge.m_vertex3 - edge.m_vertex2;
    after.Normalize();
    if (!(Cross(along, after) >= 0.0f)) return Seam::useEdgeNormal;
    return Cross(Vec2{after.y, -after.x}, axis) > sineTolerance ? Seam::drop : Seam::keep;
}

}  // namespace scree
