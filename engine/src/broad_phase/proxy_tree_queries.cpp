// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Queries over trees and edited proxies together: what a tree says about an edited proxy is ignored, and the list of
// edited ones is scanned; of a stale tree all its proxies are.

#include "broad_phase/proxy_trees.h"

namespace scree::broadphase {

bool ProxyTrees::IsCurrent(uint32_t fixture, const FlatTree& from) const {
    const uint32_t slot = m_store.Find(fixture);
    if (slot == noSlot || m_store.Pending(slot) != notPending) return false;
    // A fixture removed and inserted again with another motion type can be in both trees.
    return !m_areStaticsApart || m_store.IsStatic(slot) == (&from == &statics);
}

ProxyTrees::Part ProxyTrees::MainPart() const {
    // Statics that have no tree of their own are edited beside the main one.
    const std::span<const uint32_t> staticOnes =
        m_areStaticsApart ? std::span<const uint32_t>() : staticEdits.Pending();
    return {main, MainSlots(), IsMainStale(), moverEdits.Pending(), staticOnes};
}

ProxyTrees::Part ProxyTrees::StaticPart() const {
    if (!m_areStaticsApart) return {statics, {}, false, {}, {}};
    return {statics, m_store.Statics(), AreStaticsStale(), staticEdits.Pending(), {}};
}

bool ProxyTrees::QueryPart(const Part& part, const AABB& box, uint64_t& boxTests, Visitor visit) const {
    if (part.isStale) {
        for (uint32_t slot = part.slots.first; slot < part.slots.first + part.slots.count; ++slot, ++boxTests) {
            if (TestOverlap(m_store.Box(slot), box) && !visit(m_store.Id(slot).fixture)) return false;
        }
        return true;
    }
    const bool edited = IsEdited();
    const auto check = [&](ItemId id) { return (edited && !IsCurrent(id.fixture, part.tree)) || visit(id.fixture); };
    if (!part.tree.Query(box, boxTests, check)) return false;
    for (const std::span<const uint32_t> edits : {part.edits, part.moreEdits}) {
        boxTests += edits.size();
        for (const uint32_t fixture : edits) {
            if (TestOverlap(m_store.Box(m_store.Find(fixture)), box) && !visit(fixture)) return false;
        }
    }
    return true;
}

bool ProxyTrees::Query(const AABB& box, uint64_t& boxTests, Visitor visit) const {
    return QueryPart(MainPart(), box, boxTests, visit) && QueryPart(StaticPart(), box, boxTests, visit);
}

bool ProxyTrees::QueryStatics(const AABB& box, uint64_t& boxTests, Visitor visit) const {
    return QueryPart(StaticPart(), box, boxTests, visit);
}

RayStep ProxyTrees::RayCastPart(const Part& part, RayProbe& ray, uint64_t& boxTests, RayVisitor visit) const {
    if (part.isStale) {
        for (uint32_t slot = part.slots.first; slot < part.slots.first + part.slots.count; ++slot, ++boxTests) {
            if (!ray.MayHitLeaf(m_store.Box(slot))) continue;
            if (ray.Visit(visit, m_store.Id(slot).fixture) == RayStep::stop) return RayStep::stop;
        }
        return RayStep::goOn;
    }
    const bool edited = IsEdited();
    const auto check = [&](ItemId id) {
        return edited && !IsCurrent(id.fixture, part.tree) ? RayStep::goOn : ray.Visit(visit, id.fixture);
    };
    if (part.tree.RayCast(ray, boxTests, check) == RayStep::stop) return RayStep::stop;
    for (const std::span<const uint32_t> edits : {part.edits, part.moreEdits}) {
        boxTests += edits.size();
        for (const uint32_t fixture : edits) {
            if (!ray.MayHitLeaf(m_store.Box(m_store.Find(fixture)))) continue;
            if (ray.Visit(visit, fixture) == RayStep::stop) return RayStep::stop;
        }
    }
    return RayStep::goOn;
}

void ProxyTrees::RayCast(const RayCastInput& input, uint64_t& boxTests, RayVisitor visit) const {
    RayProbe ray(input);
    if (RayCastPart(MainPart(), ray, boxTests, visit) == RayStep::stop) return;
    (void)RayCastPart(StaticPart(), ray, boxTests, visit);
}

}  // namespace scree::broadphase
