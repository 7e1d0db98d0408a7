// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Bookkeeping around the rebuilt trees: which proxies a tree no longer describes, when it must be rebuilt, whether
// statics have a tree of their own, and queries over trees and edited proxies together.

#include "broad_phase/tree_broad_phase.h"

#include <algorithm>
#include <cmath>

namespace scree::broadphase {
namespace {

/// A scanned box costs about a fortieth of a rebuilt one, which makes √(40·n) edits per rebuild the cheapest.
uint32_t EditLimit(uint32_t proxies) {
    return std::max(64u, static_cast<uint32_t>(std::sqrt(40.0f * static_cast<float>(proxies))));
}

}  // namespace

TreeBroadPhase::TreeBroadPhase(const BroadPhaseConfig& config, SplitRule rule, int leafSize)
    : m_rule(rule),
      m_leafSize(static_cast<uint32_t>(config.leafSize > 0 ? config.leafSize : leafSize)),
      m_staticShareThreshold(config.staticShareThreshold) {}

void TreeBroadPhase::ForgetEdits(Edits& edits, bool stale) {
    for (const uint32_t fixture : edits.pending) m_store.Pending(m_store.Find(fixture)) = notPending;
    edits.pending.clear();
    edits.count = 0;
    edits.limit = EditLimit(m_store.Size());
    edits.stale = stale;
}

void TreeBroadPhase::NoteEdit(Edits& edits) {
    if (!edits.stale && ++edits.count > edits.limit) ForgetEdits(edits, true);
}

void TreeBroadPhase::MarkPending(uint32_t slot) {
    Edits& edits = EditsOf(slot);
    if (edits.stale || m_store.Pending(slot) != notPending) return;
    NoteEdit(edits);
    if (edits.stale) return;
    m_store.Pending(slot) = static_cast<uint32_t>(edits.pending.size());
    edits.pending.push_back(m_store.Id(slot).fixture);
}

void TreeBroadPhase::Insert(uint32_t fixture, uint32_t body, Motion motion, const AABB& box) {
    m_staticIndexStale = m_staticIndexStale || motion == Motion::isStatic;
    MarkPending(m_store.Insert(fixture, body, motion, box));
}

void TreeBroadPhase::Update(uint32_t fixture, const AABB& box, Vec2 /*displacement*/) {
    const uint32_t slot = m_store.Find(fixture);
    m_staticIndexStale = m_staticIndexStale || m_store.IsStatic(slot);
    m_store.SetBox(slot, box);
    MarkPending(slot);
}

void TreeBroadPhase::UpdateMany(std::span<const BoxUpdate> updates) {
    // More than the trees can leave aside: nothing need be noted one by one.
    if (!m_moverEdits.stale && updates.size() > m_moverEdits.limit) ForgetEdits(m_moverEdits, true);
    for (const BoxUpdate& update : updates) {
        const uint32_t slot = m_store.Find(update.fixture);
        m_store.SetBox(slot, update.box);
        if (m_moverEdits.stale && !m_store.IsStatic(slot)) continue;
        m_staticIndexStale = m_staticIndexStale || m_store.IsStatic(slot);
        MarkPending(slot);
    }
}

void TreeBroadPhase::Remove(uint32_t fixture) {
    const uint32_t slot = m_store.Find(fixture);
    m_staticIndexStale = m_staticIndexStale || m_store.IsStatic(slot);
    Edits& edits = EditsOf(slot);
    if (const uint32_t at = m_store.Pending(slot); at != notPending) {
        edits.pending[at] = edits.pending.back();
        m_store.Pending(m_store.Find(edits.pending[at])) = at;
        edits.pending.pop_back();
    }
    m_store.Remove(slot);
    NoteEdit(edits);
}

void TreeBroadPhase::ChooseTrees() {
    const float limit = m_staticShareThreshold * static_cast<float>(m_store.Size());
    const bool separate = static_cast<float>(m_store.StaticCount()) > limit;
    if (separate == m_separate) return;
    m_separate = separate;
    ForgetEdits(m_moverEdits, true);
    ForgetEdits(m_staticEdits, true);
    m_statics.Reset(0);
}

void TreeBroadPhase::MainTreeBuilt() {
    m_stats.rebuiltProxies += MainSlots().count;
    ForgetEdits(m_moverEdits, false);
    if (!m_separate) ForgetEdits(m_staticEdits, false);
}

void TreeBroadPhase::BuildStatics() {
    Build(Statics(), m_statics);
    m_stats.rebuiltProxies += m_store.StaticCount();
    ForgetEdits(m_staticEdits, false);
}

void TreeBroadPhase::Build(SlotRange slots, FlatTree& tree) {
    CollectItems(m_store, slots, m_items);
    BuildTopDown(m_items, m_rule, m_leafSize, tree);
}

void TreeBroadPhase::DetectBetween(const FlatTree& movers, const FlatTree& statics, PairSink& sink) {
    m_stats.boxTests += QueryBatch(movers, statics, m_batch, sink);
}

void TreeBroadPhase::FindPairs(std::vector<Pair>& pairs) {
    m_stats = {};
    ChooseTrees();
    m_stats.staticTreeSeparate = m_separate;
    PairSink sink(pairs);
    const bool asCandidates = m_separate && m_store.StaticCount() <= MaxRootCandidates();
    m_rootCandidates = asCandidates ? Statics() : SlotRange{};
    BuildAndDetect(MainSlots(), m_main, sink);
    MainTreeBuilt();
    if (m_separate && !asCandidates && m_store.MoverCount() > 0) {
        if (m_staticEdits.stale || m_staticEdits.count > 0) BuildStatics();
        DetectBetween(m_main, m_statics, sink);
    }
    sink.Finish();
}

void TreeBroadPhase::RefreshStale() {
    if (m_moverEdits.stale || (!m_separate && m_staticEdits.stale)) {
        ChooseTrees();
        Build(MainSlots(), m_main);
        MainTreeBuilt();
    }
    if (m_separate && m_staticEdits.stale) BuildStatics();
}

void TreeBroadPhase::RefreshAll() {
    if (m_moverEdits.count > 0) ForgetEdits(m_moverEdits, true);
    if (m_staticEdits.count > 0) ForgetEdits(m_staticEdits, true);
    RefreshStale();
}

bool TreeBroadPhase::IsCurrent(uint32_t fixture, bool fromStaticTree) {
    const uint32_t slot = m_store.Find(fixture);
    if (slot == noSlot || m_store.Pending(slot) != notPending) return false;
    // A fixture removed and inserted again with another motion type can be in both trees.
    return !m_separate || m_store.IsStatic(slot) == fromStaticTree;
}

bool TreeBroadPhase::QueryTree(bool staticTree, const AABB& box, const std::function<bool(uint32_t)>& visit) {
    const bool edited = m_moverEdits.count + m_staticEdits.count > 0;
    const auto check = [&](ItemId id) { return (edited && !IsCurrent(id.fixture, staticTree)) || visit(id.fixture); };
    return (staticTree ? m_statics : m_main).Query(box, m_stats.boxTests, check);
}

bool TreeBroadPhase::QueryEdits(const Edits& edits, const AABB& box, const std::function<bool(uint32_t)>& visit) {
    m_stats.boxTests += edits.pending.size();
    for (const uint32_t fixture : edits.pending) {
        if (TestOverlap(m_store.Box(m_store.Find(fixture)), box) && !visit(fixture)) return false;
    }
    return true;
}

void TreeBroadPhase::Query(const AABB& box, const std::function<bool(uint32_t)>& visit) {
    RefreshStale();
    (void)(QueryTree(false, box, visit) && QueryTree(true, box, visit) && QueryEdits(m_moverEdits, box, visit) &&
           QueryEdits(m_staticEdits, box, visit));
}

void TreeBroadPhase::QueryStatic(const AABB& box, const std::function<bool(uint32_t)>& visit) {
    if (!m_separate) {
        if (m_staticIndexStale) Build(Statics(), m_staticIndex);
        m_staticIndexStale = false;
        m_staticIndex.Query(box, m_stats.boxTests, [&](ItemId id) { return visit(id.fixture); });
        return;
    }
    if (m_staticEdits.stale) BuildStatics();
    (void)(QueryTree(true, box, visit) && QueryEdits(m_staticEdits, box, visit));
}

void TreeBroadPhase::RayCast(const RayCastInput& input,
                             const std::function<float(const RayCastInput&, uint32_t)>& visit) {
    RefreshStale();
    const bool edited = m_moverEdits.count + m_staticEdits.count > 0;
    RayProbe ray(input);
    for (const FlatTree* tree : {&m_main, &m_statics}) {
        const bool isStaticTree = tree == &m_statics;
        const auto check = [&](ItemId id) {
            return edited && !IsCurrent(id.fixture, isStaticTree) ? RayStep::goOn : ray.Visit(visit, id.fixture);
        };
        if (tree->RayCast(ray, m_stats.boxTests, check) == RayStep::stop) return;
    }
    for (const Edits* edits : {&m_moverEdits, &m_staticEdits}) {
        m_stats.boxTests += edits->pending.size();
        for (const uint32_t fixture : edits->pending) {
            if (!ray.MayHitLeaf(m_store.Box(m_store.Find(fixture)))) continue;
            if (ray.Visit(visit, fixture) == RayStep::stop) return;
        }
    }
}

void TreeBroadPhase::GetNodes(std::vector<BvhNode>& nodes) {
    RefreshAll();
    nodes.clear();
    int32_t parent = -1;
    if (!m_main.Empty() && !m_statics.Empty()) {
        BvhNode root;
        root.box = Union(ToAabb(m_main.nodes[0].box), ToAabb(m_statics.nodes[0].box));
        nodes.push_back(root);
        parent = 0;
    }
    for (const FlatTree* tree : {&m_main, &m_statics}) {
        const auto index = static_cast<int32_t>(nodes.size());
        AppendNodes(*tree, m_rule, parent, nodes);
        if (parent == 0) (tree == &m_main ? nodes[0].child1 : nodes[0].child2) = index;
    }
}

size_t TreeBroadPhase::GetMemoryBytes() const {
    return m_store.GetMemoryBytes() + m_main.GetMemoryBytes() + m_statics.GetMemoryBytes() +
           m_staticIndex.GetMemoryBytes() +
           (m_moverEdits.pending.capacity() + m_staticEdits.pending.capacity()) * sizeof(uint32_t) +
           m_batch.capacity() * sizeof(BatchItem) + m_items.capacity() * sizeof(BuildItem) + GetBufferBytes();
}

}  // namespace scree::broadphase
