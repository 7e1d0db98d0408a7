// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The order of the parts: boxes, pairs, contacts.

#include "pipeline/find_pairs.h"

#include <algorithm>

#include "pipeline/parts/rouse.h"

namespace scree {

namespace {

/// Edited fixtures that are queried one by one; more, for their share of the bodies, join one search if nothing rests.
constexpr size_t fewEdits = 8, listedPerEdit = 32;

MatchTables ForMatching(PairTables t) { return {t.pool, t.bodies, t.fixtures, t.joints, t.contacts}; }

/// The pair rule of the broad phase.
bool MayPair(const BodyTable& bodies, BodyIndex bodyA, BodyIndex bodyB) {
    const auto isDynamic = [&](BodyIndex body) { return bodies.type[body] == dynamicBody; };
    return bodyA != bodyB && (isDynamic(bodyA) || isDynamic(bodyB));
}

/// Appends the pairs of the edited fixtures.
void QueryEdited(const EditedProxies& edited, PairTables t, std::vector<Pair>& pairs) {
    t.broadPhase.PrepareQueries();
    for (const FixtureIndex fixture : edited.Fixtures()) {
        if (!t.fixtures.slots.IsAlive(fixture) || !t.fixtures.info[fixture].inBroadPhase) continue;
        const BodyIndex body = t.fixtures.body[fixture];
        const uint32_t proxy = ProxyOf(fixture);
        t.broadPhase.Query(t.broadPhase.GetBox(proxy), [&](uint32_t other) {
            if (MayPair(t.bodies, body, t.fixtures.body[FixtureOf(other)]))
                pairs.push_back({std::min(proxy, other), std::max(proxy, other)});
            return true;
        });
    }
}

}  // namespace

void FindPairsOfEdited(EditedProxies& edited, const ContactEvents& events, PairTables t) {
    std::vector<Pair>& pairs = t.editedPairs;
    pairs.clear();
    if (!edited.AreAll() && edited.Fixtures().empty()) return t.contacts.Compact();
    const bool areAllListed = t.bodies.AreAllListed();
    const size_t most = fewEdits + ToSize(t.bodies.listedRows.Count()) / listedPerEdit;
    // A search among listed bodies tells nothing of edited ones that rest.
    const bool searches = edited.AreAll() || (areAllListed && edited.Fixtures().size() > most);
    if (searches) {
        RouseProxies(t.bodies, t.fixtures, t.broadPhase);
        t.broadPhase.FindPairs(pairs);
    }
    const bool reachesAll = searches && areAllListed;
    if (!reachesAll) QueryEdited(edited, t, pairs);
    const bool nothingBegins = pairs.empty() && events.filter == nullptr;
    if (nothingBegins && t.contacts.active.IsEmpty()) {  // nor ends: contacts of what was edited are active
        t.contacts.Compact();
    } else {
        const Searched searched{.all = reachesAll, .listed = searches, .edited = &edited.Rows()};
        t.contacts.addsFresh = true;
        MatchContacts(pairs, searched, FreshOrder::oldestFirst, events, ForMatching(t));
        t.contacts.addsFresh = false;
    }
    edited.Clear();
}

void FindPairsOfMoved(const MovedLists& solved, float farDistance, const ContactEvents& events, PairTables t) {
    if (t.bodies.Listed().empty()) return t.contacts.Compact();  // no box has changed since pairs were found
    RouseContacts(t.bodies, t.contacts);                         // of what an impact has woken
    RouseProxies(t.bodies, t.fixtures, t.broadPhase);
    const float farthest = UpdateMovedBoxes(t.bodies, t.fixtures, solved, t.pool, t.broadPhase);
    if (farthest > farDistance) t.bodies.EnsureRests();
    if (!t.contacts.mustMatch && !t.broadPhase.HasChanged()) {
        t.contacts.Compact();
        return;
    }
    t.broadPhase.FindPairs(t.pairs);
    const Searched searched{.all = t.bodies.AreAllListed(), .listed = true};
    MatchContacts(t.pairs, searched, FreshOrder::newestFirst, events, ForMatching(t));
}

}  // namespace scree
