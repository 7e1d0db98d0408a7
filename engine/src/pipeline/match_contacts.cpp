// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Mark, match, sweep (the dissertation, §4.2.2). Contacts that were not touching are swept at once; those that were
// wait for the next step, in which their EndContact is due.

#include "pipeline/match_contacts.h"

#include <utility>

#include "geometry/collide.h"

namespace scree {

namespace {

void CreateContact(int fixtureA, int fixtureB, MatchTables t) {
    const Shape::Type typeA = t.fixtures.type[static_cast<size_t>(fixtureA)];
    const Shape::Type typeB = t.fixtures.type[static_cast<size_t>(fixtureB)];
    const CollideEntry entry = FindCollide(typeA, typeB);
    if (entry.function == nullptr) return;  // two edges never touch
    if (entry.swap) std::swap(fixtureA, fixtureB);
    const auto a = static_cast<size_t>(fixtureA);
    const auto b = static_cast<size_t>(fixtureB);
    const int contact = t.contacts.Add(
        {static_cast<uint32_t>(fixtureA), static_cast<uint32_t>(fixtureB), t.fixtures.body[a], t.fixtures.body[b]});
    const auto c = static_cast<size_t>(contact);
    if (t.fixtures.isSensor[a] || t.fixtures.isSensor[b]) t.contacts.flags[c] |= ContactFlag::sensor;
    t.contacts.flags[c] |= ContactFlag::enabled;
    const Material& ma = t.fixtures.material[a];
    const Material& mb = t.fixtures.material[b];
    t.contacts.material[c] = {MixFriction(ma.friction, mb.friction), MixRestitution(ma.restitution, mb.restitution),
                              MixRestitutionThreshold(ma.restitutionThreshold, mb.restitutionThreshold), 0.0f};
}

}  // namespace

bool MayHaveContact(int fixtureA, int fixtureB, const ContactEvents& events, MatchTables t) {
    const int bodyA = t.fixtures.body[static_cast<size_t>(fixtureA)];
    const int bodyB = t.fixtures.body[static_cast<size_t>(fixtureB)];
    if (!t.joints.MayCollide(bodyA, bodyB)) return false;
    return events.filter->ShouldCollide(&t.fixtures.handles[static_cast<size_t>(fixtureA)],
                                        &t.fixtures.handles[static_cast<size_t>(fixtureB)]);
}

void MatchContacts(std::span<const Pair> pairs, const ContactEvents& events, MatchTables t) {
    for (uint8_t& flags : t.contacts.flags) flags = static_cast<uint8_t>(flags & ~ContactFlag::marked);
    for (const Pair& pair : pairs) {
        const int contact = t.contacts.Find(pair.a, pair.b);
        if (contact >= 0) {
            t.contacts.flags[static_cast<size_t>(contact)] |= ContactFlag::marked;
        } else if (MayHaveContact(static_cast<int>(pair.a), static_cast<int>(pair.b), events, t)) {
            CreateContact(static_cast<int>(pair.a), static_cast<int>(pair.b), t);
        }
    }
    for (int c = 0; c < t.contacts.Size(); ++c) {
        constexpr uint8_t kept = ContactFlag::marked | ContactFlag::touching;
        if (t.contacts.Has(c, ContactFlag::alive) && !t.contacts.Has(c, kept)) t.contacts.Remove(c);
    }
    t.contacts.Compact();
}

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

void RemoveContacts(const ContactEvents& events, MatchTables t) {
    for (int c = 0; c < t.contacts.Size(); ++c) {
        if (t.contacts.Has(c, ContactFlag::alive) && !t.contacts.Has(c, ContactFlag::marked)) {
            DestroyContact(c, events, t.bodies, t.contacts);
        }
    }
}

}  // namespace scree
