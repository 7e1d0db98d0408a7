// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// b2BroadPhase by itself is a tree with a move buffer. The one a world shows is a copy of the world's boxes, made when
// a program looks into it; its statistics are those of the engine's own tree.

#include "../box2d/b2_broad_phase.h"

#include <algorithm>

#include "convert.h"
#include "world_data.h"

b2BroadPhase::b2BroadPhase() : m_proxyCount(0), m_queryProxyId(e_nullProxy), m_world(nullptr), m_stale(false) {}
b2BroadPhase::~b2BroadPhase() = default;

int32 b2BroadPhase::CreateProxy(const b2AABB& aabb, void* userData) {
    const int32 proxyId = m_tree.CreateProxy(aabb, userData);
    if (proxyId == e_nullProxy) return proxyId;
    ++m_proxyCount;
    m_moved.push_back(proxyId);
    return proxyId;
}

void b2BroadPhase::DestroyProxy(int32 proxyId) {
    std::erase(m_moved, proxyId);
    --m_proxyCount;
    m_tree.DestroyProxy(proxyId);
}

void b2BroadPhase::MoveProxy(int32 proxyId, const b2AABB& aabb, const b2Vec2& displacement) {
    const bool buffered = m_tree.WasMoved(proxyId);
    if (m_tree.MoveProxy(proxyId, aabb, displacement) && !buffered) m_moved.push_back(proxyId);
}

void b2BroadPhase::TouchProxy(int32 proxyId) {
    if (std::find(m_moved.begin(), m_moved.end(), proxyId) == m_moved.end()) m_moved.push_back(proxyId);
}

const b2AABB& b2BroadPhase::GetFatAABB(int32 proxyId) const { return Tree().GetFatAABB(proxyId); }
void* b2BroadPhase::GetUserData(int32 proxyId) const { return Tree().GetUserData(proxyId); }
bool b2BroadPhase::TestOverlap(int32 proxyIdA, int32 proxyIdB) const {
    const b2AABB a = GetFatAABB(proxyIdA);
    return b2TestOverlap(a, GetFatAABB(proxyIdB));
}
int32 b2BroadPhase::GetProxyCount() const { return m_world != nullptr ? m_world->GetProxyCount() : m_proxyCount; }

bool b2BroadPhase::QueryCallback(int32 proxyId) {
    // Of two moved proxies the one with the larger id reports the pair.
    if (proxyId == m_queryProxyId) return true;
    if (m_tree.WasMoved(proxyId) && proxyId > m_queryProxyId) return true;
    m_pairs.push_back({b2Min(proxyId, m_queryProxyId), b2Max(proxyId, m_queryProxyId)});
    return true;
}

void b2BroadPhase::FindPairs() {
    m_pairs.clear();
    for (const int32 proxyId : m_moved) {
        m_queryProxyId = proxyId;
        m_tree.Query(this, b2AABB(m_tree.GetFatAABB(proxyId)));
    }
    for (const int32 proxyId : m_moved) m_tree.ClearMoved(proxyId);
    m_moved.clear();
}

int32 b2BroadPhase::GetTreeHeight() const { return m_world != nullptr ? m_world->GetTreeHeight() : m_tree.GetHeight(); }
int32 b2BroadPhase::GetTreeBalance() const {
    return m_world != nullptr ? m_world->GetTreeBalance() : m_tree.GetMaxBalance();
}
float b2BroadPhase::GetTreeQuality() const {
    return m_world != nullptr ? m_world->GetTreeQuality() : m_tree.GetAreaRatio();
}
void b2BroadPhase::ShiftOrigin(const b2Vec2& newOrigin) { m_tree.ShiftOrigin(newOrigin); }

const b2DynamicTree& b2BroadPhase::Tree() const {
    if (m_world == nullptr || !m_stale) return m_tree;
    m_stale = false;
    m_tree.Clear();
    for (const b2Body* body = m_world->GetBodyList(); body != nullptr; body = body->GetNext()) {
        for (const b2Fixture* f = body->GetFixtureList(); f != nullptr && body->IsEnabled(); f = f->GetNext()) {
            for (int32 i = 0; i < b2Bridge::ChildCount(*f); ++i) {
                b2FixtureProxy& proxy = b2Bridge::Proxy(*f, i);
                proxy.proxyId = m_tree.CreateProxy(f->GetAABB(i), &proxy);
            }
        }
    }
    return m_tree;
}

void b2Bridge::ShowWorld(b2BroadPhase& broadPhase, const b2World* world) {
    broadPhase.m_world = world;
    broadPhase.m_stale = true;
}

void b2Bridge::Touch(b2WorldData& data) {
    data.contactsStale = true;
    data.manager.m_broadPhase.m_stale = true;
}
