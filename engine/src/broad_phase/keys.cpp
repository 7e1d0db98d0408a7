// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The production algorithm: the barycentre build and the candidate sets of Tsamis 2020 (§3.2 list 4, §3.6) in the form
// that suits the machine: keys instead of boxes in the build (keys_build.h), wide leaves and rows of four in the
// detection (keys_detect.h). Few statics go down the movers' tree as candidates of the root; more have a tree of their
// own that the movers go down as one batch.

#include "broad_phase/algorithms.h"
#include "broad_phase/keys_build.h"
#include "broad_phase/keys_detect.h"
#include "broad_phase/tree_broad_phase.h"

namespace scree::broadphase {
namespace {

/// Boxes per leaf with the least time for build and detection together (8 … 64 measured on piles and sparse scenes).
constexpr int bestLeafSize = 24;
/// As many statics as are cheaper to filter from the root than to keep in a tree; few large ones overlap most movers.
constexpr uint32_t maxRootCandidates = 32;

class Keys final : public TreeBroadPhase {
public:
    explicit Keys(const BroadPhaseConfig& config) : TreeBroadPhase(config, SplitBarycentre, bestLeafSize) {}

protected:
    void Build(SlotRange slots, FlatTree& tree) override { m_builder.Build(m_store, slots, m_leafSize, tree); }
    void BuildAndDetect(SlotRange slots, FlatTree& tree, PairSink& sink) override {
        Build(slots, tree);
        m_stats.boxTests += m_detector.DetectSelf(tree, m_store, RootCandidates(), sink);
    }
    void DetectBetween(const FlatTree& movers, const FlatTree& statics, PairSink& sink) override {
        m_stats.boxTests += m_detector.DetectBetween(movers, statics, sink);
    }
    [[nodiscard]] uint32_t MaxRootCandidates() const override { return maxRootCandidates; }
    [[nodiscard]] size_t GetBufferBytes() const override {
        return m_builder.GetMemoryBytes() + m_detector.GetMemoryBytes();
    }

private:
    KeysBuilder m_builder;
    KeysDetector m_detector;
};

}  // namespace

std::unique_ptr<BroadPhase> MakeKeys(const BroadPhaseConfig& config) { return std::make_unique<Keys>(config); }

}  // namespace scree::broadphase
