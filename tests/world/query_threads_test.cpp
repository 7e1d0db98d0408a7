// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Queries, contacts and accessors from several threads between two steps: they find what one thread finds, and leave
// the world unlocked. Run under the thread sanitizer they must be silent.

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>
#include <vector>

#include "scree/inspect.h"
#include "scree/scree.h"

namespace scree::test {
namespace {

constexpr int threadCount = 4;

/// Boxes that fall onto a floor, and a count of edits between steps that leaves trees with edits or stale.
class Falling {
public:
    explicit Falling(BroadPhaseKind kind) : world(MakeDef(kind)) {
        BodyDef floor;
        EdgeShape edge;
        edge.SetTwoSided({-40.0f, 0.0f}, {40.0f, 0.0f});
        world.CreateBody(&floor)->CreateFixture(&edge, 0.0f);
        PolygonShape box;
        box.SetAsBox(0.3f, 0.2f);
        for (int i = 0; i < 150; ++i) {
            BodyDef def;
            def.type = i % 7 == 0 ? staticBody : dynamicBody;
            def.position = {static_cast<float>(i % 15) * 2.0f - 15.0f, 1.0f + static_cast<float>(i / 15)};
            bodies.push_back(world.CreateBody(&def));
            bodies.back()->CreateFixture(&box, 1.0f);
        }
    }
    static WorldDef MakeDef(BroadPhaseKind kind) {
        WorldDef def;
        def.broadPhase = kind;
        def.gravity = {0.0f, -10.0f};
        return def;
    }
    void Edit(int count) {
        for (int i = 0; i < count; ++i) {
            Body* body = bodies[static_cast<size_t>(i * 37) % bodies.size()];
            body->SetTransform(body->GetPosition() + Vec2{0.05f, 0.3f}, 0.1f * static_cast<float>(i));
        }
    }

    World world;
    std::vector<Body*> bodies;
};

/// What a thread's share of queries finds, as numbers.
std::vector<float> Ask(const World& world, int first) {
    std::vector<float> found;
    for (int i = first; i < first + 40; ++i) {
        const float x = static_cast<float>(i % 29) - 14.0f;
        const Vec2 from{x, 14.0f}, to{x + static_cast<float>(i % 5) - 2.0f, -1.0f};
        const auto hit = world.RayCastClosest(from, to);
        found.push_back(hit ? hit->fraction : -1.0f);
        std::vector<RayHit> hits;
        world.RayCastAll(from, to, hits);
        for (const RayHit& each : hits) found.push_back(each.fraction);
        float nearest = 2.0f;
        world.RayCast(from, to, [&](Fixture*, Vec2, Vec2, float fraction) {
            nearest = std::min(nearest, fraction);
            return fraction;
        });
        found.push_back(nearest);
        int count = 0;
        world.QueryAABB({{x, 1.0f}, {x + 3.0f, 4.0f}}, [&](Fixture*) { return ++count < 1000; });
        CircleShape disk;
        disk.m_radius = 0.7f;
        Transform xf;
        xf.Set({x, 3.0f}, 0.0f);
        world.OverlapShape(disk, xf, [&](Fixture*) { return ++count < 1000; });
        world.QueryPoint({x, 1.2f}, [&](Fixture*) { return ++count < 1000; });
        found.push_back(static_cast<float>(count));
        const auto met = world.ShapeCastClosest(disk, xf, {2.0f, -2.0f});
        found.push_back(met ? met->fraction : -1.0f);
    }
    return found;
}

/// What bodies, contacts and joints tell. The order of contacts and their ids belong to it.
std::vector<float> Read(World& world) {
    std::vector<float> found;
    const auto note = [&found](auto... values) { (found.push_back(static_cast<float>(values)), ...); };
    for (const Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
        note(body->GetPosition().y, body->GetAngle(), body->GetContactCount(), body->IsAwake());
        body->VisitContacts([&](Contact* contact) {
            WorldManifold manifold;
            contact->GetWorldManifold(&manifold);
            if (contact->IsTouching()) note(manifold.normal.y, manifold.separations[0]);
            note(contact->IsTouching(), contact->GetFriction(), contact->GetIndex());
            return contact->GetFixtureA()->GetBody() == body || contact->GetFixtureB()->GetBody() == body;
        });
        body->VisitJoints([&](Joint* joint) {
            note(joint->GetReactionForce(60.0f).y, joint->GetAnchorA().x);
            return true;
        });
        for (const Fixture* f = body->GetFixtureList(); f != nullptr; f = f->GetNext()) note(f->GetAABB().upperBound.y);
    }
    for (Contact* contact = world.GetContactList(); contact != nullptr; contact = contact->GetNext()) {
        const ContactId id = world.GetId(contact);
        note(id.index, id.generation, world.Find(id) == contact);
    }
    const StepErrors errors = world.MeasureErrors();
    note(errors.overlap, world.GetContactCount(), inspect::GetStateHash(world) % 1000);
    return found;
}

TEST(QueryThreads, ThreadsReadWhatOneReads) {
    for (const bool sleeps : {false, true}) {
        Falling falling(BroadPhaseKind::automatic);
        for (size_t i = 3; i < 9; i += 2) {
            RevoluteJointDef joint;
            joint.Initialize(falling.bodies[i], falling.bodies[i + 1], falling.bodies[i]->GetPosition());
            falling.world.CreateJoint(&joint);
        }
        for (int frame = 0; frame < 8; ++frame) {
            for (int i = 0; i < (sleeps ? 60 : 5); ++i) falling.world.Step(1.0f / 60.0f, 4);
            falling.Edit(frame % 3);
            // Nothing that is made on first use is there yet: the threads ask first.
            std::vector<std::vector<float>> found(threadCount);
            std::vector<std::thread> threads;
            for (int t = 0; t < threadCount; ++t) {
                threads.emplace_back([&, t] { found[static_cast<size_t>(t)] = Read(falling.world); });
            }
            for (std::thread& thread : threads) thread.join();
            for (const std::vector<float>& each : found) EXPECT_EQ(each, Read(falling.world));
            EXPECT_FALSE(falling.world.IsLocked());
        }
    }
}

TEST(QueryThreads, ThreadsFindWhatOneFindsAndTheWorldIsNotLockedAfterwards) {
    for (size_t kind = 0; kind < broadPhaseNames.size(); ++kind) {
        Falling falling(static_cast<BroadPhaseKind>(kind));
        for (int frame = 0; frame < 6; ++frame) {
            ASSERT_FALSE(falling.world.IsLocked());
            falling.world.Step(1.0f / 60.0f, 8, 3);
            constexpr int edits[] = {0, 3, 140};  // none, some beside the trees, so many that trees are stale
            falling.Edit(edits[frame % 3]);
            std::vector<std::vector<float>> found(threadCount);
            std::vector<std::thread> threads;
            for (int t = 0; t < threadCount; ++t) {
                threads.emplace_back([&, t] {
                    for (int repeat = 0; repeat < 5; ++repeat)
                        found[static_cast<size_t>(t)] = Ask(falling.world, 11 * t);
                });
            }
            for (std::thread& thread : threads) thread.join();
            for (int t = 0; t < threadCount; ++t) {
                EXPECT_EQ(found[static_cast<size_t>(t)], Ask(falling.world, 11 * t)) << broadPhaseNames[kind];
            }
            EXPECT_FALSE(falling.world.IsLocked());
        }
        BodyDef def;
        EXPECT_NE(falling.world.CreateBody(&def), nullptr);
    }
}

/// What a callback of one thread may not do stays refused while it runs, and is allowed again after it.
TEST(QueryThreads, TheWorldIsLockedWhileAQueryCallsTheProgram) {
    Falling falling(BroadPhaseKind::automatic);
    int calls = 0;
    falling.world.SetErrorHandler([](const Error&, void*) {}, nullptr);
    falling.world.QueryAABB({{-20.0f, 0.0f}, {20.0f, 20.0f}}, [&](Fixture* fixture) {
        EXPECT_TRUE(falling.world.IsLocked());
        EXPECT_EQ(fixture->GetBody()->SetTransform({0.0f, 0.0f}, 0.0f), ErrorCode::locked);
        return ++calls < 3;
    });
    EXPECT_EQ(calls, 3);
    EXPECT_EQ(falling.bodies[0]->SetTransform({0.0f, 9.0f}, 0.0f), ErrorCode::ok);
}

}  // namespace
}  // namespace scree::test
