// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Pairs of overlapping fat boxes. Programs may use one by themselves; a world shows its own by
// GetContactManager().m_broadPhase, whose proxies carry b2FixtureProxy.

#pragma once

#include <utility>
#include <vector>

#include "b2_api.h"
#include "b2_collision.h"
#include "b2_dynamic_tree.h"
#include "b2_settings.h"

class b2World;
struct b2Bridge;

struct B2_API b2Pair {
    int32 proxyIdA;
    int32 proxyIdB;
};

class B2_API b2BroadPhase {
public:
    enum { e_nullProxy = -1 };

    b2BroadPhase();
    ~b2BroadPhase();

    int32 CreateProxy(const b2AABB& aabb, void* userData);
    void DestroyProxy(int32 proxyId);
    void MoveProxy(int32 proxyId, const b2AABB& aabb, const b2Vec2& displacement);
    /// Reports the proxy's pairs again in the next UpdatePairs.
    void TouchProxy(int32 proxyId);
    const b2AABB& GetFatAABB(int32 proxyId) const;
    void* GetUserData(int32 proxyId) const;
    bool TestOverlap(int32 proxyIdA, int32 proxyIdB) const;
    int32 GetProxyCount() const;

    /// Calls callback->AddPair(userDataA, userDataB) for each pair of a proxy that is new, moved or touched.
    template <typename T>
    void UpdatePairs(T* callback);
    /// As in b2DynamicTree.
    template <typename T>
    void Query(T* callback, const b2AABB& aabb) const;
    template <typename T>
    void RayCast(T* callback, const b2RayCastInput& input) const;

    int32 GetTreeHeight() const;
    int32 GetTreeBalance() const;
    float GetTreeQuality() const;
    void ShiftOrigin(const b2Vec2& newOrigin);

private:
    friend class b2DynamicTree;
    friend struct b2Bridge;

    bool QueryCallback(int32 proxyId);
    void FindPairs();
    /// The tree; of a world: brought up to date first.
    const b2DynamicTree& Tree() const;

    mutable b2DynamicTree m_tree;
    mutable int32 m_proxyCount;
    std::vector<int32> m_moved;
    std::vector<b2Pair> m_pairs;
    int32 m_queryProxyId;
    const b2World* m_world;  ///< whose broad phase this shows, or null
    mutable bool m_stale;
};

template <typename T>
inline void b2BroadPhase::UpdatePairs(T* callback) {
    FindPairs();
    for (const b2Pair& pair : m_pairs) callback->AddPair(GetUserData(pair.proxyIdA), GetUserData(pair.proxyIdB));
}

template <typename T>
inline void b2BroadPhase::Query(T* callback, const b2AABB& aabb) const {
    Tree().Query(callback, aabb);
}

template <typename T>
inline void b2BroadPhase::RayCast(T* callback, const b2RayCastInput& input) const {
    Tree().RayCast(callback, input);
}
