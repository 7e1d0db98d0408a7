// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Top-down building by a split rule: boxes in, flat tree out, O(n log n) unless the boxes defeat the rule; and the
// continuation of a tree with wide leaves to one box per leaf for inspection.

#include "broad_phase/top_down.h"

#include <algorithm>
#include <array>
#include <utility>

namespace scree::broadphase {

RangeBounds Measure(const BuildItem* items, uint32_t count) {
    F4 box = Load(emptyBounds);
    F4 centre = box;
    for (uint32_t i = 0; i < count; ++i) {
        const F4 item = Load(items[i].box);
        box = Min4(box, item);
        centre = Min4(centre, CentreOf(item));
    }
    RangeBounds out;
    Store(out.box, box);
    Store(out.centre, centre);
    return out;
}

namespace {

/// Twice the centre along x (axis 0) or y (axis 1).
float CentreAlong(const Bounds& box, int axis) { return axis == 0 ? box.lx - box.nux : box.ly - box.nuy; }

uint32_t PartitionBelow(BuildItem* items, uint32_t count, int axis, float limit) {
    uint32_t left = 0;
    // Swapping always and counting the comparison keeps the loop free of unpredictable branches.
    for (uint32_t i = 0; i < count; ++i) {
        const BuildItem item = items[i];
        items[i] = items[left];
        items[left] = item;
        left += CentreAlong(item.box, axis) < limit ? 1 : 0;
    }
    return left;
}

}  // namespace

uint32_t SplitBarycentre(BuildItem* items, uint32_t count, const Bounds& centre) {
    const float width = -centre.nux - centre.lx;
    const float height = -centre.nuy - centre.ly;
    if (width >= height) return PartitionBelow(items, count, 0, 0.5f * (centre.lx - centre.nux));
    return PartitionBelow(items, count, 1, 0.5f * (centre.ly - centre.nuy));
}

namespace {

constexpr int binCount = 16;

struct BinnedAxis {
    int axis;
    float low, scale;

    [[nodiscard]] int BinOf(const Bounds& box) const {
        const float bin = (CentreAlong(box, axis) - low) * scale;
        return bin < static_cast<float>(binCount - 1) ? static_cast<int>(bin) : binCount - 1;
    }
};

struct SahChoice {
    float cost = infinity;
    int axis = -1, lastLeftBin = 0;
};

/// Finds the cheapest border between bins along one axis.
void TryAxis(const BuildItem* items, uint32_t count, const BinnedAxis& binned, SahChoice& best) {
    std::array<Bounds, binCount> boxes;
    std::array<uint32_t, binCount> counts{};
    boxes.fill(emptyBounds);
    for (uint32_t i = 0; i < count; ++i) {
        const auto bin = static_cast<size_t>(binned.BinOf(items[i].box));
        Store(boxes[bin], Min4(Load(boxes[bin]), Load(items[i].box)));
        ++counts[bin];
    }
    std::array<float, binCount> rightCost{};
    Bounds sum = emptyBounds;
    uint32_t number = 0;
    for (size_t bin = binCount - 1; bin > 0; --bin) {
        Store(sum, Min4(Load(sum), Load(boxes[bin])));
        number += counts[bin];
        rightCost[bin] = number > 0 ? HalfPerimeter(sum) * static_cast<float>(number) : infinity;
    }
    sum = emptyBounds;
    number = 0;
    for (size_t bin = 0; bin + 1 < binCount; ++bin) {
        Store(sum, Min4(Load(sum), Load(boxes[bin])));
        number += counts[bin];
        if (number == 0) continue;
        const float cost = HalfPerimeter(sum) * static_cast<float>(number) + rightCost[bin + 1];
        if (cost < best.cost) best = {cost, binned.axis, static_cast<int>(bin)};
    }
}

}  // namespace

uint32_t SplitSah(BuildItem* items, uint32_t count, const Bounds& centre) {
    const float low[2] = {centre.lx, centre.ly};
    const float extent[2] = {-centre.nux - centre.lx, -centre.nuy - centre.ly};
    std::array<BinnedAxis, 2> axes;
    SahChoice best;
    for (int axis = 0; axis < 2; ++axis) {
        const float scale = static_cast<float>(binCount) / extent[axis];
        axes[static_cast<size_t>(axis)] = {axis, low[axis], scale};
        // An extent that is zero, or too small or large for arithmetic, separates nothing.
        if (extent[axis] > 0.0f && scale > 0.0f && scale < infinity) {
            TryAxis(items, count, axes[static_cast<size_t>(axis)], best);
        }
    }
    if (best.axis < 0) return 0;
    const BinnedAxis& chosen = axes[static_cast<size_t>(best.axis)];
    uint32_t left = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const BuildItem item = items[i];
        items[i] = items[left];
        items[left] = item;
        left += chosen.BinOf(item.box) <= best.lastLeftBin ? 1 : 0;
    }
    return left;
}

uint32_t SplitOrHalve(SplitRule rule, BuildItem* items, uint32_t count, const Bounds& centre, int depth) {
    if (count == 2) return 1;
    const uint32_t left = depth < maxRuleDepth ? rule(items, count, centre) : 0;
    return left == 0 || left == count ? count / 2 : left;
}

void CollectItems(const ProxyStore& store, SlotRange slots, std::vector<BuildItem>& items) {
    items.resize(slots.count);
    for (uint32_t i = 0; i < slots.count; ++i) {
        items[i] = {ToBounds(store.Box(slots.first + i)), store.Id(slots.first + i)};
    }
}

namespace {

struct Builder {
    BuildItem* items;
    SplitRule rule;
    uint32_t leafSize;
    FlatTree& tree;

    void Recurse(uint32_t nodeIndex, const Bounds& centre, int depth) {
        const uint32_t first = tree.nodes[nodeIndex].first;
        const uint32_t count = tree.nodes[nodeIndex].count;
        if (count <= leafSize) {
            for (uint32_t i = first; i < first + count; ++i) tree.SetItem(i, items[i].box, items[i].id);
            return;
        }
        const uint32_t left = SplitOrHalve(rule, items + first, count, centre, depth);
        const RangeBounds bounds1 = Measure(items + first, left);
        const RangeBounds bounds2 = Measure(items + first + left, count - left);
        const auto child = static_cast<uint32_t>(tree.nodes.size());
        tree.nodes[nodeIndex].child = child;
        tree.nodes.push_back({bounds1.box, first, left});
        tree.nodes.push_back({bounds2.box, first + left, count - left});
        Recurse(child, bounds1.centre, depth + 1);
        Recurse(child + 1, bounds2.centre, depth + 1);
    }
};

}  // namespace

void BuildTopDown(std::vector<BuildItem>& items, SplitRule rule, uint32_t leafSize, FlatTree& tree) {
    const auto count = static_cast<uint32_t>(items.size());
    tree.Reset(count);
    if (count == 0) return;
    const RangeBounds bounds = Measure(items.data(), count);
    tree.nodes.push_back({bounds.box, 0, count});
    Builder{items.data(), rule, leafSize, tree}.Recurse(0, bounds.centre, 0);
}

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

}  // namespace

void AppendNodes(const FlatTree& tree, SplitRule rule, int32_t parent, std::vector<BvhNode>& nodes) {
    if (tree.Empty()) return;
    NodeWriter writer{tree, rule, nodes, {}};
    const int32_t root = writer.Append(tree.nodes[0].box, parent);
    writer.Write(tree.nodes[0], root, 0);
}

}  // namespace scree::broadphase
