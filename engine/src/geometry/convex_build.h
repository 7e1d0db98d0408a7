// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the Make functions of convex shapes share.

#pragma once

#include <cfloat>

#include "geometry/moments.h"
#include "scree/convex_shape.h"

namespace scree {

/// Sets the chords' normals, and the control points of straight sides, from the vertices.
void FinishSides(ConvexShape& shape);

/// A shape that CreateFixture refuses, naming the argument.
ConvexShape MakeBadConvex(const char* field);

/// Mass data of a closed outline at 1 kg/m².
inline MassData OutlineMass(const Vec2* vertices, int count) {
    const FanMoments fan = IntegrateFan(vertices, count);
    const Vec2 center = vertices[0] + fan.center;
    return {fan.area, center, fan.secondMoment + fan.area * (center.LengthSquared() - fan.center.LengthSquared())};
}

}  // namespace scree
