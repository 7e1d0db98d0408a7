// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Whole revolute joints of an island side by side: the bits of solving them one by one, for random structures.

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "tests/world/random_hinges.h"
#include "world/world_state.h"

namespace scree {
namespace {

using namespace test;

/// One island: a tree of limbs on hinges, with some loops. It hangs on what stands still and on what moves on its own,
/// and lies on the ground. Hinges have limits, motors and springs, or nothing.
class Structure {
public:
    /// `oneByOne`: a disk in it has turned so far that lanes take none. Its cosine and sine matter to nobody.
    Structure(uint32_t seed, bool oneByOne) : m_draw(seed), m_plain(m_draw.Below(4)) {
        world.SetAllowSleeping(false);
        AddBox(AddBody(world, staticBody, {0.0f, -6.0f}), 60.0f, 0.5f);
        m_limbs.push_back(test::AddLimb(world, {0.0f, 0.0f}, 30.0f, m_draw));
        const uint32_t count = 60 + m_draw.Below(200);
        for (uint32_t i = 0; i < count; ++i) AddLimb();
        for (uint32_t i = 0; i < count / 16; ++i) AddLoop();
        Body* root = m_limbs.front();
        const Vec2 place = root->GetPosition();
        if (m_draw.OneIn(2)) AddHinge(AddBody(world, staticBody, place), root, place);
        Body* crank = AddBody(world, kinematicBody, m_limbs.back()->GetPosition());
        crank->SetAngularVelocity(m_draw.Any(-3.0f, 3.0f)), crank->SetLinearVelocity({0.0f, m_draw.Any(-1.0f, 1.0f)});
        if (m_draw.OneIn(2)) AddHinge(m_limbs.back(), crank, crank->GetWorldPoint({0.1f, 0.0f}));
        Body* disk = AddBody(world, dynamicBody, place, oneByOne ? 2.0e8f : 0.0f);
        Filter untouched;
        untouched.maskBits = 0;
        AddCircle(disk, 0.3f)->SetFilterData(untouched);
        RevoluteJointDef def;
        def.Initialize(root, disk, place);
        world.CreateJoint(&def);
    }
    [[nodiscard]] std::vector<uint32_t> GetBits() const { return test::GetBits(m_limbs, m_joints); }
    [[nodiscard]] int CountAtLimits() const { return test::CountAtLimits(m_joints); }
    [[nodiscard]] bool IsInLanes() const {
        return !world.GetState().solverScratch.islandRows[0].joints.wholeHinges.IsEmpty();
    }
    /// As a game turns things on and off: what they have kept is forgotten.
    void Change() {
        RevoluteJoint* joint = m_joints[m_draw.Below(static_cast<uint32_t>(m_joints.size()))];
        if (m_draw.OneIn(3)) joint->EnableLimit(!joint->IsLimitEnabled());
        if (m_draw.OneIn(3)) joint->EnableMotor(!joint->IsMotorEnabled());
    }

    World world{{0.0f, -10.0f}};

private:
    Body* AnyLimb() { return m_limbs[m_draw.Below(static_cast<uint32_t>(m_limbs.size()))]; }
    void AddLimb() {
        Body* parent = AnyLimb();
        const Vec2 anchor = parent->GetWorldPoint({m_draw.OneIn(2) ? 0.4f : -0.4f, 0.0f});
        const float x = m_draw.Any(-0.4f, 0.4f), y = m_draw.Any(-0.2f, 0.2f);
        Body* limb = test::AddLimb(world, anchor + Vec2{x, y}, 30.0f, m_draw);
        if (m_draw.OneIn(10)) limb->SetFixedRotation(true);
        AddHinge(parent, limb, anchor);
        m_limbs.push_back(limb);
    }
    void AddLoop() {
        Body *a = AnyLimb(), *b = AnyLimb();
        if (a != b) AddHinge(a, b, a->GetWorldPoint({0.2f, 0.1f}));
    }
    void AddHinge(Body* a, Body* b, Vec2 anchor) {
        RevoluteJointDef def;
        def.Initialize(a, b, anchor);
        if (m_draw.OneIn(1 + m_plain)) GiveRange(def, m_draw);
        m_joints.push_back(static_cast<RevoluteJoint*>(world.CreateJoint(&def)));
    }

    Draws m_draw;
    uint32_t m_plain;  ///< so many plain hinges for each that has more
    std::vector<Body*> m_limbs;
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
    EXPECT_GT(inLanes, 120);
    EXPECT_GT(atLimits, 3000);
}

/// Mobiles that hang on one static body, whose row no worker may write: the thread sanitizer would tell.
uint64_t HashOfMobiles(int workers, bool& inLanes) {
    WorldDef def;
    def.gravity = {0.0f, -10.0f};
    def.workerCount = workers;
    World world(def);
    world.GetState().pool->ShareAlways();
    world.SetAllowSleeping(false);
    Body* ceiling = AddBody(world, staticBody, {0.0f, 0.0f});
    Draws draw(3);
    for (int mobile = 0; mobile < 12; ++mobile) {
        std::vector<Body*> limbs{ceiling};
        for (size_t i = 1; i < 128; ++i) {
            Body* parent = limbs[i / 2];
            const Vec2 anchor = i == 1 ? Vec2{60.0f * static_cast<float>(mobile), 0.0f}
                                       : parent->GetWorldPoint({i % 2 == 0 ? 0.4f : -0.4f, 0.0f});
            limbs.push_back(AddLimb(world, anchor + Vec2{0.0f, -0.3f}, 3.0f, draw));
            RevoluteJointDef hinge;
            hinge.Initialize(parent, limbs.back(), anchor);
            world.CreateJoint(&hinge);
        }
    }
    for (int i = 0; i < 30; ++i) world.Step(frame, 8, 3);
    inLanes = !world.GetState().solverScratch.islandRows[0].joints.wholeHinges.IsEmpty();
    return inspect::GetStateHash(world);
}

TEST(HingeLanes, ShareAStaticBodyBetweenWorkers) {
    bool inLanes = false;
    const uint64_t alone = HashOfMobiles(1, inLanes);
    EXPECT_TRUE(inLanes);
    for (const int workers : {2, 3}) EXPECT_EQ(HashOfMobiles(workers, inLanes), alone) << workers;
}

}  // namespace
}  // namespace scree
