// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Height, balance and quality of the broad phase's tree, whatever algorithm keeps it: its nodes as inspectors see them
// → the numbers of Box2D 2.4's b2DynamicTree.

#include <algorithm>
#include <cstdlib>

#include "world/world_state.h"

namespace scree {

namespace {

std::vector<BvhNode> NodesOf(const WorldState& s) {
    std::vector<BvhNode> nodes;
    s.broadPhase->GetNodes(nodes);
    return nodes;
}

}  // namespace

int World::GetTreeHeight() const {
    int height = 0;
    for (const BvhNode& node : NodesOf(*m_state)) height = std::max(height, node.level);
    return height;
}

int World::GetTreeBalance() const {
    const std::vector<BvhNode> nodes = NodesOf(*m_state);
    std::vector<int> heights(nodes.size(), 0);
    int balance = 0;
    for (size_t i = nodes.size(); i-- > 0;) {  // children come after their parent
        if (nodes[i].child1 < 0) continue;
        const int h1 = heights[static_cast<size_t>(nodes[i].child1)];
        const int h2 = heights[static_cast<size_t>(nodes[i].child2)];
        heights[i] = 1 + std::max(h1, h2);
        balance = std::max(balance, std::abs(h2 - h1));
    }
    return balance;
}

float World::GetTreeQuality() const {
    const std::vector<BvhNode> nodes = NodesOf(*m_state);
    if (nodes.empty()) return 0.0f;
    float total = 0.0f;
    for (const BvhNode& node : nodes) total += node.box.GetPerimeter();
    const float root = nodes.front().box.GetPerimeter();
    return root > 0.0f ? total / root : 0.0f;
}

}  // namespace scree
