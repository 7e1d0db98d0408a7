// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Sub-steps of the soft step that threads go through in chains, bodies included: the bits of one thread, whatever else
// is in the world and wherever its bodies go.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "tests/world/fixtures.h"
#include "world/step.h"
#include "world/world_state.h"

namespace scree {
namespace {

using namespace test;

/// What is among the bodies besides boxes and disks that contacts hold.
enum class Guest { none, kinematic, locked, bouncing, rolling, hinged };

struct Pile {
    uint32_t seed;
    Guest guest;
    bool inOrder;  ///< neighbours were made one after the other
    float far;     ///< m from the origin

    void Fill(World& world) const {
        std::mt19937 random(seed);
        const auto any = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
        Body* const ground = AddBody(world, staticBody, {far, 0.0f});
        EdgeShape edge;
        edge.SetTwoSided({-100.0f, 0.0f}, {100.0f, 0.0f});
        ground->CreateFixture(&edge, 0.0f);
        const int width = any(40, 80), height = any(4, 8);
        std::vector<int> places(ToSize(width * height));
        std::iota(places.begin(), places.end(), 0);
        if (!inOrder) std::shuffle(places.begin(), places.end(), random);
        Body* last = nullptr;
        for (const int place : places) {
            const Vec2 at{far + 0.99f * static_cast<float>(place % width) - 0.5f * static_cast<float>(width),
                          0.495f + 0.99f * static_cast<float>(place / width)};
            const bool isGuest = any(0, 9) == 0;
            Body* const body = AddBody(world, isGuest && guest == Guest::kinematic ? kinematicBody : dynamicBody, at);
            Fixture* const fixture = any(0, 3) == 0 ? AddCircle(body, 0.5f) : AddBox(body, 0.5f, 0.5f);
            body->SetLinearVelocity({8.0f, 0.0f});
            body->SetLinearDamping(any(0, 5) == 0 ? 0.3f : 0.0f);
            fixture->SetFriction(0.1f * static_cast<float>(any(0, 8)));
            if (!isGuest) continue;
            if (guest == Guest::kinematic) body->SetAngularVelocity(1.0f);
            if (guest == Guest::locked)
                body->SetMotionLocks({.x = any(0, 1) == 0, .y = any(0, 1) == 0, .angle = false});
            if (guest == Guest::bouncing) fixture->SetRestitution(0.7f);
            if (guest == Guest::rolling) fixture->SetRollingResistance(0.2f);
            if (guest == Guest::hinged && last != nullptr) {
                RevoluteJointDef def;
                def.Initialize(last, body, at);
                world.CreateJoint(&def);
            }
            last = body;
        }
    }
};

bool HasChains(World& world) {
    WorldState& s = world.GetState();
    return s.solverScratch.constraints.blocks.Task(s.bodies.velocity, s.solverScratch.delta).chains != nullptr;
}

class ChainedSubsteps : public testing::TestWithParam<Guest> {};

TEST_P(ChainedSubsteps, OfSeveralWorkersHaveTheBitsOfOne) {
    std::mt19937 random(31u + static_cast<uint32_t>(GetParam()));
    int chained = 0;
    for (int i = 0; i < 6; ++i) {
        const Pile pile{random(), GetParam(), i % 2 == 0, i % 4 == 3 ? 5000.0f : 0.0f};
        WorldDef def;
        World one(def);
        def.workerCount = 2 + static_cast<int>(random() % 4);
        World several(def);
        several.GetState().pool->ShareAlways();
        pile.Fill(one), pile.Fill(several);
        const int substeps = 1 + static_cast<int>(random() % 9);
        for (int step = 0; step < 30; ++step) {
            StepWith(one, substeps), StepWith(several, substeps);
            ASSERT_EQ(inspect::GetStateHash(several), inspect::GetStateHash(one))
                << "pile " << i << ", step " << step << ", " << def.workerCount << " workers, sub-steps " << substeps;
            chained += HasChains(several) ? 1 : 0;
        }
    }
    EXPECT_GT(chained, 50) << "the blocks were hardly ever in chains";
}

std::string NameOfGuest(const testing::TestParamInfo<Guest>& info) {
    constexpr const char* names[] = {"None", "Kinematic", "Locked", "Bouncing", "Rolling", "Hinged"};
    return names[static_cast<int>(info.param)];
}

INSTANTIATE_TEST_SUITE_P(Guests, ChainedSubsteps,
                         testing::Values(Guest::none, Guest::kinematic, Guest::locked, Guest::bouncing, Guest::rolling,
                                         Guest::hinged),
                         NameOfGuest);

/// Bodies of any size and mass made in each other. Which of them stand beside others in a block differs.
TEST(SharedSteps, PartInitialOverlapToTheSameBits) {
    std::mt19937 random(77);
    const auto draw = [&random](float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(random);
    };
    int parting = 0;
    for (int i = 0; i < 60 && !testing::Test::HasFailure(); ++i) {
        WorldDef def;
        World one(def);
        def.workerCount = 2 + i % 3;
        World several(def);
        several.GetState().pool->ShareAlways();
        const float room = draw(2.0f, 60.0f);
        for (int k = 0; k < 40; ++k) {
            const Vec2 at{draw(-room, room), draw(-room, room)};
            const Vec2 velocity{draw(-10.0f, 10.0f), draw(-10.0f, 10.0f)};
            const float size = std::exp(draw(-1.0f, 3.5f)), density = std::exp(draw(-3.0f, 5.0f));
            const bool isBox = k % 3 == 0, isFixed = k % 10 == 0, isFar = i % 10 == 9 && k % 7 == 0;
            for (World* world : {&one, &several}) {
                Body* body = AddBody(*world, isFixed ? staticBody : dynamicBody, isFar ? 1e15f * at : at);
                isBox ? AddBox(body, size, 0.5f, density) : AddCircle(body, 0.5f * size, density);
                if (!isFixed) body->SetLinearVelocity(isFar ? 1e13f * velocity : velocity);
            }
        }
        for (int step = 0; step < 4; ++step) {
            StepWith(one, 4), StepWith(several, 4);
            ASSERT_EQ(inspect::GetStateHash(several), inspect::GetStateHash(one)) << "world " << i << ", step " << step;
            parting += several.GetState().solverScratch.constraints.blocks.GetInitialOverlapCount() > 0 ? 1 : 0;
        }
    }
    EXPECT_GT(parting, 100);
}

/// A wall that flies: its contacts stay the same, and its bodies come from one side of a cut to the other.
TEST(SlicesOfSubsteps, BodiesMayLeaveTheirSlices) {
    std::mt19937 random(9);
    WorldDef def;
    def.gravity = vec2Zero;
    World one(def);
    def.workerCount = 3;
    World several(def);
    several.GetState().pool->ShareAlways();
    constexpr int width = 60, height = 5;
    std::vector<int> places(width * height);
    std::iota(places.begin(), places.end(), 0);
    std::shuffle(places.begin(), places.end(), random);  // or slices would be cut by number
    for (World* world : {&one, &several}) {
        for (const int place : places) {
            const Vec2 at{static_cast<float>(place % width), static_cast<float>(place / width)};
            Body* const body = AddBody(*world, dynamicBody, at);
            AddBox(body, 0.5f, 0.5f);
            body->SetLinearVelocity({20.0f, 0.05f * static_cast<float>(place % 7)});
        }
    }
    int apart = 0;  // steps in which chains are not the slices of the bodies
    for (int step = 0; step < 200; ++step) {
        StepWith(one, 4), StepWith(several, 4);
        ASSERT_EQ(inspect::GetStateHash(several), inspect::GetStateHash(one)) << "step " << step;
        apart += HasChains(several) && !several.GetState().solverScratch.constraints.blocks.FollowSlices() ? 1 : 0;
    }
    EXPECT_GT(apart, 20);
}

/// Without a contact, too, if there are joints to solve. Of fewer bodies than are worth a loop there are none.
TEST(SharedSteps, AreThoseOfJointedBodies) {
    for (const int links : {50, 300, 1000}) {
        World world({0.0f, -10.0f});
        Body* last = AddBody(world, staticBody, {0.0f, 0.0f});
        for (int link = 0; link < links; ++link) {
            Body* const body = AddBody(world, dynamicBody, {static_cast<float>(link) + 0.5f, 0.0f});
            AddBox(body, 0.3f, 0.1f);
            RevoluteJointDef joint;
            joint.Initialize(last, body, {static_cast<float>(link), 0.0f});
            if (link % 10 != 0) world.CreateJoint(&joint);
            last = body;
        }
        StepWith(world, 4);
        EXPECT_EQ(CountWorkToShare(world.GetState()) > 0, links > 256) << links;
    }
}

/// Chains that swing, and two boxes one of which goes away. As many bodies as a world of its own accord shares.
TEST(SharedSteps, GoOnWithoutContactsOnceTheLastIsGone) {
    for (const int substeps : solvers) {
        std::vector<uint64_t> hashes;
        for (const int workers : {1, 2, 5}) {
            WorldDef def;
            def.gravity = {0.0f, -10.0f};
            def.workerCount = workers;
            World world(def);
            Body* const ceiling = AddBody(world, staticBody, {0.0f, 0.0f});
            constexpr int chains = 300, links = 8;
            for (int chain = 0; chain < chains; ++chain) {
                Body* last = ceiling;
                for (int link = 0; link < links; ++link) {
                    const float at = 20.0f * static_cast<float>(chain) + static_cast<float>(link);
                    Body* const body = AddBody(world, dynamicBody, {at + 0.5f, 0.0f});
                    AddBox(body, 0.5f, 0.1f);
                    RevoluteJointDef joint;
                    joint.Initialize(last, body, {at, 0.0f});
                    world.CreateJoint(&joint);
                    last = body;
                }
            }
            Body* const lower = AddBody(world, dynamicBody, {0.0f, 50.0f});
            Body* const upper = AddBody(world, dynamicBody, {0.0f, 50.9f});
            AddBox(lower, 0.5f, 0.5f), AddBox(upper, 0.5f, 0.5f);
            StepWith(world, substeps, 3);
            EXPECT_EQ(world.GetContactCount(), 1);
            world.DestroyBody(upper);
            StepWith(world, substeps, 3);
            EXPECT_EQ(world.GetContactCount(), 0);
            hashes.push_back(inspect::GetStateHash(world));
        }
        for (const uint64_t hash : hashes) EXPECT_EQ(hash, hashes.front()) << substeps;
    }
}

}  // namespace
}  // namespace scree
