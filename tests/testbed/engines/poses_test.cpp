// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A stand-alone b2BroadPhase that follows a Box2D world's own poses has that world's tree: same height, same nodes.

#include "testbed/engines/poses.h"

#include <gtest/gtest.h>

#include "tests/testbed/engines/run_checks.h"
#include "tests/testbed/engines/scene_builder.h"

using namespace testbed;

namespace {

void ExpectSameTree(const Snapshot& world, const Snapshot& follower, float tolerance) {
    EXPECT_EQ(world.treeHeight, follower.treeHeight);
    EXPECT_EQ(world.pairsReported, follower.pairsReported);
    ASSERT_EQ(world.nodes.size(), follower.nodes.size());
    for (size_t i = 0; i < world.nodes.size(); ++i) {
        const NodeState &a = world.nodes[i], &b = follower.nodes[i];
        ASSERT_EQ(a.fixture, b.fixture) << "node " << i;
        ASSERT_EQ(a.parent, b.parent) << "node " << i;
        ASSERT_NEAR(a.box.lower.x, b.box.lower.x, tolerance) << "node " << i;
        ASSERT_NEAR(a.box.lower.y, b.box.lower.y, tolerance) << "node " << i;
        ASSERT_NEAR(a.box.upper.x, b.box.upper.x, tolerance) << "node " << i;
        ASSERT_NEAR(a.box.upper.y, b.box.upper.y, tolerance) << "node " << i;
    }
}

/// Runs the scene and a follower of an equal run side by side, comparing the trees every `every` steps.
void ExpectFollows(const scenes::Scene& scene, int steps, int every) {
    SCOPED_TRACE(scene.name);
    const auto world = MakeRun(scene, MakeSpec("box2d", likeBox2dPreset));
    const auto follower =
        MakeBox2dFollower(scene, MakeSpec("box2d"), MakeRun(scene, MakeSpec("box2d", likeBox2dPreset)));
    Snapshot a, b;
    for (int step = 0; step <= steps; ++step) {
        if (step % every == 0) {
            world->Capture(a);
            follower->Capture(b);
            ASSERT_EQ(a.stateHash, b.stateHash);
            ASSERT_NO_FATAL_FAILURE(ExpectSameTree(a, b, 0.0f)) << "step " << step;
        }
        world->Step();
        follower->Step();
    }
}

}  // namespace

TEST(Poses, Box2dFollowerHasTheWorldsTree) {
    ExpectFollows(scenes::Build("slow-explosion", 300), 120, 10);
    ExpectFollows(scenes::Build("add-pair", 100), 60, 4);
    ExpectFollows(scenes::Build("tumbler", 50), 120, 10);
    ExpectFollows(scenes::Build("mostly-static-multi", 20), 100, 10);
    ExpectFollows(scenes::Build("big-mobile", 5), 100, 10);
    ExpectFollows(scenes::Build("mild-n2", 10), 60, 10);
    ExpectFollows(scenes::Build("car"), 120, 10);
    ExpectFollows(scenes::Build("ray-cast-playground"), 60, 10);
}

TEST(Poses, Box2dFollowerHasTheWorldsTreeWhileBodiesFallAsleep) {
    // Damped bodies that come to rest 0.1 m from their start, the margin of their fattened boxes. Their start speeds
    // are graded finely, so that some leave their box in the very step in which they fall asleep.
    scenes::Scene scene;
    scene.name = "damped";
    scene.gravity = {0.0f, 0.0f};
    for (int i = 0; i < 600; ++i) {
        scenes::Body body = checks::MakeDynamic(static_cast<float>(i % 30) * 3.0f, static_cast<float>(i / 30) * 3.0f);
        body.linearVelocity = {0.1f + 2.5e-5f * static_cast<float>(i), 0.0f};
        body.linearDamping = 1.0f;
        checks::AddBody(scene, body, checks::MakeCircleShape(0.5f), 1.0f);
    }
    ExpectFollows(scene, 200, 1);
    const auto run = MakeRun(scene, MakeSpec("box2d", likeBox2dPreset));
    for (int i = 0; i < 200; ++i) run->Step();
    Snapshot s;
    run->Capture(s);
    for (const BodyState& b : s.bodies) ASSERT_FALSE(b.awake) << "the scene does not exercise what this test is about";
}

TEST(Poses, Box2dFollowerHasTheWorldsTreeOfASettlingPile) {
    ExpectFollows(scenes::Build("falling-squares", 20), 600, 25);
}

TEST(Poses, FollowerShowsItsSourcesBodiesAndContacts) {
    const scenes::Scene scene = scenes::Build("tiles", 20);
    const auto source = MakeRun(scene, MakeSpec("box2d", likeBox2dPreset));
    const auto follower =
        MakeBox2dFollower(scene, MakeSpec("box2d"), MakeRun(scene, MakeSpec("box2d", likeBox2dPreset)));
    for (int i = 0; i < 10; ++i) {
        source->Step();
        follower->Step();
    }
    Snapshot a, b;
    source->Capture(a);
    follower->Capture(b);
    EXPECT_EQ(b.engine, "box2d");
    EXPECT_EQ(a.stateHash, b.stateHash);
    EXPECT_EQ(a.contacts.size(), b.contacts.size());
    checks::ExpectMatchesScene(b, scene);
    checks::ExpectTreeHoldsFixtures(b);
    EXPECT_EQ(b.times.narrowPhase, 0.0);
}
