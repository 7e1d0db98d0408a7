// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the direct solve of joints gives over solving them in turn, and that it can be turned off and on.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>

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

}  // namespace
}  // namespace scree
