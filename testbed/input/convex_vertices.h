// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Vertices as a polygon of Box2D takes them: convex, counter-clockwise, none twice.

#pragma once

#include <vector>

#include "scenes/scene.h"

namespace testbed {

/// Box2D's linear slop, m: what is nearer than half of it is one vertex.
inline constexpr float linearSlop = 0.005f;

/// The convex hull, counter-clockwise from the lowest vertex on the left, without vertices between others.
[[nodiscard]] std::vector<scenes::Vec2> HullOf(std::vector<scenes::Vec2> points);

/// Leaves out what Box2D takes for one vertex with an earlier one. O(square of their number).
void Weld(std::vector<scenes::Vec2>& vertices);

/// Whether every vertex turns left. O(square of their number).
[[nodiscard]] bool IsConvex(const std::vector<scenes::Vec2>& vertices);

}  // namespace testbed
