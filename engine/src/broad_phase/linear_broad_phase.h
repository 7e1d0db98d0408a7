// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the algorithms without a tree share: the proxy store, queries and ray casts by a scan of all boxes.

#pragma once

#include "broad_phase/broad_phase.h"
#include "broad_phase/proxy_store.h"

namespace scree::broadphase {

class LinearBroadPhase : public BroadPhase {
public:
    void Insert(uint32_t fixture, uint32_t body, Motion motion, const AABB& box) override {
        m_store.Insert(fixture, body, motion, box);
    }
    void Update(uint32_t fixture, const AABB& box, Vec2 /*displacement*/) override {
        m_store.SetBox(m_store.Find(fixture), box);
    }
    void Remove(uint32_t fixture) override { m_store.Remove(m_store.Find(fixture)); }

    uint64_t Query(const AABB& box, Visitor visit) const override;
    uint64_t CastBox(const RayCastInput& path, Vec2 halfSize, RayVisitor visit) const override;

    [[nodiscard]] AABB GetBox(uint32_t fixture) const override { return m_store.Box(m_store.Find(fixture)); }
    [[nodiscard]] int GetProxyCount() const override { return static_cast<int>(m_store.Size()); }
    void GetNodes(std::vector<BvhNode>& nodes) override { nodes.clear(); }
    [[nodiscard]] int GetLeafSize() const override { return 0; }
    [[nodiscard]] size_t GetMemoryBytes() const override { return m_store.GetMemoryBytes(); }
    [[nodiscard]] BroadPhaseStats GetStats() const override { return m_stats; }

protected:
    ProxyStore m_store;
    BroadPhaseStats m_stats;
};

}  // namespace scree::broadphase
