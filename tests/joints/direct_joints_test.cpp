// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the direct solve of joints gives over solving them in turn, and that it can be turned off and on.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "tests/world/fixtures.h"

namespace scree {
namespace {

using namespace test;

/// A chain that hangs from the ceiling and swings, with a heavy box at its end.
struct LoadedChain {
    LoadedChain(uint32_t seed, bool direct) {
        std::mt19937 random(seed);
        const int links = std::uniform_int_distribution<int>(8, 20)(random);
        const float ratio = std::uniform_real_distribution<float>(50.0f, 500.0f)(random);
        inspect::SetDirectJoints(world, direct);
        Body* last = AddBody(world, staticBody, {0.0f, 0.0f});
        for (int i = 0; i < links; ++i) {
            const bool isLoad = i == links - 1;
            Body* link = AddBody(world, dynamicBody, {static_cast<float>(i) + 0.5f, 0.0f});
            AddBox(link, 0.5f, 0.125f, isLoad ? ratio : 1.0f);
            RevoluteJointDef def;
            def.Initialize(last, link, {static_cast<float>(i), 0.0f});
            world.CreateJoint(&def);
            last = link;
        }
    }
    /// Over some steps: the widest gap of a joint, m.
    float Swing(int steps, int substeps = 4) {
        float gap = 0.0f;
        for (int i = 0; i < steps; ++i) {
            StepWith(world, substeps);
            gap = std::max(gap, world.MeasureErrors().jointGap);
        }
        return gap;
    }

    World world{{0.0f, -10.0f}};
};

TEST(DirectJoints, HoldLoadsThatTearWhatIsSolvedInTurn) {
    for (uint32_t seed = 0; seed < 20; ++seed) {
        const float direct = LoadedChain(seed, true).Swing(180), inTurn = LoadedChain(seed, false).Swing(180);
        EXPECT_LT(direct, 0.001f) << seed;
        EXPECT_GT(inTurn, 20.0f * direct) << seed;
    }
}

/// In mid-swing, with a load that is under way: nothing is to be thrown, and in the end all is closed.
void ExpectToClose(uint32_t seed, int substeps) {
    LoadedChain chain(seed, false);
    EXPECT_FALSE(inspect::GetDirectJoints(chain.world));
    EXPECT_GT(chain.Swing(60, substeps), substeps == 4 ? 0.003f : 0.0003f) << seed;
    inspect::SetDirectJoints(chain.world, true);
    EXPECT_LT(chain.Swing(240, substeps), substeps == 4 ? 4.0f : 0.2f) << seed;
    chain.Swing(360, substeps);
    EXPECT_LT(chain.Swing(60, substeps), substeps == 4 ? 0.5f : 0.02f) << seed;
}

TEST(DirectJoints, CloseWhatWasOpenedWhenTheyAreTurnedOnAgain) {
    std::mt19937 random(std::random_device{}());
    for (int round = 0; round < 8; ++round) {
        for (const int substeps : {4, 16}) ExpectToClose(random(), substeps);
    }
}

/// Chains of which four in two thousand were thrown: what closed a gap in one sub-step gave the load its speed.
TEST(DirectJoints, CloseWithoutBringingEnergy) {
    for (const uint32_t seed : {1579874688u, 3880940467u, 2992286136u, 1030504754u, 3608243170u, 3293529044u}) {
        ExpectToClose(seed, 4);
    }
}

TEST(DirectJoints, AreWhatAnImageStartsWith) {
    LoadedChain chain(5, false);
    chain.Swing(10);
    const std::unique_ptr<World> loaded = LoadWorld(SaveWorld(chain.world));
    ASSERT_NE(loaded, nullptr);
    EXPECT_TRUE(inspect::GetDirectJoints(*loaded));
    EXPECT_EQ(inspect::GetStateHash(*loaded), inspect::GetStateHash(chain.world));
    inspect::SetDirectJoints(*loaded, false);
    StepWith(*loaded, 4), StepWith(chain.world, 4);
    EXPECT_EQ(inspect::GetStateHash(*loaded), inspect::GetStateHash(chain.world));
}

/// A bridge of planks between two posts, with a box on it.
void AddLoadedBridge(World& world, float x, float loadInPlanks) {
    const int planks = 10;
    Body* post = AddBody(world, staticBody, {x, 0.0f});
    Body* last = post;
    const auto join = [&](Body* next, int at) {
        RevoluteJointDef def;
        def.Initialize(last, next, {x + 0.5f * static_cast<float>(at), 0.0f});
        world.CreateJoint(&def);
        last = next;
    };
    for (int i = 0; i < planks; ++i) {
        Body* plank = AddBody(world, dynamicBody, {x + 0.5f * (static_cast<float>(i) + 0.5f), 0.0f});
        AddBox(plank, 0.25f, 0.0625f);
        join(plank, i);
    }
    join(post, planks);
    AddBox(AddBody(world, dynamicBody, {x + 2.5f, 0.5625f}), 0.5f, 0.5f, loadInPlanks / 16.0f);
}

/// Poses over time of a chain that is let go with a weight at its end. With `isDouble` two pins hold each link, which
/// is no tree.
std::vector<Transform> SwingBeside(uint32_t seed, bool isDouble, int substeps, float loadInPlanks) {
    std::mt19937 random(seed);
    const auto between = [&](float a, float b) { return std::uniform_real_distribution<float>(a, b)(random); };
    World world({0.0f, -10.0f});
    const float length = between(0.2f, 0.5f), ratio = std::exp(between(4.0f, 8.0f)), angle = between(-1.2f, 1.2f);
    const Rot turn(angle);
    const int links = 12;
    std::vector<Body*> bodies;
    Body* last = AddBody(world, staticBody, {0.0f, 0.0f});
    const auto at = [&](float along, float across) { return Mul(turn, {along, across}); };
    for (int i = 0; i <= links; ++i) {
        const float begin = length * static_cast<float>(i);
        Body* link = AddBody(world, dynamicBody, at(begin + 0.5f * length, 0.0f));
        link->SetTransform(link->GetPosition(), angle);
        AddBox(link, 0.5f * length, 0.05f, i == links ? ratio : 1.0f);
        for (const float across : {-0.04f, 0.04f}) {
            if (across > 0.0f && !isDouble) break;
            RevoluteJointDef def;
            def.Initialize(last, link, at(begin, isDouble ? across : 0.0f));
            world.CreateJoint(&def);
        }
        last = link;
        bodies.push_back(link);
    }
    AddLoadedBridge(world, 100.0f, loadInPlanks);
    // Joints are solved once more where there are contacts, so there always are.
    world.SetAllowSleeping(false);
    AddBox(AddBody(world, staticBody, {200.0f, 0.0f}), 1.0f, 1.0f);
    AddBox(AddBody(world, dynamicBody, {200.0f, 1.5f}), 0.5f, 0.5f);
    std::vector<Transform> poses;
    for (int i = 0; i < 120; ++i) {
        StepWith(world, substeps);
        for (const Body* body : bodies) poses.push_back(body->GetTransform());
    }
    return poses;
}

TEST(DirectJoints, DoNotDependOnLoadsElsewhere) {
    std::random_device seeds;
    for (const bool isDouble : {false, true}) {
        for (const int substeps : {4, 8, 16}) {
            const uint32_t seed = seeds();
            const auto light = SwingBeside(seed, isDouble, substeps, 5.0f);
            const auto heavy = SwingBeside(seed, isDouble, substeps, 100.0f);
            ASSERT_EQ(light.size(), heavy.size());
            const auto isSame = [](const Transform& a, const Transform& b) {
                return a.p == b.p && a.q.s == b.q.s && a.q.c == b.q.c;
            };
            EXPECT_TRUE(std::ranges::equal(light, heavy, isSame)) << seed << " " << isDouble << " " << substeps;
        }
    }
}

}  // namespace
}  // namespace scree
