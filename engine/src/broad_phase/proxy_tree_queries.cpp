// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Queries over trees and what is outside of them; of a stale tree all its proxies are scanned.

#include "broad_phase/proxy_trees.h"

namespace scree::broadphase {

bool ProxyTrees::QueryPart(const Part& part, const AABB& box, uint64_t& boxTests, Visitor visit) const {
    if (part.edits.IsStale()) {
        for (uint32_t slot = part.slots.first; slot < part.slots.first + part.slots.count; ++slot, ++boxTests) {
            if (TestOverlap(m_store.Box(slot), box) && !visit(m_store.Id(slot).fixture)) return false;
        }
        return true;
    }
    if (!part.tree.Query(box, boxTests, [&](ItemId id) { return visit(id.fixture); })) return false;
    boxTests += part.edits.Outside().size();
    for (const uint32_t fixture : part.edits.Outside()) {
        if (TestOverlap(m_store.Box(m_store.Find(fixture)), box) && !visit(fixture)) return false;
    }
    return true;
}

bool ProxyTrees::Query(const AABB& box, uint64_t& boxTests, Visitor visit) const {
    if (!QueryPart(MainPart(), box, boxTests, visit)) return false;
    return !m_isRestingApart || QueryResting(box, boxTests, visit);
}

bool ProxyTrees::QueryResting(const AABB& box, uint64_t& boxTests, Visitor visit) const {
    return QueryPart(RestingPart(), box, boxTests, visit);
}

RayStep ProxyTrees::CastPart(const Part& part, RayProbe& ray, uint64_t& boxTests, RayVisitor visit) const {
    if (part.edits.IsStale()) {
        for (uint32_t slot = part.slots.first; slot < part.slots.first + part.slots.count; ++slot, ++boxTests) {
            if (!ray.MayHitLeaf(m_store.Box(slot))) continue;
            if (ray.Visit(visit, m_store.Id(slot).fixture) == RayStep::stop) return RayStep::stop;
        }
        return RayStep::goOn;
    }
    const auto check = [&](ItemId id) { return ray.Visit(visit, id.fixture); };
    if (part.tree.RayCast(ray, boxTests, check) == RayStep::stop) return RayStep::stop;
    boxTests += part.edits.Outside().size();
    for (const uint32_t fixture : part.edits.Outside()) {
        if (!ray.MayHitLeaf(m_store.Box(m_store.Find(fixture)))) continue;
        if (ray.Visit(visit, fixture) == RayStep::stop) return RayStep::stop;
    }
    return RayStep::goOn;
}

void ProxyTrees::CastBox(const RayCastInput& path, Vec2 halfSize, uint64_t& boxTests, RayVisitor visit) const {
    RayProbe ray(path, halfSize);
    if (CastPart(MainPart(), ray, boxTests, visit) == RayStep::stop) return;
    if (m_isRestingApart) (void)CastPart(RestingPart(), ray, boxTests, visit);
}

}  // namespace scree::broadphase
