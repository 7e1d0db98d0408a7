// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Bad input to queries, chains, contacts and world settings, and calls on destroyed objects: refused once, with the
// name of what is wrong, and the state hash stays.

#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <limits>

#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

class BadWorldInput : public ::testing::Test {
protected:
    BadWorldInput() : world({0.0f, -10.0f}), errors(world) {
        ground = AddGround(world);
        box = AddBody(world, dynamicBody, {0, 0.5f});
        AddBox(box, 0.5f, 0.5f);
        StepFor(world, 3);
    }

    void ExpectRefused(ErrorCode code, const char* field, const std::function<void()>& action) {
        const uint64_t before = inspect::GetStateHash(world);
        const int count = errors.count;
        action();
        EXPECT_EQ(errors.count, count + 1) << field;
        EXPECT_EQ(errors.last.code, code) << field << ": " << GetName(errors.last.code);
        EXPECT_STREQ(errors.last.field, field);
        EXPECT_GT(std::strlen(errors.last.cure), 0u);
        EXPECT_GT(std::strlen(errors.last.function), 0u);
        EXPECT_EQ(inspect::GetStateHash(world), before) << field;
    }

    World world;
    ErrorLog errors;
    Body *ground, *box;
};

TEST_F(BadWorldInput, Queries) {
    const auto all = [](Fixture*) { return true; };
    std::vector<RayHit> rays(3);
    std::vector<ShapeHit> shapes(2);
    CircleShape circle;
    circle.m_radius = 0.5f;
    Transform xf;
    xf.SetIdentity();
    Transform broken = xf;
    broken.p.x = nan;
    ExpectRefused(ErrorCode::outOfRange, "aabb", [&] { world.QueryAABB({{0, 0}, {nan, 1}}, all); });
    ExpectRefused(ErrorCode::nullArgument, "visit", [&] { world.QueryAABB({{0, 0}, {1, 1}}, nullptr); });
    ExpectRefused(ErrorCode::nullArgument, "callback", [&] { world.QueryAABB(nullptr, {{0, 0}, {1, 1}}); });
    ExpectRefused(ErrorCode::nullArgument, "visit", [&] { world.RayCast({0, 0}, {1, 1}, nullptr); });
    ExpectRefused(ErrorCode::nullArgument, "callback", [&] { world.RayCast(nullptr, {0, 0}, {1, 1}); });
    ExpectRefused(ErrorCode::nonFinite, "p1, p2", [&] { EXPECT_FALSE(world.RayCastClosest({0, infinity}, {1, 1})); });
    ExpectRefused(ErrorCode::outOfRange, "p1, p2", [&] { EXPECT_FALSE(world.RayCastClosest({1, 1}, {1, 1})); });
    ExpectRefused(ErrorCode::nonFinite, "p1, p2", [&] { world.RayCastAll({0, 0}, {nan, 1}, rays); });
    EXPECT_EQ(rays.size(), 3u);
    ExpectRefused(ErrorCode::nonFinite, "point", [&] { world.QueryPoint({nan, 0}, all); });
    ExpectRefused(ErrorCode::nullArgument, "visit", [&] { world.QueryPoint({0, 0}, nullptr); });
    ExpectRefused(ErrorCode::nullArgument, "visit", [&] { world.OverlapShape(circle, xf, nullptr); });
    ExpectRefused(ErrorCode::nonFinite, "xf", [&] { world.OverlapShape(circle, broken, all); });
    ExpectRefused(ErrorCode::nonFinite, "translation", [&] { world.ShapeCast(circle, xf, {nan, 0}, shapes); });
    EXPECT_EQ(shapes.size(), 2u);
    ExpectRefused(ErrorCode::nonFinite, "xf", [&] { EXPECT_FALSE(world.ShapeCastClosest(circle, broken, {1, 0})); });
    ChainShape chain;
    const Vec2 points[2] = {{0, 0}, {1, 0}};
    ASSERT_TRUE(chain.CreateChain(points, 2, {-1, 0}, {2, 0}));
    ExpectRefused(ErrorCode::badShape, "shape", [&] { world.OverlapShape(chain, xf, all); });
    circle.m_radius = 0.0f;
    ExpectRefused(ErrorCode::badShape, "CircleShape::m_radius", [&] { world.ShapeCast(circle, xf, {1, 0}, shapes); });
}

TEST_F(BadWorldInput, ChainsAndTypes) {
    ChainShape chain;
    ExpectRefused(ErrorCode::badShape, "ChainShape::m_vertices",
                  [&] { EXPECT_EQ(ground->CreateFixture(&chain, 0), nullptr); });
    const Vec2 points[3] = {{0, 0}, {1, 0}, {2, 0}};
    ASSERT_TRUE(chain.CreateChain(points, 3, {-1, 0}, {3, 0}));
    chain.m_vertices[1] = chain.m_vertices[0];
    ExpectRefused(ErrorCode::badShape, "ChainShape::m_vertices",
                  [&] { EXPECT_EQ(ground->CreateFixture(&chain, 0), nullptr); });
    chain.m_vertices[1].x = nan;
    ExpectRefused(ErrorCode::nonFinite, "ChainShape::m_vertices",
                  [&] { EXPECT_EQ(ground->CreateFixture(&chain, 0), nullptr); });
    chain.m_vertices[1].x = 1.0f;
    chain.m_nextVertex.y = infinity;
    ExpectRefused(ErrorCode::nonFinite, "ChainShape::m_nextVertex",
                  [&] { EXPECT_EQ(ground->CreateFixture(&chain, 0), nullptr); });
    ExpectRefused(ErrorCode::nullArgument, "fixture", [&] { ground->DestroyChain(nullptr); });
    ExpectRefused(ErrorCode::outOfRange, "fixture", [&] { ground->DestroyChain(ground->GetFixtureList()); });
    ExpectRefused(ErrorCode::foreignHandle, "fixture", [&] { ground->DestroyChain(box->GetFixtureList()); });
    ExpectRefused(ErrorCode::nullArgument, "fixture", [&] { ground->DestroyFixture(nullptr); });
    ExpectRefused(ErrorCode::outOfRange, "type", [&] { box->SetType(static_cast<BodyType>(9)); });
    ExpectRefused(ErrorCode::nonFinite, "newOrigin", [&] { world.ShiftOrigin({nan, 0}); });
    ExpectRefused(ErrorCode::nullArgument, "body", [&] { world.DestroyBody(nullptr); });
    ExpectRefused(ErrorCode::nullArgument, "joint", [&] { world.DestroyJoint(nullptr); });
    ExpectRefused(ErrorCode::nullArgument, "visit", [&] { box->VisitContacts(nullptr); });
    ExpectRefused(ErrorCode::nullArgument, "visit", [&] { box->VisitJoints(nullptr); });
    ExpectRefused(ErrorCode::nullArgument, "data", [&] { box->GetMassData(nullptr); });
}

TEST_F(BadWorldInput, FixturesAndContacts) {
    Fixture* f = box->GetFixtureList();
    ExpectRefused(ErrorCode::outOfRange, "density", [&] { f->SetDensity(-1); });
    ExpectRefused(ErrorCode::nonFinite, "density", [&] { f->SetDensity(nan); });
    ExpectRefused(ErrorCode::outOfRange, "friction", [&] { f->SetFriction(-1); });
    ExpectRefused(ErrorCode::nonFinite, "restitution", [&] { f->SetRestitution(infinity); });
    ExpectRefused(ErrorCode::outOfRange, "threshold", [&] { f->SetRestitutionThreshold(-1); });
    ExpectRefused(ErrorCode::nullArgument, "massData", [&] { f->GetMassData(nullptr); });
    RayCastOutput out;
    ExpectRefused(ErrorCode::nullArgument, "output", [&] { f->RayCast(nullptr, {{0, 0}, {1, 1}, 1}); });
    ExpectRefused(ErrorCode::nonFinite, "RayCastInput::p1", [&] { f->RayCast(&out, {{nan, 0}, {1, 1}, 1}); });
    ExpectRefused(ErrorCode::outOfRange, "RayCastInput::maxFraction", [&] { f->RayCast(&out, {{0, 0}, {1, 1}, -1}); });
    Contact* contact = world.GetContactList();
    ASSERT_NE(contact, nullptr);
    ExpectRefused(ErrorCode::outOfRange, "friction", [&] { contact->SetFriction(-1); });
    ExpectRefused(ErrorCode::nonFinite, "friction", [&] { contact->SetFriction(nan); });
    ExpectRefused(ErrorCode::nonFinite, "restitution", [&] { contact->SetRestitution(nan); });
    ExpectRefused(ErrorCode::nonFinite, "threshold", [&] { contact->SetRestitutionThreshold(nan); });
    ExpectRefused(ErrorCode::nonFinite, "speed", [&] { contact->SetTangentSpeed(infinity); });
    box->SetTransform({0, 20}, 0);
    StepFor(world, 2);
    ASSERT_EQ(world.GetContactCount(), 0);
    ExpectRefused(ErrorCode::foreignHandle, "this", [&] { contact->SetFriction(1); });
    ExpectRefused(ErrorCode::foreignHandle, "this", [&] { contact->SetEnabled(false); });
    ExpectRefused(ErrorCode::foreignHandle, "this", [&] { contact->ResetFriction(); });
}

TEST_F(BadWorldInput, DeadBodiesAndFixtures) {
    Body* dead = AddBody(world, dynamicBody, {5, 5});
    Fixture* deadFixture = AddCircle(dead, 1);
    world.DestroyBody(dead);
    CircleShape circle;
    circle.m_radius = 1;
    MassData mass{1, {0, 0}, 1};
    const auto refused = [&](const std::function<void()>& action) {
        ExpectRefused(ErrorCode::foreignHandle, "this", action);
    };
    refused([&] { EXPECT_EQ(dead->CreateFixture(&circle, 1), nullptr); });
    refused([&] { dead->DestroyFixture(deadFixture); });
    refused([&] { dead->DestroyChain(deadFixture); });
    refused([&] { dead->SetTransform({0, 0}, 0); });
    refused([&] { dead->SetType(staticBody); });
    refused([&] { dead->SetEnabled(false); });
    refused([&] { dead->SetMassData(&mass); });
    refused([&] { dead->ResetMassData(); });
    refused([&] { dead->SetLinearVelocity({1, 0}); });
    refused([&] { dead->SetAngularVelocity(1); });
    refused([&] { dead->ApplyForce({1, 0}, {0, 0}, true); });
    refused([&] { dead->ApplyForceToCenter({1, 0}, true); });
    refused([&] { dead->ApplyTorque(1, true); });
    refused([&] { dead->ApplyLinearImpulse({1, 0}, {0, 0}, true); });
    refused([&] { dead->ApplyLinearImpulseToCenter({1, 0}, true); });
    refused([&] { dead->ApplyAngularImpulse(1, true); });
    refused([&] { dead->SetLinearDamping(1); });
    refused([&] { dead->SetAngularDamping(1); });
    refused([&] { dead->SetGravityScale(1); });
    refused([&] { dead->SetBullet(true); });
    refused([&] { dead->SetSleepingAllowed(false); });
    refused([&] { dead->SetAwake(true); });
    refused([&] { dead->SetFixedRotation(true); });
    refused([&] { deadFixture->SetSensor(true); });
    refused([&] { deadFixture->SetFilterData({}); });
    refused([&] { deadFixture->Refilter(); });
    refused([&] { deadFixture->SetDensity(1); });
    refused([&] { deadFixture->SetFriction(1); });
    refused([&] { deadFixture->SetRestitution(1); });
    refused([&] { deadFixture->SetRestitutionThreshold(1); });
    ExpectRefused(ErrorCode::foreignHandle, "body", [&] { world.DestroyBody(dead); });
    ExpectRefused(ErrorCode::foreignHandle, "fixture", [&] { box->DestroyFixture(deadFixture); });
    StepFor(world, 2);
}

TEST(BadWorldDef, MakesNoWorld) {
    const auto expectNone = [](const char* field, auto change) {
        WorldDef def;
        change(def);
        Error heard{ErrorCode::ok, "", "", ""};
        const auto hear = [](const Error& error, void* to) { *static_cast<Error*>(to) = error; };
        EXPECT_EQ(CreateWorld(def, hear, &heard), nullptr);
        EXPECT_NE(heard.code, ErrorCode::ok);
        EXPECT_STREQ(heard.field, field);
        testing::internal::CaptureStderr();
        EXPECT_EQ(CreateWorld(def), nullptr);
        EXPECT_THROW(World{def}, std::invalid_argument);
        const std::string told = testing::internal::GetCapturedStderr();
        EXPECT_NE(told.find(field), told.rfind(field)) << "both tell: " << told;
    };
    expectNone("WorldDef::gravity", [](WorldDef& d) { d.gravity.x = nan; });
    expectNone("WorldDef::maxTranslation", [](WorldDef& d) { d.maxTranslation = -1; });
    expectNone("WorldDef::maxRotation", [](WorldDef& d) { d.maxRotation = nan; });
    expectNone("WorldDef::staticShareThreshold", [](WorldDef& d) { d.staticShareThreshold = -1; });
    expectNone("WorldDef::staticShareThreshold", [](WorldDef& d) { d.staticShareThreshold = 1.5f; });
    expectNone("WorldDef::broadPhase", [](WorldDef& d) { d.broadPhase = static_cast<BroadPhaseKind>(77); });
    expectNone("WorldDef::workerCount", [](WorldDef& d) { d.workerCount = 0; });
    expectNone("WorldDef::tasks", [](WorldDef& d) { d.tasks.finish = [](void*, void*) {}; });
    for (const int tasks : {-1, maxWorkers / 3 + 1}) {
        expectNone("WorldDef::tasks.tasksPerWorker", [tasks](WorldDef& d) {
            d.workerCount = 3;
            d.tasks.tasksPerWorker = tasks;
        });
    }
    EXPECT_THROW(World(Vec2{0.0f, infinity}), std::invalid_argument);
}

TEST(BadWorldDef, AGoodOneMakesAWorldThatTellsTheHandler) {
    Error heard{ErrorCode::ok, "", "", ""};
    const auto hear = [](const Error& error, void* to) { *static_cast<Error*>(to) = error; };
    const std::unique_ptr<World> world = CreateWorld({}, hear, &heard);
    ASSERT_NE(world, nullptr);
    EXPECT_EQ(heard.code, ErrorCode::ok);
    EXPECT_EQ(world->CreateBody(nullptr), nullptr);
    EXPECT_EQ(heard.code, ErrorCode::nullArgument);
}

}  // namespace
}  // namespace scree::test
