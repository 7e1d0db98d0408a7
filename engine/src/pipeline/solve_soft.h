// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Stage: islands → new velocities, positions and sleep states, by the soft step.

#pragma once

#include "pipeline/contact_events.h"
#include "pipeline/parts/solver.h"
#include "state/fixtures.h"
#include "state/islands.h"

namespace scree {

/// Integrates and solves the lists of `active` together in `settings.substeps` sub-steps, and every isolated body. A
/// body whose state stops being finite is put back to where it was, at rest, and counted.
SolverCounts SolveSoft(const SolverSettings& settings, const FixtureTable& fixtures, const IslandTable& active,
                       const ContactEvents& events, SolverTables tables, SolverScratch& scratch);

}  // namespace scree
