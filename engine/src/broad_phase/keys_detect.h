// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Detection of the production algorithm: candidate sets go down a tree with wide leaves. Every node receives the
// outside boxes that overlap its box; both children take over those that overlap them, and the larger child also the
// boxes of its smaller sibling that do. In a leaf, rows of four boxes are compared at a time and hits are written
// without a branch.

#pragma once

#include <cstdint>
#include <vector>

#include "broad_phase/flat_tree.h"
#include "broad_phase/proxy_store.h"
#include "broad_phase/top_down.h"

namespace scree::broadphase {

class KeysDetector {
public:
    /// Pairs inside the tree, and between it and the slots given (which are not in it). Returns the box tests.
    uint64_t DetectSelf(const FlatTree& tree, const ProxyStore& store, SlotRange outside, PairSink& sink);
    /// Pairs between the boxes of two trees.
    uint64_t DetectBetween(const FlatTree& batch, const FlatTree& tree, PairSink& sink);
    [[nodiscard]] size_t GetMemoryBytes() const;

private:
    template <bool self>
    friend struct KeysWalk;

    std::vector<Bounds> m_boxes;                      ///< the stack of candidate sets
    std::vector<ItemId> m_ids;                        ///< likewise
    std::vector<uint32_t> m_hitsFirst, m_hitsSecond;  ///< hits of one kernel call
};

}  // namespace scree::broadphase
