// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Area, centre and moment of shapes in closed form: what mass properties are made of.

#pragma once

#include <span>

#include "scenes/scene.h"

namespace testbed {

/// Sums over an area in body coordinates. Times a density they are mass, mass times centre, and moment of inertia about
/// the origin.
struct AreaSums {
    double area = 0.0, x = 0.0, y = 0.0, moment = 0.0;

    void Add(const AreaSums& one, double density);
};

/// Of a polygon, counter-clockwise.
[[nodiscard]] AreaSums SumsOf(std::span<const scenes::Vec2> vertices);
/// Of any shape; edges and chains have none, and further convex shapes that of the polygon in their place.
[[nodiscard]] AreaSums SumsOf(const scenes::Scene& scene, const scenes::Shape& shape);

}  // namespace testbed
