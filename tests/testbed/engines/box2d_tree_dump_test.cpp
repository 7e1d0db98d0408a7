// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The dump of Box2D's private tree reproduces what Box2D says of it: height, balance, quality, number of proxies, and
// for each proxy its fattened box.

#include "testbed/engines/box2d_tree_dump.h"

#include <box2d/box2d.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "testbed/jobs/overlap/tree_quality.h"

using namespace testbed;

namespace {

int IndexOf(void* userData) { return static_cast<int>(reinterpret_cast<uintptr_t>(userData)); }

struct NullSink {
    void AddPair(void*, void*) {}
};

/// Fixtures for MeasureTree, which asks for tight boxes; the figures compared here do not depend on them.
std::vector<FixtureState> DummyFixtures(size_t count) { return std::vector<FixtureState>(count); }

void ExpectAgrees(const b2BroadPhase& broadPhase, const std::vector<NodeState>& nodes) {
    const TreeQuality quality = MeasureTree(nodes, DummyFixtures(static_cast<size_t>(broadPhase.GetProxyCount())));
    EXPECT_EQ(quality.height, broadPhase.GetTreeHeight());
    EXPECT_EQ(quality.maxBalance, broadPhase.GetTreeBalance());
    // Box2D sums in single precision.
    EXPECT_NEAR(quality.areaRatio, broadPhase.GetTreeQuality(), 1e-5 * quality.areaRatio);
    int leaves = 0;
    for (const NodeState& n : nodes) leaves += n.fixture >= 0;
    EXPECT_EQ(leaves, broadPhase.GetProxyCount());
}

void ExpectWellFormed(const std::vector<NodeState>& nodes) {
    for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
        const NodeState& n = nodes[static_cast<size_t>(i)];
        EXPECT_EQ(n.parent < 0, i == 0);
        EXPECT_LT(n.parent, i);
        EXPECT_EQ(n.child1 < 0, n.child2 < 0);
        EXPECT_EQ(n.child1 < 0, n.fixture >= 0);
        if (n.parent < 0) continue;
        const NodeState& parent = nodes[static_cast<size_t>(n.parent)];
        EXPECT_TRUE(parent.child1 == i || parent.child2 == i);
        EXPECT_EQ(n.level, parent.level + 1);
        EXPECT_LE(parent.box.lower.x, n.box.lower.x);
        EXPECT_LE(parent.box.lower.y, n.box.lower.y);
        EXPECT_GE(parent.box.upper.x, n.box.upper.x);
        EXPECT_GE(parent.box.upper.y, n.box.upper.y);
    }
}

}  // namespace

TEST(Box2dTreeDump, EmptyTreeHasNoNodes) {
    const b2BroadPhase broadPhase;
    std::vector<NodeState> nodes(3);
    DumpBox2dTree(broadPhase, IndexOf, nodes);
    EXPECT_TRUE(nodes.empty());
}

TEST(Box2dTreeDump, AgreesWithBox2dAfterRandomMoves) {
    EXPECT_TRUE(rc::check("height, balance, quality, count, fat boxes", [] {
        b2BroadPhase broadPhase;
        std::vector<int32> ids;
        std::vector<b2Vec2> at;
        const auto count = *rc::gen::inRange<size_t>(1, 200);
        const auto coordinate = [] { return 0.1f * static_cast<float>(*rc::gen::inRange(-500, 500)); };
        for (size_t i = 0; i < count; ++i) {
            at.push_back({coordinate(), coordinate()});
            const b2AABB box{at[i], at[i] + b2Vec2(1, 1)};
            ids.push_back(broadPhase.CreateProxy(box, reinterpret_cast<void*>(i)));
        }
        NullSink sink;
        broadPhase.UpdatePairs(&sink);
        for (size_t i = 0; i < count; i += 2) {
            const b2Vec2 to(coordinate(), coordinate());
            const b2AABB box{to, to + b2Vec2(1, 1)};
            broadPhase.MoveProxy(ids[i], box, to - at[i]);
        }
        std::vector<NodeState> nodes;
        DumpBox2dTree(broadPhase, IndexOf, nodes);
        RC_ASSERT(nodes.size() == 2 * count - 1);
        for (const NodeState& n : nodes) {
            if (n.fixture < 0) continue;
            const b2AABB& fat = broadPhase.GetFatAABB(ids[static_cast<size_t>(n.fixture)]);
            RC_ASSERT(n.box.lower.x == fat.lowerBound.x && n.box.upper.y == fat.upperBound.y);
        }
        ExpectWellFormed(nodes);
        ExpectAgrees(broadPhase, nodes);
        RC_ASSERT(!::testing::Test::HasFailure());
    }));
}

TEST(Box2dTreeDump, AgreesWithARunningWorld) {
    b2World world({0.0f, -10.0f});
    b2CircleShape circle;
    circle.m_radius = 0.3f;
    for (uintptr_t i = 0; i < 300; ++i) {
        b2BodyDef def;
        def.type = i % 10 == 0 ? b2_staticBody : b2_dynamicBody;
        def.position.Set(static_cast<float>(i % 20), static_cast<float>(i / 20) * 0.7f);
        def.linearVelocity.Set(static_cast<float>(i % 7) * 3.0f, 0.0f);
        world.CreateBody(&def)->CreateFixture(&circle, 1.0f)->GetUserData().pointer = i;
    }
    const auto fixtureOf = [](void* proxy) {
        return static_cast<int>(static_cast<b2FixtureProxy*>(proxy)->fixture->GetUserData().pointer);
    };
    std::vector<NodeState> nodes;
    for (int step = 0; step < 30; ++step) {
        world.Step(1.0f / 60.0f, 8, 3);
        DumpBox2dTree(world.GetContactManager().m_broadPhase, fixtureOf, nodes);
        ExpectAgrees(world.GetContactManager().m_broadPhase, nodes);
    }
    ExpectWellFormed(nodes);
    std::vector<bool> seen(300, false);
    for (const NodeState& n : nodes) {
        if (n.fixture >= 0) seen[static_cast<size_t>(n.fixture)] = true;
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), true), 300);
}
