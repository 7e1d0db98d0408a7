// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What Box2D programs do inside callbacks and between steps from threads, and the lengths they give to a rope they wind
// in: as with Box2D 2.4.1.

#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <functional>
#include <thread>
#include <vector>

namespace {

b2Body* MakeBody(b2World& world, b2BodyType type, float x, float y, float hx = 0.5f, float hy = 0.5f) {
    b2BodyDef def;
    def.type = type;
    def.position.Set(x, y);
    b2PolygonShape box;
    box.SetAsBox(hx, hy);
    b2Body* body = world.CreateBody(&def);
    body->CreateFixture(&box, 1.0f);
    return body;
}

class Listener : public b2ContactListener {
public:
    void BeginContact(b2Contact* contact) override { Call(onBegin, contact); }
    void EndContact(b2Contact* contact) override { Call(onEnd, contact); }
    void PreSolve(b2Contact* contact, const b2Manifold*) override { Call(onPre, contact); }
    void PostSolve(b2Contact* contact, const b2ContactImpulse*) override { Call(onPost, contact); }
    std::function<void(b2Contact*)> onBegin, onEnd, onPre, onPost;
    int calls = 0;

private:
    void Call(const std::function<void(b2Contact*)>& function, b2Contact* contact) {
        if (!function) return;
        ++calls;
        function(contact);
    }
};

void Step(b2World& world) { world.Step(1.0f / 60.0f, 8, 3); }

TEST(CompatCallbacks, AListenerMayTakeItselfAway) {
    for (int which = 0; which < 3; ++which) {
        b2World world(b2Vec2(0.0f, -10.0f));
        MakeBody(world, b2_staticBody, 0.0f, 0.0f, 20.0f, 0.5f);
        for (int i = 0; i < 8; ++i) MakeBody(world, b2_dynamicBody, 2.0f * static_cast<float>(i) - 8.0f, 0.99f);
        Listener listener;
        const auto leave = [&](b2Contact*) { world.SetContactListener(nullptr); };
        (which == 0 ? listener.onBegin : which == 1 ? listener.onPre : listener.onPost) = leave;
        world.SetContactListener(&listener);
        Step(world);
        Step(world);
        EXPECT_EQ(listener.calls, 1);
    }
}

TEST(CompatCallbacks, AFilterSetInACallbackHoldsFromTheNextStepOn) {
    b2World world(b2Vec2(0.0f, -10.0f));
    MakeBody(world, b2_staticBody, 0.0f, 0.0f, 20.0f, 0.5f);
    b2Body* body = MakeBody(world, b2_dynamicBody, 0.0f, 0.99f);
    Listener listener;
    listener.onBegin = [&](b2Contact*) {
        b2Filter none;
        none.maskBits = 0;
        body->GetFixtureList()->SetFilterData(none);
        EXPECT_EQ(body->GetFixtureList()->GetFilterData().maskBits, 0);
    };
    world.SetContactListener(&listener);
    for (int i = 0; i < 60; ++i) Step(world);
    EXPECT_EQ(listener.calls, 1);
    EXPECT_LT(body->GetPosition().y, -2.0f);
}

TEST(CompatCallbacks, AContactThatEndsTouchesNoMore) {
    b2World world(b2Vec2(0.0f, 0.0f));
    MakeBody(world, b2_staticBody, 0.0f, 0.0f, 20.0f, 0.5f);
    b2Body* body = MakeBody(world, b2_dynamicBody, 0.0f, 0.99f);
    Listener listener;
    listener.onEnd = [&](b2Contact* contact) {
        EXPECT_FALSE(contact->IsTouching());
        EXPECT_EQ(contact->GetManifold()->pointCount, 0);
    };
    world.SetContactListener(&listener);
    Step(world);
    body->SetLinearVelocity(b2Vec2(0.0f, 30.0f));
    for (int i = 0; i < 5; ++i) Step(world);
    EXPECT_EQ(listener.calls, 1);
}

TEST(CompatJoints, LengthsAreClampedAsInBox2d) {
    b2World world(b2Vec2(0.0f, 0.0f));
    b2DistanceJointDef def;
    b2Body* a = MakeBody(world, b2_dynamicBody, 0.0f, 0.0f);
    b2Body* b = MakeBody(world, b2_dynamicBody, 3.0f, 0.0f);
    def.Initialize(a, b, a->GetPosition(), b->GetPosition());
    auto* joint = static_cast<b2DistanceJoint*>(world.CreateJoint(&def));
    EXPECT_EQ(joint->SetLength(-0.05f), b2_linearSlop);
    EXPECT_EQ(joint->SetMinLength(-1.0f), b2_linearSlop);
    EXPECT_EQ(joint->SetMaxLength(-1.0f), b2_linearSlop);
}

class Closest : public b2RayCastCallback {
public:
    float ReportFixture(b2Fixture*, const b2Vec2&, const b2Vec2&, float fraction) override {
        return nearest = fraction;
    }
    float nearest = 1.0f;
};

TEST(CompatQueries, ThreadsMayAskBetweenSteps) {
    b2World world(b2Vec2(0.0f, -10.0f));
    MakeBody(world, b2_staticBody, 0.0f, 0.0f, 30.0f, 0.5f);
    for (int i = 0; i < 60; ++i)
        MakeBody(world, b2_dynamicBody, static_cast<float>(i % 12) * 2.0f - 12.0f, 1.0f + static_cast<float>(i / 12),
                 0.3f, 0.3f);
    const auto ask = [&world](int first) {
        std::vector<float> found;
        for (int i = first; i < first + 200; ++i) {
            Closest closest;
            const float x = static_cast<float>(i % 25) - 12.0f;
            world.RayCast(&closest, b2Vec2(x, 9.0f), b2Vec2(x + 1.0f, -1.0f));
            found.push_back(closest.nearest);
        }
        return found;
    };
    for (int frame = 0; frame < 5; ++frame) {
        Step(world);
        std::vector<std::vector<float>> found(4);
        std::vector<std::thread> threads;
        for (int t = 0; t < 4; ++t) threads.emplace_back([&, t] { found[static_cast<size_t>(t)] = ask(7 * t); });
        for (std::thread& thread : threads) thread.join();
        for (int t = 0; t < 4; ++t) EXPECT_EQ(found[static_cast<size_t>(t)], ask(7 * t));
        EXPECT_FALSE(world.IsLocked());
    }
}

}  // namespace
