// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The walk of a batch of boxes down a tree: tree and boxes in, pairs out.

#include "broad_phase/batch_query.h"

#include <utility>

namespace scree::broadphase {
namespace {

template <bool self>
struct BatchWalk {
    const FlatTree& queries;
    const FlatTree& tree;
    BatchItem* batch;
    PairSink& sink;
    uint64_t boxTests = 0;

    void Recurse(uint32_t nodeIndex, uint32_t count) {
        const TreeNode& node = tree.nodes[nodeIndex];
        const F4 probe = ProbeOf(Load(node.box));
        uint32_t front = 0;
        boxTests += count;
        for (uint32_t i = 0; i < count; ++i) {
            const BatchItem item = batch[i];
            bool goesOn = Overlaps(Load(item.box), probe);
            // Of two boxes of one tree the later one reports the pair.
            if constexpr (self) goesOn &= item.position > node.first;
            batch[i] = batch[front];
            batch[front] = item;
            front += goesOn ? 1 : 0;
        }
        if (front == 0) return;
        if (node.IsLeaf()) {
            EmitLeaf(node, front);
        } else {
            Recurse(node.child, front);
            Recurse(node.child + 1, front);
        }
    }

    void EmitLeaf(const TreeNode& node, uint32_t front) {
        if (node.count > 1) boxTests += static_cast<uint64_t>(front) * node.count;
        for (uint32_t position = node.first; position < node.first + node.count; ++position) {
            const Bounds box = tree.Box(position);
            const F4 probe = ProbeOf(Load(box));
            for (uint32_t i = 0; i < front; ++i) {
                if (self && batch[i].position <= position) continue;
                if (Overlaps(Load(batch[i].box), probe))
                    sink.Emit(queries.Ids()[batch[i].position], tree.Ids()[position]);
            }
        }
    }
};

template <bool self>
uint64_t Run(const FlatTree& queries, const FlatTree& tree, std::vector<BatchItem>& batch, PairSink& sink) {
    if (queries.Empty() || tree.Empty()) return 0;
    batch.resize(queries.Size());
    for (uint32_t i = 0; i < queries.Size(); ++i) batch[i] = {queries.Box(i), i};
    BatchWalk<self> walk{queries, tree, batch.data(), sink};
    walk.Recurse(0, queries.Size());
    return walk.boxTests;
}

}  // namespace

uint64_t QueryBatch(const FlatTree& queries, const FlatTree& tree, std::vector<BatchItem>& batch, PairSink& sink) {
    return Run<false>(queries, tree, batch, sink);
}

uint64_t QueryBatchSelf(const FlatTree& tree, std::vector<BatchItem>& batch, PairSink& sink) {
    return Run<true>(tree, tree, batch, sink);
}

}  // namespace scree::broadphase
