// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Stage: contacts of awake bodies → manifolds, begin and end events, pre-solve; contacts that are over → destroyed.

#pragma once

#include "pipeline/contact_events.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/fixtures.h"
#include "state/joints.h"

namespace scree {

struct NarrowPhaseTables {
    BodyTable& bodies;
    FixtureTable& fixtures;
    JointTable& joints;
    ContactTable& contacts;
};

/// Newest row first, as Box2D tells its events: destroys the contacts whose boxes have parted and those that joints and
/// filters refuse when they are asked again (ContactFlag::refilter); of the others with an awake body, recomputes the
/// manifold, carries impulses over by feature id, reports changes and wakes the bodies of contacts that began or ended.
/// Returns the number of touching contacts.
int UpdateManifolds(const ContactEvents& events, NarrowPhaseTables tables);

}  // namespace scree
