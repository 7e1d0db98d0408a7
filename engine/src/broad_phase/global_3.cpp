// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Global 3 (Tsamis 2020, §3.5, Query-All3): a barycentre tree, then one walk. Every node hands each child the outside
// boxes that overlap it. One child also gets those of its sibling, so that no pair is met twice.

#include "broad_phase/algorithms.h"
#include "broad_phase/tree_broad_phase.h"

namespace scree::broadphase {
namespace {

struct CandidateWalk {
    const FlatTree& tree;
    std::vector<BatchItem>& candidates;  ///< a stack: the sets of all nodes on the path from the root
    PairSink& sink;
    uint64_t boxTests = 0;

    void Recurse(const TreeNode& node, uint32_t first, uint32_t count) {
        if (node.IsLeaf()) {
            FinishLeaf(node, first, count);
            return;
        }
        const TreeNode* children[2] = {&tree.nodes[node.child], &tree.nodes[node.child + 1]};
        const uint32_t small = children[0]->count <= children[1]->count ? 0 : 1;
        const uint32_t top = first + count;
        const size_t room = top + count + children[small]->count + 1;
        if (candidates.size() < room) candidates.resize(2 * room);
        for (uint32_t i = 0; i < 2; ++i) {
            const F4 probe = ProbeOf(Load(children[i]->box));
            uint32_t end = top;
            for (uint32_t c = first; c < top; ++c) {
                candidates[end] = candidates[c];
                end += Overlaps(Load(candidates[c].box), probe) ? 1 : 0;
            }
            boxTests += count;
            if (i != small) end = TakeSiblings(*children[small], probe, end);
            Recurse(*children[i], top, end - top);
        }
    }

    uint32_t TakeSiblings(const TreeNode& sibling, F4 probe, uint32_t end) {
        boxTests += sibling.count;
        for (uint32_t position = sibling.first; position < sibling.first + sibling.count; ++position) {
            candidates[end] = {tree.Box(position), position};
            end += Overlaps(Load(candidates[end].box), probe) ? 1 : 0;
        }
        return end;
    }

    void FinishLeaf(const TreeNode& node, uint32_t first, uint32_t count) {
        for (uint32_t i = node.first; i < node.first + node.count; ++i) {
            const Bounds box = tree.Box(i);
            const F4 probe = ProbeOf(Load(box));
            for (uint32_t j = i + 1; j < node.first + node.count; ++j) {
                const Bounds other = tree.Box(j);
                if (Overlaps(Load(other), probe)) sink.Emit(tree.Ids()[i], tree.Ids()[j]);
            }
            for (uint32_t c = first; c < first + count; ++c) {
                if (Overlaps(Load(candidates[c].box), probe))
                    sink.Emit(tree.Ids()[i], tree.Ids()[candidates[c].position]);
            }
        }
        boxTests += static_cast<uint64_t>(node.count) * (count + (node.count - 1) / 2);
    }
};

class Global3 final : public TreeBroadPhase {
public:
    explicit Global3(const BroadPhaseConfig& config) : TreeBroadPhase(config, SplitBarycentre, 1) {}

protected:
    void BuildAndDetect(SlotRange slots, FlatTree& tree, PairSink& sink) override {
        Build(slots, tree);
        if (tree.Empty()) return;
        CandidateWalk walk{tree, m_candidates, sink};
        walk.Recurse(tree.nodes[0], 0, 0);
        m_stats.boxTests += walk.boxTests;
    }
    [[nodiscard]] size_t GetBufferBytes() const override { return m_candidates.capacity() * sizeof(BatchItem); }

private:
    std::vector<BatchItem> m_candidates;
};

}  // namespace

std::unique_ptr<BroadPhase> MakeGlobal3(const BroadPhaseConfig& config) { return std::make_unique<Global3>(config); }

}  // namespace scree::broadphase
