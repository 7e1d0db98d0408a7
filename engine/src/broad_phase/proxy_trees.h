// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The trees over the proxies of a store: a main tree, and one of the statics while their share is above a threshold
// (Tsamis 2020, §3.7.1), which is rebuilt only after statics were edited. Says which trees there are, when they are due
// and what they hold, and answers queries over trees and edited proxies together. Building is the owner's.

#pragma once

#include <cstdint>
#include <span>

#include "broad_phase/flat_tree.h"
#include "broad_phase/proxy_store.h"
#include "broad_phase/tree_edits.h"

namespace scree::broadphase {

class ProxyTrees {
public:
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

    /// Visits the fixtures of both trees, or of the static tree, as BroadPhase::Query does: the proxies of a stale tree
    /// are scanned. Adds to `boxTests`; false if the visitor ended it.
    bool Query(const AABB& box, uint64_t& boxTests, Visitor visit) const;
    bool QueryStatics(const AABB& box, uint64_t& boxTests, Visitor visit) const;
    void RayCast(const RayCastInput& input, uint64_t& boxTests, RayVisitor visit) const;

    [[nodiscard]] size_t GetMemoryBytes() const;

private:
    /// Where the proxies of a tree are found: in it and in lists of edits, or by a scan of their slots.
    struct Part {
        const FlatTree& tree;
        SlotRange slots;
        bool isStale;
        std::span<const uint32_t> edits, moreEdits;
    };
    [[nodiscard]] Part MainPart() const;
    [[nodiscard]] Part StaticPart() const;
    bool QueryPart(const Part& part, const AABB& box, uint64_t& boxTests, Visitor visit) const;
    RayStep RayCastPart(const Part& part, RayProbe& ray, uint64_t& boxTests, RayVisitor visit) const;
    [[nodiscard]] bool IsEdited() const { return moverEdits.Count() + staticEdits.Count() > 0; }
    [[nodiscard]] bool IsCurrent(uint32_t fixture, const FlatTree& from) const;

    ProxyStore& m_store;
    const float m_staticShareThreshold;
    bool m_areStaticsApart = false;
};

}  // namespace scree::broadphase
