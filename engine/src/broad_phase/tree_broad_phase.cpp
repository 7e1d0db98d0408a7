// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Proxies in; builds when they are due, pairs and answers out.

#include "broad_phase/tree_broad_phase.h"

#include "broad_phase/tree_nodes.h"

namespace scree::broadphase {
namespace {

bool IsSame(const AABB& a, const AABB& b) { return a.lowerBound == b.lowerBound && a.upperBound == b.upperBound; }

}  // namespace

TreeBroadPhase::TreeBroadPhase(const BroadPhaseConfig& config, SplitRule rule, int leafSize)
    : m_rule(rule),
      m_leafSize(static_cast<uint32_t>(config.leafSize > 0 ? config.leafSize : leafSize)),
      m_trees(m_store, config.staticShareThreshold) {}

void TreeBroadPhase::Insert(uint32_t fixture, uint32_t body, Motion motion, const AABB& box) {
    m_hasChanged = true;
    m_isStaticIndexStale = m_isStaticIndexStale || motion == Motion::isStatic;
    const uint32_t slot = m_store.Insert(fixture, body, motion, box);
    m_trees.EditsOf(slot).Add(slot);
}

void TreeBroadPhase::Update(uint32_t fixture, const AABB& box, Vec2 /*displacement*/) {
    const uint32_t slot = m_store.Find(fixture);
    const bool isSame = IsSame(m_store.Box(slot), box);
    m_store.SetBox(slot, box);
    if (isSame) return;
    m_hasChanged = true;
    m_isStaticIndexStale = m_isStaticIndexStale || m_store.IsStatic(slot);
    m_trees.EditsOf(slot).Change(slot);
}

void TreeBroadPhase::UpdateMany(std::span<const BoxUpdate> updates) {
    for (const BoxUpdate& update : updates) {
        const uint32_t slot = m_store.Find(update.fixture);
        if (m_store.IsResting(slot)) {
            Update(update.fixture, update.box, update.displacement);
            continue;
        }
        m_hasChanged = m_hasChanged || !IsSame(m_store.Box(slot), update.box);
        m_store.SetBox(slot, update.box);
    }
    if (m_hasChanged) m_trees.mainEdits.NoteMoved();
}

bool TreeBroadPhase::UpdateMoving(std::span<const BoxUpdate> updates) {
    bool haveChanged = false;
    for (const BoxUpdate& update : updates) {
        const uint32_t slot = m_store.Find(update.fixture);
        haveChanged = haveChanged || !IsSame(m_store.Box(slot), update.box);
        m_store.SetBox(slot, update.box);
    }
    return haveChanged;
}

void TreeBroadPhase::NoteUpdated(bool haveChanged) {
    m_hasChanged = m_hasChanged || haveChanged;
    if (m_hasChanged) m_trees.mainEdits.NoteMoved();
}

void TreeBroadPhase::Remove(uint32_t fixture) {
    m_hasChanged = true;
    const uint32_t slot = m_store.Find(fixture);
    m_isStaticIndexStale = m_isStaticIndexStale || m_store.IsStatic(slot);
    m_trees.EditsOf(slot).Leave(slot);
    m_store.Remove(slot);
}

void TreeBroadPhase::SetResting(uint32_t fixture, bool resting) {
    const uint32_t slot = m_store.Find(fixture);
    if (m_store.IsStatic(slot) || m_store.IsResting(slot) == resting) return;
    m_trees.SetResting(slot, resting);
}

void TreeBroadPhase::Collect(std::span<const uint32_t> fixtures, std::vector<BuildItem>& items) const {
    items.clear();
    for (const uint32_t fixture : fixtures) {
        const uint32_t slot = m_store.Find(fixture);
        items.push_back({ToBounds(m_store.Box(slot)), m_store.Id(slot)});
    }
}

void TreeBroadPhase::Build(SlotRange slots, FlatTree& tree) {
    CollectItems(m_store, slots, m_items);
    BuildTopDown(m_items, m_rule, m_leafSize, tree);
}

void TreeBroadPhase::DetectBetween(const FlatTree& moving, std::span<const BuildItem> /*outside*/,
                                   const FlatTree& resting, PairSink& sink) {
    m_stats.boxTests += QueryBatch(moving, resting, m_batch, sink);
}

void TreeBroadPhase::NoteMainBuilt() {
    m_stats.rebuiltProxies += m_trees.MainSlots().count;
    m_trees.mainEdits.NoteBuilt(m_pool);
}

void TreeBroadPhase::BuildMain() {
    m_trees.Choose();
    Build(m_trees.MainSlots(), m_trees.main);
    NoteMainBuilt();
}

void TreeBroadPhase::BuildResting() {
    Build(m_store.Resting(), m_trees.resting);
    m_stats.rebuiltProxies += m_store.Resting().count;
    m_trees.restingEdits.NoteBuilt(m_pool);
}

void TreeBroadPhase::PrepareQueries() {
    if (TreeEdits& edits = m_trees.mainEdits; edits.IsStale()) {
        !edits.IsLost() && Refit(m_trees.main) ? edits.NoteRefitted() : BuildMain();
    }
    if (m_trees.IsRestingStale()) BuildResting();
}

bool TreeBroadPhase::PrepareResting() {
    /// As many boxes as are cheaper to filter from the root than to keep in a tree; few large ones overlap most movers.
    constexpr uint32_t mostWithoutTree = 32;
    m_candidates.clear();
    if (!m_trees.IsRestingApart()) return false;
    const SlotRange resting = m_store.Resting();
    if (TakesCandidates() && resting.count <= mostWithoutTree) {
        CollectItems(m_store, resting, m_candidates);
        return false;
    }
    if (m_store.Moving().count == 0) return false;
    const TreeEdits& edits = m_trees.restingEdits;
    if (edits.IsStale() || (!TakesCandidates() && edits.Count() > 0)) BuildResting();
    Collect(edits.Outside(), m_candidates);
    return true;
}

void TreeBroadPhase::FindPairs(std::vector<Pair>& pairs) {
    m_stats = {};
    m_hasChanged = false;
    m_trees.Choose();
    m_stats.staticTreeSeparate = m_trees.IsRestingApart();
    PairSink sink(pairs);
    const bool meetsTree = PrepareResting();
    Collect(m_trees.mainEdits.Outside(), m_outside);
    if (RefitAndDetect(m_trees.main, m_trees.mainEdits, m_outside, sink)) {
        m_trees.mainEdits.NoteRefitted();
        m_stats.rebuiltProxies += m_trees.MainSlots().count;
    } else {
        m_outside.clear();
        BuildAndDetect(m_trees.MainSlots(), m_trees.main, sink);
        NoteMainBuilt();
    }
    if (meetsTree) DetectBetween(m_trees.main, m_outside, m_trees.resting, sink);
    sink.Finish();
}

uint64_t TreeBroadPhase::Query(const AABB& box, Visitor visit) const {
    uint64_t boxTests = 0;
    m_trees.Query(box, boxTests, visit);
    return boxTests;
}

uint64_t TreeBroadPhase::CastBox(const RayCastInput& path, Vec2 halfSize, RayVisitor visit) const {
    uint64_t boxTests = 0;
    m_trees.CastBox(path, halfSize, boxTests, visit);
    return boxTests;
}

void TreeBroadPhase::PrepareStatic() {
    if (m_trees.IsRestingApart()) {
        if (m_trees.IsRestingStale()) BuildResting();
        return;
    }
    if (m_isStaticIndexStale) Build(m_store.Statics(), m_staticIndex);
    m_isStaticIndexStale = false;
}

uint64_t TreeBroadPhase::QueryStatic(const AABB& box, Visitor visit) const {
    uint64_t boxTests = 0;
    if (m_trees.IsRestingApart()) {
        m_trees.QueryResting(box, boxTests, visit);
    } else if (m_isStaticIndexStale) {
        return Query(box, visit);
    } else {
        m_staticIndex.Query(box, boxTests, [&](ItemId id) { return visit(id.fixture); });
    }
    return boxTests;
}

void TreeBroadPhase::QueryResting(const AABB& box, Visitor visit) {
    if (!m_trees.IsRestingApart()) return BroadPhase::QueryResting(box, visit);
    if (m_trees.IsRestingStale()) BuildResting();
    m_trees.QueryResting(box, m_stats.boxTests, visit);
}

void TreeBroadPhase::GetNodes(std::vector<BvhNode>& nodes) {
    m_trees.RefuseEdits();
    PrepareQueries();
    WriteNodes(m_trees.main, m_trees.resting, m_rule, nodes);
}

size_t TreeBroadPhase::GetMemoryBytes() const {
    return m_store.GetMemoryBytes() + m_trees.GetMemoryBytes() + m_staticIndex.GetMemoryBytes() +
           m_batch.capacity() * sizeof(BatchItem) +
           (m_items.capacity() + m_candidates.capacity() + m_outside.capacity()) * sizeof(BuildItem) + GetBufferBytes();
}

}  // namespace scree::broadphase
