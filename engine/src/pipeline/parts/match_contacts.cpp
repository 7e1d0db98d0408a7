// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Mark, match, sweep (the dissertation, §4.2.2). Contacts that were not touching are swept at once; those that were
// wait for the next step, in which their EndContact is due.

#include "pipeline/parts/match_contacts.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/compiler.h"
#include "base/gather_parts.h"
#include "base/shared_count.h"
#include "pipeline/parts/make_contact.h"

namespace scree {

namespace {

/// Below this many pairs their contacts are not worth looking for on several threads.
constexpr int leastPairsToShare = 1024;

/// Whether the filters of all pairs that have contacts still let them meet.
bool FiltersAgree(const FixtureTable& fixtures, const ContactTable& contacts) {
    for (const ContactIndex contact : contacts.Rows()) {
        const ContactPair& p = contacts.pair[contact];
        if (contacts.IsAlive(contact) && !ShouldCollide(fixtures.filter[p.fixtureA], fixtures.filter[p.fixtureB]))
            return false;
    }
    return true;
}

/// In a list of contacts: filters refuse the pair.
constexpr ContactIndex refusedPair{-2};

/// Finds the contact of each pair; below 0: it has none. Follows the order of the last full matching and asks the hash
/// where the pairs leave it. A pair that is gone or new is one such place, the start of a worker's range another.
/// `filters`, if not null, tell of pairs that they have none: limbs of ragdolls overlap all the time.
void FindContacts(std::span<const Pair> pairs, TaskPool& pool, const Column<FixtureIndex, Filter>* filters,
                  ContactTable& contacts) {
    EnsureRows(contacts.matched, pairs.size());
    const std::span<const ContactIndex> order = contacts.order;
    pool.For(static_cast<int>(pairs.size()), leastPairsToShare, [&](int begin, int end, int /*worker*/) {
        size_t next = order.size() * ToSize(begin) / std::max<size_t>(pairs.size(), 1);
        for (size_t i = ToSize(begin); i < ToSize(end); ++i) {
            const FixtureIndex a = FixtureOf(pairs[i].a), b = FixtureOf(pairs[i].b);
            ContactIndex contact = next < order.size() ? order[next] : ContactIndex::none;
            if (contacts.IsRowOf(contact, a, b)) {
                ++next;
            } else {
                const bool hadNone = IsNone(contact);
                const bool isRefused = filters != nullptr && !ShouldCollide((*filters)[a], (*filters)[b]);
                contact = isRefused ? refusedPair : contacts.Find(a, b);
                const size_t place = IsSome(contact) ? ToSize(LoadShared(contacts.place[contact])) : order.size();
                if (place < order.size() && order[place] == contact) {
                    next = place + 1;
                } else if (hadNone) {
                    ++next;
                }
            }
            contacts.matched[i] = contact;
            if (IsSome(contact)) StoreShared(contacts.place[contact], static_cast<int>(i));  // a pair may come twice
        }
    });
}

/// Marks the contacts of the pairs; those that have none and may get one go to `fresh`. That comes after finding, which
/// reads flags of rows that other workers mark.
void MarkPairs(std::span<const Pair> pairs, const ContactEvents& events, MatchTables t, std::vector<uint64_t>& fresh) {
    const std::vector<ContactIndex>& found = t.contacts.matched;
    const bool areDefault = events.filter == nullptr;
    if (areDefault && !t.contacts.filtersAgree) t.contacts.filtersAgree = FiltersAgree(t.fixtures, t.contacts);
    const bool asksFilters = areDefault && t.contacts.filtersAgree;
    FindContacts(pairs, t.pool, asksFilters ? &t.fixtures.filter : nullptr, t.contacts);
    const auto mayBegin = [&](const Pair& pair) {
        return events.filter != nullptr ||
               MayHaveContact(FixtureOf(pair.a), FixtureOf(pair.b), events, t.fixtures, t.joints);
    };
    const auto mark = [&](int begin, int end, const std::array<int*, 1>& places) {
        int* missing = places[0];
        for (int i = begin; i < end; ++i) {
            if (const ContactIndex contact = found[ToSize(i)]; IsSome(contact)) {
                SetSharedBits(t.contacts.flags[contact], ContactFlag::marked);
            } else if (contact != refusedPair && mayBegin(pairs[ToSize(i)])) {
                *missing++ = i;
            }
        }
        return std::array{static_cast<size_t>(missing - places[0])};
    };
    const auto [count] =
        WriteParts<int, 1>(t.pool, static_cast<int>(pairs.size()), leastPairsToShare, {&t.contacts.missing}, mark);
    for (const int i : std::span(t.contacts.missing).first(count))
        fresh.push_back(static_cast<uint64_t>(pairs[ToSize(i)].b) << 32 | pairs[ToSize(i)].a);
}

/// Whether joints and the program's filter let the pair have a contact. What
/// the filter refuses is noted.
bool AskAbout(FixtureIndex a, FixtureIndex b, uint64_t key, const ContactEvents& events, MatchTables t) {
    if (!t.joints.MayCollide(t.fixtures.body[a], t.fixtures.body[b])) return false;
    if (MayHaveContact(a, b, events, t.fixtures, t.joints)) return true;
    t.contacts.freshRefusals.push_back(key);
    return false;
}

/// Asks for what making a coming contact reads: rows of fixtures and a place of the hash, which are in memory anywhere.
void FetchForContact(uint64_t key, const MatchTables& t) {
    const FixtureIndex a = RefusedPairs::LowOf(key), b = RefusedPairs::HighOf(key);
    for (const FixtureIndex fixture : {a, b}) {
        Prefetch(&t.fixtures.body[fixture]);
        Prefetch(&t.fixtures.material[fixture]);
    }
    t.contacts.FetchHome(a, b);
}

bool HasRow(const Column<FixtureIndex, uint8_t>* rows, FixtureIndex row) {
    return rows != nullptr && rows->Has(row) && (*rows)[row] != 0;
}

/// One of the bodies is.
bool IsListed(const BodyTable& bodies, const ContactPair& pair) {
    return bodies.isListed[pair.bodyA] != 0 || bodies.isListed[pair.bodyB] != 0;
}

bool IsSearched(const Searched& searched, const BodyTable& bodies, const ContactPair& pair) {
    if (searched.all) return true;
    if (HasRow(searched.edited, pair.fixtureA) || HasRow(searched.edited, pair.fixtureB)) return true;
    return searched.listed && IsListed(bodies, pair);
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
    if (searched.all || searched.listed) {
        std::swap(t.contacts.order, t.contacts.matched);
        t.contacts.order.resize(pairs.size());
    }
    // By index, so that callbacks and rows do not depend on the broad phase.
    std::sort(fresh.begin(), fresh.end());
    fresh.erase(std::unique(fresh.begin(), fresh.end()), fresh.end());
    const bool asks = events.filter != nullptr;
    if (asks) {
        t.contacts.refused.TakeOut(fresh, [&](FixtureIndex a, FixtureIndex b) {
            return IsSearched(searched, t.bodies, {a, b, t.fixtures.body[a], t.fixtures.body[b]});
        });
    }
    if (order == FreshOrder::newestFirst) std::reverse(fresh.begin(), fresh.end());
    t.contacts.Reserve(fresh.size());
    constexpr size_t fetchAhead = 8;
    for (size_t i = 0; i < fresh.size(); ++i) {
        const uint64_t key = fresh[i];
        if (i + fetchAhead < fresh.size()) FetchForContact(fresh[i + fetchAhead], t);
        const FixtureIndex a = RefusedPairs::LowOf(key), b = RefusedPairs::HighOf(key);
        if (asks && !AskAbout(a, b, key, events, t)) continue;
        const ContactIndex made = MakeContact(a, b, events, t.fixtures, t.contacts);
        if (IsNone(made) && asks) t.contacts.freshRefusals.push_back(key);
        if (IsSome(made) && !IsListed(t.bodies, t.contacts.pair[made])) t.contacts.mayRest = true;
    }
    t.contacts.refused.Add(t.contacts.freshRefusals);
    t.contacts.freshRefusals.clear();
    t.contacts.RemoveParted();
    t.contacts.Compact();
    if (searched.all || searched.listed) t.contacts.mustMatch = false;
}

}  // namespace scree
