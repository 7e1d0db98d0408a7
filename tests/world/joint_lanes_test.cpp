// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Wheel and revolute joints side by side: the bits of solving them one by one, for random cars and figures.

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <random>
#include <vector>

#include "tests/world/random_hinges.h"
#include "world/world_state.h"

namespace scree {
namespace {

using namespace test;

/// A car on bumps of its own: one to four wheels with or without spring, motor and limits, on a body that may be fixed.
class Car {
public:
    Car(World& world, uint32_t seed, float x) : m_random(seed) {
        Body* ground = AddBody(world, staticBody, {x, 0.0f});
        for (int i = -8; i < 8; ++i) {
            EdgeShape edge;
            edge.SetTwoSided({static_cast<float>(i), Any(0.0f, 0.4f)}, {static_cast<float>(i) + 1.0f, Any(0.0f, 0.4f)});
            ground->CreateFixture(&edge, 0.0f)->SetFriction(0.9f);
        }
        const bool isFixed = m_random() % 8 == 0;
        Body* chassis = AddBody(world, isFixed ? staticBody : dynamicBody, {x, 2.0f}, Any(-0.3f, 0.3f));
        AddBox(chassis, 1.2f, 0.25f, Any(0.5f, 3.0f));
        chassis->SetLinearVelocity({Any(-6.0f, 6.0f), Any(-2.0f, 0.0f)});
        m_bodies.push_back(chassis);
        const int count = 1 + static_cast<int>(m_random() % 4);
        for (int i = 0; i < count; ++i) AddWheel(world, {x - 1.0f + 0.7f * static_cast<float>(i), 1.3f});
    }

    /// Of all bodies, and of what the joints do.
    [[nodiscard]] std::vector<uint32_t> GetBits() const {
        std::vector<uint32_t> bits;
        const auto add = [&bits](float x) { bits.push_back(std::bit_cast<uint32_t>(x)); };
        for (const Body* body : m_bodies) {
            add(body->GetPosition().x), add(body->GetPosition().y), add(body->GetAngle());
            add(body->GetLinearVelocity().x), add(body->GetLinearVelocity().y), add(body->GetAngularVelocity());
        }
        for (const WheelJoint* joint : m_joints) {
            const Vec2 force = joint->GetReactionForce(60.0f);
            add(force.x), add(force.y), add(joint->GetMotorTorque(60.0f));
        }
        return bits;
    }
    /// Wheels that are within 2 mm of a limit.
    [[nodiscard]] int CountAtLimits() const {
        int count = 0;
        for (const WheelJoint* joint : m_joints) {
            const float at = joint->GetJointTranslation();
            const float room = Min(at - joint->GetLowerLimit(), joint->GetUpperLimit() - at);
            if (joint->IsLimitEnabled() && room < 0.002f) ++count;
        }
        return count;
    }

private:
    float Any(float low, float high) { return std::uniform_real_distribution<float>(low, high)(m_random); }
    bool OneIn(uint32_t count) { return m_random() % count == 0; }

    void AddWheel(World& world, Vec2 place) {
        Body* wheel = AddBody(world, dynamicBody, place);
        AddCircle(wheel, Any(0.2f, 0.35f))->SetFriction(0.9f);
        WheelJointDef def;
        const Vec2 anchor = place + Vec2{OneIn(4) ? Any(-0.1f, 0.1f) : 0.0f, 0.0f};
        def.Initialize(m_bodies.front(), wheel, anchor, {OneIn(3) ? Any(-0.5f, 0.5f) : 0.0f, 1.0f});
        if (!OneIn(3)) LinearStiffness(def.stiffness, def.damping, Any(2.0f, 8.0f), 0.5f, m_bodies.front(), wheel);
        if (OneIn(3)) def.maxSpringForce = Any(1.0f, 40.0f);
        def.enableMotor = OneIn(2);
        def.motorSpeed = Any(-20.0f, 20.0f);
        def.maxMotorTorque = Any(0.0f, 20.0f);
        def.enableLimit = OneIn(2);
        def.lowerTranslation = Any(-0.2f, 0.0f);
        def.upperTranslation = def.lowerTranslation + Any(0.0f, 0.2f);
        m_joints.push_back(static_cast<WheelJoint*>(world.CreateJoint(&def)));
        m_bodies.push_back(wheel);
    }

    std::mt19937 m_random;
    std::vector<Body*> m_bodies;
    std::vector<WheelJoint*> m_joints;
};

WorldDef MakeDef(int workers) {
    WorldDef def;
    def.gravity = {0.0f, -10.0f};
    def.workerCount = workers;
    return def;
}

/// Boxes on a ground far below: so many that steps are worth sharing.
void AddBallast(World& world) {
    AddBox(AddBody(world, staticBody, {0.0f, -100.0f}), 400.0f, 0.5f);
    for (int i = 0; i < 256; ++i) {
        AddBox(AddBody(world, dynamicBody, {3.0f * static_cast<float>(i - 128), -99.0f}), 0.5f, 0.5f);
    }
}

/// Many cars, and a wheel to spare that turns in the air.
struct Cars {
    /// `oneByOne`: the spare wheel has turned so far that the lanes take none; its cosine and sine matter to nobody.
    Cars(uint32_t seed, bool oneByOne, int workers) : world(MakeDef(workers)) {
        world.SetAllowSleeping(false);
        if (workers > 1) world.GetState().pool->ShareAlways();
        AddBallast(world);
        for (uint32_t i = 0; i < 40; ++i) all.emplace_back(world, 1000 * seed + i, 40.0f * static_cast<float>(i));
        if (workers > 1 && seed % 2 == 1) return;  // a level without what cannot be pushed
        Body* post = AddBody(world, staticBody, {-50.0f, 5.0f});
        Body* wheel = AddBody(world, dynamicBody, {-50.0f, 5.0f}, oneByOne ? 2.0e8f : 0.0f);
        AddCircle(wheel, 0.3f);
        WheelJointDef def;
        def.Initialize(post, wheel, wheel->GetPosition(), {0.0f, 1.0f});
        def.stiffness = 1000.0f, def.damping = 50.0f;
        world.CreateJoint(&def);
    }
    [[nodiscard]] bool AreInLanes() const {
        return !world.GetState().solverScratch.constraints.joints.wheels.IsEmpty();
    }

    World world;
    std::vector<Car> all;
};

/// A figure of two to six limbs, in a tree, whose hinges have limits, motors or springs.
class Figure {
public:
    Figure(World& world, uint32_t seed, float x) : m_draw(seed) {
        Body* ground = AddBody(world, staticBody, {x, 0.0f});
        AddBox(ground, 12.0f, 0.5f);
        m_limbs.push_back(AddLimb(world, {x, 3.0f}, 3.0f, m_draw));
        const uint32_t count = 1 + m_draw.Below(5);
        for (uint32_t i = 0; i < count; ++i) AddHinge(world);
    }
    [[nodiscard]] std::vector<uint32_t> GetBits() const { return test::GetBits(m_limbs, m_joints); }
    [[nodiscard]] int CountAtLimits() const { return test::CountAtLimits(m_joints); }

private:
    void AddHinge(World& world) {
        Body* parent = m_limbs[m_draw.Below(static_cast<uint32_t>(m_limbs.size()))];
        const Vec2 anchor = parent->GetWorldPoint({m_draw.OneIn(2) ? 0.4f : -0.4f, 0.0f});
        const float x = m_draw.Any(-0.4f, 0.4f), y = m_draw.Any(-0.2f, 0.2f);
        m_limbs.push_back(AddLimb(world, anchor + Vec2{x, y}, 3.0f, m_draw));
        RevoluteJointDef def;
        def.Initialize(parent, m_limbs.back(), anchor);
        GiveRange(def, m_draw);
        m_joints.push_back(static_cast<RevoluteJoint*>(world.CreateJoint(&def)));
    }

    Draws m_draw;
    std::vector<Body*> m_limbs;
    std::vector<RevoluteJoint*> m_joints;
};

/// Many figures, and a hinge to spare in the air.
struct Figures {
    /// `oneByOne` as of Cars.
    Figures(uint32_t seed, bool oneByOne, int workers) : world(MakeDef(workers)) {
        world.SetAllowSleeping(false);
        if (workers > 1) world.GetState().pool->ShareAlways();
        AddBallast(world);
        for (uint32_t i = 0; i < 40; ++i) all.emplace_back(world, 1000 * seed + i, 40.0f * static_cast<float>(i));
        if (workers > 1 && seed % 2 == 1) return;  // a level without what cannot be pushed
        Body* post = AddBody(world, staticBody, {-50.0f, 5.0f});
        Body* disk = AddBody(world, dynamicBody, {-50.0f, 5.0f}, oneByOne ? 2.0e8f : 0.0f);
        AddCircle(disk, 0.3f);
        RevoluteJointDef def;
        def.Initialize(post, disk, disk->GetPosition());
        def.enableMotor = true;
        world.CreateJoint(&def);
    }
    [[nodiscard]] bool AreInLanes() const {
        return !world.GetState().solverScratch.constraints.joints.hinges.IsEmpty();
    }

    World world;
    std::vector<Figure> all;
};

/// Six worlds, side by side by one thread and by three, and one by one. Expects so many times that a joint was at its
/// limit.
template <typename Worlds>
void ExpectTheSameBits(int leastAtLimits) {
    int atLimits = 0, inLanes = 0;
    for (uint32_t seed = 0; seed < 6 && !testing::Test::HasFailure(); ++seed) {
        Worlds lanes(seed, false, 1), shared(seed, false, 3), alone(seed, true, 1);
        for (int step = 0; step < 150; ++step) {
            for (Worlds* worlds : {&lanes, &shared, &alone}) worlds->world.Step(frame, 4);
            inLanes += lanes.AreInLanes() ? 1 : 0;  // unless a few go on after a time of impact
            ASSERT_FALSE(alone.AreInLanes());
            for (size_t i = 0; i < lanes.all.size(); ++i) {
                ASSERT_EQ(lanes.all[i].GetBits(), alone.all[i].GetBits())
                    << "seed " << seed << ", step " << step << ", number " << i;
                ASSERT_EQ(shared.all[i].GetBits(), alone.all[i].GetBits())
                    << "three threads, seed " << seed << ", step " << step << ", number " << i;
                atLimits += lanes.all[i].CountAtLimits();
            }
        }
    }
    EXPECT_GT(inLanes, 300);
    EXPECT_GT(atLimits, leastAtLimits);
}

TEST(JointLanes, OfWheelsGiveTheBitsOfOneByOne) { ExpectTheSameBits<Cars>(10000); }
TEST(JointLanes, OfRevoluteJointsGiveTheBitsOfOneByOne) { ExpectTheSameBits<Figures>(5000); }

/// A slider with a motor and limits, and a wheel with a motor, beside nothing and beside many figures.
TEST(JointLanes, LeaveLimitsAndMotorsOfOtherJointsAsTheyAre) {
    int inLanes = 0;
    for (uint32_t seed = 0; seed < 4; ++seed) {
        World alone(MakeDef(1));
        alone.SetAllowSleeping(false);
        AddBallast(alone);
        Figures beside(seed, false, 1);
        struct Others {
            PrismaticJoint* slider;
            WheelJoint* wheel;
        };
        const auto addTo = [&](World& world) {
            Body* post = AddBody(world, staticBody, {-90.0f, 20.0f});
            Body* block = AddBody(world, dynamicBody, {-90.0f, 20.0f});
            AddBox(block, 0.5f, 0.5f);
            PrismaticJointDef def;
            def.Initialize(post, block, block->GetPosition(), {1.0f, 0.0f});
            def.enableLimit = def.enableMotor = true;
            def.lowerTranslation = -0.5f, def.upperTranslation = 1.0f;
            def.motorSpeed = 2.0f, def.maxMotorForce = 100.0f;
            Body* disk = AddBody(world, dynamicBody, {-90.0f, 30.0f});
            AddCircle(disk, 0.5f);
            WheelJointDef turning;
            turning.Initialize(post, disk, disk->GetPosition(), {0.0f, 1.0f});
            turning.enableLimit = turning.enableMotor = true;
            turning.lowerTranslation = -0.1f, turning.upperTranslation = 0.1f;
            turning.motorSpeed = 5.0f, turning.maxMotorTorque = 10.0f;
            return Others{static_cast<PrismaticJoint*>(world.CreateJoint(&def)),
                          static_cast<WheelJoint*>(world.CreateJoint(&turning))};
        };
        const Others one = addTo(alone), other = addTo(beside.world);
        for (int step = 0; step < 90; ++step) {
            alone.Step(frame, 4), beside.world.Step(frame, 4);
            inLanes += beside.AreInLanes() ? 1 : 0;
            ASSERT_NEAR(one.slider->GetJointTranslation(), other.slider->GetJointTranslation(), 1e-4f) << step;
            ASSERT_NEAR(one.wheel->GetJointTranslation(), other.wheel->GetJointTranslation(), 1e-4f) << step;
            ASSERT_NEAR(one.wheel->GetJointAngularSpeed(), other.wheel->GetJointAngularSpeed(), 1e-3f) << step;
        }
        // Motors have driven them as far and as fast as they go, and the limits hold.
        EXPECT_NEAR(one.slider->GetJointTranslation(), 1.0f, 0.02f);
        EXPECT_GT(one.slider->GetMotorForce(60.0f), 50.0f);
        EXPECT_NEAR(one.wheel->GetJointTranslation(), -0.1f, 0.02f);
        EXPECT_NEAR(one.wheel->GetJointAngularSpeed(), 5.0f, 0.1f);
    }
    EXPECT_GT(inLanes, 200);
}

}  // namespace
}  // namespace scree
