// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Laws of the inspection tree. Children are behind their parents, and parents contain children and are their exact
// union. Every fixture is in exactly one leaf with its stored box, there are n − 1 inner nodes, and levels count from
// the root. The static tree is apart above the threshold and not below. Algorithms without a tree have no nodes.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <set>

#include "tests/broad_phase/test_world.h"

namespace scree::test {
namespace {

class Nodes : public testing::TestWithParam<BroadPhaseKind> {};

INSTANTIATE_TEST_SUITE_P(BroadPhase, Nodes, testing::ValuesIn(allKinds), KindName);

bool KeepsTree(BroadPhaseKind kind) {
    return kind != BroadPhaseKind::bruteForce && kind != BroadPhaseKind::sweepAndPrune;
}

void CheckNodes(const TestWorld& world, BroadPhase& broadPhase) {
    std::vector<BvhNode> nodes;
    broadPhase.GetNodes(nodes);
    const size_t count = world.Fixtures().size();
    RC_ASSERT(nodes.size() == (count == 0 ? 0 : 2 * count - 1));
    std::multiset<int32_t> leaves, expected;
    for (const TestFixture& fixture : world.Fixtures()) expected.insert(static_cast<int32_t>(fixture.fixture));
    for (size_t i = 0; i < nodes.size(); ++i) {
        const BvhNode& node = nodes[i];
        if (i == 0) {
            RC_ASSERT(node.parent == -1);
            RC_ASSERT(node.level == 0);
        } else {
            RC_ASSERT(node.parent >= 0);
            RC_ASSERT(node.parent < static_cast<int32_t>(i));
            const BvhNode& parent = nodes[static_cast<size_t>(node.parent)];
            RC_ASSERT(node.level == parent.level + 1);
            RC_ASSERT(parent.child1 == static_cast<int32_t>(i) || parent.child2 == static_cast<int32_t>(i));
        }
        if (node.child1 < 0) {
            RC_ASSERT(node.child2 == -1);
            RC_ASSERT(node.fixture >= 0);
            leaves.insert(node.fixture);
            const AABB box = broadPhase.GetBox(static_cast<uint32_t>(node.fixture));
            RC_ASSERT(box.lowerBound == node.box.lowerBound && box.upperBound == node.box.upperBound);
        } else {
            RC_ASSERT(node.fixture == -1);
            const AABB united =
                Union(nodes[static_cast<size_t>(node.child1)].box, nodes[static_cast<size_t>(node.child2)].box);
            RC_ASSERT(united.lowerBound == node.box.lowerBound && united.upperBound == node.box.upperBound);
        }
    }
    RC_ASSERT(leaves == expected);
}

TEST_P(Nodes, InvariantsBeforeAndAfterEdits) {
    EXPECT_TRUE(rc::check("node invariants", [] {
        const WorldShape shape = AnyWorldShape(120);
        BroadPhaseConfig config;
        config.leafSize = *rc::gen::element(0, 0, 1, 4, 100);
        TestWorld world(shape);
        const auto broadPhase = CreateBroadPhase(GetParam(), config);
        world.Fill(*broadPhase);
        std::vector<Pair> pairs;
        std::vector<BvhNode> nodes;
        for (int round = 0; round < 4; ++round) {
            if (*rc::gen::arbitrary<bool>()) broadPhase->FindPairs(pairs);
            if (KeepsTree(GetParam())) {
                CheckNodes(world, *broadPhase);
            } else {
                broadPhase->GetNodes(nodes);
                RC_ASSERT(nodes.empty());
            }
            world.Edit(*broadPhase, *rc::gen::element(1, 10, 100));
            world.Rest(*broadPhase, *rc::gen::element(0, 10));
        }
    }));
}

TEST_P(Nodes, LeafSizeIsTold) {
    BroadPhaseConfig config;
    EXPECT_EQ(CreateBroadPhase(GetParam())->GetLeafSize() > 0, KeepsTree(GetParam()));
    config.leafSize = 7;
    const int leafSize = CreateBroadPhase(GetParam(), config)->GetLeafSize();
    if (KeepsTree(GetParam()) && GetParam() != BroadPhaseKind::fatTree) {
        EXPECT_EQ(leafSize, 7);
    }
}

class StaticTree : public testing::TestWithParam<BroadPhaseKind> {};

INSTANTIATE_TEST_SUITE_P(BroadPhase, StaticTree, testing::ValuesIn(rebuiltTreeKinds), KindName);

/// 800 movers in rows and `statics` boxes to their right.
std::unique_ptr<BroadPhase> MakeWithStatics(BroadPhaseKind kind, uint32_t statics) {
    auto broadPhase = CreateBroadPhase(kind);
    for (uint32_t i = 0; i < 800 + statics; ++i) {
        const Vec2 p{static_cast<float>(i % 40), 2.0f * static_cast<float>(i / 40)};
        broadPhase->Insert(i, i, i < 800 ? Motion::dynamic : Motion::isStatic, {p, p + Vec2{0.9f, 0.9f}});
    }
    return broadPhase;
}

TEST_P(StaticTree, IsApartAboveTheThresholdOnly) {
    std::vector<Pair> pairs;
    std::vector<BvhNode> nodes;
    // An eighth of all: 800 movers and 114 statics are just below, 115 just above.
    for (const uint32_t statics : {114u, 115u}) {
        const auto broadPhase = MakeWithStatics(GetParam(), statics);
        broadPhase->FindPairs(pairs);
        EXPECT_EQ(broadPhase->GetStats().staticTreeSeparate, statics == 115);
        broadPhase->GetNodes(nodes);
        // Under a virtual root the statics are exactly one of its subtrees.
        size_t staticsBelow = 0, fixturesBelow = 0;
        const int32_t part = nodes[0].child2;
        for (size_t i = 0; i < nodes.size(); ++i) {
            if (nodes[i].fixture < 0) continue;
            auto at = static_cast<int32_t>(i);
            while (at > 0 && at != part) at = nodes[static_cast<size_t>(at)].parent;
            if (at != part) continue;
            ++fixturesBelow;
            staticsBelow += nodes[i].fixture >= 800 ? 1 : 0;
        }
        EXPECT_EQ(staticsBelow == statics && fixturesBelow == statics, statics == 115);
    }
}

/// `keys` takes what is edited beside the tree, the others build it anew.
TEST_P(StaticTree, IsKeptUntilStaticsAreEdited) {
    const auto broadPhase = MakeWithStatics(GetParam(), 4000);
    std::vector<Pair> pairs;
    broadPhase->FindPairs(pairs);
    EXPECT_EQ(broadPhase->GetStats().rebuiltProxies, 4800u);
    for (uint32_t i = 0; i < 800; ++i) broadPhase->Update(i, {{1.0f, 1.0f}, {2.0f, 2.0f}}, vec2Zero);
    broadPhase->FindPairs(pairs);
    EXPECT_EQ(broadPhase->GetStats().rebuiltProxies, 800u);
    broadPhase->Update(900, {{1.0f, 1.0f}, {2.0f, 2.0f}}, vec2Zero);
    broadPhase->FindPairs(pairs);
    EXPECT_EQ(broadPhase->GetStats().rebuiltProxies, GetParam() == BroadPhaseKind::keys ? 800u : 4800u);
    EXPECT_EQ(pairs.size(), 800u * 799u / 2u + 800u);
}

/// Statics all on one spot would make half a million tests if they met each other.
TEST_P(StaticTree, StaticsAreNeverTestedAgainstEachOther) {
    const auto broadPhase = CreateBroadPhase(GetParam());
    for (uint32_t i = 0; i < 1000; ++i) broadPhase->Insert(i, 1, Motion::isStatic, {{0.0f, 0.0f}, {1.0f, 1.0f}});
    for (uint32_t i = 1000; i < 1010; ++i) broadPhase->Insert(i, i, Motion::dynamic, {{9.0f, 9.0f}, {9.5f, 9.5f}});
    std::vector<Pair> pairs;
    broadPhase->FindPairs(pairs);
    EXPECT_EQ(pairs.size(), 45u);
    EXPECT_LE(broadPhase->GetStats().boxTests, 500u);
}

}  // namespace
}  // namespace scree::test
