// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Sleepers leave the lists at the end of a step, when their boxes have been updated and their pairs found once more.

#include "pipeline/parts/rouse.h"

namespace scree {

namespace {

void SetResting(int body, bool resting, const BodyTable& bodies, const FixtureTable& fixtures, BroadPhase& broadPhase) {
    for (const int f : fixtures.From(bodies.fixtureHead[static_cast<size_t>(body)])) {
        if (fixtures.info[static_cast<size_t>(f)].inBroadPhase)
            broadPhase.SetResting(static_cast<uint32_t>(f), resting);
    }
}

}  // namespace

void RouseProxies(BodyTable& bodies, const FixtureTable& fixtures, BroadPhase& broadPhase) {
    for (const int body : bodies.risenProxies) {
        if (bodies.isListed[static_cast<size_t>(body)] != 0) SetResting(body, false, bodies, fixtures, broadPhase);
    }
    bodies.risenProxies.clear();
}

void RestSleepers(BodyTable& bodies, const FixtureTable& fixtures, ContactTable& contacts, BroadPhase& broadPhase) {
    RouseContacts(bodies, contacts);
    if (bodies.fellAsleep > 0) {
        bodies.fellAsleep = 0;
        for (const int body : bodies.Listed()) {
            if (bodies.Has(body, BodyFlag::awake)) continue;
            bodies.Unlist(body);
            SetResting(body, true, bodies, fixtures, broadPhase);
            contacts.mayRest = true;
        }
    }
    if (!contacts.mayRest) return;
    contacts.mayRest = false;
    contacts.active.ForEach([&](int contact) {
        const auto c = static_cast<size_t>(contact);
        constexpr uint8_t asked = ContactFlag::marked | ContactFlag::refilter;
        if ((contacts.flags[c] & asked) != ContactFlag::marked) {
            contacts.mayRest = true;
            return;
        }
        const ContactPair& pair = contacts.pair[c];
        if (bodies.isListed[static_cast<size_t>(pair.bodyA)] != 0) return;
        if (bodies.isListed[static_cast<size_t>(pair.bodyB)] == 0) contacts.Rest(contact);
    });
}

}  // namespace scree
