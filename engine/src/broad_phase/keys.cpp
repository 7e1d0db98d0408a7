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

/// Steps for which splits are kept at most: what they save is then shared out, and their order is nearly as good.
constexpr int longestUse = 8;
/// Growth of the nodes' summed half perimeters beyond which splits are given up at once (everything has jumped), and
/// growth of the box tests beyond which the next step gets new ones (what the sum hides when one box is far away).
constexpr float largestGrowth = 1.2f;
constexpr double mostTests = 1.5;

class Keys final : public TreeBroadPhase {
public:
    explicit Keys(const BroadPhaseConfig& config) : TreeBroadPhase(config, SplitBarycentre, bestLeafSize) {}

    void ShareWork(TaskPool& pool) override { m_pool = &pool; }
    void Insert(uint32_t fixture, uint32_t body, Motion motion, const AABB& box) override {
        m_uses = longestUse;
        TreeBroadPhase::Insert(fixture, body, motion, box);
    }
    void Remove(uint32_t fixture) override {
        m_uses = longestUse;
        TreeBroadPhase::Remove(fixture);
    }

protected:
    void Build(SlotRange slots, FlatTree& tree) override { m_builder.Build(m_store, slots, m_leafSize, tree); }
    void BuildAndDetect(SlotRange slots, FlatTree& tree, PairSink& sink) override {
        if (!KeepsSplits(slots, tree)) {
            Build(slots, tree);
            m_uses = 0;
            m_sizeWhenSplit = KeysBuilder::SumHalfPerimeters(tree);
        }
        const uint64_t tests = m_detector.DetectSelf(tree, m_store, RootCandidates(), m_pool, sink);
        m_stats.boxTests += tests;
        if (m_uses == 0) m_testsWhenSplit = tests;
        if (static_cast<double>(tests) > mostTests * static_cast<double>(m_testsWhenSplit)) m_uses = longestUse;
    }
    void DetectBetween(const FlatTree& movers, const FlatTree& statics, PairSink& sink) override {
        m_stats.boxTests += m_detector.DetectBetween(movers, statics, sink);
    }
    [[nodiscard]] uint32_t MaxRootCandidates() const override { return maxRootCandidates; }
    [[nodiscard]] size_t GetBufferBytes() const override {
        return m_builder.GetMemoryBytes() + m_detector.GetMemoryBytes();
    }

private:
    /// Gives the main tree the present boxes under its old splits; false if new ones are due.
    bool KeepsSplits(SlotRange slots, FlatTree& tree) {
        if (m_uses >= longestUse || tree.Size() != slots.count) return false;
        ++m_uses;
        KeysBuilder::Refit(m_store, tree);
        return KeysBuilder::SumHalfPerimeters(tree) <= largestGrowth * m_sizeWhenSplit;
    }

    KeysBuilder m_builder;
    KeysDetector m_detector;
    TaskPool* m_pool = nullptr;
    int m_uses = longestUse;        ///< how often the main tree's splits were used again
    float m_sizeWhenSplit = 0.0f;   ///< half perimeters of the nodes it had then
    uint64_t m_testsWhenSplit = 0;  ///< box tests of the detection then
};

}  // namespace

std::unique_ptr<BroadPhase> MakeKeys(const BroadPhaseConfig& config) { return std::make_unique<Keys>(config); }

}  // namespace scree::broadphase
