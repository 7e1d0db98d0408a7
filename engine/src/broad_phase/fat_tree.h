// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A dynamic tree by Box2D 2.4's rules (b2DynamicTree, described in Catto 2019, Dynamic Bounding Volume Hierarchies).
// Boxes are inserted one by one where they enlarge the perimeter least, and rotations keep heights balanced. Boxes in,
// node links out. Which boxes and when is the business of its user; the rule of fattening stands here.

#pragma once

#include <cstdint>
#include <vector>

#include "broad_phase/bounds.h"
#include "broad_phase/pair_sink.h"
#include "broad_phase/ray_probe.h"
#include "broad_phase/small_stack.h"
#include "scree/settings.h"
#include "scree/shape.h"

namespace scree::broadphase {

inline constexpr uint32_t noNode = 0xFFFFFFFFu;

/// How far a box of a proxy is kept larger than it is (b2_aabbExtension, b2_aabbMultiplier).
struct FatMargin {
    float margin = aabbExtension;  ///< m on each side

    /// The box to keep for a proxy that moved by `displacement`: stretched ahead of it.
    [[nodiscard]] AABB Fatten(const AABB& box, Vec2 displacement = vec2Zero) const {
        AABB fat = Grow(box, margin);
        const Vec2 ahead = aabbMultiplier * displacement;
        (ahead.x < 0.0f ? fat.lowerBound.x : fat.upperBound.x) += ahead.x;
        (ahead.y < 0.0f ? fat.lowerBound.y : fat.upperBound.y) += ahead.y;
        return fat;
    }
    /// False if `stored` must be replaced by `fat`: the box left it, or it was stretched for a motion that is over and
    /// would go on catching pairs.
    [[nodiscard]] bool Keeps(const AABB& stored, const AABB& box, const AABB& fat) const {
        return stored.Contains(box) && Grow(fat, 4.0f * margin).Contains(stored);
    }

private:
    static AABB Grow(const AABB& box, float by) {
        return {{box.lowerBound.x - by, box.lowerBound.y - by}, {box.upperBound.x + by, box.upperBound.y + by}};
    }
};

struct FatNode {
    Bounds box;
    ItemId id;                 ///< of a leaf
    uint32_t parent = noNode;  ///< or the next free node
    uint32_t child1 = noNode, child2 = noNode;
    int32_t height = 0;  ///< leaf 0, free −1

    [[nodiscard]] bool IsLeaf() const { return child1 == noNode; }
};

class FatTree {
public:
    [[nodiscard]] uint32_t Root() const { return m_root; }
    [[nodiscard]] const FatNode& Node(uint32_t index) const { return m_nodes[index]; }
    /// One more than the largest node index ever used.
    [[nodiscard]] size_t NodeLimit() const { return m_nodes.size(); }
    [[nodiscard]] bool IsLiveLeaf(uint32_t index) const { return m_nodes[index].height == 0; }

    /// Adds a leaf and returns its node. O(log n).
    uint32_t CreateLeaf(const Bounds& box, ItemId id);
    void DestroyLeaf(uint32_t leaf);
    /// Gives a leaf a new box and a new place; its node index stays.
    void Reinsert(uint32_t leaf, const Bounds& box);
    /// Links the leaves anew, cheapest union first. Leaves keep their node indices. O(n³).
    void RebuildBottomUp();
    /// Subtracts `origin` from every box.
    void ShiftOrigin(Vec2 origin);

    /// Calls `visit(leaf)` for each leaf that overlaps, until it returns false.
    template <class Visit>
    void Query(const Bounds& box, uint64_t& boxTests, Visit&& visit) const {
        if (m_root == noNode) return;
        const F4 probe = ProbeOf(Load(box));
        SmallStack stack;
        stack.Push(m_root);
        while (!stack.Empty()) {
            const uint32_t index = stack.Pop();
            const FatNode& node = m_nodes[index];
            ++boxTests;
            if (!Overlaps(Load(node.box), probe)) continue;
            if (node.IsLeaf()) {
                if (!visit(index)) return;
            } else {
                stack.Push(node.child1);
                stack.Push(node.child2);
            }
        }
    }

    /// Calls `visit(leaf)` for each leaf that the ray may hit, near ones first, until it returns RayStep::stop.
    template <class Visit>
    void RayCast(const RayProbe& ray, uint64_t& boxTests, Visit&& visit) const {
        if (m_root == noNode) return;
        ++boxTests;
        if (!ray.MayHitNode(m_nodes[m_root].box)) return;
        SmallStack stack;
        stack.Push(m_root);
        while (!stack.Empty()) {
            const uint32_t index = stack.Pop();
            const FatNode& node = m_nodes[index];
            if (!ray.Reaches(node.box)) continue;  // a hit has shortened the ray since
            if (node.IsLeaf()) {
                if (ray.MayHitLeaf(ToAabb(node.box)) && visit(index) == RayStep::stop) return;
                continue;
            }
            boxTests += 2;
            const RayFork fork = ray.MayHitNodes(m_nodes[node.child1].box, m_nodes[node.child2].box);
            if (!fork.isSecondNearer && fork.second) stack.Push(node.child2);
            if (fork.first) stack.Push(node.child1);
            if (fork.isSecondNearer && fork.second) stack.Push(node.child2);
        }
    }

    [[nodiscard]] size_t GetMemoryBytes() const { return m_nodes.capacity() * sizeof(FatNode); }

private:
    uint32_t Allocate();
    void Free(uint32_t index);
    void Link(uint32_t leaf);
    void Unlink(uint32_t leaf);
    [[nodiscard]] uint32_t BestSibling(const Bounds& box) const;
    void ReplaceChild(uint32_t parent, uint32_t oldChild, uint32_t newChild);
    void RefitUpwards(uint32_t index);
    void Refit(uint32_t index);
    uint32_t Balance(uint32_t index);
    uint32_t LiftChild(uint32_t index, uint32_t heavy);

    std::vector<FatNode> m_nodes;
    uint32_t m_root = noNode;
    uint32_t m_free = noNode;
};

}  // namespace scree::broadphase
