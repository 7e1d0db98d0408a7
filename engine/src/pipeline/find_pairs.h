// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Stage: boxes of what moved or was edited → pairs of fixtures whose boxes overlap → contacts.

#pragma once

#include <vector>

#include "base/task_pool.h"
#include "broad_phase/broad_phase.h"
#include "pipeline/contact_events.h"
#include "pipeline/parts/match_contacts.h"
#include "pipeline/parts/update_boxes.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/edited_proxies.h"
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
    std::vector<Pair>& pairs;        ///< of listed bodies, when they were found last
    std::vector<Pair>& editedPairs;  ///< of what was edited, likewise
};

/// After edits between steps: finds the pairs of what was edited, and marks or makes their contacts.
void FindPairsOfEdited(EditedProxies& edited, const ContactEvents& events, PairTables tables);

/// Finds the pairs of listed bodies if any box has changed. Called at the end of a step, after the boxes of the bodies
/// that moved in it are known. These are the active ones, and those of the lists `solved` that fell asleep. A centre
/// farther out than `farDistance`, m, makes positions have rests.
void FindPairsOfMoved(const MovedLists& solved, float farDistance, const ContactEvents& events, PairTables tables);

}  // namespace scree
