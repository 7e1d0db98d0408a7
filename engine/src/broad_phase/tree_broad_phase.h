// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the rebuilding tree algorithms share: the proxy store, one main tree rebuilt by every FindPairs, a static tree
// kept apart while the share of statics is above the threshold (Tsamis 2020, §3.7.1) and rebuilt only after statics
// were edited, and lazy answers to queries between edits (§3.7.2). An algorithm supplies the building and the
// detection.
//
// Edits after a build do not touch the tree. The edited proxies go to a short list that queries scan beside the tree,
// and what the tree still says about them is ignored. When the list exceeds a few √n the tree counts as stale and the
// next query rebuilds it: n edits interleaved with n queries cost O(n^1.5), not O(n²).

#pragma once

#include <cstdint>
#include <vector>

#include "broad_phase/batch_query.h"
#include "broad_phase/broad_phase.h"
#include "broad_phase/flat_tree.h"
#include "broad_phase/proxy_store.h"
#include "broad_phase/top_down.h"

namespace scree::broadphase {

class TreeBroadPhase : public BroadPhase {
public:
    /// `rule` continues leaves for GetNodes; `leafSize` is the algorithm's own best, the config may override it.
    TreeBroadPhase(const BroadPhaseConfig& config, SplitRule rule, int leafSize);

    void Insert(uint32_t fixture, uint32_t body, Motion motion, const AABB& box) override;
    void Update(uint32_t fixture, const AABB& box, Vec2 displacement) override;
    void UpdateMany(std::span<const BoxUpdate> updates) override;
    void Remove(uint32_t fixture) override;
    void FindPairs(std::vector<Pair>& pairs) override;

    void Query(const AABB& box, const std::function<bool(uint32_t)>& visit) override;
    void QueryStatic(const AABB& box, const std::function<bool(uint32_t)>& visit) override;
    void RayCast(const RayCastInput& input, const std::function<float(const RayCastInput&, uint32_t)>& visit) override;

    [[nodiscard]] AABB GetBox(uint32_t fixture) const override { return m_store.Box(m_store.Find(fixture)); }
    [[nodiscard]] int GetProxyCount() const override { return static_cast<int>(m_store.Size()); }
    void GetNodes(std::vector<BvhNode>& nodes) override;
    [[nodiscard]] int GetLeafSize() const override { return static_cast<int>(m_leafSize); }
    [[nodiscard]] size_t GetMemoryBytes() const override;
    [[nodiscard]] BroadPhaseStats GetStats() const override { return m_stats; }

protected:
    /// Builds a tree over the slots.
    virtual void Build(SlotRange slots, FlatTree& tree);
    /// Builds the main tree over the slots and reports the pairs inside it.
    virtual void BuildAndDetect(SlotRange slots, FlatTree& tree, PairSink& sink) = 0;
    /// Reports the pairs between the boxes of two trees; by default the movers go down the static tree as one batch.
    virtual void DetectBetween(const FlatTree& movers, const FlatTree& statics, PairSink& sink);
    /// Up to this many statics apart are handed to BuildAndDetect through RootCandidates instead of getting a tree.
    [[nodiscard]] virtual uint32_t MaxRootCandidates() const { return 0; }
    /// The statics that BuildAndDetect must test the movers against.
    [[nodiscard]] SlotRange RootCandidates() const { return m_rootCandidates; }
    /// Bytes of the algorithm's own buffers.
    [[nodiscard]] virtual size_t GetBufferBytes() const { return 0; }

    ProxyStore m_store;
    BroadPhaseStats m_stats;
    const SplitRule m_rule;
    const uint32_t m_leafSize;

private:
    /// What changed in one part of the proxies since its tree was built.
    struct Edits {
        std::vector<uint32_t> pending;  ///< fixtures whose boxes must be scanned beside the tree
        uint32_t count = 0;             ///< proxies edited or removed
        uint32_t limit = 0;
        bool stale = true;  ///< the tree is of no use any more; `pending` is then empty
    };

    void NoteEdit(Edits& edits);
    void MarkPending(uint32_t slot);
    void ForgetEdits(Edits& edits, bool stale);
    void ChooseTrees();
    void MainTreeBuilt();
    void BuildStatics();
    void RefreshStale();
    void RefreshAll();
    /// Visits what a tree holds and is still current; false if the visitor ended it.
    bool QueryTree(bool staticTree, const AABB& box, const std::function<bool(uint32_t)>& visit);
    /// Visits edited proxies; false if the visitor ended it.
    bool QueryEdits(const Edits& edits, const AABB& box, const std::function<bool(uint32_t)>& visit);
    [[nodiscard]] bool IsCurrent(uint32_t fixture, bool fromStaticTree);
    Edits& EditsOf(uint32_t slot) { return m_store.IsStatic(slot) ? m_staticEdits : m_moverEdits; }
    [[nodiscard]] SlotRange Movers() const { return {0, m_store.MoverCount()}; }
    [[nodiscard]] SlotRange Statics() const { return {m_store.MoverCount(), m_store.StaticCount()}; }
    [[nodiscard]] SlotRange MainSlots() const { return m_separate ? Movers() : SlotRange{0, m_store.Size()}; }

    const float m_staticShareThreshold;
    FlatTree m_main, m_statics;
    FlatTree m_staticIndex;  ///< of QueryStatic while the statics have no tree of their own
    bool m_staticIndexStale = true;
    Edits m_moverEdits, m_staticEdits;
    SlotRange m_rootCandidates;
    bool m_separate = false;
    std::vector<BuildItem> m_items;  ///< of the default Build
    std::vector<BatchItem> m_batch;  ///< of the default DetectBetween
};

}  // namespace scree::broadphase
