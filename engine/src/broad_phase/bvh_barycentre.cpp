// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A tree built anew by the barycentre rule (Tsamis 2020, §3.2, list 4), pairs by dual descent.

#include "broad_phase/algorithms.h"
#include "broad_phase/dual_descent.h"
#include "broad_phase/tree_broad_phase.h"

namespace scree::broadphase {
namespace {

class BvhBarycentre final : public TreeBroadPhase {
public:
    explicit BvhBarycentre(const BroadPhaseConfig& config) : TreeBroadPhase(config, SplitBarycentre, 1) {}

protected:
    void BuildAndDetect(SlotRange slots, FlatTree& tree, PairSink& sink) override {
        Build(slots, tree);
        m_stats.boxTests += DescendSelf(tree, sink);
    }
};

}  // namespace

std::unique_ptr<BroadPhase> MakeBvhBarycentre(const BroadPhaseConfig& config) {
    return std::make_unique<BvhBarycentre>(config);
}

}  // namespace scree::broadphase
