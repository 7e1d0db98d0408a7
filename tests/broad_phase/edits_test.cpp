// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Law: edits and queries may interleave as they like; n of each cost far less than n² box tests and rebuilt proxies
// together. And a warm FindPairs allocates nothing. Both are counted, never timed.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/broad_phase/test_world.h"

namespace {

std::atomic<size_t> allocations{0};

}  // namespace

// Every allocation of the test binary is counted; new[] forwards to these. Not inlined: the compiler would otherwise
// see free() on what it knows to come from operator new and warn.
[[gnu::noinline]] void* operator new(size_t size) {
    ++allocations;
    if (void* p = std::malloc(size == 0 ? 1 : size)) return p;
    throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(size_t size, std::align_val_t alignment) {
    ++allocations;
    const size_t unit = static_cast<size_t>(alignment);
    if (void* p = std::aligned_alloc(unit, (size + unit - 1) / unit * unit)) return p;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, size_t) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, size_t, std::align_val_t) noexcept { std::free(p); }

namespace scree::test {
namespace {

class Edits : public testing::TestWithParam<BroadPhaseKind> {};

INSTANTIATE_TEST_SUITE_P(BroadPhase, Edits, testing::ValuesIn(allKinds), KindName);

/// Algorithms with linear queries (brute force, sweep and prune) are left out: their cost is quadratic by design.
class InterleavedEdits : public testing::TestWithParam<BroadPhaseKind> {};

INSTANTIATE_TEST_SUITE_P(BroadPhase, InterleavedEdits, testing::ValuesIn(treeKinds), KindName);

AABB CellBox(uint32_t i) {
    const Vec2 p{static_cast<float>(i % 97), static_cast<float>(i / 97)};
    return {p, p + Vec2{0.5f, 0.5f}};
}

/// Rebuilds what is due and queries; returns the box tests.
template <class Visit>
uint64_t PrepareAndQuery(BroadPhase& broadPhase, const AABB& box, Visit&& visit) {
    broadPhase.PrepareQueries();
    return broadPhase.Query(box, visit);
}

/// What n edits, each followed by a query, may cost; `interleave` returns the box tests of the queries. By the rule (a
/// list of up to 6√n edits beside the tree, a rebuild when it is full) that is a small multiple of n^1.5.
template <class Interleave>
void ExpectFarBelowQuadratic(BroadPhaseKind kind, Interleave&& interleave) {
    uint64_t costs[2];
    for (int i = 0; i < 2; ++i) {
        const auto broadPhase = CreateBroadPhase(kind);
        costs[i] = interleave(*broadPhase, i == 0 ? 4000u : 16'000u);
        costs[i] += broadPhase->GetStats().boxTests + broadPhase->GetStats().rebuiltProxies;
    }
    // Four times the size: 16 times the cost if quadratic, 8 times by the rule; 10 leaves room for logarithms.
    EXPECT_LT(costs[1], 10 * costs[0]) << costs[0] << " -> " << costs[1];
    // And an absolute bound: n²/8.
    EXPECT_LT(costs[1], 16'000ull * 16'000ull / 8);
}

TEST_P(InterleavedEdits, InsertAndQueryInTurnIsFarBelowQuadratic) {
    for (const Motion motion : {Motion::dynamic, Motion::isStatic}) {
        ExpectFarBelowQuadratic(GetParam(), [&](BroadPhase& broadPhase, uint32_t count) {
            uint64_t boxTests = 0;
            for (uint32_t i = 0; i < count; ++i) {
                broadPhase.Insert(i, i, motion, CellBox(i));
                int visits = 0;
                boxTests += PrepareAndQuery(broadPhase, CellBox(i), [&](uint32_t) { return ++visits > 0; });
                EXPECT_GE(visits, 1);
            }
            return boxTests;
        });
    }
}

TEST_P(InterleavedEdits, UpdateRemoveAndQueryInTurnIsFarBelowQuadratic) {
    ExpectFarBelowQuadratic(GetParam(), [](BroadPhase& broadPhase, uint32_t count) {
        for (uint32_t i = 0; i < count; ++i)
            broadPhase.Insert(i, i, i % 3 == 0 ? Motion::isStatic : Motion::dynamic, CellBox(i));
        std::vector<Pair> pairs;
        broadPhase.FindPairs(pairs);
        uint64_t boxTests = 0;
        for (uint32_t i = 0; i < count; ++i) {
            if (i % 2 == 0) {
                broadPhase.Remove(i);
            } else {
                broadPhase.Update(i, CellBox(count - i), vec2Zero);
            }
            boxTests += PrepareAndQuery(broadPhase, CellBox(i), [](uint32_t) { return true; });
        }
        return boxTests;
    });
}

/// A world that goes back and forth over the threshold of the static tree between queries must not rebuild each time.
TEST_P(InterleavedEdits, CrossingTheStaticThresholdInTurnIsFarBelowQuadratic) {
    ExpectFarBelowQuadratic(GetParam(), [](BroadPhase& broadPhase, uint32_t count) {
        for (uint32_t i = 0; i < count; ++i)
            broadPhase.Insert(i, i, i % 8 == 0 ? Motion::isStatic : Motion::dynamic, CellBox(i));
        std::vector<Pair> pairs;
        broadPhase.FindPairs(pairs);
        uint64_t boxTests = 0;
        for (uint32_t i = 0; i < count; ++i) {
            if (i % 2 == 0) {
                broadPhase.Insert(count, count, Motion::isStatic, CellBox(i));
            } else {
                broadPhase.Remove(count);
            }
            boxTests += PrepareAndQuery(broadPhase, CellBox(i), [](uint32_t) { return true; });
        }
        return boxTests;
    });
}

// Splits kept from the last step would be worth nothing after a jump and the search quadratic.
TEST(KeptSplits, AJumpOfEverythingCostsWhatANewTreeDoes) {
    constexpr uint32_t count = 4000;
    const auto jumped = [](uint32_t i) { return CellBox(i * 1237 % count); };
    const auto kept = CreateBroadPhase(BroadPhaseKind::keys), fresh = CreateBroadPhase(BroadPhaseKind::keys);
    std::vector<Pair> pairs;
    for (uint32_t i = 0; i < count; ++i) kept->Insert(i, i, Motion::dynamic, CellBox(i));
    for (int step = 0; step < 3; ++step) kept->FindPairs(pairs);
    std::vector<BoxUpdate> updates;
    for (uint32_t i = 0; i < count; ++i) {
        updates.push_back({jumped(i), vec2Zero, i});
        fresh->Insert(i, i, Motion::dynamic, jumped(i));
    }
    kept->UpdateMany(updates);
    kept->FindPairs(pairs);
    fresh->FindPairs(pairs);
    EXPECT_EQ(kept->GetStats().boxTests, fresh->GetStats().boxTests);
}

TEST_P(Edits, WarmFindPairsAllocatesNothing) {
    for (const float staticShare : {0.0f, 0.05f, 0.5f}) {
        WorldShape shape;
        shape.count = 600;
        shape.staticShare = staticShare;
        TestWorld world(shape);
        const auto broadPhase = CreateBroadPhase(GetParam());
        world.Fill(*broadPhase);
        // The world breathes: two poses in turn, so every buffer reaches its full size.
        std::vector<Pair> pairs;
        const auto pose = [&](bool shifted) {
            std::vector<BoxUpdate> updates;
            for (const TestFixture& fixture : world.Fixtures()) {
                if (fixture.motion == Motion::isStatic) continue;
                const Vec2 d{shifted ? 0.3f : 0.0f, 0.0f};
                updates.push_back(
                    {{fixture.box.lowerBound + d, fixture.box.upperBound + d}, vec2Zero, fixture.fixture});
            }
            broadPhase->UpdateMany(updates);
        };
        for (int step = 0; step < 4; ++step) {
            pose(step % 2 == 1);
            broadPhase->FindPairs(pairs);
        }
        for (int step = 0; step < 4; ++step) {
            pose(step % 2 == 1);
            const size_t before = allocations;
            broadPhase->FindPairs(pairs);
            EXPECT_EQ(allocations - before, 0u);
        }
        EXPECT_GT(pairs.size(), 100u);
    }
}

TEST_P(Edits, MemoryIsTold) {
    const auto broadPhase = CreateBroadPhase(GetParam());
    for (uint32_t i = 0; i < 1000; ++i) broadPhase->Insert(i, i, Motion::dynamic, CellBox(i));
    std::vector<Pair> pairs;
    broadPhase->FindPairs(pairs);
    // Box and identity of 1000 proxies at least; at most what any of the structures needs with room to grow.
    EXPECT_GE(broadPhase->GetMemoryBytes(), 1000u * 24u);
    EXPECT_LE(broadPhase->GetMemoryBytes(), 1000u * 400u);
}

}  // namespace
}  // namespace scree::test
