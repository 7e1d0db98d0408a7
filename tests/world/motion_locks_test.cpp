// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Locked motions, and velocities towards a target transform: in both solvers, with contacts and joints.

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "scree/recording.h"
#include "scree/snapshot.h"
#include "tests/world/fixtures.h"
#include "world/world_state.h"

namespace scree::test {
namespace {

/// A heap of boxes and disks with random locks, some of them hinged to the next, and a ball that is shot into it.
struct Heap {
    explicit Heap(uint32_t seed, bool hasJoints) {
        std::mt19937 random(seed);
        AddGround(world);
        for (int i = 0; i < 40; ++i) {
            BodyDef def;
            def.type = dynamicBody;
            def.position = {1.01f * static_cast<float>(i % 8) - 4.0f, 0.55f + 1.02f * static_cast<float>(i / 8)};
            def.locks = {random() % 4 == 0, random() % 4 == 0, random() % 4 == 0};
            Body* body = world.CreateBody(&def);
            random() % 2 == 0 ? AddBox(body, 0.5f, 0.5f) : AddCircle(body, 0.5f);
            bodies.push_back(body);
            if (!hasJoints || i % 8 == 0 || random() % 3 != 0) continue;
            RevoluteJointDef hinge;
            hinge.Initialize(bodies[bodies.size() - 2], body, body->GetPosition());
            world.CreateJoint(&hinge);
        }
        Body* ball = AddBody(world, dynamicBody, {-30.0f, 2.0f});
        AddCircle(ball, 0.6f, 5.0f);
        ball->SetBullet(true);
        ball->SetLinearVelocity({45.0f, 2.0f});
    }
    World world{Vec2{0.0f, -10.0f}};
    std::vector<Body*> bodies;
};

TEST(MotionLocks, WhatIsLockedDoesNotMoveByOneBit) {
    for (const int substeps : solvers) {
        for (const bool hasJoints : {false, true}) {
            for (uint32_t seed = 1; seed <= 3; ++seed) {
                Heap heap(seed, hasJoints);
                std::vector<Vec2> start;
                for (const Body* body : heap.bodies) start.push_back(body->GetWorldCenter());
                StepWith(heap.world, substeps, 150);
                bool hasMoved = false;
                for (size_t i = 0; i < heap.bodies.size(); ++i) {
                    const Body& body = *heap.bodies[i];
                    const MotionLocks locks = body.GetMotionLocks();
                    const Vec2 now = body.GetWorldCenter();
                    const Vec2 v = body.GetLinearVelocity();
                    EXPECT_TRUE(!locks.x || now.x == start[i].x) << substeps << ' ' << hasJoints << ' ' << i;
                    EXPECT_TRUE(!locks.y || now.y == start[i].y) << substeps << ' ' << hasJoints << ' ' << i;
                    EXPECT_TRUE(!locks.angle || body.GetAngle() == 0.0f) << i;
                    EXPECT_TRUE((!locks.x || v.x == 0.0f) && (!locks.y || v.y == 0.0f)) << i;
                    hasMoved = hasMoved || (!locks.x && std::abs(now.x - start[i].x) > 0.1f);
                }
                EXPECT_TRUE(hasMoved);
            }
        }
    }
}

/// A sled that is locked in y carries a crate as the ground would, and gives way to the side.
TEST(MotionLocks, ALockedBodyCarriesAsAWallDoes) {
    for (const int substeps : solvers) {
        World world({0.0f, -10.0f});
        BodyDef def;
        def.type = dynamicBody;
        def.locks = {.y = true, .angle = true};
        Body* sled = world.CreateBody(&def);
        AddBox(sled, 2.0f, 0.25f);
        Body* crate = AddBody(world, dynamicBody, {0.0f, 0.75f});
        AddBox(crate, 0.5f, 0.5f);
        StepWith(world, substeps, 240);
        EXPECT_NEAR(crate->GetPosition().y, 0.75f, 0.02f) << substeps;
        sled->ApplyLinearImpulseToCenter({0.5f * sled->GetMass(), 50.0f}, true);
        StepWith(world, substeps, 60);
        EXPECT_GT(sled->GetPosition().x, 0.15f) << substeps;
        EXPECT_EQ(sled->GetPosition().y, 0.0f);
    }
}

TEST(MotionLocks, AreSetAndFreedAndStopWhatMoves) {
    World world({0.0f, 0.0f});
    Body* body = AddBody(world, dynamicBody, {0.0f, 0.0f});
    AddBox(body, 0.5f, 0.5f);
    body->SetLinearVelocity({1.0f, 2.0f});
    body->SetAngularVelocity(3.0f);
    EXPECT_FALSE(world.GetRequiredFeatures().Has(Feature::motionLocks));
    EXPECT_EQ(body->SetMotionLocks({.x = true, .angle = true}), ErrorCode::ok);
    EXPECT_TRUE((body->GetMotionLocks() == MotionLocks{true, false, true}));
    EXPECT_TRUE(world.GetRequiredFeatures().Has(Feature::motionLocks));
    EXPECT_TRUE(body->IsFixedRotation());
    EXPECT_TRUE((body->GetLinearVelocity() == Vec2{0.0f, 2.0f}));
    EXPECT_EQ(body->GetAngularVelocity(), 0.0f);
    StepFor(world, 1);
    EXPECT_TRUE(inspect::GetKernels(world).locks);
    body->SetMotionLocks({});
    EXPECT_FALSE(body->IsFixedRotation());
    body->ApplyLinearImpulseToCenter({3.0f, 0.0f}, true);
    StepFor(world, 1);
    EXPECT_GT(body->GetPosition().x, 0.0f);
    EXPECT_FALSE(inspect::GetKernels(world).locks);
}

TEST(MotionLocks, RecordingsImagesAndWorkersLeadToTheSameState) {
    for (const int substeps : solvers) {
        Heap one(5, true), three(5, true);
        three.world.SetWorkers(3);
        three.world.GetState().pool->ShareAlways();
        Recorder recorder;
        ASSERT_EQ(StartRecording(one.world, recorder), ErrorCode::ok);
        for (int i = 0; i < 90; ++i) {
            for (Heap* heap : {&one, &three}) {
                Body* body = heap->bodies[static_cast<size_t>(i * 7) % heap->bodies.size()];
                body->SetMotionLocks({i % 3 == 0, i % 5 == 0, i % 2 == 0});
                StepWith(heap->world, substeps, 1);
            }
            ASSERT_EQ(inspect::GetStateHash(one.world), inspect::GetStateHash(three.world)) << i;
        }
        StopRecording(one.world);
        const ReplayReport report = Replay(recorder.GetBytes());
        EXPECT_TRUE(report.valid);
        EXPECT_EQ(report.firstDifference, 0);
        const auto loaded = LoadWorld(SaveWorld(one.world));
        ASSERT_NE(loaded, nullptr);
        StepWith(one.world, substeps, 30), StepWith(*loaded, substeps, 30);
        EXPECT_EQ(inspect::GetStateHash(*loaded), inspect::GetStateHash(one.world));
    }
}

TEST(TargetTransform, AKinematicBodyArrivesInOneStepAndCarriesWhatStandsOnIt) {
    for (const int substeps : solvers) {
        World world({0.0f, -10.0f});
        Body* lift = AddBody(world, kinematicBody, {0.0f, 0.0f});
        PolygonShape plate;
        plate.SetAsBox(2.0f, 0.25f, {0.5f, 0.0f}, 0.0f);
        lift->CreateFixture(&plate, 1.0f);
        Body* crate = AddBody(world, dynamicBody, {0.0f, 0.75f});
        AddBox(crate, 0.5f, 0.5f);
        for (int i = 1; i <= 120; ++i) {
            const Vec2 target{0.01f * static_cast<float>(i), 0.02f * static_cast<float>(i)};
            ASSERT_EQ(lift->SetTargetTransform(target, 0.0f, frame), ErrorCode::ok);
            StepWith(world, substeps, 1);
            ASSERT_NEAR(lift->GetPosition().x, target.x, 1e-5f);
            ASSERT_NEAR(lift->GetPosition().y, target.y, 1e-5f);
        }
        EXPECT_NEAR(crate->GetPosition().y, 2.4f + 0.75f, 0.03f) << substeps;
        EXPECT_NEAR(crate->GetPosition().x, 1.2f, 0.1f) << substeps;
        lift->SetTargetTransform({3.0f, 2.0f}, 1.0f, frame);
        StepWith(world, substeps, 1);
        EXPECT_NEAR(lift->GetAngle(), 1.0f, 1e-5f);
        EXPECT_NEAR(lift->GetPosition().x, 3.0f, 1e-4f);
    }
}

TEST(TargetTransform, BadInputIsRefused) {
    World world({0.0f, 0.0f});
    Body* body = AddBody(world, kinematicBody, {0.0f, 0.0f});
    Body* wall = AddBody(world, staticBody, {0.0f, 0.0f});
    ErrorLog errors(world);
    EXPECT_EQ(body->SetTargetTransform({nan, 0.0f}, 0.0f, frame), ErrorCode::nonFinite);
    EXPECT_EQ(body->SetTargetTransform({0.0f, 0.0f}, 0.0f, 0.0f), ErrorCode::outOfRange);
    EXPECT_EQ(body->SetTargetTransform({0.0f, 0.0f}, 0.0f, nan), ErrorCode::outOfRange);
    EXPECT_EQ(body->SetTargetTransform({1e17f, 0.0f}, 0.0f, 1e-3f), ErrorCode::outOfRange);
    EXPECT_EQ(wall->SetTargetTransform({1.0f, 0.0f}, 0.0f, frame), ErrorCode::outOfRange);
    EXPECT_EQ(errors.count, 5);
    EXPECT_TRUE(body->GetLinearVelocity() == vec2Zero);
}

}  // namespace
}  // namespace scree::test
