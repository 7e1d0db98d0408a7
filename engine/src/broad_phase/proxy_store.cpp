// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Insertion, removal and rest in the dense proxy arrays of three parts, O(1).

#include "broad_phase/proxy_store.h"

#include <utility>

#include "base/slots.h"

namespace scree::broadphase {

void ProxyStore::Move(uint32_t from, uint32_t to) {
    if (from == to) return;
    m_boxes[to] = m_boxes[from];
    m_ids[to] = m_ids[from];
    m_places[to] = m_places[from];
    m_table.Set(m_ids[to].fixture, to);
}

void ProxyStore::Swap(uint32_t slot1, uint32_t slot2) {
    if (slot1 == slot2) return;
    std::swap(m_boxes[slot1], m_boxes[slot2]);
    std::swap(m_ids[slot1], m_ids[slot2]);
    std::swap(m_places[slot1], m_places[slot2]);
    m_table.Set(m_ids[slot1].fixture, slot1);
    m_table.Set(m_ids[slot2].fixture, slot2);
}

uint32_t ProxyStore::Insert(uint32_t fixture, uint32_t body, Motion motion, const AABB& box) {
    uint32_t slot = Size();
    // When memory runs out nothing has changed yet.
    ReserveRows(m_boxes.size() + 1, m_boxes, m_ids, m_places);
    m_table.Set(fixture, motion == Motion::isStatic ? slot : m_movingCount);
    m_boxes.emplace_back();
    m_ids.emplace_back();
    m_places.emplace_back();
    if (motion != Motion::isStatic) {
        // The first proxy of either part behind makes room at its border.
        Move(m_moverCount, slot);
        Move(m_movingCount, m_moverCount++);
        slot = m_movingCount++;
    }
    m_boxes[slot] = box;
    m_ids[slot] = {fixture, GroupOf(body, motion)};
    m_places[slot] = noPlace;
    return slot;
}

uint32_t ProxyStore::SetResting(uint32_t slot, bool resting) {
    const uint32_t border = resting ? --m_movingCount : m_movingCount++;
    Swap(slot, border);
    return border;
}

void ProxyStore::Remove(uint32_t slot) {
    m_table.Erase(m_ids[slot].fixture);
    if (slot < m_movingCount) {
        --m_movingCount;
        Move(m_movingCount, slot);
        slot = m_movingCount;
    }
    if (slot < m_moverCount) {
        --m_moverCount;
        Move(m_moverCount, slot);
        slot = m_moverCount;
    }
    Move(Size() - 1, slot);
    m_boxes.pop_back();
    m_ids.pop_back();
    m_places.pop_back();
}

size_t ProxyStore::GetMemoryBytes() const {
    return m_boxes.capacity() * sizeof(AABB) + m_ids.capacity() * sizeof(ItemId) +
           m_places.capacity() * sizeof(uint32_t) + m_table.GetMemoryBytes();
}

}  // namespace scree::broadphase
