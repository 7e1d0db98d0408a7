// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The trees over the proxies of a store: a main tree, and one of the statics while their share is above a threshold
// (Tsamis 2020, §3.7.1), which is rebuilt only after statics were edited. Says which trees there are, when they are due
// and what they hold, and answers queries over trees and edited proxies together. Building is the owner's.

#pragma once

#include <cstdint>
#include <functional>

#include "broad_phase/flat_tree.h"
#include "broad_phase/proxy_store.h"
#include "broad_phase/tree_edits.h"

namespace scree::broadphase {

class ProxyTrees {
public:
    using Visitor = std::function<bool(uint32_t)>;
    using RayVisitor = std::function<float(const RayCastInput&, uint32_t)>;

    ProxyTrees(ProxyStore& store, float staticShareThreshold)
        : moverEdits(store), staticEdits(store), m_store(store), m_staticShareThreshold(staticShareThreshold) {}

    FlatTree main;     ///< movers, and statics unless they are apart
    FlatTree statics;  ///< empty unless they are apart
    TreeEdits moverEdits, staticEdits;

    [[nodiscard]] bool AreStaticsApart() const { return m_areStaticsApart; }
    [[nodiscard]] SlotRange MainSlots() const { return m_areStaticsApart ? m_store.Movers() : m_store.All(); }
    [[nodiscard]] TreeEdits& EditsOf(uint32_t slot) { return m_store.IsStatic(slot) ? staticEdits : moverEdits; }
    [[nodiscard]] bool IsMainStale() const {
        return moverEdits.IsStale() || (!m_areStaticsApart && staticEdits.IsStale());
    }
    [[nodiscard]] bool AreStaticsStale() const { return m_areStaticsApart && staticEdits.IsStale(); }

    /// Decides whether statics have a tree of their own from now on; if that changes, all trees are stale.
    void Choose();
    /// The owner has built one of the trees.
    void NoteMainBuilt();
    void NoteStaticsBuilt() { staticEdits.Forget(false); }
    /// Makes trees stale that do not describe every proxy.
    void RefuseEdits();

    /// Visits the fixtures of both trees, or of the static tree, as BroadPhase::Query does; none of them may be stale.
    /// Adds to `boxTests`.
    void Query(const AABB& box, uint64_t& boxTests, const Visitor& visit);
    void QueryStatics(const AABB& box, uint64_t& boxTests, const Visitor& visit);
    void RayCast(const RayCastInput& input, uint64_t& boxTests, const RayVisitor& visit);

    [[nodiscard]] size_t GetMemoryBytes() const;

private:
    bool QueryTree(const FlatTree& tree, const AABB& box, uint64_t& boxTests, const Visitor& visit);
    bool QueryEdits(const TreeEdits& edits, const AABB& box, uint64_t& boxTests, const Visitor& visit);
    [[nodiscard]] bool IsEdited() const { return moverEdits.Count() + staticEdits.Count() > 0; }
    [[nodiscard]] bool IsCurrent(uint32_t fixture, const FlatTree& from) const;

    ProxyStore& m_store;
    const float m_staticShareThreshold;
    bool m_areStaticsApart = false;
};

}  // namespace scree::broadphase
