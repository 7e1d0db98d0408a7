// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Small islands side by side: the bits of solving them one by one, for random piles of all kinds of shapes. What else
// is in a world does not change how a pile moves.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "pipeline/parts/lane_solver.h"
#include "tests/world/fixtures.h"
#include "world/step.h"
#include "world/world_state.h"

namespace scree {
namespace {

using namespace test;

/// Piles of one to a dozen bodies, far apart, thrown a little; some bounce, some lie on moving ground. Some are of a
/// few compounds, which touch each other with many fixtures.
class Piles {
public:
    /// `oneByOne`: a lone body with a lock, which moves alike without it, keeps islands out of the lanes.
    Piles(uint32_t seed, bool oneByOne, int workers = 1, int count = 30) : world(DefOf(workers)), m_random(seed) {
        world.GetState().pool->ShareAlways();
        constexpr float width = 1200.0f;  // what is far from the origin is in no lanes
        for (int pile = 0; pile < count; ++pile) AddPile(width * static_cast<float>(pile) / static_cast<float>(count));
        Body* lone = AddBody(world, dynamicBody, {-100.0f, 0.0f});
        AddCircle(lone, 0.3f);
        if (oneByOne) lone->SetMotionLocks({.x = true});
    }

    World world;

private:
    static WorldDef DefOf(int workers) {
        WorldDef def;
        def.gravity = {0.0f, -10.0f};
        def.workerCount = workers;
        return def;
    }
    float Any(float low, float high) { return std::uniform_real_distribution<float>(low, high)(m_random); }

    void AddPile(float x) {
        const bool moves = m_random() % 4 == 0;
        Body* ground = AddBody(world, moves ? kinematicBody : staticBody, {x, -1.0f}, Any(-0.2f, 0.2f));
        AddBox(ground, 12.0f, 1.0f);
        if (moves) ground->SetLinearVelocity({Any(-1.0f, 1.0f), 0.0f});
        if (m_random() % 4 == 0) return AddCompounds(x);
        const int count = 1 + static_cast<int>(m_random() % 12);
        for (int i = 0; i < count; ++i) {
            Body* body = AddBody(world, dynamicBody, {x + Any(-1.5f, 1.5f), 1.0f + 0.9f * static_cast<float>(i)},
                                 Any(-3.0f, 3.0f));
            Fixture* fixture =
                m_random() % 3 == 0 ? AddCircle(body, Any(0.2f, 0.6f)) : AddBox(body, Any(0.2f, 0.8f), Any(0.2f, 0.6f));
            fixture->SetRestitution(m_random() % 3 == 0 ? Any(0.0f, 0.9f) : 0.0f);
            fixture->SetFriction(Any(0.0f, 1.0f));
            body->SetLinearVelocity({Any(-2.0f, 2.0f), Any(-2.0f, 2.0f)});
            body->SetAngularVelocity(Any(-3.0f, 3.0f));
            body->SetFixedRotation(m_random() % 10 == 0);
        }
    }

    void AddCompounds(float x) {
        const int count = 2 + static_cast<int>(m_random() % 5);
        for (int i = 0; i < count; ++i) {
            Body* body = AddBody(world, dynamicBody, {x + Any(-0.3f, 0.3f), 0.5f + 0.3f * static_cast<float>(i)},
                                 Any(-3.0f, 3.0f));
            const int fixtures = 1 + static_cast<int>(m_random() % 12);
            for (int f = 0; f < fixtures; ++f) {
                PolygonShape box;
                box.SetAsBox(Any(0.1f, 0.4f), Any(0.1f, 0.4f), {Any(-1.0f, 1.0f), Any(-0.5f, 0.5f)}, Any(-3.0f, 3.0f));
                body->CreateFixture(&box, 1.0f);
            }
        }
    }

    std::mt19937 m_random;
};

TEST(IslandLanes, GiveTheBitsOfOneByOne) {
    size_t solvedInLanes = 0, behindAnother = 0, ofManyContacts = 0;
    for (uint32_t seed = 0; seed < 8 && !HasFailure(); ++seed) {
        Piles lanes(seed, false), alone(seed, true);
        for (int step = 0; step < 240; ++step) {
            lanes.world.Step(frame, 8, 3);
            alone.world.Step(frame, 8, 3);
            for (const LaneScratch::Place& place : lanes.world.GetState().solverScratch.lanes.places) {
                ++solvedInLanes;
                if (place.first > 0) ++behindAnother;
                if (CountContacts(lanes.world.GetState().islands.islands[ToSize(place.island)]) >= leastWideContacts)
                    ++ofManyContacts;
            }
            ASSERT_TRUE(alone.world.GetState().solverScratch.lanes.places.empty());
            ASSERT_EQ(BitsOf(lanes.world), BitsOf(alone.world)) << "seed " << seed << ", step " << step;
        }
    }
    EXPECT_GT(solvedInLanes, size_t{8 * 60 * 8});
    EXPECT_GT(behindAnother, solvedInLanes / 20);
    EXPECT_GT(ofManyContacts, size_t{8 * 10});
}

/// Angles get too large for the kernels within a step, or are no numbers at its end.
TEST(IslandLanes, GiveTheBitsOfOneByOneWhateverTheSpeeds) {
    size_t solvedInLanes = 0;
    for (uint32_t seed = 20; seed < 60 && !HasFailure(); ++seed) {
        Piles lanes(seed, false), alone(seed, true);
        std::mt19937 random(seed);
        for (int step = 0; step < 20; ++step) {
            const uint32_t draw = random();
            const float speed = std::ldexp(1.0f, static_cast<int>(random() % 60));  // none is refused
            for (World* world : {&lanes.world, &alone.world}) {
                uint32_t number = 0;
                for (Body* body = world->GetBodyList(); body != nullptr; body = body->GetNext()) {
                    if (body->GetType() != dynamicBody || ++number % 16 != draw % 16) continue;
                    const bool turns = draw % 3 != 0, flies = draw % 5 == 0;
                    if (turns) body->SetAngularVelocity(speed);
                    if (flies) body->SetLinearVelocity({0.0f, -speed});
                }
            }
            lanes.world.Step(frame, 8, 3);
            alone.world.Step(frame, 8, 3);
            solvedInLanes += lanes.world.GetState().solverScratch.lanes.places.size();
            ASSERT_EQ(BitsOf(lanes.world), BitsOf(alone.world)) << "seed " << seed << ", step " << step;
        }
    }
    EXPECT_GT(solvedInLanes, size_t{1000});
}

TEST(IslandLanes, OfSeveralWorkersAreThoseOfOne) {
    const auto countGroups = [](World& world) { return world.GetState().solverScratch.lanes.groups.size(); };
    constexpr int piles = 48;
    int shared = 0;
    size_t givenUp = 0, kept = 0;
    for (const int workers : {2, 4, 8}) {
        const auto seed = static_cast<uint32_t>(workers);
        Piles one(seed, false, 1, piles), many(seed, false, workers, piles);
        for (int step = 0; step < 120; ++step) {
            one.world.Step(frame, 8, 3);
            many.world.Step(frame, 8, 3);
            shared += CountWorkToShare(many.world.GetState()) > 0 ? 1 : 0;
            const size_t all = countGroups(one.world), left = countGroups(many.world);
            ASSERT_LE(left, all);
            givenUp += all - left, kept += left;
        }
        EXPECT_EQ(BitsOf(one.world), BitsOf(many.world)) << workers << " workers";
    }
    EXPECT_GT(shared, 3 * 60);
    // Those that last longer than all else, shared, are given up.
    EXPECT_GT(givenUp, size_t{120});
    EXPECT_GT(kept, size_t{40});
}

/// What is built first, and beside it, half a kilometre away, crates at rest or a pyramid that falls down.
struct Beside {
    enum Kind { tower, pyramid };
    struct Neighbours {
        int crates, pyramidBase;
    };

    Beside(Kind kind, int size, Neighbours neighbours) {
        AddGround(world, 3000.0f);
        if (kind == tower) {
            for (int i = 0; i < size; ++i) AddBoxAt({0.01f * static_cast<float>(i % 3), 0.5f + static_cast<float>(i)});
        } else {
            AddPyramid(0.0f, size, 1.05f);
        }
        own = count;
        for (int i = 0; i < neighbours.crates; ++i) AddBoxAt({500.0f + 2.0f * static_cast<float>(i), 0.5f});
        AddPyramid(400.0f, neighbours.pyramidBase, 1.7f);
        world.SetAllowSleeping(false);
    }
    void AddPyramid(float x, int base, float spacing) {
        for (int row = 0; row < base; ++row) {
            for (int i = 0; i < base - row; ++i) {
                const float at = static_cast<float>(i) + 0.5f * static_cast<float>(row);
                AddBoxAt({x + spacing * at, 0.5f + 1.02f * static_cast<float>(row)});
            }
        }
    }
    void AddBoxAt(Vec2 place) {
        AddBox(AddBody(world, dynamicBody, place), 0.5f, 0.5f);
        ++count;
    }
    /// Positions and angles of what was built first, to the bit.
    [[nodiscard]] std::vector<uint32_t> GetBits() const {
        std::vector<uint32_t> bits;
        int i = count;
        for (const Body* b = world.GetBodyList(); b != nullptr && i > 0; b = b->GetNext(), --i) {
            if (i > own) continue;
            for (const float x : {b->GetPosition().x, b->GetPosition().y, b->GetAngle()})
                bits.push_back(std::bit_cast<uint32_t>(x));
        }
        return bits;
    }

    World world{{0.0f, -10.0f}};
    int own = 0, count = 0;
};

class Neighbours : public testing::TestWithParam<int> {};  // sub-steps; 0: sequential impulses

TEST_P(Neighbours, ChangeNoBitOfAPile) {
    constexpr int steps = 400;
    using Piles = std::vector<std::pair<Beside::Kind, int>>;
    for (const auto& [kind, size] : Piles{{Beside::tower, 1},
                                          {Beside::tower, 5},
                                          {Beside::tower, 12},
                                          {Beside::tower, 20},
                                          {Beside::pyramid, 6},
                                          {Beside::pyramid, 15}}) {
        Beside alone(kind, size, {0, 0});
        StepWith(alone.world, GetParam(), steps);
        const std::vector<uint32_t> expected = alone.GetBits();
        ASSERT_EQ(expected.size(), 3 * static_cast<size_t>(alone.own));
        for (const Beside::Neighbours neighbours :
             {Beside::Neighbours{1, 0}, {7, 0}, {40, 0}, {130, 0}, {400, 0}, {3, 16}}) {
            Beside beside(kind, size, neighbours);
            StepWith(beside.world, GetParam(), steps);
            EXPECT_EQ(beside.GetBits(), expected)
                << (kind == Beside::tower ? "tower of " : "pyramid of ") << size << " beside " << neighbours.crates
                << " crates and a pyramid of " << neighbours.pyramidBase;
        }
    }
}
INSTANTIATE_TEST_SUITE_P(EverySolver, Neighbours, testing::ValuesIn(solvers));

}  // namespace
}  // namespace scree
