// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Whether a shape that passes another one, or rests on it, can have a time of impact at all. The bound costs a few
// products a vertex and spares the search (time_of_impact.cpp) where nothing can happen.
//
// Take an axis that is fixed in the still shape. A vertex of the mover goes along it as its centre does, which is
// linear, and on an arc. That leaves the straight line between its ends by an eighth of reach times turn squared. So
// what is beyond the target at both ends by so much is beyond it all the way. Axes are those of one face of the still
// shape. Of an edge also: its ends, the direction from an end to the nearest vertex of the mover, and the side of the
// mover that looks at it.

#pragma once

#include "scree/shape.h"

namespace scree {

/// A shape that has moved against another one, which does not turn; places are those at the end of the motion.
struct Passage {
    const Shape& still;
    Transform stillPlace;
    const Shape& mover;
    Transform moverPlace;
    Vec2 centre;  ///< about which the mover turns, in its own coordinates
    Vec2 way;     ///< of that centre against the still shape
    float turn;   ///< of the mover, rad
};

/// What counts as a meeting.
enum class Watched : uint8_t {
    cores,          ///< cores that come within the target
    coresOrMiddle,  ///< the same; where they begin within it, the middle of the mover that comes near (MiddlePartOf)
    middle          ///< the middle of the mover that comes near
};

struct Clearance {
    bool isSure = false;        ///< nothing meets on the way
    bool middlePasses = false;  ///< the middle of the mover does not, where it is watched
    /// Nothing meets either on any way on which no point of the mover gets farther than this from where it is at the
    /// end of this one, m. Negative: nothing is known.
    float slack = -1.0f;
    float reach = 0.0f;  ///< of the mover's core from its centre, m
};

/// Conservative: what is not sure has to be searched. `lengthScale` as for TimeOfImpact.
Clearance BoundClearance(const Passage& passage, Watched watched, float lengthScale);

/// The centroid of a shape, in its own coordinates.
Vec2 MiddleOf(const Shape& shape);
/// What must not pass is the middle of a shape in every direction: contacts push to the nearer side. Where opposite
/// vertices have one middle, that is the centroid, and this is 0. The centroid of other shapes lies at 1/3 to 2/3 of
/// their width. Of those the core must not pass, shrunk about the centroid to this share.
float MiddlePartOf(const Shape& shape);
/// How far that is from the surface of the shape at least, m; of shapes that are not convex 0.
float DepthOfMiddle(const Shape& shape);

}  // namespace scree
