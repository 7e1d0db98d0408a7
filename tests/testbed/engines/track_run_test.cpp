// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A recorded motion in which bodies come and go, and trees that follow it: they hold what is there, and nothing else.

#include "testbed/engines/track_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <set>
#include <stdexcept>
#include <vector>

#include "scenes/outline.h"
#include "scree/world.h"
#include "testbed/capture/scree_capture.h"
#include "testbed/engines/capture_scree.h"
#include "testbed/engines/engine_list.h"
#include "testbed/engines/pair_count.h"
#include "tests/testbed/engines/run_checks.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

/// A world that makes and destroys bodies of one to three fixtures at random, recorded; its states, by step.
class Churn {
public:
    Churn(unsigned seed, int stepCount, bool isConvex = false)
        : m_isConvex(isConvex), m_random(seed), m_world(scree::Vec2{0.0f, -10.0f}) {
        MakeGround();
        for (int i = 0; i < 10; ++i) MakeBody();
        const std::string path = m_folder.GetPath() / "churn.track";
        scree_capture::Options options;
        options.contacts = true;
        options.tree = true;
        scree_capture::Track recorder(m_world, path, options);
        for (int step = 1; step <= stepCount; ++step) {
            if (Chance(0.2)) MakeBody();
            if (Chance(0.15) && m_bodies.size() > 2) DestroyBody();
            m_world.Step(1.0f / 60.0f, 8, 3);
            recorder.Step(1.0f / 60.0f);
            Capture(m_world, snapshots.emplace_back());
        }
        recorder.Close();
        track = std::make_shared<TrackFile>(ReadTrackFile(path));
    }

    std::vector<Snapshot> snapshots;  ///< after step 1, 2 …
    std::shared_ptr<TrackFile> track;

private:
    bool Chance(double share) { return std::bernoulli_distribution(share)(m_random); }
    float Between(float low, float high) { return std::uniform_real_distribution<float>(low, high)(m_random); }
    void MakeGround() {
        const scree::BodyDef def;
        scree::ChainShape chain;
        const scree::Vec2 vertices[] = {{10.0f, 1.0f}, {3.0f, 0.0f}, {-3.0f, 0.0f}, {-10.0f, 1.0f}};
        EXPECT_TRUE(chain.CreateChain(vertices, 4, {11.0f, 1.0f}, {-11.0f, 1.0f}));
        m_world.CreateBody(&def)->CreateFixture(&chain, 0.0f);
    }
    void MakeBody() {
        scree::BodyDef def;
        def.type = Chance(0.1) ? scree::kinematicBody : scree::dynamicBody;
        def.position = {Between(-6.0f, 6.0f), Between(2.0f, 9.0f)};
        def.angle = Between(-3.0f, 3.0f);
        scree::Body* body = m_world.CreateBody(&def);
        for (int i = 0, count = 1 + static_cast<int>(m_random() % 3); i < count; ++i) {
            const scree::Vec2 center{Between(-0.5f, 0.5f), 0.0f};
            scree::PolygonShape box;
            box.SetAsBox(Between(0.1f, 0.6f), Between(0.1f, 0.6f), center, Between(0.0f, 1.0f));
            if (m_isConvex && Chance(0.3)) {
                const scree::Vec2 other{center.x + Between(0.1f, 0.5f), 0.1f};
                const scree::ConvexShape capsule = scree::MakeCapsule(center, other, Between(0.1f, 0.4f));
                body->CreateFixture(&capsule, 1.0f);
            } else if (m_isConvex && Chance(0.3)) {
                const scree::ConvexShape rounded =
                    scree::MakeRoundedPolygon(box.m_vertices, box.m_count, Between(0.05f, 0.2f));
                body->CreateFixture(&rounded, 1.0f);
            } else {
                body->CreateFixture(&box, 1.0f);
            }
        }
        m_bodies.push_back(body);
    }
    void DestroyBody() {
        const std::size_t chosen = m_random() % m_bodies.size();
        m_world.DestroyBody(m_bodies[chosen]);
        m_bodies.erase(m_bodies.begin() + static_cast<std::ptrdiff_t>(chosen));
    }

    bool m_isConvex;  ///< with shapes that Box2D does not know
    std::mt19937 m_random;
    ScratchFolder m_folder;
    scree::World m_world;
    std::vector<scree::Body*> m_bodies;
};

/// Poses in a fixed order: indices of a track are not the world's.
std::multiset<std::vector<float>> PosesOf(const Snapshot& snapshot) {
    std::multiset<std::vector<float>> poses;
    for (const BodyState& b : snapshot.bodies) {
        poses.insert({b.position.x, b.position.y, b.sin, b.cos, b.linearVelocity.x, b.linearVelocity.y,
                      b.angularVelocity, b.awake ? 1.0f : 0.0f});
    }
    return poses;
}

std::multiset<std::vector<float>> BoxesOf(const Snapshot& snapshot) {
    std::multiset<std::vector<float>> boxes;
    for (const FixtureState& f : snapshot.fixtures) {
        boxes.insert({f.tight.lower.x, f.tight.lower.y, f.tight.upper.x, f.tight.upper.y});
    }
    return boxes;
}

TEST(TrackRun, ShowsWhatTheRecordedWorldShowed) {
    for (const unsigned seed : {1u, 2u, 3u}) {
        const Churn churn(seed, 150);
        const auto run = MakeTrackRun(churn.track, 0);
        for (const Snapshot& world : churn.snapshots) {
            run->Step();
            Snapshot shown;
            run->Capture(shown);
            ASSERT_EQ(PosesOf(shown), PosesOf(world)) << "seed " << seed << " step " << run->GetStep();
            ASSERT_EQ(BoxesOf(shown), BoxesOf(world)) << "seed " << seed << " step " << run->GetStep();
            ASSERT_EQ(shown.touchingCount, world.touchingCount);
            ASSERT_EQ(shown.contacts.size(), static_cast<std::size_t>(world.touchingCount));
            for (const ContactState& c : shown.contacts) {
                ASSERT_TRUE(c.fixtureA >= 0 && c.fixtureA < std::ssize(shown.fixtures));
                ASSERT_TRUE(c.fixtureB >= 0 && c.fixtureB < std::ssize(shown.fixtures));
            }
        }
        EXPECT_THROW(run->Step(), std::out_of_range);
    }
}

/// The box of an outline in the world.
Box BoxOfOutline(const FixtureState& fixture, const BodyState& body) {
    Box box{{1e9f, 1e9f}, {-1e9f, -1e9f}};
    for (const Vec2 p : fixture.outline) {
        const Vec2 at{body.cos * p.x - body.sin * p.y + body.position.x,
                      body.sin * p.x + body.cos * p.y + body.position.y};
        box.lower = {std::min(box.lower.x, at.x), std::min(box.lower.y, at.y)};
        box.upper = {std::max(box.upper.x, at.x), std::max(box.upper.y, at.y)};
    }
    return box;
}

/// Pictures and searches for tunnelling know these shapes by their outlines alone.
TEST(TrackRun, FurtherConvexShapesHaveOutlines) {
    const Churn churn(8, 60, true);
    const auto run = MakeTrackRun(churn.track, 0);
    int outlines = 0;
    for (int step = 1; step <= 60; ++step) {
        run->Step();
        Snapshot shown;
        run->Capture(shown);
        for (const FixtureState& f : shown.fixtures) {
            ASSERT_EQ(f.outline.empty(), !scenes::IsFurtherConvex(f.shape.type));
            if (f.outline.empty()) continue;
            ++outlines;
            const Box box = BoxOfOutline(f, shown.bodies[static_cast<std::size_t>(f.body)]);
            constexpr float close = 0.011f;  // a skin, and what chords leave out
            ASSERT_NEAR(box.lower.x, f.tight.lower.x, close);
            ASSERT_NEAR(box.lower.y, f.tight.lower.y, close);
            ASSERT_NEAR(box.upper.x, f.tight.upper.x, close);
            ASSERT_NEAR(box.upper.y, f.tight.upper.y, close);
        }
    }
    EXPECT_GT(outlines, 100);
}

/// Boxes and levels of all nodes from the root on, and of leaves the box of what they hold.
std::vector<std::vector<float>> TreeOf(const Snapshot& snapshot) {
    std::vector<std::vector<float>> tree;
    std::vector<int> pending(snapshot.nodes.empty() ? 0 : 1, 0);
    while (!pending.empty()) {
        const NodeState& node = snapshot.nodes[static_cast<std::size_t>(pending.back())];
        pending.pop_back();
        tree.push_back(
            {node.box.lower.x, node.box.lower.y, node.box.upper.x, node.box.upper.y, static_cast<float>(node.level)});
        if (node.fixture < 0) {
            pending.insert(pending.end(), {node.child2, node.child1});
            continue;
        }
        const Box& tight = snapshot.fixtures[static_cast<std::size_t>(node.fixture)].tight;
        tree.back().insert(tree.back().end(), {tight.lower.x, tight.lower.y, tight.upper.x, tight.upper.y});
    }
    return tree;
}

TEST(TrackRun, TheRecordedTreeIsThatOfTheWorld) {
    for (const unsigned seed : {5u, 6u, 7u}) {
        const Churn churn(seed, 150);
        RunStart start(churn.track->GetParts());
        start.motion = churn.track;
        const auto run = MakeFollower(start, MakeSpec(recordedEngine));
        for (const Snapshot& world : churn.snapshots) {
            run->Step();
            Snapshot shown;
            run->Capture(shown);
            ASSERT_FALSE(shown.nodes.empty());
            ASSERT_EQ(TreeOf(shown), TreeOf(world)) << "seed " << seed << " step " << run->GetStep();
            ASSERT_EQ(shown.nodes.size(), world.nodes.size());
            ASSERT_EQ(shown.treeHeight, world.treeHeight);
            ASSERT_EQ(shown.pairsReported, CountPairs(LeafBoxes(shown)));
            ASSERT_NO_FATAL_FAILURE(checks::ExpectTreeHoldsFixtures(shown)) << "seed " << seed;
        }
    }
}

TEST(TrackRun, TreesThatFollowHoldWhatIsThere) {
    const Churn churn(4, 200);
    for (const EngineInfo& engine : GetEngines()) {
        for (const int from : {0, 77}) {
            RunStart start(churn.track->GetParts());
            start.motion = churn.track;
            start.step = from;
            const auto follower = MakeFollower(start, MakeSpec(engine.name));
            EXPECT_EQ(follower->GetStep(), from);
            for (int step = from + 1; step <= 200; ++step) {
                follower->Step();
                Snapshot shown;
                follower->Capture(shown);
                ASSERT_EQ(shown.step, step);
                ASSERT_EQ(BoxesOf(shown), BoxesOf(churn.snapshots[static_cast<std::size_t>(step - 1)]));
                ASSERT_NO_FATAL_FAILURE(checks::ExpectTreeHoldsFixtures(shown)) << engine.name << " step " << step;
            }
        }
    }
}

}  // namespace
}  // namespace testbed
