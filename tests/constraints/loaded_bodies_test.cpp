// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What one search for loads has found is not known to the next.

#include "constraints/loaded_bodies.h"

#include <gtest/gtest.h>

#include "tests/world/fixtures.h"
#include "world/world_state.h"

namespace scree {
namespace {

using namespace test;

TEST(LoadedBodies, ForgetWhatWasRaisedBesideTheBodiesOfAStep) {
    World world({0.0f, -10.0f});
    Body* const feather = AddBody(world, dynamicBody, {0.0f, 0.5f});
    Body* const light = AddBody(world, dynamicBody, {0.0f, 1.49f});
    Body* const heavy = AddBody(world, dynamicBody, {0.0f, 2.48f});
    Body* const apart = AddBody(world, dynamicBody, {50.0f, 0.0f});
    AddBox(feather, 0.5f, 0.5f, 0.001f);
    AddBox(light, 0.5f, 0.5f, 1.0f);
    AddBox(heavy, 0.5f, 0.5f, 10000.0f);
    AddBox(apart, 0.5f, 0.5f, 10000.0f);
    world.Step(0.0f, 8, 3);
    WorldState& s = world.GetState();
    const auto contactOf = [&s](Body* a, Body* b) {
        for (const ContactIndex c : s.contacts.Rows()) {
            const ContactPair& pair = s.contacts.pair[c];
            const auto isOf = [&pair](Body* body) {
                return pair.bodyA == BodyIndex{body->GetIndex()} || pair.bodyB == BodyIndex{body->GetIndex()};
            };
            if (s.contacts.IsAlive(c) && isOf(a) && isOf(b)) return c;
        }
        return ContactIndex::none;
    };
    const auto raise = [&s](LoadedBodies& loaded, std::initializer_list<Body*> of, ContactIndex contact) {
        std::vector<BodyIndex> bodies;
        for (Body* body : of) bodies.push_back(BodyIndex{body->GetIndex()});
        const std::vector<ContactIndex> list{contact};
        loaded.Raise({.pool = *s.pool,
                      .fixtures = s.fixtures,
                      .contacts = s.contacts,
                      .joints = s.joints,
                      .bodies = bodies,
                      .list = list,
                      .gravity = {0.0f, -10.0f},
                      .dt = frame,
                      .stiffness = 35000.0f,
                      .depth = 0.0025f,
                      .raisesJointed = true},
                     s.bodies);
        const bool isAny = !loaded.IsEmpty();
        const ContactImpulse none{};
        loaded.Lower(s.bodies, {&none, 1});
        return isAny;
    };
    LoadedBodies before, fresh;
    EXPECT_TRUE(raise(before, {heavy, apart, feather}, contactOf(heavy, light)));  // light is none of them
    EXPECT_FALSE(raise(fresh, {apart, feather}, contactOf(light, feather)));
    EXPECT_FALSE(raise(before, {apart, feather}, contactOf(light, feather)));
}

}  // namespace
}  // namespace scree
