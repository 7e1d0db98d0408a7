// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Contacts that go on while their bodies turn together: normals and arms turn with them. And steps of unequal length.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

/// A box on a platform that is tilted from level to `end` in three seconds. Returns the tilt at which it has slid by
/// 1 cm, or `end`.
float FindSlope(int substeps, float friction, float end, float size) {
    World world({0.0f, -10.0f});
    Body* platform = AddBody(world, kinematicBody, {0.0f, 0.0f});
    AddBox(platform, 50.0f, 0.5f)->SetFriction(friction);
    Body* box = AddBody(world, dynamicBody, {0.0f, 0.5f + size + (substeps == 0 ? 0.015f : 0.0f)});
    box->SetSleepingAllowed(false);
    AddBox(box, size, size)->SetFriction(friction);
    StepWith(world, substeps, 20);
    platform->SetAngularVelocity(end / 3.0f);
    for (int step = 0; step < 180; ++step) {
        StepWith(world, substeps);
        if (Abs(platform->GetLocalPoint(box->GetPosition()).x) > 0.01f) return platform->GetAngle();
    }
    return end;
}

TEST(TurningContacts, ABoxSlidesOffAGroundThatIsTiltedUnderIt) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> share(0.0f, 1.0f);
    for (int i = 0; i < 20; ++i) {
        const float friction = 0.12f * share(random), size = 0.2f + 0.6f * share(random);
        const float slope = std::atan(friction), end = slope + 0.07f;
        const float rigid = FindSlope(0, friction, end, size);
        EXPECT_GT(rigid, slope - 0.002f) << "friction " << friction;
        EXPECT_LT(rigid, slope + 0.04f) << "friction " << friction;
        for (const int substeps : {1, 4, 16}) {
            EXPECT_NEAR(FindSlope(substeps, friction, end, size), rigid, 0.02f)
                << substeps << " sub-steps, friction " << friction;
        }
    }
}

/// A pyramid at rest under steps between these lengths, s. Returns how far a box has moved at most.
float FindShift(int substeps, float shortest, float longest, uint32_t seed) {
    constexpr int base = 8;
    World world({0.0f, -10.0f});
    AddGround(world);
    std::vector<Body*> boxes;
    for (int row = 0; row < base; ++row) {
        for (int i = 0; i < base - row; ++i) {
            const float x = 1.1f * (static_cast<float>(i) - 0.5f * static_cast<float>(base - 1 - row));
            boxes.push_back(AddBody(world, dynamicBody, {x, 0.5f + static_cast<float>(row)}));
            boxes.back()->SetSleepingAllowed(false);
            AddBox(boxes.back(), 0.5f, 0.5f);
        }
    }
    std::vector<Vec2> start;
    for (const Body* box : boxes) start.push_back(box->GetPosition());
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> logarithm(std::log(shortest), std::log(longest));
    for (float time = 0.0f; time < 4.0f;) {
        const float step = std::exp(logarithm(random));
        world.Step(step, substeps);
        time += step;
    }
    float shift = 0.0f;
    for (std::size_t i = 0; i < boxes.size(); ++i) shift = Max(shift, (boxes[i]->GetPosition() - start[i]).Length());
    return shift;
}

TEST(UnequalSteps, ThrowNoPileOfTheSoftStep) {
    for (const uint32_t seed : {1u, 2u, 3u}) {
        EXPECT_LT(FindShift(4, 1e-4f, 0.05f, seed), 0.1f) << seed;
        EXPECT_LT(FindShift(8, 1e-4f, 0.05f, seed), 0.1f) << seed;
    }
}

}  // namespace
}  // namespace scree::test
