// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Global 2 (Tsamis 2020, §3.5): a barycentre tree, then all boxes as one batch down that tree, in place.

#include "broad_phase/algorithms.h"
#include "broad_phase/tree_broad_phase.h"

namespace scree::broadphase {
namespace {

class Global2 final : public TreeBroadPhase {
public:
    explicit Global2(const BroadPhaseConfig& config) : TreeBroadPhase(config, SplitBarycentre, 1) {}

protected:
    void BuildAndDetect(SlotRange slots, FlatTree& tree, PairSink& sink) override {
        Build(slots, tree);
        m_stats.boxTests += QueryBatchSelf(tree, m_selfBatch, sink);
    }
    [[nodiscard]] size_t GetBufferBytes() const override { return m_selfBatch.capacity() * sizeof(BatchItem); }

private:
    std::vector<BatchItem> m_selfBatch;
};

}  // namespace

std::unique_ptr<BroadPhase> MakeGlobal2(const BroadPhaseConfig& config) { return std::make_unique<Global2>(config); }

}  // namespace scree::broadphase
