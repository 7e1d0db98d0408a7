// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The split rules and what they measure, in loops without branches that depend on the boxes.

#include "broad_phase/split_rules.h"

#include <algorithm>
#include <array>

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

}  // namespace scree::broadphase
