// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A binary min-heap of numbered items whose keys can change while they wait: the order of continuous-collision events
// (the dissertation, §6). Ties are decided by a second key, so the order never depends on the order of insertion.

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/bytes.h"

namespace scree {

class IndexedHeap {
public:
    void Clear() {
        m_items.clear();
        m_slotOf.clear();
    }
    [[nodiscard]] bool Empty() const { return m_items.empty(); }
    /// The item with the smallest key.
    [[nodiscard]] int Top() const { return m_items.front().id; }
    [[nodiscard]] float TopKey() const { return m_items.front().key; }

    /// Inserts item `id` or changes its key. O(log n).
    void Set(int id, float key, uint64_t tie) {
        if (!m_slotOf.Has(id)) m_slotOf.resize(ToSize(id) + 1, -1);
        int slot = m_slotOf[id];
        if (slot < 0) {
            slot = m_items.End();
            m_items.push_back({});
        }
        Place(slot, {key, id, tie});
        SiftDown(SiftUp(slot));
    }
    /// Takes item `id` out if it is in. O(log n).
    void Remove(int id) {
        if (!m_slotOf.Has(id) || m_slotOf[id] < 0) return;
        const int slot = m_slotOf[id];
        m_slotOf[id] = -1;
        const Item last = m_items.back();
        m_items.pop_back();
        if (slot == m_items.End()) return;
        Place(slot, last);
        SiftDown(SiftUp(slot));
    }

    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(m_items, m_slotOf); }

private:
    struct Item {
        float key;
        int id;
        uint64_t tie;
        [[nodiscard]] bool Before(const Item& other) const {
            return key < other.key || (key == other.key && tie < other.tie);
        }
    };

    void Place(int slot, const Item& item) {
        m_items[slot] = item;
        m_slotOf[item.id] = slot;
    }
    [[nodiscard]] const Item& At(int slot) const { return m_items[slot]; }

    int SiftUp(int slot) {
        const Item item = At(slot);
        while (slot > 0 && item.Before(At((slot - 1) / 2))) {
            Place(slot, At((slot - 1) / 2));
            slot = (slot - 1) / 2;
        }
        Place(slot, item);
        return slot;
    }
    void SiftDown(int slot) {
        const Item item = At(slot);
        const int count = static_cast<int>(m_items.size());
        for (int child = 2 * slot + 1; child < count; child = 2 * slot + 1) {
            if (child + 1 < count && At(child + 1).Before(At(child))) ++child;
            if (!At(child).Before(item)) break;
            Place(slot, At(child));
            slot = child;
        }
        Place(slot, item);
    }

    Column<int, Item> m_items;
    Column<int, int> m_slotOf;  ///< by id; −1: not in the heap
};

}  // namespace scree
