// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Stage: contacts of awake bodies → manifolds, begin and end events, pre-solve.

#pragma once

#include "pipeline/contact_events.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/fixtures.h"

namespace scree {

/// Recomputes the manifold of every contact with an awake body, carries impulses over by feature id, reports changes,
/// wakes the bodies of contacts that began or ended. Returns the number of touching contacts.
int UpdateManifolds(const FixtureTable& fixtures, const ContactEvents& events, BodyTable& bodies,
                    ContactTable& contacts);

}  // namespace scree
