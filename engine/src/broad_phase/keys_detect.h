// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Detection of the production algorithm: candidate sets go down a tree with wide leaves. Every node receives the
// outside boxes that overlap its box. Both children take over those that overlap them, and the larger child also the
// boxes of its smaller sibling that do. In a leaf, rows of four boxes are compared at a time and hits are written
// without a branch.
//
// Several workers share one walk. It is cut where subtrees have become small. The worker of such a subtree looks for
// its candidates itself: below the siblings that would hand over their boxes on the way down. Pairs are put together in
// the order of the walk, so that the result is that of one worker.

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/task_pool.h"
#include "broad_phase/flat_tree.h"
#include "broad_phase/split_rules.h"

namespace scree::broadphase {

/// What one worker walks with.
struct KeysBuffers {
    std::vector<Bounds> boxes;                    ///< the stack of candidate sets
    std::vector<ItemId> ids;                      ///< likewise
    std::vector<uint32_t> hitsFirst, hitsSecond;  ///< hits of one kernel call
    std::vector<Pair> pairs;                      ///< found in parts of a shared walk
    size_t pairCount = 0;

    /// Room for any part that another one has walked.
    void MatchRoomOf(const KeysBuffers& other);
    [[nodiscard]] size_t GetMemoryBytes() const;
};

/// The parts of a shared walk, in its order.
struct KeysCut {
    /// A node of the tree, and then what was found there.
    struct Part {
        const TreeNode* node;
        int parent = -1;                    ///< the part of the node above; negative: none
        const TreeNode* sibling = nullptr;  ///< hands its boxes over to the node; null: none does
        bool isBelow = false;               ///< all below the node belongs to the part, too
        int worker = 0;
        size_t firstPair = 0, pairCount = 0;
        size_t place = 0;  ///< of its pairs among those of all parts
        uint64_t boxTests = 0;
    };
    std::vector<Part> parts;
};

class KeysDetector {
public:
    /// Pairs inside the tree, and between it and the boxes given in two parts (which are not in it). Returns the box
    /// tests. The pool may be null.
    uint64_t DetectSelf(const FlatTree& tree, std::span<const BuildItem> resting, std::span<const BuildItem> outside,
                        TaskPool* pool, PairSink& sink);
    /// Pairs of the boxes of one tree, and of others, with those of another tree.
    uint64_t DetectBetween(const FlatTree& batch, std::span<const BuildItem> more, const FlatTree& tree, TaskPool* pool,
                           PairSink& sink);
    [[nodiscard]] size_t GetMemoryBytes() const;

private:
    /// Makes parts of the upper nodes, and of what is below them once that is small; the pool is open.
    void CutWalk(const FlatTree& tree, const TaskPool& pool);
    /// DetectSelf by all workers, part by part.
    uint64_t WalkParts(const FlatTree& tree, std::span<const BuildItem> resting, std::span<const BuildItem> outside,
                       TaskPool& pool, PairSink& sink);
    /// Calls walk(buffers, sink, part) → box tests for all parts, by all workers, and puts their pairs together in the
    /// order of the parts. Returns all box tests.
    template <typename Walk>
    uint64_t ShareParts(TaskPool& pool, PairSink& sink, Walk&& walk);

    KeysBuffers m_whole;                   ///< of walks that are no part of one
    std::vector<KeysBuffers> m_ofWorkers;  ///< of parts
    KeysCut m_cut;
};

}  // namespace scree::broadphase
