// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Stage: touching contacts and joints → islands of awake bodies.

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/task_pool.h"
#include "pipeline/parts/island_memo.h"
#include "pipeline/parts/sleepy_islands.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/islands.h"
#include "state/joints.h"

namespace scree {

/// Scratch of the search, kept between steps to save allocation.
struct IslandScratch {
    /// How far the search is with a mover: whether it has contacts, whether it was put on the stack, and whether its
    /// contacts are listed.
    enum Progress : uint8_t { untouched, touched, seen, seenUntouched, visited };
    struct Entry {
        ContactIndex contact;
        BodyIndex other;  ///< the mover on the other side, −1 if that is static
        int next;         ///< the entry of the body's next older contact, 0: none
    };

    std::vector<ContactIndex> rows;       ///< of the solved contacts
    Column<BodyIndex, int> first;         ///< per mover: the entry of its newest contact, 0: none
    Column<BodyIndex, int> count;         ///< how many it has, where many workers list them
    std::vector<Entry> entries;           ///< contacts by body, from 1 on
    Column<BodyIndex, uint8_t> progress;  ///< per mover
    std::vector<ContactIndex> roused;     ///< contacts of one body that rested
    Column<JointIndex, uint8_t> jointSeen;
    std::vector<BodyIndex> seeds;  ///< awake bodies that are not isolated
    std::vector<BodyIndex> stack;
    IslandMemo memo;
    SleepyScratch sleepy;

    [[nodiscard]] size_t GetMemoryBytes() const {
        return (rows.capacity() + first.capacity() + count.capacity() + seeds.capacity() + stack.capacity() +
                roused.capacity()) *
                   sizeof(int) +
               entries.capacity() * sizeof(Entry) + progress.capacity() + jointSeen.capacity() + memo.GetMemoryBytes() +
               sleepy.GetMemoryBytes();
    }
};

/// Where bodies without contacts and joints go.
enum class IsolatedPath : uint8_t {
    apart,      ///< to the list of isolated bodies, which are integrated without a solver
    asIslands,  ///< among the others, for comparisons: same bits, more time
};

/// Depth-first search from every awake body (as Box2D does it: static bodies do not connect islands; sleeping bodies
/// that are reached wake up, their sleep timers keep running). O(contacts +
/// joints + movers); where nothing that matters has changed since the last search, its islands stay.
void FindIslands(const ContactTable& contacts, JointTable& joints, TaskPool& pool, BodyTable& bodies,
                 IslandScratch& scratch, IslandTable& islands, IsolatedPath path = IsolatedPath::apart);

/// The same lists without the search, and no islands: awake bodies, solved contacts and joints of theirs, by row.
void GatherActive(const ContactTable& contacts, const JointTable& joints, TaskPool& pool, const BodyTable& bodies,
                  IslandScratch& scratch, IslandTable& active, IsolatedPath path = IsolatedPath::apart);

}  // namespace scree
