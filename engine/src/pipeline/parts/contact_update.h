// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// New manifold of one contact at the bodies' present transforms, and its events. Shared by the narrow phase and the
// continuous collision.

#pragma once

#include "pipeline/contact_events.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/fixtures.h"

namespace scree {

/// The manifold at the present transforms, with the impulses of the old one by feature id; true if the fixtures touch.
/// Nothing else changes but `work`, the counts of what sensors cost, so contacts may be computed in any order and at
/// the same time.
bool ComputeManifold(int contact, const FixtureTable& fixtures, const BodyTable& bodies, TOIStats& work,
                     ContactTable& contacts);

/// What follows a computed manifold: flags, and the bodies wake if the contact began or ended. True if it did.
bool NoteTouching(int contact, bool isTouching, BodyTable& bodies, ContactTable& contacts);

/// Both, then the listener is told (begin, end, pre-solve). Returns true if the fixtures touch.
bool UpdateContact(int contact, const FixtureTable& fixtures, const ContactEvents& events, BodyTable& bodies,
                   ContactTable& contacts);

}  // namespace scree
