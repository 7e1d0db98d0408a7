// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A tree of boxes that programs may use by themselves. Proxies are fattened and keep their ids until destroyed.

#pragma once

#include <memory>

#include "b2_api.h"
#include "b2_collision.h"
#include "b2_growable_stack.h"

#define b2_nullNode (-1)

struct b2TreeData;

/// A node as Box2D's headers describe it. The tree here keeps its nodes to itself.
struct B2_API b2TreeNode {
    bool IsLeaf() const { return child1 == b2_nullNode; }

    b2AABB aabb;
    void* userData;
    union {
        int32 parent;
        int32 next;
    };
    int32 child1;
    int32 child2;
    int32 height;
    bool moved;
};

class B2_API b2DynamicTree {
public:
    b2DynamicTree();
    ~b2DynamicTree();

    /// The box is fattened by b2_aabbExtension. Returns the proxy's id, b2_nullNode for a box that is not valid.
    int32 CreateProxy(const b2AABB& aabb, void* userData);
    /// Functions with an id ignore one that does not exist.
    void DestroyProxy(int32 proxyId);
    /// True if the box left its fat box (or that had become much too large) and got a new one, stretched ahead.
    bool MoveProxy(int32 proxyId, const b2AABB& aabb1, const b2Vec2& displacement);
    void* GetUserData(int32 proxyId) const;
    bool WasMoved(int32 proxyId) const;
    void ClearMoved(int32 proxyId);
    const b2AABB& GetFatAABB(int32 proxyId) const;

    /// Calls callback->QueryCallback(proxyId) for each fat box that overlaps, until it returns false.
    template <typename T>
    void Query(T* callback, const b2AABB& aabb) const;
    /// Calls callback->RayCastCallback(input, proxyId) for each fat box on the way. It returns 0 to end, the new
    /// maxFraction to shorten the ray, or a negative value to leave it.
    template <typename T>
    void RayCast(T* callback, const b2RayCastInput& input) const;

    /// Reports a broken invariant in the log.
    void Validate() const;
    int32 GetHeight() const;
    /// The largest difference in height of two siblings.
    int32 GetMaxBalance() const;
    /// Sum of all perimeters over the root's.
    float GetAreaRatio() const;
    /// Slow: builds the tree anew, nearest boxes first.
    void RebuildBottomUp();
    void ShiftOrigin(const b2Vec2& newOrigin);

private:
    friend class b2BroadPhase;

    void Clear();
    void VisitBoxes(const b2AABB& aabb, bool (*visit)(void*, int32), void* context) const;
    void VisitRay(const b2RayCastInput& input, float (*visit)(void*, const b2RayCastInput&, int32),
                  void* context) const;

    std::unique_ptr<b2TreeData> m_data;
};

template <typename T>
inline void b2DynamicTree::Query(T* callback, const b2AABB& aabb) const {
    VisitBoxes(
        aabb, [](void* context, int32 id) -> bool { return static_cast<T*>(context)->QueryCallback(id); }, callback);
}

template <typename T>
inline void b2DynamicTree::RayCast(T* callback, const b2RayCastInput& input) const {
    VisitRay(
        input,
        [](void* context, const b2RayCastInput& part, int32 id) -> float {
            return static_cast<T*>(context)->RayCastCallback(part, id);
        },
        callback);
}
