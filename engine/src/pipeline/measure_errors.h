// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Stage, only for those who ask: how far the state after a step is from an exact one.

#pragma once

#include "scree/profile.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/fixtures.h"
#include "state/joints.h"

namespace scree {

struct MeasuredTables {
    const BodyTable& bodies;
    const FixtureTable& fixtures;
    const ContactTable& contacts;
    const JointTable& joints;
};

/// Over contacts that push and joints with an awake body. `slop` is the overlap that the solver means to leave, m, `dt`
/// the length of the step whose impulses the contacts hold, s.
StepErrors MeasureErrors(const MeasuredTables& tables, float slop, float dt);
/// The same, and what of it each mover has its part in: raises overlaps and joint gaps of BodyTable::demand.
StepErrors MeasureDemand(const MeasuredTables& tables, float slop, float dt, Column<BodyIndex, BodyDemand>& demand);

}  // namespace scree
