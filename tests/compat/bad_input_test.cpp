// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Where Box2D aborts in an assertion, the compatibility library refuses: null or nothing happens, and the world goes
// on.

#include <box2d/b2_distance.h>
#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

b2Body* MakeBox(b2World& world, float x, float y) {
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position.Set(x, y);
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    b2Body* body = world.CreateBody(&def);
    body->CreateFixture(&box, 1.0f);
    return body;
}

TEST(BadInput, AWorldWithoutAValidGravityHasNone) {
    for (const b2Vec2 gravity : {b2Vec2(nan, -10.0f), b2Vec2(0.0f, std::numeric_limits<float>::infinity())}) {
        testing::internal::CaptureStderr();
        b2World world(gravity);
        EXPECT_NE(testing::internal::GetCapturedStderr().find("gravity"), std::string::npos);
        EXPECT_EQ(world.GetGravity(), b2Vec2(0.0f, 0.0f));
        b2Body* box = MakeBox(world, 3.0f, 4.0f);
        for (int i = 0; i < 10; ++i) world.Step(1.0f / 60.0f, 8, 3);
        EXPECT_EQ(box->GetPosition(), b2Vec2(3.0f, 4.0f));
        world.SetGravity(b2Vec2(0.0f, -10.0f));
        world.Step(1.0f / 60.0f, 8, 3);
        EXPECT_LT(box->GetPosition().y, 4.0f);
    }
}

TEST(BadInput, MakesNoObjects) {
    b2World world(b2Vec2(0.0f, -10.0f));
    EXPECT_EQ(world.CreateBody(nullptr), nullptr);
    b2BodyDef def;
    def.position.Set(nan, 0.0f);
    EXPECT_EQ(world.CreateBody(&def), nullptr);
    b2Body* body = MakeBox(world, 0.0f, 0.0f);
    EXPECT_EQ(body->CreateFixture(nullptr), nullptr);
    b2FixtureDef fixture;
    EXPECT_EQ(body->CreateFixture(&fixture), nullptr);
    b2PolygonShape empty;
    EXPECT_EQ(body->CreateFixture(&empty, 1.0f), nullptr);
    EXPECT_EQ(world.CreateJoint(nullptr), nullptr);
    b2RevoluteJointDef joint;
    EXPECT_EQ(world.CreateJoint(&joint), nullptr);
    joint.bodyA = joint.bodyB = body;
    EXPECT_EQ(world.CreateJoint(&joint), nullptr);
    b2JointDef base;
    EXPECT_EQ(world.CreateJoint(&base), nullptr);
    EXPECT_EQ(world.GetBodyCount(), 1);
    EXPECT_EQ(world.GetJointCount(), 0);
    world.DestroyBody(nullptr);
    world.DestroyJoint(nullptr);
    body->DestroyFixture(nullptr);
    world.Step(1.0f / 60.0f, 8, 3);
}

TEST(BadInput, LeavesValuesAsTheyAre) {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2Body* body = MakeBox(world, 1.0f, 2.0f);
    body->SetTransform(b2Vec2(nan, 0.0f), 0.0f);
    body->SetLinearVelocity(b2Vec2(0.0f, nan));
    body->ApplyForceToCenter(b2Vec2(nan, 0.0f), true);
    body->GetFixtureList()->SetDensity(-1.0f);
    EXPECT_EQ(body->GetPosition(), b2Vec2(1.0f, 2.0f));
    EXPECT_EQ(body->GetLinearVelocity(), b2Vec2(0.0f, 0.0f));
    EXPECT_EQ(body->GetFixtureList()->GetDensity(), 1.0f);
    world.Step(nan, 8, 3);
    EXPECT_EQ(body->GetPosition(), b2Vec2(1.0f, 2.0f));
    b2World other(b2Vec2(0.0f, 0.0f));
    other.DestroyBody(body);
    EXPECT_EQ(world.GetBodyCount(), 1);
}

TEST(BadInput, LeavesShapesAsTheyAre) {
    const b2Vec2 line[] = {b2Vec2(0.0f, 0.0f), b2Vec2(1.0f, 0.0f), b2Vec2(2.0f, 0.0f)};
    b2PolygonShape polygon;
    polygon.SetAsBox(1.0f, 1.0f);
    polygon.Set(line, 3);
    polygon.Set(line, 2);
    polygon.Set(nullptr, 3);
    EXPECT_EQ(polygon.m_count, 4);
    b2ChainShape chain;
    chain.CreateLoop(line, 2);
    chain.CreateChain(nullptr, 3, line[0], line[1]);
    EXPECT_EQ(chain.m_count, 0);
    b2World world(b2Vec2(0.0f, 0.0f));
    b2BodyDef def;
    EXPECT_EQ(world.CreateBody(&def)->CreateFixture(&chain, 0.0f), nullptr);
    b2DistanceProxy proxy;
    proxy.Set(&polygon, 7);
    EXPECT_EQ(proxy.m_count, 0);
}

/// Tries in every callback what is not allowed in a step.
class Meddler : public b2ContactListener {
public:
    explicit Meddler(b2World& world) : m_world(world) {}
    void BeginContact(b2Contact* contact) override { Try(contact); }
    void PreSolve(b2Contact* contact, const b2Manifold*) override { Try(contact); }
    void PostSolve(b2Contact* contact, const b2ContactImpulse*) override { Try(contact); }
    int tries = 0;

private:
    void Try(b2Contact* contact) {
        ++tries;
        EXPECT_TRUE(m_world.IsLocked());
        b2BodyDef def;
        EXPECT_EQ(m_world.CreateBody(&def), nullptr);
        b2Body* body = contact->GetFixtureB()->GetBody();
        const b2Vec2 position = body->GetPosition();
        m_world.DestroyBody(body);
        body->DestroyFixture(body->GetFixtureList());
        body->SetTransform(b2Vec2(9.0f, 9.0f), 1.0f);
        m_world.Step(1.0f, 1, 1);
        EXPECT_EQ(body->GetPosition(), position);
        EXPECT_NE(body->GetFixtureList(), nullptr);
    }
    b2World& m_world;
};

TEST(BadInput, InCallbacksIsRefused) {
    b2World world(b2Vec2(0.0f, -10.0f));
    Meddler meddler(world);
    world.SetContactListener(&meddler);
    b2BodyDef def;
    b2EdgeShape edge;
    edge.SetTwoSided(b2Vec2(-5.0f, 0.0f), b2Vec2(5.0f, 0.0f));
    world.CreateBody(&def)->CreateFixture(&edge, 0.0f);
    b2Body* box = MakeBox(world, 0.0f, 0.5f);
    for (int i = 0; i < 3; ++i) world.Step(1.0f / 60.0f, 8, 3);
    EXPECT_GT(meddler.tries, 3);
    EXPECT_EQ(world.GetBodyCount(), 2);
    EXPECT_NEAR(box->GetPosition().y, 0.5f, 0.02f);
    EXPECT_FALSE(world.IsLocked());
}

/// What Box2D leaves to the program: a gear goes with its joints.
TEST(Lifetime, AGearGoesWithItsJoints) {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef def;
    b2Body* ground = world.CreateBody(&def);
    b2Joint* hinges[2];
    b2Body* bodies[2];
    for (int i = 0; i < 2; ++i) {
        bodies[i] = MakeBox(world, 3.0f * static_cast<float>(i), 5.0f);
        b2RevoluteJointDef hinge;
        hinge.Initialize(ground, bodies[i], bodies[i]->GetPosition());
        hinges[i] = world.CreateJoint(&hinge);
    }
    b2GearJointDef gear;
    gear.bodyA = bodies[0];
    gear.bodyB = bodies[1];
    gear.joint1 = hinges[0];
    gear.joint2 = hinges[1];
    ASSERT_NE(world.CreateJoint(&gear), nullptr);
    world.DestroyJoint(hinges[0]);
    EXPECT_EQ(world.GetJointCount(), 1);
    EXPECT_EQ(world.GetJointList(), hinges[1]);
    EXPECT_EQ(bodies[0]->GetJointList(), nullptr);
    world.DestroyBody(bodies[1]);
    EXPECT_EQ(world.GetJointCount(), 0);
}

/// A chain is one fixture: what is set on it holds for every edge.
TEST(Lifetime, AChainIsOneFixture) {
    b2World world(b2Vec2(0.0f, -10.0f));
    std::vector<b2Vec2> vertices;
    for (int i = 0; i < 30; ++i) vertices.push_back(b2Vec2(15.0f - static_cast<float>(i), 0.0f));
    b2ChainShape chain;
    chain.CreateChain(vertices.data(), 30, b2Vec2(16.0f, 0.0f), b2Vec2(-15.0f, 0.0f));
    b2BodyDef def;
    b2Body* ground = world.CreateBody(&def);
    b2Fixture* fixture = ground->CreateFixture(&chain, 0.0f);
    ASSERT_NE(fixture, nullptr);
    EXPECT_EQ(fixture->GetNext(), nullptr);
    EXPECT_EQ(world.GetProxyCount(), 29);
    b2Body* boxes[3] = {MakeBox(world, -9.3f, 0.5f), MakeBox(world, 0.2f, 0.5f), MakeBox(world, 8.4f, 0.5f)};
    fixture->SetSensor(true);
    for (int i = 0; i < 30; ++i) world.Step(1.0f / 60.0f, 8, 3);
    for (const b2Body* box : boxes) EXPECT_LT(box->GetPosition().y, 0.0f);
    ground->DestroyFixture(fixture);
    EXPECT_EQ(world.GetProxyCount(), 3);
    EXPECT_EQ(world.GetContactCount(), 0);
}

}  // namespace
