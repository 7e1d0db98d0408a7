// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Sleepers leave the lists at the end of a step, when their boxes have been updated and their pairs found once more.

#include "pipeline/parts/rouse.h"

#include <atomic>

#include "pipeline/parts/solved_rows.h"

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

void RestSleepers(TaskPool& pool, BodyTable& bodies, const FixtureTable& fixtures, ContactTable& contacts,
                  BroadPhase& broadPhase, std::vector<ContactIndex>& rows) {
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
    std::atomic<bool> isSomeAsked{false};
    const auto rests = [&](ContactIndex contact) {
        if (!contacts.IsAlive(contact)) return false;
        constexpr uint8_t asked = ContactFlag::marked | ContactFlag::refilter;
        if ((contacts.flags[contact] & asked) != ContactFlag::marked) {
            isSomeAsked.store(true, std::memory_order_relaxed);
            return false;
        }
        const ContactPair& pair = contacts.pair[contact];
        return bodies.isListed[pair.bodyA] == 0 && bodies.isListed[pair.bodyB] == 0;
    };
    GatherActiveRows(
        contacts, pool, rows,
        [&](ContactIndex contact, ContactIndex*& place) {
            *place = contact;
            place += rests(contact) ? 1 : 0;
        },
        [](const ContactIndex* begin, const ContactIndex* end) { return static_cast<size_t>(end - begin); });
    for (const ContactIndex contact : rows) contacts.Rest(contact);
    contacts.mayRest = isSomeAsked.load(std::memory_order_relaxed);
}

}  // namespace scree
