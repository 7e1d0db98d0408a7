// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Queries by a scan of all boxes: box or ray in, visited fixtures out, O(n).

#include "broad_phase/linear_broad_phase.h"

#include "broad_phase/ray_probe.h"

namespace scree::broadphase {

void LinearBroadPhase::Query(const AABB& box, const std::function<bool(uint32_t)>& visit) {
    m_stats.boxTests += m_store.Size();
    for (uint32_t slot = 0; slot < m_store.Size(); ++slot) {
        if (TestOverlap(m_store.Box(slot), box) && !visit(m_store.Id(slot).fixture)) return;
    }
}

void LinearBroadPhase::RayCast(const RayCastInput& input,
                               const std::function<float(const RayCastInput&, uint32_t)>& visit) {
    m_stats.boxTests += m_store.Size();
    RayProbe ray(input);
    for (uint32_t slot = 0; slot < m_store.Size(); ++slot) {
        if (!ray.MayHitLeaf(m_store.Box(slot))) continue;
        if (ray.Visit(visit, m_store.Id(slot).fixture) == RayStep::stop) return;
    }
}

}  // namespace scree::broadphase
