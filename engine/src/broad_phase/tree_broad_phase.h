// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the rebuilding tree algorithms share: the proxies and their trees as a BroadPhase. Every FindPairs rebuilds the
// main tree; queries between edits are answered from what was built last (proxy_trees.h, tree_edits.h). An algorithm
// supplies the building and the detection.

#pragma once

#include <cstdint>
#include <vector>

#include "broad_phase/batch_query.h"
#include "broad_phase/broad_phase.h"
#include "broad_phase/flat_tree.h"
#include "broad_phase/proxy_store.h"
#include "broad_phase/proxy_trees.h"
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

    void PrepareQueries() override;
    uint64_t Query(const AABB& box, Visitor visit) const override;
    uint64_t RayCast(const RayCastInput& input, RayVisitor visit) const override;
    void QueryStatic(const AABB& box, Visitor visit) override;

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
    void NoteMainBuilt();
    void BuildStatics();

    ProxyTrees m_trees;
    FlatTree m_staticIndex;  ///< of QueryStatic while the statics have no tree of their own
    bool m_isStaticIndexStale = true;
    SlotRange m_rootCandidates;
    std::vector<BuildItem> m_items;  ///< of the default Build
    std::vector<BatchItem> m_batch;  ///< of the default DetectBetween
};

}  // namespace scree::broadphase
