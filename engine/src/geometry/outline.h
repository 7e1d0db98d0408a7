// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What of a shape's radius is solid: all of a disk's or a capsule's, and nothing of the skin around polygons and edges.

#pragma once

#include "scree/convex_shape.h"
#include "scree/math.h"
#include "scree/settings.h"
#include "scree/shape.h"

namespace scree {

/// The radius of a shape without its skin, m. Polygons and edges that were given a larger radius are solid beyond the
/// skin.
inline float OutlineRadius(const Shape& shape, float lengthScale) {
    if (shape.GetType() == Shape::e_circle) return shape.m_radius;
    if (shape.GetType() == Shape::e_convex) return static_cast<const ConvexShape&>(shape).m_solidRadius;
    return Max(shape.m_radius - polygonRadius * lengthScale, 0.0f);
}

}  // namespace scree
