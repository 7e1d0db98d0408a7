// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What programs written for Box2D 2.4 rely on: lists, masses, sleeping, sensors, filters, destruction.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

TEST(World, ListsMoversBeforeStaticBodiesNewestFirst) {
    World world({0.0f, -10.0f});
    Body* s1 = AddBody(world, staticBody, {0, 0});
    Body* d1 = AddBody(world, dynamicBody, {1, 0});
    Body* s2 = AddBody(world, staticBody, {2, 0});
    Body* k1 = AddBody(world, kinematicBody, {3, 0});
    std::vector<Body*> list;
    for (Body* b = world.GetBodyList(); b; b = b->GetNext()) list.push_back(b);
    EXPECT_EQ(list, (std::vector<Body*>{k1, d1, s2, s1}));
    world.DestroyBody(d1);
    world.DestroyBody(s2);
    list.clear();
    for (Body* b = world.GetBodyList(); b; b = b->GetNext()) list.push_back(b);
    EXPECT_EQ(list, (std::vector<Body*>{k1, s1}));
    EXPECT_EQ(world.GetBodyCount(), 2);
}

TEST(World, WithoutBodiesTakesSteps) {
    World world({0.0f, -10.0f});
    EXPECT_EQ(world.Step(1.0f / 60.0f, 8, 3).awakeBodyCount, 0);
    EXPECT_EQ(world.Step(1.0f / 60.0f, 4).awakeBodyCount, 0);
    EXPECT_EQ(world.Step(1.0f / 60.0f, Tolerance()).awakeBodyCount, 0);
    EXPECT_EQ(world.Step(1.0f / 60.0f, Accuracy::game).awakeBodyCount, 0);
}

TEST(World, MassOfSeveralFixturesIsThatOfTheirUnion) {
    World world({0.0f, 0.0f});
    Body* body = AddBody(world, dynamicBody, {5, 5}, 0.3f);
    EXPECT_FLOAT_EQ(body->GetMass(), 0.0f);  // no density yet: as in Box2D 2.4.1
    PolygonShape left, right;
    left.SetAsBox(0.5f, 1.0f, {-0.5f, 0.0f}, 0.0f);
    right.SetAsBox(0.5f, 1.0f, {0.5f, 0.0f}, 0.0f);
    body->CreateFixture(&left, 2.0f);
    EXPECT_FLOAT_EQ(body->GetMass(), 4.0f);
    EXPECT_NEAR(body->GetLocalCenter().x, -0.5f, 1e-6f);
    body->CreateFixture(&right, 2.0f);
    EXPECT_FLOAT_EQ(body->GetMass(), 8.0f);
    EXPECT_NEAR(body->GetLocalCenter().x, 0.0f, 1e-6f);
    EXPECT_NEAR(body->GetInertia(), 8.0f * (2.0f * 2.0f + 2.0f * 2.0f) / 12.0f, 1e-5f);  // a 2×2 square
    body->DestroyFixture(body->GetFixtureList());
    EXPECT_FLOAT_EQ(body->GetMass(), 4.0f);
}

TEST(World, ABoxAtRestFallsAsleepAndWakesWhenHit) {
    World world({0.0f, -10.0f});
    AddGround(world);
    Body* box = AddBody(world, dynamicBody, {0, 0.51f});
    AddBox(box, 0.5f, 0.5f);
    StepFor(world, 120);
    EXPECT_FALSE(box->IsAwake());
    EXPECT_EQ(world.GetReport().awakeBodyCount, 0);
    EXPECT_NEAR(box->GetPosition().y, 0.5f, 0.02f);

    Body* ball = AddBody(world, dynamicBody, {0, 3});
    AddCircle(ball, 0.25f);
    bool woke = false;
    for (int i = 0; i < 120; ++i) {
        StepFor(world, 1);
        woke = woke || box->IsAwake();
    }
    EXPECT_TRUE(woke);
    StepFor(world, 600);
    EXPECT_FALSE(box->IsAwake());
}

TEST(World, TurningSleepOffWakesEverything) {
    World world({0.0f, -10.0f});
    AddGround(world);
    Body* box = AddBody(world, dynamicBody, {0, 0.51f});
    AddBox(box, 0.5f, 0.5f);
    StepFor(world, 120);
    ASSERT_FALSE(box->IsAwake());
    world.SetAllowSleeping(false);
    EXPECT_TRUE(box->IsAwake());
    StepFor(world, 120);
    EXPECT_TRUE(box->IsAwake());
}

/// Writes events down as "begin", "end", "pre", "post".
struct OrderRecorder : ContactListener {
    std::vector<std::string> events;
    World* world = nullptr;
    bool createInside = false;
    int refused = 0;

    void BeginContact(Contact* contact) override {
        events.push_back("begin");
        EXPECT_TRUE(contact->IsTouching());
        if (createInside) {
            BodyDef def;
            if (world->CreateBody(&def) == nullptr) ++refused;
            if (world->DestroyBody(contact->GetFixtureA()->GetBody()) == ErrorCode::locked) ++refused;
        }
    }
    void EndContact(Contact*) override { events.push_back("end"); }
    void PreSolve(Contact*, const Manifold*) override {
        if (events.empty() || events.back() != "pre") events.push_back("pre");
    }
    void PostSolve(Contact*, const ContactImpulse* impulse) override {
        EXPECT_GT(impulse->count, 0);
        if (events.empty() || events.back() != "post") events.push_back("post");
    }
    [[nodiscard]] int Count(const std::string& name) const {
        return static_cast<int>(std::count(events.begin(), events.end(), name));
    }
};

TEST(World, ReportsBeginPreSolvePostSolveAndEnd) {
    World world({0.0f, -10.0f});
    OrderRecorder recorder;
    world.SetContactListener(&recorder);
    AddGround(world);
    Body* box = AddBody(world, dynamicBody, {0, 0.6f});
    AddBox(box, 0.5f, 0.5f);
    StepFor(world, 60);
    ASSERT_GE(recorder.events.size(), 3u);
    EXPECT_EQ(recorder.events[0], "begin");
    EXPECT_EQ(recorder.events[1], "pre");
    EXPECT_EQ(recorder.events[2], "post");
    EXPECT_EQ(recorder.Count("end"), 0);
    box->SetLinearVelocity({0, 20});
    StepFor(world, 10);
    EXPECT_EQ(recorder.Count("end"), 1);
    EXPECT_EQ(recorder.events.back(), "end");
}

TEST(World, DestroyingATouchingBodyEndsItsContacts) {
    World world({0.0f, -10.0f});
    OrderRecorder recorder;
    AddGround(world);
    Body* box = AddBody(world, dynamicBody, {0, 0.5f});
    AddBox(box, 0.5f, 0.5f);
    StepFor(world, 5);
    world.SetContactListener(&recorder);
    world.DestroyBody(box);
    EXPECT_EQ(recorder.Count("end"), 1);
    EXPECT_EQ(world.GetContactCount(), 0);
    StepFor(world, 2);
    EXPECT_EQ(recorder.Count("end"), 1);
}

TEST(World, RefusesCreationAndDestructionInsideCallbacks) {
    World world({0.0f, -10.0f});
    ErrorLog errors(world);
    OrderRecorder recorder;
    recorder.world = &world;
    recorder.createInside = true;
    world.SetContactListener(&recorder);
    AddGround(world);
    Body* box = AddBody(world, dynamicBody, {0, 0.5f});
    AddBox(box, 0.5f, 0.5f);
    StepFor(world, 5);
    EXPECT_EQ(recorder.refused, 2);
    EXPECT_EQ(errors.last.code, ErrorCode::locked);
    EXPECT_EQ(world.GetBodyCount(), 2);
}

TEST(World, SensorsReportButDoNotPush) {
    World world({0.0f, 0.0f});
    OrderRecorder recorder;
    world.SetContactListener(&recorder);
    Body* gate = AddBody(world, staticBody, {0, 0});
    PolygonShape shape;
    shape.SetAsBox(0.5f, 0.5f);
    FixtureDef def;
    def.shape = &shape;
    def.isSensor = true;
    gate->CreateFixture(&def);
    Body* ball = AddBody(world, dynamicBody, {-2, 0});
    AddCircle(ball, 0.25f);
    ball->SetLinearVelocity({4, 0});
    StepFor(world, 60);
    EXPECT_EQ(recorder.events, (std::vector<std::string>{"begin", "end"}));
    EXPECT_FLOAT_EQ(ball->GetLinearVelocity().x, 4.0f);
    EXPECT_NEAR(ball->GetPosition().x, 2.0f, 1e-4f);
}

TEST(World, FiltersAndGroupsDecide) {
    World world({0.0f, -10.0f});
    Fixture* ground = AddGround(world)->GetFixtureList();
    Body* masked = AddBody(world, dynamicBody, {0, 1});
    Body* grouped = AddBody(world, dynamicBody, {5, 1});
    Body* normal = AddBody(world, dynamicBody, {10, 1});
    for (Body* body : {masked, grouped, normal}) AddBox(body, 0.5f, 0.5f);
    Filter filter;
    filter.maskBits = 0xFFFE;
    masked->GetFixtureList()->SetFilterData(filter);
    filter = {};
    filter.groupIndex = -3;
    ground->SetFilterData(filter);
    grouped->GetFixtureList()->SetFilterData(filter);
    StepFor(world, 120);
    EXPECT_LT(masked->GetPosition().y, -5.0f);
    EXPECT_LT(grouped->GetPosition().y, -5.0f);
    EXPECT_NEAR(normal->GetPosition().y, 0.5f, 0.02f);
    // A change of filter on a living contact takes effect.
    filter = {};
    filter.maskBits = 0;
    normal->GetFixtureList()->SetFilterData(filter);
    normal->SetAwake(true);
    StepFor(world, 60);
    EXPECT_LT(normal->GetPosition().y, 0.0f);
}

TEST(World, JointedBodiesDoNotCollideUnlessAsked) {
    for (const bool collide : {false, true}) {
        World world({0.0f, 0.0f});
        Body* a = AddBody(world, dynamicBody, {0, 0});
        Body* b = AddBody(world, dynamicBody, {0.5f, 0});
        AddBox(a, 0.5f, 0.5f);
        AddBox(b, 0.5f, 0.5f);
        RevoluteJointDef def;
        def.Initialize(a, b, {0.25f, 0.0f});
        def.collideConnected = collide;
        Joint* joint = world.CreateJoint(&def);
        ASSERT_NE(joint, nullptr);
        StepFor(world, 2);
        EXPECT_EQ(world.GetContactCount(), collide ? 1 : 0);
        world.DestroyJoint(joint);
        StepFor(world, 2);
        EXPECT_EQ(world.GetContactCount(), 1);
    }
}

TEST(World, DestroyingABodyTakesItsJoints) {
    World world({0.0f, -10.0f});
    Body* anchor = AddBody(world, staticBody, {0, 0});
    Body* first = AddBody(world, dynamicBody, {1, 0});
    Body* second = AddBody(world, dynamicBody, {2, 0});
    for (Body* body : {first, second}) AddBox(body, 0.4f, 0.1f);
    RevoluteJointDef def;
    def.Initialize(anchor, first, {0, 0});
    world.CreateJoint(&def);
    def.Initialize(first, second, {1.5f, 0});
    world.CreateJoint(&def);
    StepFor(world, 10);
    world.DestroyBody(first);
    EXPECT_EQ(world.GetJointCount(), 0);
    StepFor(world, 60);
    EXPECT_LT(second->GetPosition().y, -4.0f);
}

TEST(World, DisabledBodiesNeitherMoveNorCollide) {
    World world({0.0f, -10.0f});
    Body* ground = AddGround(world);
    Body* box = AddBody(world, dynamicBody, {0, 0.5f});
    AddBox(box, 0.5f, 0.5f);
    StepFor(world, 10);
    box->SetEnabled(false);
    EXPECT_EQ(world.GetContactCount(), 0);
    const Vec2 before = box->GetPosition();
    StepFor(world, 30);
    EXPECT_EQ(box->GetPosition(), before);
    box->SetEnabled(true);
    ground->SetEnabled(false);
    StepFor(world, 30);
    EXPECT_LT(box->GetPosition().y, -0.5f);
}

TEST(World, SetTransformMovesContactsInTheNextStep) {
    World world({0.0f, 0.0f});
    Body* a = AddBody(world, dynamicBody, {0, 0});
    Body* b = AddBody(world, dynamicBody, {10, 0});
    AddCircle(a, 0.5f);
    AddCircle(b, 0.5f);
    StepFor(world, 1);
    EXPECT_EQ(world.GetContactCount(), 0);
    b->SetTransform({0.9f, 0}, 0.0f);
    StepFor(world, 1);
    EXPECT_EQ(world.GetReport().touchingCount, 1);
    b->SetTransform({10, 0}, 0.0f);
    StepFor(world, 2);
    EXPECT_EQ(world.GetContactCount(), 0);
}

TEST(World, SpeedIsCappedOnlyWhenAskedAndCounted) {
    for (const bool cap : {false, true}) {
        WorldDef def;
        def.gravity = {0.0f, 0.0f};
        if (cap) def.maxTranslation = maxTranslation;
        World world(def);
        Body* ball = AddBody(world, dynamicBody, {0, 0});
        AddCircle(ball, 0.5f);
        ball->SetLinearVelocity({600, 0});
        const StepReport report = StepFor(world, 1);
        EXPECT_NEAR(ball->GetPosition().x, cap ? 2.0f : 10.0f, 1e-4f);
        EXPECT_EQ(report.cappedCount, cap ? 1 : 0);
    }
}

TEST(World, QueriesFindWhatIsThere) {
    World world({0.0f, 0.0f});
    std::vector<Body*> balls;
    for (int i = 0; i < 20; ++i) {
        balls.push_back(AddBody(world, i % 3 == 0 ? staticBody : dynamicBody, {static_cast<float>(2 * i), 0}));
        AddCircle(balls.back(), 0.5f);
    }
    std::set<Body*> found;
    world.QueryAABB({{9.0f, -1.0f}, {15.0f, 1.0f}}, [&](Fixture* f) { return found.insert(f->GetBody()), true; });
    EXPECT_EQ(found, (std::set<Body*>{balls[5], balls[6], balls[7]}));

    Fixture* nearest = nullptr;
    float fraction = 1.0f;
    world.RayCast({-5, 0}, {45, 0}, [&](Fixture* f, Vec2, Vec2 normal, float at) {
        nearest = f;
        fraction = at;
        EXPECT_NEAR(normal.x, -1.0f, 1e-5f);
        return at;
    });
    ASSERT_NE(nearest, nullptr);
    EXPECT_EQ(nearest->GetBody(), balls[0]);
    EXPECT_NEAR(fraction, 4.5f / 50.0f, 1e-6f);
}

TEST(World, StepZeroUpdatesContactsOnly) {
    World world({0.0f, -10.0f});
    AddGround(world);
    Body* box = AddBody(world, dynamicBody, {0, 0.4f});
    AddBox(box, 0.5f, 0.5f);
    const StepReport report = world.Step(0.0f, 8, 3);
    EXPECT_EQ(report.touchingCount, 1);
    EXPECT_EQ(box->GetPosition(), (Vec2{0, 0.4f}));
}

}  // namespace
}  // namespace scree::test
