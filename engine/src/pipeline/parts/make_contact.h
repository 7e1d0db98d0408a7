// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Birth of a contact: may these two fixtures have one, and its row with mixed material. Shared by the stages that find
// pairs (matching, continuous collision).

#pragma once

#include "pipeline/contact_events.h"
#include "state/contacts.h"
#include "state/fixtures.h"
#include "state/joints.h"

namespace scree {

/// True if joints and filters let the two fixtures have a contact.
bool MayHaveContact(FixtureIndex fixtureA, FixtureIndex fixtureB, const ContactEvents& events, FixtureTable& fixtures,
                    JointTable& joints);
/// A new row for a pair that has none; −1 if the two shapes never touch (two edges).
ContactIndex MakeContact(FixtureIndex fixtureA, FixtureIndex fixtureB, const ContactEvents& events,
                         const FixtureTable& fixtures, ContactTable& contacts);

}  // namespace scree
