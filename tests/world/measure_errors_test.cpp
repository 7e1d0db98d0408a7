// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// StepErrors against states whose overlap, joint gap and residual are known.

#include <gtest/gtest.h>

#include "scree/revolute_joint.h"
#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

TEST(MeasureErrors, AreZeroUnlessAsked) {
    World world({0, -10});
    AddGround(world);
    AddBox(AddBody(world, dynamicBody, {0, 0.4f}), 0.5f, 0.5f);
    StepReport report = StepFor(world, 1);
    EXPECT_EQ(report.errors.overlap, 0.0f);
    EXPECT_GT(world.MeasureErrors().overlap, 0.03f);
    world.SetMeasureErrors(true);
    EXPECT_TRUE(world.GetMeasureErrors());
    report = StepFor(world, 1);
    EXPECT_GT(report.errors.overlap, 0.02f);
    EXPECT_EQ(report.errors.overlap, world.GetReport().errors.overlap);
}

TEST(MeasureErrors, TellTheDeepestOverlapSkinsIncluded) {
    World world({0, 0});
    AddGround(world);
    Body* deep = AddBody(world, dynamicBody, {0, 0.4f});
    AddBox(deep, 0.5f, 0.5f);
    AddCircle(AddBody(world, dynamicBody, {5, 0.49f}), 0.5f);
    world.Step(0.0f, 8, 3);  // only finds contacts
    world.Step(0.0f, 8, 3);
    EXPECT_NEAR(world.MeasureErrors().overlap, 0.1f + 2.0f * polygonRadius, 1e-5f);
    deep->SetTransform({50, 50}, 0);
    world.Step(0.0f, 8, 3);
    world.Step(0.0f, 8, 3);
    EXPECT_NEAR(world.MeasureErrors().overlap, 0.01f + polygonRadius, 1e-5f);
}

TEST(MeasureErrors, AreSmallAtRestAndLargeWhereASolverIsCutShort) {
    for (const bool soft : {false, true}) {
        World world({0, -10});
        world.SetAllowSleeping(false);
        AddGround(world);
        for (int i = 0; i < 5; ++i)
            AddBox(AddBody(world, dynamicBody, {0, 0.515f + 1.015f * static_cast<float>(i)}), 0.5f, 0.5f);
        for (int i = 0; i < 300; ++i) soft ? world.Step(1.0f / 60.0f, 8) : world.Step(1.0f / 60.0f, 30, 10);
        const StepErrors rest = world.MeasureErrors();
        if (soft) {  // outlines give way a little
            EXPECT_LT(rest.overlap, linearSlop);
            EXPECT_LT(rest.residual, linearSlop);
        } else {
            EXPECT_NEAR(rest.overlap, linearSlop, 0.002f);
            EXPECT_LT(rest.residual, 0.002f);
        }
        EXPECT_EQ(rest.jointGap, 0.0f);
        for (Body* b = world.GetBodyList(); b; b = b->GetNext()) b->SetLinearVelocity({0, -10});
        world.Step(1.0f / 60.0f, 0, 0);  // no iteration at all
        EXPECT_GT(world.MeasureErrors().overlap, 0.15f);
        EXPECT_GT(world.MeasureErrors().residual, 0.15f) << "a gap that is negative, whatever is pushed";
    }
}

TEST(MeasureErrors, SeeAPushAcrossAGap) {
    // The contact stopped a fall; then the box is lifted away: a gap with the impulse of the step still on it.
    World world({0, -10});
    AddGround(world);
    Body* box = AddBody(world, dynamicBody, {0, 0.515f});
    AddBox(box, 0.5f, 0.5f);
    box->SetLinearVelocity({0, -30});
    StepFor(world, 1);
    EXPECT_LT(world.MeasureErrors().residual, 0.01f);
    box->SetTransform({0, 0.515f + 0.1f}, 0);
    EXPECT_NEAR(world.MeasureErrors().residual, 0.1f, 0.01f);
}

TEST(MeasureErrors, TellTheWorstJointGap) {
    World world({0, 0});
    Body* a = AddBody(world, staticBody, {0, 0});
    Body* b = AddBody(world, dynamicBody, {0, 0});
    Body* c = AddBody(world, dynamicBody, {2, 0});
    AddCircle(b, 0.1f);
    AddCircle(c, 0.1f);
    RevoluteJointDef hinge;
    hinge.Initialize(a, b, {0, 0});
    world.CreateJoint(&hinge);
    DistanceJointDef rod;
    rod.Initialize(a, c, {0, 0}, {2, 0});
    rod.minLength = rod.maxLength = rod.length;
    world.CreateJoint(&rod);
    EXPECT_EQ(world.MeasureErrors().jointGap, 0.0f);
    b->SetTransform({0.03f, 0.04f}, 1.0f);
    EXPECT_NEAR(world.MeasureErrors().jointGap, 0.05f, 1e-6f);
    c->SetTransform({0, 2.25f}, 0);
    EXPECT_NEAR(world.MeasureErrors().jointGap, 0.25f, 1e-6f);
    b->SetTransform({0, 0}, 0);
    PrismaticJointDef slide;
    slide.Initialize(a, b, {0, 0}, {1, 0});
    slide.enableLimit = true;
    slide.lowerTranslation = -1.0f;
    slide.upperTranslation = 1.0f;
    World other({0, 0});
    slide.bodyA = AddBody(other, staticBody, {0, 0});
    slide.bodyB = AddBody(other, dynamicBody, {0.5f, 0});
    AddCircle(slide.bodyB, 0.1f);
    other.CreateJoint(&slide);
    EXPECT_EQ(other.MeasureErrors().jointGap, 0.0f) << "along the axis is free";
    slide.bodyB->SetTransform({0.5f, 0.2f}, 0);
    EXPECT_NEAR(other.MeasureErrors().jointGap, 0.2f, 1e-6f);
    slide.bodyB->SetTransform({1.75f, 0}, 0);
    EXPECT_NEAR(other.MeasureErrors().jointGap, 0.75f, 1e-6f);
}

}  // namespace
}  // namespace scree::test
