// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The stand-alone tree: the broad phase's fat tree with user data and move marks beside it.

#include "scree/dynamic_tree.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "broad_phase/fat_tree.h"
#include "broad_phase/ray_probe.h"
#include "scree/settings.h"

namespace scree {

using broadphase::FatNode;
using broadphase::noNode;

struct DynamicTree::Impl {
    broadphase::FatMargin margin;
    broadphase::FatTree tree;
    std::vector<void*> userData;  ///< by node, of leaves
    std::vector<uint8_t> moved;
    int count = 0;

    [[nodiscard]] bool Has(int proxy) const {
        if (proxy < 0 || static_cast<size_t>(proxy) >= tree.NodeLimit()) return false;
        return tree.IsLiveLeaf(static_cast<uint32_t>(proxy));
    }
    [[nodiscard]] AABB BoxOf(uint32_t node) const { return ToAabb(tree.Node(node).box); }

    /// Links, heights and boxes of a subtree; counts its leaves.
    [[nodiscard]] bool IsConsistent(uint32_t index, uint32_t parent, int& leaves) const {
        const FatNode& node = tree.Node(index);
        if (node.parent != parent) return false;
        if (node.IsLeaf()) {
            ++leaves;
            return node.child2 == noNode && node.height == 0;
        }
        if (!IsConsistent(node.child1, index, leaves) || !IsConsistent(node.child2, index, leaves)) return false;
        const AABB joined = Union(BoxOf(node.child1), BoxOf(node.child2));
        const AABB box = ToAabb(node.box);
        return node.height == 1 + std::max(tree.Node(node.child1).height, tree.Node(node.child2).height) &&
               box.Contains(joined) && joined.Contains(box);
    }
};

DynamicTree::DynamicTree(float margin) : m_impl(std::make_unique<Impl>()) {
    if (margin >= 0.0f && std::isfinite(margin)) {
        m_impl->margin = {margin};
    } else {
        // A constructor cannot refuse: the tree is made with the default, and stderr says so.
        std::fprintf(stderr, "scree: DynamicTree::DynamicTree: margin: out of range; give 0 m or more\n");
    }
}
DynamicTree::~DynamicTree() = default;
DynamicTree::DynamicTree(DynamicTree&&) noexcept = default;
DynamicTree& DynamicTree::operator=(DynamicTree&&) noexcept = default;

int DynamicTree::CreateProxy(const AABB& aabb, void* userData) {
    if (!aabb.IsValid()) return -1;
    const uint32_t leaf = m_impl->tree.CreateLeaf(broadphase::ToBounds(m_impl->margin.Fatten(aabb)), {});
    if (m_impl->userData.size() < m_impl->tree.NodeLimit()) {
        m_impl->userData.resize(m_impl->tree.NodeLimit(), nullptr);
        m_impl->moved.resize(m_impl->tree.NodeLimit(), 0);
    }
    m_impl->userData[leaf] = userData;
    m_impl->moved[leaf] = 1;
    ++m_impl->count;
    return static_cast<int>(leaf);
}

bool DynamicTree::DestroyProxy(int proxy) {
    if (!m_impl->Has(proxy)) return false;
    m_impl->tree.DestroyLeaf(static_cast<uint32_t>(proxy));
    --m_impl->count;
    return true;
}

bool DynamicTree::MoveProxy(int proxy, const AABB& aabb, Vec2 displacement) {
    if (!m_impl->Has(proxy) || !aabb.IsValid() || !displacement.IsValid()) return false;
    const auto leaf = static_cast<uint32_t>(proxy);
    const AABB fat = m_impl->margin.Fatten(aabb, displacement);
    if (m_impl->margin.Keeps(m_impl->BoxOf(leaf), aabb, fat)) return false;
    m_impl->tree.Reinsert(leaf, broadphase::ToBounds(fat));
    m_impl->moved[leaf] = 1;
    return true;
}

void* DynamicTree::GetUserData(int proxy) const {
    return m_impl->Has(proxy) ? m_impl->userData[static_cast<size_t>(proxy)] : nullptr;
}
bool DynamicTree::WasMoved(int proxy) const {
    return m_impl->Has(proxy) && m_impl->moved[static_cast<size_t>(proxy)] != 0;
}
void DynamicTree::ClearMoved(int proxy) {
    if (m_impl->Has(proxy)) m_impl->moved[static_cast<size_t>(proxy)] = 0;
}
AABB DynamicTree::GetFatAABB(int proxy) const {
    return m_impl->Has(proxy) ? m_impl->BoxOf(static_cast<uint32_t>(proxy)) : AABB{vec2Zero, vec2Zero};
}

void DynamicTree::Query(const AABB& aabb, FunctionRef<bool(int)> visit) const {
    if (!aabb.IsValid() || visit == nullptr) return;
    uint64_t boxTests = 0;
    m_impl->tree.Query(broadphase::ToBounds(aabb), boxTests,
                       [&](uint32_t leaf) { return visit(static_cast<int>(leaf)); });
}

void DynamicTree::RayCast(const RayCastInput& input, FunctionRef<float(const RayCastInput&, int)> visit) const {
    const bool usable =
        input.p1.IsValid() && input.p2.IsValid() && std::isfinite(input.maxFraction) && visit != nullptr;
    if (!usable) return;
    const auto forward = [&](const RayCastInput& rest, uint32_t leaf) { return visit(rest, static_cast<int>(leaf)); };
    uint64_t boxTests = 0;
    broadphase::RayProbe ray(input);
    m_impl->tree.RayCast(ray, boxTests, [&](uint32_t leaf) { return ray.Visit(forward, leaf); });
}

bool DynamicTree::Validate() const {
    int leaves = 0;
    const uint32_t root = m_impl->tree.Root();
    return (root == noNode || m_impl->IsConsistent(root, noNode, leaves)) && leaves == m_impl->count;
}

int DynamicTree::GetProxyCount() const { return m_impl->count; }

int DynamicTree::GetHeight() const {
    const uint32_t root = m_impl->tree.Root();
    return root == noNode ? 0 : m_impl->tree.Node(root).height;
}

int DynamicTree::GetMaxBalance() const {
    int balance = 0;
    for (uint32_t i = 0; i < m_impl->tree.NodeLimit(); ++i) {
        const FatNode& node = m_impl->tree.Node(i);
        if (node.height <= 1) continue;
        balance =
            std::max(balance, std::abs(m_impl->tree.Node(node.child2).height - m_impl->tree.Node(node.child1).height));
    }
    return balance;
}

float DynamicTree::GetAreaRatio() const {
    const uint32_t root = m_impl->tree.Root();
    if (root == noNode) return 0.0f;
    float total = 0.0f;
    for (uint32_t i = 0; i < m_impl->tree.NodeLimit(); ++i) {
        if (m_impl->tree.Node(i).height >= 0) total += m_impl->BoxOf(i).GetPerimeter();
    }
    return total / m_impl->BoxOf(root).GetPerimeter();
}

void DynamicTree::RebuildBottomUp() { m_impl->tree.RebuildBottomUp(); }

void DynamicTree::ShiftOrigin(Vec2 newOrigin) {
    if (newOrigin.IsValid()) m_impl->tree.ShiftOrigin(newOrigin);
}

}  // namespace scree
