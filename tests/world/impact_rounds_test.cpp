// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Impacts of jointed bodies that are solved together: the bits of one after the other, on any number of workers.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <mutex>
#include <random>
#include <thread>
#include <utility>
#include <vector>

#include "scree/inspect.h"
#include "tests/world/fixtures.h"
#include "world/world_state.h"

namespace scree {
namespace {

using namespace test;

enum class Rounds : uint8_t { asUsual, ofOneImpact };

/// Chains of limbs that fall fast on a floor and on thin slopes, some of them on each other or together with loose
/// disks.
class FallingChains {
public:
    FallingChains(uint32_t seed, int workers, Rounds rounds) : world(DefOf(workers)), m_random(seed) {
        if (workers > 1) world.GetState().pool->ShareAlways();
        world.SetAllowSleeping(m_random() % 2 == 0);
        AddBox(AddBody(world, staticBody, {0.0f, -0.5f}), 200.0f, 0.5f);
        for (int i = 0; i < 6; ++i) {
            AddBox(AddBody(world, staticBody, {Any(-40.0f, 40.0f), Any(1.0f, 6.0f)}, Any(-0.5f, 0.5f)), 3.0f, 0.02f);
        }
        const float spacing = Any(0.7f, 3.0f);
        const int chains = 12 + static_cast<int>(m_random() % 20);
        for (int i = 0; i < chains; ++i) AddChain({spacing * static_cast<float>(i - chains / 2), Any(2.0f, 6.0f)});
        const int sheaves = static_cast<int>(m_random() % 12);
        for (int i = 0; i < sheaves; ++i) AddSheaf({6.0f * static_cast<float>(i - sheaves / 2), Any(3.0f, 5.0f)});
        for (int i = 0; i < 10; ++i) {
            Body* disk = AddBody(world, dynamicBody, {Any(-20.0f, 20.0f), Any(1.0f, 8.0f)});
            AddCircle(disk, Any(0.1f, 0.4f));
            disk->SetLinearVelocity({0.0f, Any(-60.0f, 0.0f)});
            m_bodies.push_back(disk);
        }
        if (rounds == Rounds::ofOneImpact) world.GetState().continuousScratch.impacts.mostImpacts = 1;
    }

    [[nodiscard]] std::vector<Vec2> GetStates() const {
        std::vector<Vec2> states;
        for (const Body* body : m_bodies) {
            states.push_back(body->GetPosition());
            states.push_back(body->GetLinearVelocity());
            states.push_back({body->GetAngle(), body->GetAngularVelocity()});
        }
        return states;
    }
    /// Whose they are, in their order.
    [[nodiscard]] std::vector<std::pair<FixtureIndex, FixtureIndex>> GetContacts() const {
        std::vector<std::pair<FixtureIndex, FixtureIndex>> rows;
        const ContactTable& contacts = world.GetState().contacts;
        for (const ContactIndex row : contacts.flags.Rows()) {
            if (contacts.IsAlive(row)) rows.emplace_back(contacts.pair[row].fixtureA, contacts.pair[row].fixtureB);
        }
        return rows;
    }
    [[nodiscard]] size_t GetLargestRound() const { return world.GetState().continuousScratch.impacts.largestRound; }

    World world;

private:
    static WorldDef DefOf(int workers) {
        WorldDef def;
        def.gravity = {0.0f, -10.0f};
        def.workerCount = workers;
        return def;
    }
    float Any(float low, float high) { return std::uniform_real_distribution<float>(low, high)(m_random); }

    void AddChain(Vec2 place) { AddChain(place, {0.5f, 0.0f}, {Any(-3.0f, 3.0f), Any(-80.0f, -5.0f)}); }
    /// Upright ones that touch, or nearly, and come down at the same time.
    void AddSheaf(Vec2 place) {
        const Vec2 speed{0.0f, Any(-80.0f, -20.0f)};
        const float spacing = Any(0.35f, 0.42f);
        const int chains = 2 + static_cast<int>(m_random() % 3);
        for (int i = 0; i < chains; ++i) {
            AddChain(place + Vec2(spacing * static_cast<float>(i), Any(-0.1f, 0.1f)), {0.0f, 0.5f}, speed);
        }
    }
    void AddChain(Vec2 place, Vec2 way, Vec2 speed) {
        const int links = 2 + static_cast<int>(m_random() % 4);
        const uint32_t kind = m_random() % 12;
        Body* last = nullptr;
        for (int i = 0; i < links; ++i) {
            const Vec2 at = place + static_cast<float>(i) * way;
            Body* link = AddBody(world, dynamicBody, at);
            Fixture* fixture =
                m_random() % 2 == 0 ? AddCircle(link, 0.2f) : AddBox(link, Any(0.15f, 0.22f), Any(0.05f, 0.2f));
            fixture->SetRestitution(m_random() % 4 == 0 ? 0.5f : 0.0f);
            fixture->SetRollingResistance(m_random() % 4 == 0 ? 0.1f : 0.0f);
            link->SetLinearVelocity(speed);
            m_bodies.push_back(link);
            if (last != nullptr) Hold(kind, last, link, at - 0.5f * way, way);
            last = link;
        }
    }

    /// By a joint of some kind, a third of them by plain hinges.
    void Hold(uint32_t kind, Body* a, Body* b, Vec2 at, Vec2 way) {
        RevoluteJointDef hinge;
        hinge.Initialize(a, b, at);
        WeldJointDef weld;
        weld.Initialize(a, b, at);
        DistanceJointDef rod;
        rod.Initialize(a, b, a->GetPosition(), b->GetPosition());
        PrismaticJointDef slider;
        slider.Initialize(a, b, at, way);
        WheelJointDef wheel;
        wheel.Initialize(a, b, at, way);
        MotorJointDef motor;
        motor.Initialize(a, b);
        hinge.enableLimit = slider.enableLimit = true;
        hinge.lowerAngle = -0.2f, hinge.upperAngle = 0.3f;
        slider.lowerTranslation = -0.1f, slider.upperTranslation = 0.05f;
        hinge.enableMotor = kind == 1, hinge.motorSpeed = 3.0f, hinge.maxMotorTorque = 5.0f;
        weld.stiffness = kind == 3 ? 40.0f : 0.0f, weld.damping = 1.0f;
        wheel.stiffness = 100.0f, wheel.damping = 2.0f;
        motor.maxForce = motor.maxTorque = 100.0f;
        RevoluteJointDef plain;
        plain.Initialize(a, b, at);
        const JointDef* const defs[] = {&hinge, &hinge, &weld, &weld, &rod, &slider, &wheel, &motor};
        world.CreateJoint(kind < std::size(defs) ? defs[kind] : &plain);
    }

    std::mt19937 m_random;
    std::vector<Body*> m_bodies;
};

/// With a number of sub-steps, or a tolerance.
void StepWorlds(uint32_t seed, std::initializer_list<FallingChains*> all) {
    constexpr float dt = 1.0f / 60.0f;
    for (FallingChains* one : all) {
        seed % 3 == 0 ? one->world.Step(dt, Tolerance{}) : one->world.Step(dt, 4);
    }
}

/// But for the order of contacts that impacts make: an impact may follow on one of a round, and come before others of
/// that round.
TEST(ImpactRounds, AreTheImpactsOneByOne) {
    size_t largest = 0;
    int compared = 0, reordered = 0;
    for (uint32_t seed = 0; seed < 60; ++seed) {
        FallingChains together(seed, 1, Rounds::asUsual), oneByOne(seed, 1, Rounds::ofOneImpact);
        for (int step = 0; step < 40; ++step) {
            StepWorlds(seed, {&together, &oneByOne});
            if (together.GetContacts() != oneByOne.GetContacts()) {
                ++reordered;
                break;
            }
            ASSERT_EQ(together.GetStates(), oneByOne.GetStates()) << "seed " << seed << ", step " << step;
            ++compared;
        }
        EXPECT_LE(oneByOne.GetLargestRound(), 1u);
        largest = std::max(largest, together.GetLargestRound());
    }
    EXPECT_GT(largest, 4u);
    EXPECT_GT(compared, 1200);
    EXPECT_LT(reordered, 30);
}

TEST(ImpactRounds, DoNotHangOnTheNumberOfWorkers) {
    size_t most = 0;
    for (uint32_t seed = 100; seed < 130; ++seed) {
        FallingChains one(seed, 1, Rounds::asUsual), three(seed, 3, Rounds::asUsual);
        for (int step = 0; step < 40; ++step) {
            StepWorlds(seed, {&one, &three});
            ASSERT_EQ(one.GetStates(), three.GetStates()) << "seed " << seed << ", step " << step;
        }
        ASSERT_EQ(inspect::GetStateHash(one.world), inspect::GetStateHash(three.world)) << "seed " << seed;
        most = std::max(most, three.GetLargestRound());
    }
    EXPECT_GT(most, 4u);
}

/// Writes down what it hears, and on which threads.
class Ear : public ContactListener {
public:
    void BeginContact(Contact* contact) override { Note(0, contact); }
    void EndContact(Contact* contact) override { Note(1, contact); }
    void PreSolve(Contact* contact, const Manifold*) override { Note(2, contact); }
    void PostSolve(Contact* contact, const ContactImpulse* impulse) override {
        Note(3, contact);
        m_heard.push_back(impulse->normalImpulses[0]);
    }

    [[nodiscard]] const std::vector<float>& GetHeard() const { return m_heard; }
    [[nodiscard]] bool IsOnOneThread() const { return m_others == 0; }

private:
    void Note(int call, const Contact* contact) {
        const std::lock_guard lock(m_mutex);
        m_others += std::this_thread::get_id() == m_thread ? 0 : 1;
        m_heard.push_back(static_cast<float>(call));
        m_heard.push_back(static_cast<float>(contact->GetIndex()));
    }

    const std::thread::id m_thread = std::this_thread::get_id();
    std::mutex m_mutex;
    std::vector<float> m_heard;
    int m_others = 0;
};

TEST(ImpactRounds, AreHeardOfOnTheThreadOfTheStep) {
    size_t largest = 0;
    for (uint32_t seed = 200; seed < 215; ++seed) {
        FallingChains one(seed, 1, Rounds::asUsual), three(seed, 3, Rounds::asUsual), deaf(seed, 3, Rounds::asUsual);
        Ear ofOne, ofThree;
        one.world.SetContactListener(&ofOne), three.world.SetContactListener(&ofThree);
        for (int step = 0; step < 30; ++step) {
            StepWorlds(seed, {&one, &three, &deaf});
            ASSERT_EQ(three.GetStates(), deaf.GetStates()) << "seed " << seed << ", step " << step;
        }
        ASSERT_TRUE(ofThree.IsOnOneThread()) << "seed " << seed;
        ASSERT_EQ(ofOne.GetHeard(), ofThree.GetHeard()) << "seed " << seed;
        largest = std::max(largest, three.GetLargestRound());
    }
    EXPECT_GT(largest, 4u);
}

}  // namespace
}  // namespace scree
