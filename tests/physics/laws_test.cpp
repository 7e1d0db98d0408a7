// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Laws of mechanics that sequential impulses at 8/3 iterations and 60 Hz must meet, each against its closed form.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

constexpr float h = 1.0f / 60.0f;
constexpr double g = 10.0;

TEST(Laws, AProjectileFollowsTheDiscreteParabola) {
    // Semi-implicit Euler: y(n) = y0 + v0·n·h − g·h²·n(n+1)/2, exactly, so only float rounding remains.
    World world({0.0f, -10.0f});
    Body* ball = AddBody(world, dynamicBody, {0, 0});
    AddCircle(ball, 0.1f);
    ball->SetLinearVelocity({10, 20});
    const int steps = 240;
    StepFor(world, steps);
    const double t = steps / 60.0;
    EXPECT_NEAR(ball->GetPosition().x, 10.0 * t, 1e-3);
    EXPECT_NEAR(ball->GetPosition().y, 20.0 * t - g * steps * (steps + 1) / 2.0 / 3600.0, 1e-3);
}

TEST(Laws, FreeSpinKeepsItsRate) {
    World world({0.0f, 0.0f});
    Body* box = AddBody(world, dynamicBody, {0, 0});
    AddBox(box, 0.5f, 0.2f);
    box->SetAngularVelocity(20.0f);
    StepFor(world, 600);
    EXPECT_NEAR(box->GetAngle(), 200.0, 200.0 * 1e-5);  // 600 additions in float
}

TEST(Laws, DiskCollisionsKeepMomentumAndFollowRestitution) {
    for (const float ratio : {1.0f, 10.0f, 1000.0f}) {
        for (const float e : {0.0f, 0.5f, 1.0f}) {
            World world({0.0f, 0.0f});
            Body* light = AddBody(world, dynamicBody, {-2.0f, 0.0f});
            Body* heavy = AddBody(world, dynamicBody, {0.0f, 0.0f});
            for (Body* body : {light, heavy}) {
                CircleShape circle;
                circle.m_radius = 0.5f;
                FixtureDef def;
                def.shape = &circle;
                def.density = body == heavy ? ratio : 1.0f;
                def.friction = 0.0f;
                def.restitution = e;
                body->CreateFixture(&def);
            }
            light->SetLinearVelocity({5.0f, 0.0f});
            world.SetAllowSleeping(false);  // a heavy disk creeping below 1 cm/s must not be put to rest
            const double m1 = light->GetMass(), m2 = heavy->GetMass();
            StepFor(world, 60);
            const double v1 = light->GetLinearVelocity().x, v2 = heavy->GetLinearVelocity().x;
            EXPECT_NEAR(m1 * v1 + m2 * v2, m1 * 5.0, m1 * 5.0 * 1e-5);
            EXPECT_NEAR(v2 - v1, e * 5.0, 5.0 * 1e-4) << "mass ratio " << ratio << ", e " << e;
        }
    }
}

TEST(Laws, ABoxOnAnInclineSticksOrSlidesByItsFriction) {
    const double alpha = std::atan(0.5);
    for (const double factor : {0.8, 1.2}) {
        World world({0.0f, -10.0f});
        Body* ramp = AddBody(world, staticBody, {0, 0}, static_cast<float>(alpha));
        Fixture* surface = AddBox(ramp, 50.0f, 0.5f, 0.0f);
        const auto mu = static_cast<float>(0.5 * factor);
        surface->SetFriction(mu);
        Body* box = AddBody(world, dynamicBody,
                            {static_cast<float>(-std::sin(alpha) * 1.01), static_cast<float>(std::cos(alpha) * 1.01)},
                            static_cast<float>(alpha));
        AddBox(box, 0.5f, 0.5f)->SetFriction(mu);
        world.SetAllowSleeping(false);
        StepFor(world, 60);
        const Vec2 settled = box->GetPosition();
        StepFor(world, 60);
        const Vec2 v = box->GetLinearVelocity();
        const double speed = std::hypot(v.x, v.y);
        if (factor > 1.0) {
            EXPECT_LT(Distance(box->GetPosition(), settled), 1e-3) << "creep";
        } else {
            const double a = g * (std::sin(alpha) - mu * std::cos(alpha));
            EXPECT_NEAR(speed, a * 2.0, a * 2.0 * 0.02);
        }
    }
}

TEST(Laws, SlidingStopsAfterVSquaredOver2MuG) {
    World world({0.0f, -10.0f});
    AddGround(world)->GetFixtureList()->SetFriction(0.5f);
    Body* box = AddBody(world, dynamicBody, {0, 0.5f});
    AddBox(box, 0.5f, 0.5f)->SetFriction(0.5f);
    StepFor(world, 30);  // settle
    const float x0 = box->GetPosition().x;
    box->SetLinearVelocity({8, 0});
    StepFor(world, 180);
    EXPECT_NEAR(box->GetPosition().x - x0, 64.0 / (2.0 * 0.5 * g), 6.4 * 0.02);
}

TEST(Laws, BouncesReachESquaredOfTheHeight) {
    for (const float e : {0.3f, 0.6f, 0.9f}) {
        World world({0.0f, -10.0f});
        AddGround(world);
        Body* ball = AddBody(world, dynamicBody, {0, 5.5f});
        AddCircle(ball, 0.5f)->SetRestitution(e);
        float apex = 0.0f;
        bool bounced = false;
        for (int i = 0; i < 240; ++i) {
            StepFor(world, 1);
            if (ball->GetLinearVelocity().y > 0.0f) bounced = true;
            if (bounced) apex = Max(apex, ball->GetPosition().y - 0.5f);
            if (bounced && ball->GetLinearVelocity().y < -1.0f) break;
        }
        // Discrete contact loses up to one step of fall: h·v of the 5 m drop.
        EXPECT_NEAR(apex / 5.0, e * e, 0.05) << "e " << e;
    }
}

TEST(Laws, AColumnOfTenCarriesItsWeight) {
    World world({0.0f, -10.0f});
    AddGround(world);
    std::vector<Body*> boxes;
    for (int i = 0; i < 10; ++i) {
        boxes.push_back(AddBody(world, dynamicBody, {0, 0.5f + static_cast<float>(i)}));
        AddBox(boxes.back(), 0.5f, 0.5f);
    }
    world.SetAllowSleeping(false);
    StepFor(world, 120);
    std::vector<double> force(10, 0.0);
    const int window = 30;
    for (int i = 0; i < window; ++i) {
        StepFor(world, 1);
        for (Contact* c = world.GetContactList(); c; c = c->GetNext()) {
            // The upper body of the contact tells the interface.
            const float yA = c->GetFixtureA()->GetBody()->GetPosition().y,
                        yB = c->GetFixtureB()->GetBody()->GetPosition().y;
            const auto level = static_cast<size_t>(std::lround(Max(yA, yB) - 0.5f));
            for (int p = 0; p < c->GetManifold()->pointCount; ++p)
                force[level] += c->GetManifold()->points[p].normalImpulse / h;
        }
    }
    for (size_t level = 0; level < 10; ++level) {
        const double expected = static_cast<double>(10 - level) * g;
        EXPECT_NEAR(force[level] / window, expected, expected * 0.02) << "interface " << level;
    }
    for (size_t i = 0; i < 10; ++i) EXPECT_NEAR(boxes[i]->GetPosition().x, 0.0, 1e-3);
}

TEST(Laws, AMotorReachesItsSpeedAndALimitHolds) {
    World world({0.0f, 0.0f});
    Body* hub = AddBody(world, staticBody, {0, 0});
    Body* arm = AddBody(world, dynamicBody, {1, 0});
    AddBox(arm, 1.0f, 0.1f);
    RevoluteJointDef def;
    def.Initialize(hub, arm, {0, 0});
    def.enableMotor = true;
    def.motorSpeed = 2.0f;
    def.maxMotorTorque = 100.0f;
    def.enableLimit = true;
    def.lowerAngle = -1.0f;
    def.upperAngle = 1.5f;
    auto* joint = static_cast<RevoluteJoint*>(world.CreateJoint(&def));
    StepFor(world, 20);
    EXPECT_NEAR(joint->GetJointSpeed(), 2.0f, 1e-3f);  // the point block runs after the motor and disturbs it a little
    StepFor(world, 120);
    EXPECT_NEAR(joint->GetJointAngle(), 1.5f, angularSlop);
    joint->SetMotorSpeed(-2.0f);
    StepFor(world, 240);
    EXPECT_NEAR(joint->GetJointAngle(), -1.0f, angularSlop);
}

}  // namespace
}  // namespace scree::test
