// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Whole revolute joints of an island side by side: the bits of solving them one by one, for random structures.

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <random>
#include <vector>

#include "tests/world/fixtures.h"
#include "world/world_state.h"

namespace scree {
namespace {

using namespace test;

/// One island: a tree of limbs on hinges, with some loops. It hangs on what stands still and on what moves on its own,
/// and lies on the ground. Hinges have limits, motors and springs, or nothing.
class Structure {
public:
    /// `oneByOne`: a disk in it has turned so far that lanes take none. Its cosine and sine matter to nobody.
    Structure(uint32_t seed, bool oneByOne) : m_random(seed) {
        m_plainShare = static_cast<uint32_t>(m_random() % 4);
        world.SetAllowSleeping(false);
        Body* ground = AddBody(world, staticBody, {0.0f, -6.0f});
        AddBox(ground, 60.0f, 0.5f);
        m_bodies.push_back(AddBody(world, dynamicBody, {0.0f, 0.0f}));
        AddBox(m_bodies.front(), 0.4f, 0.2f);
        const uint32_t count = 30 + m_random() % 120;
        for (uint32_t i = 0; i < count; ++i) AddLimb();
        for (uint32_t i = 0; i < count / 16; ++i) AddLoop();
        Body* post = AddBody(world, staticBody, m_bodies.front()->GetPosition());
        if (OneIn(2)) AddHinge(post, m_bodies.front(), post->GetPosition());
        Body* crank = AddBody(world, kinematicBody, m_bodies.back()->GetPosition());
        crank->SetAngularVelocity(Any(-3.0f, 3.0f)), crank->SetLinearVelocity({Any(-1.0f, 1.0f), Any(0.0f, 1.0f)});
        if (OneIn(2)) AddHinge(m_bodies.back(), crank, crank->GetWorldPoint({0.1f, 0.0f}));
        Body* disk = AddBody(world, dynamicBody, m_bodies.front()->GetPosition(), oneByOne ? 2.0e8f : 0.0f);
        Filter untouched;
        untouched.maskBits = 0;
        AddCircle(disk, 0.3f)->SetFilterData(untouched);
        RevoluteJointDef def;
        def.Initialize(m_bodies.front(), disk, disk->GetPosition());
        world.CreateJoint(&def);
    }

    /// Of all limbs, and of what the joints do.
    [[nodiscard]] std::vector<uint32_t> GetBits() const {
        std::vector<uint32_t> bits;
        const auto add = [&bits](float x) { bits.push_back(std::bit_cast<uint32_t>(x)); };
        for (const Body* body : m_bodies) {
            add(body->GetPosition().x), add(body->GetPosition().y), add(body->GetAngle());
            add(body->GetLinearVelocity().x), add(body->GetLinearVelocity().y), add(body->GetAngularVelocity());
        }
        for (const RevoluteJoint* joint : m_joints) {
            const Vec2 force = joint->GetReactionForce(60.0f);
            add(force.x), add(force.y), add(joint->GetReactionTorque(60.0f)), add(joint->GetMotorTorque(60.0f));
        }
        return bits;
    }
    [[nodiscard]] bool IsInLanes() const {
        return !world.GetState().solverScratch.islandRows[0].joints.wholeHinges.IsEmpty();
    }
    /// Hinges out of their range, or within a milliradian of an end.
    [[nodiscard]] int CountAtLimits() const {
        int count = 0;
        for (const RevoluteJoint* joint : m_joints) {
            const float at = joint->GetJointAngle();
            const float room = Min(at - joint->GetLowerLimit(), joint->GetUpperLimit() - at);
            if (joint->IsLimitEnabled() && room < 0.001f) ++count;
        }
        return count;
    }
    /// As a game turns things on and off: what they have kept is forgotten.
    void Change() {
        RevoluteJoint* joint = m_joints[m_random() % m_joints.size()];
        if (OneIn(3)) joint->EnableLimit(!joint->IsLimitEnabled());
        if (OneIn(3)) joint->EnableMotor(!joint->IsMotorEnabled());
    }

    World world{{0.0f, -10.0f}};

private:
    float Any(float low, float high) { return std::uniform_real_distribution<float>(low, high)(m_random); }
    bool OneIn(uint32_t count) { return m_random() % count == 0; }
    static void FilterOut(Fixture* fixture) {
        Filter filter;
        filter.groupIndex = -1;
        fixture->SetFilterData(filter);
    }

    void AddLimb() {
        Body* parent = m_bodies[m_random() % m_bodies.size()];
        const Vec2 anchor = parent->GetWorldPoint({OneIn(2) ? 0.4f : -0.4f, 0.0f});
        Body* limb = AddBody(world, dynamicBody, anchor + Vec2{Any(-0.4f, 0.4f), Any(-0.2f, 0.2f)}, Any(-0.5f, 0.5f));
        FilterOut(AddBox(limb, Any(0.2f, 0.5f), Any(0.1f, 0.2f), Any(0.5f, 30.0f)));
        limb->SetAngularVelocity(Any(-4.0f, 4.0f));
        if (OneIn(10)) limb->SetFixedRotation(true);
        AddHinge(parent, limb, anchor);
        m_bodies.push_back(limb);
    }
    void AddLoop() {
        Body* a = m_bodies[m_random() % m_bodies.size()];
        Body* b = m_bodies[m_random() % m_bodies.size()];
        if (a != b) AddHinge(a, b, a->GetWorldPoint({0.2f, 0.1f}));
    }
    void AddHinge(Body* a, Body* b, Vec2 anchor) {
        RevoluteJointDef def;
        def.Initialize(a, b, anchor);
        if (OneIn(1 + m_plainShare)) {
            def.enableLimit = !OneIn(4);
            def.lowerAngle = Any(-1.0f, 0.1f);
            def.upperAngle = def.lowerAngle + (OneIn(5) ? 0.0f : Any(0.0f, 1.0f));
            def.enableMotor = OneIn(3);
            def.motorSpeed = Any(-4.0f, 4.0f);
            def.maxMotorTorque = Any(0.0f, 5.0f);
            def.enableSpring = OneIn(3);
            def.stiffness = Any(1.0f, 40.0f), def.damping = Any(0.0f, 4.0f);
            def.targetAngle = Any(-0.5f, 0.5f);
            if (OneIn(2)) def.maxSpringTorque = Any(0.1f, 5.0f);
        }
        m_joints.push_back(static_cast<RevoluteJoint*>(world.CreateJoint(&def)));
    }

    std::mt19937 m_random;
    uint32_t m_plainShare = 0;  ///< so many plain hinges for each that has more
    std::vector<Body*> m_bodies;
    std::vector<RevoluteJoint*> m_joints;
};

TEST(HingeLanes, GiveTheBitsOfOneByOne) {
    const uint32_t begin = std::random_device{}();
    int inLanes = 0, atLimits = 0;
    for (uint32_t round = 0; round < 24 && !HasFailure(); ++round) {
        const uint32_t seed = begin + round;
        Structure lanes(seed, false), alone(seed, true);
        const bool isWarm = seed % 5 != 0;
        lanes.world.SetWarmStarting(isWarm), alone.world.SetWarmStarting(isWarm);
        for (int step = 0; step < 60; ++step) {
            lanes.world.Step(frame, 8, 3);
            alone.world.Step(frame, 8, 3);
            ASSERT_FALSE(alone.IsInLanes());
            inLanes += lanes.IsInLanes() ? 1 : 0;
            ASSERT_EQ(lanes.GetBits(), alone.GetBits()) << "seed " << seed << ", step " << step;
            atLimits += lanes.CountAtLimits();
            lanes.Change(), alone.Change();
        }
    }
    EXPECT_GT(inLanes, 300);
    EXPECT_GT(atLimits, 300);
}

}  // namespace
}  // namespace scree
