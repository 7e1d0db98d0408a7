// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Build and detect in one pass (Tsamis 2020, §3.6). The boxes are split at the barycentre. Every node receives the set
// of outside boxes that overlap its box: its candidates. Both children take over the parent's candidates that overlap
// them, and one child also those boxes of its sibling that do. A leaf pairs with what is left. The tree is kept for
// queries. Boxes are tight.

#include "broad_phase/algorithms.h"
#include "broad_phase/tree_broad_phase.h"

namespace scree::broadphase {
namespace {

struct UnifiedPass {
    BuildItem* items;
    uint32_t leafSize;
    FlatTree& tree;
    std::vector<BuildItem>& candidates;  ///< a stack: the sets of all nodes on the path from the root
    PairSink& sink;
    uint64_t boxTests = 0;

    /// Copies those of `count` boxes that overlap `box` to `out`; returns how many.
    uint32_t Filter(const BuildItem* in, uint32_t count, const Bounds& box, BuildItem* out) {
        const F4 probe = ProbeOf(Load(box));
        uint32_t kept = 0;
        boxTests += count;
        for (uint32_t i = 0; i < count; ++i) {
            out[kept] = in[i];
            kept += Overlaps(Load(in[i].box), probe) ? 1 : 0;
        }
        return kept;
    }

    void FinishLeaf(const TreeNode& node, uint32_t firstCandidate, uint32_t candidateCount) {
        for (uint32_t i = node.first; i < node.first + node.count; ++i) {
            const BuildItem& item = items[i];
            tree.SetItem(i, item.box, item.id);
            const F4 probe = ProbeOf(Load(item.box));
            for (uint32_t j = i + 1; j < node.first + node.count; ++j) {
                if (Overlaps(Load(items[j].box), probe)) sink.Emit(item.id, items[j].id);
            }
            for (uint32_t c = firstCandidate; c < firstCandidate + candidateCount; ++c) {
                if (Overlaps(Load(candidates[c].box), probe)) sink.Emit(item.id, candidates[c].id);
            }
        }
        boxTests += static_cast<uint64_t>(node.count) * (candidateCount + (node.count - 1) / 2);
    }

    void Recurse(uint32_t nodeIndex, const Bounds& centre, uint32_t firstCandidate, uint32_t candidateCount,
                 int depth) {
        const TreeNode node = tree.nodes[nodeIndex];
        if (node.count <= leafSize) {
            FinishLeaf(node, firstCandidate, candidateCount);
            return;
        }
        const uint32_t left = SplitOrHalve(SplitBarycentre, items + node.first, node.count, centre, depth);
        const SlotRange ranges[2] = {{node.first, left}, {node.first + left, node.count - left}};
        const RangeBounds bounds[2] = {Measure(items + ranges[0].first, ranges[0].count),
                                       Measure(items + ranges[1].first, ranges[1].count)};
        const auto child = static_cast<uint32_t>(tree.nodes.size());
        tree.nodes[nodeIndex].child = child;
        for (int i = 0; i < 2; ++i) tree.nodes.push_back({bounds[i].box, ranges[i].first, ranges[i].count});

        // The smaller side is the cheaper one to hand over.
        const uint32_t small = ranges[0].count <= ranges[1].count ? 0 : 1;
        const uint32_t top = firstCandidate + candidateCount;
        for (uint32_t i = 0; i < 2; ++i) {
            // The filter writes one item beyond those it keeps, and reads from the same array.
            const size_t room = top + candidateCount + ranges[small].count + 1;
            if (candidates.size() < room) candidates.resize(2 * room);
            BuildItem* out = candidates.data() + top;
            uint32_t kept = Filter(candidates.data() + firstCandidate, candidateCount, bounds[i].box, out);
            if (i != small) kept += Filter(items + ranges[small].first, ranges[small].count, bounds[i].box, out + kept);
            Recurse(child + i, bounds[i].centre, top, kept, depth + 1);
        }
    }
};

class Unified final : public TreeBroadPhase {
public:
    explicit Unified(const BroadPhaseConfig& config) : TreeBroadPhase(config, SplitBarycentre, 1) {}

protected:
    void BuildAndDetect(SlotRange slots, FlatTree& tree, PairSink& sink) override {
        CollectItems(m_store, slots, m_detectItems);
        tree.Reset(slots.count, slots.count);
        if (slots.count == 0) return;
        const RangeBounds bounds = Measure(m_detectItems.data(), slots.count);
        tree.nodes.push_back({bounds.box, 0, slots.count});
        UnifiedPass pass{m_detectItems.data(), m_leafSize, tree, m_candidates, sink};
        pass.Recurse(0, bounds.centre, 0, 0, 0);
        m_stats.boxTests += pass.boxTests;
    }

    [[nodiscard]] size_t GetBufferBytes() const override {
        return (m_detectItems.capacity() + m_candidates.capacity()) * sizeof(BuildItem);
    }

private:
    std::vector<BuildItem> m_detectItems, m_candidates;
};

}  // namespace

std::unique_ptr<BroadPhase> MakeUnified(const BroadPhaseConfig& config) { return std::make_unique<Unified>(config); }

}  // namespace scree::broadphase
