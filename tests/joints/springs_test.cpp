// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Springs with targets on hinges and sliders, bounds of spring forces, thresholds that report or break: laws in both
// solvers, and the same state by recordings and images.

#include <gtest/gtest.h>

#include <cmath>

#include "scree/recording.h"
#include "scree/snapshot.h"
#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

/// A box that slides along y on a ground.
struct Slider {
    explicit Slider(float stiffness, float damping, float target = 0.0f, float gravity = -10.0f)
        : world(Vec2{0.0f, gravity}) {
        Body* ground = AddBody(world, staticBody, {0.0f, 0.0f});
        body = AddBody(world, dynamicBody, {0.0f, 0.0f});
        AddBox(body, 0.5f, 0.5f);
        body->SetSleepingAllowed(false);
        PrismaticJointDef def;
        def.Initialize(ground, body, {0.0f, 0.0f}, {0.0f, 1.0f});
        def.enableSpring = true;
        def.stiffness = stiffness;
        def.damping = damping;
        def.targetTranslation = target;
        joint = static_cast<PrismaticJoint*>(world.CreateJoint(&def));
    }
    World world;
    Body* body;
    PrismaticJoint* joint;
};

TEST(JointSprings, ASliderComesToRestWhereTheSpringHoldsItsWeight) {
    for (const int substeps : solvers) {
        Slider slider(50.0f, 8.0f, 0.5f);
        StepWith(slider.world, substeps, 600);
        EXPECT_NEAR(slider.joint->GetJointTranslation(), 0.5f - 10.0f / 50.0f, 2e-3f) << substeps;
        EXPECT_NEAR(slider.joint->GetSpringForce(60.0f), 10.0f, 0.05f) << substeps;
        slider.joint->SetTargetTranslation(1.0f);
        slider.joint->SetSpring(100.0f, 10.0f);
        StepWith(slider.world, substeps, 600);
        EXPECT_NEAR(slider.joint->GetJointTranslation(), 1.0f - 10.0f / 100.0f, 2e-3f) << substeps;
        slider.joint->EnableSpring(false);
        StepWith(slider.world, substeps, 60);
        EXPECT_NEAR(slider.body->GetLinearVelocity().y, -10.0f, 0.2f) << substeps;
    }
}

TEST(JointSprings, ABoundedSpringHoldsNoMoreThanItsBound) {
    for (const int substeps : solvers) {
        for (const float most : {8.0f, 12.0f}) {
            Slider slider(500.0f, 20.0f);
            slider.joint->SetMaxSpringForce(most);
            StepWith(slider.world, substeps, 60);
            if (most > 10.0f) {
                EXPECT_NEAR(slider.joint->GetJointTranslation(), -0.02f, 0.01f) << substeps;
            } else {  // what is left of the weight accelerates the box
                EXPECT_NEAR(slider.body->GetLinearVelocity().y, -2.0f, 0.3f) << substeps;
                EXPECT_NEAR(slider.joint->GetSpringForce(60.0f), 8.0f, 0.1f) << substeps;
            }
        }
    }
}

/// Without damping of its own a spring at a hertz swings at that frequency.
TEST(JointSprings, AHingeSwingsAtItsFrequencyAroundItsTarget) {
    for (const int substeps : solvers) {
        World world({0.0f, 0.0f});
        Body* ground = AddBody(world, staticBody, {0.0f, 0.0f});
        Body* body = AddBody(world, dynamicBody, {0.0f, 0.0f});
        AddBox(body, 1.0f, 0.25f);
        RevoluteJointDef def;
        def.Initialize(ground, body, {0.0f, 0.0f});
        def.enableSpring = true;
        def.targetAngle = 0.4f;
        constexpr float hertz = 0.5f;
        ASSERT_EQ(AngularStiffness(def.stiffness, def.damping, hertz, 0.05f, ground, body), ErrorCode::ok);
        auto* joint = static_cast<RevoluteJoint*>(world.CreateJoint(&def));
        int crossings = 0, first = 0, last = 0;
        float before = joint->GetJointAngle() - 0.4f;
        for (int step = 1; step <= 600; ++step) {
            StepWith(world, substeps, 1);
            const float now = joint->GetJointAngle() - 0.4f;
            if ((before < 0.0f) != (now < 0.0f)) {
                if (crossings++ == 0) first = step;
                last = step;
            }
            before = now;
        }
        ASSERT_GE(crossings, 4) << substeps;
        const float period = 2.0f * static_cast<float>(last - first) / static_cast<float>(crossings - 1) * frame;
        EXPECT_NEAR(period, 1.0f / hertz, 0.05f) << substeps;
    }
}

TEST(JointSprings, AHingeHoldsNoMoreThanItsTorque) {
    for (const int substeps : solvers) {
        for (const float most : {4.0f, 6.0f}) {
            World world({0.0f, -10.0f});
            Body* ground = AddBody(world, staticBody, {0.0f, 0.0f});
            Body* arm = AddBody(world, dynamicBody, {1.0f, 0.0f});
            AddBox(arm, 0.5f, 0.25f);  // 0.5 kg at 1 m: 5 N·m
            RevoluteJointDef def;
            def.Initialize(ground, arm, {0.0f, 0.0f});
            def.enableSpring = true;
            def.stiffness = 500.0f;
            def.damping = 40.0f;
            def.maxSpringTorque = most;
            auto* joint = static_cast<RevoluteJoint*>(world.CreateJoint(&def));
            StepWith(world, substeps, 90);
            if (most > 5.0f) {
                EXPECT_NEAR(joint->GetJointAngle(), -0.01f, 0.005f) << substeps;
            } else {
                EXPECT_LT(joint->GetJointAngle(), -0.3f) << substeps;
            }
        }
    }
}

TEST(JointSprings, DistanceAndWheelSpringsAreBoundedToo) {
    for (const int substeps : solvers) {
        for (const float most : {6.0f, 14.0f}) {
            for (const bool isWheel : {false, true}) {
                World world({0.0f, -10.0f});
                Body* ground = AddBody(world, staticBody, {0.0f, 0.0f});
                Body* body = AddBody(world, dynamicBody, {0.0f, -2.0f});
                AddBox(body, 0.5f, 0.5f);
                if (isWheel) {
                    WheelJointDef def;
                    def.Initialize(ground, body, {0.0f, -2.0f}, {0.0f, 1.0f});
                    def.stiffness = 400.0f, def.damping = 20.0f, def.maxSpringForce = most;
                    world.CreateJoint(&def);
                } else {
                    DistanceJointDef def;
                    def.Initialize(ground, body, {0.0f, 0.0f}, {0.0f, -2.0f});
                    def.minLength = 0.0f, def.maxLength = 50.0f;
                    def.stiffness = 400.0f, def.damping = 20.0f, def.maxSpringForce = most;
                    world.CreateJoint(&def);
                }
                StepWith(world, substeps, 60);
                if (most > 10.0f) {
                    EXPECT_NEAR(body->GetPosition().y, -2.025f, 0.01f) << substeps << ' ' << isWheel;
                } else {
                    EXPECT_NEAR(body->GetLinearVelocity().y, -4.0f, 0.3f) << substeps << ' ' << isWheel;
                }
            }
        }
    }
}

/// A mass on a hinge, 10 N.
struct Hanging {
    Hanging() {
        Body* ground = AddBody(world, staticBody, {0.0f, 5.0f});
        body = AddBody(world, dynamicBody, {0.0f, 3.0f});
        AddBox(body, 0.5f, 0.5f);
        RevoluteJointDef def;
        def.Initialize(ground, body, {0.0f, 5.0f});
        joint = world.CreateJoint(&def);
    }
    World world{Vec2{0.0f, -10.0f}};
    Body* body;
    Joint* joint;
};

TEST(JointEvents, TellOfReactionsAboveAThresholdAndBreakTheJoint) {
    for (const int substeps : solvers) {
        Hanging hanging;
        World& world = hanging.world;
        StepWith(world, substeps, 10);
        EXPECT_TRUE(world.GetEvents().joints.empty());
        ASSERT_EQ(hanging.joint->SetThresholds(10.5f, infinity, false), ErrorCode::ok);
        EXPECT_TRUE(world.GetRequiredFeatures().Has(Feature::events));
        StepWith(world, substeps, 1);
        EXPECT_TRUE(world.GetEvents().joints.empty());
        hanging.joint->SetThresholds(9.5f, infinity, false);
        StepWith(world, substeps, 1);
        ASSERT_EQ(world.GetEvents().joints.size(), 1u);
        const JointEvent event = world.GetEvents().joints[0];
        EXPECT_TRUE(event.joint == world.GetId(hanging.joint));
        EXPECT_NEAR(event.force, 10.0f, 0.2f);
        EXPECT_FALSE(event.broke);
        hanging.joint->SetThresholds(9.5f, infinity, true);
        StepWith(world, substeps, 1);
        ASSERT_EQ(world.GetEvents().joints.size(), 1u);
        EXPECT_TRUE(world.GetEvents().joints[0].broke);
        EXPECT_EQ(world.Find(event.joint), nullptr);
        EXPECT_EQ(world.GetJointCount(), 0);
        EXPECT_EQ(hanging.body->GetJointCount(), 0);
        StepWith(world, substeps, 30);
        EXPECT_TRUE(world.GetEvents().joints.empty());
        EXPECT_LT(hanging.body->GetLinearVelocity().y, -4.0f);
    }
}

TEST(JointEvents, ATorqueBreaksAWeldAndItsGearsGoWithAJoint) {
    for (const int substeps : solvers) {
        World world({0.0f, -10.0f});
        Body* ground = AddBody(world, staticBody, {0.0f, 0.0f});
        Body* wheels[2];
        RevoluteJointDef hinge;
        Joint* hinges[2];
        for (int i = 0; i < 2; ++i) {
            wheels[i] = AddBody(world, dynamicBody, {3.0f * static_cast<float>(i), 4.0f});
            AddCircle(wheels[i], 0.5f);
            hinge.Initialize(ground, wheels[i], wheels[i]->GetPosition());
            hinge.forceThreshold = i == 0 ? 2.0f : infinity;
            hinge.breaks = true;
            hinges[i] = world.CreateJoint(&hinge);
        }
        GearJointDef gear;
        gear.joint1 = hinges[0], gear.joint2 = hinges[1];
        ASSERT_NE(world.CreateJoint(&gear), nullptr);
        Body* beam = AddBody(world, dynamicBody, {-3.0f, 2.0f});
        AddBox(beam, 1.0f, 0.1f);
        WeldJointDef weld;
        weld.Initialize(ground, beam, {-4.0f, 2.0f});
        weld.torqueThreshold = 0.5f;
        weld.breaks = true;
        world.CreateJoint(&weld);
        StepWith(world, substeps, 3);
        EXPECT_EQ(world.GetJointCount(), 1) << "the second hinge";
    }
}

TEST(JointEvents, RecordingsAndImagesLeadToTheSameState) {
    for (const int substeps : solvers) {
        World world({0.0f, -10.0f});
        Recorder recorder;
        ASSERT_EQ(StartRecording(world, recorder), ErrorCode::ok);
        AddGround(world);
        Body* before = AddBody(world, staticBody, {0.0f, 12.0f});
        for (int i = 0; i < 12; ++i) {
            Body* body = AddBody(world, dynamicBody, {0.5f + static_cast<float>(i), 12.0f});
            AddBox(body, 0.5f, 0.2f);
            RevoluteJointDef def;
            def.Initialize(before, body, {static_cast<float>(i), 12.0f});
            def.enableSpring = i % 2 == 0;
            def.stiffness = 5.0f, def.damping = 0.5f, def.maxSpringTorque = 3.0f;
            def.forceThreshold = 30.0f + 3.0f * static_cast<float>(i);
            def.breaks = i > 3;
            auto* joint = static_cast<RevoluteJoint*>(world.CreateJoint(&def));
            if (i == 5) joint->SetTargetAngle(0.7f), joint->SetThresholds(20.0f, 50.0f, true);
            before = body;
        }
        StepWith(world, substeps, 90);
        EXPECT_LT(world.GetJointCount(), 12);
        StopRecording(world);
        const ReplayReport report = Replay(recorder.GetBytes());
        EXPECT_TRUE(report.valid);
        EXPECT_EQ(report.firstDifference, 0);
        const auto loaded = LoadWorld(SaveWorld(world));
        ASSERT_NE(loaded, nullptr);
        StepWith(world, substeps, 60), StepWith(*loaded, substeps, 60);
        EXPECT_EQ(inspect::GetStateHash(*loaded), inspect::GetStateHash(world));
    }
}

TEST(JointSprings, BadValuesAreRefused) {
    Slider slider(50.0f, 8.0f);
    ErrorLog errors(slider.world);
    EXPECT_EQ(slider.joint->SetSpring(-1.0f, 0.0f), ErrorCode::outOfRange);
    EXPECT_EQ(slider.joint->SetSpring(1.0f, nan), ErrorCode::nonFinite);
    EXPECT_EQ(slider.joint->SetTargetTranslation(infinity), ErrorCode::nonFinite);
    EXPECT_EQ(slider.joint->SetMaxSpringForce(nan), ErrorCode::outOfRange);
    EXPECT_EQ(slider.joint->SetMaxSpringForce(infinity), ErrorCode::ok);
    EXPECT_EQ(slider.joint->SetThresholds(-1.0f, 0.0f, false), ErrorCode::outOfRange);
    EXPECT_EQ(slider.joint->SetThresholds(1.0f, nan, false), ErrorCode::outOfRange);
    PrismaticJointDef def;
    def.Initialize(slider.joint->GetBodyA(), slider.body, {0.0f, 0.0f}, {0.0f, 1.0f});
    def.maxSpringForce = -1.0f;
    EXPECT_EQ(slider.world.CreateJoint(&def), nullptr);
    def.maxSpringForce = 1.0f, def.forceThreshold = nan;
    EXPECT_EQ(slider.world.CreateJoint(&def), nullptr);
    EXPECT_EQ(errors.count, 8);
}

}  // namespace
}  // namespace scree::test
