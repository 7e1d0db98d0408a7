// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Death of a contact: EndContact, waking, and its row.

#pragma once

#include <span>
#include <vector>

#include "pipeline/contact_events.h"
#include "state/bodies.h"
#include "state/contacts.h"

namespace scree {

/// Destroys one contact: EndContact if it was touching, and its bodies wake if it pushed. The row is usable again after
/// the next Compact. `parted`: its boxes have come apart, so that it has no points when its end is told.
void DestroyContact(ContactIndex contact, bool parted, const ContactEvents& events, BodyTable& bodies,
                    ContactTable& contacts);

/// Destroys the contacts of a body for which `involves(pair)` holds, newest row first. O(contacts of the body), see
/// ContactTable::OfBody. The listener must not add contacts. It may look up contacts of other bodies, which would
/// change the list.
template <typename Predicate>
void DestroyContactsOfBodyIf(BodyIndex body, Predicate involves, const ContactEvents& events, BodyTable& bodies,
                             ContactTable& contacts) {
    std::span<const ContactIndex> rows = contacts.OfBody(body);
    std::vector<ContactIndex> own;
    if (events.HearsEnd()) {
        own.assign(rows.begin(), rows.end());
        rows = own;
    }
    for (const ContactIndex contact : rows) {
        if (contacts.IsAlive(contact) && involves(contacts.pair[contact])) {
            DestroyContact(contact, false, events, bodies, contacts);
        }
    }
}

}  // namespace scree
