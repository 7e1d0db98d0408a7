// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A scene's shape as a Box2D shape: shape in, value that owns no heap out.

#pragma once

#include <box2d/b2_chain_shape.h>
#include <box2d/b2_circle_shape.h>
#include <box2d/b2_edge_shape.h>
#include <box2d/b2_polygon_shape.h>

#include <variant>

#include "scenes/scene.h"
#include "testbed/engines/snapshot.h"

namespace testbed {

using Box2dShape = std::variant<b2CircleShape, b2PolygonShape, b2EdgeShape>;

/// Throws std::invalid_argument for a chain, which owns heap, and for a further convex shape: see Box2dShapeOf.
[[nodiscard]] Box2dShape MakeBox2dShape(const scenes::Shape& shape);
/// What Box2D gets for a shape of a scene: a polygon of at most 8 vertices for the further convex shapes, which it does
/// not have, else the shape itself.
[[nodiscard]] scenes::Shape Box2dShapeOf(const scenes::Scene& scene, const scenes::Shape& shape);
[[nodiscard]] const b2Shape& AsB2Shape(const Box2dShape& shape);

/// Fills a chain that is empty (Box2D's cannot be copied).
void MakeBox2dChain(const scenes::Scene& scene, const scenes::Shape& shape, b2ChainShape& chain);

inline b2Vec2 ToB2(scenes::Vec2 v) { return {v.x, v.y}; }
inline scenes::Vec2 FromB2(b2Vec2 v) { return {v.x, v.y}; }
inline Box FromB2(const b2AABB& box) { return {FromB2(box.lowerBound), FromB2(box.upperBound)}; }

}  // namespace testbed
