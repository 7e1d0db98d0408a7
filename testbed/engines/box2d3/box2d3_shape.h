// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Shapes of a scene for Box2D 3.

#pragma once

#include <box2d/box2d.h>
#include <box2d/collision.h>

#include <variant>

#include "scenes/scene.h"
#include "testbed/engines/snapshot.h"

namespace testbed::box2d3 {

inline b2Vec2 ToB2(scenes::Vec2 v) { return {v.x, v.y}; }
inline scenes::Vec2 FromB2(b2Vec2 v) { return {v.x, v.y}; }

using Shape = std::variant<b2Circle, b2Capsule, b2Polygon, b2Segment>;

/// A shape that is no chain; one-sided edges as the segment that they are. Further convex shapes but the capsule become
/// polygons of 8 vertices.
[[nodiscard]] Shape MakeShape(const scenes::Scene& scene, const scenes::Shape& shape);
/// What Box2D 3 gets of it, for pictures.
[[nodiscard]] scenes::Shape ShownShape(const scenes::Scene& scene, const scenes::Shape& shape);
/// The tight box at a pose.
[[nodiscard]] b2AABB ComputeBox(const Shape& shape, b2WorldTransform pose);
inline Box FromB2(const b2AABB& box) { return {FromB2(box.lowerBound), FromB2(box.upperBound)}; }

}  // namespace testbed::box2d3
