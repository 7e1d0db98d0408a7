// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The order of the parts: boxes, pairs, contacts.

#include "pipeline/find_pairs.h"

#include "pipeline/parts/update_boxes.h"

namespace scree {

void FindPairs(FreshOrder order, const ContactEvents& events, PairTables t) {
    t.broadPhase.FindPairs(t.pairs);
    MatchContacts(t.pairs, order, events, {t.pool, t.bodies, t.fixtures, t.joints, t.contacts});
}

void FindPairsOfMoved(std::initializer_list<const std::vector<int>*> solved, float farDistance,
                      const ContactEvents& events, PairTables t) {
    if (t.bodies.Listed().empty()) return;  // no box has changed since pairs were found
    const float farthest = UpdateMovedBoxes(t.bodies, t.fixtures, solved, t.broadPhase);
    if (farthest > farDistance) t.bodies.EnsureRests();
    FindPairs(FreshOrder::newestFirst, events, t);
}

}  // namespace scree
