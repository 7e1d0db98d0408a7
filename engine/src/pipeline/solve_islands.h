// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Stage: islands → new velocities, positions and sleep states, by sequential impulses.

#pragma once

#include "constraints/contact_rows.h"
#include "constraints/joint_solver.h"
#include "pipeline/contact_events.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/fixtures.h"
#include "state/islands.h"
#include "state/joints.h"

namespace scree {

struct SolverSettings {
    float dt;            ///< s, > 0
    float impulseScale;  ///< of warm starting: dt / last dt, 0 without
    int velocityIterations, positionIterations;
    Vec2 gravity;
    float maxTranslation, maxRotation;  ///< per step
    bool allowSleep;
    bool exactDrift = false;  ///< positions advance by the mean of the velocities before and after
};

/// Scratch of the solver, kept between steps.
struct SolverScratch {
    ContactRows contacts;
    JointConstraints joints;
};

struct SolverCounts {
    int capped = 0;
    int nonFinite = 0;
};

struct SolverTables {
    BodyTable& bodies;
    ContactTable& contacts;
    JointTable& joints;
};

/// Integrates and solves every island and every isolated body. A body whose state stops being finite is put back to
/// where it was, at rest, and counted.
SolverCounts SolveIslands(const SolverSettings& settings, const FixtureTable& fixtures, const IslandTable& islands,
                          const ContactEvents& events, SolverTables tables, SolverScratch& scratch);

}  // namespace scree
