// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Queries by a scan of all boxes: box or ray in, visited fixtures out, O(n).

#include "broad_phase/linear_broad_phase.h"

#include "broad_phase/ray_probe.h"

namespace scree::broadphase {

uint64_t LinearBroadPhase::Query(const AABB& box, Visitor visit) const {
    for (uint32_t slot = 0; slot < m_store.Size(); ++slot) {
        if (TestOverlap(m_store.Box(slot), box) && !visit(m_store.Id(slot).fixture)) return slot + 1;
    }
    return m_store.Size();
}

uint64_t LinearBroadPhase::CastBox(const RayCastInput& path, Vec2 halfSize, RayVisitor visit) const {
    RayProbe ray(path, halfSize);
    for (uint32_t slot = 0; slot < m_store.Size(); ++slot) {
        if (!ray.MayHitLeaf(m_store.Box(slot))) continue;
        if (ray.Visit(visit, m_store.Id(slot).fixture) == RayStep::stop) return slot + 1;
    }
    return m_store.Size();
}

}  // namespace scree::broadphase
