// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The tree all rebuilding algorithms make: a flat array of nodes, both children side by side behind their parent, and
// the boxes in leaf order as separate arrays of coordinates. Every node owns a contiguous range of positions. Walks for
// box queries and ray casts are here; builders and detection are in files of their own.

#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/leave_raw.h"
#include "broad_phase/bounds.h"
#include "broad_phase/pair_sink.h"
#include "broad_phase/ray_probe.h"
#include "broad_phase/small_stack.h"

namespace scree::broadphase {

/// Never a child: the root.
inline constexpr uint32_t noChild = 0;

struct alignas(32) TreeNode {
    Bounds box;
    uint32_t first;            ///< first position
    uint32_t count;            ///< positions below this node
    uint32_t child = noChild;  ///< the first of two neighbouring children
    uint32_t buildState = 0;   ///< for the builder's own use while it works

    [[nodiscard]] bool IsLeaf() const { return child == noChild; }
};

/// At a position whose box is gone.
inline constexpr ItemId nobody{0xFFFFFFFFu, fixedGroup};

class FlatTree {
public:
    std::vector<TreeNode> nodes;  ///< root first; empty without boxes

    /// Makes room for `positions` boxes and forgets the old ones. Allocates only when `most`, which there may come to
    /// be, is more than ever before.
    void Reset(uint32_t positions, uint32_t most);

    [[nodiscard]] bool Empty() const { return nodes.empty(); }
    /// Positions in use.
    [[nodiscard]] uint32_t Size() const { return m_size; }
    /// The coordinates of all positions: component 0…3 of Bounds. Three positions beyond the end can be read.
    [[nodiscard]] const float* Lane(int component) const {
        return m_block.data() + static_cast<size_t>(component) * m_stride;
    }
    [[nodiscard]] float* Lane(int component) { return m_block.data() + static_cast<size_t>(component) * m_stride; }
    [[nodiscard]] const ItemId* Ids() const { return m_ids.data(); }
    [[nodiscard]] ItemId* Ids() { return m_ids.data(); }

    [[nodiscard]] Bounds Box(uint32_t position) const {
        return {Lane(0)[position], Lane(1)[position], Lane(2)[position], Lane(3)[position]};
    }
    /// Four positions; what is beyond the end is any number.
    [[nodiscard]] BoxRow Row(uint32_t position) const {
        return {Load4(Lane(0) + position), Load4(Lane(1) + position), Load4(Lane(2) + position),
                Load4(Lane(3) + position)};
    }
    void SetItem(uint32_t position, const Bounds& box, ItemId id) {
        Lane(0)[position] = box.lx;
        Lane(1)[position] = box.ly;
        Lane(2)[position] = box.nux;
        Lane(3)[position] = box.nuy;
        m_ids[position] = id;
    }

    /// The position has no box any more: nothing finds it.
    void Kill(uint32_t position) { SetItem(position, emptyBounds, nobody); }

    /// Calls `visit(ItemId)` for each box that overlaps, until it returns false; false if it did. Adds to `boxTests`.
    template <class Visit>
    bool Query(const AABB& box, uint64_t& boxTests, Visit&& visit) const;
    /// Calls `visit(ItemId)` for each box that the ray may hit, those of near nodes first, until it returns
    /// RayStep::stop.
    template <class Visit>
    RayStep RayCast(const RayProbe& ray, uint64_t& boxTests, Visit&& visit) const;

    [[nodiscard]] size_t GetMemoryBytes() const;

private:
    std::vector<float, LeaveRaw<float>> m_block;  ///< the four coordinate arrays
    std::vector<ItemId, LeaveRaw<ItemId>> m_ids;
    size_t m_stride = 0;  ///< floats from one coordinate array to the next
    uint32_t m_size = 0;
};

template <class Visit>
bool FlatTree::Query(const AABB& box, uint64_t& boxTests, Visit&& visit) const {
    if (Empty()) return true;
    const F4 probe = ProbeOf(Load(ToBounds(box)));
    ++boxTests;
    if (!Overlaps(Load(nodes[0].box), probe)) return true;
    SmallStack stack;
    stack.Push(0);
    while (!stack.Empty()) {
        const TreeNode& node = nodes[stack.Pop()];
        if (!node.IsLeaf()) {
            boxTests += 2;
            if (Overlaps(Load(nodes[node.child + 1].box), probe)) stack.Push(node.child + 1);
            if (Overlaps(Load(nodes[node.child].box), probe)) stack.Push(node.child);
            continue;
        }
        if (node.count > 1) boxTests += node.count;
        for (uint32_t position = node.first; position < node.first + node.count; ++position) {
            const Bounds item = Box(position);
            if (Overlaps(Load(item), probe) && !visit(m_ids[position])) return false;
        }
    }
    return true;
}

template <class Visit>
RayStep FlatTree::RayCast(const RayProbe& ray, uint64_t& boxTests, Visit&& visit) const {
    if (Empty()) return RayStep::goOn;
    ++boxTests;
    if (!ray.MayHitNode(nodes[0].box)) return RayStep::goOn;
    SmallStack stack;
    stack.Push(0);
    while (!stack.Empty()) {
        const TreeNode& node = nodes[stack.Pop()];
        if (!ray.Reaches(node.box)) continue;  // a hit has shortened the ray since
        if (!node.IsLeaf()) {
            boxTests += 2;
            const RayFork fork = ray.MayHitNodes(nodes[node.child].box, nodes[node.child + 1].box);
            if (!fork.isSecondNearer && fork.second) stack.Push(node.child + 1);
            if (fork.first) stack.Push(node.child);
            if (fork.isSecondNearer && fork.second) stack.Push(node.child + 1);
            continue;
        }
        boxTests += node.count;
        for (uint32_t row = 0; row < node.count; row += 4) {
            const uint32_t position = node.first + row;
            uint32_t hits = ray.MayHitLeaves(Row(position));
            if (node.count - row < 4) hits &= (1u << (node.count - row)) - 1u;
            for (; hits != 0; hits &= hits - 1) {
                const auto at = position + static_cast<uint32_t>(std::countr_zero(hits));
                if (ray.Reaches(Box(at)) && visit(m_ids[at]) == RayStep::stop) return RayStep::stop;
            }
        }
    }
    return RayStep::goOn;
}

}  // namespace scree::broadphase
