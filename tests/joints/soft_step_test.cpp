// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What joints of the soft step report and do does not depend on how the step is cut: into sub-steps, or by an impact.

#include <gtest/gtest.h>

#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

constexpr float inverseDt = 60.0f;
constexpr int cuts[] = {0, 1, 4, 16};  ///< sub-steps; 0: sequential impulses

/// A box of 1 kg under gravity of 10 m/s² beside a fixed one; both touch nothing.
struct Bench {
    Bench(Vec2 place, float density = 1.0f) : world({0.0f, -10.0f}) {
        ground = AddBody(world, staticBody, {0.0f, 0.0f});
        body = AddBody(world, dynamicBody, place);
        body->SetSleepingAllowed(false);
        Filter nothing;
        nothing.maskBits = 0;
        AddBox(ground, 0.5f, 0.5f)->SetFilterData(nothing);
        AddBox(body, 0.5f, 0.5f, density);
    }
    World world;
    Body *ground, *body;
};

TEST(SoftStepJoints, WhatIsSwitchedOffPushesNoMore) {
    for (const int substeps : cuts) {
        SCOPED_TRACE(substeps);
        {
            Bench bench({1.0f, 0.0f});
            RevoluteJointDef def;
            def.Initialize(bench.ground, bench.body, {0.0f, 0.0f});
            def.enableMotor = true, def.maxMotorTorque = 1000.0f;
            auto* hinge = static_cast<RevoluteJoint*>(bench.world.CreateJoint(&def));
            StepWith(bench.world, substeps, 60);
            EXPECT_NEAR(hinge->GetMotorTorque(inverseDt), 10.0f, 0.1f);
            hinge->EnableMotor(false);
            StepWith(bench.world, substeps, 2);
            EXPECT_EQ(hinge->GetMotorTorque(inverseDt), 0.0f);
            EXPECT_EQ(hinge->GetReactionTorque(inverseDt), 0.0f);
        }
        {
            Bench bench({0.0f, -1.0f});
            PrismaticJointDef def;
            def.Initialize(bench.ground, bench.body, {0.0f, 0.0f}, {0.0f, 1.0f});
            def.enableMotor = true, def.maxMotorForce = 1000.0f;
            auto* slide = static_cast<PrismaticJoint*>(bench.world.CreateJoint(&def));
            StepWith(bench.world, substeps, 60);
            EXPECT_NEAR(slide->GetReactionForce(inverseDt).y, 10.0f, 0.1f);
            slide->EnableMotor(false);
            StepWith(bench.world, substeps, 2);
            EXPECT_NEAR(slide->GetReactionForce(inverseDt).y, 0.0f, 1e-4f);
        }
        {
            Bench bench({0.0f, -1.0f});
            WheelJointDef def;
            def.Initialize(bench.ground, bench.body, {0.0f, -1.0f}, {0.0f, 1.0f});
            def.stiffness = 100.0f, def.damping = 10.0f;
            auto* wheel = static_cast<WheelJoint*>(bench.world.CreateJoint(&def));
            StepWith(bench.world, substeps, 120);
            EXPECT_NEAR(wheel->GetReactionForce(inverseDt).y, 10.0f, 0.1f);
            wheel->SetStiffness(0.0f);
            StepWith(bench.world, substeps, 2);
            EXPECT_NEAR(wheel->GetReactionForce(inverseDt).y, 0.0f, 1e-4f);
        }
        {
            Bench bench({0.0f, -2.0f});
            DistanceJointDef def;
            def.Initialize(bench.ground, bench.body, {0.0f, 0.0f}, {0.0f, -2.0f});
            def.minLength = 0.5f;
            auto* rope = static_cast<DistanceJoint*>(bench.world.CreateJoint(&def));
            StepWith(bench.world, substeps, 60);
            rope->SetMinLength(2.0f);  // a rod
            StepWith(bench.world, substeps, 60);
            EXPECT_NEAR(rope->GetReactionForce(inverseDt).y, 10.0f, 0.1f);
        }
    }
}

/// A pellet meets a hanging load within a step: the joint goes on to carry the load.
TEST(SoftStepJoints, AnImpactWithinAStepLeavesTheReaction) {
    for (const int substeps : cuts) {
        for (const bool isRigid : {false, true}) {
            for (const float part : {0.1f, 0.5f, 0.9f}) {
                SCOPED_TRACE(testing::Message() << substeps << " sub-steps, at " << part);
                Bench bench({0.0f, -5.0f}, 1000.0f);
                bench.body->SetBullet(true);
                DistanceJointDef def;
                def.Initialize(bench.ground, bench.body, {0.0f, 0.0f}, {0.0f, -5.0f});
                if (!isRigid) def.minLength = 0.0f;
                Joint* joint = bench.world.CreateJoint(&def);
                StepWith(bench.world, substeps, 30);
                constexpr float speed = 200.0f, way = speed / 60.0f;
                Body* pellet = AddBody(bench.world, dynamicBody, {-0.55f - way * part, -5.0f});
                AddBox(pellet, 0.05f, 0.05f, 0.001f);
                pellet->SetBullet(true);
                pellet->SetGravityScale(0.0f);
                pellet->SetLinearVelocity({speed, 0.0f});
                int events = 0;
                for (int step = 0; step < 3; ++step) {
                    const StepReport report = StepWith(bench.world, substeps);
                    events += report.continuousEventCount;
                    EXPECT_NEAR(joint->GetReactionForce(inverseDt).y, 10000.0f, 50.0f);
                }
                EXPECT_GT(events, 0);
            }
        }
    }
}

TEST(SoftStepJoints, SharesOfAStepAreThoseOfAStep) {
    for (const int substeps : cuts) {
        SCOPED_TRACE(substeps);
        World world({0.0f, 0.0f});
        Body* ground = AddBody(world, staticBody, {0.0f, 0.0f});
        Body* driven = AddBody(world, dynamicBody, {1.0f, 0.0f});
        AddBox(driven, 0.5f, 0.5f);
        MotorJointDef motor;
        motor.bodyA = ground, motor.bodyB = driven;
        motor.linearOffset = {0.0f, 0.0f}, motor.correctionFactor = 0.3f;
        motor.maxForce = motor.maxTorque = 1e6f;
        world.CreateJoint(&motor);
        Body* held = AddBody(world, dynamicBody, {9.0f, 0.0f});
        AddBox(held, 0.5f, 0.5f);
        held->SetAngularVelocity(10.0f);
        MouseJointDef mouse;
        mouse.bodyA = ground, mouse.bodyB = held;
        mouse.target = {9.0f, 0.0f}, mouse.maxForce = 1000.0f, mouse.stiffness = 100.0f, mouse.damping = 1.0f;
        world.CreateJoint(&mouse);
        StepWith(world, substeps);
        EXPECT_NEAR(driven->GetPosition().x, 0.7f, 1e-4f);
        EXPECT_NEAR(held->GetAngularVelocity(), 9.8f, 0.01f);
        StepWith(world, substeps, 59);
        EXPECT_NEAR(held->GetAngularVelocity(), 2.98f, 0.03f);
    }
}

}  // namespace
}  // namespace scree::test
