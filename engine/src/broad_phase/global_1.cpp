// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Global 1 (Tsamis 2020, §3.5): a barycentre tree, then one box query per box; of two boxes the later one in leaf order
// reports the pair.

#include "broad_phase/algorithms.h"
#include "broad_phase/tree_broad_phase.h"

namespace scree::broadphase {
namespace {

struct SingleQueries {
    const FlatTree& tree;
    PairSink& sink;
    uint64_t boxTests = 0;

    /// Reports the pairs of one box with all earlier positions.
    void Run(uint32_t position) {
        const Bounds box = tree.Box(position);
        Recurse(tree.nodes[0], position, ProbeOf(Load(box)));
    }

    void Recurse(const TreeNode& node, uint32_t position, F4 probe) {
        if (node.first >= position) return;
        ++boxTests;
        if (!Overlaps(Load(node.box), probe)) return;
        if (!node.IsLeaf()) {
            Recurse(tree.nodes[node.child], position, probe);
            Recurse(tree.nodes[node.child + 1], position, probe);
            return;
        }
        for (uint32_t i = node.first; i < node.first + node.count && i < position; ++i) {
            const Bounds other = tree.Box(i);
            if (Overlaps(Load(other), probe)) sink.Emit(tree.Ids()[position], tree.Ids()[i]);
        }
        if (node.count > 1) boxTests += node.count;
    }
};

class Global1 final : public TreeBroadPhase {
public:
    explicit Global1(const BroadPhaseConfig& config) : TreeBroadPhase(config, SplitBarycentre, 1) {}

protected:
    void BuildAndDetect(SlotRange slots, FlatTree& tree, PairSink& sink) override {
        Build(slots, tree);
        SingleQueries queries{tree, sink};
        for (uint32_t position = 1; position < tree.Size(); ++position) queries.Run(position);
        m_stats.boxTests += queries.boxTests;
    }
};

}  // namespace

std::unique_ptr<BroadPhase> MakeGlobal1(const BroadPhaseConfig& config) { return std::make_unique<Global1>(config); }

}  // namespace scree::broadphase
