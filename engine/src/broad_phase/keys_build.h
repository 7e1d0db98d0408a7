// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The fast form of the barycentre build: it sorts 16-bit keys of the box centres instead of boxes. One item is 8 bytes
// (two keys and the slot). A split compares a key with the integer middle of the keys' bounds. The boxes are fetched
// once, in leaf order. A range whose keys have become too coarse gets new keys from its own bounds, so clusters and far
// outliers lose nothing.

#pragma once

#include <cstdint>
#include <vector>

#include "base/leave_raw.h"
#include "base/task_pool.h"
#include "broad_phase/flat_tree.h"
#include "broad_phase/proxy_store.h"

namespace scree::broadphase {

/// A box while it is being sorted into a tree.
struct KeyItem {
    int16_t key[2];  ///< centre along x and y, in units of the range that was last given keys
    uint32_t slot;
};

class KeysBuilder {
public:
    /// Builds the tree over a range of slots. Many workers share the fetching of boxes; the pool may be null.
    void Build(const ProxyStore& store, SlotRange slots, uint32_t leafSize, TaskPool* pool, FlatTree& tree);
    /// Gives a tree built earlier the present boxes of its proxies, likewise.
    static void Refit(const ProxyStore& store, TaskPool* pool, FlatTree& tree);
    /// Of all nodes with a box: the measure of how well splits fit.
    [[nodiscard]] static float SumHalfPerimeters(const FlatTree& tree);
    [[nodiscard]] size_t GetMemoryBytes() const { return (m_items.capacity() + m_other.capacity()) * sizeof(KeyItem); }

private:
    std::vector<KeyItem, LeaveRaw<KeyItem>> m_items, m_other;
};

}  // namespace scree::broadphase
