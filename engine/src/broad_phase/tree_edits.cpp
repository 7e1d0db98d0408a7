// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The list of what is outside, and the deaths in the tree. The store keeps the place of each proxy: its position in the
// tree, or its index in the list.

#include "broad_phase/tree_edits.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "base/compiler.h"

namespace scree::broadphase {
namespace {

/// A scanned box costs about a fortieth of a rebuilt one, which makes √(40·n) edits per rebuild the cheapest.
uint32_t EditLimit(uint32_t proxies) {
    return std::max(64u, static_cast<uint32_t>(std::sqrt(40.0f * static_cast<float>(proxies))));
}

/// Marks the place of a proxy that is outside.
constexpr uint32_t outsideBit = 0x80000000u;

}  // namespace

void TreeEdits::Lose() {
    m_outside.clear();
    m_state = State::lost;
}

void TreeEdits::NoteBuilt(TaskPool* pool) {
    constexpr int leastPositions = 2048;
    const auto place = [&](int begin, int end, int /*worker*/) {
        for (auto position = static_cast<uint32_t>(begin); position < static_cast<uint32_t>(end); ++position) {
            m_store.Place(m_store.Find(m_tree.Ids()[position].fixture)) = position;
        }
    };
    const auto count = static_cast<int>(m_tree.Size());
    pool != nullptr ? pool->For(count, leastPositions, place) : place(0, count, 0);
    m_outside.clear();
    m_count = 0;
    m_limit = EditLimit(m_store.Size());
    m_state = State::current;
}

void TreeEdits::CountOne() {
    if (++m_count > m_limit) Lose();
}

void TreeEdits::PutOutside(uint32_t slot) {
    SCREE_TRY { m_outside.push_back(m_store.Id(slot).fixture); }
    SCREE_CATCH(const std::bad_alloc&) {
        return Lose();  // no room for the list: the tree is to be rebuilt
    }
    m_store.Place(slot) = outsideBit | static_cast<uint32_t>(m_outside.size() - 1);
}

void TreeEdits::TakeOut(uint32_t slot) {
    const uint32_t place = m_store.Place(slot);
    if ((place & outsideBit) == 0) return m_tree.Kill(place);
    const uint32_t at = place & ~outsideBit;
    m_outside[at] = m_outside.back();
    m_store.Place(m_store.Find(m_outside[at])) = outsideBit | at;
    m_outside.pop_back();
}

void TreeEdits::Add(uint32_t slot) {
    if (!IsLost()) CountOne();
    if (!IsLost()) PutOutside(slot);
}

void TreeEdits::Leave(uint32_t slot) {
    if (!IsLost()) CountOne();
    if (!IsLost()) TakeOut(slot);
}

void TreeEdits::Change(uint32_t slot) {
    if (IsStale() || (m_store.Place(slot) & outsideBit) != 0) return;
    CountOne();
    if (IsLost()) return;
    m_tree.Kill(m_store.Place(slot));
    PutOutside(slot);
}

}  // namespace scree::broadphase
