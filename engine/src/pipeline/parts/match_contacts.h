// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Part of the stage that finds pairs: marks the contact of every pair or makes one. Contacts left unmarked have parted.
// Those that did not touch go at once. Those that did are removed by the narrow phase of the next step, where Box2D
// reports their EndContact.

#pragma once

#include <span>
#include <vector>

#include "base/task_pool.h"
#include "broad_phase/broad_phase.h"
#include "pipeline/contact_events.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/fixtures.h"
#include "state/joints.h"

namespace scree {

struct MatchTables {
    TaskPool& pool;
    BodyTable& bodies;
    FixtureTable& fixtures;
    JointTable& joints;
    ContactTable& contacts;
};

/// The order in which new contacts are made, by fixture index. Events and solving go through contacts newest first, so
/// this order shows. It is Box2D's: proxies of edits are matched as they came, after a step those of the newest body
/// first.
enum class FreshOrder : uint8_t { oldestFirst, newestFirst };

/// Which pairs a search has found if there are such: all, or those with a listed body or an edited fixture. The others
/// have neither begun nor parted.
struct Searched {
    bool all = false;
    bool listed = false;                                    ///< those of listed bodies
    const Column<FixtureIndex, uint8_t>* edited = nullptr;  ///< per fixture, rows may be missing; null: none
};

/// Marks, creates, sweeps; pairs may come twice. Contacts of bodies that joints or filters keep apart are not made.
void MatchContacts(std::span<const Pair> pairs, const Searched& searched, FreshOrder order, const ContactEvents& events,
                   MatchTables tables);

}  // namespace scree
