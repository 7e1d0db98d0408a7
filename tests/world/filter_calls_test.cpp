// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A program's filter is asked about a pair when its boxes begin to overlap, and again when there is a reason: not in
// every step.

#include <gtest/gtest.h>

#include "tests/geometry/source.h"
#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

struct Refuse final : ContactFilter {
    int calls = 0;
    bool answer = false;
    bool ShouldCollide(Fixture*, Fixture*) override { return ++calls, answer; }
};

struct Overlapping {
    explicit Overlapping(int count) : world({0.0f, 0.0f}) {
        world.SetContactFilter(&filter);
        for (int i = 0; i < count; ++i) {
            bodies.push_back(AddBody(world, dynamicBody, {0.01f * static_cast<float>(i), 0.0f}));
            AddBox(bodies.back(), 0.5f, 0.5f);
        }
    }
    int CallsIn(int steps) {
        filter.calls = 0;
        StepFor(world, steps);
        return filter.calls;
    }
    World world;
    Refuse filter;
    std::vector<Body*> bodies;
};

TEST(FilterCalls, OneForEachPairThatBegins) {
    for (const int count : {2, 7, 30}) {
        Overlapping s(count);
        EXPECT_EQ(s.CallsIn(1), count * (count - 1) / 2);
        EXPECT_EQ(s.CallsIn(60), 0);
    }
}

TEST(FilterCalls, AgainWhenThePairPartsAndMeets) {
    Overlapping s(3);
    s.CallsIn(5);
    s.bodies[0]->SetTransform({20.0f, 0.0f}, 0.0f);
    EXPECT_EQ(s.CallsIn(5), 0);
    s.bodies[0]->SetTransform({0.0f, 0.0f}, 0.0f);
    EXPECT_EQ(s.CallsIn(5), 2);
}

TEST(FilterCalls, AgainWhenAskedForAndForANewFilter) {
    Overlapping s(4);
    s.CallsIn(3);
    s.bodies[1]->GetFixtureList()->Refilter();
    EXPECT_EQ(s.CallsIn(3), 3);
    s.bodies[2]->GetFixtureList()->SetFilterData({2, 0xFFFF, 0});
    EXPECT_EQ(s.CallsIn(3), 3);
    Refuse other;
    s.world.SetContactFilter(&other);
    s.bodies[0]->SetTransform({0.001f, 0.0f}, 0.0f);
    StepFor(s.world, 3);
    EXPECT_EQ(other.calls, 6);
    s.world.SetContactFilter(nullptr);
    s.bodies[0]->SetTransform({0.0f, 0.0f}, 0.0f);
    StepFor(s.world, 1);
    EXPECT_EQ(s.world.GetContactCount(), 6);
}

/// A new fixture that takes the number of a destroyed one is a new pair.
TEST(FilterCalls, AgainForAFixtureThatTakesTheNumberOfAnother) {
    Overlapping s(3);
    s.CallsIn(3);
    const int index = s.bodies[2]->GetFixtureList()->GetIndex();
    s.world.DestroyBody(s.bodies[2]);
    s.bodies[2] = AddBody(s.world, dynamicBody, {0.02f, 0.0f});
    AddBox(s.bodies[2], 0.5f, 0.5f);
    EXPECT_EQ(s.bodies[2]->GetFixtureList()->GetIndex(), index);
    EXPECT_EQ(s.CallsIn(3), 2);
}

TEST(FilterCalls, WhatIsLetThroughIsAskedOnceToo) {
    Overlapping s(5);
    s.filter.answer = true;
    EXPECT_EQ(s.CallsIn(1), 10);
    EXPECT_EQ(s.world.GetContactCount(), 10);
}

TEST(FilterCalls, WhatOnlyTheProgramsFilterLetThroughStaysWithoutIt) {
    for (const int count : {3, 5, 60}) {
        Overlapping s(count);
        s.filter.answer = true;
        // Of one group: of themselves they do not meet.
        for (Body* body : s.bodies) {
            body->GetFixtureList()->SetSensor(true);
            body->GetFixtureList()->SetFilterData({1, 0xFFFF, -1});
        }
        s.world.SetContactFilter(nullptr);
        StepFor(s.world, 2);
        EXPECT_EQ(s.world.GetContactCount(), 0);
        s.world.SetContactFilter(&s.filter);
        s.CallsIn(1);
        const int all = count * (count - 1) / 2;
        EXPECT_EQ(s.world.GetContactCount(), all);
        s.world.SetContactFilter(nullptr);
        StepFor(s.world, 3);
        EXPECT_EQ(s.world.GetContactCount(), all);
        s.bodies[1]->GetFixtureList()->Refilter();
        StepFor(s.world, 3);
        EXPECT_EQ(s.world.GetContactCount(), all - (count - 1));
    }
}

/// Sensors that drift through each other, whose filters change all the time, against all pairs tried.
TEST(FilterCalls, ContactsAreThoseThatTheFiltersOfTheMomentAllow) {
    Source source(41);
    for (int round = 0; round < 20; ++round) {
        World world({0.0f, 0.0f});
        world.SetAllowSleeping(source.Chance(2));
        std::vector<Body*> bodies;
        const auto randomFilter = [&] {
            const auto bits = [&] { return static_cast<uint16_t>(1 + source.Below(7)); };
            return Filter{bits(), bits(), static_cast<int16_t>(source.Chance(2) ? source.Below(5) - 2 : 0)};
        };
        for (int i = 0, count = 2 + source.Below(60); i < count; ++i) {
            bodies.push_back(AddBody(world, dynamicBody, source.InSquare(3.0f)));
            AddBox(bodies.back(), 0.5f, 0.5f)->SetSensor(true);
            bodies.back()->GetFixtureList()->SetFilterData(randomFilter());
            bodies.back()->SetLinearVelocity(source.InSquare(0.1f));
        }
        for (int step = 0; step < 40; ++step) {
            for (int edits = source.Below(4); edits > 0; --edits) {
                Body* body = bodies[static_cast<size_t>(source.Below(static_cast<int>(bodies.size())))];
                body->GetFixtureList()->SetFilterData(randomFilter());
            }
            StepFor(world, 2);
            // What touched when it was refused or parted ends in the next step.
            std::vector<Vec2> velocities;
            for (Body* body : bodies) {
                velocities.push_back(body->GetLinearVelocity());
                body->SetLinearVelocity(vec2Zero);
            }
            StepFor(world, 1);
            for (size_t i = 0; i < bodies.size(); ++i) bodies[i]->SetLinearVelocity(velocities[i]);
            int expected = 0;
            for (size_t i = 0; i < bodies.size(); ++i) {
                for (size_t j = 0; j < i; ++j) {
                    const Fixture &a = *bodies[i]->GetFixtureList(), &b = *bodies[j]->GetFixtureList();
                    const Filter f = a.GetFilterData(), g = b.GetFilterData();
                    const bool sameGroup = f.groupIndex == g.groupIndex && f.groupIndex != 0;
                    const bool areAllowed =
                        sameGroup ? f.groupIndex > 0
                                  : (f.maskBits & g.categoryBits) != 0 && (f.categoryBits & g.maskBits) != 0;
                    const bool overlap = TestOverlap(a.GetAABB(), b.GetAABB());
                    expected += areAllowed && overlap ? 1 : 0;
                }
            }
            ASSERT_EQ(world.GetContactCount(), expected) << "round " << round << ", step " << step;
        }
    }
}

/// Takes itself away in its first call; the engine must not call it again in that step.
struct OnceOnly final : ContactListener {
    explicit OnceOnly(World& w) : world(w) {}
    void BeginContact(Contact*) override { Note(); }
    void PreSolve(Contact*, const Manifold*) override { Note(); }
    void PostSolve(Contact*, const ContactImpulse*) override { Note(); }
    void EndContact(Contact*) override { Note(); }
    void Note() {
        ++calls;
        world.SetContactListener(nullptr);
    }
    World& world;
    int calls = 0;
};

TEST(ListenerCalls, NoneAfterTheListenerWasTakenAway) {
    for (const int substeps : {0, 4}) {
        World world({0.0f, -10.0f});
        AddGround(world, 20.0f);
        for (int i = 0; i < 30; ++i)
            AddBox(AddBody(world, dynamicBody, {static_cast<float>(i % 6), 0.5f + static_cast<float>(i / 6)}), 0.5f,
                   0.5f);
        OnceOnly listener(world);
        for (int step = 0; step < 5; ++step) {
            listener.calls = 0;
            world.SetContactListener(&listener);
            StepWith(world, substeps);
            EXPECT_EQ(listener.calls, 1);
        }
    }
}

}  // namespace
}  // namespace scree::test
