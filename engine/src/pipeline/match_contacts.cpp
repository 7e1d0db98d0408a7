// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Mark, match, sweep (the dissertation, §4.2.2). Contacts that were not touching are swept at once; those that were
// wait for the next step, in which their EndContact is due.

#include "pipeline/match_contacts.h"

#include <algorithm>

#include "pipeline/parts/make_contact.h"

namespace scree {

void MatchContacts(std::span<const Pair> pairs, const ContactEvents& events, MatchTables t) {
    for (uint8_t& flags : t.contacts.flags) flags = static_cast<uint8_t>(flags & ~ContactFlag::marked);
    std::vector<uint64_t>& fresh = t.contacts.freshPairs;
    fresh.clear();
    for (const Pair& pair : pairs) {
        const int contact = t.contacts.Find(pair.a, pair.b);
        if (contact >= 0) {
            t.contacts.flags[static_cast<size_t>(contact)] |= ContactFlag::marked;
        } else {
            fresh.push_back(static_cast<uint64_t>(pair.b) << 32 | pair.a);
        }
    }
    // By index, as they come when fixtures are added one by one: callbacks and rows do not depend on the broad phase.
    std::sort(fresh.begin(), fresh.end());
    for (const uint64_t key : fresh) {
        const int a = static_cast<int>(key & 0xFFFFFFFFu);
        const int b = static_cast<int>(key >> 32);
        if (MayHaveContact(a, b, events, t.fixtures, t.joints)) MakeContact(a, b, t.fixtures, t.contacts);
    }
    for (int c = 0; c < t.contacts.Size(); ++c) {
        constexpr uint8_t kept = ContactFlag::marked | ContactFlag::touching;
        if (t.contacts.Has(c, ContactFlag::alive) && !t.contacts.Has(c, kept)) t.contacts.Remove(c);
    }
    t.contacts.Compact();
}

}  // namespace scree
