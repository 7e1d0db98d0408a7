// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The end of a contact.

#include "pipeline/parts/destroy_contact.h"

namespace scree {

void DestroyContact(int contact, bool parted, const ContactEvents& events, BodyTable& bodies, ContactTable& contacts) {
    const auto c = static_cast<size_t>(contact);
    contacts.Rouse(contact);
    const ContactPair pair = contacts.pair[c];
    const bool touched = contacts.Has(contact, ContactFlag::touching);
    const bool pushed = contacts.manifold[c].pointCount > 0 && !contacts.Has(contact, ContactFlag::sensor);
    if (parted) {
        contacts.flags[c] = static_cast<uint8_t>(contacts.flags[c] & ~ContactFlag::touching);
        contacts.manifold[c].pointCount = 0;
    }
    if (touched && events.HearsEnd()) {
        events.listener->EndContact(contacts.Handle(events.state, contact));
    }
    if (pushed) {
        for (const int body : {pair.bodyA, pair.bodyB}) {
            if (events.restartsTimers || !bodies.Has(body, BodyFlag::awake)) bodies.Wake(body);
        }
    }
    contacts.Remove(contact);
}

}  // namespace scree
