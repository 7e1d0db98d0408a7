// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Stage: what is awake → new velocities, positions and sleep states. The choice between the two solvers, and of what is
// solved together: islands, everything at once, or groups of islands with the same number of sub-steps. Being that
// choice, it is the one stage that includes others.

#pragma once

#include <cstdint>

#include "pipeline/contact_events.h"
#include "pipeline/find_islands.h"
#include "pipeline/group_substeps.h"
#include "pipeline/parts/solver.h"
#include "state/fixtures.h"
#include "state/islands.h"

namespace scree {

/// What is solved together. Kept after the step for those who look.
struct SolveLists {
    IslandTable& islands;   ///< of sequential impulses, and with a tolerance; else those that may fall asleep
    IslandTable& active;    ///< of the soft step: everything awake, without islands
    SubstepGroups& groups;  ///< of the soft step with a tolerance: `active` in parts
};

struct SolveReport {
    SolverCounts counts{};
    int substeps = 0;  ///< of the group that took most; 0 with sequential impulses
    int64_t bodySubsteps = 0;
    int islandCount = 0;
    int isolatedCount = 0;  ///< bodies without contacts and joints
    int awakeCount = 0;     ///< bodies, isolated ones included
};

/// Fills the lists that the solver of these settings wants, and empties the others. Wakes what awake bodies reach.
void GatherLists(const SolverSettings& settings, TaskPool& pool, ContactTable& contacts, JointTable& joints,
                 BodyTable& bodies, IslandScratch& scratch, IsolatedPath path, SolveLists lists);

/// The table that lists everything awake, after GatherLists.
const IslandTable& SolvedOf(const SolverSettings& settings, SolveLists lists);

/// Integrates, solves and puts to sleep: the soft step if `settings.substeps` > 0, else sequential impulses.
SolveReport Solve(const SolverSettings& settings, const FixtureTable& fixtures, SolveLists lists,
                  const ContactEvents& events, SolverTables tables, SolverScratch& scratch);

/// Solves and moves some bodies with their contacts and joints once more, for the last `dt` seconds of a soft step that
/// took `settings`. Returns what it counted.
SolverCounts SolveRest(const SolverSettings& settings, float dt, const FixtureTable& fixtures, const IslandTable& lists,
                       const ContactEvents& events, SolverTables tables, SolverScratch& scratch);

/// After a step that lost bodies: they begin anew, without the impulses that moved them out of bounds. Nor do others
/// keep impulses that are not finite: warm starting would bring them back in every later step.
void ForgetLost(BodyTable& bodies, ContactTable& contacts, JointTable& joints);

}  // namespace scree
