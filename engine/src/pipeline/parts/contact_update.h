// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// New manifold of one contact at the bodies' present transforms, with its events. Shared by the narrow phase and the
// continuous collision.

#pragma once

#include "pipeline/contact_events.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/fixtures.h"

namespace scree {

/// Recomputes the manifold, carries impulses over by feature id, enables the contact, wakes the bodies if it began or
/// ended, then tells the listener (begin, end, pre-solve). Returns true if the fixtures touch.
bool UpdateContact(int contact, const FixtureTable& fixtures, const ContactEvents& events, BodyTable& bodies,
                   ContactTable& contacts);

}  // namespace scree
