// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Dual descent over a flat tree: tree in, pairs out. Recursion is as deep as twice the tree's height at most.

#include "broad_phase/dual_descent.h"

namespace scree::broadphase {
namespace {

struct Descent {
    const FlatTree& tree;
    PairSink& sink;
    uint64_t boxTests = 0;

    void Self(const TreeNode& node) {
        if (node.IsLeaf()) {
            for (uint32_t i = node.first; i < node.first + node.count; ++i)
                OneAgainst(i, i + 1, node.first + node.count);
            return;
        }
        const TreeNode& child1 = tree.nodes[node.child];
        const TreeNode& child2 = tree.nodes[node.child + 1];
        Self(child1);
        Self(child2);
        Cross(child1, child2);
    }

    void Cross(const TreeNode& a, const TreeNode& b) {
        ++boxTests;
        if (!Overlaps(Load(a.box), ProbeOf(Load(b.box)))) return;
        if (a.IsLeaf() && b.IsLeaf()) {
            if (a.count == 1 && b.count == 1) {
                sink.Emit(tree.Ids()[a.first], tree.Ids()[b.first]);
                return;
            }
            for (uint32_t i = a.first; i < a.first + a.count; ++i) OneAgainst(i, b.first, b.first + b.count);
        } else if (b.IsLeaf() || (!a.IsLeaf() && HalfPerimeter(a.box) >= HalfPerimeter(b.box))) {
            Cross(tree.nodes[a.child], b);
            Cross(tree.nodes[a.child + 1], b);
        } else {
            Cross(a, tree.nodes[b.child]);
            Cross(a, tree.nodes[b.child + 1]);
        }
    }

    void OneAgainst(uint32_t position, uint32_t begin, uint32_t end) {
        const Bounds box = tree.Box(position);
        const F4 probe = ProbeOf(Load(box));
        boxTests += end - begin;
        for (uint32_t j = begin; j < end; ++j) {
            const Bounds other = tree.Box(j);
            if (Overlaps(Load(other), probe)) sink.Emit(tree.Ids()[position], tree.Ids()[j]);
        }
    }
};

}  // namespace

uint64_t DescendSelf(const FlatTree& tree, PairSink& sink) {
    if (tree.Empty()) return 0;
    Descent descent{tree, sink};
    descent.Self(tree.nodes[0]);
    return descent.boxTests;
}

}  // namespace scree::broadphase
