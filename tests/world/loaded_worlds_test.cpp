// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A world that is loaded looks at all bodies in its first step, the one that was saved only at those that do not rest.
// Both go on alike, whatever was asleep, edited, ended or lost before. Each case was found by tests/fuzz.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "fixtures.h"
#include "scree/snapshot.h"
#include "world/world_state.h"

namespace scree::test {
namespace {

class LoadedWorlds : public testing::Test {
protected:
    static constexpr int rounds = 50;

    float Between(float low, float high) { return std::uniform_real_distribution(low, high)(m_random); }
    Vec2 PointWithin(float reach) { return {Between(-reach, reach), Between(-reach, reach)}; }
    bool Flip() { return m_random() % 2 == 0; }
    int OneOf(int count) { return static_cast<int>(m_random() % static_cast<unsigned>(count)); }

    BroadPhaseKind AnyBroadPhase() {
        return static_cast<BroadPhaseKind>(OneOf(static_cast<int>(std::size(broadPhaseNames))));
    }
    /// In the distance.
    static void AddStatics(World& world, int count) {
        for (int i = 0; i < count; ++i)
            AddBox(AddBody(world, staticBody, {static_cast<float>(3 * i), -20.0f}), 1.0f, 1.0f);
    }

    static void ExpectAlike(World& world, int steps = 3) {
        SnapshotError error = SnapshotError::ok;
        const std::unique_ptr<World> loaded = LoadWorld(SaveWorld(world), &error);
        ASSERT_EQ(error, SnapshotError::ok) << GetName(error);
        for (int i = 0; i <= steps; ++i) {
            ASSERT_EQ(inspect::GetStateHash(*loaded), inspect::GetStateHash(world)) << "after " << i << " steps";
            if (i < steps) world.Step(frame, 4), loaded->Step(frame, 4);
        }
    }

    static bool IsFinite(const Body* body) {
        const Vec2 v = body->GetLinearVelocity();
        return body->GetPosition().IsValid() && v.IsValid() && std::isfinite(body->GetAngularVelocity());
    }
    static void ExpectFinite(World& world) {
        for (const Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
            EXPECT_TRUE(IsFinite(body)) << "body " << body->GetIndex();
    }

private:
    const unsigned m_seed = std::random_device{}();
    std::mt19937 m_random{m_seed};
    testing::ScopedTrace m_trace{__FILE__, __LINE__, "seed " + std::to_string(m_seed)};
};

Body* AddSleeper(World& world, BodyType type, Vec2 position) {
    BodyDef def;
    def.type = type;
    def.position = position;
    def.awake = false;
    return world.CreateBody(&def);
}

TEST_F(LoadedWorlds, SleepersThatOverlapMeetNothing) {
    for (int round = 0; round < rounds; ++round) {
        World world({0.0f, -10.0f});
        const Vec2 at = PointWithin(10.0f);
        AddCircle(AddSleeper(world, kinematicBody, at), Between(0.5f, 2.0f));
        for (int i = OneOf(3); i > 0; --i) world.Step(frame, 4);
        Body* sleeper = AddSleeper(world, dynamicBody, at + PointWithin(0.2f));
        AddCircle(sleeper, Between(0.1f, 2.0f));
        ExpectAlike(world);
        EXPECT_EQ(world.GetReport().continuousEventCount, 0);
        EXPECT_FALSE(sleeper->IsAwake());
    }
}

TEST_F(LoadedWorlds, ContactsEndAlikeWhereNothingMoves) {
    for (int round = 0; round < rounds; ++round) {
        World world({0.0f, -10.0f});
        const Vec2 at = PointWithin(10.0f);
        Fixture* ground = AddCircle(AddBody(world, staticBody, at), 1.0f);
        Fixture* sleeper = AddCircle(AddSleeper(world, dynamicBody, at + PointWithin(0.5f)), 1.0f);
        for (int i = 1 + OneOf(3); i > 0; --i) world.Step(frame, 4);
        ASSERT_EQ(world.GetContactCount(), 1);
        (Flip() ? ground : sleeper)->SetFilterData({1, 0, 0});
        if (Flip()) world.Step(0.0f, 4);
        ExpectAlike(world);
        EXPECT_EQ(world.GetContactCount(), 0);
    }
}

/// A kinematic body that will be `way` further left after a step.
Body* AddHammer(World& world, Vec2 position, float way, float halfHeight) {
    Body* hammer = AddBody(world, kinematicBody, position);
    AddBox(hammer, 0.5f, halfHeight);
    hammer->SetLinearVelocity({-way / frame, 0.0f});
    return hammer;
}

TEST_F(LoadedWorlds, WhatIsAddedToASleeperIsMet) {
    for (int round = 0; round < rounds; ++round) {
        WorldDef def;
        def.gravity = {0.0f, 0.0f};
        def.broadPhase = AnyBroadPhase();
        World world(def);
        AddStatics(world, OneOf(100));
        Body* sleeper = AddSleeper(world, dynamicBody, {0.0f, 0.0f});
        AddCircle(sleeper, 0.5f);
        for (int i = 1 + OneOf(3); i > 0; --i) world.Step(frame, 4);
        CircleShape shape;
        shape.m_radius = Between(0.2f, 0.6f), shape.m_p = {10.0f, 0.0f};
        ASSERT_NE(sleeper->CreateFixture(&shape, 1.0f), nullptr);
        AddHammer(world, {14.0f, Between(-0.5f, 0.5f)}, Between(6.0f, 8.0f), 2.0f);
        ExpectAlike(world, 1);
        EXPECT_GT(world.GetReport().continuousEventCount, 0);
        EXPECT_TRUE(sleeper->IsAwake());
    }
}

TEST_F(LoadedWorlds, ContactsOfWhatAnImpactWakesEndInThatStep) {
    for (int round = 0; round < rounds; ++round) {
        World world({0.0f, 0.0f});
        Body* sleeper = AddBody(world, dynamicBody, {0.0f, 0.0f});
        AddCircle(sleeper, 0.5f);
        AddBox(AddBody(world, staticBody, {0.6f, 0.6f}), 0.2f, 0.2f);  // its box overlaps that of the circle
        Body* hammer = AddHammer(world, {Between(5.0f, 6.0f), -1.5f}, 0.0f, 1.5f);
        AddSleeper(world, dynamicBody, {0.0f, 50.0f});  // goes on resting
        world.Step(frame, 4);
        sleeper->SetAwake(false);
        world.Step(frame, 4);
        ASSERT_EQ(world.GetContactCount(), 1);
        hammer->SetLinearVelocity({-Between(8.0f, 10.0f) / frame, 0.0f});
        world.Step(frame, 4);
        ASSERT_LT(sleeper->GetPosition().x, -1.0f);
        EXPECT_EQ(world.GetContactCount(), 1);  // with the hammer
        ExpectAlike(world);
    }
}

TEST_F(LoadedWorlds, CentresOfMassStayInRange) {
    constexpr float farthest = 1e18f;
    for (int round = 0; round < 20 * rounds; ++round) {
        World world({0.0f, 0.0f});
        Body* body = AddBody(world, dynamicBody, {0.0f, 0.0f});
        CircleShape shape;
        shape.m_p = {Flip() ? farthest : -farthest, Between(-20.0f, 20.0f)};
        const float density = std::exp2(Between(-80.0f, -46.0f));  // the inertia is in range
        for (int i = 1 + OneOf(3); i > 0; --i) {
            shape.m_radius = std::exp2(Between(-6.0f, 20.0f));
            body->CreateFixture(&shape, density);
        }
        const Vec2 centre = body->GetLocalCenter();
        EXPECT_NEAR(centre.x / shape.m_p.x, 1.0f, 1e-6f);
        EXPECT_LE(std::abs(centre.x), farthest);
        ExpectAlike(world, 1);
    }
}

TEST_F(LoadedWorlds, BodiesStayFiniteUnderGravityBeyondAllBounds) {
    for (int round = 0; round < rounds; ++round) {
        WorldDef def;
        def.exactDrift = true;
        def.subStepping = Flip();
        World world(def);
        world.SetGravity(std::exp2(Between(120.0f, 127.0f)) * PointWithin(1.0f));
        Body* body = AddBody(world, dynamicBody, PointWithin(0.5f));
        AddCircle(body, Between(0.5f, 1.0f), Between(1.0f, 5.0f));
        AddHammer(world, {4.0f, 0.0f}, Between(4.0f, 8.0f), 2.0f);
        for (int i = 0; i < 3; ++i) {
            Flip() ? world.Step(frame, 8, 3) : world.Step(frame, 1 + OneOf(4));
            ExpectFinite(world);
        }
        ExpectAlike(world);
    }
}

TEST_F(LoadedWorlds, RotationsStayUnitVectorsAtAnyAngle) {
    for (int round = 0; round < 4 * rounds; ++round) {
        World world({0.0f, 0.0f});
        std::vector<Body*> bodies;
        const bool touches = Flip();  // small islands are solved in lanes
        for (int i = 0; i < 20; ++i) {
            Body* body = AddBody(world, dynamicBody, {4.0f * static_cast<float>(i), 0.0f},
                                 std::exp2(Between(-4.0f, 59.0f)) * (Flip() ? 1.0f : -1.0f));
            AddCircle(body, 1.0f);
            body->SetAngularVelocity(std::exp2(Between(-4.0f, 59.0f)));
            bodies.push_back(body);
            if (touches) AddCircle(AddBody(world, dynamicBody, body->GetPosition() + Vec2{1.9f, 0.0f}), 1.0f);
        }
        for (int i = 0; i < 3; ++i) {
            Flip() ? world.Step(frame, 8, 3) : world.Step(frame, 1 + OneOf(4));
            for (const Body* body : bodies) {
                const Rot q = body->GetTransform().q;
                ASSERT_NEAR(q.s * q.s + q.c * q.c, 1.0f, 1e-6f) << body->GetAngle();
            }
        }
        ExpectAlike(world);
    }
}

TEST_F(LoadedWorlds, OfBodiesInPlacesThatNoProgramCanGiveThemThereAreNone) {
    World world({0.0f, -10.0f});
    Body* body = AddBody(world, dynamicBody, {1e18f, -1e18f});
    CircleShape far;
    far.m_p = {1e18f, -1e18f}, far.m_radius = 1.0f;
    body->CreateFixture(&far, 1e-3f);
    ASSERT_NE(LoadWorld(SaveWorld(world)), nullptr) << "what a program can give";
    BodyTable& bodies = world.GetState().bodies;
    const BodyIndex row{body->GetIndex()};
    const auto expectRefused = [&](float& value, float bad) {
        const float good = value;
        value = bad;
        SnapshotError error = SnapshotError::ok;
        EXPECT_EQ(LoadWorld(SaveWorld(world), &error), nullptr) << bad;
        EXPECT_EQ(error, SnapshotError::badContent);
        value = good;
    };
    for (int round = 0; round < rounds; ++round) {
        const float beyond = std::exp2(Between(64.0f, 127.9f)) * (Flip() ? 1.0f : -1.0f);
        expectRefused(bodies.position[row].c.x, beyond);
        expectRefused(bodies.position[row].c.y, beyond);
        expectRefused(bodies.startPosition[row].c.x, beyond);
        expectRefused(bodies.transform[row].p.y, beyond);
        expectRefused(bodies.transform[row].q.s, Between(1.01f, 1e6f));
    }
}

/// In the midst of a sub-stepped step.
class UnfinishedSteps : public LoadedWorlds {
protected:
    /// Two balls hit a paddle that comes to meet them; the step stops at the first impact.
    void Begin() {
        WorldDef def;
        def.gravity = {0.0f, -10.0f};
        def.subStepping = true;
        m_world = std::make_unique<World>(def);
        m_paddle = AddBody(*m_world, kinematicBody, {0.0f, 0.0f});
        AddBox(m_paddle, 5.0f, 0.1f);
        m_paddle->SetLinearVelocity({0.0f, Between(10.0f, 100.0f)});
        m_paddle->SetAngularVelocity(Between(-1.0f, 1.0f));
        for (const float x : {-1.0f, 1.0f}) {
            m_ball = AddBody(*m_world, dynamicBody, {x, Between(1.0f, 3.0f)});
            AddCircle(m_ball, 0.2f);
            m_ball->SetLinearVelocity({0.0f, -Between(300.0f, 600.0f)});
        }
        m_world->Step(frame, 4);
        ASSERT_EQ(m_world->GetReport().continuousEventCount, 1);
    }

    std::unique_ptr<World> m_world;
    Body* m_paddle = nullptr;
    Body* m_ball = nullptr;
};

TEST_F(UnfinishedSteps, WhatBecomesStaticStaysWhereItIs) {
    for (int round = 0; round < rounds; ++round) {
        Begin();
        const Vec2 before = m_paddle->GetPosition();
        m_paddle->SetType(staticBody);
        ExpectAlike(*m_world, 6);
        EXPECT_EQ(m_paddle->GetPosition(), before);
    }
}

TEST_F(UnfinishedSteps, WhatIsPutToSleepGoesOnFromWhereItIs) {
    for (int round = 0; round < rounds; ++round) {
        Begin();
        const Vec2 before = m_paddle->GetPosition();
        m_paddle->SetAwake(false);  // its velocity is 0
        if (Flip()) m_ball->SetAwake(false);
        ExpectAlike(*m_world, 6);
        EXPECT_EQ(m_paddle->GetPosition(), before);
    }
}

/// While most joints rest, a step asks the bodies that are awake for theirs; in which order joints were made still
/// counts.
TEST_F(LoadedWorlds, FewJointsAmongManyThatRest) {
    constexpr int pairs = 500;
    for (int round = 0; round < rounds; ++round) {
        World world({0.0f, -10.0f});
        const auto join = [&](Body* a, Body* b) {
            RevoluteJointDef def;
            def.Initialize(a, b, 0.5f * (a->GetPosition() + b->GetPosition()));
            return world.CreateJoint(&def);
        };
        std::vector<Joint*> resting;
        std::vector<Body*> sleepers;
        for (int i = 0; i < pairs; ++i) {
            const Vec2 place{static_cast<float>(4 * i), 30.0f};
            Body* a = AddSleeper(world, dynamicBody, place);
            Body* b = AddSleeper(world, dynamicBody, place + Vec2{1.0f, 0.0f});
            AddBox(a, 0.4f, 0.4f), AddBox(b, 0.4f, 0.4f);
            resting.push_back(join(a, b));
            sleepers.push_back(a);
        }
        // Joints made later take the places of these.
        for (int i = 0; i < 12; ++i) {
            const size_t which = static_cast<size_t>(OneOf(static_cast<int>(resting.size())));
            world.DestroyJoint(resting[which]);
            resting.erase(resting.begin() + static_cast<std::ptrdiff_t>(which));
        }
        std::vector<Body*> net;
        for (int i = 0; i < 7; ++i) {
            net.push_back(AddBody(world, dynamicBody, PointWithin(3.0f)));
            AddBox(net.back(), Between(0.1f, 0.5f), Between(0.1f, 0.5f));
        }
        for (size_t i = 1; i < net.size(); ++i) join(net[i], net[static_cast<size_t>(OneOf(static_cast<int>(i)))]);
        for (int i = 0; i < 5; ++i) {
            const size_t a = static_cast<size_t>(OneOf(7)), b = (a + 1 + static_cast<size_t>(OneOf(6))) % 7;
            join(net[a], net[b]);
        }
        for (int i = 0; i < 3; ++i) world.Step(frame, 4);
        if (Flip()) join(net[0], sleepers[static_cast<size_t>(OneOf(pairs))]);  // which wakes it
        ExpectAlike(world, 4);
    }
}

TEST_F(LoadedWorlds, RememberManifoldsThatAProgramHasSet) {
    for (int round = 0; round < rounds && !HasFailure(); ++round) {
        World world({0.0f, -10.0f});
        AddGround(world);
        for (int i = 0; i < 4; ++i) {
            Body* body = AddBody(world, dynamicBody, {1.5f * static_cast<float>(i), 0.5f - Between(0.0f, 0.1f)});
            AddBox(body, 0.5f, 0.5f);
        }
        for (int i = 0; i < 4; ++i) world.Step(frame, 4);
        int set = 0;
        for (Contact* contact = world.GetContactList(); contact != nullptr; contact = contact->GetNext()) {
            Manifold manifold = contact->GetManifold();
            if (Flip()) manifold.localPoint.y += Between(-0.1f, 0.1f);
            if (Flip()) continue;
            ASSERT_EQ(contact->SetManifold(manifold), ErrorCode::ok);
            ++set;
        }
        SCOPED_TRACE(std::to_string(set) + " manifolds set");
        ExpectAlike(world);
    }
}

}  // namespace
}  // namespace scree::test
