// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What listeners hear, and when, equals what Box2D 2.4.1 tells on the same small worlds; edits inside callbacks are
// refused and change nothing.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <vector>

#include "tests/world/engines.h"
#include "tests/world/fixtures.h"
#include "world/world_state.h"

namespace scree::test {
namespace {

/// Writes one line per event: step, event, names of both fixtures. Wide boxes of the rival make contacts earlier, so
/// only events of touching contacts are compared.
template <class E>
class Recorder : public E::ContactListener {
public:
    void BeginContact(typename E::Contact* contact) override { Write("begin", contact); }
    void EndContact(typename E::Contact* contact) override { Write("end", contact); }
    void PreSolve(typename E::Contact* contact, const typename E::Manifold* old) override {
        Write("pre " + std::to_string(static_cast<int>(old->pointCount)), contact);
    }
    void PostSolve(typename E::Contact* contact, const typename E::ContactImpulse* impulse) override {
        Write("post " + std::to_string(impulse->count), contact);
    }
    Log log;
    int step = 0;

private:
    void Write(const std::string& event, typename E::Contact* contact) {
        log.push_back(std::to_string(step) + " " + event + " " +
                      std::to_string(contact->GetFixtureA()->GetUserData().pointer) + "-" +
                      std::to_string(contact->GetFixtureB()->GetUserData().pointer));
    }
};

/// The order of contacts within a step depends on how early their boxes met, which wide boxes change; what happens in
/// each step does not.
Log SortedWithinSteps(Log log) {
    auto from = log.begin();
    while (from != log.end()) {
        const std::string step = from->substr(0, from->find(' '));
        const auto to = std::find_if(from, log.end(),
                                     [&](const std::string& line) { return line.substr(0, line.find(' ')) != step; });
        std::sort(from, to);
        from = to;
    }
    return log;
}

template <class E>
Log FallingThings() {
    typename E::World world({0.0f, -10.0f});
    world.SetContinuousPhysics(false);
    Recorder<E> recorder;
    world.SetContactListener(&recorder);
    Attach<E>(MakeBody<E>(world, E::isStatic, 0, 0, 1), EdgeOf<E>({-20, 0}, {20, 0}), 0);
    Attach<E>(MakeBody<E>(world, E::isDynamic, 0, 1.0f, 2), BoxShape<E>(0.5f, 0.5f));
    Attach<E>(MakeBody<E>(world, E::isDynamic, 3, 2.0f, 3), CircleOf<E>(0.5f));
    Attach<E>(MakeBody<E>(world, E::isStatic, 3, 1.5f, 4), BoxShape<E>(0.5f, 0.1f), 0, true);  // a sensor on its way
    Attach<E>(MakeBody<E>(world, E::isDynamic, 6, 0.55f, 5), BoxShape<E>(0.5f, 0.5f));
    for (recorder.step = 0; recorder.step < 90; ++recorder.step) world.Step(1.0f / 60.0f, 8, 3);
    return recorder.log;
}

TEST(Callbacks, SequenceOfFallingThingsIsBox2Ds) {
    const Log ours = SortedWithinSteps(FallingThings<Ours>()), theirs = SortedWithinSteps(FallingThings<Theirs>());
    EXPECT_GT(ours.size(), 100u);
    ASSERT_EQ(ours.size(), theirs.size());
    for (size_t i = 0; i < ours.size(); ++i) ASSERT_EQ(ours[i], theirs[i]) << i;
}

template <class E>
Log StackedBoxes() {
    typename E::World world({0.0f, -10.0f});
    world.SetContinuousPhysics(false);
    Recorder<E> recorder;
    world.SetContactListener(&recorder);
    Attach<E>(MakeBody<E>(world, E::isStatic, 0, 0, 1), EdgeOf<E>({-20, 0}, {20, 0}), 0);
    for (int i = 0; i < 3; ++i) {
        Attach<E>(
            MakeBody<E>(world, E::isDynamic, 0, 0.5f + 1.0f * static_cast<float>(i), static_cast<uintptr_t>(i + 2)),
            BoxShape<E>(0.5f, 0.5f));
    }
    for (recorder.step = 0; recorder.step < 60; ++recorder.step) world.Step(1.0f / 60.0f, 8, 3);
    return recorder.log;
}

TEST(Callbacks, SequenceOfAStackIsBox2Ds) { EXPECT_EQ(StackedBoxes<Ours>(), StackedBoxes<Theirs>()); }

/// Edits between steps: filter, sensor, type, enabling, destruction.
template <class E>
Log Edits() {
    typename E::World world({0.0f, -10.0f});
    world.SetContinuousPhysics(false);
    Recorder<E> recorder;
    world.SetContactListener(&recorder);
    Attach<E>(MakeBody<E>(world, E::isStatic, 0, 0, 1), EdgeOf<E>({-20, 0}, {20, 0}), 0);
    std::vector<typename E::Body*> boxes;
    for (int i = 0; i < 5; ++i) {
        boxes.push_back(
            MakeBody<E>(world, E::isDynamic, 3.0f * static_cast<float>(i), 0.5f, static_cast<uintptr_t>(i + 2)));
        Attach<E>(boxes.back(), BoxShape<E>(0.5f, 0.5f));
    }
    StepTimes(world, 5);
    recorder.log.clear();
    recorder.step = 1;
    auto filter = boxes[0]->GetFixtureList()->GetFilterData();
    filter.maskBits = 0;
    boxes[0]->GetFixtureList()->SetFilterData(filter);
    boxes[1]->GetFixtureList()->SetSensor(true);
    recorder.log.push_back("before step");
    world.Step(1.0f / 60.0f, 8, 3);
    recorder.step = 2;
    recorder.log.push_back("type");
    boxes[2]->SetType(E::isKinematic);
    recorder.log.push_back("enabled");
    boxes[3]->SetEnabled(false);
    recorder.log.push_back("destroy");
    world.DestroyBody(boxes[4]);
    recorder.log.push_back("before step");
    world.Step(1.0f / 60.0f, 8, 3);
    boxes[2]->SetType(E::isDynamic);
    boxes[3]->SetEnabled(true);
    recorder.step = 3;
    world.Step(1.0f / 60.0f, 8, 3);
    world.Step(1.0f / 60.0f, 8, 3);
    return recorder.log;
}

TEST(Callbacks, EditsBetweenStepsTellWhatBox2DTells) {
    EXPECT_EQ(SortedWithinSteps(Edits<Ours>()), SortedWithinSteps(Edits<Theirs>()));
}

/// A platform that lets bodies through from below: PreSolve disables the contact while the body comes up.
template <class E>
class OneWay : public E::ContactListener {
public:
    explicit OneWay(typename E::Body* platform) : m_platform(platform) {}
    void PreSolve(typename E::Contact* contact, const typename E::Manifold*) override {
        typename E::Body* a = contact->GetFixtureA()->GetBody();
        typename E::Body* other = a == m_platform ? contact->GetFixtureB()->GetBody() : a;
        if (other->GetLinearVelocity().y > 0.5f || other->GetPosition().y < m_platform->GetPosition().y + 0.4f)
            contact->SetEnabled(false);
    }

private:
    typename E::Body* m_platform;
};

template <class E>
std::vector<float> JumpThroughPlatform() {
    typename E::World world({0.0f, -10.0f});
    world.SetContinuousPhysics(false);
    typename E::Body* platform = MakeBody<E>(world, E::isStatic, 0, 5);
    Attach<E>(platform, BoxShape<E>(3.0f, 0.1f), 0);
    OneWay<E> listener(platform);
    world.SetContactListener(&listener);
    typename E::Body* ball = MakeBody<E>(world, E::isDynamic, 0, 0);
    Attach<E>(ball, CircleOf<E>(0.5f));
    ball->SetLinearVelocity({0.0f, 12.0f});
    std::vector<float> heights;
    for (int i = 0; i < 180; ++i) {
        world.Step(1.0f / 60.0f, 8, 3);
        heights.push_back(ball->GetPosition().y);
    }
    return heights;
}

TEST(Callbacks, OneWayPlatformCatchesFromAboveOnly) {
    const std::vector<float> ours = JumpThroughPlatform<Ours>();
    const std::vector<float> theirs = JumpThroughPlatform<Theirs>();
    EXPECT_GT(*std::max_element(ours.begin(), ours.end()), 6.0f);  // through, upwards
    EXPECT_NEAR(ours.back(), 5.6f, 0.02f);                         // and standing on it; one skin of 1 cm and one slop
    for (size_t i = 0; i < ours.size(); ++i) EXPECT_NEAR(ours[i], theirs[i], 1e-4f) << i;
}

template <class E>
class Goodbyes : public E::DestructionListener {
public:
    explicit Goodbyes(Log& log) : m_log(log) {}
    void SayGoodbye(typename E::Joint* joint) override {
        m_log.push_back("joint " + std::to_string(joint->GetUserData().pointer));
    }
    void SayGoodbye(typename E::Fixture* fixture) override {
        m_log.push_back("fixture " + std::to_string(fixture->GetUserData().pointer));
    }

private:
    Log& m_log;
};

template <class E>
Log DestroyABody() {
    typename E::World world({0.0f, -10.0f});
    Recorder<E> recorder;
    Goodbyes<E> goodbyes(recorder.log);
    Attach<E>(MakeBody<E>(world, E::isStatic, 0, 0, 1), EdgeOf<E>({-20, 0}, {20, 0}), 0);
    typename E::Body* body = MakeBody<E>(world, E::isDynamic, 0, 0.5f, 2);
    for (uintptr_t i = 0; i < 3; ++i) SetName(Attach<E>(body, BoxShape<E>(0.5f, 0.5f)), 20 + i);
    for (uintptr_t i = 0; i < 3; ++i) {
        typename E::Body* other = MakeBody<E>(world, E::isDynamic, 5.0f + 2.0f * static_cast<float>(i), 3.0f, 3 + i);
        Attach<E>(other, CircleOf<E>(0.5f));
        typename E::RevoluteJointDef def;
        def.Initialize(body, other, {0.0f, 1.0f});
        def.userData.pointer = 100 + i;
        world.CreateJoint(&def);
    }
    StepTimes(world, 2);
    world.SetContactListener(&recorder);
    world.SetDestructionListener(&goodbyes);
    world.DestroyBody(body);
    recorder.log.push_back(std::to_string(world.GetBodyCount()) + " " + std::to_string(world.GetJointCount()));
    return recorder.log;
}

TEST(Callbacks, DestroyBodySaysGoodbyeInBox2DsOrder) {
    const Log ours = DestroyABody<Ours>();
    EXPECT_EQ(ours, DestroyABody<Theirs>());
    EXPECT_EQ(ours.size(), 3u + 3u + 3u + 1u);  // joints, contacts, fixtures, counts
}

/// Runs an action once in the callback of choice.
class Meddler : public ContactListener, public DestructionListener {
public:
    std::function<void()> begin, end, pre, post, goodbye;
    void BeginContact(Contact*) override { Once(begin); }
    void EndContact(Contact*) override { Once(end); }
    void PreSolve(Contact*, const Manifold*) override { Once(pre); }
    void PostSolve(Contact*, const ContactImpulse*) override { Once(post); }
    void SayGoodbye(Joint*) override { Once(goodbye); }
    void SayGoodbye(Fixture*) override { Once(goodbye); }

private:
    static void Once(std::function<void()>& action) {
        const std::function<void()> now = std::move(action);
        action = nullptr;
        if (now) now();
    }
};

class Locked : public ::testing::Test {
protected:
    Locked() : world({0.0f, -10.0f}), errors(world) {
        ground = AddGround(world);
        box = AddBody(world, dynamicBody, {0, 0.5f});
        AddBox(box, 0.5f, 0.5f);
        other = AddBody(world, dynamicBody, {5, 0.5f});
        AddBox(other, 0.5f, 0.5f);
        const Vec2 points[3] = {{10, 0}, {12, 0}, {14, 0}};
        EXPECT_TRUE(chain.CreateChain(points, 3, {8, 0}, {16, 0}));
        edge = ground->CreateFixture(&chain, 0.0f);
        RevoluteJointDef def;
        def.Initialize(box, other, {2.5f, 0.5f});
        joint = world.CreateJoint(&def);
        jointDef = def;
        world.SetContactListener(&meddler);
        world.SetDestructionListener(&meddler);
    }

    /// Every edit that a locked world refuses.
    void MeddleWithEverything() {
        EXPECT_TRUE(world.IsLocked());
        const int bodies = world.GetBodyCount(), fixtures = world.GetFixtureCount(), joints = world.GetJointCount();
        const Vec2 position = box->GetPosition();
        const auto refused = [&](const char* what, const std::function<void()>& action) {
            const int count = errors.count;
            action();
            EXPECT_EQ(errors.count, count + 1) << what;
            EXPECT_EQ(errors.last.code, ErrorCode::locked) << what;
        };
        CircleShape circle;
        circle.m_radius = 1.0f;
        BodyDef bodyDef;
        MassData mass{1.0f, {0, 0}, 1.0f};
        refused("CreateBody", [&] { EXPECT_EQ(world.CreateBody(&bodyDef), nullptr); });
        refused("DestroyBody", [&] { world.DestroyBody(box); });
        refused("CreateJoint", [&] { EXPECT_EQ(world.CreateJoint(&jointDef), nullptr); });
        refused("DestroyJoint", [&] { world.DestroyJoint(joint); });
        refused("Step", [&] { world.Step(1.0f / 60.0f, 8, 3); });
        refused("ShiftOrigin", [&] { world.ShiftOrigin({1, 1}); });
        refused("CreateFixture", [&] { EXPECT_EQ(box->CreateFixture(&circle, 1.0f), nullptr); });
        refused("CreateFixture chain", [&] { EXPECT_EQ(box->CreateFixture(&chain, 1.0f), nullptr); });
        refused("DestroyFixture", [&] { box->DestroyFixture(box->GetFixtureList()); });
        refused("DestroyChain", [&] { ground->DestroyChain(edge); });
        refused("SetTransform", [&] { box->SetTransform({9, 9}, 0); });
        refused("SetType", [&] { box->SetType(staticBody); });
        refused("SetEnabled", [&] { box->SetEnabled(false); });
        refused("SetMassData", [&] { box->SetMassData(&mass); });
        refused("SetFilterData", [&] { box->GetFixtureList()->SetFilterData({}); });
        refused("Refilter", [&] { box->GetFixtureList()->Refilter(); });
        EXPECT_EQ(world.GetBodyCount(), bodies);
        EXPECT_EQ(world.GetFixtureCount(), fixtures);
        EXPECT_EQ(world.GetJointCount(), joints);
        EXPECT_EQ(box->GetPosition(), position);
        EXPECT_EQ(box->GetType(), dynamicBody);
        ++meddled;
    }

    World world;
    ErrorLog errors;
    Meddler meddler;
    Body *ground, *box, *other;
    Fixture* edge;
    Joint* joint;
    RevoluteJointDef jointDef;
    ChainShape chain;
    int meddled = 0;
};

TEST_F(Locked, EveryEditIsRefusedInEveryCallback) {
    meddler.begin = meddler.pre = meddler.post = [this] { MeddleWithEverything(); };
    StepFor(world, 3);
    EXPECT_EQ(meddled, 3);
    meddler.end = [this] { MeddleWithEverything(); };
    box->SetTransform({0, 5}, 0);
    StepFor(world, 2);
    EXPECT_EQ(meddled, 4);
    EXPECT_FALSE(world.IsLocked());
    const auto query = [this](Fixture*) {
        MeddleWithEverything();
        return false;
    };
    world.QueryAABB({{-1, -1}, {20, 20}}, query);
    world.QueryPoint(other->GetPosition(), query);
    world.OverlapShape(*other->GetFixtureList()->GetShape(), other->GetTransform(), query);
    world.RayCast({5, 5}, {5, -1}, [this](Fixture*, Vec2, Vec2, float) {
        MeddleWithEverything();
        return 0.0f;
    });
    EXPECT_EQ(meddled, 8);
    EXPECT_FALSE(world.IsLocked());
    Body* victim = AddBody(world, dynamicBody, {50, 50});
    AddCircle(victim, 1.0f);
    meddler.goodbye = [this] { MeddleWithEverything(); };
    EXPECT_EQ(world.DestroyBody(victim), ErrorCode::ok);
    EXPECT_EQ(meddled, 9);
    EXPECT_FALSE(world.IsLocked());
    EXPECT_EQ(world.DestroyBody(box), ErrorCode::ok);
}

TEST_F(Locked, WhatBox2DAllowsInsideCallbacksWorks) {
    meddler.pre = [this] {
        EXPECT_EQ(other->SetLinearVelocity({0, 3}), ErrorCode::ok);
        EXPECT_EQ(other->ApplyLinearImpulseToCenter({1, 0}, true), ErrorCode::ok);
        EXPECT_EQ(other->GetFixtureList()->SetSensor(true), ErrorCode::ok);
        EXPECT_TRUE(world.RayCastClosest({5, 5}, {5, -1}).has_value());
        ++meddled;
    };
    StepFor(world, 2);
    EXPECT_EQ(meddled, 1);
    EXPECT_EQ(errors.count, 0);
}

TEST_F(Locked, AnExceptionFromACallbackLeavesTheWorldUsable) {
    meddler.begin = [] { throw 1; };
    EXPECT_THROW(StepFor(world, 3), int);
    EXPECT_FALSE(world.IsLocked());
    StepFor(world, 3);
    EXPECT_EQ(world.DestroyBody(box), ErrorCode::ok);
}

/// Throws in one of the calls to come.
class Thrower final : public ContactListener, public ContactFilter {
public:
    void BeginContact(Contact*) override { Hear(); }
    void EndContact(Contact*) override { Hear(); }
    void PreSolve(Contact*, const Manifold*) override { Hear(); }
    void PostSolve(Contact*, const ContactImpulse*) override { Hear(); }
    bool ShouldCollide(Fixture* a, Fixture* b) override {
        Hear();
        return ContactFilter::ShouldCollide(a, b);
    }

    int callsLeft = -1;  ///< below 0: it does not throw

private:
    void Hear() {
        if (callsLeft >= 0 && callsLeft-- == 0) throw 1;
    }
};

/// Boxes and disks in a pit, some of them fast, some joined.
std::vector<Body*> FillPit(World& world, std::mt19937& random) {
    const auto draw = [&](float from, float to) { return std::uniform_real_distribution<float>(from, to)(random); };
    Body* ground = AddGround(world, 12.0f);
    for (const float x : {-12.0f, 12.0f}) {
        EdgeShape wall;
        wall.SetTwoSided({x, 0.0f}, {x, 20.0f});
        ground->CreateFixture(&wall, 0.0f);
    }
    std::vector<Body*> bodies;
    for (int i = 0; i < 50; ++i) {
        Body* body = AddBody(world, dynamicBody, {draw(-10.0f, 10.0f), draw(0.5f, 12.0f)}, draw(-3.0f, 3.0f));
        i % 2 == 0 ? AddBox(body, draw(0.1f, 0.7f), draw(0.1f, 0.7f)) : AddCircle(body, draw(0.1f, 0.6f));
        body->SetLinearVelocity({draw(-40.0f, 40.0f), draw(-40.0f, 40.0f)});
        body->SetBullet(i % 5 == 0);
        if (i % 8 == 7) {
            RevoluteJointDef hinge;
            hinge.Initialize(bodies.back(), body, body->GetPosition());
            world.CreateJoint(&hinge);
        }
        bodies.push_back(body);
    }
    return bodies;
}

TEST(Exceptions, QueriesFindBodiesWhereTheyAreThen) {
    std::mt19937 random(std::random_device{}());
    int thrown = 0;
    for (int round = 0; round < 40; ++round) {
        const int substeps = solvers[round % 2];
        WorldDef def;
        def.workerCount = 1 + round / 2 % 2;
        const std::unique_ptr<World> world = CreateWorld(def);
        world->GetState().pool->ShareAlways();
        Thrower thrower;
        world->SetContactListener(&thrower);
        if (round % 3 == 0) world->SetContactFilter(&thrower);
        const std::vector<Body*> bodies = FillPit(*world, random);
        StepWith(*world, substeps, std::uniform_int_distribution<int>(0, 20)(random));
        thrower.callsLeft = std::uniform_int_distribution<int>(0, 150)(random);
        try {
            StepWith(*world, substeps, 8);
        } catch (int) {
            ++thrown;
        }
        thrower.callsLeft = -1;
        for (const Body* body : bodies) {
            const Fixture* fixture = body->GetFixtureList();
            AABB box;
            fixture->GetShape()->ComputeAABB(&box, body->GetTransform());
            EXPECT_TRUE(fixture->GetAABB().Contains(box)) << "round " << round;
            bool isFound = false;
            world->QueryAABB(box, [&](Fixture* found) {
                isFound = isFound || found == fixture;
                return true;
            });
            EXPECT_TRUE(isFound) << "round " << round;
        }
        StepWith(*world, substeps, 3);
    }
    EXPECT_GT(thrown, 0);
}

}  // namespace
}  // namespace scree::test
