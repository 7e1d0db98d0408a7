// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Stage: boxes of what moved → pairs of fixtures whose boxes overlap → contacts.

#pragma once

#include <initializer_list>
#include <vector>

#include "base/task_pool.h"
#include "broad_phase/broad_phase.h"
#include "pipeline/contact_events.h"
#include "pipeline/parts/match_contacts.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/fixtures.h"
#include "state/joints.h"

namespace scree {

struct PairTables {
    TaskPool& pool;
    BodyTable& bodies;
    FixtureTable& fixtures;
    JointTable& joints;
    ContactTable& contacts;
    BroadPhase& broadPhase;
    std::vector<Pair>& pairs;  ///< of the last call
};

/// Finds all pairs of the stored boxes and marks or makes their contacts.
void FindPairs(FreshOrder order, const ContactEvents& events, PairTables tables);

/// The same at the end of a step, after the boxes of the bodies that moved in it: the active ones, and those of the
/// lists `solved` that fell asleep. A centre farther out than `farDistance`, m, makes positions have rests.
void FindPairsOfMoved(std::initializer_list<const std::vector<int>*> solved, float farDistance,
                      const ContactEvents& events, PairTables tables);

}  // namespace scree
