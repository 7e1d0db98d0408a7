// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the rebuilding tree algorithms share: the proxies and their trees as a BroadPhase. Every FindPairs rebuilds the
// main tree or gives it the present boxes; the tree of what rests follows edits (proxy_trees.h, tree_edits.h). An
// algorithm supplies the building and the detection.

#pragma once

#include <cstdint>
#include <span>
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
    [[nodiscard]] bool SharesUpdates() const override { return true; }
    [[nodiscard]] bool UpdateMoving(std::span<const BoxUpdate> updates) override;
    void NoteUpdated(bool haveChanged) override;
    void Remove(uint32_t fixture) override;
    void SetResting(uint32_t fixture, bool resting) override;
    [[nodiscard]] bool HasChanged() const override { return m_hasChanged; }
    void ShareWork(TaskPool& pool) override { m_pool = &pool; }
    void FindPairs(std::vector<Pair>& pairs) override;

    void PrepareQueries() override;
    uint64_t Query(const AABB& box, Visitor visit) const override;
    uint64_t CastBox(const RayCastInput& path, Vec2 halfSize, RayVisitor visit) const override;
    void PrepareStatic() override;
    uint64_t QueryStatic(const AABB& box, Visitor visit) const override;
    void QueryResting(const AABB& box, Visitor visit) override;

    [[nodiscard]] AABB GetBox(uint32_t fixture) const override { return m_store.Box(m_store.Find(fixture)); }
    [[nodiscard]] int GetProxyCount() const override { return static_cast<int>(m_store.Size()); }
    void GetNodes(std::vector<BvhNode>& nodes) override;
    [[nodiscard]] int GetLeafSize() const override { return static_cast<int>(m_leafSize); }
    [[nodiscard]] size_t GetMemoryBytes() const override;
    [[nodiscard]] BroadPhaseStats GetStats() const override { return m_stats; }

protected:
    /// Builds a tree over the slots.
    virtual void Build(SlotRange slots, FlatTree& tree);
    /// Gives a tree the present boxes of the proxies that live in it. False if it is to be built instead.
    virtual bool Refit(FlatTree& /*tree*/) { return false; }
    /// Builds the main tree over the slots and reports the pairs inside it, and those with the candidates.
    virtual void BuildAndDetect(SlotRange slots, FlatTree& tree, PairSink& sink) = 0;
    /// The same for a tree whose splits still serve: gives it the present boxes, and joins in what is outside of it.
    /// False if it did nothing.
    virtual bool RefitAndDetect(FlatTree& /*tree*/, const TreeEdits& /*edits*/, std::span<const BuildItem> /*outside*/,
                                PairSink& /*sink*/) {
        return false;
    }
    /// Reports the pairs between the boxes of a tree and of what is outside of it, and those of another tree. By
    /// default nothing is outside, and the boxes go down as one batch.
    virtual void DetectBetween(const FlatTree& moving, std::span<const BuildItem> outside, const FlatTree& resting,
                               PairSink& sink);
    /// Whether BuildAndDetect and RefitAndDetect look at Candidates(). If not, a tree of what rests is rebuilt after
    /// every edit.
    [[nodiscard]] virtual bool TakesCandidates() const { return false; }
    /// What rests and is in no tree: the movers must be tested against it.
    [[nodiscard]] std::span<const BuildItem> Candidates() const { return m_candidates; }
    /// Replaces `items` by the proxies of these fixtures.
    void Collect(std::span<const uint32_t> fixtures, std::vector<BuildItem>& items) const;
    /// Bytes of the algorithm's own buffers.
    [[nodiscard]] virtual size_t GetBufferBytes() const { return 0; }

    ProxyStore m_store;
    TaskPool* m_pool = nullptr;  ///< of ShareWork; null: there is one thread
    BroadPhaseStats m_stats;
    const SplitRule m_rule;
    const uint32_t m_leafSize;

private:
    void BuildMain();
    void BuildResting();
    void NoteMainBuilt();
    /// Prepares the candidates, and the tree of what rests where they do not do. True if the movers must meet it.
    bool PrepareResting();

    ProxyTrees m_trees;
    FlatTree m_staticIndex;  ///< of QueryStatic while what rests has no tree of its own
    bool m_isStaticIndexStale = true;
    bool m_hasChanged = true;  ///< a box, since pairs were found
    std::vector<BuildItem> m_candidates, m_outside;
    std::vector<BuildItem> m_items;  ///< of the default Build
    std::vector<BatchItem> m_batch;  ///< of the default DetectBetween
};

}  // namespace scree::broadphase
