// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Proxies in; builds when they are due, pairs and answers out.

#include "broad_phase/tree_broad_phase.h"

#include "broad_phase/tree_nodes.h"

namespace scree::broadphase {

TreeBroadPhase::TreeBroadPhase(const BroadPhaseConfig& config, SplitRule rule, int leafSize)
    : m_rule(rule),
      m_leafSize(static_cast<uint32_t>(config.leafSize > 0 ? config.leafSize : leafSize)),
      m_trees(m_store, config.staticShareThreshold) {}

void TreeBroadPhase::Insert(uint32_t fixture, uint32_t body, Motion motion, const AABB& box) {
    m_isStaticIndexStale = m_isStaticIndexStale || motion == Motion::isStatic;
    const uint32_t slot = m_store.Insert(fixture, body, motion, box);
    m_trees.EditsOf(slot).Mark(slot);
}

void TreeBroadPhase::Update(uint32_t fixture, const AABB& box, Vec2 /*displacement*/) {
    const uint32_t slot = m_store.Find(fixture);
    m_isStaticIndexStale = m_isStaticIndexStale || m_store.IsStatic(slot);
    m_store.SetBox(slot, box);
    m_trees.EditsOf(slot).Mark(slot);
}

void TreeBroadPhase::UpdateMany(std::span<const BoxUpdate> updates) {
    m_trees.moverEdits.Expect(updates.size());
    for (const BoxUpdate& update : updates) {
        const uint32_t slot = m_store.Find(update.fixture);
        m_store.SetBox(slot, update.box);
        if (m_trees.moverEdits.IsStale() && !m_store.IsStatic(slot)) continue;
        m_isStaticIndexStale = m_isStaticIndexStale || m_store.IsStatic(slot);
        m_trees.EditsOf(slot).Mark(slot);
    }
}

void TreeBroadPhase::Remove(uint32_t fixture) {
    const uint32_t slot = m_store.Find(fixture);
    m_isStaticIndexStale = m_isStaticIndexStale || m_store.IsStatic(slot);
    m_trees.EditsOf(slot).Remove(slot);
}

void TreeBroadPhase::Build(SlotRange slots, FlatTree& tree) {
    CollectItems(m_store, slots, m_items);
    BuildTopDown(m_items, m_rule, m_leafSize, tree);
}

void TreeBroadPhase::DetectBetween(const FlatTree& movers, const FlatTree& statics, PairSink& sink) {
    m_stats.boxTests += QueryBatch(movers, statics, m_batch, sink);
}

void TreeBroadPhase::NoteMainBuilt() {
    m_stats.rebuiltProxies += m_trees.MainSlots().count;
    m_trees.NoteMainBuilt();
}

void TreeBroadPhase::BuildStatics() {
    Build(m_store.Statics(), m_trees.statics);
    m_stats.rebuiltProxies += m_store.StaticCount();
    m_trees.NoteStaticsBuilt();
}

void TreeBroadPhase::PrepareQueries() {
    if (m_trees.IsMainStale()) {
        m_trees.Choose();
        Build(m_trees.MainSlots(), m_trees.main);
        NoteMainBuilt();
    }
    if (m_trees.AreStaticsStale()) BuildStatics();
}

void TreeBroadPhase::FindPairs(std::vector<Pair>& pairs) {
    m_stats = {};
    m_trees.Choose();
    const bool apart = m_trees.AreStaticsApart();
    m_stats.staticTreeSeparate = apart;
    PairSink sink(pairs);
    const bool asCandidates = apart && m_store.StaticCount() <= MaxRootCandidates();
    m_rootCandidates = asCandidates ? m_store.Statics() : SlotRange{};
    BuildAndDetect(m_trees.MainSlots(), m_trees.main, sink);
    NoteMainBuilt();
    if (apart && !asCandidates && m_store.MoverCount() > 0) {
        if (m_trees.staticEdits.IsStale() || m_trees.staticEdits.Count() > 0) BuildStatics();
        DetectBetween(m_trees.main, m_trees.statics, sink);
    }
    sink.Finish();
}

uint64_t TreeBroadPhase::Query(const AABB& box, Visitor visit) const {
    uint64_t boxTests = 0;
    m_trees.Query(box, boxTests, visit);
    return boxTests;
}

uint64_t TreeBroadPhase::RayCast(const RayCastInput& input, RayVisitor visit) const {
    uint64_t boxTests = 0;
    m_trees.RayCast(input, boxTests, visit);
    return boxTests;
}

void TreeBroadPhase::QueryStatic(const AABB& box, Visitor visit) {
    if (m_trees.AreStaticsApart()) {
        if (m_trees.AreStaticsStale()) BuildStatics();
        m_trees.QueryStatics(box, m_stats.boxTests, visit);
        return;
    }
    if (m_isStaticIndexStale) Build(m_store.Statics(), m_staticIndex);
    m_isStaticIndexStale = false;
    m_staticIndex.Query(box, m_stats.boxTests, [&](ItemId id) { return visit(id.fixture); });
}

void TreeBroadPhase::GetNodes(std::vector<BvhNode>& nodes) {
    m_trees.RefuseEdits();
    PrepareQueries();
    WriteNodes(m_trees.main, m_trees.statics, m_rule, nodes);
}

size_t TreeBroadPhase::GetMemoryBytes() const {
    return m_store.GetMemoryBytes() + m_trees.GetMemoryBytes() + m_staticIndex.GetMemoryBytes() +
           m_batch.capacity() * sizeof(BatchItem) + m_items.capacity() * sizeof(BuildItem) + GetBufferBytes();
}

}  // namespace scree::broadphase
