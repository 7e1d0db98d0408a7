// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A tree built anew by the binned surface area heuristic (Tsamis 2020, §3.2; Wald 2007), pairs by dual descent: what a
// better tree costs to build and saves in detection.

#include "broad_phase/algorithms.h"
#include "broad_phase/dual_descent.h"
#include "broad_phase/tree_broad_phase.h"

namespace scree::broadphase {
namespace {

class BvhSah final : public TreeBroadPhase {
public:
    explicit BvhSah(const BroadPhaseConfig& config) : TreeBroadPhase(config, SplitSah, 1) {}

protected:
    void BuildAndDetect(SlotRange slots, FlatTree& tree, PairSink& sink) override {
        Build(slots, tree);
        m_stats.boxTests += DescendSelf(tree, sink);
    }
};

}  // namespace

std::unique_ptr<BroadPhase> MakeBvhSah(const BroadPhaseConfig& config) { return std::make_unique<BvhSah>(config); }

}  // namespace scree::broadphase
