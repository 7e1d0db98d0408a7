// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A recording replays to the same hashes; a world that differs is caught at the step where it parts; what is recorded
// is listed, and so is what is not.

#include "scree/recording.h"

#include <gtest/gtest.h>

#include <set>

#include "fixtures.h"
#include "scene_world.h"
#include "world/record.h"

namespace scree::test {
namespace {

TEST(Recording, EverySceneReplaysToTheSameHashes) {
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        const scenes::Scene scene = scenes::Build(info.name, SmallSize(info));
        SCOPED_TRACE(std::string(info.name));
        World world(DefOf(scene, BroadPhaseKind::automatic));
        Recorder recorder;
        ASSERT_EQ(StartRecording(world, recorder), ErrorCode::ok);
        LoadScene(world, scene);
        const int steps = scene.bodies.size() > 1500 ? 3 : 30;
        for (int i = 0; i < steps; ++i) StepScene(world, scene);
        StopRecording(world);
        const ReplayReport report = Replay(recorder.GetBytes());
        EXPECT_TRUE(report.valid);
        EXPECT_EQ(report.firstDifference, 0);
        EXPECT_EQ(report.steps, steps);
        EXPECT_EQ(report.calls, recorder.GetCallCount());
        ASSERT_NE(report.world, nullptr);
        EXPECT_EQ(inspect::GetStateHash(world), inspect::GetStateHash(*report.world));
    }
}

/// Edits of every kind between steps, on a world that was already running.
void Play(World& world, int steps) {
    Body* ground = AddGround(world);
    Body* a = AddBody(world, dynamicBody, {0.0f, 2.0f});
    Body* b = AddBody(world, dynamicBody, {1.5f, 2.0f});
    Fixture* box = AddBox(a, 0.5f, 0.5f);
    AddCircle(b, 0.5f);
    RevoluteJointDef hinge;
    hinge.Initialize(ground, a, {0.0f, 2.5f});
    auto* joint = static_cast<RevoluteJoint*>(world.CreateJoint(&hinge));
    for (int i = 0; i < steps; ++i) {
        if (i == 3) a->ApplyLinearImpulse({1.0f, 4.0f}, {0.1f, 2.0f}, true);
        if (i == 5) joint->EnableMotor(true), joint->SetMaxMotorTorque(20.0f), joint->SetMotorSpeed(2.0f);
        if (i == 8) joint->EnableLimit(true), joint->SetLimits(-0.5f, 1.5f);
        if (i == 10) box->SetFriction(0.9f), box->SetFilterData({2, 0xFFFF, 0});
        if (i == 12) b->SetTransform({1.5f, 5.0f}, 0.4f), b->SetFixedRotation(true);
        if (i == 14) world.SetGravity({1.0f, -9.0f}), b->SetType(kinematicBody), b->SetLinearVelocity({0.0f, -1.0f});
        if (i == 16) a->DestroyFixture(box);
        if (i == 17) {
            CircleShape smaller;
            smaller.m_radius = 0.3f;
            b->GetFixtureList()->SetShape(smaller);
        }
        if (i == 18) AddBox(a, 0.3f, 0.6f, 2.0f);
        if (i == 20) world.DestroyBody(b);
        if (i == 22) world.ShiftOrigin({3.0f, 1.0f}), b = AddBody(world, dynamicBody, {2.0f, 3.0f});
        if (i == 24) world.DestroyJoint(joint), a->SetAwake(false);
        StepFor(world, 1);
    }
}

TEST(Recording, EditsBetweenStepsReplayToTheSameHashes) {
    World world({0.0f, -10.0f});
    AddBox(AddBody(world, dynamicBody, {-4.0f, 1.0f}), 0.5f, 0.5f);
    StepFor(world, 5);
    Recorder recorder;
    ASSERT_EQ(StartRecording(world, recorder), ErrorCode::ok);
    Play(world, 40);
    const ReplayReport report = Replay(recorder.GetBytes());
    EXPECT_TRUE(report.valid);
    EXPECT_EQ(report.firstDifference, 0);
    EXPECT_EQ(report.steps, 40);
    EXPECT_EQ(report.calls, recorder.GetCallCount());
    EXPECT_EQ(inspect::GetStateHash(world), inspect::GetStateHash(*report.world));
}

TEST(Recording, AManifoldSetBetweenStepsIsReplayed) {
    World world({0.0f, -10.0f});
    AddGround(world);
    AddBox(AddBody(world, dynamicBody, {0.0f, 0.5f}), 0.5f, 0.5f);
    Recorder recorder;
    ASSERT_EQ(StartRecording(world, recorder), ErrorCode::ok);
    StepFor(world, 5);
    Contact* contact = world.GetContactList();
    ASSERT_NE(contact, nullptr);
    // The next step begins with these impulses.
    Manifold manifold = contact->GetManifold();
    ASSERT_GT(manifold.pointCount, 0);
    for (ManifoldPoint& point : manifold.points) point.normalImpulse = 3.0f;
    ASSERT_EQ(contact->SetManifold(manifold), ErrorCode::ok);
    StepFor(world, 1);
    const ReplayReport report = Replay(recorder.GetBytes());
    EXPECT_TRUE(report.valid);
    EXPECT_EQ(report.firstDifference, 0);
    EXPECT_EQ(inspect::GetStateHash(world), inspect::GetStateHash(*report.world));
}

TEST(Recording, APlayerGoesStepByStepAndItsWorldGoesOnAsTheRecordedOne) {
    World world({0.0f, -10.0f});
    Recorder recorder;
    ASSERT_EQ(StartRecording(world, recorder), ErrorCode::ok);
    Play(world, 30);
    world.SetGravity({0.0f, -5.0f});
    Player player(recorder.GetBytes());
    ASSERT_NE(player.GetWorld(), nullptr);
    EXPECT_EQ(player.GetWorld()->GetBodyCount(), 0) << "no call is made before the first step";
    int steps = 0;
    while (player.Step()) {
        EXPECT_EQ(player.GetReport().steps, ++steps);
        EXPECT_FLOAT_EQ(player.GetReport().lastStep.timeStep, 1.0f / 60.0f);
        EXPECT_EQ(player.GetReport().lastStep.velocityIterations, 8);
        EXPECT_EQ(player.GetReport().lastStep.positionIterations, 3);
    }
    EXPECT_EQ(steps, 30);
    EXPECT_TRUE(player.GetReport().valid);
    EXPECT_EQ(player.GetReport().position, recorder.GetBytes().size());
    EXPECT_EQ(player.GetWorld()->GetGravity().y, -5.0f) << "calls behind the last step are made";
    EXPECT_EQ(inspect::GetStateHash(*player.GetWorld()), inspect::GetStateHash(world));
    EXPECT_FALSE(player.Step());

    Player none(recorder.GetBytes().first(7));
    EXPECT_EQ(none.GetWorld(), nullptr);
    EXPECT_FALSE(none.Step());
    EXPECT_FALSE(none.GetReport().valid);
}

TEST(Recording, AShapeOfAnotherTypeOrADegenerateOneIsRefused) {
    World world({0.0f, -10.0f});
    ErrorLog errors(world);
    Fixture* circle = AddCircle(AddBody(world, dynamicBody, {0.0f, 1.0f}), 0.5f);
    PolygonShape box;
    box.SetAsBox(1.0f, 1.0f);
    EXPECT_EQ(circle->SetShape(box), ErrorCode::badShape);
    CircleShape bad;
    bad.m_radius = NAN;
    EXPECT_NE(circle->SetShape(bad), ErrorCode::ok);
    EXPECT_EQ(errors.count, 2);
    EXPECT_EQ(std::as_const(*circle).GetShape()->m_radius, 0.5f);
}

TEST(Recording, TheFirstStepThatDiffersIsNamed) {
    // A listener that the player does not have stands for a build that computes something else from step 7 on.
    struct Meddler final : ContactListener {
        int step = 0;
        void PreSolve(Contact* contact, const Manifold*) override {
            if (step >= 7) contact->SetTangentSpeed(1.0f);
        }
    } meddler;
    World world({0.0f, -10.0f});
    AddGround(world);
    AddBox(AddBody(world, dynamicBody, {0.0f, 0.5f}), 0.5f, 0.5f);
    world.SetContactListener(&meddler);
    Recorder recorder;
    ASSERT_EQ(StartRecording(world, recorder), ErrorCode::ok);
    for (meddler.step = 1; meddler.step <= 12; ++meddler.step) StepFor(world, 1);
    const ReplayReport report = Replay(recorder.GetBytes());
    EXPECT_TRUE(report.valid);
    EXPECT_EQ(report.firstDifference, 7);

    Meddler same;
    const ReplayReport prepared = Replay(recorder.GetBytes(), [&](World& copy) {
        same.step = 7;
        copy.SetContactListener(&same);
    });
    EXPECT_EQ(prepared.firstDifference, 1) << "the listener of the player is heard";
}

TEST(Recording, RefusedCallsAndCallsWithoutARecorderLeaveNoTrace) {
    World world({0.0f, -10.0f});
    ErrorLog errors(world);
    Body* body = AddBody(world, dynamicBody, {0.0f, 1.0f});
    Recorder recorder;
    ASSERT_EQ(StartRecording(world, recorder), ErrorCode::ok);
    const size_t before = recorder.GetBytes().size();
    body->SetLinearVelocity({NAN, 0.0f});
    world.CreateBody(nullptr);
    world.Step(-1.0f, 8, 3);
    EXPECT_EQ(errors.count, 3);
    EXPECT_EQ(recorder.GetBytes().size(), before);
    StopRecording(world);
    StepFor(world, 3);
    EXPECT_EQ(recorder.GetBytes().size(), before);
}

TEST(Recording, DamagedBytesEndTheReplayWithoutHarm) {
    World world({0.0f, -10.0f});
    Recorder recorder;
    ASSERT_EQ(StartRecording(world, recorder), ErrorCode::ok);
    Play(world, 30);
    const std::vector<std::byte> bytes(recorder.GetBytes().begin(), recorder.GetBytes().end());
    int valid = 0;
    for (size_t length = 0; length < bytes.size(); length += 7) {
        const ReplayReport report = Replay(std::span(bytes).first(length));
        valid += report.valid ? 1 : 0;
        EXPECT_EQ(report.firstDifference, 0);
    }
    EXPECT_LT(valid, 100) << "a cut is noticed unless it falls between two calls";
    for (size_t at = 0; at < bytes.size(); at += 3) {
        std::vector<std::byte> damaged = bytes;
        damaged[at] ^= static_cast<std::byte>(1u << (at % 8));
        EXPECT_FALSE(Replay(damaged).valid) << at;
    }
}

TEST(Recording, NamesAreKnownByDifferentNumbers) {
    std::set<uint32_t> numbers{hashRecord};
    const std::vector<std::string_view> names = GetRecordedCalls();
    for (const std::string_view name : names) EXPECT_TRUE(numbers.insert(CallNumber(name)).second) << name;
    EXPECT_EQ(names.size(), 111u) << "a new call of the API that changes the world is recorded and counted here";
    // The gap: what belongs to the program and not to the world.
    for (const char* call :
         {"World::SetContactListener", "World::SetContactFilter", "World::SetDestructionListener",
          "World::SetErrorHandler", "World::SetDebugDraw", "World::SetWorkers", "World::SetFeatures"}) {
        EXPECT_FALSE(numbers.contains(CallNumber(call))) << call;
    }
}

}  // namespace
}  // namespace scree::test
