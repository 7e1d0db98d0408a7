// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One pass over all contacts.

#include "pipeline/narrow_phase.h"

#include "pipeline/parts/contact_update.h"
#include "pipeline/parts/destroy_contact.h"
#include "pipeline/parts/make_contact.h"

namespace scree {

namespace {

/// Still reported by the broad phase, and not refused by joints and filters when they must be asked again.
bool Stays(int contact, const ContactEvents& events, NarrowPhaseTables t) {
    uint8_t& flags = t.contacts.flags[static_cast<size_t>(contact)];
    if ((flags & ContactFlag::marked) == 0) return false;
    if ((flags & ContactFlag::refilter) == 0) return true;
    flags = static_cast<uint8_t>(flags & ~ContactFlag::refilter);
    const ContactPair& pair = t.contacts.pair[static_cast<size_t>(contact)];
    return MayHaveContact(static_cast<int>(pair.fixtureA), static_cast<int>(pair.fixtureB), events, t.fixtures,
                          t.joints);
}

}  // namespace

int UpdateManifolds(const ContactEvents& events, NarrowPhaseTables t) {
    int touchingCount = 0;
    for (int contact = t.contacts.Size(); contact-- > 0;) {
        if (!t.contacts.Has(contact, ContactFlag::alive)) continue;
        if (!Stays(contact, events, t)) {
            DestroyContact(contact, events, t.bodies, t.contacts);
            continue;
        }
        const ContactPair& pair = t.contacts.pair[static_cast<size_t>(contact)];
        const bool active = t.bodies.IsActive(pair.bodyA) || t.bodies.IsActive(pair.bodyB);
        const bool touching = active ? UpdateContact(contact, t.fixtures, events, t.bodies, t.contacts)
                                     : t.contacts.Has(contact, ContactFlag::touching);
        if (touching) ++touchingCount;
    }
    return touchingCount;
}

}  // namespace scree
