// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Stage: islands → new velocities, positions and sleep states, by sequential impulses.

#pragma once

#include "pipeline/contact_events.h"
#include "pipeline/parts/solver.h"
#include "state/fixtures.h"
#include "state/islands.h"

namespace scree {

/// Integrates and solves every island and every isolated body. Islands with few contacts are solved contact by contact
/// in Box2D's order; the others all together by vector kernels, colour by colour. A body whose state stops being finite
/// is put back to where it was, at rest, and counted.
SolverCounts SolveIslands(const SolverSettings& settings, const FixtureTable& fixtures, const IslandTable& islands,
                          const ContactEvents& events, SolverTables tables, SolverScratch& scratch);

}  // namespace scree
