// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The table shape × shape of collision functions. A new shape is one row and one column.

#pragma once

#include "scree/collision.h"
#include "scree/distance.h"
#include "scree/shape.h"

namespace scree {

/// Fills the manifold of two shapes whose types the entry was made for.
using CollideFunction = void (*)(Manifold& manifold, const Shape& shapeA, const Transform& xfA, const Shape& shapeB,
                                 const Transform& xfB);

struct CollideEntry {
    CollideFunction function;  ///< null: these shapes never touch (two edges)
    bool swap;                 ///< the function wants the second shape first
};

CollideEntry FindCollide(Shape::Type typeA, Shape::Type typeB);

/// True if the shapes, with their skins, overlap: what a sensor reports.
bool TestOverlap(const Shape& shapeA, const Transform& xfA, const Shape& shapeB, const Transform& xfB);

/// The same, and how many rounds GJK took.
struct OverlapResult {
    bool overlaps;
    int iterations;
};
OverlapResult FindOverlap(const DistanceProxy& proxyA, const Transform& xfA, const DistanceProxy& proxyB,
                          const Transform& xfB);

}  // namespace scree
