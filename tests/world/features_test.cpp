// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a world says that it requires, and that a fixed set refuses every call that would use something else, once, with
// the feature's name, and changes nothing.

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "scree/snapshot.h"
#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

int UsersOf(const World& world, Feature feature) { return world.GetFeatureUsers()[static_cast<size_t>(feature)]; }

TEST(Features, AnEmptyWorldRequiresNothing) {
    const World world({0.0f, -10.0f});
    EXPECT_TRUE(world.GetRequiredFeatures().IsEmpty());
}

TEST(Features, UsersAreCountedAsTheyComeAndGo) {
    World world({0.0f, -10.0f});
    Body* ground = AddGround(world);
    Body* box = AddBody(world, dynamicBody, {0, 3});
    AddBox(box, 0.5f, 0.5f);
    EXPECT_EQ(world.GetRequiredFeatures(), (Features{Feature::rotation, Feature::friction, Feature::sleeping,
                                                     Feature::continuousStatic, Feature::polygons, Feature::edges}));
    EXPECT_EQ(UsersOf(world, Feature::friction), 2);
    box->SetLinearDamping(0.5f);
    EXPECT_EQ(UsersOf(world, Feature::damping), 1);
    box->SetLinearDamping(0.0f);
    EXPECT_EQ(UsersOf(world, Feature::damping), 0);
    box->ApplyForceToCenter({1.0f, 0.0f}, true);
    EXPECT_EQ(UsersOf(world, Feature::forces), 1);
    world.Step(1.0f / 60.0f, 8, 3);
    EXPECT_EQ(UsersOf(world, Feature::forces), 0);
    ground->SetType(kinematicBody);
    EXPECT_EQ(UsersOf(world, Feature::kinematicBodies), 1);
    EXPECT_EQ(UsersOf(world, Feature::continuousStatic), 1);
    world.SetContinuousPhysics(false);
    EXPECT_EQ(UsersOf(world, Feature::continuousStatic), 0);
    world.DestroyBody(ground);
    world.DestroyBody(box);
    EXPECT_TRUE(world.GetRequiredFeatures().IsEmpty());
}

TEST(Features, AContactKeepsFrictionThatItsFixturesGaveUp) {
    World world({0.0f, -10.0f});
    AddGround(world);
    Body* box = AddBody(world, dynamicBody, {0, 0.5f});
    AddBox(box, 0.5f, 0.5f);
    box->SetLinearVelocity({3.0f, 0.0f});
    StepFor(world, 3);
    for (Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
        body->GetFixtureList()->SetFriction(0.0f, true);
    }
    EXPECT_EQ(UsersOf(world, Feature::friction), 1);
    StepFor(world, 1);
    EXPECT_TRUE(inspect::GetKernels(world).friction);
    for (Contact* c = world.GetContactList(); c != nullptr; c = c->GetNext()) c->SetFriction(0.0f);
    EXPECT_EQ(UsersOf(world, Feature::friction), 1) << "what is left in its impulses";
    StepFor(world, 2);
    EXPECT_EQ(UsersOf(world, Feature::friction), 0);
    EXPECT_FALSE(inspect::GetKernels(world).friction);
}

/// A world with a fixed set: dynamic circles without rotation and nothing else.
class FixedSet : public ::testing::Test {
protected:
    FixedSet() : world(MakeDef()), errors(world) {
        ball = AddBall({0.0f, 0.0f});
        other = AddBall({0.4f, 0.0f});
        world.Step(1.0f / 60.0f, 4);
    }

    static WorldDef MakeDef() {
        WorldDef def;
        def.featureMode = FeatureMode::fixed;
        def.features = {Feature::joints};
        def.allowSleep = false;
        return def;
    }
    static BodyDef MakeBody() {
        BodyDef def;
        def.type = dynamicBody;
        def.fixedRotation = true;
        return def;
    }
    FixtureDef MakeFixture() {
        circle.m_radius = 0.5f;
        FixtureDef def;
        def.shape = &circle;
        def.density = 1.0f;
        def.friction = 0.0f;
        return def;
    }
    Body* AddBall(Vec2 position) {
        BodyDef def = MakeBody();
        def.position = position;
        Body* body = world.CreateBody(&def);
        const FixtureDef fixture = MakeFixture();
        body->CreateFixture(&fixture);
        return body;
    }

    void ExpectMissing(Feature feature, const std::function<void()>& call) {
        const std::vector<std::byte> before = SaveWorld(world);
        const int count = errors.count;
        call();
        EXPECT_EQ(errors.count, count + 1) << GetName(feature);
        EXPECT_EQ(errors.last.code, ErrorCode::missingFeature) << errors.last.function;
        EXPECT_STREQ(errors.last.field, GetName(feature));
        EXPECT_TRUE(before == SaveWorld(world)) << GetName(feature);
    }
    void ExpectBodyMissing(Feature feature, const std::function<void(BodyDef&)>& change) {
        BodyDef def = MakeBody();
        change(def);
        ExpectMissing(feature, [&] { EXPECT_EQ(world.CreateBody(&def), nullptr); });
    }
    void ExpectFixtureMissing(Feature feature, const std::function<void(FixtureDef&)>& change) {
        FixtureDef def = MakeFixture();
        change(def);
        ExpectMissing(feature, [&] { EXPECT_EQ(ball->CreateFixture(&def), nullptr); });
    }

    World world;
    ErrorLog errors;
    CircleShape circle;
    Body *ball, *other;
};

TEST_F(FixedSet, RefusesBodies) {
    ExpectBodyMissing(Feature::rotation, [](BodyDef& d) { d.fixedRotation = false; });
    ExpectBodyMissing(Feature::rotation, [](BodyDef& d) { d.angularVelocity = 1.0f; });
    ExpectBodyMissing(Feature::damping, [](BodyDef& d) { d.linearDamping = 1.0f; });
    ExpectBodyMissing(Feature::damping, [](BodyDef& d) { d.angularDamping = 1.0f; });
    ExpectBodyMissing(Feature::gravityScale, [](BodyDef& d) { d.gravityScale = 0.5f; });
    ExpectBodyMissing(Feature::sleeping, [](BodyDef& d) { d.awake = false; });
    ExpectBodyMissing(Feature::continuousBullet, [](BodyDef& d) { d.bullet = true; });
    ExpectBodyMissing(Feature::motionLocks, [](BodyDef& d) { d.locks.y = true; });
    ExpectBodyMissing(Feature::kinematicBodies, [](BodyDef& d) { d.type = kinematicBody; });
}

TEST_F(FixedSet, RefusesFixtures) {
    PolygonShape box;
    box.SetAsBox(1.0f, 1.0f);
    EdgeShape edge;
    edge.SetTwoSided({0, 0}, {1, 0});
    ExpectFixtureMissing(Feature::friction, [](FixtureDef& d) { d.friction = 0.2f; });
    ExpectFixtureMissing(Feature::restitution, [](FixtureDef& d) { d.restitution = 0.2f; });
    ExpectFixtureMissing(Feature::friction, [](FixtureDef& d) { d.frictionRule = MixRule::custom; });
    ExpectFixtureMissing(Feature::tangentSpeed, [](FixtureDef& d) { d.tangentSpeed = 0.2f; });
    ExpectFixtureMissing(Feature::rollingResistance, [](FixtureDef& d) { d.rollingResistance = 0.2f; });
    ExpectFixtureMissing(Feature::sensors, [](FixtureDef& d) { d.isSensor = true; });
    ExpectFixtureMissing(Feature::filters, [](FixtureDef& d) { d.filter.groupIndex = -1; });
    ExpectFixtureMissing(Feature::polygons, [&](FixtureDef& d) { d.shape = &box; });
    ExpectFixtureMissing(Feature::edges, [&](FixtureDef& d) { d.shape = &edge; });
    Body* fixed = AddBody(world, staticBody, {9.0f, 9.0f});
    const FixtureDef def = MakeFixture();
    ExpectMissing(Feature::continuousStatic, [&] { EXPECT_EQ(fixed->CreateFixture(&def), nullptr); });
}

TEST_F(FixedSet, RefusesSetters) {
    Fixture* fixture = ball->GetFixtureList();
    Contact* contact = world.GetContactList();
    ASSERT_NE(contact, nullptr);
    ExpectMissing(Feature::rotation, [&] { ball->SetAngularVelocity(1.0f); });
    ExpectMissing(Feature::rotation, [&] { ball->SetFixedRotation(false); });
    ExpectMissing(Feature::damping, [&] { ball->SetLinearDamping(1.0f); });
    ExpectMissing(Feature::damping, [&] { ball->SetAngularDamping(1.0f); });
    ExpectMissing(Feature::gravityScale, [&] { ball->SetGravityScale(2.0f); });
    ExpectMissing(Feature::forces, [&] { ball->ApplyForce({1, 0}, {0, 0}, true); });
    ExpectMissing(Feature::forces, [&] { ball->ApplyForceToCenter({1, 0}, true); });
    ExpectMissing(Feature::forces, [&] { ball->ApplyTorque(1.0f, true); });
    ExpectMissing(Feature::continuousBullet, [&] { ball->SetBullet(true); });
    ExpectMissing(Feature::sleeping, [&] { ball->SetAwake(false); });
    ExpectMissing(Feature::motionLocks, [&] { ball->SetMotionLocks({.x = true, .angle = true}); });
    const BodyDef bare = MakeBody();
    Body* withoutFixtures = world.CreateBody(&bare);
    ExpectMissing(Feature::kinematicBodies, [&] { withoutFixtures->SetType(kinematicBody); });
    ExpectMissing(Feature::continuousStatic, [&] { ball->SetType(staticBody); });
    ExpectMissing(Feature::friction, [&] { fixture->SetFriction(0.1f); });
    ExpectMissing(Feature::restitution, [&] { fixture->SetRestitution(0.1f); });
    ExpectMissing(Feature::restitution, [&] { fixture->SetMixRules(MixRule::standard, MixRule::custom); });
    ExpectMissing(Feature::tangentSpeed, [&] { fixture->SetTangentSpeed(0.1f); });
    ExpectMissing(Feature::rollingResistance, [&] { fixture->SetRollingResistance(0.1f); });
    ExpectMissing(Feature::sensors, [&] { fixture->SetSensor(true); });
    ExpectMissing(Feature::filters, [&] { fixture->SetFilterData({1, 1, 0}); });
    ExpectMissing(Feature::friction, [&] { contact->SetFriction(0.1f); });
    ExpectMissing(Feature::restitution, [&] { contact->SetRestitution(0.1f); });
    ExpectMissing(Feature::tangentSpeed, [&] { contact->SetTangentSpeed(0.1f); });
    ExpectMissing(Feature::sleeping, [&] { world.SetAllowSleeping(true); });
    ContactListener listener;
    ContactFilter filter;
    ExpectMissing(Feature::events, [&] { world.SetContactListener(&listener); });
    ExpectMissing(Feature::filters, [&] { world.SetContactFilter(&filter); });
    ExpectMissing(Feature::multiThreading, [&] { world.SetWorkers(2); });
}

TEST_F(FixedSet, RefusesJointsWithMoreThanTheSetHas) {
    RevoluteJointDef hinge;
    hinge.Initialize(ball, other, {0, 0});
    hinge.enableMotor = true;
    ExpectMissing(Feature::motors, [&] { EXPECT_EQ(world.CreateJoint(&hinge), nullptr); });
    hinge.enableMotor = false, hinge.enableLimit = true;
    ExpectMissing(Feature::limits, [&] { EXPECT_EQ(world.CreateJoint(&hinge), nullptr); });
    hinge.enableLimit = false;
    auto* made = static_cast<RevoluteJoint*>(world.CreateJoint(&hinge));
    ASSERT_NE(made, nullptr);
    ExpectMissing(Feature::motors, [&] { made->EnableMotor(true); });
    ExpectMissing(Feature::limits, [&] { made->EnableLimit(true); });
    DistanceJointDef rod;
    rod.Initialize(ball, other, {0, 0}, {1, 0});
    auto* rope = static_cast<DistanceJoint*>(world.CreateJoint(&rod));
    ASSERT_NE(rope, nullptr);
    ExpectMissing(Feature::springs, [&] { rope->SetStiffness(3.0f); });
    ExpectMissing(Feature::limits, [&] { rope->SetMaxLength(3.0f); });
    ExpectMissing(Feature::limits, [&] { rope->SetMinLength(0.1f); });
    world.DestroyJoint(made);
    world.DestroyJoint(rope);
}

TEST_F(FixedSet, IsRefusedForAWorldThatUsesMore) {
    EXPECT_EQ(world.SetFeatures(FeatureMode::automatic), ErrorCode::ok);
    ball->SetGravityScale(0.5f);
    EXPECT_EQ(world.SetFeatures(FeatureMode::fixed, {Feature::joints}), ErrorCode::missingFeature);
    EXPECT_EQ(world.GetFeatureMode(), FeatureMode::automatic);
    EXPECT_EQ(world.SetFeatures(FeatureMode::fixed, {Feature::gravityScale}), ErrorCode::ok);
    ExpectMissing(Feature::damping, [&] { ball->SetLinearDamping(1.0f); });
}

TEST(Features, ADefinitionThatAsksForMoreThanItsSetIsRefused) {
    WorldDef def;
    def.featureMode = FeatureMode::fixed;
    def.features = {};
    def.maxTranslation = 2.0f;
    std::string field;
    const auto hear = [](const Error& error, void* to) { *static_cast<std::string*>(to) = error.field; };
    EXPECT_EQ(CreateWorld(def, hear, &field), nullptr);
    EXPECT_EQ(field, "speedLimit");
}

TEST(Features, NamesAreFoundAgain) {
    for (size_t i = 0; i < featureNames.size(); ++i) {
        EXPECT_EQ(FeatureFromName(featureNames[i]), static_cast<Feature>(i));
    }
    EXPECT_FALSE(FeatureFromName("gravity"));
}

}  // namespace
}  // namespace scree::test
