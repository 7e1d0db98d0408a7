// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A character that is no body: a capsule that is cast through the world and slides along what it meets, goes up steps
// and slopes, and rides on what moves. Free functions over queries, from the planes of what is near (collide), over the
// way that keeps out of all of them (slide), to a whole move; a program may take any of them. The world is only read,
// so several threads may move their characters at once, between steps.

#pragma once

#include <span>
#include <vector>

#include "scree/api.h"
#include "scree/ids.h"
#include "scree/math.h"
#include "scree/queries.h"
#include "scree/world.h"

namespace scree {

/// Two points grown by a radius > 0, m, about the mover's position. It does not turn.
struct MoverCapsule {
    Vec2 point1{0.0f, -0.5f}, point2{0.0f, 0.5f};
    float radius = 0.3f;
};

/// The surface of a fixture near a mover, as a half plane that it is to stay out of.
struct MoverPlane {
    Fixture* fixture;
    Vec2 normal;        ///< unit, towards the mover
    Vec2 point;         ///< on the fixture
    float separation;   ///< from the capsule to it, m; negative: they overlap
    float push = 0.0f;  ///< by how much SolvePlanes has pushed along the normal, m
};

/// The planes of all fixtures that the filter sees within `margin` ≥ 0 m of the capsule at `position`, by fixture
/// index. `planes` is overwritten. Bad input: an error and no planes.
SCREE_API ErrorCode CollideMover(const World& world, const MoverCapsule& capsule, Vec2 position, float margin,
                                 const QueryFilter& filter, std::vector<MoverPlane>& planes);

/// The translation nearest to `wish` that leaves every plane with a separation of at least 0. Where planes leave no
/// room, it gives way to each of them in turn. Fills in the pushes: their sum leads from `wish` to the result.
SCREE_API Vec2 SolvePlanes(Vec2 wish, std::span<MoverPlane> planes);

/// A velocity without what points into planes that have pushed.
SCREE_API Vec2 ClipVelocity(Vec2 velocity, std::span<const MoverPlane> planes);

/// How much of `translation` the capsule can go before it comes nearer than `margin` to something, 0…1. What it
/// overlaps at the start does not stop it: that is for CollideMover.
SCREE_API float CastMover(const World& world, const MoverCapsule& capsule, Vec2 position, Vec2 translation,
                          float margin, const QueryFilter& filter);

/// What a mover is.
struct MoverDef {
    MoverCapsule capsule;
    Vec2 up{0.0f, 1.0f};      ///< unit
    float maxSlope = 0.8f;    ///< of ground that it can stand on, against the level, rad, 0…π/2
    float stepHeight = 0.3f;  ///< what it goes up and down without leaving the ground, m, ≥ 0
    float skin = 0.01f;       ///< distance that it keeps, m, > 0
    QueryFilter filter{.includeSensors = false};
};

/// Where a mover is, and on what.
struct MoverState {
    Vec2 position{0.0f, 0.0f};
    /// m/s; on ground relative to it, so that a mover rides on what moves. The program sets it before each move: what
    /// the player wants, and gravity while it is in the air.
    Vec2 velocity{0.0f, 0.0f};
    bool isGrounded = false;
    Vec2 groundNormal{0.0f, 0.0f};
    FixtureId ground{};  ///< of no fixture in the air
    Vec2 groundPoint{0.0f, 0.0f};
};

/// Moves by `timeStep` > 0 s: with the ground, then by its own velocity along what it meets, up a step if one is in the
/// way, and down to the ground again if it stood on it and does not rise. Its velocity loses what pointed into
/// obstacles; who leaves the ground takes its velocity along. Bad input: an error is told and the state is given back
/// as it was.
[[nodiscard]] SCREE_API MoverState MoveMover(World& world, const MoverDef& def, const MoverState& state,
                                             float timeStep);

}  // namespace scree
