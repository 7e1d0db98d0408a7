// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Convex hull of a few points, as PolygonShape::Set needs it: points → corners counter-clockwise, near-duplicates
// merged.

#pragma once

#include "scree/math.h"

namespace scree {

/// Writes the corners of the convex hull of `count` finite points (at most maxConvexVertices) to `hull`, which has room
/// for `count`. Returns their number. The corners are counter-clockwise, from the rightmost point (the lowest of
/// several). Points nearer than half of linearSlop to an earlier one are dropped, and so are points on a side. Returns
/// 0 when fewer than three corners remain or when rounding keeps the outline from closing.
[[nodiscard]] int ConvexHull(const Vec2* points, int count, Vec2* hull);

}  // namespace scree
