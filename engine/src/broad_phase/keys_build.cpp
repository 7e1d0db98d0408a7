// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Building on 16-bit centre keys: slots in, flat tree with wide leaves out. Two item arrays take turns: a split reads
// one and writes the other from both ends, without a branch per item.

#include "broad_phase/keys_build.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <utility>

#include "base/gather_parts.h"
#include "broad_phase/split_rules.h"

namespace scree::broadphase {
namespace {

/// Keys spanning fewer units than this are made anew from the boxes: a middle split would soon have nothing to compare.
constexpr int coarseExtent = 64;

struct KeyBounds {
    int16_t lowX, lowY, highX, highY;

    [[nodiscard]] int Width() const { return highX - lowX; }
    [[nodiscard]] int Height() const { return highY - lowY; }
    void Join(const KeyBounds& other) {
        lowX = std::min(lowX, other.lowX), lowY = std::min(lowY, other.lowY);
        highX = std::max(highX, other.highX), highY = std::max(highY, other.highY);
    }
};

/// Where a range of keys is cut: true for items that go to the first child.
struct KeyMiddle {
    int axis, limit;

    bool operator()(const KeyItem& item) const { return item.key[axis] <= limit; }
};

/// In the middle of the longer side.
KeyMiddle MiddleOf(const KeyBounds& keys) {
    if (keys.Width() >= keys.Height()) return {0, (keys.lowX + keys.highX) >> 1};
    return {1, (keys.lowY + keys.highY) >> 1};
}

KeyBounds MeasureKeys(const KeyItem* items, uint32_t count) {
    // Two items per register; the lanes that hold slots are never read.
    S8 low = SplatS8(0x7FFF), high = SplatS8(-0x8000);
    const auto take = [&](S8 keys) { low = MinS8(low, keys), high = MaxS8(high, keys); };
    uint32_t i = 0;
    for (; i + 2 <= count; i += 2) take(LoadS8(items + i));
    if (i < count) take(LoadTwiceS8(items + i));
    low = MinS8(low, UpperHalfS8(low));
    high = MaxS8(high, UpperHalfS8(high));
    int16_t lowest[2], highest[2];
    StoreFirstTwoS8(lowest, low);
    StoreFirstTwoS8(highest, high);
    return {lowest[0], lowest[1], highest[0], highest[1]};
}

/// Copies items before the middle to the front of `out` and the others to its back; returns the number of the
/// former. Every item is written to both ends and the counts decide which copy stays: a branch would be mispredicted
/// half of the time. Four at a time, all loaded before the first is stored, since the compiler must assume that they
/// overlap.
SCREE_NOINLINE uint32_t Partition(const KeyItem* in, uint32_t count, KeyItem* out, KeyMiddle middle) {
    const auto goesLeft = [=](const KeyItem& item) { return static_cast<ptrdiff_t>(middle(item) ? 1 : 0); };
    const auto put = [](KeyItem* place, uint64_t item) { std::memcpy(place, &item, sizeof item); };
    KeyItem* back = out + count - 1;
    const KeyItem* const end = in + count;
    ptrdiff_t left = 0;
    for (; end - in >= 4; in += 4, back -= 4) {
        const ptrdiff_t left1 = goesLeft(in[0]), left2 = goesLeft(in[1]), left3 = goesLeft(in[2]),
                        left4 = goesLeft(in[3]);
        uint64_t items[4];
        std::memcpy(&items[0], in, 8);
        std::memcpy(&items[1], in + 1, 8);
        std::memcpy(&items[2], in + 2, 8);
        std::memcpy(&items[3], in + 3, 8);
        put(out + left, items[0]);
        put(back + left, items[0]);
        left += left1;
        put(out + left, items[1]);
        put(back + left - 1, items[1]);
        left += left2;
        put(out + left, items[2]);
        put(back + left - 2, items[2]);
        left += left3;
        put(out + left, items[3]);
        put(back + left - 3, items[3]);
        left += left4;
    }
    for (; in != end; ++in, --back) {
        const ptrdiff_t step = goesLeft(*in);
        uint64_t item;
        std::memcpy(&item, in, sizeof item);
        put(out + left, item);
        put(back + left, item);
        left += step;
    }
    return static_cast<uint32_t>(left);
}

/// Fetches the boxes of a leaf, four at a time. `boxOf(i)` gives that of its i-th position.
template <typename BoxOf>
void FillLeafBoxes(FlatTree& tree, TreeNode& node, BoxOf boxOf) {
    F4 sum = Load(emptyBounds);
    float* const lanes[4] = {tree.Lane(0) + node.first, tree.Lane(1) + node.first, tree.Lane(2) + node.first,
                             tree.Lane(3) + node.first};
    const auto fetch = [&](uint32_t index) {
        const F4 box = Load(boxOf(index));
        sum = Min4(sum, box);
        return box;
    };
    const uint32_t count = node.count;
    uint32_t i = 0;
    for (; i + 4 <= count; i += 4) {
        F4 a = fetch(i), b = fetch(i + 1), c = fetch(i + 2), d = fetch(i + 3);
        Transpose4(a, b, c, d);
        Store4(lanes[0] + i, a);
        Store4(lanes[1] + i, b);
        Store4(lanes[2] + i, c);
        Store4(lanes[3] + i, d);
    }
    for (; i < count; ++i) {
        Bounds box;
        Store(box, fetch(i));
        lanes[0][i] = box.lx;
        lanes[1][i] = box.ly;
        lanes[2][i] = box.nux;
        lanes[3][i] = box.nuy;
    }
    Store(node.box, sum);
}

void JoinBoxes(FlatTree& tree, TreeNode& node) {
    Store(node.box, Min4(Load(tree.nodes[node.child].box), Load(tree.nodes[node.child + 1].box)));
}

/// Fills the leaves below a node and joins their boxes.
template <typename Fill>
void FillSubtree(FlatTree& tree, TreeNode& node, Fill&& fill) {
    if (node.IsLeaf()) return fill(node);
    FillSubtree(tree, tree.nodes[node.child], fill);
    FillSubtree(tree, tree.nodes[node.child + 1], fill);
    JoinBoxes(tree, node);
}

/// Calls fill(leaf) for all leaves and gives all nodes the boxes of what is below them. Nodes stand level by level.
template <typename Fill>
void FillTree(FlatTree& tree, TaskPool* pool, Fill&& fill) {
    constexpr uint32_t leastNodes = 512, topNodes = 128;  // of many subtrees all workers get their share
    const auto count = static_cast<uint32_t>(tree.nodes.size());
    uint32_t end = count;  // of the nodes that are finished here, last nodes first: children stand behind their parents
    if (pool != nullptr && pool->IsOpen() && count >= leastNodes) {
        end = topNodes;
        uint32_t below = 1;  // the first nodes have as many children as this, and one root
        for (uint32_t i = 0; i < end; ++i) below += tree.nodes[i].IsLeaf() ? 0 : 2;
        pool->For(static_cast<int>(below - end), 2, [&](int first, int last, int /*worker*/) {
            for (int i = first; i < last; ++i) FillSubtree(tree, tree.nodes[end + static_cast<uint32_t>(i)], fill);
        });
    }
    for (uint32_t i = end; i-- > 0;) {
        TreeNode& node = tree.nodes[i];
        node.IsLeaf() ? fill(node) : JoinBoxes(tree, node);
    }
}

/// What a node knows while it waits to be split.
struct BuildState {
    uint32_t array = 0;  ///< which of the two arrays holds its items
    uint32_t depth = 0;
    bool halve = false;  ///< keys tell nothing more: split into equal counts

    [[nodiscard]] uint32_t Pack() const { return array | (halve ? 2u : 0u) | depth << 2; }
    static BuildState Unpack(uint32_t bits) { return {bits & 1u, bits >> 2, (bits & 2u) != 0}; }
};

/// Bounds of twice the centres of boxes; lanes: x, y, and both once more.
struct CentreBounds {
    float low[4], high[4];

    void Join(const CentreBounds& other) {
        for (int i = 0; i < 4; ++i) {
            low[i] = std::min(low[i], other.low[i]);
            high[i] = std::max(high[i], other.high[i]);
        }
    }
};

/// How centres become keys. One unit for both axes, so that key extents compare like lengths.
struct KeyScale {
    float lowX = 0.0f, lowY = 0.0f, factor = 0.0f;

    /// False if the centres are one point or beyond arithmetic.
    [[nodiscard]] bool Set(const CentreBounds& centres) {
        const float extent = std::max(centres.high[0] - centres.low[0], centres.high[1] - centres.low[1]);
        lowX = centres.low[0], lowY = centres.low[1], factor = 65535.0f / extent;
        return extent > 0.0f && factor > 0.0f && factor < infinity;
    }
};

/// What one worker at a time does of the first split.
struct alignas(64) RootPart {
    CentreBounds centres;
    KeyBounds keys;
    uint32_t left = 0;       ///< items that go to the first child
    uint32_t firstLeft = 0;  ///< those of the parts before
};

struct KeysPass {
    const AABB* boxes;
    const ItemId* ids;
    uint32_t leafSize;
    FlatTree& tree;
    KeyItem* arrays[2];

    [[nodiscard]] CentreBounds MeasureCentres(const KeyItem* items, uint32_t count) const {
        F4 low = Splat4(infinity);
        F4 high = Splat4(-infinity);
        for (uint32_t i = 0; i < count; ++i) {
            const F4 box = Load4(reinterpret_cast<const float*>(&boxes[items[i].slot]));
            const F4 centre = box + SwapHalves4(box);
            low = Min4(low, centre);
            high = Max4(high, centre);
        }
        CentreBounds bounds;
        Store4(bounds.low, low);
        Store4(bounds.high, high);
        return bounds;
    }

    void PutKeys(const KeyScale& scale, KeyItem* items, uint32_t count) const {
        for (uint32_t i = 0; i < count; ++i) {
            const AABB& box = boxes[items[i].slot];
            const float x = (box.lowerBound.x + box.upperBound.x - scale.lowX) * scale.factor;
            const float y = (box.lowerBound.y + box.upperBound.y - scale.lowY) * scale.factor;
            items[i].key[0] = static_cast<int16_t>(static_cast<int>(x) - 0x8000);
            items[i].key[1] = static_cast<int16_t>(static_cast<int>(y) - 0x8000);
        }
    }

    /// Gives the items keys from the bounds of their own centres; false if these give none.
    bool MakeKeys(KeyItem* items, uint32_t count) const {
        KeyScale scale;
        if (!scale.Set(MeasureCentres(items, count))) return false;
        PutKeys(scale, items, count);
        return true;
    }

    /// Fetches what a leaf holds.
    void FillLeaf(TreeNode& node) {
        const KeyItem* const items = arrays[BuildState::Unpack(node.buildState).array] + node.first;
        ItemId* const outIds = tree.Ids() + node.first;
        FillLeafBoxes(tree, node, [&](uint32_t index) -> const AABB& {
            const uint32_t slot = items[index].slot;
            outIds[index] = ids[slot];
            return boxes[slot];
        });
    }

    [[nodiscard]] bool Splits(const TreeNode& node) const { return node.count > leafSize; }

    /// Splits a node's items between two children, which have places.
    void Split(TreeNode& node) {
        BuildState state = BuildState::Unpack(node.buildState);
        KeyItem* const in = arrays[state.array] + node.first;
        uint32_t left = node.count / 2;
        KeyBounds keys{};
        if (!state.halve) keys = MeasureKeys(in, node.count);
        if (!state.halve && std::max(keys.Width(), keys.Height()) < coarseExtent) {
            state.halve = !MakeKeys(in, node.count);
            keys = MeasureKeys(in, node.count);
        }
        state.halve |= state.depth >= maxRuleDepth;
        if (!state.halve) {
            state.array = 1 - state.array;
            left = Partition(in, node.count, arrays[state.array] + node.first, MiddleOf(keys));
        }
        MakeChildren(node, left, state);
    }
    void MakeChildren(const TreeNode& node, uint32_t left, BuildState state) {
        ++state.depth;
        tree.nodes[node.child] = {emptyBounds, node.first, left, noChild, state.Pack()};
        tree.nodes[node.child + 1] = {emptyBounds, node.first + left, node.count - left, noChild, state.Pack()};
    }

    /// Makes the items and splits them as Split does, by all workers.
    void SplitRoot(uint32_t firstSlot, TaskPool& pool) {
        TreeNode& root = tree.nodes[0];
        const Parts ranges(pool, static_cast<int>(root.count), 0);
        RootPart room[Parts::most];
        const std::span parts = std::span(room).first(static_cast<size_t>(ranges.Count()));
        const auto inParts = [&](auto&& work) {
            ranges.For(pool, [&](int part, int begin, int end) {
                work(room[part], arrays[0] + begin, static_cast<uint32_t>(end - begin));
            });
        };
        inParts([&](RootPart& part, KeyItem* items, uint32_t count) {
            const auto slot = firstSlot + static_cast<uint32_t>(items - arrays[0]);
            for (uint32_t i = 0; i < count; ++i) items[i] = {{0, 0}, slot + i};
            part.centres = MeasureCentres(items, count);
        });
        CentreBounds centres = parts[0].centres;
        for (const RootPart& part : parts) centres.Join(part.centres);
        KeyScale scale;
        if (!scale.Set(centres)) return MakeChildren(root, root.count / 2, {.halve = true});

        inParts([&](RootPart& part, KeyItem* items, uint32_t count) {
            PutKeys(scale, items, count);
            part.keys = MeasureKeys(items, count);
        });
        KeyBounds keys = parts[0].keys;
        for (const RootPart& part : parts) keys.Join(part.keys);
        const KeyMiddle middle = MiddleOf(keys);
        inParts([&](RootPart& part, const KeyItem* items, uint32_t count) {
            part.left = static_cast<uint32_t>(std::count_if(items, items + count, middle));
        });
        uint32_t left = 0;
        for (RootPart& part : parts) part.firstLeft = std::exchange(left, left + part.left);
        inParts([&](const RootPart& part, const KeyItem* items, uint32_t count) {
            KeyItem* front = arrays[1] + part.firstLeft;
            KeyItem* back = arrays[1] + root.count - 1 - (static_cast<uint32_t>(items - arrays[0]) - part.firstLeft);
            for (uint32_t i = 0; i < count; ++i) {
                const bool goesLeft = middle(items[i]);
                *(goesLeft ? front : back) = items[i];
                front += goesLeft ? 1 : 0;
                back -= goesLeft ? 0 : 1;
            }
        });
        MakeChildren(root, left, {.array = 1});
    }

    /// Splits the nodes from `begin` on, and gives their children the places behind them.
    void SplitLevel(uint32_t begin, TaskPool* pool) {
        const auto end = static_cast<uint32_t>(tree.nodes.size());
        uint32_t next = end;
        for (uint32_t i = begin; i < end; ++i) {
            if (!Splits(tree.nodes[i])) continue;
            tree.nodes[i].child = next;
            next += 2;
        }
        tree.nodes.resize(next);
        const auto split = [&](int first, int last, int /*worker*/) {
            for (int i = first; i < last; ++i) {
                if (TreeNode& node = tree.nodes[begin + static_cast<uint32_t>(i)]; Splits(node)) Split(node);
            }
        };
        constexpr int leastNodes = 2;
        const auto count = static_cast<int>(end - begin);
        pool != nullptr ? pool->For(count, leastNodes, split) : split(0, count, 0);
    }
};

}  // namespace

void KeysBuilder::Build(const ProxyStore& store, SlotRange slots, uint32_t leafSize, TaskPool* pool, FlatTree& tree) {
    tree.Reset(slots.count, store.Size());
    if (slots.count == 0) return;
    // The odd part keeps both arrays from starting at the same page offset.
    constexpr size_t odd = 200;
    if (m_items.size() < slots.count) {
        m_items.resize(slots.count + slots.count / 2);
        m_other.resize(m_items.size() + odd);
    }
    KeysPass pass{store.Boxes(), store.Ids(), leafSize, tree, {m_items.data(), m_other.data() + odd}};
    tree.nodes.push_back({emptyBounds, 0, slots.count});
    constexpr uint32_t leastShared = 2048;  // boxes
    TaskPool* const shared = pool != nullptr && pool->IsOpen() && slots.count >= leastShared ? pool : nullptr;
    uint32_t begin = 0;
    if (shared != nullptr && pass.Splits(tree.nodes[0])) {
        tree.nodes[0].child = 1;
        tree.nodes.resize(3);
        pass.SplitRoot(slots.first, *shared);
        begin = 1;
    } else {
        for (uint32_t i = 0; i < slots.count; ++i) m_items[i] = {{0, 0}, slots.first + i};
    }
    // Level by level: a range is read long after it was written. Depth first, the loads of small ranges would meet
    // stores that have not reached the cache yet.
    while (begin < tree.nodes.size()) {
        const auto next = static_cast<uint32_t>(tree.nodes.size());
        pass.SplitLevel(begin, shared);
        begin = next;
    }
    FillTree(tree, pool, [&](TreeNode& leaf) { pass.FillLeaf(leaf); });
}

void KeysBuilder::Refit(const ProxyStore& store, TaskPool* pool, FlatTree& tree) {
    static constexpr AABB noBox = ToAabb(emptyBounds);  // of positions whose proxies have left
    FillTree(tree, pool, [&](TreeNode& leaf) {
        const ItemId* const ids = tree.Ids() + leaf.first;
        FillLeafBoxes(tree, leaf, [&](uint32_t index) -> const AABB& {
            const uint32_t slot = store.Find(ids[index].fixture);
            return slot == noSlot ? noBox : store.Box(slot);
        });
    });
}

float KeysBuilder::SumHalfPerimeters(const FlatTree& tree) {
    float sums[4] = {};  // side by side: one sum would wait for each addition
    for (size_t i = 0; i < tree.nodes.size(); ++i) {
        const Bounds& box = tree.nodes[i].box;
        sums[i % 4] += box.lx < infinity ? HalfPerimeter(box) : 0.0f;
    }
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

}  // namespace scree::broadphase
