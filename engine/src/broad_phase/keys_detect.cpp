// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The walk with candidate sets and its kernels: tree in, pairs out. The kernels are not inlined and keep their pointers
// and counts in locals, which the compiler otherwise spills in the recursion around them.

#include "broad_phase/keys_detect.h"

#include <algorithm>

#include "base/bytes.h"
#include "base/slots.h"
#include "broad_phase/lane_lists.h"

namespace scree::broadphase {
namespace {

/// Candidates are tested against a leaf in blocks, so that the hits stay in the first-level cache.
constexpr uint32_t hitBlock = 2048;
/// Parts of a shared walk per worker, about: more are better balanced, and each looks for its candidates itself.
constexpr uint32_t partsPerWorker = 4;
/// A node of so many boxes is scanned for candidates as a whole.
constexpr uint32_t scannedWhole = 48;
/// From so many pairs on the parts' lists are put together by all workers.
constexpr size_t leastPairsToCopy = 1024;
/// A store of four lanes writes beyond the last hit.
constexpr uint32_t hitSlack = 4;

struct Hits {
    uint32_t* first;
    uint32_t* second;
};

/// Bit i is set where all four comparisons hold in lane i.
SCREE_KERNEL uint32_t MaskAllLessEqual(const F4 (&a)[4], const F4 (&b)[4]) {
    const Mask4 x = And4(LessEqual4(a[0], b[0]), LessEqual4(a[2], b[2]));
    const Mask4 y = And4(LessEqual4(a[1], b[1]), LessEqual4(a[3], b[3]));
    return Bits4(And4(x, y));
}

struct Lanes {
    const float* lane[4];

    explicit Lanes(const FlatTree& tree) : lane{tree.Lane(0), tree.Lane(1), tree.Lane(2), tree.Lane(3)} {}

    /// Which of the boxes at position … position + 3 overlap the box whose probe lanes are given.
    [[nodiscard]] uint32_t RowMask(uint32_t position, const F4 (&probe)[4]) const {
        F4 row[4];
        LoadRow(position, row);
        return MaskAllLessEqual(row, probe);
    }
    /// Reads the four boxes at position … position + 3.
    void LoadRow(uint32_t position, F4 (&row)[4]) const {
        // Written out: a loop over registers is compiled as a loop over memory.
        row[0] = Load4(lane[0] + position);
        row[1] = Load4(lane[1] + position);
        row[2] = Load4(lane[2] + position);
        row[3] = Load4(lane[3] + position);
    }
};

/// Which of the four probes overlap one of four boxes.
template <int one>
uint32_t MaskOfOne(const F4 (&row)[4], const F4 (&probe)[4]) {
    const F4 box[4] = {SplatLane4<one>(row[0]), SplatLane4<one>(row[1]), SplatLane4<one>(row[2]),
                       SplatLane4<one>(row[3])};
    return MaskAllLessEqual(box, probe);
}

/// The probe of a box, each component in all four lanes of its own register.
struct SplatProbe {
    F4 lane[4];

    explicit SplatProbe(const Bounds& b) : lane{Splat4(-b.nux), Splat4(-b.nuy), Splat4(-b.lx), Splat4(-b.ly)} {}
};

/// The lanes of a row that lie before `end`.
constexpr uint32_t LanesBefore(uint32_t row, uint32_t end) { return end - row >= 4 ? 15u : (1u << (end - row)) - 1u; }

/// All pairs inside a leaf; returns the number of hits. Each row of four boxes stays in registers as probes and meets
/// all rows before it, then itself. So loops end once per row and not once per box; every end is a misprediction.
SCREE_NOINLINE uint32_t TestInside(const FlatTree& tree, const TreeNode& leaf, Hits hits) {
    const Lanes lanes(tree);
    uint32_t* outFirst = hits.first;
    uint32_t* outSecond = hits.second;
    const uint32_t first = leaf.first, end = leaf.first + leaf.count;
    uint32_t found = 0;
    const auto emit = [&](uint32_t mask, uint32_t one, uint32_t row) {
        found += EmitLanes(laneLists[mask], one, row, outFirst + found, outSecond + found);
    };
    for (uint32_t row = first; row < end; row += 4) {
        F4 own[4];
        lanes.LoadRow(row, own);
        const F4 probe[4] = {Negate4(own[2]), Negate4(own[3]), Negate4(own[0]), Negate4(own[1])};
        const uint32_t valid = LanesBefore(row, end);
        for (uint32_t i = first; i < row; i += 4) {
            F4 boxes[4];
            lanes.LoadRow(i, boxes);
            emit(MaskOfOne<0>(boxes, probe) & valid, i, row);
            emit(MaskOfOne<1>(boxes, probe) & valid, i + 1, row);
            emit(MaskOfOne<2>(boxes, probe) & valid, i + 2, row);
            emit(MaskOfOne<3>(boxes, probe) & valid, i + 3, row);
        }
        // In its own row a box meets the lanes behind its own.
        emit(MaskOfOne<0>(own, probe) & valid & 14u, row, row);
        emit(MaskOfOne<1>(own, probe) & valid & 12u, row + 1, row);
        emit(MaskOfOne<2>(own, probe) & valid & 8u, row + 2, row);
    }
    return found;
}

/// Pairs of candidates and the boxes of a leaf; a hit's first is the index among the candidates.
SCREE_NOINLINE uint32_t TestCandidates(const FlatTree& tree, const TreeNode& leaf, const Bounds* candidates,
                                       uint32_t candidateCount, Hits hits) {
    const Lanes lanes(tree);
    uint32_t* outFirst = hits.first;
    uint32_t* outSecond = hits.second;
    const uint32_t first = leaf.first, end = leaf.first + leaf.count;
    uint32_t found = 0;
    for (uint32_t c = 0; c < candidateCount; ++c) {
        const SplatProbe probe(candidates[c]);
        for (uint32_t row = first; row < end; row += 4) {
            const uint32_t mask = lanes.RowMask(row, probe.lane) & LanesBefore(row, end);
            found += EmitLanes(laneLists[mask], c, row, outFirst + found, outSecond + found);
        }
    }
    return found;
}

/// Positions of a node's boxes that overlap `box`, written to out.second; returns how many.
SCREE_NOINLINE uint32_t ScanRange(const FlatTree& tree, const TreeNode& range, const Bounds& box, Hits out) {
    const Lanes lanes(tree);
    const SplatProbe probe(box);
    uint32_t* outSecond = out.second;
    const uint32_t end = range.first + range.count;
    uint32_t found = 0;
    for (uint32_t row = range.first; row < end; row += 4) {
        const uint32_t mask = lanes.RowMask(row, probe.lane) & LanesBefore(row, end);
        found += EmitLanes(laneLists[mask], 0, row, out.first, outSecond + found);
    }
    return found;
}

SCREE_NOINLINE void EmitPairs(const ItemId* firstIds, const ItemId* secondIds, Hits hits, uint32_t count,
                              PairSink& sink) {
    const uint32_t* first = hits.first;
    const uint32_t* second = hits.second;
    Pair* out = sink.Reserve(count + 1);
    size_t kept = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const ItemId a = firstIds[first[i]];
        const ItemId b = secondIds[second[i]];
        out[kept] = {std::min(a.fixture, b.fixture), std::max(a.fixture, b.fixture)};
        kept += a.group != b.group ? 1 : 0;
    }
    sink.Commit(kept);
}

/// Which of two children has fewer boxes.
uint32_t SmallerOf(const TreeNode* children) { return children[0].count <= children[1].count ? 0 : 1; }

/// Two stacks of candidates side by side: where sets are read from and written to.
struct CandidateArrays {
    Bounds* boxes;
    ItemId* ids;
};

/// Copies those of the candidates that overlap box 1 to `out1` and those that overlap box 2 to `out2`.
SCREE_NOINLINE std::pair<uint32_t, uint32_t> FilterForBoth(CandidateArrays in, uint32_t count, const TreeNode* children,
                                                           CandidateArrays out1, CandidateArrays out2) {
    const F4 probe1 = ProbeOf(Load(children[0].box));
    const F4 probe2 = ProbeOf(Load(children[1].box));
    uint32_t kept1 = 0, kept2 = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const F4 box = Load(in.boxes[i]);
        const ItemId id = in.ids[i];
        Store(out1.boxes[kept1], box);
        out1.ids[kept1] = id;
        kept1 += Overlaps(box, probe1) ? 1 : 0;
        Store(out2.boxes[kept2], box);
        out2.ids[kept2] = id;
        kept2 += Overlaps(box, probe2) ? 1 : 0;
    }
    return {kept1, kept2};
}

}  // namespace

/// One walk. `self`: boxes of the tree pair with each other too, not only with the candidates.
template <bool self>
struct KeysWalk {
    const FlatTree& tree;
    KeysBuffers& buffers;
    PairSink& sink;
    uint64_t boxTests = 0;

    [[nodiscard]] CandidateArrays At(uint32_t index) const {
        return {buffers.boxes.data() + index, buffers.ids.data() + index};
    }
    [[nodiscard]] Hits HitArrays() const { return {buffers.hitsFirst.data(), buffers.hitsSecond.data()}; }

    void ReserveCandidates(size_t count) {
        if (buffers.boxes.size() >= count) return;
        buffers.boxes.resize(2 * count);
        buffers.ids.resize(2 * count);
    }
    void PutCandidates(size_t first, std::span<const BuildItem> items) {
        for (size_t i = 0; i < items.size(); ++i) {
            buffers.boxes[first + i] = items[i].box;
            buffers.ids[first + i] = items[i].id;
        }
    }
    void ReserveHits(size_t count) {
        if (buffers.hitsFirst.size() >= count) return;
        buffers.hitsFirst.resize(2 * count);
        // The odd part keeps both arrays from starting at the same page offset.
        buffers.hitsSecond.resize(2 * count + 208);
    }

    void Recurse(const TreeNode& node, uint32_t firstCandidate, uint32_t count) {
        if (node.IsLeaf()) {
            FinishLeaf(node, firstCandidate, count);
            return;
        }
        const TreeNode* children = &tree.nodes[node.child];
        const uint32_t small = SmallerOf(children);
        // The set of the smaller child lies below that of the larger one, which is used first and then given up.
        const uint32_t top = firstCandidate + count;
        const uint32_t largeTop = top + count + 1;
        ReserveCandidates(largeTop + count + 1 + (self ? children[small].count : 0));
        uint32_t smallCount = 0, largeCount = 0;
        if (count > 0) {
            const auto [kept0, kept1] = FilterForBoth(At(firstCandidate), count, children,
                                                      At(small == 0 ? top : largeTop), At(small == 0 ? largeTop : top));
            smallCount = small == 0 ? kept0 : kept1;
            largeCount = small == 0 ? kept1 : kept0;
            boxTests += 2 * count;
        }
        if constexpr (self) largeCount += HandOver(children[small], children[1 - small], largeTop + largeCount);
        if (self || largeCount > 0) Recurse(children[1 - small], largeTop, largeCount);
        if (self || smallCount > 0) Recurse(children[small], top, smallCount);
    }

    /// Puts the boxes of `from` that overlap the node `to` on the stack.
    uint32_t HandOver(const TreeNode& from, const TreeNode& to, uint32_t top) {
        const uint32_t tests = CountHandOver(from, to);
        boxTests += tests;
        return tests > 1 ? TakeOver(from, to.box, top) : 0;
    }
    /// Box tests of handing over: the two nodes, and all boxes of one if these overlap.
    static uint32_t CountHandOver(const TreeNode& from, const TreeNode& to) {
        return Overlaps(Load(from.box), ProbeOf(Load(to.box))) ? 1 + from.count : 1;
    }
    /// Puts the boxes of `from` that overlap `box` on the stack, and returns how many.
    uint32_t TakeOver(const TreeNode& from, const Bounds& box, uint32_t top) {
        ReserveHits(from.count + hitSlack);
        const Hits hits = HitArrays();
        const uint32_t found = ScanRange(tree, from, box, hits);
        const CandidateArrays out = At(top);
        const ItemId* ids = tree.Ids();
        for (uint32_t i = 0; i < found; ++i) {
            out.boxes[i] = tree.Box(hits.second[i]);
            out.ids[i] = ids[hits.second[i]];
        }
        return found;
    }

    /// Puts those of the items on the stack that overlap the box.
    uint32_t TakeOverlapping(std::span<const BuildItem> items, const Bounds& box, uint32_t top) {
        const F4 probe = ProbeOf(Load(box));
        ReserveCandidates(top + items.size());
        const CandidateArrays out = At(top);
        uint32_t kept = 0;
        for (const BuildItem& item : items) {
            out.boxes[kept] = item.box;
            out.ids[kept] = item.id;
            kept += Overlaps(Load(item.box), probe) ? 1 : 0;
        }
        return kept;
    }
    /// As TakeOver, but passes over what is below nodes that do not overlap.
    uint32_t Collect(const TreeNode& from, const Bounds& box, uint32_t top) {
        if (!Overlaps(Load(from.box), ProbeOf(Load(box)))) return 0;
        if (from.IsLeaf() || from.count <= scannedWhole) {
            ReserveCandidates(top + from.count);
            return TakeOver(from, box, top);
        }
        const TreeNode* children = &tree.nodes[from.child];
        const uint32_t found = Collect(children[0], box, top);
        return found + Collect(children[1], box, top + found);
    }

    void FinishLeaf(const TreeNode& leaf, uint32_t firstCandidate, uint32_t count) {
        ReserveHits(std::max<size_t>(static_cast<size_t>(leaf.count) * leaf.count, hitBlock) + hitSlack);
        const Hits hits = HitArrays();
        if constexpr (self) {
            const uint32_t found = TestInside(tree, leaf, hits);
            EmitPairs(tree.Ids(), tree.Ids(), hits, found, sink);
            boxTests += static_cast<uint64_t>(leaf.count) * (leaf.count - 1) / 2;
        }
        const uint32_t block = std::max(1u, hitBlock / leaf.count);
        boxTests += static_cast<uint64_t>(count) * leaf.count;
        for (uint32_t done = 0; done < count; done += block) {
            const CandidateArrays candidates = At(firstCandidate + done);
            const uint32_t found = TestCandidates(tree, leaf, candidates.boxes, std::min(block, count - done), hits);
            EmitPairs(candidates.ids, tree.Ids(), hits, found, sink);
        }
    }
};

uint64_t KeysDetector::DetectSelf(const FlatTree& tree, std::span<const BuildItem> resting,
                                  std::span<const BuildItem> outside, TaskPool* pool, PairSink& sink) {
    if (tree.Empty()) return 0;
    if (pool != nullptr && pool->IsOpen() && tree.Size() >= leastBoxesToShare) {
        CutWalk(tree, *pool);
        return WalkParts(tree, resting, outside, *pool, sink);
    }
    KeysWalk<true> walk{tree, m_whole, sink};
    const auto count = static_cast<uint32_t>(resting.size() + outside.size());
    walk.ReserveCandidates(count);
    walk.PutCandidates(0, resting);
    walk.PutCandidates(resting.size(), outside);
    walk.Recurse(tree.nodes[0], 0, count);
    return walk.boxTests;
}

void KeysDetector::CutWalk(const FlatTree& tree, const TaskPool& pool) {
    const uint32_t largest = tree.Size() / (partsPerWorker * static_cast<uint32_t>(pool.GetWorkerCount()));
    m_cut.parts.clear();
    const auto cut = [&](auto& self, const TreeNode& node, int parent, const TreeNode* sibling) -> void {
        const auto index = static_cast<int>(m_cut.parts.size());
        const bool isBelow = node.IsLeaf() || node.count <= largest;
        m_cut.parts.push_back({.node = &node, .parent = parent, .sibling = sibling, .isBelow = isBelow});
        if (isBelow) return;
        const TreeNode* children = &tree.nodes[node.child];
        const uint32_t small = SmallerOf(children);
        self(self, children[1 - small], index, &children[small]);
        self(self, children[small], index, nullptr);
    };
    cut(cut, tree.nodes[0], -1, nullptr);
}

uint64_t KeysDetector::WalkParts(const FlatTree& tree, std::span<const BuildItem> resting,
                                 std::span<const BuildItem> outside, TaskPool& pool, PairSink& sink) {
    return ShareParts(pool, sink, [&](KeysBuffers& own, PairSink& found, size_t i) {
        const KeysCut::Part& part = m_cut.parts[i];
        KeysWalk<true> walk{tree, own, found};
        // A box that overlaps a node overlaps all that the node is in, so its way down to here need not be followed.
        const auto collect = [&](auto& self, const KeysCut::Part& from) -> uint32_t {
            uint32_t count = 0;
            if (from.parent >= 0) {
                count = self(self, m_cut.parts[static_cast<size_t>(from.parent)]);
            } else {
                count = walk.TakeOverlapping(resting, part.node->box, 0);
                count += walk.TakeOverlapping(outside, part.node->box, count);
            }
            return from.sibling == nullptr ? count : count + walk.Collect(*from.sibling, part.node->box, count);
        };
        const bool isRoot = part.parent < 0;
        const uint32_t count = isRoot ? static_cast<uint32_t>(resting.size() + outside.size()) : collect(collect, part);
        if (part.isBelow) {
            walk.Recurse(*part.node, 0, count);
            return walk.boxTests;
        }
        // Box tests are those of a walk that is not cut: how long splits are kept hangs on them.
        const TreeNode* children = &tree.nodes[part.node->child];
        const uint32_t small = SmallerOf(children);
        return uint64_t{2} * count + KeysWalk<true>::CountHandOver(children[small], children[1 - small]);
    });
}

template <typename Walk>
uint64_t KeysDetector::ShareParts(TaskPool& pool, PairSink& sink, Walk&& walk) {
    EnsureRows(m_ofWorkers, static_cast<size_t>(pool.GetRowCount()));
    for (KeysBuffers& buffers : m_ofWorkers) buffers.pairCount = 0;
    pool.For(static_cast<int>(m_cut.parts.size()), 2, [&](int begin, int end, int worker) {
        KeysBuffers& own = m_ofWorkers[static_cast<size_t>(worker)];
        for (int i = begin; i < end; ++i) {
            KeysCut::Part& part = m_cut.parts[static_cast<size_t>(i)];
            PairSink found(own.pairs, own.pairCount);
            part.boxTests = walk(own, found, static_cast<size_t>(i));
            part.worker = worker;
            part.firstPair = own.pairCount;
            part.pairCount = found.End() - own.pairCount;
            own.pairCount = found.End();
        }
    });
    uint64_t boxTests = 0;
    size_t pairCount = 0;
    for (KeysCut::Part& part : m_cut.parts) {
        part.place = pairCount;
        pairCount += part.pairCount;
        boxTests += part.boxTests;
    }
    MatchRooms(m_ofWorkers);
    ReserveEach(m_ofWorkers, &KeysBuffers::pairs, pairCount);
    Pair* const pairs = sink.Reserve(pairCount);
    const auto copy = [&](int begin, int end, int /*worker*/) {
        for (int i = begin; i < end; ++i) {
            const KeysCut::Part& part = m_cut.parts[static_cast<size_t>(i)];
            const std::vector<Pair>& found = m_ofWorkers[static_cast<size_t>(part.worker)].pairs;
            std::copy_n(found.begin() + static_cast<ptrdiff_t>(part.firstPair), part.pairCount, pairs + part.place);
        }
    };
    const auto parts = static_cast<int>(m_cut.parts.size());
    pairCount >= leastPairsToCopy ? pool.For(parts, 2, copy) : copy(0, parts, 0);
    sink.Commit(pairCount);
    return boxTests;
}

uint64_t KeysDetector::DetectBetween(const FlatTree& batch, std::span<const BuildItem> more, const FlatTree& tree,
                                     TaskPool* pool, PairSink& sink) {
    // Boxes that follow each other in a tree are neighbours: so many of them go down together.
    constexpr uint32_t together = 256;
    const auto count = batch.Size() + static_cast<uint32_t>(more.size());
    if (count == 0 || tree.Empty()) return 0;
    const auto walkWith = [&](KeysBuffers& buffers, PairSink& found, uint32_t chunk) {
        const uint32_t begin = chunk * together, end = std::min(begin + together, count);
        KeysWalk<false> walk{tree, buffers, found};
        walk.ReserveCandidates(end - begin);
        const uint32_t ofBatch = std::min(end, batch.Size());
        for (uint32_t i = begin; i < ofBatch; ++i) {
            buffers.boxes[i - begin] = batch.Box(i);
            buffers.ids[i - begin] = batch.Ids()[i];
        }
        if (const uint32_t first = std::max(begin, ofBatch); first < end)
            walk.PutCandidates(first - begin, more.subspan(first - batch.Size(), end - first));
        walk.Recurse(tree.nodes[0], 0, end - begin);
        return walk.boxTests;
    };
    const uint32_t chunks = (count + together - 1) / together;
    if (pool != nullptr && pool->IsOpen() && count >= leastBoxesToShare) {
        m_cut.parts.assign(chunks, {});
        return ShareParts(*pool, sink, [&](KeysBuffers& own, PairSink& found, size_t part) {
            return walkWith(own, found, static_cast<uint32_t>(part));
        });
    }
    uint64_t boxTests = 0;
    for (uint32_t chunk = 0; chunk < chunks; ++chunk) boxTests += walkWith(m_whole, sink, chunk);
    return boxTests;
}

void KeysBuffers::MatchRoomOf(const KeysBuffers& other) {
    const auto match = [](auto& own, const auto& others) {
        if (own.size() < others.size()) own.resize(others.size());
    };
    match(boxes, other.boxes), match(ids, other.ids);
    match(hitsFirst, other.hitsFirst), match(hitsSecond, other.hitsSecond);
}

size_t KeysBuffers::GetMemoryBytes() const {
    return boxes.capacity() * sizeof(Bounds) + ids.capacity() * sizeof(ItemId) +
           (hitsFirst.capacity() + hitsSecond.capacity()) * sizeof(uint32_t) + pairs.capacity() * sizeof(Pair);
}

size_t KeysDetector::GetMemoryBytes() const {
    size_t bytes = m_cut.parts.capacity() * sizeof(KeysCut::Part) + m_whole.GetMemoryBytes();
    for (const KeysBuffers& buffers : m_ofWorkers) bytes += buffers.GetMemoryBytes();
    return bytes;
}

}  // namespace scree::broadphase
