// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Sleepers leave the lists at the end of a step, when their boxes have been updated and their pairs found once more.

#include "pipeline/parts/rouse.h"

namespace scree {

namespace {

void SetResting(BodyIndex body, bool resting, const BodyTable& bodies, const FixtureTable& fixtures,
                BroadPhase& broadPhase) {
    for (const FixtureIndex f : fixtures.From(bodies.fixtureHead[body])) {
        if (fixtures.info[f].inBroadPhase) broadPhase.SetResting(ProxyOf(f), resting);
    }
}

}  // namespace

void RouseProxies(BodyTable& bodies, const FixtureTable& fixtures, BroadPhase& broadPhase) {
    for (const BodyIndex body : bodies.risenProxies) {
        if (bodies.isListed[body] != 0) SetResting(body, false, bodies, fixtures, broadPhase);
    }
    bodies.risenProxies.clear();
}

void RestSleepers(BodyTable& bodies, const FixtureTable& fixtures, ContactTable& contacts, BroadPhase& broadPhase) {
    RouseContacts(bodies, contacts);
    if (bodies.fellAsleep > 0) {
        bodies.fellAsleep = 0;
        for (const BodyIndex body : bodies.Listed()) {
            if (bodies.Has(body, BodyFlag::awake)) continue;
            bodies.Unlist(body);
            SetResting(body, true, bodies, fixtures, broadPhase);
            contacts.mayRest = true;
        }
    }
    if (!contacts.mayRest) return;
    contacts.mayRest = false;
    contacts.active.ForEach([&](ContactIndex contact) {
        constexpr uint8_t asked = ContactFlag::marked | ContactFlag::refilter;
        if ((contacts.flags[contact] & asked) != ContactFlag::marked) {
            contacts.mayRest = true;
            return;
        }
        const ContactPair& pair = contacts.pair[contact];
        if (bodies.isListed[pair.bodyA] != 0) return;
        if (bodies.isListed[pair.bodyB] == 0) contacts.Rest(contact);
    });
}

}  // namespace scree
