// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Sets of numbers that several threads join at once (union-find). The lowest number of a set stands for it, so the sets
// are the same whoever joined first. Sources: Anderson, Woll, "Wait-free Parallel Algorithms for the Union-Find
// Problem", STOC 1991. Paths are halved: Tarjan, van Leeuwen, "Worst-case Analysis of Set Union Algorithms", J. ACM 31,
// 1984.

#pragma once

#include <utility>

#include "base/bytes.h"
#include "base/index.h"
#include "base/shared_count.h"
#include "base/slots.h"

namespace scree {

template <TypedIndex I>
class JoinedSets {
public:
    void Reserve(size_t count) { EnsureRows(m_parent, count); }
    /// A set of its own.
    void Begin(I number) { m_parent[number] = ToInt(number); }
    /// The lowest number of its set.
    [[nodiscard]] I Find(I number) {
        int at = ToInt(number);
        for (int parent = Load(at); parent != at; at = parent, parent = Load(at)) {
            const int next = Load(parent);
            // Whoever else changed it meanwhile made the way shorter, too.
            if (next != parent) (void)ReplaceShared(m_parent[I{at}], parent, next);
        }
        return I{at};
    }
    void Join(I one, I other) {
        for (;;) {
            I low = Find(one), high = Find(other);
            if (low == high) return;
            if (high < low) std::swap(low, high);
            if (ReplaceShared(m_parent[high], ToInt(high), ToInt(low))) return;
        }
    }
    [[nodiscard]] size_t GetMemoryBytes() const { return m_parent.capacity() * sizeof(int); }
    void MatchRoomOf(const JoinedSets& other) { MatchRoom(m_parent, other.m_parent); }

private:
    [[nodiscard]] int Load(int at) { return LoadShared(m_parent[I{at}]); }

    Column<I, int> m_parent;
};

}  // namespace scree
