// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Mark, match, sweep (the dissertation, §4.2.2). Contacts that were not touching are swept at once; those that were
// wait for the next step, in which their EndContact is due.

#include "pipeline/parts/match_contacts.h"

#include <algorithm>

#include "pipeline/parts/make_contact.h"

namespace scree {

namespace {

/// Below this many pairs their contacts are not worth looking for on several threads.
constexpr int leastPairsToShare = 1024;

/// The contact of each pair, −1 if it has none. Follows the order of the last call and asks the hash where the pairs
/// leave it: a pair that is gone or new is one such place, the start of a worker's range another.
void FindContacts(std::span<const Pair> pairs, TaskPool& pool, ContactTable& contacts, std::vector<int>& found) {
    EnsureRows(found, pairs.size());
    pool.For(static_cast<int>(pairs.size()), leastPairsToShare, [&](int begin, int end, int /*worker*/) {
        int ownFirst = -1;
        int* follower = begin == 0 ? &contacts.firstMatched : &ownFirst;
        for (auto i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i) {
            int contact = *follower;
            if (!contacts.IsRowOf(contact, pairs[i].a, pairs[i].b)) contact = contacts.Find(pairs[i].a, pairs[i].b);
            found[i] = contact;
            if (contact < 0) continue;
            if (*follower != contact) *follower = contact;
            follower = &contacts.successor[static_cast<size_t>(contact)];
        }
    });
}

/// Marks the contacts of the pairs; those that have none and may get one go to `fresh`.
void MarkPairs(std::span<const Pair> pairs, const ContactEvents& events, MatchTables t, std::vector<uint64_t>& fresh) {
    std::vector<int>& found = t.contacts.matched;
    FindContacts(pairs, t.pool, t.contacts, found);
    for (size_t i = 0; i < pairs.size(); ++i) {
        const Pair pair = pairs[i];
        if (found[i] >= 0) {
            t.contacts.flags[static_cast<size_t>(found[i])] |= ContactFlag::marked;
        } else if (events.filter != nullptr ||
                   MayHaveContact(static_cast<int>(pair.a), static_cast<int>(pair.b), events, t.fixtures, t.joints)) {
            fresh.push_back(static_cast<uint64_t>(pair.b) << 32 | pair.a);
        }
    }
}

/// Whether joints and the program's filter let the pair have a contact. What
/// the filter refuses is noted.
bool AskAbout(int a, int b, uint64_t key, const ContactEvents& events, MatchTables t) {
    if (!t.joints.MayCollide(t.fixtures.body[static_cast<size_t>(a)], t.fixtures.body[static_cast<size_t>(b)]))
        return false;
    if (MayHaveContact(a, b, events, t.fixtures, t.joints)) return true;
    t.contacts.freshRefusals.push_back(key);
    return false;
}

bool HasRow(const std::vector<uint8_t>* rows, uint32_t row) {
    return rows != nullptr && row < rows->size() && (*rows)[row] != 0;
}

bool IsSearched(const Searched& searched, const BodyTable& bodies, const ContactPair& pair) {
    if (searched.all) return true;
    if (HasRow(searched.edited, pair.fixtureA) || HasRow(searched.edited, pair.fixtureB)) return true;
    const auto isListed = [&](int body) { return bodies.isListed[static_cast<size_t>(body)] != 0; };
    return searched.listed && (isListed(pair.bodyA) || isListed(pair.bodyB));
}

}  // namespace

void MatchContacts(std::span<const Pair> pairs, const Searched& searched, FreshOrder order, const ContactEvents& events,
                   MatchTables t) {
    std::vector<uint64_t>& fresh = t.contacts.freshPairs;
    fresh.clear();
    if (searched.all) {
        t.contacts.ClearMarks();
    } else {
        t.contacts.ClearMarksIf([&](const ContactPair& pair) { return IsSearched(searched, t.bodies, pair); });
    }
    MarkPairs(pairs, events, t, fresh);
    // By index, so that callbacks and rows do not depend on the broad phase.
    std::sort(fresh.begin(), fresh.end());
    fresh.erase(std::unique(fresh.begin(), fresh.end()), fresh.end());
    const bool asks = events.filter != nullptr;
    if (asks) {
        t.contacts.refused.TakeOut(fresh, [&](uint32_t a, uint32_t b) {
            return IsSearched(searched, t.bodies, {a, b, t.fixtures.body[a], t.fixtures.body[b]});
        });
    }
    if (order == FreshOrder::newestFirst) std::reverse(fresh.begin(), fresh.end());
    t.contacts.Reserve(fresh.size());
    for (const uint64_t key : fresh) {
        const int a = static_cast<int>(key & 0xFFFFFFFFu);
        const int b = static_cast<int>(key >> 32);
        if (asks && !AskAbout(a, b, key, events, t)) continue;
        if (MakeContact(a, b, events, t.fixtures, t.contacts) < 0 && asks) t.contacts.freshRefusals.push_back(key);
    }
    t.contacts.refused.Add(t.contacts.freshRefusals);
    t.contacts.freshRefusals.clear();
    t.contacts.RemoveParted();
    t.contacts.Compact();
    if (searched.all || searched.listed) t.contacts.mustMatch = false;
}

}  // namespace scree
