// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Boxes that cover a shape on its whole way through a step: a tight one of the shape, and a quick one of its box at the
// start.

#pragma once

#include "scree/math.h"
#include "scree/shape.h"

namespace scree {

/// The boxes at both ends of the motion, widened by how far a turning point leaves the straight line between its ends.
/// `end`: the shape's frame at the end of the sweep.
AABB SweptBox(const Shape& shape, const Sweep& sweep, const Transform& end);

/// What a box of something of a body has to be widened by to cover its way.
class QuickSweep {
public:
    /// A body whose centre of mass goes from `from` to `to`, world, and which turns by `turn`, rad. `margin`, m: more
    /// than the boxes to cover lag behind.
    QuickSweep(Vec2 from, Vec2 to, float turn, float margin);
    /// Takes the box at the start; covers SweptBox too. O(1), whatever the shape.
    [[nodiscard]] AABB Cover(const AABB& start) const;

private:
    Vec2 m_from, m_way;
    float m_perReach;  ///< how far a turn takes a point and bends its way, per metre from the centre
    float m_margin;
};

}  // namespace scree
