// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Building on 16-bit centre keys: slots in, flat tree with padded leaves out. Two item arrays take turns: a split reads
// one and writes the other from both ends, without a branch per item.

#include "broad_phase/keys_build.h"

#include <algorithm>
#include <cstring>

namespace scree::broadphase {
namespace {

/// Keys spanning fewer units than this are made anew from the boxes: a middle split would soon have nothing to compare.
constexpr int coarseExtent = 64;

struct KeyBounds {
    int16_t lowX, lowY, highX, highY;

    [[nodiscard]] int Width() const { return highX - lowX; }
    [[nodiscard]] int Height() const { return highY - lowY; }
};

#if defined(__SSE2__)

KeyBounds MeasureKeys(const KeyItem* items, uint32_t count) {
    // Two items per register; the lanes that hold slots are never read.
    __m128i low = _mm_set1_epi16(0x7FFF);
    __m128i high = _mm_set1_epi16(-0x8000);
    uint32_t i = 0;
    for (; i + 2 <= count; i += 2) {
        const __m128i pair = _mm_loadu_si128(reinterpret_cast<const __m128i*>(items + i));
        low = _mm_min_epi16(low, pair);
        high = _mm_max_epi16(high, pair);
    }
    if (i < count) {
        const __m128i half = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(items + i));
        const __m128i last = _mm_unpacklo_epi64(half, half);
        low = _mm_min_epi16(low, last);
        high = _mm_max_epi16(high, last);
    }
    low = _mm_min_epi16(low, _mm_unpackhi_epi64(low, low));
    high = _mm_max_epi16(high, _mm_unpackhi_epi64(high, high));
    const auto lowBits = static_cast<uint32_t>(_mm_cvtsi128_si32(low));
    const auto highBits = static_cast<uint32_t>(_mm_cvtsi128_si32(high));
    return {static_cast<int16_t>(lowBits), static_cast<int16_t>(lowBits >> 16), static_cast<int16_t>(highBits),
            static_cast<int16_t>(highBits >> 16)};
}

#else

KeyBounds MeasureKeys(const KeyItem* items, uint32_t count) {
    KeyBounds out{0x7FFF, 0x7FFF, -0x8000, -0x8000};
    for (uint32_t i = 0; i < count; ++i) {
        const auto [x, y] = items[i].key;
        out = {std::min(out.lowX, x), std::min(out.lowY, y), std::max(out.highX, x), std::max(out.highY, y)};
    }
    return out;
}

#endif

/// Copies items with key[axis] <= limit to the front of `out` and the others to its back; returns the number of the
/// former. Every item is written to both ends and the counts decide which copy stays: a branch would be mispredicted half
/// of the time. Four at a time, because the keys then load and compare ahead of the counting (0.8 against 1.0 ns an item).
__attribute__((noinline)) uint32_t Partition(const KeyItem* in, uint32_t count, KeyItem* out, int axis, int limit) {
    KeyItem* back = out + count - 1;
    ptrdiff_t left = 0;
    uint32_t i = 0;
    for (; i + 4 <= count; i += 4, back -= 4) {
        uint64_t items[4];
        std::memcpy(items, in + i, sizeof items);
        for (int lane = 0; lane < 4; ++lane) {
            const ptrdiff_t goesLeft = in[i + static_cast<uint32_t>(lane)].key[axis] <= limit ? 1 : 0;
            std::memcpy(out + left, &items[lane], sizeof(KeyItem));
            std::memcpy(back + left - lane, &items[lane], sizeof(KeyItem));
            left += goesLeft;
        }
    }
    for (; i < count; ++i, --back) {
        const ptrdiff_t goesLeft = in[i].key[axis] <= limit ? 1 : 0;
        std::memcpy(out + left, in + i, sizeof(KeyItem));
        std::memcpy(back + left, in + i, sizeof(KeyItem));
        left += goesLeft;
    }
    return static_cast<uint32_t>(left);
}

struct KeysPass {
    const AABB* boxes;
    const ItemId* ids;
    uint32_t leafSize;
    FlatTree& tree;
    uint32_t nextPosition = 0;

    /// Gives the items keys from the bounds of their own centres; false if those are one point or beyond arithmetic.
    bool MakeKeys(KeyItem* items, uint32_t count) const {
        // Lanes: twice the centre, x and y, two times.
        const auto centreOf = [this](KeyItem item) {
            const F4 box = Load4(&boxes[item.slot].lowerBound.x);
            return Add4(box, SwapHalves4(box));
        };
        F4 lowLanes = Splat4(infinity);
        F4 highLanes = Splat4(-infinity);
        for (uint32_t i = 0; i < count; ++i) {
            const F4 centre = centreOf(items[i]);
            lowLanes = Min4(lowLanes, centre);
            highLanes = Max4(highLanes, centre);
        }
        float low[4], high[4];
        Store4(low, lowLanes);
        Store4(high, highLanes);
        // One unit for both axes, so that key extents compare like lengths.
        const float extent = std::max(high[0] - low[0], high[1] - low[1]);
        const float scale = 65535.0f / extent;
        if (!(extent > 0.0f && scale > 0.0f && scale < infinity)) return false;
        for (uint32_t i = 0; i < count; ++i) {
            const AABB& box = boxes[items[i].slot];
            const float x = (box.lowerBound.x + box.upperBound.x - low[0]) * scale;
            const float y = (box.lowerBound.y + box.upperBound.y - low[1]) * scale;
            items[i].key[0] = static_cast<int16_t>(static_cast<int>(x) - 0x8000);
            items[i].key[1] = static_cast<int16_t>(static_cast<int>(y) - 0x8000);
        }
        return true;
    }

    /// Fetches the boxes of a leaf and returns their union.
    F4 FillLeaf(TreeNode& node, const KeyItem* items, uint32_t count) {
        const uint32_t first = nextPosition;
        F4 sum = Load(emptyBounds);
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t slot = items[i].slot;
            const Bounds box = ToBounds(boxes[slot]);
            tree.SetItem(first + i, box, ids[slot]);
            sum = Min4(sum, Load(box));
        }
        nextPosition = first + (count + leafRow - 1) / leafRow * leafRow;
        for (uint32_t p = first + count; p < nextPosition; ++p) tree.SetItem(p, emptyBounds, {paddingFixture, fixedGroup});
        node.first = first;
        node.count = count;
        Store(node.box, sum);
        return sum;
    }

    /// Items of the range lie in `in`; `other` is the same range of the other array. `halve`: keys tell nothing.
    void Recurse(uint32_t nodeIndex, KeyItem* in, KeyItem* other, uint32_t count, int depth, bool halve) {
        if (count <= leafSize) {
            FillLeaf(tree.nodes[nodeIndex], in, count);
            return;
        }
        uint32_t left = count / 2;
        if (!halve) {
            KeyBounds keys = MeasureKeys(in, count);
            if (std::max(keys.Width(), keys.Height()) < coarseExtent) {
                halve = !MakeKeys(in, count);
                if (!halve) keys = MeasureKeys(in, count);
            }
            halve = halve || depth >= maxRuleDepth;
            if (!halve) {
                const bool alongX = keys.Width() >= keys.Height();
                const int limit = alongX ? (keys.lowX + keys.highX) >> 1 : (keys.lowY + keys.highY) >> 1;
                left = Partition(in, count, other, alongX ? 0 : 1, limit);
                std::swap(in, other);
            }
        }
        const uint32_t first = nextPosition;
        const auto child = static_cast<uint32_t>(tree.nodes.size());
        tree.nodes.resize(child + 2);
        Recurse(child, in, other, left, depth + 1, halve);
        Recurse(child + 1, in + left, other + left, count - left, depth + 1, halve);
        TreeNode& node = tree.nodes[nodeIndex];
        node.child = child;
        node.first = first;
        node.count = nextPosition - first;
        Store(node.box, Min4(Load(tree.nodes[child].box), Load(tree.nodes[child + 1].box)));
    }
};

}  // namespace

void KeysBuilder::Build(const ProxyStore& store, SlotRange slots, uint32_t leafSize, FlatTree& tree) {
    // Leaves hold at least one box each, so this is the most that padding can need.
    tree.Reset(0);
    if (slots.count == 0) return;
    m_items.resize(std::max<size_t>(m_items.size(), slots.count));
    // The odd part keeps both arrays from starting at the same page offset.
    m_other.resize(m_items.size() + 200);
    for (uint32_t i = 0; i < slots.count; ++i) m_items[i] = {{0, 0}, slots.first + i};
    tree.Reset(leafRow * slots.count);
    tree.nodes.resize(1);
    KeysPass pass{store.Boxes(), store.Ids(), leafSize, tree};
    pass.Recurse(0, m_items.data(), m_other.data() + 200, slots.count, 0, false);
    tree.Trim(pass.nextPosition);
}

}  // namespace scree::broadphase
