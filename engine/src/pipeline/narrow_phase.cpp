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

/// How many rows ahead the shapes, poses and the manifold of a contact are fetched, and its pair before them.
constexpr int fetchAhead = 4, fetchPairAhead = 12;

/// Asks for what the update of a coming row reads; rows of neighbours are in memory anywhere.
void Fetch(int contact, const NarrowPhaseTables& t) {
    if (contact < fetchPairAhead) return;
    __builtin_prefetch(&t.contacts.pair[static_cast<size_t>(contact - fetchPairAhead)]);
    const auto next = static_cast<size_t>(contact - fetchAhead);
    const ContactPair& pair = t.contacts.pair[next];
    __builtin_prefetch(&t.contacts.manifold[next], 1);
    __builtin_prefetch(&t.bodies.transform[static_cast<size_t>(pair.bodyA)]);
    __builtin_prefetch(&t.bodies.transform[static_cast<size_t>(pair.bodyB)]);
    __builtin_prefetch(t.fixtures.shape[pair.fixtureA]);
    __builtin_prefetch(t.fixtures.shape[pair.fixtureB]);
}

bool IsActive(int contact, const NarrowPhaseTables& t) {
    const ContactPair& pair = t.contacts.pair[static_cast<size_t>(contact)];
    return t.bodies.IsActive(pair.bodyA) || t.bodies.IsActive(pair.bodyB);
}

/// Below this many contacts the manifolds are not worth waking workers for.
constexpr int leastContacts = 128;

/// Computes the manifolds that are sure to be wanted. Bodies that wake on the way may add some, which follow in order.
void ComputeAhead(const NarrowPhaseTables& t, TOIStats& work, std::vector<uint8_t>& findings) {
    findings.assign(static_cast<size_t>(t.contacts.Size()), NarrowPhaseScratch::nothing);
    t.pool.For(t.contacts.Size(), leastContacts, [&](int begin, int end, int) {
        for (int contact = end; contact-- > begin;) {
            Fetch(contact, t);
            constexpr uint8_t sure = ContactFlag::alive | ContactFlag::marked;
            const auto c = static_cast<size_t>(contact);
            if ((t.contacts.flags[c] & (sure | ContactFlag::refilter)) != sure || !IsActive(contact, t)) continue;
            const bool touches = ComputeManifold(contact, t.fixtures, t.bodies, work, t.contacts);
            findings[c] = touches ? NarrowPhaseScratch::touching : NarrowPhaseScratch::apart;
        }
    });
}

}  // namespace

int UpdateManifolds(const ContactEvents& events, NarrowPhaseTables t, NarrowPhaseScratch& scratch) {
    const bool ahead = events.listener == nullptr && t.pool.GetWorkerCount() > 1 && t.contacts.Size() >= leastContacts;
    if (ahead) ComputeAhead(t, *events.work, scratch.findings);
    int touchingCount = 0;
    for (int contact = t.contacts.Size(); contact-- > 0;) {
        if (!ahead) Fetch(contact, t);
        if (!t.contacts.Has(contact, ContactFlag::alive)) continue;
        if (!Stays(contact, events, t)) {
            DestroyContact(contact, events, t.bodies, t.contacts);
            continue;
        }
        uint8_t finding = NarrowPhaseScratch::nothing;
        if (ahead) finding = scratch.findings[static_cast<size_t>(contact)];
        bool touching = finding == NarrowPhaseScratch::touching;
        if (finding != NarrowPhaseScratch::nothing) {
            NoteTouching(contact, touching, t.bodies, t.contacts);
        } else {
            touching = IsActive(contact, t) ? UpdateContact(contact, t.fixtures, events, t.bodies, t.contacts)
                                            : t.contacts.Has(contact, ContactFlag::touching);
        }
        if (touching) ++touchingCount;
    }
    return touchingCount;
}

}  // namespace scree
