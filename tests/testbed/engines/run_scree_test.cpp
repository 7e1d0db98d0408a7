// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Scenes in our engine through the adapter, and the two engines against each other where the physics has one answer.
// That is free flight to float rounding, and a resting box to a millimetre.

#include <gtest/gtest.h>

#include <stdexcept>

#include "scree/broad_phase_kind.h"
#include "testbed/engines/pair_count.h"
#include "tests/testbed/engines/run_checks.h"
#include "tests/testbed/engines/scene_builder.h"

using namespace testbed;

namespace {

std::unique_ptr<EngineRun> Make(const scenes::Scene& scene) {
    return MakeRun(scene, MakeSpec("scree", likeBox2dPreset));
}

Snapshot CaptureAfter(EngineRun& run, int steps) {
    for (int i = 0; i < steps; ++i) run.Step();
    Snapshot snapshot;
    run.Capture(snapshot);
    return snapshot;
}

/// A difference of a few roundings of single precision.
void ExpectRounding(float a, float b) { EXPECT_NEAR(a, b, 5e-7f * (1.0f + std::abs(a))); }

}  // namespace

TEST(ScreeRun, EverySceneOfTheCatalogueLoadsAndRuns) { checks::ExpectEverySceneRuns(Make, 6); }

TEST(ScreeRun, SpawnsEnterAfterTheirStep) {
    const scenes::Scene scene = scenes::Build("tumbler", 50);
    const auto run = Make(scene);
    Snapshot snapshot;
    for (int step = 1; step <= 20; ++step) {
        run->Step();
        run->Capture(snapshot);
        checks::ExpectMatchesScene(snapshot, scene);
        checks::ExpectTreeHoldsFixtures(snapshot);
        const size_t last = snapshot.bodies.size() - 1;
        EXPECT_EQ(snapshot.bodies[last].position, scene.bodies[last].position);
    }
}

TEST(ScreeRun, EveryBroadPhaseRunsToTheSameTruePairs) {
    const scenes::Scene scene = scenes::Build("falling-squares", 20);
    std::vector<int64_t> truePairs;
    for (const std::string_view name : scree::broadPhaseNames) {
        SCOPED_TRACE(std::string(name));
        RunSpec spec = MakeSpec("scree", likeBox2dPreset);
        spec.broadPhase = name;
        const Snapshot s = CaptureAfter(*MakeRun(scene, spec), 30);
        if (name != "auto") {
            EXPECT_EQ(s.broadPhase, name);
        }
        checks::ExpectMatchesScene(s, scene);
        if (!s.nodes.empty()) checks::ExpectTreeHoldsFixtures(s);
        const int64_t tight = CountPairs(TightBoxes(s));
        if (name == "fat-tree") {
            EXPECT_GE(s.pairsReported, tight);
        } else {
            EXPECT_EQ(s.pairsReported, tight) << "a tight algorithm reports exactly the pairs of the tight boxes";
        }
        truePairs.push_back(tight);
    }
    // Contact order may differ between algorithms and with it the last bits of the motion, hardly the pairs.
    for (const int64_t pairs : truePairs)
        EXPECT_NEAR(static_cast<double>(pairs), static_cast<double>(truePairs[0]), 3.0);
}

TEST(ScreeRun, ContinuousCollisionFollowsTheOption) {
    const scenes::Scene scene = checks::BulletAndWall();
    for (const bool continuous : {false, true}) {
        RunSpec spec = MakeSpec("scree");
        spec.continuous = continuous;
        const auto run = MakeRun(scene, spec);
        for (int i = 0; i < 20; ++i) run->Step();
        Snapshot s;
        run->Capture(s);
        EXPECT_EQ(s.bodies[1].position.x < 0.0f, continuous);
    }
}

TEST(ScreeRun, RefusesWhatItDoesNotHave) {
    const scenes::Scene scene = checks::RestingBox();
    EXPECT_THROW(MakeScreeRun(scene, {.broadPhase = "no-such-algorithm"}), std::invalid_argument);
    EXPECT_THROW(MakeScreeRun(scene, {.threads = 0}), std::invalid_argument);
    scenes::Scene bad = scene;
    bad.bodies[1].position.x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(Make(bad), std::invalid_argument);
}

TEST(ScreeRun, TwoRunsOfASceneAreEqual) {
    const scenes::Scene scene = scenes::Build("falling-squares", 10);
    EXPECT_EQ(CaptureAfter(*Make(scene), 40).stateHash, CaptureAfter(*Make(scene), 40).stateHash);
}

TEST(ScreeRun, SpeedCapFollowsTheOption) {
    scenes::Scene scene;
    scene.gravity = {0.0f, 0.0f};
    scenes::Body fast = checks::MakeDynamic(0.0f, 0.0f);
    fast.linearVelocity = {300.0f, 0.0f};
    checks::AddBody(scene, fast, checks::MakeCircleShape(0.5f), 1.0f);
    RunSpec spec = MakeSpec("scree", likeBox2dPreset);
    EXPECT_NEAR(CaptureAfter(*MakeRun(scene, spec), 1).bodies[0].position.x, 2.0f, 1e-5f);
    EXPECT_NEAR(CaptureAfter(*MakeRun(scene, MakeSpec("box2d")), 1).bodies[0].position.x, 2.0f, 1e-5f);
    spec.caps = false;
    EXPECT_NEAR(CaptureAfter(*MakeRun(scene, spec), 1).bodies[0].position.x, 5.0f, 1e-5f);
}

TEST(EnginesAgree, FreeFlightToFloatRounding) {
    const scenes::Scene scene = checks::FreeFlight();
    const Snapshot ours = CaptureAfter(*Make(scene), 1),
                   theirs = CaptureAfter(*MakeRun(scene, MakeSpec("box2d", likeBox2dPreset)), 1);
    ASSERT_EQ(ours.bodies.size(), theirs.bodies.size());
    for (size_t i = 0; i < ours.bodies.size(); ++i) {
        SCOPED_TRACE(i);
        const BodyState &a = ours.bodies[i], &b = theirs.bodies[i];
        ExpectRounding(a.position.x, b.position.x);
        ExpectRounding(a.position.y, b.position.y);
        ExpectRounding(a.angle, b.angle);
        ExpectRounding(a.sin, b.sin);
        ExpectRounding(a.cos, b.cos);
        ExpectRounding(a.linearVelocity.x, b.linearVelocity.x);
        ExpectRounding(a.linearVelocity.y, b.linearVelocity.y);
        ExpectRounding(a.angularVelocity, b.angularVelocity);
        EXPECT_EQ(a.awake, b.awake);
        const Box &boxA = ours.fixtures[i].tight, &boxB = theirs.fixtures[i].tight;
        ExpectRounding(boxA.lower.x, boxB.lower.x);
        ExpectRounding(boxA.upper.y, boxB.upper.y);
    }
}

TEST(EnginesAgree, RestingBoxToAMillimetreAndBothSleep) {
    const scenes::Scene scene = checks::RestingBox();
    const Snapshot ours = CaptureAfter(*Make(scene), 200),
                   theirs = CaptureAfter(*MakeRun(scene, MakeSpec("box2d", likeBox2dPreset)), 200);
    EXPECT_NEAR(ours.bodies[1].position.x, theirs.bodies[1].position.x, 1e-3f);
    EXPECT_NEAR(ours.bodies[1].position.y, theirs.bodies[1].position.y, 1e-3f);
    EXPECT_FALSE(ours.bodies[1].awake);
    EXPECT_FALSE(theirs.bodies[1].awake);
    ASSERT_EQ(ours.contacts.size(), 1u);
    ASSERT_EQ(ours.contacts[0].pointCount, 2);
    const bool groundFirst = ours.contacts[0].fixtureA == 0;
    EXPECT_NEAR(ours.contacts[0].normal.y, groundFirst ? 1.0f : -1.0f, 1e-6f);
}

TEST(EnginesAgree, SweptBoxesHoldTheBoxesBeforeAndAfterTheStep) {
    const scenes::Scene scene = scenes::Build("tiles", 5);
    for (const bool isTracked : {true, false}) {
        for (const char* engine : {"scree", "box2d"}) {
            const auto run = MakeRun(scene, MakeSpec(engine, likeBox2dPreset), {.sweptBoxes = isTracked});
            for (int i = 0; i < 10; ++i) run->Step();
            Snapshot before, after;
            run->Capture(before);
            run->Step();
            run->Capture(after);
            bool hasMoved = false;
            for (size_t i = 0; i < after.fixtures.size(); ++i) {
                const Box& old = before.fixtures[i].tight;
                const Box& tight = after.fixtures[i].tight;
                const Box& swept = after.fixtures[i].swept;
                EXPECT_EQ(swept.lower.y, isTracked ? std::min(old.lower.y, tight.lower.y) : tight.lower.y);
                EXPECT_EQ(swept.upper.y, isTracked ? std::max(old.upper.y, tight.upper.y) : tight.upper.y);
                EXPECT_EQ(swept.lower.x, isTracked ? std::min(old.lower.x, tight.lower.x) : tight.lower.x);
                EXPECT_EQ(swept.upper.x, isTracked ? std::max(old.upper.x, tight.upper.x) : tight.upper.x);
                hasMoved = hasMoved || old.upper.y != tight.upper.y;
            }
            EXPECT_TRUE(hasMoved);
        }
    }
}

TEST(EnginesAgree, JointAnchorsStayTogetherInBoth) {
    const scenes::Scene scene = scenes::Build("big-mobile", 3);
    for (const char* engine : {"scree", "box2d"}) {
        SCOPED_TRACE(engine);
        const Snapshot s = CaptureAfter(*MakeRun(scene, MakeSpec(engine, likeBox2dPreset)), 20);
        ASSERT_FALSE(s.joints.empty());
        for (const JointState& j : s.joints) {
            // The position solver leaves at most a few times its slop of 5 mm.
            EXPECT_NEAR(j.anchorA.x, j.anchorB.x, 0.02f);
            EXPECT_NEAR(j.anchorA.y, j.anchorB.y, 0.02f);
        }
    }
}
