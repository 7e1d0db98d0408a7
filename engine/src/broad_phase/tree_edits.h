// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Keeps a tree true to the proxies of its part while these are edited. What leaves the tree or gets another box dies in
// it: its position keeps a box that overlaps nothing. What is new, or has another box, is outside: in a short list that
// searches go through beside the tree. When there have been more than a few √n edits, the tree is lost and the next
// search rebuilds it. So n edits interleaved with n queries cost O(n^1.5), not O(n²) (Tsamis 2020, §3.7.2).

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/task_pool.h"
#include "broad_phase/flat_tree.h"
#include "broad_phase/proxy_store.h"

namespace scree::broadphase {

class TreeEdits {
public:
    TreeEdits(ProxyStore& store, FlatTree& tree) : m_store(store), m_tree(tree) {}

    /// The boxes of the tree are not those of its proxies.
    [[nodiscard]] bool IsStale() const { return m_state != State::current; }
    /// Nor are they told by what is outside: the tree is of no use any more.
    [[nodiscard]] bool IsLost() const { return m_state == State::lost; }
    /// Edits since the tree was built.
    [[nodiscard]] uint32_t Count() const { return m_count; }
    /// Fixtures of the part that the tree does not have; none if it is lost.
    [[nodiscard]] std::span<const uint32_t> Outside() const { return m_outside; }

    /// The proxy in this slot is new to the part.
    void Add(uint32_t slot);
    /// It leaves the part.
    void Leave(uint32_t slot);
    /// It has a new box.
    void Change(uint32_t slot);
    /// Many have, and the tree will be given them by NoteRefitted or NoteBuilt.
    void NoteMoved() {
        if (m_state == State::current) m_state = State::moved;
    }
    /// The tree has the present boxes of those of its proxies that are alive in it.
    void NoteRefitted() { m_state = State::current; }
    /// It has those of all proxies of the part. The pool may be null.
    void NoteBuilt(TaskPool* pool);
    void Lose();

    [[nodiscard]] size_t GetMemoryBytes() const { return m_outside.capacity() * sizeof(uint32_t); }

private:
    enum class State : uint8_t { current, moved, lost };

    void CountOne();
    void PutOutside(uint32_t slot);
    void TakeOut(uint32_t slot);

    ProxyStore& m_store;
    FlatTree& m_tree;
    std::vector<uint32_t> m_outside;
    uint32_t m_count = 0;
    uint32_t m_limit = 0;
    State m_state = State::lost;
};

}  // namespace scree::broadphase
