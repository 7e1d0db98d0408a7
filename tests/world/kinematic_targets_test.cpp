// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What moves into kinematic bodies is found one by one while these are few, and by a tree of swept boxes otherwise: no
// bit tells which. A far body of many fixtures makes them many.

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

/// Paddles that turn and a lift, among bodies that fall and are shot.
class Mill {
public:
    Mill(uint32_t seed, bool isCrowded) : m_random(seed) {
        AddGround(world);
        for (int i = 0; i < 3; ++i) {
            Body* paddle = AddBody(world, kinematicBody, {6.0f * static_cast<float>(i) - 6.0f, 4.0f});
            AddBox(paddle, 2.0f, 0.05f);
            paddle->SetAngularVelocity(3.0f + static_cast<float>(i));
        }
        Body* lift = AddBody(world, kinematicBody, {0.0f, 9.0f});
        AddBox(lift, 3.0f, 0.02f);
        lift->SetLinearVelocity({0.0f, -4.0f});
        AddBox(AddBody(world, kinematicBody, {12.0f, 1.0f}), 0.02f, 2.0f);  // at rest
        for (int i = 0; i < 120; ++i) {
            Body* body = AddBody(world, dynamicBody, {Number(-12.0f, 12.0f), Number(1.0f, 16.0f)}, Number(0.0f, 3.0f));
            i % 3 == 0 ? AddCircle(body, Number(0.1f, 0.3f)) : AddBox(body, Number(0.1f, 0.4f), 0.1f);
            body->SetLinearVelocity({Number(-40.0f, 40.0f), Number(-30.0f, 10.0f)});
            body->SetAngularVelocity(Number(-20.0f, 20.0f));
            bodies.push_back(body);
        }
        if (!isCrowded) return;
        Body* far = AddBody(world, kinematicBody, {500.0f, 500.0f});
        for (int i = 0; i < 40; ++i) AddCircle(far, 0.1f);
    }
    World world{Vec2{0.0f, -10.0f}};
    std::vector<Body*> bodies;

private:
    float Number(float low, float high) { return low + (high - low) * static_cast<float>(m_random() % 4096) / 4096.0f; }

    std::mt19937 m_random;
};

TEST(KinematicTargets, AreFoundAlikeWhetherTheyAreFewOrMany) {
    for (const int substeps : {0, 4}) {
        for (const float scale : {1.0f, 4.0f}) {
            for (uint32_t seed = 1; seed <= 4; ++seed) {
                Mill few(seed, false), many(seed, true);
                int events = 0;
                for (int step = 0; step < 90; ++step) {
                    for (Mill* mill : {&few, &many}) {
                        const float dt = scale * frame;
                        const StepReport report =
                            substeps == 0 ? mill->world.Step(dt, 8, 3) : mill->world.Step(dt, substeps);
                        if (mill == &few) events += report.continuousEventCount;
                    }
                    for (size_t i = 0; i < few.bodies.size(); ++i) {
                        ASSERT_TRUE(few.bodies[i]->GetPosition() == many.bodies[i]->GetPosition())
                            << substeps << ' ' << seed << ' ' << step << ' ' << i;
                        ASSERT_EQ(few.bodies[i]->GetAngle(), many.bodies[i]->GetAngle());
                    }
                }
                EXPECT_GT(events, 0) << substeps << ' ' << scale << ' ' << seed;
            }
        }
    }
}

}  // namespace
}  // namespace scree::test
