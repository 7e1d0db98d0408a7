// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of box2d3_trees.h. Margins are those of the library's constants.h; they depend on how far a shape
// reaches from its middle.

#include "testbed/engines/box2d3/box2d3_trees.h"

#include <box2d/constants.h>

#include <algorithm>
#include <cmath>

#include "testbed/engines/pair_count.h"

namespace testbed::box2d3 {
namespace {

constexpr int ofStatics = 0;

int TreeOf(scenes::BodyType type) {
    return type == scenes::BodyType::isStatic ? ofStatics : type == scenes::BodyType::kinematic ? 1 : 2;
}

float DistanceOf(b2Vec2 a, b2Vec2 b) { return std::hypot(a.x - b.x, a.y - b.y); }

float ReachOf(const Shape& shape) {
    struct Visitor {
        float operator()(const b2Circle& s) const { return s.radius; }
        float operator()(const b2Capsule& s) const { return 0.5f * DistanceOf(s.center1, s.center2) + s.radius; }
        float operator()(const b2Segment& s) const { return 0.5f * DistanceOf(s.point1, s.point2); }
        float operator()(const b2Polygon& s) const {
            float reach = 0.0f;
            for (int i = 0; i < s.count; ++i) reach = std::max(reach, DistanceOf(s.vertices[i], s.centroid));
            return reach;
        }
    };
    return std::visit(Visitor{}, shape);
}

b2AABB Widen(b2AABB box, float by) {
    return {{box.lowerBound.x - by, box.lowerBound.y - by}, {box.upperBound.x + by, box.upperBound.y + by}};
}

bool Contains(const b2AABB& outer, const b2AABB& inner) {
    return outer.lowerBound.x <= inner.lowerBound.x && outer.lowerBound.y <= inner.lowerBound.y &&
           inner.upperBound.x <= outer.upperBound.x && inner.upperBound.y <= outer.upperBound.y;
}

}  // namespace

Trees::Trees() {
    for (b2DynamicTree& tree : m_trees) tree = b2DynamicTree_Create(16);
}
Trees::~Trees() {
    for (b2DynamicTree& tree : m_trees) b2DynamicTree_Destroy(&tree);
}

void Trees::Add(scenes::BodyType type, const Shape& shape, b2WorldTransform pose) {
    const int tree = TreeOf(type);
    const float margin = tree == ofStatics ? B2_SPECULATIVE_DISTANCE
                                           : std::min(B2_MAX_AABB_MARGIN, B2_AABB_MARGIN_FRACTION * ReachOf(shape));
    const b2AABB fat = Widen(ComputeBox(shape, pose), B2_SPECULATIVE_DISTANCE + margin);
    const int id = b2DynamicTree_CreateProxy(&m_trees[tree], fat, 1, m_proxies.size());
    m_proxies.push_back({tree, id, margin, shape, fat});
}

void Trees::Remove(size_t number) {
    const Proxy& proxy = m_proxies[number];
    b2DynamicTree_DestroyProxy(&m_trees[proxy.tree], proxy.id);
}

void Trees::Move(size_t number, b2WorldTransform pose) {
    Proxy& proxy = m_proxies[number];
    const b2AABB box = Widen(ComputeBox(proxy.shape, pose), B2_SPECULATIVE_DISTANCE);
    if (Contains(proxy.fat, box)) return;
    proxy.fat = Widen(box, proxy.margin);
    if (proxy.tree == ofStatics) {
        b2DynamicTree_MoveProxy(&m_trees[proxy.tree], proxy.id, proxy.fat);
    } else {
        b2DynamicTree_EnlargeProxy(&m_trees[proxy.tree], proxy.id, proxy.fat);
    }
}

void Trees::Rebuild() {
    b2DynamicTree_Rebuild(&m_trees[2], false);
    b2DynamicTree_Rebuild(&m_trees[1], false);
}

void Trees::Dump(Snapshot& snapshot, bool pairs, const std::function<int(size_t)>& fixtureOf) const {
    /// A node of a tree still to be written; `node` −1: what joins this tree and those after it.
    struct Pending {
        size_t tree;
        int32_t node;
        int parent;
        bool isChild1;
    };
    std::vector<const b2DynamicTree*> trees;
    for (const b2DynamicTree& tree : m_trees) {
        if (b2DynamicTree_GetProxyCount(&tree) > 0) trees.push_back(&tree);
    }
    snapshot.nodes.clear();
    snapshot.treeHeight = 0;
    std::vector<Pending> stack;
    const auto push = [&](size_t tree, int parent, bool isChild1) {
        stack.push_back({tree, tree + 1 < trees.size() ? -1 : trees[tree]->root, parent, isChild1});
    };
    if (!trees.empty()) push(0, -1, false);
    while (!stack.empty()) {
        const Pending top = stack.back();
        stack.pop_back();
        const b2DynamicTree& tree = *trees[top.tree];
        const int index = static_cast<int>(snapshot.nodes.size());
        int level = 0;
        if (top.parent >= 0) {
            NodeState& parent = snapshot.nodes[static_cast<size_t>(top.parent)];
            (top.isChild1 ? parent.child1 : parent.child2) = index;
            level = parent.level + 1;
        }
        if (top.node < 0) {
            b2AABB box = b2DynamicTree_GetRootBounds(&tree);
            for (size_t i = top.tree + 1; i < trees.size(); ++i) {
                box = b2AABB_Union(box, b2DynamicTree_GetRootBounds(trees[i]));
            }
            snapshot.nodes.push_back({FromB2(box), top.parent, -1, -1, -1, level});
            push(top.tree + 1, index, false);
            stack.push_back({top.tree, tree.root, index, true});
            continue;
        }
        const b2TreeNode& node = tree.nodes[top.node];
        snapshot.nodes.push_back({FromB2(node.aabb), top.parent, -1, -1, -1, level});
        snapshot.treeHeight = std::max(snapshot.treeHeight, level);
        if ((node.flags & b2_leafNode) != 0) {
            const auto number = static_cast<size_t>(node.userData);
            snapshot.nodes.back().fixture = fixtureOf ? fixtureOf(number) : static_cast<int>(number);
        } else {
            stack.push_back({top.tree, node.children.child2, index, false});
            stack.push_back({top.tree, node.children.child1, index, true});
        }
    }
    snapshot.leafSize = snapshot.nodes.empty() ? 0 : 1;
    if (pairs && !snapshot.fixtures.empty()) snapshot.pairsReported = testbed::CountPairs(LeafBoxes(snapshot));
}

}  // namespace testbed::box2d3
