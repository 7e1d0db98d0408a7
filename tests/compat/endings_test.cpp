// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Callbacks of destruction that destroy what is going already: Box2D then frees twice; here the call is refused or the
// rest is skipped, and the world goes on. (What Box2D allows there is compared in programs/endings.cpp.)

#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <functional>
#include <utility>

namespace {

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

class Listener : public b2ContactListener, public b2DestructionListener {
public:
    void EndContact(b2Contact* contact) override {
        ++ends;
        if (onEnd) onEnd(contact);
    }
    void SayGoodbye(b2Joint* joint) override {
        ++goodbyes;
        if (onJoint) onJoint(joint);
    }
    void SayGoodbye(b2Fixture* fixture) override {
        ++goodbyes;
        if (onFixture) onFixture(fixture);
    }
    std::function<void(b2Contact*)> onEnd;
    std::function<void(b2Joint*)> onJoint;
    std::function<void(b2Fixture*)> onFixture;
    int ends = 0, goodbyes = 0;
};

/// A stack of three boxes in space, each touching the next, with a joint between the outer ones.
class Endings : public testing::Test {
protected:
    Endings() {
        for (int i = 0; i < 3; ++i) boxes[i] = MakeBox(world, 0.0f, static_cast<float>(i));
        world.SetContactListener(&listener);
        world.SetDestructionListener(&listener);
        b2DistanceJointDef def;
        def.Initialize(boxes[0], boxes[2], boxes[0]->GetPosition(), boxes[2]->GetPosition());
        world.CreateJoint(&def);
        Step();
    }
    void Step() {
        for (int i = 0; i < 3; ++i) world.Step(1.0f / 60.0f, 8, 3);
    }
    /// The lists agree with the counts, and the world steps.
    void ExpectSound(int bodies, int joints) {
        int count = 0;
        for (b2Body* b = world.GetBodyList(); b; b = b->GetNext()) ++count;
        EXPECT_EQ(count, bodies);
        EXPECT_EQ(world.GetBodyCount(), bodies);
        EXPECT_EQ(world.GetJointCount(), joints);
        count = 0;
        for (b2Contact* c = world.GetContactList(); c; c = c->GetNext()) ++count;
        EXPECT_EQ(world.GetContactCount(), count);
        listener.onEnd = nullptr;
        Step();
    }

    b2World world{b2Vec2(0.0f, 0.0f)};
    Listener listener;
    b2Body* boxes[3];
};

TEST_F(Endings, RefusesToDestroyABodyTwice) {
    listener.onEnd = [&](b2Contact*) { world.DestroyBody(boxes[1]); };
    listener.onJoint = [&](b2Joint*) { world.DestroyBody(boxes[0]); };
    listener.onFixture = [&](b2Fixture* fixture) { world.DestroyBody(fixture->GetBody()); };
    world.DestroyBody(boxes[1]);
    EXPECT_EQ(listener.ends, 2);
    world.DestroyBody(boxes[0]);
    EXPECT_EQ(listener.goodbyes, 3);
    ExpectSound(1, 0);
}

TEST_F(Endings, TellsEachContactOnceWhenTheOtherBodyGoesToo) {
    listener.onEnd = [&](b2Contact*) {
        if (boxes[2] != nullptr) world.DestroyBody(std::exchange(boxes[2], nullptr));
    };
    world.DestroyBody(boxes[1]);
    EXPECT_EQ(listener.ends, 2);
    ExpectSound(1, 0);
}

TEST_F(Endings, SurvivesAListenerThatDestroysWhatSaysGoodbye) {
    listener.onJoint = [&](b2Joint* joint) { world.DestroyJoint(joint); };
    listener.onFixture = [&](b2Fixture* fixture) { fixture->GetBody()->DestroyFixture(fixture); };
    world.DestroyBody(boxes[0]);
    ExpectSound(2, 0);
}

TEST_F(Endings, RefusesToDestroyAFixtureTwice) {
    b2Fixture* fixture = boxes[1]->GetFixtureList();
    listener.onEnd = [&](b2Contact*) {
        boxes[1]->DestroyFixture(fixture);
        world.DestroyBody(boxes[1]);
    };
    boxes[1]->DestroyFixture(fixture);
    EXPECT_EQ(boxes[1]->GetFixtureList(), nullptr);
    ExpectSound(3, 1);
}

TEST_F(Endings, RefusesToDestroyABodyThatIsBeingDisabledOrRetyped) {
    listener.onEnd = [&](b2Contact*) { world.DestroyBody(boxes[1]); };
    boxes[1]->SetEnabled(false);
    EXPECT_FALSE(boxes[1]->IsEnabled());
    boxes[1]->SetEnabled(true);
    Step();
    boxes[1]->SetType(b2_staticBody);
    EXPECT_EQ(listener.ends, 4);
    ExpectSound(3, 1);
}

TEST_F(Endings, RefusesAStepAndWhatWouldHangOnADyingBody) {
    b2Joint* joint = world.GetJointList();
    b2Fixture* fixture = joint->GetBodyA()->GetFixtureList();
    listener.onEnd = [&](b2Contact*) {
        const b2Vec2 before = boxes[2]->GetPosition();
        world.Step(1.0f / 60.0f, 8, 3);
        EXPECT_EQ(boxes[2]->GetPosition(), before);
        b2DistanceJointDef def;
        def.Initialize(boxes[1], boxes[2], boxes[1]->GetPosition(), boxes[2]->GetPosition());
        EXPECT_EQ(world.CreateJoint(&def), nullptr);
    };
    listener.onFixture = [&](b2Fixture* dying) {
        EXPECT_EQ(dying->GetBody()->CreateFixture(fixture->GetShape(), 1.0f), nullptr);
    };
    world.DestroyBody(boxes[1]);
    ExpectSound(2, 1);
}

TEST_F(Endings, LeavesAContactOutOfTheListsOnceItsEndIsTold) {
    listener.onEnd = [&](b2Contact* ended) {
        int count = 0;
        bool isListed = false;
        for (b2Contact* c = world.GetContactList(); c; c = c->GetNext()) {
            ++count;
            isListed = isListed || c == ended;
        }
        EXPECT_TRUE(isListed);
        EXPECT_EQ(count, 3 - listener.ends);
        EXPECT_EQ(world.GetContactCount(), count);
    };
    world.DestroyBody(boxes[1]);
    EXPECT_EQ(listener.ends, 2);
    ExpectSound(2, 1);
}

TEST_F(Endings, GearsAndTheirJointsMayBeDestroyedInTheirGoodbyes) {
    b2RevoluteJointDef hinge;
    hinge.Initialize(boxes[0], boxes[1], b2Vec2(0.0f, 0.5f));
    b2Joint* first = world.CreateJoint(&hinge);
    hinge.Initialize(boxes[1], boxes[2], b2Vec2(0.0f, 1.5f));
    b2Joint* second = world.CreateJoint(&hinge);
    b2GearJointDef gear;
    gear.joint1 = first;
    gear.joint2 = second;
    gear.bodyA = boxes[0];
    gear.bodyB = boxes[2];
    ASSERT_NE(world.CreateJoint(&gear), nullptr);
    listener.onJoint = [&](b2Joint* joint) {
        if (joint->GetType() == e_gearJoint) world.DestroyJoint(first);
    };
    world.DestroyJoint(first);
    ExpectSound(3, 2);
}

}  // namespace
