// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The outline of the further convex shapes as points: what pictures draw, and what an engine gets that has polygons of
// few vertices only.

#pragma once

#include <span>
#include <vector>

#include "scenes/scene.h"

namespace scenes {

/// True for capsule, roundedPolygon, largePolygon, ellipse, sector and supported: shapes that not every engine has.
[[nodiscard]] bool IsFurtherConvex(ShapeType type);

/// The point of a further convex shape that is farthest along `direction` (of length 1), body coordinates. `points`:
/// what OutlinePointsOf gives for the shape.
[[nodiscard]] Vec2 SupportPoint(const Shape& shape, std::span<const Vec2> points, Vec2 direction);

/// A convex polygon, counter-clockwise, of at most `directions` points on the outline: the farthest ones along that
/// many directions at equal angles. Never outside of the shape; with 8 directions an ellipse loses 10 % of its area.
[[nodiscard]] std::vector<Vec2> SampleOutline(const Scene& scene, const Shape& shape, int directions);

/// As many vertices as a PolygonShape has: what stands for a further convex shape in engines without them.
[[nodiscard]] Shape PolygonInstead(const Scene& scene, const Shape& shape);

}  // namespace scenes
