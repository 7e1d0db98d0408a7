// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the soft step needs to know of islands: who wakes, and who may fall asleep together. It solves all that is awake
// at once, so it needs no lists of the contacts of each.

#pragma once

#include <cstdint>
#include <vector>

#include "base/bytes.h"
#include "base/joined_sets.h"
#include "base/task_pool.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/islands.h"
#include "state/joints.h"

namespace scree {

/// Scratch, kept between steps.
struct SleepyScratch {
    std::vector<ContactIndex> rows;  ///< of contacts whose sleepers wake, and later of those that come to rest
    std::vector<BodyIndex> woken;
    std::vector<BodyIndex> sleepy;         ///< may fall asleep in this step
    JoinedSets<BodyIndex> sets;            ///< of these
    Column<BodyIndex, uint8_t> isKept;     ///< per sleepy body: somebody who is not touches it or is joined to it
    Column<BodyIndex, uint8_t> isSetKept;  ///< the same of a set, by its first body

    [[nodiscard]] size_t GetMemoryBytes() const {
        return BytesOf(rows, woken, sleepy, isKept, isSetKept) + sets.GetMemoryBytes();
    }
};

/// Wakes sleepers that awake bodies touch or are joined to, and those that touch these or are joined to them, and so
/// on. Their sleep timers keep running. O(contacts that do not rest + joints) if somebody sleeps, else O(movers).
void WakeReached(ContactTable& contacts, const JointTable& joints, TaskPool& pool, BodyTable& bodies,
                 SleepyScratch& scratch);

/// Lists the islands all of whose bodies may fall asleep within `dt`, without their contacts and joints. `active`: what
/// is awake, after WakeReached. O(movers) if nobody may, else O(contacts + joints + movers).
void FindSleepyIslands(const IslandTable& active, const ContactTable& contacts, const JointTable& joints,
                       TaskPool& pool, const BodyTable& bodies, float dt, SleepyScratch& scratch, IslandTable& islands);

}  // namespace scree
