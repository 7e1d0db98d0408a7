// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The proxies of a broad phase as dense arrays: movers (kinematic and dynamic) that may move, movers that rest,
// statics. Edits keep the parts dense by moving at most three proxies, so every algorithm can walk a part, or
// neighbouring ones, as one range of slots.

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "broad_phase/fixture_table.h"
#include "broad_phase/pair_sink.h"

namespace scree::broadphase {

/// A range [first, first + count) of slots.
struct SlotRange {
    uint32_t first = 0, count = 0;
};

/// Of a proxy that has no place yet.
inline constexpr uint32_t noPlace = 0xFFFFFFFFu;

class ProxyStore {
public:
    [[nodiscard]] uint32_t Size() const { return static_cast<uint32_t>(m_boxes.size()); }
    [[nodiscard]] uint32_t MoverCount() const { return m_moverCount; }
    [[nodiscard]] uint32_t StaticCount() const { return Size() - m_moverCount; }
    [[nodiscard]] SlotRange Movers() const { return {0, m_moverCount}; }
    /// The movers that do not rest, and all that does.
    [[nodiscard]] SlotRange Moving() const { return {0, m_movingCount}; }
    [[nodiscard]] SlotRange Resting() const { return {m_movingCount, Size() - m_movingCount}; }
    [[nodiscard]] SlotRange Statics() const { return {m_moverCount, StaticCount()}; }
    [[nodiscard]] SlotRange All() const { return {0, Size()}; }
    [[nodiscard]] bool IsStatic(uint32_t slot) const { return slot >= m_moverCount; }
    [[nodiscard]] bool IsResting(uint32_t slot) const { return slot >= m_movingCount; }

    /// The slot of a fixture, noSlot if it is not here.
    [[nodiscard]] uint32_t Find(uint32_t fixture) const { return m_table.Find(fixture); }
    [[nodiscard]] const AABB* Boxes() const { return m_boxes.data(); }
    [[nodiscard]] const ItemId* Ids() const { return m_ids.data(); }
    [[nodiscard]] const AABB& Box(uint32_t slot) const { return m_boxes[slot]; }
    [[nodiscard]] ItemId Id(uint32_t slot) const { return m_ids[slot]; }
    /// A free field for the algorithm, moved along with the proxy; noPlace at first.
    [[nodiscard]] uint32_t& Place(uint32_t slot) { return m_places[slot]; }
    [[nodiscard]] uint32_t Place(uint32_t slot) const { return m_places[slot]; }

    /// Returns the slot. A mover does not rest at first.
    uint32_t Insert(uint32_t fixture, uint32_t body, Motion motion, const AABB& box);
    /// Lets a mover rest, or rouses it. Returns its new slot.
    uint32_t SetResting(uint32_t slot, bool resting);
    void SetBox(uint32_t slot, const AABB& box) { m_boxes[slot] = box; }
    void Remove(uint32_t slot);

    [[nodiscard]] size_t GetMemoryBytes() const;

private:
    void Move(uint32_t from, uint32_t to);
    void Swap(uint32_t slot1, uint32_t slot2);

    std::vector<AABB> m_boxes;
    std::vector<ItemId> m_ids;
    std::vector<uint32_t> m_places;
    FixtureTable m_table;
    uint32_t m_movingCount = 0, m_moverCount = 0;
};

}  // namespace scree::broadphase
