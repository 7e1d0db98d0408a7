// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The recursion of top-down building.

#include "broad_phase/top_down.h"

namespace scree::broadphase {

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
    tree.Reset(count, count);
    if (count == 0) return;
    const RangeBounds bounds = Measure(items.data(), count);
    tree.nodes.push_back({bounds.box, 0, count});
    Builder{items.data(), rule, leafSize, tree}.Recurse(0, bounds.centre, 0);
}

}  // namespace scree::broadphase
