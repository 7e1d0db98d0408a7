// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The end of a contact.

#include "pipeline/parts/destroy_contact.h"

namespace scree {

void DestroyContact(int contact, const ContactEvents& events, BodyTable& bodies, ContactTable& contacts) {
    const ContactPair pair = contacts.pair[static_cast<size_t>(contact)];
    if (contacts.Has(contact, ContactFlag::touching) && events.listener != nullptr) {
        events.listener->EndContact(contacts.Handle(events.state, contact));
    }
    if (contacts.manifold[static_cast<size_t>(contact)].pointCount > 0 && !contacts.Has(contact, ContactFlag::sensor)) {
        bodies.Wake(pair.bodyA);
        bodies.Wake(pair.bodyB);
    }
    contacts.Remove(contact);
}

}  // namespace scree
