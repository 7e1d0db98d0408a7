// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Finite numbers at the ends of the range. Where nothing can be made of them they are refused by name. Where a state
// runs out of bounds during a step, its body is put back and counted. No state, box or other body is ever not finite.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <string>

#include "tests/world/fixtures.h"
#include "tests/world/random_pair.h"

namespace scree::test {
namespace {

constexpr float largest = std::numeric_limits<float>::max();
constexpr float smallest = std::numeric_limits<float>::denorm_min();

void ExpectFinite(World& world) {
    for (Body* body = world.GetBodyList(); body; body = body->GetNext()) {
        EXPECT_TRUE(body->GetPosition().IsValid() && body->GetLinearVelocity().IsValid());
        EXPECT_TRUE(std::isfinite(body->GetAngle()) && std::isfinite(body->GetAngularVelocity()));
        for (Fixture* fixture = body->GetFixtureList(); fixture; fixture = fixture->GetNext()) {
            const AABB box = fixture->GetAABB();
            EXPECT_TRUE(box.lowerBound.IsValid() && box.upperBound.IsValid());
        }
    }
}

class ExtremeNumbers : public ::testing::Test {
protected:
    ExtremeNumbers() : world({0.0f, -10.0f}), errors(world) {
        AddGround(world);
        box = AddBody(world, dynamicBody, {0, 0.5f});
        AddBox(box, 0.5f, 0.5f);
        StepFor(world, 3);
    }

    template <typename Call>
    void ExpectRefused(const char* field, Call&& call) {
        const uint64_t before = inspect::GetStateHash(world);
        const int count = errors.count;
        call();
        EXPECT_EQ(errors.count, count + 1) << field;
        EXPECT_EQ(errors.last.code, ErrorCode::outOfRange) << field;
        EXPECT_STREQ(errors.last.field, field);
        EXPECT_EQ(inspect::GetStateHash(world), before) << field;
    }

    World world;
    ErrorLog errors;
    Body* box;
};

TEST_F(ExtremeNumbers, PlacesAndSpeedsBeyondAllBoundsAreRefused) {
    BodyDef def;
    def.position = {largest, 0};
    ExpectRefused("BodyDef::position", [&] { EXPECT_EQ(world.CreateBody(&def), nullptr); });
    def = {};
    def.linearVelocity = {0, -largest};
    ExpectRefused("BodyDef::linearVelocity", [&] { EXPECT_EQ(world.CreateBody(&def), nullptr); });
    def = {};
    def.angularVelocity = largest;
    ExpectRefused("BodyDef::angularVelocity", [&] { EXPECT_EQ(world.CreateBody(&def), nullptr); });
    ExpectRefused("position", [&] { box->SetTransform({0, largest}, 0); });
    ExpectRefused("v", [&] { box->SetLinearVelocity({largest, 0}); });
    ExpectRefused("omega", [&] { box->SetAngularVelocity(largest); });
    ExpectRefused("impulse", [&] { box->ApplyLinearImpulse({largest, 0}, {0, 0}, true); });
    ExpectRefused("impulse", [&] { box->ApplyLinearImpulseToCenter({largest, 0}, true); });
    ExpectRefused("impulse", [&] { box->ApplyAngularImpulse(largest, true); });
    box->ApplyForceToCenter({largest, 0}, true);
    ExpectRefused("force", [&] { box->ApplyForceToCenter({largest, 0}, true); });
    ExpectRefused("force", [&] { box->ApplyForce({0, largest}, {2e20f, 0}, true); });
    box->ApplyTorque(largest, true);
    ExpectRefused("torque", [&] { box->ApplyTorque(largest, true); });
}

TEST_F(ExtremeNumbers, MassesWithoutAUsableInverseAreRefused) {
    CircleShape circle;
    circle.m_radius = 0.5f;
    ExpectRefused("FixtureDef::density", [&] { EXPECT_EQ(box->CreateFixture(&circle, smallest), nullptr); });
    ExpectRefused("FixtureDef::density", [&] { EXPECT_EQ(box->CreateFixture(&circle, largest), nullptr); });
    ExpectRefused("density", [&] { box->GetFixtureList()->SetDensity(smallest); });
    MassData data{smallest, {0, 0}, 1.0f};
    ExpectRefused("MassData::mass", [&] { box->SetMassData(&data); });
    data = {1.0f, {0, 0}, smallest};
    ExpectRefused("MassData::I", [&] { box->SetMassData(&data); });
    circle.m_radius = largest;
    ExpectRefused("Shape::m_radius", [&] { EXPECT_EQ(box->CreateFixture(&circle, 0), nullptr); });
    circle = {};
    circle.m_radius = 1.0f;
    circle.m_p = {largest, 0};
    ExpectRefused("CircleShape::m_p", [&] { EXPECT_EQ(box->CreateFixture(&circle, 0), nullptr); });
}

TEST_F(ExtremeNumbers, AMassOfTheSmallestInertiaDoesNotTurn) {
    // Mass 1e-30·…, inertia below the smallest number: no turning, and nothing that is not finite.
    Body* dust = AddBody(world, dynamicBody, {0, 5});
    CircleShape grain;
    grain.m_radius = 1e-8f;
    ASSERT_NE(dust->CreateFixture(&grain, 1e-14f), nullptr);
    EXPECT_GT(dust->GetMass(), 0.0f);
    dust->SetAngularVelocity(1.0f);
    const StepReport report = StepFor(world, 120);
    EXPECT_EQ(report.nonFiniteCount, 0);
    ExpectFinite(world);
}

TEST_F(ExtremeNumbers, WhatLeavesAllBoundsIsPutBackAndCounted) {
    for (const bool soft : {false, true}) {
        const Vec2 before = box->GetPosition();
        box->ApplyForceToCenter({1e30f, 0}, true);
        const StepReport report = StepWith(world, soft ? 4 : 0);
        EXPECT_EQ(report.nonFiniteCount, 1);
        EXPECT_EQ(box->GetPosition(), before);
        EXPECT_EQ(box->GetLinearVelocity(), Vec2(0, 0));
        ExpectFinite(world);
        EXPECT_EQ(StepFor(world, 60).nonFiniteCount, 0) << "the world goes on";
        EXPECT_NEAR(box->GetPosition().y, 0.515f, 0.01f);
    }
}

TEST_F(ExtremeNumbers, OneThatBlowsUpLeavesTheGroundAndItsNeighboursAlone) {
    // Masses of 1e30 kg a hundred metres off their body's origin: impulses overflow as soon as it touches the ground.
    Body* monster = AddBody(world, dynamicBody, {30, 2}, 0.2f);
    PolygonShape shape;
    shape.SetAsBox(1, 1, {0, 0}, 0);
    monster->CreateFixture(&shape, 2e29f);
    monster->SetLinearVelocity({0, -1e17f});
    Body* neighbour = AddBody(world, dynamicBody, {-30, 10});
    AddBox(neighbour, 0.5f, 0.5f);
    int stopped = 0;
    for (int i = 0; i < 30; ++i) stopped += world.Step(1.0f / 60.0f, 8, 3).nonFiniteCount;
    EXPECT_GT(stopped, 0);
    ExpectFinite(world);
    EXPECT_NEAR(neighbour->GetPosition().y, 10.0f - 0.5f * 10.0f * 0.25f, 0.1f) << "falls on as if nothing had been";
    EXPECT_NEAR(box->GetPosition().y, 0.515f, 0.01f);
}

TEST_F(ExtremeNumbers, AStepTooShortToDivideByChangesNothing) {
    const Vec2 before = box->GetPosition();
    for (const float dt : {smallest, 1e-38f, 9e-31f}) {
        world.Step(dt, 8, 3);
        world.Step(dt, 4);
        EXPECT_EQ(box->GetPosition(), before);
    }
    StepFor(world, 60);
    EXPECT_NEAR(box->GetPosition().y, 0.515f, 0.01f);
    ExpectFinite(world);
}

TEST_F(ExtremeNumbers, ImpulsesOfAMuchShorterStepAreNotScaledUp) {
    // A fall stopped within a step of a microsecond: its impulse, times 16,667, would shoot the box up with 10⁵ m/s.
    for (const bool soft : {false, true}) {
        box->SetTransform({0, 0.5f + 0.015f}, 0);
        box->SetLinearVelocity({0, -7});
        soft ? world.Step(1e-6f, 4) : world.Step(1e-6f, 8, 3);
        for (int i = 0; i < 5; ++i) StepWith(world, soft ? 4 : 0);
        EXPECT_LT(box->GetLinearVelocity().Length(), 1.0f) << soft;
        EXPECT_NEAR(box->GetPosition().y, 0.515f, 0.05f) << soft;
    }
}

/// Slides of two bodies whose anchors lie `anchor` away, turned by `angle`.
template <typename Def>
void SlideFarAway(World& world, Body* a, Body* b, Vec2 anchor, float angle) {
    Def def;
    def.bodyA = a, def.bodyB = b;
    def.localAnchorA = anchor, def.localAnchorB = -anchor;
    def.localAxisA = {std::cos(angle), std::sin(angle)};
    def.enableLimit = true, def.lowerTranslation = -1.0f, def.upperTranslation = 1.0f;
    ASSERT_NE(world.CreateJoint(&def), nullptr);
}

TEST_F(ExtremeNumbers, AWorldWithAnchorsBeyondAllPlacesIsSavedAndLoaded) {
    // The gap of such anchors is no number, and what was noted of it for the next step's number of sub-steps was none.
    std::mt19937 random(20);
    const auto uniform = [&](float low, float high) { return std::uniform_real_distribution(low, high)(random); };
    for (int round = 0; round < 20; ++round) {
        World wide({0.0f, -10.0f});
        Body* bodies[3];
        for (int i = 0; i < 3; ++i) {
            bodies[i] = AddBody(wide, dynamicBody, {2.0f * static_cast<float>(i), uniform(-1.0f, 1.0f)});
            AddBox(bodies[i], 0.5f, 0.5f);
        }
        const Vec2 anchor{largest * uniform(-1.0f, 1.0f), largest * uniform(-1.0f, 1.0f)};
        SlideFarAway<WheelJointDef>(wide, bodies[0], bodies[1], anchor, uniform(0.0f, 6.0f));
        SlideFarAway<PrismaticJointDef>(wide, bodies[1], bodies[2], {anchor.y, anchor.x}, uniform(0.0f, 6.0f));
        wide.SetMeasureErrors(true);
        for (int i = 0; i < 4; ++i) {
            wide.Step(1.0f / 60.0f, Tolerance{});
            EXPECT_FALSE(std::isnan(wide.GetReport().errors.jointGap));
            ExpectFinite(wide);
            SnapshotError error{};
            const std::unique_ptr<World> loaded = LoadWorld(SaveWorld(wide), &error);
            ASSERT_NE(loaded, nullptr) << round << ", step " << i << ": " << GetName(error);
            EXPECT_EQ(inspect::GetStateHash(*loaded), inspect::GetStateHash(wide));
        }
    }
}

/// What is put back begins anew: no force of the step that is lost acts on in the next one.
class LostSteps : public ::testing::Test {
protected:
    /// A force beyond all numbers, then a step without it. False if the world bore it.
    bool Lose(World& world, bool soft, Body* a, Body* b) {
        const auto huge = [&] { return (m_random() % 2 == 0 ? 1.0f : -1.0f) * std::pow(10.0f, Between(30.0f, 38.0f)); };
        for (Body* const body : {a, b}) {
            body->ApplyForceToCenter({huge(), huge()}, true);
            body->ApplyTorque(huge(), true);
        }
        const Vec2 start = a->GetPosition();
        if (StepWith(world, soft ? 4 : 0).nonFiniteCount < 2) return false;
        EXPECT_EQ(a->GetPosition(), start);
        for (Joint* joint = world.GetJointList(); joint != nullptr; joint = joint->GetNext()) {
            EXPECT_EQ(joint->GetReactionForce(60.0f), Vec2(0, 0));
            EXPECT_EQ(joint->GetReactionTorque(60.0f), 0.0f);
        }
        broken += static_cast<int>(world.GetEvents().joints.size());
        EXPECT_EQ(StepWith(world, soft ? 4 : 0).nonFiniteCount, 0);
        for (Body* const body : {a, b}) {
            EXPECT_LT(body->GetLinearVelocity().Length(), 1e3f);
            EXPECT_LT(std::abs(body->GetAngularVelocity()), 1e3f);
        }
        return true;
    }
    float Between(float from, float to) { return std::uniform_real_distribution<float>(from, to)(m_random); }

    const unsigned m_seed = std::random_device{}();
    const ::testing::ScopedTrace m_trace{__FILE__, __LINE__, "seed " + std::to_string(m_seed)};
    std::mt19937 m_random{m_seed};
    int broken = 0;  ///< joints
};

TEST_F(LostSteps, LeaveNoForceInJoints) {
    constexpr int kinds = kindsOfPairs - 1;  // all but those alone
    int lost = 0, watched = 0;
    for (int round = 0; round < 100 * kinds; ++round) {
        const int kind = round % kinds;
        const bool soft = round % (2 * kinds) >= kinds;
        SCOPED_TRACE("kind " + std::to_string(kind) + (soft ? ", soft" : ""));
        World world({0.0f, -10.0f});
        BodyDef ground;
        const RandomPair pair(world, world.CreateBody(&ground), {}, kind, m_random);
        StepWith(world, soft ? 4 : 0);
        const bool breaks = m_random() % 4 == 0;
        if (breaks) pair.joint->SetThresholds(1e20f, 1e20f, true);
        if (!Lose(world, soft, pair.a, pair.b)) continue;
        ++lost, watched += breaks ? 1 : 0;
        if (HasFailure()) return;
    }
    EXPECT_GT(lost, 50 * kinds);
    EXPECT_GT(broken, watched / 2) << "what pulls beyond all numbers breaks a joint";
}

TEST_F(LostSteps, LeaveNoForceInContacts) {
    int lost = 0;
    for (int round = 0; round < 200; ++round) {
        const bool soft = round % 2 == 0;
        World world({0.0f, -10.0f});
        AddGround(world);
        Body* pair[2] = {};
        for (int i = 0; i < 2; ++i) {
            pair[i] = AddBody(world, dynamicBody, {static_cast<float>(i), 0.5f});
            CircleShape shape;
            shape.m_radius = 0.5f;
            FixtureDef def;
            def.shape = &shape, def.density = Between(0.1f, 10.0f), def.rollingResistance = 0.1f;
            pair[i]->CreateFixture(&def);
        }
        StepWith(world, soft ? 4 : 0, 3);
        lost += Lose(world, soft, pair[0], pair[1]) ? 1 : 0;
        if (HasFailure()) return;
    }
    EXPECT_GT(lost, 100);
}

/// Impulses of joints that pull beyond all numbers may be none: the image holds 0 for them, as the next step does.
TEST(ExtremeJoints, OfAnyNumbersAreSavedAndLoaded) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto below = [&](int end) { return static_cast<int>(random() % static_cast<unsigned>(end)); };
    const auto number = [&] {
        const int kind = below(6);
        if (kind == 0) return largest * static_cast<float>(below(201) - 100) / 100.0f;
        if (kind == 1) return std::ldexp(static_cast<float>(below(3) - 1), below(250) - 125);
        return static_cast<float>(below(200) - 100) / 8.0f;
    };
    const auto point = [&] { return Vec2{number(), number()}; };
    int made = 0;
    for (int round = 0; round < 3000; ++round) {
        World wide({static_cast<float>(below(20)), -10.0f});
        ErrorLog errors(wide);
        Body* bodies[3] = {};
        for (Body*& body : bodies) {
            BodyDef def;
            def.type = static_cast<BodyType>(below(3));
            def.position = {static_cast<float>(below(20)), static_cast<float>(below(20))};
            def.linearVelocity = point();
            body = wide.CreateBody(&def);
            if (body == nullptr) break;
            AddBox(body, 0.5f, 0.5f);
        }
        if (bodies[2] == nullptr) continue;
        const auto add = [&](auto def) {
            if constexpr (requires { def.enableMotor; }) def.enableMotor = below(2) == 0, def.motorSpeed = number();
            if constexpr (requires { def.enableLimit; }) def.enableLimit = below(2) == 0;
            if constexpr (requires { def.lowerTranslation; }) {
                def.lowerTranslation = number(), def.upperTranslation = number();
            }
            if constexpr (requires { def.stiffness; }) def.stiffness = number(), def.damping = number();
            def.localAnchorA = point(), def.localAnchorB = point();
            def.bodyA = bodies[0], def.bodyB = bodies[1 + below(2)];
            made += wide.CreateJoint(&def) != nullptr ? 1 : 0;
        };
        for (int i = 0; i < 2; ++i) {
            switch (below(6)) {
                case 0:
                    add(RevoluteJointDef());
                    break;
                case 1:
                    add(PrismaticJointDef());
                    break;
                case 2:
                    add(DistanceJointDef());
                    break;
                case 3:
                    add(WheelJointDef());
                    break;
                case 4:
                    add(WeldJointDef());
                    break;
                default:
                    add(PulleyJointDef());
            }
        }
        for (int i = 0; i < 4; ++i) {
            i % 2 == 0 ? wide.Step(1.0f / 60.0f, 4) : wide.Step(1.0f / 60.0f, 8, 3);
            SnapshotError error{};
            const std::unique_ptr<World> loaded = LoadWorld(SaveWorld(wide), &error);
            ASSERT_NE(loaded, nullptr) << GetName(error);
            ASSERT_EQ(inspect::GetStateHash(*loaded), inspect::GetStateHash(wide));
        }
    }
    EXPECT_GT(made, 50);
}

TEST_F(ExtremeNumbers, MaterialsMixToFiniteOnes) {
    EXPECT_TRUE(std::isfinite(MixFriction(largest, largest)));
    EXPECT_EQ(MixFriction(0.25f, 1.0f), 0.5f);
    EXPECT_EQ(MixRestitution(-1.0f, -0.5f), 0.0f) << "what hits does not sink in";
    EXPECT_EQ(MixRestitution(-1.0f, 0.5f), 0.5f);
    Body* rough = AddBody(world, dynamicBody, {3, 3}, 0.3f);
    Fixture* fixture = AddBox(rough, 0.5f, 0.5f);
    fixture->SetFriction(largest);
    fixture->SetRestitution(-1.0f);
    for (Body* b = world.GetBodyList(); b; b = b->GetNext()) b->GetFixtureList()->SetFriction(largest);
    EXPECT_EQ(StepFor(world, 200).nonFiniteCount, 0);
    EXPECT_NEAR(rough->GetPosition().y, 0.515f, 0.02f);
    ExpectFinite(world);
}

/// A ball hits a wall within a step and leaves along it at once. The way after the impact is capped, and that is
/// counted as the way before it is.
TEST(SpeedCap, IsCountedAfterAnImpactToo) {
    for (const float cap : {std::numeric_limits<float>::infinity(), 3.0f}) {
        WorldDef def;
        def.gravity = {0, 0};
        def.maxTranslation = cap;
        World world(def);
        AddBox(AddBody(world, staticBody, {10.5f, 0}), 0.5f, 1000.0f, 0.0f);
        Body* ball = AddBody(world, dynamicBody, {8.5f, 0});
        AddCircle(ball, 0.5f)->SetRestitution(20.0f);
        ball->SetLinearVelocity(
            {120, 0});  // 2 m a step: below the cap until the wall throws it back twenty times as fast
        const StepReport report = world.Step(1.0f / 60.0f, 8, 3);
        EXPECT_GE(report.continuousEventCount, 1);
        EXPECT_EQ(report.cappedCount, cap > 3.0f ? 0 : 1);
        EXPECT_LT(ball->GetLinearVelocity().x, -300.0f);
    }
}

}  // namespace
}  // namespace scree::test
