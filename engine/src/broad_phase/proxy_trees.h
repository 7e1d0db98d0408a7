// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The trees over the proxies of a store: a main tree, and one of what rests (statics and sleepers). The latter exists
// while its share is above a threshold (Tsamis 2020, §3.7.1, where it is statics alone); it follows edits and is
// rebuilt rarely. Says which trees there are, when they are due and what they hold. Answers queries over trees and what
// is outside of them together. Building is the owner's.

#pragma once

#include <cstdint>

#include "broad_phase/flat_tree.h"
#include "broad_phase/proxy_store.h"
#include "broad_phase/tree_edits.h"

namespace scree::broadphase {

class ProxyTrees {
public:
    ProxyTrees(ProxyStore& store, float restingShareThreshold)
        : mainEdits(store, main),
          restingEdits(store, resting),
          m_store(store),
          m_restingShareThreshold(restingShareThreshold) {}

    FlatTree main;     ///< what moves, and what rests unless that is apart
    FlatTree resting;  ///< empty unless it is apart
    TreeEdits mainEdits, restingEdits;

    [[nodiscard]] bool IsRestingApart() const { return m_isRestingApart; }
    [[nodiscard]] SlotRange MainSlots() const { return m_isRestingApart ? m_store.Moving() : m_store.All(); }
    /// Of the part that a proxy belongs to.
    [[nodiscard]] TreeEdits& EditsOf(uint32_t slot) {
        return m_isRestingApart && m_store.IsResting(slot) ? restingEdits : mainEdits;
    }
    [[nodiscard]] bool IsRestingStale() const { return m_isRestingApart && restingEdits.IsStale(); }

    /// Decides whether what rests has a tree of its own from now on; if that changes, both trees are lost.
    void Choose();
    /// Lets a mover rest, or rouses it.
    void SetResting(uint32_t slot, bool resting);
    /// Loses trees that do not hold every proxy.
    void RefuseEdits();

    /// Visits the fixtures of both trees, or of the resting one, as BroadPhase::Query does: the proxies of a stale tree
    /// are scanned. Adds to `boxTests`; false if the visitor ended it.
    bool Query(const AABB& box, uint64_t& boxTests, Visitor visit) const;
    bool QueryResting(const AABB& box, uint64_t& boxTests, Visitor visit) const;
    void CastBox(const RayCastInput& path, Vec2 halfSize, uint64_t& boxTests, RayVisitor visit) const;

    [[nodiscard]] size_t GetMemoryBytes() const;

private:
    /// Where the proxies of a tree are found: in it and outside, or by a scan of their slots.
    struct Part {
        const FlatTree& tree;
        const TreeEdits& edits;
        SlotRange slots;
    };
    [[nodiscard]] Part MainPart() const { return {main, mainEdits, MainSlots()}; }
    [[nodiscard]] Part RestingPart() const { return {resting, restingEdits, m_store.Resting()}; }
    bool QueryPart(const Part& part, const AABB& box, uint64_t& boxTests, Visitor visit) const;
    RayStep CastPart(const Part& part, RayProbe& ray, uint64_t& boxTests, RayVisitor visit) const;

    ProxyStore& m_store;
    const float m_restingShareThreshold;
    bool m_isRestingApart = false;
};

}  // namespace scree::broadphase
