// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A character that is not a body: a capsule that is cast through the world, slides along obstacles, goes up steps and
// slopes, and rides on platforms. The functions use queries: CollideMover gives the surfaces nearby as planes,
// SolvePlanes a translation that stays out of them, MoveMover a whole move. A program may use any of them. They only
// read the world, so several threads may move their characters at once, between steps.

#pragma once

#include <span>
#include <vector>

#include "scree/api.h"
#include "scree/ids.h"
#include "scree/math.h"
#include "scree/queries.h"
#include "scree/world.h"

namespace scree {

/// A segment with a radius > 0, m, relative to the mover's position. It does not turn.
struct MoverCapsule {
    Vec2 point1{0.0f, -0.5f}, point2{0.0f, 0.5f};
    float radius = 0.3f;
};

/// The surface of a fixture near a mover, as a half plane that the mover must stay out of.
struct MoverPlane {
    Fixture* fixture;
    Vec2 normal;        ///< unit, towards the mover
    Vec2 point;         ///< on the fixture
    float separation;   ///< from the capsule to it, m; negative: they overlap
    float push = 0.0f;  ///< distance that SolvePlanes has pushed along the normal, m
};

/// The planes of all fixtures that the filter accepts within `margin` ≥ 0 m of the capsule at `position`, in the order
/// of fixture indices. `planes` is overwritten. Bad input gives an error and no planes.
SCREE_API ErrorCode CollideMover(const World& world, const MoverCapsule& capsule, Vec2 position, float margin,
                                 const QueryFilter& filter, std::vector<MoverPlane>& planes);

/// The translation closest to `wish` after which every plane has a separation of at least 0. If the planes leave no
/// room, it gives way to each of them in turn. Sets `push` of each plane; their sum leads from `wish` to the result.
SCREE_API Vec2 SolvePlanes(Vec2 wish, std::span<MoverPlane> planes);

/// The velocity without its component into planes that have pushed.
SCREE_API Vec2 ClipVelocity(Vec2 velocity, std::span<const MoverPlane> planes);

/// The fraction of `translation` that the capsule can move before it is closer than `margin` to a fixture, 0…1.
/// Fixtures that it overlaps at the start do not stop it; see CollideMover. To those that are closer than `margin` then
/// it may come nearer by half of the gap. Distances are those of outlines, without skins.
SCREE_API float CastMover(const World& world, const MoverCapsule& capsule, Vec2 position, Vec2 translation,
                          float margin, const QueryFilter& filter);

/// The properties of a mover.
struct MoverDef {
    MoverCapsule capsule;
    Vec2 up{0.0f, 1.0f};      ///< unit
    float maxSlope = 0.8f;    ///< steepest ground on which it can stand, rad, 0…π/2
    float stepHeight = 0.3f;  ///< highest step that it goes up or down without leaving the ground, m, ≥ 0
    float skin = 0.01f;       ///< distance that it keeps from everything, m, > 0
    QueryFilter filter{.includeSensors = false};
};

/// Where a mover is, and on what.
struct MoverState {
    Vec2 position{0.0f, 0.0f};
    /// m/s; on the ground relative to it, so that a mover rides on platforms. The program sets it before each move to
    /// what the player wants, and adds gravity while the mover is in the air.
    Vec2 velocity{0.0f, 0.0f};
    bool isGrounded = false;
    Vec2 groundNormal{0.0f, 0.0f};
    FixtureId ground{};  ///< the default id while it is in the air
    Vec2 groundPoint{0.0f, 0.0f};
};

/// Moves for `timeStep` > 0 s: first with the ground, then by its own velocity along obstacles and up steps. If it
/// stood on the ground and does not rise, it then goes down to it again. The velocity loses its component into
/// obstacles. A mover that leaves the ground gets the ground's velocity added. Bad input is reported, and the state is
/// returned unchanged.
[[nodiscard]] SCREE_API MoverState MoveMover(World& world, const MoverDef& def, const MoverState& state,
                                             float timeStep);

}  // namespace scree
