// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What handles give: values that stay when tables grow, errors when their object is gone, and ids of contacts.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

struct Heard {
    std::vector<std::string> functions;
    ErrorCode last = ErrorCode::ok;
};

void Listen(World& world, Heard& heard) {
    world.SetErrorHandler(
        [](const Error& error, void* context) {
            auto& h = *static_cast<Heard*>(context);
            h.functions.emplace_back(error.function);
            h.last = error.code;
        },
        &heard);
}

TEST(Handles, ValuesStayWhenTablesGrow) {
    World world({0.0f, -10.0f});
    Body* body = AddBody(world, dynamicBody, {1.0f, 2.0f});
    AddBox(body, 0.5f, 0.5f);
    body->SetUserData({7});
    Fixture* fixture = body->GetFixtureList();
    fixture->SetUserData({8});
    const Transform& xf = body->GetTransform();
    const BodyUserData& data = body->GetUserData();
    const Filter& filter = fixture->GetFilterData();
    for (int i = 0; i < 3000; ++i)
        AddBox(AddBody(world, dynamicBody, {3.0f * static_cast<float>(i), 50.0f}), 1.0f, 1.0f);
    EXPECT_TRUE((xf.p == Vec2{1.0f, 2.0f}));
    EXPECT_EQ(data.pointer, 7u);
    EXPECT_EQ(filter.maskBits, ~uint64_t{0});
    EXPECT_EQ(body->GetUserData().pointer, 7u);
    EXPECT_EQ(fixture->GetUserData().pointer, 8u);
}

/// Each accessor of a destroyed object tells the error handler once and gives nothing.
TEST(Handles, EveryAccessorOfADeadObjectIsAnError) {
    World world({0.0f, -10.0f});
    Heard heard;
    Body* ground = AddBody(world, staticBody, {0.0f, 0.0f});
    AddBox(ground, 5.0f, 0.5f);
    Body* body = AddBody(world, dynamicBody, {0.0f, 1.0f});
    AddBox(body, 0.5f, 0.5f);
    Fixture* fixture = body->GetFixtureList();
    RevoluteJointDef def;
    def.Initialize(ground, body, {0.0f, 1.0f});
    def.collideConnected = true;
    auto* joint = static_cast<RevoluteJoint*>(world.CreateJoint(&def));
    StepFor(world, 2);
    Contact* contact = world.GetContactList();
    ASSERT_NE(contact, nullptr);
    const ContactId id = world.GetId(contact);
    EXPECT_EQ(world.Find(id), contact);
    Listen(world, heard);
    WorldManifold manifold;
    contact->GetWorldManifold(nullptr);
    EXPECT_EQ(heard.last, ErrorCode::nullArgument);
    world.DestroyBody(body);
    EXPECT_EQ(world.Find(id), nullptr);

    const auto expectRefused = [&](const std::string& name, auto&& call) {
        heard = {};
        call();
        EXPECT_EQ(heard.functions, std::vector<std::string>{name});
        EXPECT_EQ(heard.last, ErrorCode::foreignHandle);
    };
    expectRefused("Body::GetPosition", [&] { EXPECT_TRUE(body->GetPosition() == vec2Zero); });
    expectRefused("Body::GetTransform", [&] { EXPECT_EQ(body->GetTransform().q.c, 1.0f); });
    expectRefused("Body::GetMass", [&] { EXPECT_EQ(body->GetMass(), 0.0f); });
    expectRefused("Body::IsAwake", [&] { EXPECT_FALSE(body->IsAwake()); });
    expectRefused("Body::GetWorldPoint", [&] { EXPECT_TRUE(body->GetWorldPoint({1.0f, 1.0f}) == vec2Zero); });
    expectRefused("Body::GetFixtureList", [&] { EXPECT_EQ(body->GetFixtureList(), nullptr); });
    expectRefused("Body::GetContactCount", [&] { EXPECT_EQ(body->GetContactCount(), 0); });
    expectRefused("Body::GetNext", [&] { EXPECT_EQ(body->GetNext(), nullptr); });
    expectRefused("Body::GetUserData", [&] { EXPECT_EQ(body->GetUserData().pointer, 0u); });
    expectRefused("Body::SetUserData", [&] { EXPECT_EQ(body->SetUserData({1}), ErrorCode::foreignHandle); });
    expectRefused("Body::SetLinearDamping", [&] { EXPECT_EQ(body->SetLinearDamping(1.0f), ErrorCode::foreignHandle); });
    expectRefused("Fixture::GetShape", [&] { EXPECT_EQ(fixture->GetShape(), nullptr); });
    expectRefused("Fixture::GetShape", [&] { EXPECT_EQ(std::as_const(*fixture).GetShape(), nullptr); });
    expectRefused("Fixture::GetBody", [&] { EXPECT_EQ(fixture->GetBody(), nullptr); });
    expectRefused("Fixture::TestPoint", [&] { EXPECT_FALSE(fixture->TestPoint({0.0f, 1.0f})); });
    expectRefused("Fixture::GetAABB", [&] { EXPECT_TRUE(fixture->GetAABB().lowerBound == vec2Zero); });
    expectRefused("Fixture::GetFriction", [&] { EXPECT_EQ(fixture->GetFriction(), 0.0f); });
    RayCastOutput output;
    expectRefused("Fixture::RayCast", [&] { EXPECT_FALSE(fixture->RayCast(&output, {{0, 9}, {0, 0}, 1.0f})); });
    expectRefused("Joint::GetBodyA", [&] { EXPECT_EQ(joint->GetBodyA(), nullptr); });
    expectRefused("Joint::GetNext", [&] { EXPECT_EQ(joint->GetNext(), nullptr); });
    expectRefused("Joint::IsEnabled", [&] { EXPECT_FALSE(joint->IsEnabled()); });
    expectRefused("RevoluteJoint::GetAnchorA", [&] { EXPECT_TRUE(joint->GetAnchorA() == vec2Zero); });
    expectRefused("RevoluteJoint::GetJointAngle", [&] { EXPECT_EQ(joint->GetJointAngle(), 0.0f); });
    expectRefused("RevoluteJoint::IsMotorEnabled", [&] { EXPECT_FALSE(joint->IsMotorEnabled()); });
    expectRefused("Contact::GetFixtureA", [&] { EXPECT_EQ(contact->GetFixtureA(), nullptr); });
    expectRefused("Contact::GetManifold", [&] { EXPECT_EQ(contact->GetManifold().pointCount, 0); });
    expectRefused("Contact::GetWorldManifold", [&] { contact->GetWorldManifold(&manifold); });
    expectRefused("Contact::GetFriction", [&] { EXPECT_EQ(contact->GetFriction(), 0.0f); });
    expectRefused("Contact::GetNext", [&] { EXPECT_EQ(contact->GetNext(), nullptr); });
    StepFor(world, 2);  // the table has no row any more
    expectRefused("Contact::IsTouching", [&] { EXPECT_FALSE(contact->IsTouching()); });
    expectRefused("Contact::SetManifold", [&] { EXPECT_EQ(contact->SetManifold({}), ErrorCode::foreignHandle); });
}

/// A handle serves one contact after another; an id names one of them.
TEST(Handles, AnIdOfAContactNamesThatContactOnly) {
    World world({0.0f, 0.0f});
    Body* a = AddBody(world, dynamicBody, {0.0f, 0.0f});
    Body* b = AddBody(world, dynamicBody, {0.8f, 0.0f});
    AddBox(a, 0.5f, 0.5f);
    AddBox(b, 0.5f, 0.5f);
    StepFor(world, 1);
    const ContactId first = world.GetId(world.GetContactList());
    EXPECT_NE(world.Find(first), nullptr);
    b->SetTransform({50.0f, 0.0f}, 0.0f);
    StepFor(world, 3);
    EXPECT_EQ(world.Find(first), nullptr);
    b->SetTransform({0.0f, 0.8f}, 0.0f);
    StepFor(world, 1);
    const ContactId second = world.GetId(world.GetContactList());
    EXPECT_NE(world.Find(second), nullptr);
    EXPECT_EQ(world.Find(first), nullptr);
    EXPECT_FALSE(first == second);
    EXPECT_EQ(world.Find(ContactId{}), nullptr);
    EXPECT_TRUE(world.GetId(static_cast<Contact*>(nullptr)) == ContactId{});
}

}  // namespace
}  // namespace scree::test
