// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A scene's shape as a shape of ours: shape in, value out.

#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "scenes/scene.h"
#include "scree/chain_shape.h"
#include "scree/convex_shape.h"
#include "scree/shape.h"
#include "testbed/engines/snapshot.h"

namespace testbed {

/// A ConvexShape is large and rare: held apart, so that vectors of shapes stay small.
using ScreeShape =
    std::variant<scree::CircleShape, scree::PolygonShape, scree::EdgeShape, std::shared_ptr<const scree::ConvexShape>>;

/// Throws std::invalid_argument for a degenerate shape, and for a chain, which owns heap.
[[nodiscard]] ScreeShape MakeScreeShape(const scenes::Scene& scene, const scenes::Shape& shape);
[[nodiscard]] const scree::Shape& AsShape(const ScreeShape& shape);

/// Throws std::invalid_argument for a degenerate chain.
[[nodiscard]] scree::ChainShape MakeScreeChain(const scenes::Scene& scene, const scenes::Shape& shape);

inline scree::Vec2 ToScree(scenes::Vec2 v) { return {v.x, v.y}; }
inline scenes::Vec2 FromScree(scree::Vec2 v) { return {v.x, v.y}; }
inline Box FromScree(const scree::AABB& box) { return {FromScree(box.lowerBound), FromScree(box.upperBound)}; }

}  // namespace testbed
