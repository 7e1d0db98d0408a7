// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Scenes in Box2D through the adapter: every scene loads with the right counts and runs; spawns come when due;
// contacts, pairs, options and captures say what Box2D says.

#include <gtest/gtest.h>

#include "testbed/engines/pair_count.h"
#include "tests/testbed/engines/run_checks.h"
#include "tests/testbed/engines/scene_builder.h"

using namespace testbed;

namespace {

std::unique_ptr<EngineRun> Make(const scenes::Scene& scene) {
    return MakeRun(scene, MakeSpec("box2d", likeBox2dPreset));
}

}  // namespace

TEST(Box2dRun, EverySceneOfTheCatalogueLoadsAndRuns) { checks::ExpectEverySceneRuns(Make, 6); }

TEST(Box2dRun, SpawnsEnterAfterTheirStep) {
    const scenes::Scene scene = scenes::Build("tumbler", 50);
    ASSERT_FALSE(scene.spawns.empty());
    const auto run = Make(scene);
    Snapshot snapshot;
    for (int step = 1; step <= 20; ++step) {
        run->Step();
        run->Capture(snapshot, {.contacts = false, .joints = false, .nodes = false});
        EXPECT_EQ(static_cast<int>(snapshot.bodies.size()), checks::BodiesAfter(scene, step));
        // The newcomer has not moved yet.
        const size_t last = snapshot.bodies.size() - 1;
        EXPECT_EQ(snapshot.bodies[last].position, scene.bodies[last].position);
    }
}

TEST(Box2dRun, RestingBoxCarriesItsWeight) {
    const auto run = Make(checks::RestingBox());
    for (int i = 0; i < 60; ++i) run->Step();
    Snapshot s;
    run->Capture(s);
    ASSERT_EQ(s.contacts.size(), 1u);
    const ContactState& c = s.contacts[0];
    ASSERT_TRUE(c.touching);
    ASSERT_EQ(c.pointCount, 2);
    // 1 kg at 10 m/s² over 1/60 s; the solver's residue is far below 1 %.
    EXPECT_NEAR(c.normalImpulses[0] + c.normalImpulses[1], 10.0f / 60.0f, 0.01f * 10.0f / 60.0f);
    const bool groundFirst = c.fixtureA == 0;
    EXPECT_NEAR(c.normal.y, groundFirst ? 1.0f : -1.0f, 1e-6f);
    EXPECT_NEAR(c.points[0].y, 1.0f, 0.02f);
}

TEST(Box2dRun, ReportedPairsAreASupersetOfTheTrueOnes) {
    const auto run = Make(scenes::Build("add-pair-400"));
    Snapshot s;
    int64_t excess = 0;
    for (int i = 0; i < 30; ++i) {
        run->Step();
        run->Capture(s);
        const int64_t truePairs = CountPairs(TightBoxes(s));
        EXPECT_GE(s.pairsReported, truePairs);
        excess += s.pairsReported - truePairs;
    }
    EXPECT_GT(excess, 0) << "fattened boxes must report more than tight ones in a moving scene";
}

TEST(Box2dRun, ContinuousCollisionFollowsTheOption) {
    const scenes::Scene scene = checks::BulletAndWall();
    for (const bool continuous : {false, true}) {
        RunSpec spec = MakeSpec("box2d");
        spec.continuous = continuous;
        const auto run = MakeRun(scene, spec);
        for (int i = 0; i < 20; ++i) run->Step();
        Snapshot s;
        run->Capture(s);
        EXPECT_EQ(s.bodies[1].position.x < 0.0f, continuous);
    }
}

TEST(Box2dRun, TwoRunsOfASceneAreEqual) {
    const scenes::Scene scene = scenes::Build("falling-squares", 10);
    const auto a = Make(scene), b = Make(scene);
    Snapshot sa, sb;
    for (int i = 0; i < 40; ++i) {
        a->Step();
        b->Step();
    }
    a->Capture(sa);
    b->Capture(sb);
    EXPECT_EQ(sa.stateHash, sb.stateHash);
    EXPECT_NE(sa.stateHash, 0u);
}

// A sanitizer brings its own allocator, of which the C library counts nothing.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(Box2dRun, MemoryGrowsWithTheScene) {
    Snapshot small, large;
    Make(scenes::Build("n2", 25))->Capture(small);
    Make(scenes::Build("n2", 500))->Capture(large);
    // A body with a circle is at least 300 B in Box2D.
    EXPECT_GT(large.memoryBytes, small.memoryBytes + 475 * 300);
}
#endif

TEST(Box2dRun, PartsLeftOutAreEmpty) {
    const auto run = Make(scenes::Build("tiles", 20));
    run->Step();
    Snapshot full, bare;
    run->Capture(full);
    run->Capture(bare);  // the next capture must clear these
    run->Capture(bare, {.fixtures = false, .contacts = false, .joints = false, .nodes = false});
    EXPECT_TRUE(bare.fixtures.empty() && bare.contacts.empty() && bare.joints.empty() && bare.nodes.empty());
    EXPECT_EQ(bare.bodies.size(), full.bodies.size());
    EXPECT_EQ(bare.stateHash, full.stateHash);
    EXPECT_EQ(bare.contactCount, full.contactCount);
}
