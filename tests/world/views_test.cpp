// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Views of all bodies and contacts say what the accessors of each say, bit for bit, in worlds that change.

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "scree/inspect.h"
#include "scree/scree.h"

namespace scree::test {
namespace {

void ExpectBodies(const World& world) {
    std::vector<inspect::BodyView> views;
    inspect::GetBodies(world, views);
    size_t at = 0;
    for (const Body* b = world.GetBodyList(); b != nullptr; b = b->GetNext(), ++at) {
        ASSERT_LT(at, views.size());
        const inspect::BodyView& view = views[at];
        EXPECT_EQ(view.body, b);
        EXPECT_EQ(view.generation, world.GetId(b).generation);
        const Fixture* newest = b->GetFixtureList();
        EXPECT_EQ(view.newestFixture.index, newest == nullptr ? -1 : world.GetId(newest).index);
        if (newest != nullptr) {
            EXPECT_EQ(view.newestFixture.generation, world.GetId(newest).generation);
        }
        EXPECT_EQ(view.type, b->GetType());
        EXPECT_EQ(view.isAwake, b->IsAwake());
        EXPECT_TRUE(view.position == b->GetPosition());
        EXPECT_EQ(view.angle, b->GetAngle());
        EXPECT_TRUE(view.linearVelocity == b->GetLinearVelocity());
        EXPECT_EQ(view.angularVelocity, b->GetAngularVelocity());
    }
    EXPECT_EQ(at, views.size());
}

int ExpectContacts(const World& world) {
    inspect::TouchingContacts touching;
    touching.Take(world);
    std::vector<inspect::ContactView> views;
    touching.ForEach([&views](const inspect::ContactView& view) { views.push_back(view); });
    EXPECT_EQ(touching.Count(), static_cast<int>(views.size()));
    size_t at = 0;
    for (const Contact* c = world.GetContactList(); c != nullptr; c = c->GetNext()) {
        if (!c->IsTouching()) continue;
        if (at == views.size()) {
            ADD_FAILURE() << "a contact is missing";
            return 0;
        }
        const inspect::ContactView& view = views[at++];
        EXPECT_EQ(view.fixtureA, c->GetFixtureA()->GetIndex());
        EXPECT_EQ(view.fixtureB, c->GetFixtureB()->GetIndex());
        EXPECT_EQ(view.isSensor, c->GetFixtureA()->IsSensor() || c->GetFixtureB()->IsSensor());
        const Manifold manifold = c->GetManifold();
        EXPECT_EQ(view.manifold.pointCount, manifold.pointCount);
        WorldManifold placed;
        placed.normal.SetZero();
        if (manifold.pointCount > 0) c->GetWorldManifold(&placed);
        const WorldManifold points = view.GetPoints();
        EXPECT_TRUE(points.normal == placed.normal);
        for (int i = 0; i < manifold.pointCount; ++i) {
            EXPECT_TRUE(points.points[i] == placed.points[i]);
            EXPECT_EQ(points.separations[i], placed.separations[i]);
            EXPECT_EQ(view.manifold.points[i].normalImpulse, manifold.points[i].normalImpulse);
            EXPECT_EQ(view.manifold.points[i].tangentImpulse, manifold.points[i].tangentImpulse);
        }
    }
    EXPECT_EQ(at, views.size());
    return static_cast<int>(at);
}

TEST(Views, SayWhatAccessorsSay) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto between = [&](float a, float b) { return std::uniform_real_distribution<float>(a, b)(random); };
    int contacts = 0;
    for (const float far : {0.0f, 30000.0f}) {
        World world(Vec2{0.0f, -10.0f});
        const BodyDef still;
        EdgeShape edge;
        edge.SetTwoSided({far - 8.0f, 0.0f}, {far + 8.0f, 0.0f});
        world.CreateBody(&still)->CreateFixture(&edge, 0.0f);
        std::vector<Body*> bodies;
        for (int step = 0; step < 120; ++step) {
            if (step % 3 == 0) {
                BodyDef def;
                def.type = step % 9 == 0 ? kinematicBody : dynamicBody;
                def.position = {far + between(-6.0f, 6.0f), between(0.5f, 6.0f)};
                Body* body = world.CreateBody(&def);
                bodies.push_back(body);
                CircleShape circle;
                circle.m_radius = between(0.2f, 0.6f);
                PolygonShape box;
                box.SetAsBox(between(0.2f, 0.6f), between(0.2f, 0.6f));
                FixtureDef fixture;
                fixture.shape = step % 2 == 0 ? static_cast<const Shape*>(&circle) : &box;
                fixture.density = 1.0f;
                fixture.isSensor = step % 7 == 0;
                if (step % 5 != 4) body->CreateFixture(&fixture);
            }
            if (step % 11 == 10) {
                const size_t gone = random() % bodies.size();
                world.DestroyBody(bodies[gone]);
                bodies.erase(bodies.begin() + static_cast<ptrdiff_t>(gone));
            }
            step % 2 == 0 ? world.Step(1.0f / 60.0f, 4) : world.Step(1.0f / 60.0f, 8, 3);
            ExpectBodies(world);
            contacts += ExpectContacts(world);
            if (HasFailure()) return;
        }
    }
    EXPECT_GT(contacts, 100);
}

}  // namespace
}  // namespace scree::test
