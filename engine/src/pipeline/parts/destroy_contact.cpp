// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The end of a contact.

#include "pipeline/parts/destroy_contact.h"

#include "state/event_log.h"

namespace scree {

void DestroyContact(ContactIndex contact, bool parted, const ContactEvents& events, BodyTable& bodies,
                    ContactTable& contacts) {
    contacts.Rouse(contact);
    const ContactPair pair = contacts.pair[contact];
    const bool touched = contacts.Has(contact, ContactFlag::touching);
    const bool pushed = contacts.manifold[contact].pointCount > 0 && !contacts.Has(contact, ContactFlag::sensor);
    if (parted) {
        const int untouched = contacts.flags[contact] & ~ContactFlag::touching;
        contacts.flags[contact] = static_cast<uint8_t>(untouched | ContactFlag::enabled);
        contacts.manifold[contact].pointCount = 0;
    }
    if (touched && events.log != nullptr)
        events.log->NoteChange(pair, contacts.Has(contact, ContactFlag::sensor), false);
    if (touched && events.HearsEnd()) {
        events.listener->EndContact(contacts.Handle(events.state, contact));
    }
    if (pushed) {
        for (const BodyIndex body : {pair.bodyA, pair.bodyB}) {
            if (events.restartsTimers || !bodies.Has(body, BodyFlag::awake)) bodies.Wake(body);
        }
    }
    contacts.Remove(contact);
}

}  // namespace scree
