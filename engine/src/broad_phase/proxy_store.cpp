// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Insertion and removal in the two-part dense proxy arrays, O(1).

#include "broad_phase/proxy_store.h"

#include "base/slots.h"

namespace scree::broadphase {

void ProxyStore::Move(uint32_t from, uint32_t to) {
    if (from == to) return;
    m_boxes[to] = m_boxes[from];
    m_ids[to] = m_ids[from];
    m_pending[to] = m_pending[from];
    m_table.Set(m_ids[to].fixture, to);
}

uint32_t ProxyStore::Insert(uint32_t fixture, uint32_t body, Motion motion, const AABB& box) {
    uint32_t slot = Size();
    // When memory runs out nothing has changed yet.
    ReserveRows(m_boxes.size() + 1, m_boxes, m_ids, m_pending);
    m_table.Set(fixture, motion == Motion::isStatic ? slot : m_moverCount);
    m_boxes.emplace_back();
    m_ids.emplace_back();
    m_pending.emplace_back();
    if (motion != Motion::isStatic) {
        // The first static makes room at the border of the two parts.
        Move(m_moverCount, slot);
        slot = m_moverCount++;
    }
    m_boxes[slot] = box;
    m_ids[slot] = {fixture, GroupOf(body, motion)};
    m_pending[slot] = notPending;
    return slot;
}

void ProxyStore::Remove(uint32_t slot) {
    m_table.Erase(m_ids[slot].fixture);
    if (slot < m_moverCount) {
        --m_moverCount;
        Move(m_moverCount, slot);
        slot = m_moverCount;
    }
    Move(Size() - 1, slot);
    m_boxes.pop_back();
    m_ids.pop_back();
    m_pending.pop_back();
}

size_t ProxyStore::GetMemoryBytes() const {
    return m_boxes.capacity() * sizeof(AABB) + m_ids.capacity() * sizeof(ItemId) +
           m_pending.capacity() * sizeof(uint32_t) + m_table.GetMemoryBytes();
}

}  // namespace scree::broadphase
