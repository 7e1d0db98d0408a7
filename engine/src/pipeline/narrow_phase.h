// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Stage: contacts of awake bodies → manifolds, begin and end events, pre-solve; contacts that are over → destroyed.

#pragma once

#include "base/task_pool.h"
#include "pipeline/contact_events.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/fixtures.h"
#include "state/joints.h"

namespace scree {

struct NarrowPhaseTables {
    TaskPool& pool;
    BodyTable& bodies;
    FixtureTable& fixtures;
    JointTable& joints;
    ContactTable& contacts;
};

/// What was found out ahead of each contact, kept between steps to save allocation.
struct NarrowPhaseScratch {
    /// `passed`, alone: all that there was to do has been done. `unseen`, alone: the row rests or is free.
    enum Finding : uint8_t {
        nothing = 0,
        known = 1,
        touching = 2,
        asSensor = 4,
        regrouped = 8,
        passed = 16,
        unseen = 32
    };
    Column<ContactIndex, uint8_t> findings;
    Column<ContactIndex, Manifold> old;  ///< before, for a listener that asks
};

/// Newest row first, as Box2D tells its events. Destroys the contacts whose boxes have parted, and those that joints
/// and filters refuse when they are asked again (ContactFlag::refilter). Of the others with an awake body, recomputes
/// the manifold, carries impulses over by feature id, reports changes and wakes the bodies of contacts that began or
/// ended. Returns the number of touching contacts.
///
/// The manifolds are computed ahead, polygons eight pairs at a time and by all workers. What depends on the order stays
/// in order: who wakes, what is destroyed, what a listener is told. So the result is the same.
int UpdateManifolds(const ContactEvents& events, NarrowPhaseTables tables, NarrowPhaseScratch& scratch);

}  // namespace scree
