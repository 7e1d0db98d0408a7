// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Explosions and wind, made of queries, impulses and forces. The world keeps nothing of them. Call them outside of Step
// and of callbacks. Recordings contain the impulses and forces that they apply.

#pragma once

#include <cstdint>

#include "scree/api.h"
#include "scree/errors.h"
#include "scree/math.h"
#include "scree/queries.h"
#include "scree/world.h"

namespace scree {

/// Input of Explode.
struct ExplosionDef {
    Vec2 position{0.0f, 0.0f};  ///< m
    float radius = 1.0f;        ///< within which it has its full strength, m, ≥ 0
    float falloff = 0.0f;       ///< distance beyond it over which the strength falls to 0, m, ≥ 0
    /// Per metre of a fixture's width as it is seen from the centre, N·s/m; negative: an implosion.
    float impulsePerWidth = 0.0f;
    QueryFilter filter{~uint64_t{0}, false};  ///< which fixtures it reaches
};

/// Pushes every dynamic body within reach away from the centre, fixture by fixture, at the point that is nearest to it,
/// and wakes it. Walls do not shield. Bad input gives an error and changes nothing. O(fixtures within reach).
SCREE_API ErrorCode Explode(World& world, const ExplosionDef& def);

/// Input of ApplyWind.
struct WindDef {
    Vec2 velocity{0.0f, 0.0f};  ///< of the air, m/s
    /// Pressure divided by the square of the speed at right angles to a side: kg/m² of the air times a factor of the
    /// shape, ≥ 0. 1.2 is air on a flat plate with a depth of 1 m.
    float density = 1.2f;
    bool wake = false;  ///< whether the wind wakes sleeping bodies
};

/// Applies the force of wind to a fixture of a dynamic body for the next step. Each part of its outline that faces the
/// relative wind gets a pressure of density · (speed along the normal)², after Newton's sine-square law. Drag, lift and
/// torque follow from that. Does nothing for static bodies, edges and chains.
/// O(vertices).
SCREE_API ErrorCode ApplyWind(Fixture* fixture, const WindDef& wind);

}  // namespace scree
