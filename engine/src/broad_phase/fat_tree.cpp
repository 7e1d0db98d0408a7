// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Insertion by perimeter cost, removal and height rotations of the dynamic tree.

#include "broad_phase/fat_tree.h"

#include <algorithm>

#include "base/slots.h"

namespace scree::broadphase {
namespace {

Bounds UnionOf(const Bounds& a, const Bounds& b) {
    Bounds out;
    Store(out, Min4(Load(a), Load(b)));
    return out;
}

}  // namespace

uint32_t FatTree::Allocate() {
    if (m_free == noNode) {
        m_nodes.emplace_back();
        return static_cast<uint32_t>(m_nodes.size()) - 1;
    }
    const uint32_t index = m_free;
    m_free = m_nodes[index].parent;
    m_nodes[index] = {};
    return index;
}

void FatTree::Free(uint32_t index) {
    m_nodes[index] = {};
    m_nodes[index].height = -1;
    m_nodes[index].parent = m_free;
    m_free = index;
}

uint32_t FatTree::CreateLeaf(const Bounds& box, ItemId id) {
    ReserveRows(m_nodes.size() + 2, m_nodes);  // when memory runs out nothing has changed yet
    const uint32_t leaf = Allocate();
    m_nodes[leaf].box = box;
    m_nodes[leaf].id = id;
    Link(leaf);
    return leaf;
}

void FatTree::DestroyLeaf(uint32_t leaf) {
    Unlink(leaf);
    Free(leaf);
}

void FatTree::Reinsert(uint32_t leaf, const Bounds& box) {
    Unlink(leaf);
    m_nodes[leaf].box = box;
    Link(leaf);
}

void FatTree::RebuildBottomUp() {
    std::vector<uint32_t> tops;  // roots of the subtrees that are left
    for (uint32_t i = 0; i < m_nodes.size(); ++i) {
        if (m_nodes[i].height == 0) {
            tops.push_back(i);
        } else if (m_nodes[i].height > 0) {
            Free(i);
        }
    }
    while (tops.size() > 1) {
        size_t best1 = 0, best2 = 1;
        float lowest = infinity;
        for (size_t i = 0; i < tops.size(); ++i) {
            for (size_t j = i + 1; j < tops.size(); ++j) {
                const float cost = HalfPerimeter(UnionOf(m_nodes[tops[i]].box, m_nodes[tops[j]].box));
                if (cost >= lowest) continue;
                lowest = cost;
                best1 = i;
                best2 = j;
            }
        }
        const uint32_t joint = Allocate();
        m_nodes[joint].child1 = tops[best1];
        m_nodes[joint].child2 = tops[best2];
        m_nodes[tops[best1]].parent = joint;
        m_nodes[tops[best2]].parent = joint;
        Refit(joint);
        tops[best1] = joint;
        tops[best2] = tops.back();
        tops.pop_back();
    }
    m_root = tops.empty() ? noNode : tops[0];
    if (m_root != noNode) m_nodes[m_root].parent = noNode;
}

void FatTree::ShiftOrigin(Vec2 origin) {
    for (FatNode& node : m_nodes) {
        const Bounds& b = node.box;
        node.box = {b.lx - origin.x, b.ly - origin.y, b.nux + origin.x, b.nuy + origin.y};
    }
}

uint32_t FatTree::BestSibling(const Bounds& box) const {
    uint32_t index = m_root;
    while (!m_nodes[index].IsLeaf()) {
        const FatNode& node = m_nodes[index];
        const float grown = HalfPerimeter(UnionOf(node.box, box));
        // What every node above a deeper place would grow by on account of this node.
        const float inherited = 2.0f * (grown - HalfPerimeter(node.box));
        const auto costBelow = [&](uint32_t child) {
            const FatNode& c = m_nodes[child];
            const float united = HalfPerimeter(UnionOf(c.box, box));
            return inherited + (c.IsLeaf() ? united : united - HalfPerimeter(c.box));
        };
        const float cost1 = costBelow(node.child1);
        const float cost2 = costBelow(node.child2);
        const float costHere = 2.0f * grown;
        if (costHere < cost1 && costHere < cost2) break;
        index = cost1 < cost2 ? node.child1 : node.child2;
    }
    return index;
}

void FatTree::ReplaceChild(uint32_t parent, uint32_t oldChild, uint32_t newChild) {
    m_nodes[newChild].parent = parent;
    if (parent == noNode) {
        m_root = newChild;
    } else if (m_nodes[parent].child1 == oldChild) {
        m_nodes[parent].child1 = newChild;
    } else {
        m_nodes[parent].child2 = newChild;
    }
}

void FatTree::Link(uint32_t leaf) {
    if (m_root == noNode) {
        m_root = leaf;
        m_nodes[leaf].parent = noNode;
        return;
    }
    const uint32_t sibling = BestSibling(m_nodes[leaf].box);
    const uint32_t joint = Allocate();
    ReplaceChild(m_nodes[sibling].parent, sibling, joint);
    m_nodes[joint].child1 = sibling;
    m_nodes[joint].child2 = leaf;
    m_nodes[sibling].parent = joint;
    m_nodes[leaf].parent = joint;
    RefitUpwards(joint);
}

void FatTree::Unlink(uint32_t leaf) {
    if (leaf == m_root) {
        m_root = noNode;
        return;
    }
    const uint32_t joint = m_nodes[leaf].parent;
    const uint32_t sibling = m_nodes[joint].child1 == leaf ? m_nodes[joint].child2 : m_nodes[joint].child1;
    const uint32_t above = m_nodes[joint].parent;
    ReplaceChild(above, joint, sibling);
    Free(joint);
    RefitUpwards(above);
}

void FatTree::Refit(uint32_t index) {
    FatNode& node = m_nodes[index];
    const FatNode& c1 = m_nodes[node.child1];
    const FatNode& c2 = m_nodes[node.child2];
    node.box = UnionOf(c1.box, c2.box);
    node.height = 1 + std::max(c1.height, c2.height);
}

void FatTree::RefitUpwards(uint32_t index) {
    while (index != noNode) {
        index = Balance(index);
        Refit(index);
        index = m_nodes[index].parent;
    }
}

uint32_t FatTree::Balance(uint32_t index) {
    const FatNode& node = m_nodes[index];
    const int32_t lead = m_nodes[node.child2].height - m_nodes[node.child1].height;
    if (lead > 1) return LiftChild(index, node.child2);
    if (lead < -1) return LiftChild(index, node.child1);
    return index;
}

/// The heavy child takes its parent's place, the parent becomes its child and takes over its lighter grandchild.
uint32_t FatTree::LiftChild(uint32_t index, uint32_t heavy) {
    const uint32_t g1 = m_nodes[heavy].child1;
    const uint32_t g2 = m_nodes[heavy].child2;
    const bool keepFirst = m_nodes[g1].height > m_nodes[g2].height;
    const uint32_t kept = keepFirst ? g1 : g2;
    const uint32_t handed = keepFirst ? g2 : g1;
    ReplaceChild(m_nodes[index].parent, index, heavy);
    ReplaceChild(index, heavy, handed);
    m_nodes[heavy].child1 = index;
    m_nodes[heavy].child2 = kept;
    m_nodes[index].parent = heavy;
    Refit(index);
    return heavy;
}

}  // namespace scree::broadphase
