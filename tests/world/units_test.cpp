// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Motion does not depend on the units of mass and length. Units that are powers of two change no digit, so states must
// be the same to the last one, unless some product leaves the range of numbers on the way.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "tests/world/random_pair.h"

namespace scree::test {
namespace {

class WorldInUnits {
public:
    WorldInUnits(Units units, int kind, unsigned seed)
        : m_units(units), m_world(DefIn(units)), m_random(seed), m_pair(m_world, MakeGround(), units, kind, m_random) {}

    void Step(bool soft) {
        EXPECT_EQ(StepWith(m_world, soft ? 4 : 0).nonFiniteCount, 0);
        for (const Body* const body : {m_pair.a, m_pair.b}) {
            const Vec2 at = body->GetPosition(), velocity = body->GetLinearVelocity();
            const float length = m_units.length;
            const float states[] = {at.x / length,       at.y / length,       body->GetAngle(),
                                    velocity.x / length, velocity.y / length, body->GetAngularVelocity()};
            m_states.insert(m_states.end(), std::begin(states), std::end(states));
        }
    }
    [[nodiscard]] const std::vector<float>& GetStates() const { return m_states; }

private:
    static WorldDef DefIn(Units units) {
        WorldDef def;
        def.lengthScale = units.length;
        def.gravity = units.length * Vec2(0, -10);
        return def;
    }
    Body* MakeGround() {
        Body* const ground = AddBody(m_world, staticBody, {0, 0}, 0);
        // Steep and short enough that ends of edges are met.
        std::uniform_real_distribution<float> height(-0.5f, 0.5f);
        Vec2 last(-20.0f, 0.0f);
        while (last.x < 20.0f) {
            const Vec2 next(last.x + 0.75f, height(m_random));
            EdgeShape shape;
            shape.SetTwoSided(m_units.length * last, m_units.length * next);
            ground->CreateFixture(&shape, 0.0f);
            last = next;
        }
        return ground;
    }

    Units m_units;
    World m_world;
    std::mt19937 m_random;
    RandomPair m_pair;
    std::vector<float> m_states;
};

/// Runs every kind of pair in random units against the units that all is chosen in.
template <typename Choose>
void ExpectSameMotion(Choose&& choose) {
    std::mt19937 random(std::random_device{}());
    for (int round = 0; round < 480; ++round) {
        const int kind = round % kindsOfPairs;
        const bool soft = round % (2 * kindsOfPairs) >= kindsOfPairs;
        const unsigned seed = random();
        const Units units = choose(random, kind);
        SCOPED_TRACE("kind " + std::to_string(kind) + (soft ? ", soft" : "") + ", seed " + std::to_string(seed) +
                     ", unit of mass " + std::to_string(std::ilogb(units.mass)) + ", of length " +
                     std::to_string(std::ilogb(units.length)));
        WorldInUnits one({}, kind, seed), other(units, kind, seed);
        for (int i = 0; i < 90; ++i) one.Step(soft), other.Step(soft);
        // Below this is what came of a zero with a few subnormal digits.
        constexpr float nothing = 1e-15f;
        for (size_t i = 0; i < one.GetStates().size(); ++i)
            ASSERT_NEAR(one.GetStates()[i], other.GetStates()[i], nothing) << "state " << i;
    }
}

float PowerOfTwo(std::mt19937& random, int least, int most) {
    return std::ldexp(1.0f, std::uniform_int_distribution(least, most)(random));
}

TEST(Units, OfMassDoNotChangeMotion) {
    ExpectSameMotion([](std::mt19937& random, int) { return Units{.mass = PowerOfTwo(random, -45, 50)}; });
}

TEST(Units, OfLengthDoNotChangeMotion) {
    ExpectSameMotion([](std::mt19937& random, int kind) {
        // All that WorldDef::lengthScale takes. Which face is preferred as the reference does not grow beyond 1.
        const float length = PowerOfTwo(random, -19, kind == alone ? 0 : 19);
        return Units{.mass = length * length, .length = length};
    });
}

}  // namespace
}  // namespace scree::test
