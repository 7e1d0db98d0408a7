// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of box2d_tree_dump.h. b2DynamicTree keeps its nodes private. Its member template Query may be
// specialised for a type of ours, though, and a specialisation of a member may read m_root and m_nodes. That is legal
// C++ and needs no change of access control.

#include "testbed/engines/box2d_tree_dump.h"

#include <box2d/b2_broad_phase.h>

#include "testbed/engines/box2d_shape.h"

namespace testbed {
namespace {

/// Stands in for a query callback; carries what the walk needs.
struct TreeDump {
    const std::function<int(void*)>& fixtureOf;
    std::vector<NodeState>* nodes;
};

/// A node still to be written, with its place below an already written parent.
struct Pending {
    int32 node;
    int parent;
    bool isChild1;
};

}  // namespace
}  // namespace testbed

template <>
inline void b2DynamicTree::Query<testbed::TreeDump>(testbed::TreeDump* dump, const b2AABB&) const {
    using testbed::NodeState;
    std::vector<NodeState>& out = *dump->nodes;
    out.clear();
    if (m_root == b2_nullNode) return;
    out.reserve(static_cast<size_t>(m_nodeCount));
    std::vector<testbed::Pending> stack{{m_root, -1, false}};
    while (!stack.empty()) {
        const testbed::Pending top = stack.back();
        stack.pop_back();
        const b2TreeNode& node = m_nodes[top.node];
        const int index = static_cast<int>(out.size());
        int level = 0;
        if (top.parent >= 0) {
            NodeState& parent = out[static_cast<size_t>(top.parent)];
            (top.isChild1 ? parent.child1 : parent.child2) = index;
            level = parent.level + 1;
        }
        out.push_back({testbed::FromB2(node.aabb), top.parent, -1, -1, -1, level});
        if (node.IsLeaf()) {
            out.back().fixture = dump->fixtureOf(node.userData);
        } else {
            stack.push_back({node.child2, index, false});
            stack.push_back({node.child1, index, true});
        }
    }
}

namespace testbed {

void DumpBox2dTree(const b2BroadPhase& broadPhase, const std::function<int(void* userData)>& fixtureOf,
                   std::vector<NodeState>& nodes) {
    TreeDump dump{fixtureOf, &nodes};
    broadPhase.Query(&dump, b2AABB{});
}

}  // namespace testbed
