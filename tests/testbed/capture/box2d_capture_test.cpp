// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Worlds of Box2D 2.4.1 recorded by scree_capture_box2d.h and read again. They have the same bits of every body after
// every step, the same scene, and what the testbed's own run of a scene shows, tree included.

#include "testbed/capture/scree_capture_box2d.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "testbed/engines/box2d_joint.h"
#include "testbed/engines/box2d_shape.h"
#include "testbed/engines/engine_run.h"
#include "tests/testbed/capture/track_test_world.h"

namespace testbed {
namespace {

struct Box2dTypes {
    using World = b2World;
    using Body = b2Body;
    using BodyDef = b2BodyDef;
    using BodyType = b2BodyType;
    using FixtureDef = b2FixtureDef;
    using Vec = b2Vec2;
    using Joint = b2Joint;
    static constexpr auto createJoint = &CreateBox2dJoint;
    static void CreateFixture(b2Body& body, b2FixtureDef& def, const scenes::Scene& scene, const scenes::Shape& shape) {
        if (shape.type == scenes::ShapeType::chain) {
            b2ChainShape chain;
            MakeBox2dChain(scene, shape, chain);
            def.shape = &chain;
            body.CreateFixture(&def);
        } else {
            const Box2dShape made = MakeBox2dShape(Box2dShapeOf(scene, shape));
            def.shape = &AsB2Shape(made);
            body.CreateFixture(&def);
        }
    }
};

TEST(Box2dCapture, EveryBuiltInSceneReadsBackToTheSameBits) {
    const double bytes = ExpectAllScenesReadBack<Box2dTypes, scree_capture::Track>("Box2D 2.4");
    RecordProperty("bytes a move", std::to_string(bytes));
}

TEST(Box2dCapture, AWrittenSceneIsTheSameWorld) {
    ExpectWrittenScenesAreTheSame<Box2dTypes>(
        [](b2World& world, const std::string& path) { return scree_capture::WriteScene(world, path); });
}

void ExpectSameBox(const Box& box, const TrackNode& node) {
    EXPECT_EQ(box.lower, node.lower);
    EXPECT_EQ(box.upper, node.upper);
}

/// Records a scene while the testbed runs it, too; returns the contacts seen.
int ExpectWhatTheTestbedShows(const scenes::Scene& scene) {
    const ScratchFolder folder;
    const std::string path = folder.GetPath() / "tiles.track";
    TestWorld<Box2dTypes> world(scene);
    world.GetWorld().SetContinuousPhysics(false);  // as the testbed compares
    const auto run = MakeRun(scene, MakeSpec("box2d", likeBox2dPreset));
    scree_capture::Options options;
    options.contacts = options.tree = true;
    std::vector<Snapshot> snapshots(91);
    {
        scree_capture::Track track(world.GetWorld(), path, options);
        for (int step = 1; step <= 90; ++step) {
            world.Step();
            track.Step(scene.timeStep);
            run->Step();
            run->Capture(snapshots[static_cast<std::size_t>(step)]);
        }
    }
    TrackFile track = ReadTrackFile(path);
    // The scene is that of the catalogue but for what no engine knows.
    const scenes::Scene start = track.SceneAt(0);
    EXPECT_TRUE(start.bodies == scene.bodies);
    EXPECT_TRUE(start.fixtures == scene.fixtures);
    EXPECT_EQ(start.gravity, scene.gravity);
    int touching = 0;
    for (int step = 1; step <= 90; ++step) {
        const TrackStep& read = track.Read(step);
        const Snapshot& shown = snapshots[static_cast<std::size_t>(step)];
        for (std::size_t i = 0; i < shown.bodies.size(); ++i) {
            const BodyState& body = shown.bodies[i];
            const TrackState state{true,       body.awake,          body.position,
                                   body.angle, body.linearVelocity, body.angularVelocity};
            EXPECT_TRUE(BitsOf(read.bodies[i]) == BitsOf(state)) << step << " body " << i;
        }
        EXPECT_EQ(read.contactCount, shown.contactCount) << step;
        EXPECT_EQ(static_cast<int>(read.contacts.size()), shown.touchingCount) << step;
        touching += shown.touchingCount;
        EXPECT_EQ(read.nodes.size(), shown.nodes.size()) << step;
        if (read.nodes.size() != shown.nodes.size()) return 0;
        for (std::size_t i = 0; i < shown.nodes.size(); ++i) {
            const NodeState& node = shown.nodes[i];
            ExpectSameBox(node.box, read.nodes[i]);
            EXPECT_EQ(node.parent, read.nodes[i].parent);
            EXPECT_EQ(node.child1, read.nodes[i].child1);
            EXPECT_EQ(node.child2, read.nodes[i].child2);
            if (node.fixture < 0) continue;
            const FixtureState& leaf = shown.fixtures[static_cast<std::size_t>(node.fixture)];
            EXPECT_EQ(leaf.body, read.nodes[i].leaf.body);
        }
    }
    return touching;
}

TEST(Box2dCapture, ScenesAreWhatTheTestbedsOwnRunShows) {
    (void)ExpectWhatTheTestbedShows(scenes::Build("tiles", 40));
    EXPECT_GT(ExpectWhatTheTestbedShows(scenes::Build("pyramid", 12)), 1000);
}

}  // namespace
}  // namespace testbed
