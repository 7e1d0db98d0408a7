// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Stage: pairs → contacts. Marks the contact of every reported pair or makes one. Contacts left unmarked have parted:
// those that did not touch go at once, those that did are removed at the start of the next step (RemoveContacts), so
// that EndContact comes in the step in which Box2D reports it.

#pragma once

#include <span>

#include "broad_phase/broad_phase.h"
#include "pipeline/contact_events.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/fixtures.h"
#include "state/joints.h"

namespace scree {

struct MatchTables {
    BodyTable& bodies;
    FixtureTable& fixtures;
    JointTable& joints;
    ContactTable& contacts;
};

/// Marks, creates, sweeps. Contacts of bodies that joints or filters keep apart are not made.
void MatchContacts(std::span<const Pair> pairs, const ContactEvents& events, MatchTables tables);
/// Destroys the parted contacts that were touching: EndContact, and their bodies wake.
void RemoveContacts(const ContactEvents& events, MatchTables tables);
/// Destroys one contact at once (its fixture goes). The row is usable again after the next Compact.
void DestroyContact(int contact, const ContactEvents& events, BodyTable& bodies, ContactTable& contacts);
/// Destroys every contact for which `involves(pair)` holds.
template <typename Predicate>
void DestroyContactsIf(Predicate involves, const ContactEvents& events, BodyTable& bodies, ContactTable& contacts) {
    for (int c = 0; c < contacts.Size(); ++c) {
        if (contacts.Has(c, ContactFlag::alive) && involves(contacts.pair[static_cast<size_t>(c)])) {
            DestroyContact(c, events, bodies, contacts);
        }
    }
}
/// True if joints and filters let the two fixtures have a contact.
bool MayHaveContact(int fixtureA, int fixtureB, const ContactEvents& events, MatchTables tables);

}  // namespace scree
