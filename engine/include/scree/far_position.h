// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Positions in double, for programs whose worlds reach far from the origin.

#pragma once

#include "scree/api.h"
#include "scree/math.h"

namespace scree {

/// What BodyDef and Body::SetTransform take, m.
struct FarPosition {
    Vec2 position;      ///< the nearest floats
    Vec2 positionRest;  ///< what they lack
};

/// The point (x, y), m. To be preferred to taking the differences oneself: g++ 12 at -O2 rounds x − double(float(x)) of
/// two neighbours to 0.
SCREE_API FarPosition ToFarPosition(double x, double y);

}  // namespace scree
