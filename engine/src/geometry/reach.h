// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// How far a shape reaches from a point, which bounds how fast its surface moves when it turns about that point. Also
// tells whether a moving disk can meet a shape at all.

#pragma once

#include "scree/shape.h"

namespace scree {

/// The largest distance of a point of the shape, skin included, from `center` (body coordinates), m.
float Reach(const Shape& shape, Vec2 center);

/// True if a disk of `radius` whose centre goes from `from` to `to` (world) surely stays outside the shape placed at
/// `xf`. Exact for circles and edges, up to rounding; for polygons it takes one face that has the whole way in front of
/// it. Quick and conservative: false proves nothing.
bool WayIsClear(const Shape& shape, const Transform& xf, Vec2 from, Vec2 to, float radius);

/// A lower bound of the distance from a point (world) to the shape placed at `xf`, skin included, m. Exact for circles
/// and edges, up to rounding; by the farthest face for polygons; 0 (which proves nothing) for others. Negative inside.
float LeastDistance(const Shape& shape, const Transform& xf, Vec2 point);

}  // namespace scree
