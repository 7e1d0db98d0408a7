// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A listener changes nothing by listening: the same bits, the same calls with any number of workers, and only those
// functions are called that its class has replaced.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "base/compiler.h"
#include "tests/world/fixtures.h"
#include "world/world_state.h"

namespace scree {
namespace {

using test::AddBody;
using test::AddBox;
using test::AddCircle;
using test::AddGround;

/// Boxes, disks and capsules that fall into a bin, with a sensor across it.
struct Heap {
    Heap(int count, unsigned seed, int workers) : world(Define(workers)) {
        world.GetState().pool->ShareAlways();
        AddGround(world);
        for (const float x : {-4.5f, 4.5f}) AddBox(AddBody(world, staticBody, {x, 10.0f}), 0.5f, 10.0f);
        FixtureDef sensor;
        PolygonShape across;
        across.SetAsBox(4.0f, 0.5f, {0.0f, 2.0f}, 0.0f);
        sensor.shape = &across;
        sensor.isSensor = true;
        AddBody(world, staticBody, {0.0f, 0.0f})->CreateFixture(&sensor);
        std::mt19937 random(seed);
        for (int i = 0; i < count; ++i) {
            const float jitter = static_cast<float>(random() % 100) * 0.002f;
            const Vec2 place{static_cast<float>(i % 8) - 3.5f + jitter, 1.0f + 1.1f * static_cast<float>(i / 8)};
            Body* body = AddBody(world, dynamicBody, place);
            random() % 2 == 0 ? AddBox(body, 0.4f, 0.3f) : AddCircle(body, 0.4f);
        }
    }
    static WorldDef Define(int workers) {
        WorldDef def;
        def.workerCount = workers;
        return def;
    }
    void Step(int substeps) { test::StepWith(world, substeps); }

    World world;
};

/// Writes down every call, and compares old manifolds with those of the last step.
struct Log : ContactListener {
    void BeginContact(Contact* c) override { Write('b', c); }
    void EndContact(Contact* c) override {
        Write('e', c);
        last.erase(PairOf(c));
    }
    void PreSolve(Contact* c, const Manifold* old) override {
        Write('p', c);
        const auto before = last.find(PairOf(c));
        if (before == last.end()) return;
        const Manifold expected = before->second;
        last.erase(before);  // at a time of impact the contact may be told of again
        ++compared;
        ASSERT_EQ(old->pointCount, expected.pointCount);
        for (int i = 0; i < old->pointCount; ++i) {
            EXPECT_EQ(old->points[i].id.key, expected.points[i].id.key);
            EXPECT_EQ(old->points[i].localPoint, expected.points[i].localPoint);
            EXPECT_EQ(old->points[i].normalImpulse, expected.points[i].normalImpulse);
        }
    }
    void PostSolve(Contact* c, const ContactImpulse*) override { Write('s', c); }
    void Write(char what, Contact* c) {
        calls += what + std::to_string(c->GetFixtureA()->GetIndex()) + "-" +
                 std::to_string(c->GetFixtureB()->GetIndex()) + " ";
    }
    static std::pair<int, int> PairOf(Contact* c) {
        return {c->GetFixtureA()->GetIndex(), c->GetFixtureB()->GetIndex()};
    }
    /// After a step.
    void Remember(World& world) {
        last.clear();
        for (Contact* c = world.GetContactList(); c != nullptr; c = c->GetNext()) last[PairOf(c)] = c->GetManifold();
    }

    std::string calls;
    std::map<std::pair<int, int>, Manifold> last;  ///< by fixtures
    int compared = 0;
};

TEST(Listener, ChangesNoBitAndHearsTheSameFromAnyNumberOfWorkers) {
    for (const int substeps : {0, 4}) {
        for (const int count : {6, 200}) {
            Heap none(count, 3, 1), empty(count, 3, 1);
            ContactListener silent;
            empty.world.SetContactListener(&silent);
            std::vector<std::unique_ptr<Heap>> heaps;
            std::vector<Log> logs(3);
            for (size_t i = 0; i < logs.size(); ++i) {
                heaps.push_back(std::make_unique<Heap>(count, 3, static_cast<int>(i) + 1));
                heaps.back()->world.SetContactListener(&logs[i]);
            }
            for (int step = 0; step < 120; ++step) {
                none.Step(substeps);
                empty.Step(substeps);
                const uint64_t expected = inspect::GetStateHash(none.world);
                ASSERT_EQ(inspect::GetStateHash(empty.world), expected) << "step " << step;
                for (size_t i = 0; i < logs.size(); ++i) {
                    heaps[i]->Step(substeps);
                    logs[i].Remember(heaps[i]->world);
                    ASSERT_EQ(inspect::GetStateHash(heaps[i]->world), expected) << "step " << step;
                    ASSERT_EQ(logs[i].calls, logs[0].calls);
                }
            }
            EXPECT_GT(logs[0].compared, 100);
            for (const char what : {'b', 'e', 'p', 's'}) {
                if (what == 'e' && count < 100) continue;
                EXPECT_NE(logs[0].calls.find(what), std::string::npos) << what;
            }
        }
    }
}

int CountAwake(World& world) {
    int count = 0;
    for (Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
        count += body->GetType() == dynamicBody && body->IsAwake() ? 1 : 0;
    return count;
}

// Contacts that wake nobody are noted out of order where nobody listens.
TEST(Listener, SleepersWakeTheSameWithoutOne) {
    std::mt19937 random(std::random_device{}());
    int fellAsleep = 0, woke = 0;
    for (int round = 0; round < 6; ++round) {
        const unsigned seed = random();
        const int substeps = round % 2 == 0 ? 0 : 4, count = 8 + static_cast<int>(random() % 24);
        SCOPED_TRACE("seed " + std::to_string(seed) + ", " + std::to_string(count) + " bodies");
        Heap none(count, seed, 3), heard(count, seed, 1);
        ContactListener silent;
        heard.world.SetContactListener(&silent);
        // Islands do not spread over kinematic bodies: who touches this one wakes by the contact alone.
        Body* paddles[2] = {};
        for (const int i : {0, 1}) {
            paddles[i] = AddBody(i == 0 ? none.world : heard.world, kinematicBody, {3.0f, 0.8f});
            AddBox(paddles[i], 0.5f, 0.4f);
        }
        std::mt19937 throws(seed);
        int awake = count;
        for (int step = 0; step < 1500; ++step) {
            const float speed = step % 300 < 260 ? 0.0f : step % 600 < 300 ? -2.0f : 2.0f;
            for (Body* paddle : paddles) paddle->SetLinearVelocity({speed, 0.0f});
            // One falls on the others, and later one is made within them.
            if (step % 300 == 299) {
                const Vec2 place{static_cast<float>(throws() % 7) - 3.0f, step % 600 == 299 ? 15.0f : 1.0f};
                for (Heap* heap : {&none, &heard}) AddBox(AddBody(heap->world, dynamicBody, place), 0.4f, 0.4f);
            }
            none.Step(substeps);
            heard.Step(substeps);
            ASSERT_EQ(inspect::GetStateHash(none.world), inspect::GetStateHash(heard.world)) << "step " << step;
            const int now = CountAwake(none.world);
            fellAsleep += std::max(0, awake - now), woke += step % 300 == 299 ? 0 : std::max(0, now - awake);
            awake = now;
        }
    }
    EXPECT_GT(fellAsleep, 50);
    EXPECT_GT(woke, 10);
}

struct Begins : ContactListener {
    int count = 0;
    void BeginContact(Contact*) override { ++count; }
};
struct Ends : ContactListener {
    int count = 0;
    void EndContact(Contact*) override { ++count; }
};
struct PreSolves : ContactListener {
    int count = 0;
    void PreSolve(Contact*, const Manifold*) override { ++count; }
};
struct PostSolves : Begins {
    int count = 0;
    void PostSolve(Contact*, const ContactImpulse*) override { ++count; }
};

TEST(Listener, OnlyReplacedFunctionsAreCalled) {
#if defined(SCREE_HAS_PLAIN_VIRTUAL_TABLES)
    const auto isHeard = [](const ContactListener& listener, bool begin, bool end, bool preSolve, bool postSolve) {
        const HeardCalls heard = FindHeardCalls(listener);
        return heard.begin == begin && heard.end == end && heard.preSolve == preSolve && heard.postSolve == postSolve;
    };
    EXPECT_TRUE(isHeard(ContactListener(), false, false, false, false));
    EXPECT_TRUE(isHeard(Begins(), true, false, false, false));
    EXPECT_TRUE(isHeard(Ends(), false, true, false, false));
    EXPECT_TRUE(isHeard(PreSolves(), false, false, true, false));
    EXPECT_TRUE(isHeard(PostSolves(), true, false, false, true));
    EXPECT_TRUE(isHeard(Log(), true, true, true, true));
#endif
    const auto count = [](auto listener) {
        Heap heap(80, 5, 1);
        heap.world.SetContactListener(&listener);
        for (int step = 0; step < 60; ++step) heap.Step(0);
        return listener.count;
    };
    EXPECT_GT(count(Begins()), 0);
    EXPECT_GT(count(Ends()), 0);
    EXPECT_GT(count(PreSolves()), 0);
    EXPECT_GT(count(PostSolves()), 0);
}

/// What a callback does to contacts that come later in the same pass holds for them at once.
TEST(Listener, CallbacksChangeWhatComesLater) {
    struct Turns : ContactListener {
        void BeginContact(Contact* c) override {
            for (Fixture* f : {c->GetFixtureA(), c->GetFixtureB()}) {
                if (f->GetBody()->GetType() == dynamicBody && f->GetIndex() % 3 == 0) f->SetSensor(true);
            }
        }
        void PreSolve(Contact* c, const Manifold*) override {
            presolvedSensors += c->GetFixtureA()->IsSensor() || c->GetFixtureB()->IsSensor() ? 1 : 0;
        }
        int presolvedSensors = 0;
    } turns;
    Heap heap(120, 11, 1);
    heap.world.SetContactListener(&turns);
    for (int step = 0; step < 90; ++step) heap.Step(0);
    // The contact that turned them is told of its own pre-solve no more either.
    EXPECT_EQ(turns.presolvedSensors, 0);
}

struct TakesPoints : ContactListener {
    void PreSolve(Contact* contact, const Manifold*) override {
        Manifold manifold = contact->GetManifold();
        manifold.pointCount = 0;
        EXPECT_EQ(contact->SetManifold(manifold), ErrorCode::ok);
    }
};
struct Disables : ContactListener {
    void PreSolve(Contact* contact, const Manifold*) override { contact->SetEnabled(false); }
};
struct Hardens : ContactListener {
    void BeginContact(Contact* contact) override {
        for (Fixture* fixture : {contact->GetFixtureA(), contact->GetFixtureB()}) fixture->SetSensor(false);
        ++count;
    }
    int count = 0;
};

/// Pairs of boxes that overlap. The solid ones are on a ground, every other one.
void AddPairs(World& world, int pairs, bool areSensors) {
    AddBox(AddBody(world, staticBody, {0.0f, -0.5f}), 200.0f, 0.5f);
    for (int i = 0; i < 2 * pairs; ++i) {
        const Vec2 place{3.0f * static_cast<float>(i / 2) + 0.3f * static_cast<float>(i % 2),
                         !areSensors && i % 4 < 2 ? 0.4f : 5.0f};
        AddBox(AddBody(world, dynamicBody, place), 0.5f, 0.5f)->SetSensor(areSensors);
    }
}

void ExpectSameMotion(World& a, World& b) {
    for (Body *p = a.GetBodyList(), *q = b.GetBodyList(); p != nullptr; p = p->GetNext(), q = q->GetNext()) {
        EXPECT_EQ(p->GetPosition().x, q->GetPosition().x) << "body " << p->GetIndex();
        EXPECT_EQ(p->GetPosition().y, q->GetPosition().y) << "body " << p->GetIndex();
        EXPECT_EQ(p->GetAngle(), q->GetAngle()) << "body " << p->GetIndex();
    }
}

TEST(Listener, AContactWithoutPointsDoesNotPush) {
    for (const int substeps : test::solvers) {
        for (const int pairs : {1, 2, 40}) {
            SCOPED_TRACE(std::to_string(pairs) + " pairs, sub-steps " + std::to_string(substeps));
            TakesPoints takes;
            Disables disables;
            World a({0.0f, -10.0f}), b({0.0f, -10.0f});
            a.SetContactListener(&takes), b.SetContactListener(&disables);
            for (World* world : {&a, &b}) {
                world->SetContinuousPhysics(false);
                AddPairs(*world, pairs, false);
                for (int i = 0; i < 5; ++i) test::StepWith(*world, substeps);
            }
            ExpectSameMotion(a, b);
        }
    }
}

TEST(Listener, ASensorThatBecomesSolidInsideAStepPushesFromTheNextOneOn) {
    for (const int substeps : test::solvers) {
        for (const int pairs : {1, 2, 40}) {
            SCOPED_TRACE(std::to_string(pairs) + " pairs, sub-steps " + std::to_string(substeps));
            Hardens hardens;
            World a({0.0f, -10.0f}), b({0.0f, -10.0f});
            a.SetContactListener(&hardens);
            for (World* world : {&a, &b}) {
                AddPairs(*world, pairs, true);
                test::StepWith(*world, substeps);
            }
            EXPECT_GT(hardens.count, 0);
            ExpectSameMotion(a, b);
            test::StepWith(a, substeps), test::StepWith(b, substeps);
            EXPECT_NE(a.GetBodyList()->GetPosition().x, b.GetBodyList()->GetPosition().x);
        }
    }
}

}  // namespace
}  // namespace scree
