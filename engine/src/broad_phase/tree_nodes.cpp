// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The walk that writes inspection nodes; leaves are split further by the rule that made the tree.

#include "broad_phase/tree_nodes.h"

#include <utility>

namespace scree::broadphase {

namespace {

/// Writes inspection nodes: first the production nodes, then the leaves' inner nodes.
struct NodeWriter {
    const FlatTree& tree;
    SplitRule rule;
    std::vector<BvhNode>& out;
    std::vector<BuildItem> items;

    /// Appends a node below `parent` and returns its index.
    int32_t Append(const Bounds& box, int32_t parent) {
        BvhNode node;
        node.box = ToAabb(box);
        node.parent = parent;
        node.level = parent < 0 ? 0 : out[static_cast<size_t>(parent)].level + 1;
        out.push_back(node);
        return static_cast<int32_t>(out.size()) - 1;
    }

    void Write(const TreeNode& node, int32_t index, int depth) {
        if (node.IsLeaf()) {
            items.clear();
            for (uint32_t p = node.first; p < node.first + node.count; ++p)
                items.push_back({tree.Box(p), tree.Ids()[p]});
            WriteItems(0, node.count, index, depth);
            return;
        }
        const TreeNode& child1 = tree.nodes[node.child];
        const TreeNode& child2 = tree.nodes[node.child + 1];
        const auto [index1, index2] = AppendChildren(index, child1.box, child2.box);
        Write(child1, index1, depth + 1);
        Write(child2, index2, depth + 1);
    }

    void WriteItems(uint32_t first, uint32_t count, int32_t index, int depth) {
        if (count == 1) {
            out[static_cast<size_t>(index)].fixture = static_cast<int32_t>(items[first].id.fixture);
            return;
        }
        const Bounds centre = Measure(&items[first], count).centre;
        const uint32_t left = SplitOrHalve(rule, &items[first], count, centre, depth);
        const auto [index1, index2] =
            AppendChildren(index, Measure(&items[first], left).box, Measure(&items[first + left], count - left).box);
        WriteItems(first, left, index1, depth + 1);
        WriteItems(first + left, count - left, index2, depth + 1);
    }

    std::pair<int32_t, int32_t> AppendChildren(int32_t index, const Bounds& box1, const Bounds& box2) {
        const int32_t index1 = Append(box1, index);
        const int32_t index2 = Append(box2, index);
        out[static_cast<size_t>(index)].child1 = index1;
        out[static_cast<size_t>(index)].child2 = index2;
        return {index1, index2};
    }
};

/// Appends the tree; its root gets `parent`. Does nothing with an empty tree.
void AppendNodes(const FlatTree& tree, SplitRule rule, int32_t parent, std::vector<BvhNode>& nodes) {
    if (tree.Empty()) return;
    NodeWriter writer{tree, rule, nodes, {}};
    const int32_t root = writer.Append(tree.nodes[0].box, parent);
    writer.Write(tree.nodes[0], root, 0);
}

}  // namespace

void WriteNodes(const FlatTree& main, const FlatTree& statics, SplitRule rule, std::vector<BvhNode>& nodes) {
    nodes.clear();
    int32_t parent = -1;
    if (!main.Empty() && !statics.Empty()) {
        BvhNode root;
        root.box = Union(ToAabb(main.nodes[0].box), ToAabb(statics.nodes[0].box));
        nodes.push_back(root);
        parent = 0;
    }
    for (const FlatTree* tree : {&main, &statics}) {
        const auto index = static_cast<int32_t>(nodes.size());
        AppendNodes(*tree, rule, parent, nodes);
        if (parent == 0) (tree == &main ? nodes[0].child1 : nodes[0].child2) = index;
    }
}

}  // namespace scree::broadphase
