// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Edits of a living world against Box2D 2.4.1: types changed on the fly, masses, moved origins, lists, ids, contacts
// per body.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/world/engines.h"
#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

/// What a program can see of a body, as one line.
template <class Body>
std::string Describe(Body* b) {
    char line[256];
    std::snprintf(line, sizeof line,
                  "type %d p (%.3f %.3f) a %.3f v (%.3f %.3f) w %.3f m %.3f I %.3f c (%.3f %.3f) awake %d",
                  static_cast<int>(b->GetType()), static_cast<double>(b->GetPosition().x),
                  static_cast<double>(b->GetPosition().y), static_cast<double>(b->GetAngle()),
                  static_cast<double>(b->GetLinearVelocity().x), static_cast<double>(b->GetLinearVelocity().y),
                  static_cast<double>(b->GetAngularVelocity()), static_cast<double>(b->GetMass()),
                  static_cast<double>(b->GetInertia()), static_cast<double>(b->GetWorldCenter().x),
                  static_cast<double>(b->GetWorldCenter().y), b->IsAwake() ? 1 : 0);
    return line;
}

template <class E>
Log ChangeTypes() {
    typename E::World world({0.0f, -10.0f});
    world.SetContinuousPhysics(false);
    Log log;
    Attach<E>(MakeBody<E>(world, E::isStatic, 0, -1), BoxShape<E>(50, 1), 0);
    typename E::Polygon offset;
    offset.SetAsBox(0.5f, 0.5f, {0.3f, 0.1f}, 0.2f);
    const typename E::BodyType types[3] = {E::isStatic, E::isKinematic, E::isDynamic};
    for (int from = 0; from < 3; ++from) {
        for (int to = 0; to < 3; ++to) {
            typename E::Body* b =
                MakeBody<E>(world, types[from], 6.0f * static_cast<float>(3 * from + to) - 20.0f, 3.0f);
            Attach<E>(b, offset, 2.0f);
            if (from != 0) {
                b->SetLinearVelocity({1.0f, 2.0f});
                b->SetAngularVelocity(0.5f);
            }
            b->ApplyForceToCenter({30.0f, 0.0f}, true);
            world.Step(1.0f / 60.0f, 8, 3);
            log.push_back(Describe(b));
            b->ApplyForceToCenter({300.0f, 0.0f}, true);
            b->SetType(types[to]);
            log.push_back(Describe(b));
            StepTimes(world, 20);
            log.push_back(Describe(b));
            b->SetType(types[from]);
            StepTimes(world, 20);
            log.push_back(Describe(b));
        }
    }
    return log;
}

TEST(Edits, ChangingTypesDoesWhatBox2DDoes) { EXPECT_EQ(ChangeTypes<Ours>(), ChangeTypes<Theirs>()); }

template <class E>
Log Masses() {
    typename E::World world({0.0f, -10.0f});
    Log log;
    typename E::Body* b = MakeBody<E>(world, E::isDynamic, 1, 2);
    const auto note = [&] { log.push_back(Describe(b)); };
    note();  // no fixture
    auto* f = Attach<E>(b, CircleOf<E>(0.5f), 0.0f);
    note();  // no density
    StepTimes(world, 3);
    note();
    f->SetDensity(3.0f);
    note();
    b->ResetMassData();
    note();
    b->SetAngularVelocity(2.0f);
    typename E::Polygon offset;
    offset.SetAsBox(0.5f, 0.5f, {1.0f, 0.0f}, 0.0f);
    Attach<E>(b, offset, 1.0f);
    note();
    b->SetFixedRotation(true);
    note();
    b->SetFixedRotation(false);
    note();
    typename E::MassData data;
    data.mass = 5.0f;
    data.center = {0.2f, 0.1f};
    data.I = 4.0f;
    b->SetMassData(&data);
    note();
    StepTimes(world, 5);
    note();
    data.mass = 0.0f;
    data.I = 0.0f;
    b->SetMassData(&data);
    note();
    b->DestroyFixture(f);
    note();
    b->SetGravityScale(0.0f);
    b->SetLinearDamping(0.5f);
    b->SetAngularDamping(0.3f);
    b->SetLinearVelocity({1, 1});
    StepTimes(world, 10);
    note();
    b->SetGravityScale(-2.0f);
    StepTimes(world, 10);
    note();
    b->SetAwake(false);
    note();
    b->SetSleepingAllowed(false);
    note();
    return log;
}

TEST(Edits, MassesAreBox2Ds) { EXPECT_EQ(Masses<Ours>(), Masses<Theirs>()); }

TEST(Edits, ABodyMadeStaticCountsAsStaticInListAndBroadPhase) {
    World world({0.0f, -10.0f});
    Body* s = AddBody(world, staticBody, {0, 0});
    Body* d = AddBody(world, dynamicBody, {0, 1});
    AddBox(s, 1, 1);
    AddBox(d, 1, 1);
    StepFor(world, 2);
    EXPECT_EQ(world.GetContactCount(), 1);
    d->SetType(staticBody);
    EXPECT_EQ(world.GetContactCount(), 0);
    EXPECT_EQ(world.GetBodyList(), d);
    StepFor(world, 2);
    EXPECT_EQ(world.GetContactCount(), 0);  // two static bodies never pair
    EXPECT_EQ(d->GetPosition().y, d->GetTransform().p.y);
    s->SetType(dynamicBody);
    EXPECT_EQ(world.GetBodyList(), s);
    StepFor(world, 2);
    EXPECT_EQ(world.GetContactCount(), 1);
}

template <class E>
Log ListOrders() {
    typename E::World world({0.0f, -10.0f});
    std::vector<typename E::Body*> bodies;
    for (uintptr_t i = 0; i < 6; ++i) {
        bodies.push_back(MakeBody<E>(world, E::isDynamic, 2.0f * static_cast<float>(i), 0, i));
        for (uintptr_t k = 0; k < 3; ++k) SetName(Attach<E>(bodies.back(), CircleOf<E>(0.2f)), 10 * i + k);
    }
    for (size_t i = 0; i + 1 < bodies.size(); ++i) {
        typename E::RevoluteJointDef def;
        def.Initialize(bodies[i], bodies[i + 1], {0, 0});
        def.userData.pointer = 100 + i;
        world.CreateJoint(&def);
    }
    world.DestroyBody(bodies[2]);
    bodies[3]->DestroyFixture(bodies[3]->GetFixtureList()->GetNext());
    MakeBody<E>(world, E::isDynamic, 0, 9, 77);
    Log log;
    for (auto* b = world.GetBodyList(); b; b = b->GetNext()) {
        log.push_back("body " + std::to_string(b->GetUserData().pointer));
        for (auto* f = b->GetFixtureList(); f; f = f->GetNext())
            log.push_back("fixture " + std::to_string(f->GetUserData().pointer));
    }
    for (auto* j = world.GetJointList(); j; j = j->GetNext())
        log.push_back("joint " + std::to_string(j->GetUserData().pointer));
    return log;
}

TEST(Edits, ListsOfMoversHaveBox2DsOrder) { EXPECT_EQ(ListOrders<Ours>(), ListOrders<Theirs>()); }

template <class E>
Log ContactLists() {
    typename E::World world({0.0f, -10.0f});
    typename E::Body* plate = MakeBody<E>(world, E::isStatic, 0, 0, 1);
    Attach<E>(plate, BoxShape<E>(10, 1), 0);
    for (uintptr_t i = 0; i < 5; ++i)
        Attach<E>(MakeBody<E>(world, E::isDynamic, 3.0f * static_cast<float>(i) - 6.0f, 1.4f, 2 + i),
                  CircleOf<E>(0.5f));
    StepTimes(world, 3);
    Log log;
    for (auto* c = world.GetContactList(); c; c = c->GetNext()) {
        log.push_back(std::to_string(c->GetFixtureA()->GetUserData().pointer) + "-" +
                      std::to_string(c->GetFixtureB()->GetUserData().pointer) + (c->IsTouching() ? " touching" : ""));
    }
    return log;
}

TEST(Edits, ContactListHasBox2DsOrder) { EXPECT_EQ(ContactLists<Ours>(), ContactLists<Theirs>()); }

TEST(Edits, ContactsOfABodyAreThoseOfTheWorldThatNameIt) {
    EXPECT_TRUE(rc::check("adjacency = filter of the contact list", [] {
        World world({0.0f, -10.0f});
        AddGround(world, 10.0f);
        std::vector<Body*> bodies;
        const int count = *rc::gen::inRange(1, 40);
        for (int i = 0; i < count; ++i) {
            bodies.push_back(AddBody(world, dynamicBody,
                                     {static_cast<float>(*rc::gen::inRange(-40, 40)) * 0.1f,
                                      static_cast<float>(*rc::gen::inRange(5, 40)) * 0.1f}));
            AddCircle(bodies.back(), 0.4f);
        }
        for (int round = 0; round < 4; ++round) {
            StepFor(world, 2);
            if (!bodies.empty()) {
                world.DestroyBody(bodies.back());
                bodies.pop_back();
            }
            int total = 0;
            for (Body* b = world.GetBodyList(); b; b = b->GetNext()) {
                std::set<Contact*> expected, found;
                for (Contact* c = world.GetContactList(); c; c = c->GetNext()) {
                    if (c->GetFixtureA()->GetBody() == b || c->GetFixtureB()->GetBody() == b) expected.insert(c);
                }
                b->VisitContacts([&](Contact* c) { return found.insert(c).second; });
                RC_ASSERT(found == expected);
                RC_ASSERT(b->GetContactCount() == static_cast<int>(expected.size()));
                total += b->GetContactCount();
            }
            RC_ASSERT(total == 2 * world.GetContactCount());
        }
    }));
}

/// A small pile, before and after its origin is shifted, relative to the origin.
template <class E>
std::vector<float> ShiftedPile(bool shift) {
    typename E::World world({0.0f, -10.0f});
    Attach<E>(MakeBody<E>(world, E::isStatic, 1024, -1), BoxShape<E>(50, 1), 0);
    std::vector<typename E::Body*> boxes;
    for (int i = 0; i < 6; ++i) {
        boxes.push_back(MakeBody<E>(world, E::isDynamic, 1024.0f + 0.25f * static_cast<float>(i % 2),
                                    0.5f + 1.0625f * static_cast<float>(i)));
        Attach<E>(boxes.back(), BoxShape<E>(0.5f, 0.5f));
    }
    StepTimes(world, 20);
    if (shift) world.ShiftOrigin({1024.0f, 256.0f});
    StepTimes(world, 60);
    std::vector<float> out;
    for (auto* b : boxes) {
        out.push_back(b->GetPosition().x - (shift ? 0.0f : 1024.0f));
        out.push_back(b->GetPosition().y + (shift ? 256.0f : 0.0f));
        out.push_back(b->GetAngle());
    }
    return out;
}

TEST(Edits, ShiftOriginMovesEverythingAndNothingElse) {
    const std::vector<float> plain = ShiftedPile<Ours>(false), shifted = ShiftedPile<Ours>(true),
                             theirs = ShiftedPile<Theirs>(true);
    // At 1024 m a float has 6e-5 m; 60 steps of a settling pile amplify that to a few millimetres at most.
    for (size_t i = 0; i < plain.size(); ++i) {
        EXPECT_NEAR(plain[i], shifted[i], 5e-3f) << i;
        EXPECT_NEAR(theirs[i], shifted[i], 2e-2f) << i;
    }
}

TEST(Edits, ShiftOriginKeepsContactsAndBoxesInEveryBroadPhase) {
    for (int kind = 0; kind < static_cast<int>(broadPhaseNames.size()); ++kind) {
        WorldDef def;
        def.broadPhase = static_cast<BroadPhaseKind>(kind);
        World world(def);
        Fixture* ground = AddGround(world)->GetFixtureList();
        Body* box = AddBody(world, dynamicBody, {0, 0.5f});
        Fixture* fixture = AddBox(box, 0.5f, 0.5f);
        StepFor(world, 5);
        const Contact* contact = world.GetContactList();
        const float impulse = contact->GetManifold().points[0].normalImpulse;
        ASSERT_EQ(world.ShiftOrigin({64, 32}), ErrorCode::ok);
        EXPECT_EQ(world.GetContactCount(), 1);
        EXPECT_EQ(contact->GetManifold().points[0].normalImpulse, impulse);
        EXPECT_NEAR(box->GetPosition().x, -64.0f, 1e-4f);
        EXPECT_TRUE(TestOverlap(fixture->GetAABB(), {box->GetPosition(), box->GetPosition()}));
        const auto hit = world.RayCastClosest({-64, 0}, {-64, -100});
        ASSERT_TRUE(hit.has_value());
        EXPECT_EQ(hit->fixture, fixture);
        EXPECT_TRUE(world.RayCastClosest({-60, 0}, {-60, -100})->fixture == ground);
        StepFor(world, 5);
        EXPECT_NEAR(box->GetPosition().y, 0.5f - 32.0f, 2.0f * polygonRadius);  // rests within both skins
    }
}

TEST(Edits, IdsOutliveTheirObjectsAndKnowIt) {
    World world({0.0f, -10.0f});
    Body* a = AddBody(world, dynamicBody, {0, 0});
    Fixture* f = AddCircle(a, 1);
    Body* b = AddBody(world, dynamicBody, {5, 0});
    RevoluteJointDef def;
    def.Initialize(a, b, {0, 0});
    Joint* j = world.CreateJoint(&def);
    const BodyId bodyId = world.GetId(a);
    const FixtureId fixtureId = world.GetId(f);
    const JointId jointId = world.GetId(j);
    EXPECT_EQ(world.Find(bodyId), a);
    EXPECT_EQ(world.Find(fixtureId), f);
    EXPECT_EQ(world.Find(jointId), j);
    world.DestroyBody(a);
    EXPECT_EQ(world.Find(bodyId), nullptr);
    EXPECT_EQ(world.Find(fixtureId), nullptr);
    EXPECT_EQ(world.Find(jointId), nullptr);
    Body* reused = AddBody(world, dynamicBody, {0, 0});
    EXPECT_EQ(reused, a);  // the slot is used again: the pointer lies, the id does not
    EXPECT_EQ(world.Find(bodyId), nullptr);
    EXPECT_EQ(world.Find(world.GetId(reused)), reused);
    EXPECT_EQ(world.Find(BodyId{}), nullptr);
    EXPECT_EQ(world.Find(BodyId{1000, 0}), nullptr);
    World other({0, 0});
    EXPECT_EQ(other.GetId(reused), BodyId{});
    EXPECT_EQ(world.GetId(static_cast<Body*>(nullptr)), BodyId{});
}

TEST(Edits, TreeStatisticsAreThoseOfTheInspectedTree) {
    for (int kind = 0; kind < static_cast<int>(broadPhaseNames.size()); ++kind) {
        WorldDef def;
        def.broadPhase = static_cast<BroadPhaseKind>(kind);
        World world(def);
        EXPECT_EQ(world.GetTreeHeight(), 0);
        EXPECT_EQ(world.GetTreeQuality(), 0.0f);
        for (int i = 0; i < 64; ++i)
            AddCircle(AddBody(world, dynamicBody, {static_cast<float>(i % 8) * 3.0f, static_cast<float>(i / 8) * 3.0f}),
                      0.5f);
        std::vector<BvhNode> nodes;
        inspect::GetNodes(world, nodes);
        if (nodes.empty()) {
            EXPECT_EQ(world.GetTreeHeight(), 0);
            continue;
        }
        EXPECT_EQ(nodes.size(), 127u);
        EXPECT_GE(world.GetTreeHeight(), 6);
        EXPECT_LE(world.GetTreeHeight(), 20);
        EXPECT_GE(world.GetTreeBalance(), 0);
        EXPECT_GT(world.GetTreeQuality(), 1.0f);
        EXPECT_LT(world.GetTreeQuality(), 63.0f);
        EXPECT_EQ(world.GetProxyCount(), 64);
    }
}

TEST(Edits, ExactDriftFliesExactParabolas) {
    for (const float hertz : {10.0f, 60.0f}) {
        WorldDef def;
        def.exactDrift = true;
        World exact(def);
        World plain({0.0f, -10.0f});
        float errors[2];
        int k = 0;
        for (World* world : {&exact, &plain}) {
            Body* body = AddBody(*world, dynamicBody, {0, 0});
            AddCircle(body, 0.5f);
            body->SetLinearVelocity({10, 20});
            for (int i = 0; i < static_cast<int>(4.0f * hertz); ++i) world->Step(1.0f / hertz, 8, 3);
            errors[k++] = Distance(body->GetPosition(), {40.0f, 0.0f});  // 20 t − 5 t² at t = 4
        }
        EXPECT_LT(errors[0], 1e-3f);                                 // rounding of some hundred sums of up to 40 m
        EXPECT_NEAR(errors[1], 0.5f * 10.0f * 4.0f / hertz, 1e-2f);  // ½·g·t·h, what semi-implicit Euler lags
    }
}

TEST(Edits, ExactDriftIsTheSameOnTheIslandPath) {
    for (const bool exactDrift : {false, true}) {
        WorldDef def;
        def.exactDrift = exactDrift;
        World apart(def), among(def);
        inspect::SetIsolatedPath(among, false);
        Body* alone = AddBody(apart, dynamicBody, {0, 0});
        Body* listed = AddBody(among, dynamicBody, {0, 0});
        for (Body* b : {alone, listed}) {
            AddBox(b, 0.5f, 0.25f);
            b->SetLinearVelocity({3, 4});
            b->SetAngularVelocity(2);
            b->SetLinearDamping(0.1f);
        }
        for (int i = 0; i < 100; ++i) {
            ASSERT_EQ(apart.Step(1.0f / 60.0f, 8, 3).isolatedBodyCount, 1);
            ASSERT_EQ(among.Step(1.0f / 60.0f, 8, 3).isolatedBodyCount, 0);
            ASSERT_EQ(alone->GetPosition(), listed->GetPosition());
            ASSERT_EQ(alone->GetAngle(), listed->GetAngle());
            ASSERT_EQ(alone->GetLinearVelocity(), listed->GetLinearVelocity());
        }
    }
}

TEST(Edits, SettingsAreKept) {
    WorldDef def;
    EXPECT_TRUE(def.continuousPhysics);
    World world(def);
    EXPECT_TRUE(world.GetContinuousPhysics());
    world.SetContinuousPhysics(false);
    EXPECT_FALSE(world.GetContinuousPhysics());
    EXPECT_FALSE(world.GetSubStepping());
    world.SetSubStepping(true);
    EXPECT_TRUE(world.GetSubStepping());
    EXPECT_FALSE(world.GetExactDrift());
    world.SetExactDrift(true);
    EXPECT_TRUE(world.GetExactDrift());
    AddGround(world);
    StepFor(world, 1);
    EXPECT_GT(world.GetProfile().step, 0.0f);
    EXPECT_EQ(&world.GetProfile(), &world.GetReport().profile);
}

}  // namespace
}  // namespace scree::test
