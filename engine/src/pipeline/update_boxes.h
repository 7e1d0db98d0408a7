// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Stage: tight AABBs of the fixtures of bodies that moved, into the broad phase.

#pragma once

#include <span>

#include "broad_phase/broad_phase.h"
#include "state/bodies.h"
#include "state/fixtures.h"

namespace scree {

/// Gives the broad phase the present box of every fixture of `body`; `displacement` is the way its origin went.
void UpdateBodyBoxes(const BodyTable& bodies, const FixtureTable& fixtures, int body, Vec2 displacement,
                     BroadPhase& broadPhase);

}  // namespace scree
