// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Sleep timers run once a step and only as long as the rules say: beside disabled bodies, and under contacts that
// flicker.

#include <gtest/gtest.h>

#include <vector>

#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

/// Steps until the body sleeps; −1: it does not within a hundred.
int StepsToSleep(World& world, const Body* body, int substeps) {
    for (int step = 1; step <= 100; ++step) {
        StepWith(world, substeps);
        if (!body->IsAwake()) return step;
    }
    return -1;
}

TEST(SleepTimers, ABodyJoinedToADisabledOneFallsAsleepLikeALoneOne) {
    for (const int substeps : {0, 4}) {
        const auto stepsOf = [&](bool joined) {
            World world({0.0f, 0.0f});
            Body* body = AddBody(world, dynamicBody, {0.0f, 0.0f});
            Body* other = AddBody(world, dynamicBody, {3.0f, 0.0f});
            AddBox(body, 0.5f, 0.5f);
            AddBox(other, 0.5f, 0.5f);
            if (joined) {
                RevoluteJointDef def;
                def.Initialize(body, other, {1.5f, 0.0f});
                world.CreateJoint(&def);
            }
            other->SetEnabled(false);
            return StepsToSleep(world, body, substeps);
        };
        EXPECT_EQ(stepsOf(true), stepsOf(false)) << substeps;
        EXPECT_GT(stepsOf(true), 25) << substeps;
    }
}

/// The soft step looks for islands only when somebody may fall asleep or must wake.
TEST(SleepTimers, AJointToADisabledBodyAsksForNoIslands) {
    World world({0.0f, 0.0f});
    Body* body = AddBody(world, dynamicBody, {0.0f, 0.0f});
    Body* other = AddBody(world, dynamicBody, {3.0f, 0.0f});
    AddBox(body, 0.5f, 0.5f);
    AddBox(other, 0.5f, 0.5f);
    body->SetLinearVelocity({1.0f, 0.0f});
    RevoluteJointDef def;
    def.Initialize(body, other, {1.5f, 0.0f});
    world.CreateJoint(&def);
    other->SetEnabled(false);
    for (int step = 0; step < 5; ++step) {
        const StepReport report = world.Step(1.0f / 60.0f, 4);
        EXPECT_EQ(report.islandCount, 0);
        EXPECT_EQ(report.isolatedBodyCount, 1);
    }
}

/// A pile that was about to fall asleep moves in that very step.
TEST(SleepTimers, WhatMovesInTheStepInWhichItWouldFallAsleepStaysAwake) {
    for (const int substeps : {0, 4}) {
        const auto build = [](World& world) {
            AddGround(world, 20.0f);
            std::vector<Body*> boxes;
            for (int i = 0; i < 3; ++i) {
                boxes.push_back(AddBody(world, dynamicBody, {0.0f, 0.5f + static_cast<float>(i)}));
                AddBox(boxes.back(), 0.5f, 0.5f);
            }
            return boxes;
        };
        World before({0.0f, -10.0f});
        const int steps = StepsToSleep(before, build(before).back(), substeps);
        ASSERT_GT(steps, 25) << substeps;
        World world({0.0f, -10.0f});
        const std::vector<Body*> boxes = build(world);
        for (int step = 1; step < steps; ++step) StepWith(world, substeps);
        world.SetGravity({30.0f, -1.0f});
        StepWith(world, substeps);
        for (const Body* box : boxes) EXPECT_TRUE(box->IsAwake()) << substeps;
        EXPECT_GT(boxes.back()->GetLinearVelocity().x, 0.1f);
    }
}

/// Two slow bodies come to touch while their timers run: the soft step lets them go on, Box2D's rule for sequential
/// impulses starts them anew.
TEST(SleepTimers, AContactThatBeginsLeavesTheTimersOfAwakeBodiesInTheSoftStep) {
    for (const int substeps : {0, 4}) {
        World world({0.0f, 0.0f});
        Body* a = AddBody(world, dynamicBody, {0.0f, 0.0f});
        Body* b = AddBody(world, dynamicBody, {1.02f, 0.0f});
        AddCircle(a, 0.5f);
        AddCircle(b, 0.5f);
        a->SetLinearVelocity({0.004f, 0.0f});
        b->SetLinearVelocity({-0.004f, 0.0f});
        b->SetTransform({1.0012f, 0.0f}, 0.0f);  // 0.15 s apart
        const int steps = StepsToSleep(world, a, substeps);
        if (substeps > 0) {
            EXPECT_LE(steps, 32);
        } else {
            EXPECT_GE(steps, 36);
        }
    }
}

}  // namespace
}  // namespace scree::test
