// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Bad input is refused with the field's name and changes nothing: the state hash before and after is equal.

#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <limits>

#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

class BadInput : public ::testing::Test {
protected:
    BadInput() : world({0.0f, -10.0f}), errors(world) {
        AddGround(world);
        box = AddBody(world, dynamicBody, {0, 0.5f});
        AddBox(box, 0.5f, 0.5f);
        other = AddBody(world, dynamicBody, {3, 0.5f});
        AddCircle(other, 0.5f);
        RevoluteJointDef def;
        def.Initialize(box, other, {1.5f, 0.5f});
        joint = static_cast<RevoluteJoint*>(world.CreateJoint(&def));
        StepFor(world, 3);
    }

    /// The action must be refused once, naming `field`, and leave every bit as it was.
    void ExpectRefused(ErrorCode code, const char* field, const std::function<void()>& action) {
        const uint64_t before = inspect::GetStateHash(world);
        const int bodies = world.GetBodyCount(), fixtures = world.GetFixtureCount(), joints = world.GetJointCount();
        const int count = errors.count;
        action();
        EXPECT_EQ(errors.count, count + 1) << field;
        EXPECT_EQ(errors.last.code, code) << field << ": " << GetName(errors.last.code);
        EXPECT_STREQ(errors.last.field, field);
        EXPECT_GT(std::strlen(errors.last.cure), 0u);
        EXPECT_EQ(inspect::GetStateHash(world), before) << field;
        EXPECT_EQ(world.GetBodyCount(), bodies);
        EXPECT_EQ(world.GetFixtureCount(), fixtures);
        EXPECT_EQ(world.GetJointCount(), joints);
    }

    World world;
    ErrorLog errors;
    Body* box;
    Body* other;
    RevoluteJoint* joint;
};

TEST_F(BadInput, BodyDef) {
    const auto create = [&](auto change) {
        BodyDef def;
        change(def);
        EXPECT_EQ(world.CreateBody(&def), nullptr);
    };
    ExpectRefused(ErrorCode::nullArgument, "def", [&] { EXPECT_EQ(world.CreateBody(nullptr), nullptr); });
    ExpectRefused(ErrorCode::nonFinite, "BodyDef::position", [&] {
        create([](BodyDef& d) { d.position = {nan, 0}; });
    });
    ExpectRefused(ErrorCode::nonFinite, "BodyDef::angle", [&] { create([](BodyDef& d) { d.angle = infinity; }); });
    ExpectRefused(ErrorCode::nonFinite, "BodyDef::linearVelocity", [&] {
        create([](BodyDef& d) { d.linearVelocity = {0, -infinity}; });
    });
    ExpectRefused(ErrorCode::nonFinite, "BodyDef::angularVelocity",
                  [&] { create([](BodyDef& d) { d.angularVelocity = nan; }); });
    ExpectRefused(ErrorCode::outOfRange, "BodyDef::linearDamping",
                  [&] { create([](BodyDef& d) { d.linearDamping = -1; }); });
    ExpectRefused(ErrorCode::outOfRange, "BodyDef::angularDamping",
                  [&] { create([](BodyDef& d) { d.angularDamping = -1; }); });
    ExpectRefused(ErrorCode::nonFinite, "BodyDef::gravityScale",
                  [&] { create([](BodyDef& d) { d.gravityScale = nan; }); });
    ExpectRefused(ErrorCode::outOfRange, "BodyDef::type",
                  [&] { create([](BodyDef& d) { d.type = static_cast<BodyType>(7); }); });
}

TEST_F(BadInput, FixtureDef) {
    CircleShape circle;
    circle.m_radius = 1.0f;
    const auto create = [&](auto change) {
        FixtureDef def;
        def.shape = &circle;
        change(def);
        EXPECT_EQ(box->CreateFixture(&def), nullptr);
    };
    ExpectRefused(ErrorCode::nullArgument, "def", [&] { EXPECT_EQ(box->CreateFixture(nullptr), nullptr); });
    ExpectRefused(ErrorCode::nullArgument, "FixtureDef::shape",
                  [&] { create([](FixtureDef& d) { d.shape = nullptr; }); });
    ExpectRefused(ErrorCode::outOfRange, "FixtureDef::friction",
                  [&] { create([](FixtureDef& d) { d.friction = -0.1f; }); });
    ExpectRefused(ErrorCode::nonFinite, "FixtureDef::friction",
                  [&] { create([](FixtureDef& d) { d.friction = nan; }); });
    ExpectRefused(ErrorCode::nonFinite, "FixtureDef::restitution",
                  [&] { create([](FixtureDef& d) { d.restitution = infinity; }); });
    ExpectRefused(ErrorCode::outOfRange, "FixtureDef::restitutionThreshold",
                  [&] { create([](FixtureDef& d) { d.restitutionThreshold = -1; }); });
    ExpectRefused(ErrorCode::outOfRange, "FixtureDef::density", [&] { create([](FixtureDef& d) { d.density = -2; }); });
}

TEST_F(BadInput, Shapes) {
    CircleShape circle;
    ExpectRefused(ErrorCode::badShape, "CircleShape::m_radius",
                  [&] { EXPECT_EQ(box->CreateFixture(&circle, 1), nullptr); });
    circle.m_radius = nan;
    ExpectRefused(ErrorCode::nonFinite, "Shape::m_radius", [&] { EXPECT_EQ(box->CreateFixture(&circle, 1), nullptr); });
    circle.m_radius = 1.0f;
    circle.m_p = {infinity, 0};
    ExpectRefused(ErrorCode::nonFinite, "CircleShape::m_p",
                  [&] { EXPECT_EQ(box->CreateFixture(&circle, 1), nullptr); });
    EdgeShape edge;
    edge.SetTwoSided({1, 1}, {1, 1});
    ExpectRefused(ErrorCode::badShape, "EdgeShape::m_vertex2",
                  [&] { EXPECT_EQ(box->CreateFixture(&edge, 0), nullptr); });
    PolygonShape polygon;
    ExpectRefused(ErrorCode::badShape, "PolygonShape::m_count",
                  [&] { EXPECT_EQ(box->CreateFixture(&polygon, 1), nullptr); });
    polygon.SetAsBox(1, 1);
    polygon.m_vertices[2] = {nan, 0};
    ExpectRefused(ErrorCode::badShape, "PolygonShape::m_vertices",
                  [&] { EXPECT_EQ(box->CreateFixture(&polygon, 1), nullptr); });
}

TEST_F(BadInput, FieldsOfShapesThatProgramsHaveWritten) {
    const auto refused = [&](ErrorCode code, const char* field, auto write) {
        PolygonShape polygon;
        polygon.SetAsBox(1, 1);
        ConvexShape convex = MakeEllipse(2.0f, 1.0f);
        const Shape* shape = nullptr;
        if constexpr (std::is_invocable_v<decltype(write), PolygonShape&>) {
            write(polygon), shape = &polygon;
        } else {
            write(convex), shape = &convex;
        }
        ExpectRefused(code, field, [&] { EXPECT_EQ(box->CreateFixture(shape, 1), nullptr); });
    };
    refused(ErrorCode::badShape, "PolygonShape::m_normals", [](PolygonShape& p) { p.m_normals[1] = {0, 2}; });
    refused(ErrorCode::outOfRange, "PolygonShape::m_centroid", [](PolygonShape& p) { p.m_centroid.x = 1e30f; });
    refused(ErrorCode::badShape, "ConvexShape::m_normals", [](ConvexShape& c) { c.m_normals[1] = {0, 2}; });
    refused(ErrorCode::outOfRange, "ConvexShape::m_controls", [](ConvexShape& c) { c.m_controls[0].y = 1e30f; });
    refused(ErrorCode::nonFinite, "ConvexShape::m_error", [](ConvexShape& c) { c.m_error = infinity; });
    refused(ErrorCode::outOfRange, "ConvexShape::m_error", [](ConvexShape& c) { c.m_error = -1; });
    refused(ErrorCode::outOfRange, "ConvexShape::m_error", [](ConvexShape& c) { c.m_error = 1e30f; });
    refused(ErrorCode::nonFinite, "ConvexShape::m_solidRadius", [](ConvexShape& c) { c.m_solidRadius = nan; });
    refused(ErrorCode::badShape, "ConvexShape::m_solidRadius", [](ConvexShape& c) { c.m_solidRadius = 9; });
    refused(ErrorCode::outOfRange, "ConvexShape::m_unitMass", [](ConvexShape& c) { c.m_unitMass.center.x = 1e30f; });
}

TEST_F(BadInput, BodySetters) {
    ExpectRefused(ErrorCode::nonFinite, "position", [&] { box->SetTransform({nan, 0}, 0); });
    ExpectRefused(ErrorCode::nonFinite, "angle", [&] { box->SetTransform({0, 0}, infinity); });
    ExpectRefused(ErrorCode::nonFinite, "v", [&] { box->SetLinearVelocity({nan, 0}); });
    ExpectRefused(ErrorCode::nonFinite, "omega", [&] { box->SetAngularVelocity(nan); });
    ExpectRefused(ErrorCode::nonFinite, "force", [&] { box->ApplyForce({nan, 0}, {0, 0}, true); });
    ExpectRefused(ErrorCode::nonFinite, "point", [&] { box->ApplyForce({0, 0}, {0, nan}, true); });
    ExpectRefused(ErrorCode::nonFinite, "torque", [&] { box->ApplyTorque(infinity, true); });
    ExpectRefused(ErrorCode::nonFinite, "impulse", [&] { box->ApplyLinearImpulse({infinity, 0}, {0, 0}, true); });
    ExpectRefused(ErrorCode::nonFinite, "impulse", [&] { box->ApplyAngularImpulse(nan, true); });
    ExpectRefused(ErrorCode::outOfRange, "damping", [&] { box->SetLinearDamping(-1); });
    ExpectRefused(ErrorCode::nonFinite, "scale", [&] { box->SetGravityScale(nan); });
    ExpectRefused(ErrorCode::nullArgument, "data", [&] { box->SetMassData(nullptr); });
    MassData data{1.0f, {2.0f, 0.0f}, 1.0f};  // less than mass·|center|²
    ExpectRefused(ErrorCode::outOfRange, "MassData::I", [&] { box->SetMassData(&data); });
}

TEST_F(BadInput, JointsAndHandles) {
    World second({0.0f, 0.0f});
    Body* foreign = AddBody(second, dynamicBody, {0, 0});
    RevoluteJointDef def;
    ExpectRefused(ErrorCode::nullArgument, "def", [&] { EXPECT_EQ(world.CreateJoint(nullptr), nullptr); });
    ExpectRefused(ErrorCode::nullArgument, "JointDef::bodyA", [&] { EXPECT_EQ(world.CreateJoint(&def), nullptr); });
    def.bodyA = box;
    def.bodyB = foreign;
    ExpectRefused(ErrorCode::foreignHandle, "JointDef::bodyB", [&] { EXPECT_EQ(world.CreateJoint(&def), nullptr); });
    def.bodyB = box;
    ExpectRefused(ErrorCode::outOfRange, "JointDef::bodyB", [&] { EXPECT_EQ(world.CreateJoint(&def), nullptr); });
    def.bodyB = other;
    def.lowerAngle = 1.0f;
    ExpectRefused(ErrorCode::outOfRange, "RevoluteJointDef::lowerAngle",
                  [&] { EXPECT_EQ(world.CreateJoint(&def), nullptr); });
    ExpectRefused(ErrorCode::foreignHandle, "body", [&] { world.DestroyBody(foreign); });
    ExpectRefused(ErrorCode::foreignHandle, "fixture", [&] { box->DestroyFixture(other->GetFixtureList()); });
    ExpectRefused(ErrorCode::nonFinite, "lower", [&] { joint->SetLimits(nan, 0); });
    ExpectRefused(ErrorCode::outOfRange, "torque", [&] { joint->SetMaxMotorTorque(-1); });
}

TEST_F(BadInput, WorldCalls) {
    ExpectRefused(ErrorCode::nonFinite, "timeStep", [&] { world.Step(nan, 8, 3); });
    ExpectRefused(ErrorCode::outOfRange, "timeStep", [&] { world.Step(-0.1f, 8, 3); });
    ExpectRefused(ErrorCode::outOfRange, "velocityIterations", [&] { world.Step(0.1f, -1, 3); });
    ExpectRefused(ErrorCode::outOfRange, "positionIterations", [&] { world.Step(0.1f, 8, -3); });
    ExpectRefused(ErrorCode::nonFinite, "gravity", [&] { world.SetGravity({0, nan}); });
    ExpectRefused(ErrorCode::outOfRange, "aabb", [&] {
        world.QueryAABB({{1, 1}, {0, 0}}, [](Fixture*) { return true; });
    });
    ExpectRefused(ErrorCode::nonFinite, "p1, p2", [&] {
        world.RayCast({nan, 0}, {1, 1}, [](Fixture*, Vec2, Vec2, float) { return 1.0f; });
    });
}

TEST_F(BadInput, ABodyThatBlowsUpIsStoppedAndCounted) {
    other->SetLinearVelocity({9e17f, 9e17f});
    const StepReport report = world.Step(10.0f, 8, 3);
    EXPECT_GE(report.nonFiniteCount, 1);
    EXPECT_TRUE(other->GetPosition().IsValid());
    EXPECT_TRUE(box->GetPosition().IsValid());
    StepFor(world, 10);
    EXPECT_TRUE(other->GetPosition().IsValid());
}

}  // namespace
}  // namespace scree::test
