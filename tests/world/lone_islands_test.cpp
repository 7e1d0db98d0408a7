// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Islands that are in no group of lanes: several workers solve them side by side, with the bits of one worker that
// takes them in their order. A listener that hears of impulses hears of them in that order.

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

/// The impulses of PostSolve in the order of the calls.
struct Ear final : ContactListener {
    void PostSolve(Contact*, const ContactImpulse* impulse) override {
        for (int i = 0; i < impulse->count; ++i) heard.push_back(std::bit_cast<uint32_t>(impulse->normalImpulses[i]));
    }
    std::vector<uint32_t> heard;
};

/// Heaps of many sizes and chains that lie on them, far apart.
class Heaps {
public:
    enum Size { small, mixed, oneLarge };

    Heaps(uint32_t seed, Size size, int workers)
        : world(DefOf(workers)), m_random(seed), m_resistance(seed % 2 == 0 ? 0.0f : 0.1f) {
        world.GetState().pool->ShareAlways();
        const int heaps = 12 + static_cast<int>(m_random() % 20);
        for (int i = 0; i < heaps; ++i) {
            const bool isLarge = size == oneLarge && i == heaps / 2;
            AddHeap(60.0f * static_cast<float>(i), isLarge ? 45 : size == small ? Any(3, 10) : Any(3, 24));
        }
    }

    World world;

private:
    static WorldDef DefOf(int workers) {
        WorldDef def;
        def.workerCount = workers;
        return def;
    }
    int Any(int low, int high) { return std::uniform_int_distribution<int>(low, high)(m_random); }

    /// On a ground of its own, or on one that it shares with others.
    void AddHeap(float x, int base) {
        if (m_ground == nullptr || m_random() % 2 == 0) m_ground = AddBody(world, staticBody, {x, -1.0f});
        PolygonShape floor;
        floor.SetAsBox(29.0f, 1.0f, m_ground->GetLocalPoint({x, -1.0f}), 0.0f);
        m_ground->CreateFixture(&floor, 0.0f);
        for (int row = 0; row < base; ++row) {
            for (int i = 0; i < base - row; ++i) {
                const float at =
                    static_cast<float>(i) + 0.5f * static_cast<float>(row) - 0.5f * static_cast<float>(base);
                Body* body = AddBody(world, dynamicBody, {x + 1.03f * at, 0.5f + 1.01f * static_cast<float>(row)});
                if (m_random() % 4 != 0) {
                    AddBox(body, 0.5f, 0.5f);
                } else {
                    AddCircle(body, 0.5f)->SetRollingResistance(m_resistance);
                }
            }
        }
        Body* last = nullptr;
        for (int link = Any(0, 8); link > 0; --link) {
            const Vec2 place{x + 0.6f * static_cast<float>(link), 2.0f + 1.01f * static_cast<float>(base)};
            Body* body = AddBody(world, dynamicBody, place);
            AddBox(body, 0.3f, 0.1f);
            if (last != nullptr) {
                RevoluteJointDef def;
                def.Initialize(last, body, place + Vec2{0.3f, 0.0f});
                world.CreateJoint(&def);
            }
            last = body;
        }
    }

    std::mt19937 m_random;
    float m_resistance;  ///< of disks that roll; every other world has none
    Body* m_ground = nullptr;
};

class LoneIslands : public testing::TestWithParam<Heaps::Size> {};

TEST_P(LoneIslands, OfSeveralWorkersHaveTheBitsOfOne) {
    int side = 0, wide = 0;
    for (uint32_t seed = 0; seed < 3; ++seed) {
        for (const int workers : {2, 3, 8}) {
            Heaps one(seed, GetParam(), 1), many(seed, GetParam(), workers);
            for (int step = 0; step < 40; ++step) {
                StepFor(one.world, 1), StepFor(many.world, 1);
                ASSERT_EQ(BitsOf(one.world), BitsOf(many.world))
                    << "seed " << seed << ", step " << step << ", " << workers;
                for (const LoneIsland& lone : many.world.GetState().solverScratch.lone)
                    ++(lone.blocks < 0 ? side : wide);
            }
        }
    }
    EXPECT_GT(side, 1000);
    if (GetParam() != Heaps::small) {
        EXPECT_GT(wide, 1000);
    }
}

TEST_P(LoneIslands, AreHeardOfInTheirOrder) {
    Heaps one(7, GetParam(), 1), many(7, GetParam(), 3);
    Ear ofOne, ofMany;
    one.world.SetContactListener(&ofOne);
    many.world.SetContactListener(&ofMany);
    StepFor(one.world, 20), StepFor(many.world, 20);
    EXPECT_GT(ofOne.heard.size(), size_t{1000});
    EXPECT_EQ(ofOne.heard, ofMany.heard);
    EXPECT_EQ(BitsOf(one.world), BitsOf(many.world));
}

/// Pyramids of the same base, and their scratch after a few steps.
size_t ScratchOfPyramids(int count, int base, int workers) {
    WorldDef def;
    def.workerCount = workers;
    World world(def);
    world.GetState().pool->ShareAlways();
    AddGround(world, 1e5f);
    for (int pyramid = 0; pyramid < count; ++pyramid) {
        for (int row = 0; row < base; ++row) {
            for (int i = 0; i < base - row; ++i) {
                const float at = 1.01f * (static_cast<float>(i) + 0.5f * static_cast<float>(row));
                const Vec2 place{3.0f * static_cast<float>(base * pyramid) + at, 0.5f + static_cast<float>(row)};
                AddBox(AddBody(world, dynamicBody, place), 0.5f, 0.5f);
            }
        }
    }
    StepFor(world, 5);
    EXPECT_EQ(world.GetState().solverScratch.wide.size(), static_cast<size_t>(count));
    return inspect::GetMemoryUse(world).solverScratch;
}

TEST(RoomOfLoneIslands, IsThatOfTheirContacts) {
    for (const int workers : {1, 3}) {
        const size_t few = ScratchOfPyramids(20, 12, workers), many = ScratchOfPyramids(200, 12, workers);
        EXPECT_LT(many, 12 * few) << workers;
    }
}

/// A net of hinges that hangs, and its scratch after a few steps.
size_t ScratchOfNet(int size, int workers) {
    WorldDef def;
    def.gravity = {0.0f, -10.0f};
    def.workerCount = workers;
    World world(def);
    world.GetState().pool->ShareAlways();
    std::vector<Body*> bodies;
    for (int i = 0; i < size * size; ++i) {
        const Vec2 place{static_cast<float>(i % size), -static_cast<float>(i / size)};
        bodies.push_back(AddBody(world, i == 0 ? staticBody : dynamicBody, place));
        AddCircle(bodies.back(), 0.4f);
        const auto hang = [&](int other) {
            RevoluteJointDef joint;
            joint.Initialize(bodies[static_cast<size_t>(other)], bodies.back(), place);
            world.CreateJoint(&joint);
        };
        if (i % size > 0) hang(i - 1);
        if (i >= size) hang(i - size);
    }
    StepFor(world, 5);
    return inspect::GetMemoryUse(world).solverScratch;
}

TEST(RoomOfLoneIslands, OfAllWorkersIsTakenOnce) { EXPECT_LT(ScratchOfNet(60, 8), 2 * ScratchOfNet(60, 1)); }

TEST(RoomOfLoneIslands, IsGivenBack) {
    World world{{0.0f, -10.0f}};
    AddGround(world, 1000.0f);
    std::vector<Body*> large;
    const auto add = [&](float x, int base, std::vector<Body*>* list) {
        for (int row = 0; row < base; ++row) {
            for (int i = 0; i < base - row; ++i) {
                const float at = x + 1.01f * (static_cast<float>(i) + 0.5f * static_cast<float>(row));
                Body* body = AddBody(world, dynamicBody, {at, 0.5f + static_cast<float>(row)});
                AddBox(body, 0.5f, 0.5f);
                if (list != nullptr) list->push_back(body);
            }
        }
    };
    add(100.0f, 10, nullptr);
    add(0.0f, 60, &large);
    StepFor(world, 5);
    const size_t before = inspect::GetMemoryUse(world).solverScratch;
    for (Body* body : large) world.DestroyBody(body);
    StepFor(world, 5);
    EXPECT_LT(inspect::GetMemoryUse(world).solverScratch, before / 2);
}

INSTANTIATE_TEST_SUITE_P(OfSize, LoneIslands, testing::Values(Heaps::small, Heaps::mixed, Heaps::oneLarge));

}  // namespace
}  // namespace scree
