// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Part of the stage that finds pairs: tight AABBs of the fixtures of bodies that moved, into the broad phase.

#pragma once

#include <array>
#include <vector>

#include "base/task_pool.h"
#include "broad_phase/broad_phase.h"
#include "state/bodies.h"
#include "state/fixtures.h"

namespace scree {

/// Lists of bodies, null behind the last.
using MovedLists = std::array<const std::vector<BodyIndex>*, 4>;

/// Gives the broad phase the present box of every fixture of every body that moved in the step. These are the active
/// ones, and those of the lists `solved` that fell asleep in it. The lists may be of an earlier step, and their bodies
/// gone. Returns the largest coordinate of their centres, m.
float UpdateMovedBoxes(const BodyTable& bodies, const FixtureTable& fixtures, const MovedLists& solved, TaskPool& pool,
                       BroadPhase& broadPhase);

/// The box of a fixture where its body is now.
AABB FindBox(const BodyTable& bodies, const FixtureTable& fixtures, FixtureIndex fixture);

/// Lists of bodies, null behind the last.
using MovedLists = std::array<const std::vector<BodyIndex>*, 4>;

/// Gives the broad phase the present box of every fixture of `body`; `displacement` is the way its origin went.
void UpdateBodyBoxes(const BodyTable& bodies, const FixtureTable& fixtures, BodyIndex body, Vec2 displacement,
                     BroadPhase& broadPhase);

}  // namespace scree
