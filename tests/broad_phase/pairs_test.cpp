// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Law: every algorithm reports exactly the pairs of the rule, each once, after any history of edits. The rule is:
// different bodies, at least one dynamic, closed boxes overlap. The fattened tree reports a superset that equals them
// after a tight test. The expected pairs come from a loop in the test that shares no code with the engine.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "tests/broad_phase/test_world.h"

namespace scree::test {
namespace {

class Pairs : public testing::TestWithParam<BroadPhaseKind> {};

INSTANTIATE_TEST_SUITE_P(BroadPhase, Pairs, testing::ValuesIn(allKinds), KindName);

/// Without brute force, which is quadratic by design.
class ManyPairs : public testing::TestWithParam<BroadPhaseKind> {};

INSTANTIATE_TEST_SUITE_P(BroadPhase, ManyPairs, testing::ValuesIn(std::span(allKinds).subspan<1>()), KindName);

void CheckPairs(const TestWorld& world, const std::vector<Pair>& pairs, bool fattened) {
    RC_ASSERT(!HasDuplicates(pairs));
    for (const Pair pair : pairs) RC_ASSERT(pair.a < pair.b);
    const std::vector<Pair> tight = world.TightOnly(pairs);
    RC_ASSERT(fattened || tight.size() == pairs.size());
    RC_ASSERT(world.WithoutResting(tight) == world.WithoutResting(world.TruePairs()));
}

TEST_P(Pairs, EqualTheRuleAfterAnyHistory) {
    EXPECT_TRUE(rc::check("pairs equal the rule", [] {
        const WorldShape shape = AnyWorldShape(150);
        BroadPhaseConfig config;
        config.leafSize = *rc::gen::element(0, 0, 1, 3, 8, 50);
        config.staticShareThreshold = *rc::gen::element(0.125f, 0.0f, 1.0f);
        TestWorld world(shape);
        const auto broadPhase = CreateBroadPhase(GetParam(), config);
        world.Fill(*broadPhase);
        std::vector<Pair> pairs{{7, 9}};
        const int rounds = *rc::gen::inRange(1, 6);
        for (int round = 0; round < rounds; ++round) {
            broadPhase->FindPairs(pairs);
            CheckPairs(world, pairs, GetParam() == BroadPhaseKind::fatTree);
            world.Edit(*broadPhase, *rc::gen::inRange(0, 60));
            world.Rest(*broadPhase, *rc::gen::element(0, 0, 5, 200));
            if (round % 2 == 0) world.Drift(*broadPhase, 0.3f);
            if (round % 3 == 2) broadPhase->Query(world.RandomBox(), [](uint32_t) { return true; });
        }
    }));
}

TEST_P(Pairs, LargerWorldOverManySteps) {
    for (const Layout layout : {Layout::spread, Layout::clusters, Layout::outlier}) {
        WorldShape shape;
        shape.layout = layout;
        shape.count = 1500;
        shape.seed = 77;
        TestWorld world(shape);
        const auto broadPhase = CreateBroadPhase(GetParam());
        world.Fill(*broadPhase);
        std::vector<Pair> pairs;
        for (int step = 0; step < 4; ++step) {
            broadPhase->FindPairs(pairs);
            EXPECT_FALSE(HasDuplicates(pairs));
            EXPECT_EQ(world.TightOnly(pairs), world.TruePairs());
            world.Drift(*broadPhase, 0.5f);
            world.Edit(*broadPhase, 30);
        }
    }
}

// Without insertions and removals an algorithm may keep parts of what it built; with a jump it must not believe them.
TEST_P(Pairs, ManyStepsOfTheSameBoxes) {
    for (const Layout layout : {Layout::spread, Layout::clusters, Layout::grid, Layout::outlier}) {
        WorldShape shape;
        shape.layout = layout;
        shape.count = 600;
        shape.seed = 78;
        TestWorld world(shape);
        const auto broadPhase = CreateBroadPhase(GetParam());
        world.Fill(*broadPhase);
        std::vector<Pair> pairs;
        for (int step = 0; step < 24; ++step) {
            broadPhase->FindPairs(pairs);
            EXPECT_FALSE(HasDuplicates(pairs));
            EXPECT_EQ(world.TightOnly(pairs), world.TruePairs());
            world.Drift(*broadPhase, step == 10 ? 100.0f : 0.2f);
            if (step % 5 == 4) broadPhase->Query(world.RandomBox(), [](uint32_t) { return true; });
        }
    }
}

/// Some proxies are edited or come to rest in every step, most go on: trees are kept and followed for long.
TEST_P(Pairs, ManyStepsWithFewEdits) {
    for (const float staticShare : {0.02f, 0.3f}) {
        WorldShape shape;
        shape.staticShare = staticShare;
        shape.count = 900;
        shape.seed = 79;
        TestWorld world(shape);
        const auto broadPhase = CreateBroadPhase(GetParam());
        world.Fill(*broadPhase);
        std::vector<Pair> pairs;
        for (int step = 0; step < 60; ++step) {
            broadPhase->FindPairs(pairs);
            EXPECT_FALSE(HasDuplicates(pairs));
            EXPECT_EQ(world.WithoutResting(world.TightOnly(pairs)), world.WithoutResting(world.TruePairs()));
            world.Edit(*broadPhase, step % 7);
            if (step % 20 < 10) world.Rest(*broadPhase, step / 10 * 20);
            world.Drift(*broadPhase, 0.1f);
            if (step % 3 == 0) broadPhase->PrepareQueries();
        }
    }
}

TEST_P(Pairs, TouchCountsAsOverlap) {
    const auto broadPhase = CreateBroadPhase(GetParam());
    broadPhase->Insert(0, 0, Motion::dynamic, {{0.0f, 0.0f}, {1.0f, 1.0f}});
    broadPhase->Insert(1, 1, Motion::dynamic, {{1.0f, 1.0f}, {2.0f, 2.0f}});
    broadPhase->Insert(2, 2, Motion::isStatic, {{2.0f, 2.0f}, {2.0f, 2.0f}});
    broadPhase->Insert(3, 3, Motion::isStatic, {{-5.0f, 0.0f}, {-4.0f, 1.0f}});
    std::vector<Pair> pairs;
    broadPhase->FindPairs(pairs);
    std::sort(pairs.begin(), pairs.end());
    EXPECT_EQ(pairs, (std::vector<Pair>{{0, 1}, {1, 2}}));
}

TEST_P(Pairs, OrderFollowsFromTheCalls) {
    WorldShape shape;
    shape.count = 400;
    std::vector<std::vector<Pair>> reported[2];
    for (auto& run : reported) {
        TestWorld world(shape);
        const auto broadPhase = CreateBroadPhase(GetParam());
        world.Fill(*broadPhase);
        for (int step = 0; step < 5; ++step) {
            run.emplace_back();
            broadPhase->FindPairs(run.back());
            world.Edit(*broadPhase, 50);
            world.Drift(*broadPhase, 0.2f);
        }
    }
    EXPECT_EQ(reported[0], reported[1]);
}

TEST_P(Pairs, EmptyAndSmallWorlds) {
    const auto broadPhase = CreateBroadPhase(GetParam());
    std::vector<Pair> pairs{{1, 2}};
    std::vector<BvhNode> nodes;
    const AABB box{{0.0f, 0.0f}, {1.0f, 1.0f}};
    const auto fails = [](uint32_t) -> bool { throw std::logic_error("nothing to visit"); };
    for (int round = 0; round < 2; ++round) {
        broadPhase->FindPairs(pairs);
        EXPECT_TRUE(pairs.empty());
        broadPhase->Query(box, fails);
        broadPhase->GetNodes(nodes);
        EXPECT_TRUE(nodes.empty());
        EXPECT_EQ(broadPhase->GetProxyCount(), 0);
        broadPhase->Insert(5, 1, Motion::dynamic, box);
        broadPhase->FindPairs(pairs);
        EXPECT_TRUE(pairs.empty());
        EXPECT_EQ(broadPhase->GetProxyCount(), 1);
        broadPhase->Remove(5);
    }
}

TEST_P(Pairs, OnlyStaticsAndKinematicsNeverPair) {
    const auto broadPhase = CreateBroadPhase(GetParam());
    for (uint32_t i = 0; i < 100; ++i) {
        broadPhase->Insert(i, i, i % 3 == 0 ? Motion::kinematic : Motion::isStatic, {{0.0f, 0.0f}, {1.0f, 1.0f}});
    }
    std::vector<Pair> pairs;
    broadPhase->FindPairs(pairs);
    EXPECT_TRUE(pairs.empty());
}

/// Two thousand boxes on one spot: half a million is the number of pairs, so that many tests and a small factor are
/// due.
TEST_P(Pairs, IdenticalBoxesCostNoMoreThanTheirPairs) {
    constexpr uint32_t count = 2000;
    const auto broadPhase = CreateBroadPhase(GetParam());
    for (uint32_t i = 0; i < count; ++i) broadPhase->Insert(i, i, Motion::dynamic, {{2.0f, 2.0f}, {3.0f, 3.0f}});
    std::vector<Pair> pairs;
    broadPhase->FindPairs(pairs);
    const uint64_t due = static_cast<uint64_t>(count) * (count - 1) / 2;
    EXPECT_EQ(pairs.size(), due);
    EXPECT_FALSE(HasDuplicates(pairs));
    // The fattened tree and single queries meet every pair from both sides, trees add their inner nodes.
    EXPECT_LE(broadPhase->GetStats().boxTests, 5 * due);
}

/// One body that touches 1e5 others: the pairs are linear in the boxes, the tests must be nearly so.
TEST_P(ManyPairs, OnOneBody) {
    constexpr uint32_t count = 100'000;
    const auto broadPhase = CreateBroadPhase(GetParam());
    for (uint32_t i = 0; i < count; ++i) {
        const Vec2 p{static_cast<float>(i % 320), static_cast<float>(i / 320)};
        broadPhase->Insert(i, i, Motion::dynamic, {p, p + Vec2{0.5f, 0.5f}});
    }
    broadPhase->Insert(count, count, Motion::dynamic, {{-1.0f, -1.0f}, {400.0f, 400.0f}});
    std::vector<Pair> pairs;
    broadPhase->FindPairs(pairs);
    if (GetParam() != BroadPhaseKind::fatTree) {
        EXPECT_EQ(pairs.size(), count);
    }
    EXPECT_GE(pairs.size(), count);
    EXPECT_FALSE(HasDuplicates(pairs));
    // Sweep and prune tests every column of 313 boxes against itself and against the large box.
    EXPECT_LE(broadPhase->GetStats().boxTests, 400ull * count);
}

/// Centres that halve their distance again and again defeat a middle split; depth and cost must stay bounded.
TEST_P(Pairs, GeometricSeriesOfBoxes) {
    const auto broadPhase = CreateBroadPhase(GetParam());
    uint32_t fixture = 0;
    for (int exponent = -140; exponent < 120; ++exponent) {
        const float x = std::ldexp(1.0f, exponent);
        for (const float sign : {-1.0f, 1.0f}) {
            broadPhase->Insert(fixture, fixture, Motion::dynamic, {{sign * x, 0.0f}, {sign * x, 0.0f}});
            ++fixture;
        }
    }
    std::vector<Pair> pairs;
    broadPhase->FindPairs(pairs);
    if (GetParam() == BroadPhaseKind::fatTree) {
        EXPECT_GE(pairs.size(), 1u);
    } else {
        EXPECT_TRUE(pairs.empty());
    }
    // 64 levels of middle splits, then halves: 520 boxes need at most 10 more.
    std::vector<BvhNode> nodes;
    broadPhase->GetNodes(nodes);
    for (const BvhNode& node : nodes) EXPECT_LE(node.level, 74);
}

}  // namespace
}  // namespace scree::test
