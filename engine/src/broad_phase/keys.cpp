// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The production algorithm: the barycentre build and the candidate sets of Tsamis 2020 (§3.2 list 4, §3.6). The build
// sorts keys instead of boxes (keys_build.h); the detection has wide leaves and rows of four (keys_detect.h). A little
// that rests goes down the movers' tree as candidates of the root. More has a tree of its own, which the movers go down
// as one batch.

#include "broad_phase/algorithms.h"
#include "broad_phase/keys_build.h"
#include "broad_phase/keys_detect.h"
#include "broad_phase/tree_broad_phase.h"

namespace scree::broadphase {
namespace {

/// Boxes per leaf with the least time for build and detection together, on piles and on sparse scenes.
constexpr int bestLeafSize = 24;
/// Steps for which splits are kept at most: what they save is then shared out, and their order is nearly as good.
constexpr int longestUse = 8;
/// Growth of the nodes' summed half perimeters beyond which splits are given up at once: everything has jumped.
/// Growth of the box tests beyond which the next step gets new ones: the sum hides much when one box is far away.
constexpr float largestGrowth = 1.2f;
constexpr double mostTests = 1.5;
/// New boxes that may be joined in beside the tree before it is built anew, and the share of edited ones.
constexpr size_t mostOutside = 32;
constexpr uint32_t mostEdited = 8;

class Keys final : public TreeBroadPhase {
public:
    explicit Keys(const BroadPhaseConfig& config) : TreeBroadPhase(config, SplitBarycentre, bestLeafSize) {}

protected:
    void Build(SlotRange slots, FlatTree& tree) override {
        m_builder.Build(m_store, slots, m_leafSize, m_pool, tree);
        m_uses = longestUse;
    }
    void BuildAndDetect(SlotRange slots, FlatTree& tree, PairSink& sink) override {
        Build(slots, tree);
        m_uses = 0;
        m_sizeWhenSplit = KeysBuilder::SumHalfPerimeters(tree);
        m_testsWhenSplit = m_detector.DetectSelf(tree, Candidates(), {}, m_pool, sink);
        m_stats.boxTests += m_testsWhenSplit;
    }
    bool Refit(FlatTree& tree) override {
        KeysBuilder::Refit(m_store, m_pool, tree);
        return true;
    }
    bool RefitAndDetect(FlatTree& tree, const TreeEdits& edits, std::span<const BuildItem> outside,
                        PairSink& sink) override {
        if (!KeepsSplits(tree, edits)) return false;
        const uint64_t tests = m_detector.DetectSelf(tree, Candidates(), outside, m_pool, sink);
        DetectOutside(outside, sink);
        m_stats.boxTests += tests;
        if (static_cast<double>(tests) > mostTests * static_cast<double>(m_testsWhenSplit)) m_uses = longestUse;
        return true;
    }
    void DetectBetween(const FlatTree& moving, std::span<const BuildItem> outside, const FlatTree& resting,
                       PairSink& sink) override {
        m_stats.boxTests += m_detector.DetectBetween(moving, outside, resting, m_pool, sink);
    }
    [[nodiscard]] bool TakesCandidates() const override { return true; }
    [[nodiscard]] size_t GetBufferBytes() const override {
        return m_builder.GetMemoryBytes() + m_detector.GetMemoryBytes();
    }

private:
    /// Gives the main tree the present boxes under its old splits; false if new ones are due.
    bool KeepsSplits(FlatTree& tree, const TreeEdits& edits) {
        if (m_uses >= longestUse || edits.IsLost() || tree.Empty()) return false;
        if (edits.Outside().size() > mostOutside || edits.Count() > mostEdited + tree.Size() / 8) return false;
        ++m_uses;
        Refit(tree);
        return KeysBuilder::SumHalfPerimeters(tree) <= largestGrowth * m_sizeWhenSplit;
    }

    /// Pairs of what is outside of the main tree among itself, and with the candidates.
    void DetectOutside(std::span<const BuildItem> outside, PairSink& sink) {
        for (size_t i = 0; i < outside.size(); ++i) {
            const F4 probe = ProbeOf(Load(outside[i].box));
            const auto meet = [&](const BuildItem& item) {
                if (Overlaps(Load(item.box), probe)) sink.Emit(outside[i].id, item.id);
            };
            for (const BuildItem& item : outside.subspan(i + 1)) meet(item);
            for (const BuildItem& item : Candidates()) meet(item);
        }
    }

    KeysBuilder m_builder;
    KeysDetector m_detector;
    int m_uses = longestUse;        ///< how often the main tree's splits were used again
    float m_sizeWhenSplit = 0.0f;   ///< half perimeters of the nodes it had then
    uint64_t m_testsWhenSplit = 0;  ///< box tests of the detection then
};

}  // namespace

std::unique_ptr<BroadPhase> MakeKeys(const BroadPhaseConfig& config) { return std::make_unique<Keys>(config); }

}  // namespace scree::broadphase
