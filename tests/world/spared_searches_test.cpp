// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Continuous collision searches only where something may meet, and loses no event by that. In random scenes every pair
// that is spared a search is searched all the same, and none has an event. What rests is not searched for. Threads
// share the searches and change nothing.

#include <gtest/gtest.h>

#include <cmath>

#include "scree/convex_shape.h"
#include "scree/inspect.h"
#include "tests/geometry/source.h"
#include "tests/world/fixtures.h"
#include "world/world_state.h"

namespace scree::test {
namespace {

void AddSomething(Body* body, float size, Source& random) {
    switch (random.Below(5)) {
        case 0:
            AddCircle(body, size);
            break;
        case 1: {
            const ConvexShape capsule = MakeCapsule({-size, 0.0f}, {size, 0.3f * size}, 0.4f * size);
            body->CreateFixture(&capsule, 1.0f);
            break;
        }
        case 2: {
            PolygonShape shape;
            shape.SetAsBox(size, 0.2f * size, random.InSquare(size), random.Between(-3.0f, 3.0f));
            body->CreateFixture(&shape, 1.0f);
            AddCircle(body, 0.5f * size);
            break;
        }
        default:
            AddBox(body, size, random.Between(0.1f, 1.0f) * size);
    }
}

/// A pit of uneven ground, thin walls and blocks, moving platforms, and everything that may fall into it.
void BuildPit(World& world, Vec2 origin, Source& random) {
    Body* ground = AddBody(world, staticBody, origin);
    Vec2 from{-12.0f, 8.0f};
    for (int i = 0; i < 24; ++i) {
        const Vec2 to{-11.0f + static_cast<float>(i), random.Below(3) == 0 ? 0.0f : random.Between(-0.4f, 0.4f)};
        EdgeShape edge;
        edge.SetTwoSided(from, i == 23 ? Vec2{12.0f, 8.0f} : to);
        ground->CreateFixture(&edge, 0.0f);
        from = to;
    }
    for (int i = 0; i < 8; ++i) {
        Body* block =
            AddBody(world, staticBody, origin + Vec2{random.Between(-10.0f, 10.0f), random.Between(1.0f, 6.0f)});
        random.Below(2) == 0 ? AddBox(block, random.Between(0.2f, 2.0f), 0.01f) : AddCircle(block, 0.5f);
        ASSERT_EQ(block->SetTransform(block->GetPosition(), random.Between(-1.0f, 1.0f)), ErrorCode::ok);
    }
    for (int i = 0; i < 3; ++i) {
        Body* platform = AddBody(world, kinematicBody, origin + Vec2{-6.0f + 6.0f * static_cast<float>(i), 3.0f});
        AddBox(platform, 1.5f, 0.1f);
        platform->SetLinearVelocity({random.Between(-1.0f, 1.0f), random.Between(-0.5f, 0.5f)});
        if (i == 2) platform->SetAngularVelocity(1.0f);
    }
    for (int i = 0; i < 60; ++i) {
        Body* body =
            AddBody(world, dynamicBody, origin + Vec2{random.Between(-9.0f, 9.0f), random.Between(2.0f, 20.0f)},
                    random.Between(-3.0f, 3.0f));
        AddSomething(body, random.Between(0.1f, 0.5f), random);
        if (random.Below(4) == 0) body->SetLinearVelocity(random.InSquare(100.0f));
        if (random.Below(6) == 0) body->SetAngularVelocity(random.Between(-80.0f, 80.0f));
        body->SetBullet(random.Below(12) == 0);
    }
}

TEST(SparedSearches, LoseNoEvent) {
    ToiAudit sum;
    int events = 0;
    for (uint32_t seed = 0; seed < 16; ++seed) {
        Source random(seed);
        WorldDef def;
        def.gravity = {0.0f, random.Below(3) == 0 ? -100.0f : -10.0f};
        def.farDistance = seed % 4 == 3 ? 100.0f : def.farDistance;
        World world(def);
        BuildPit(world, seed % 4 >= 2 ? random.InSquare(1500.0f) : Vec2{0.0f, 0.0f}, random);
        WorldState& s = world.GetState();
        ToiAudit audit;
        s.continuousScratch.audit = &audit;
        const bool isSoft = seed % 2 == 1;
        for (int step = 0; step < 300; ++step) {
            const StepReport report = StepWith(world, isSoft ? 4 : 0);
            events += report.continuousEventCount;
            ASSERT_EQ(audit.missed, 0) << "seed " << seed << " step " << step;
        }
        sum.spared += audit.spared;
    }
    EXPECT_GT(sum.spared, 100000);
    EXPECT_GT(events, 3000);
}

/// Edges and triangles that begin at a pit and end up to a million kilometres away. Impacts there may be rounding
/// alone, but what one look passes over no other one may find.
TEST(SparedSearches, LoseNoEventOnWhatReachesFar) {
    ToiAudit sum;
    for (uint32_t seed = 0; seed < 24; ++seed) {
        Source random(seed);
        World world({0.0f, -10.0f});
        BuildPit(world, {0.0f, 0.0f}, random);
        Body* ground = AddBody(world, staticBody, {random.Between(-3.0f, 3.0f), 0.0f}, random.Between(-3.0f, 3.0f));
        for (int i = 0; i < 3; ++i) {
            const Vec2 near = random.InSquare(8.0f), far = near + random.Size(1e3f, 1e9f) * random.Direction();
            EdgeShape edge;
            edge.SetTwoSided(near, far);
            ground->CreateFixture(&edge, 0.0f);
            const Vec2 corners[] = {near, far, far + random.Size(1e3f, 1e9f) * random.Direction()};
            PolygonShape triangle;
            if (i == 0 && triangle.Set(corners, 3)) ground->CreateFixture(&triangle, 0.0f);
        }
        ToiAudit audit;
        world.GetState().continuousScratch.audit = &audit;
        for (int step = 0; step < 60; ++step) {
            StepWith(world, seed % 2 == 1 ? 4 : 0);
            ASSERT_EQ(audit.missed, 0) << "seed " << seed << " step " << step;
        }
        sum.spared += audit.spared;
    }
    EXPECT_GT(sum.spared, 10000);
}

/// Crates at rest: no search at all, with either solver.
TEST(SparedSearches, AreThoseOfWhatRests) {
    for (const bool isSoft : {false, true}) {
        World world({0.0f, -10.0f});
        world.SetAllowSleeping(false);
        AddGround(world, 1000.0f);
        for (int i = 0; i < 100; ++i) {
            AddBox(AddBody(world, dynamicBody, {2.0f * static_cast<float>(i) - 100.0f, 0.51f}), 0.5f, 0.5f);
        }
        for (int step = 0; step < 60; ++step) StepWith(world, isSoft ? 4 : 0);
        int searches = 0;
        for (int step = 0; step < 60; ++step) {
            StepWith(world, isSoft ? 4 : 0);
            searches += world.GetState().distanceWork.calls;
        }
        EXPECT_EQ(searches, 0) << (isSoft ? "soft" : "8/3");
    }
}

TEST(SparedSearches, OfOneBodyOnManyEdgesGrowWithTheirNumber) {
    // Each edge that the contacts hold asked for the times of all others once.
    constexpr int edges = 2000, steps = 4;
    for (const int substeps : {2, 4, 8}) {
        World world(Vec2{0.0f, -10.0f});
        Body* ground = AddBody(world, staticBody, {});
        for (int i = 0; i < edges; ++i) {
            const float x = 0.01f * static_cast<float>(i - edges / 2);
            EdgeShape edge;
            edge.SetTwoSided({x, 0.0f}, {x + 0.01f, 0.0f});
            ground->CreateFixture(&edge, 0.0f);
        }
        AddBox(AddBody(world, dynamicBody, {0.0f, 1.01f}), 0.005f * edges, 1.0f);
        int64_t searches = 0;
        for (int i = 0; i < steps; ++i) {
            world.Step(1.0f / 60.0f, substeps);
            searches += world.GetState().distanceWork.calls;
        }
        EXPECT_LT(searches, int64_t{20} * steps * edges) << substeps;
    }
}

/// Crates that slide and are shaken: still next to none.
TEST(SparedSearches, AreMostOfThoseOfWhatSlides) {
    for (const bool isSoft : {false, true}) {
        Source random(4);
        World world({0.0f, -10.0f});
        AddGround(world, 1000.0f);
        for (int i = 0; i < 100; ++i) {
            Body* crate = AddBody(world, dynamicBody, {8.0f * static_cast<float>(i) - 400.0f, 0.51f});
            AddBox(crate, 0.5f, 0.3f)->SetFriction(0.01f);
            crate->SetLinearVelocity({random.Between(-8.0f, 8.0f), 0.0f});
        }
        int searches = 0;
        for (int step = 0; step < 120; ++step) {
            StepWith(world, isSoft ? 4 : 0);
            if (step >= 30) searches += world.GetState().distanceWork.calls;
        }
        EXPECT_LT(searches, 90 * 100 / 50) << (isSoft ? "soft" : "8/3");
    }
}

uint64_t RunOn(int workers, bool isSoft, int& events) {
    WorldDef def;
    def.gravity = {0.0f, -10.0f};
    def.workerCount = workers;
    World world(def);
    Source random(11);
    for (int i = 0; i < 12; ++i) BuildPit(world, {40.0f * static_cast<float>(i), 0.0f}, random);
    for (int step = 0; step < 90; ++step) {
        events += StepWith(world, isSoft ? 4 : 0).continuousEventCount;
    }
    return inspect::GetStateHash(world);
}

TEST(SparedSearches, AndOthersAreSharedWithoutATrace) {
    for (const bool isSoft : {false, true}) {
        int events = 0;
        const uint64_t alone = RunOn(1, isSoft, events);
        EXPECT_GT(events, 300);
        for (const int workers : {2, 3, 8}) {
            int others = 0;
            EXPECT_EQ(RunOn(workers, isSoft, others), alone) << workers << " workers";
            EXPECT_EQ(others, events);
        }
    }
}

/// What a body was passed over for in an earlier step is no state: a world from an image goes on alike. Bullets hit
/// what has come to rest on uneven ground.
TEST(SparedSearches, LeaveNoTraceInWhatFallsAsleep) {
    int events = 0;
    for (uint32_t seed = 0; seed < 12; ++seed) {
        Source random(seed);
        World world({0.0f, -10.0f});
        BuildPit(world, {0.0f, 0.0f}, random);
        for (int step = 0; step < 400; ++step) world.Step(frame, 8, 3);
        for (int i = 0; i < 12; ++i) {
            Body* bullet = AddBody(world, dynamicBody, {random.Between(-9.0f, 9.0f), 12.0f});
            AddCircle(bullet, 0.1f);
            bullet->SetBullet(true);
            bullet->SetLinearVelocity({random.Between(-100.0f, 100.0f), -200.0f});
        }
        const auto again = LoadWorld(SaveWorld(world));
        ASSERT_NE(again, nullptr);
        for (int step = 0; step < 30; ++step) {
            events += world.Step(frame, 8, 3).continuousEventCount;
            again->Step(frame, 8, 3);
            ASSERT_EQ(inspect::GetStateHash(*again), inspect::GetStateHash(world))
                << "seed " << seed << " step " << step;
        }
    }
    EXPECT_GT(events, 200);
}

}  // namespace
}  // namespace scree::test
