// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Mark, match, sweep (the dissertation, §4.2.2). Contacts that were not touching are swept at once; those that were
// wait for the next step, in which their EndContact is due.

#include "pipeline/match_contacts.h"

#include <algorithm>

#include "pipeline/parts/make_contact.h"

namespace scree {

namespace {

/// Marks the contacts of the pairs; those that have none and may get one go to `fresh`. Follows the order of the last
/// call and asks the hash where the pairs leave it: a pair that is gone or new is one such place.
void MarkPairs(std::span<const Pair> pairs, const ContactEvents& events, MatchTables t, std::vector<uint64_t>& fresh) {
    ContactTable& contacts = t.contacts;
    int* follower = &contacts.firstMatched;
    for (const Pair& pair : pairs) {
        int contact = *follower;
        if (!contacts.IsRowOf(contact, pair.a, pair.b)) contact = contacts.Find(pair.a, pair.b);
        if (contact >= 0) {
            contacts.flags[static_cast<size_t>(contact)] |= ContactFlag::marked;
            *follower = contact;
            follower = &contacts.successor[static_cast<size_t>(contact)];
        } else if (events.filter != nullptr ||
                   MayHaveContact(static_cast<int>(pair.a), static_cast<int>(pair.b), events, t.fixtures, t.joints)) {
            fresh.push_back(static_cast<uint64_t>(pair.b) << 32 | pair.a);
        }
    }
}

}  // namespace

void MatchContacts(std::span<const Pair> pairs, FreshOrder order, const ContactEvents& events, MatchTables t) {
    std::vector<uint64_t>& fresh = t.contacts.freshPairs;
    fresh.clear();
    t.contacts.ClearMarks();
    MarkPairs(pairs, events, t, fresh);
    // By index, so that callbacks and rows do not depend on the broad phase.
    std::sort(fresh.begin(), fresh.end());
    if (order == FreshOrder::newestFirst) std::reverse(fresh.begin(), fresh.end());
    t.contacts.Reserve(fresh.size());
    for (const uint64_t key : fresh) {
        const int a = static_cast<int>(key & 0xFFFFFFFFu);
        const int b = static_cast<int>(key >> 32);
        if (events.filter == nullptr || MayHaveContact(a, b, events, t.fixtures, t.joints)) {
            MakeContact(a, b, t.fixtures, t.contacts);
        }
    }
    t.contacts.RemoveParted();
    t.contacts.Compact();
}

}  // namespace scree
