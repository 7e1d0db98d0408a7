// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a body can meet is never missing from what is kept for it. That is compared with a search for the time of impact
// with every static fixture. Ways are random among shapes of every kind, with edits in between. And worlds run alike
// with and without.

#include "pipeline/parts/near_statics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/reach.h"
#include "scree/convex_shape.h"
#include "scree/inspect.h"
#include "scree/time_of_impact.h"
#include "tests/geometry/source.h"
#include "tests/world/fixtures.h"
#include "world/world_state.h"

namespace scree::test {
namespace {

Fixture* AddSomething(Body* body, Source& random) {
    switch (random.Below(4)) {
        case 0:
            return AddCircle(body, random.Between(0.1f, 1.5f));
        case 1:
            return AddBox(body, random.Between(0.1f, 2.0f), random.Between(0.05f, 0.5f));
        case 2: {
            EdgeShape edge;
            edge.SetTwoSided(random.InSquare(2.0f), random.InSquare(2.0f) + Vec2{0.1f, 0.1f});
            return body->CreateFixture(&edge, 1.0f);
        }
        default: {
            const ConvexShape capsule = MakeCapsule({-0.4f, 0.0f}, {0.5f, 0.2f}, 0.2f);
            return body->CreateFixture(&capsule, 1.0f);
        }
    }
}

bool Meets(const WorldState& s, BodyIndex m, FixtureIndex fixture, FixtureIndex other) {
    TOIInput input;
    input.proxyA.Set(s.fixtures.shape[other], 0);
    input.proxyB.Set(s.fixtures.shape[fixture], 0);
    const BodyIndex still = s.fixtures.body[other];
    input.sweepA.localCenter = s.bodies.mass[still].localCenter;
    input.sweepA.c0 = input.sweepA.c = s.bodies.position[still].c;
    input.sweepA.a0 = input.sweepA.a = s.bodies.position[still].a;
    input.sweepB.localCenter = s.bodies.mass[m].localCenter;
    input.sweepB.c0 = s.bodies.startPosition[m].c, input.sweepB.c = s.bodies.position[m].c;
    input.sweepB.a0 = s.bodies.startPosition[m].a, input.sweepB.a = s.bodies.position[m].a;
    input.tMax = 1.0f;
    TOIOutput output;
    TimeOfImpact(&output, &input);
    return output.state != TOIOutput::e_separated;
}

TEST(NearStatics, MissNothingThatABodyMeets) {
    int known = 0, met = 0, empty = 0, left = 0, foundApart = 0;
    for (uint32_t seed = 0; seed < 40; ++seed) {
        Source random(seed);
        World world({0.0f, 0.0f});
        std::vector<Body*> statics;
        for (int i = 0; i < 25; ++i) {
            statics.push_back(AddBody(world, staticBody, random.InSquare(12.0f)));
            AddSomething(statics.back(), random);
        }
        Body* mover = AddBody(world, dynamicBody, {0.0f, 0.0f});
        for (int i = random.Below(3); i >= 0; --i) AddSomething(mover, random);
        WorldState& s = world.GetState();
        const BodyIndex m = IndexOf(*mover);
        for (int step = 0; step < 60; ++step) {
            if (random.Below(10) == 0) {
                ASSERT_EQ(statics[static_cast<size_t>(random.Below(25))]->SetTransform(random.InSquare(12.0f), 1.0f),
                          ErrorCode::ok);
            }
            if (random.Below(15) == 0) AddSomething(mover, random);
            if (random.Below(15) == 0 && mover->GetFixtureList()->GetNext() != nullptr) {
                ASSERT_EQ(mover->DestroyFixture(mover->GetFixtureList()), ErrorCode::ok);
            }
            if (random.Below(15) == 0) {
                MassData mass;
                mover->GetMassData(&mass);
                mass.mass += 1.0f, mass.I += 4.0f, mass.center = random.InSquare(0.5f);
                ASSERT_EQ(mover->SetMassData(&mass), ErrorCode::ok);
            }
            if (Body* body = statics[static_cast<size_t>(random.Below(25))]; random.Below(10) == 0) {
                // Static ones come and go in every way.
                const BodyType type = body->GetType() == staticBody ? dynamicBody : staticBody;
                switch (random.Below(3)) {
                    case 0:
                        ASSERT_EQ(body->SetType(type), ErrorCode::ok);
                        break;
                    case 1:
                        ASSERT_EQ(body->SetEnabled(!body->IsEnabled()), ErrorCode::ok);
                        break;
                    default:
                        ASSERT_EQ(body->DestroyFixture(body->GetFixtureList()), ErrorCode::ok);
                        AddSomething(body, random);
                        break;
                }
            }
            if (random.Below(20) == 0) {
                ASSERT_EQ(mover->SetTransform(random.InSquare(10.0f), random.Between(-3.0f, 3.0f)), ErrorCode::ok);
            }
            s.bodies.startPosition[m] = s.bodies.position[m];
            const float size = random.Below(4) == 0 ? 2.0f : 0.2f;
            s.bodies.position[m].c += random.InSquare(size);
            s.bodies.position[m].a += random.Between(-2.0f, 2.0f);
            s.bodies.UpdateTransform(m);
            const NearStatics::Tables tables{s.bodies, s.fixtures, *s.broadPhase, s.def.lengthScale};
            NearStatics& kept = s.continuousScratch.nearStatics;
            NearStatics copy = kept;
            if (random.Below(2) == 0) s.broadPhase->PrepareStatic();
            const auto apart = copy.FindApart(m, tables);
            const auto near = kept.Find(m, tables);
            if (apart) {
                ASSERT_TRUE(near.has_value() && std::ranges::equal(*apart, *near));
                ++foundApart;
            }
            if (!near) continue;
            ++known;
            float reach = 0.0f;
            for (const Fixture* f = mover->GetFixtureList(); f != nullptr; f = f->GetNext())
                reach = std::max(reach, Reach(*f->GetShape(), s.bodies.mass[m].localCenter));
            EXPECT_EQ(s.continuousScratch.nearStatics.GetReach(m), reach);
            empty += near->empty() ? 1 : 0;
            EXPECT_TRUE(std::is_sorted(near->begin(), near->end()));
            for (const Fixture* f = mover->GetFixtureList(); f != nullptr; f = f->GetNext()) {
                for (const Body* body : statics) {
                    if (body->GetType() != staticBody || !body->IsEnabled()) continue;
                    const Fixture* still = body->GetFixtureList();
                    const FixtureIndex other = IndexOf(*still);
                    const bool isKept = std::find(near->begin(), near->end(), other) != near->end();
                    if (!isKept && still->GetType() != Shape::e_convex) {
                        // Then the search without what is kept does not look at it either: no result can depend on it.
                        EXPECT_TRUE(WayIsClear(*still->GetShape(), body->GetTransform(), s.bodies.startPosition[m].c,
                                               s.bodies.position[m].c,
                                               Reach(*f->GetShape(), s.bodies.mass[m].localCenter)))
                            << "seed " << seed << " step " << step << " fixture " << ToInt(other);
                        ++left;
                    }
                    if (!Meets(s, m, IndexOf(*f), other)) continue;
                    ++met;
                    EXPECT_TRUE(isKept) << "seed " << seed << " step " << step << " fixture " << ToInt(other);
                }
            }
        }
    }
    EXPECT_GT(known, 1000);
    EXPECT_GT(foundApart, 1000);
    EXPECT_GT(met, 300);
    EXPECT_GT(empty, 100);
    EXPECT_GT(left, 1000);
}

/// What flies through empty space asks ever more seldom, and at once where something comes near.
TEST(NearStatics, AskSeldomInEmptySpace) {
    for (uint32_t seed = 0; seed < 20; ++seed) {
        Source random(seed);
        World world({0.0f, 0.0f});
        AddBox(AddBody(world, staticBody, {1000.0f, 0.0f}), 1.0f, 100.0f);
        Body* mover = AddBody(world, dynamicBody, {0.0f, 0.0f});
        AddCircle(mover, random.Between(0.05f, 0.5f));
        WorldState& s = world.GetState();
        NearStatics& near = s.continuousScratch.nearStatics;
        const BodyIndex m = IndexOf(*mover);
        const Vec2 way{random.Between(0.5f, 2.0f), random.Between(-0.01f, 0.01f)};
        int asked = 0, steps = 0;
        bool isMet = false;
        for (; s.bodies.position[m].c.x < 1003.0f; ++steps) {
            s.bodies.startPosition[m] = s.bodies.position[m];
            s.bodies.position[m].c += way;
            asked += near.Get(m, s.bodies) ? 0 : 1;
            const auto found = near.Find(m, {s.bodies, s.fixtures, *s.broadPhase, s.def.lengthScale});
            ASSERT_TRUE(found);
            isMet = isMet || !found->empty();
            if (s.bodies.position[m].c.x > 998.9f && s.bodies.startPosition[m].c.x < 1001.1f) {
                EXPECT_EQ(found->size(), 1u) << "seed " << seed << " step " << steps;
            }
        }
        EXPECT_TRUE(isMet);
        EXPECT_LT(asked, steps / 10) << "seed " << seed;
    }
}

/// Among the short segments of a chain a body keeps more of them, and gives the room back when it leaves.
TEST(NearStatics, KeepTheSegmentsOfAChain) {
    World world({0.0f, 0.0f});
    Body* ground = AddBody(world, staticBody, {0.0f, 0.0f});
    std::vector<Vec2> points;
    for (int i = 200; i >= -200; --i) points.push_back({0.1f * static_cast<float>(i), 0.0f});
    ChainShape chain;
    ASSERT_TRUE(chain.CreateChain(points.data(), static_cast<int>(points.size()), {21.0f, 0.0f}, {-21.0f, 0.0f}));
    ASSERT_NE(ground->CreateFixture(&chain, 0.0f), nullptr);
    Body* mover = AddBody(world, dynamicBody, {0.0f, 0.4f});
    CircleShape circle;
    circle.m_radius = 0.4f;
    ASSERT_NE(mover->CreateFixture(&circle, 1.0f), nullptr);
    WorldState& s = world.GetState();
    const BodyIndex m = IndexOf(*mover);
    NearStatics& near = s.continuousScratch.nearStatics;
    size_t bytes = 0;
    for (int round = 0; round < 200; ++round) {
        // On the chain, and far above it.
        for (const float height : {0.4f, 30.0f}) {
            ASSERT_EQ(mover->SetTransform({0.05f * static_cast<float>(round % 100), height}, 0.0f), ErrorCode::ok);
            s.bodies.startPosition[m] = s.bodies.position[m];
            const auto found = near.Find(m, {s.bodies, s.fixtures, *s.broadPhase, 1.0f});
            ASSERT_TRUE(found.has_value());
            EXPECT_TRUE(std::is_sorted(found->begin(), found->end()));
            EXPECT_EQ(found->empty(), height > 1.0f);
            EXPECT_TRUE(height > 1.0f || found->size() > 8);
        }
        if (round == 10) bytes = near.GetMemoryBytes();
        EXPECT_TRUE(round <= 10 || near.GetMemoryBytes() == bytes);
    }
}

TEST(NearStatics, KnowNothingWhileAProgramHoldsAShape) {
    World world({0.0f, 0.0f});
    AddGround(world);
    Body* body = AddBody(world, dynamicBody, {0.0f, 5.0f});
    Fixture* fixture = AddCircle(body, 0.5f);
    WorldState& s = world.GetState();
    const NearStatics::Tables tables{s.bodies, s.fixtures, *s.broadPhase, 1.0f};
    EXPECT_TRUE(s.continuousScratch.nearStatics.Find(IndexOf(*body), tables).has_value());
    ASSERT_NE(fixture->GetShape(), nullptr);
    EXPECT_FALSE(s.continuousScratch.nearStatics.Find(IndexOf(*body), tables).has_value());
}

TEST(NearStatics, KnowNothingFarFromTheOrigin) {
    World world({0.0f, 0.0f});
    Body* body = AddBody(world, dynamicBody, {1.0e6f, 5.0f});
    AddCircle(body, 0.5f);
    world.Step(1.0f / 60.0f, 8, 3);
    WorldState& s = world.GetState();
    ASSERT_TRUE(s.bodies.IsFar());
    const NearStatics::Tables tables{s.bodies, s.fixtures, *s.broadPhase, 1.0f};
    EXPECT_FALSE(s.continuousScratch.nearStatics.Find(IndexOf(*body), tables).has_value());
}

/// Falls and slides over slopes at speed. `hold` keeps what is near from being known.
uint64_t RunSlopes(bool hold, int& events) {
    World world({0.0f, -10.0f});
    Body* ground = AddGround(world);
    if (hold) {
        EXPECT_NE(ground->GetFixtureList()->GetShape(), nullptr);
    }
    for (int i = 0; i < 20; ++i) {
        Body* slope = AddBody(world, staticBody, {-20.0f + 2.0f * static_cast<float>(i), 4.0f + (i % 3)});
        AddBox(slope, 1.2f, 0.05f);
        EXPECT_EQ(slope->SetTransform(slope->GetPosition(), i % 2 == 0 ? 0.5f : -0.4f), ErrorCode::ok);
    }
    Source random(3);
    for (int i = 0; i < 120; ++i) {
        Body* body = AddBody(world, dynamicBody, {random.Between(-18.0f, 18.0f), random.Between(8.0f, 30.0f)});
        i % 2 == 0 ? AddCircle(body, 0.2f) : AddBox(body, 0.2f, 0.15f);
        body->SetLinearVelocity({random.Between(-10.0f, 10.0f), -40.0f});
    }
    events = 0;
    for (int step = 0; step < 200; ++step) events += world.Step(1.0f / 60.0f, 8, 3).continuousEventCount;
    return inspect::GetStateHash(world);
}

TEST(NearStatics, ChangeNoResult) {
    int with = 0, without = 0;
    EXPECT_EQ(RunSlopes(false, with), RunSlopes(true, without));
    EXPECT_EQ(with, without);
    EXPECT_GT(with, 100);
}

/// Turns a fixture into a sensor and back whenever it is asked, which makes what is near forgotten.
struct RestlessFilter : ContactFilter {
    Fixture* fixture = nullptr;
    int asked = 0;
    bool ShouldCollide(Fixture*, Fixture*) override {
        ++asked;
        EXPECT_EQ(fixture->SetSensor(!fixture->IsSensor()), ErrorCode::ok);
        return true;
    }
};

uint64_t RunRestless(bool hold, int& asked) {
    World world({0.0f, -10.0f});
    Body* ground = AddGround(world);
    if (hold) {
        EXPECT_NE(ground->GetFixtureList()->GetShape(), nullptr);
    }
    for (int i = 0; i < 6; ++i) AddBox(AddBody(world, staticBody, {0.3f * static_cast<float>(i), 1.0f}), 0.1f, 0.1f);
    RestlessFilter filter;
    filter.fixture = AddBox(AddBody(world, staticBody, {50.0f, 0.0f}), 0.1f, 0.1f);
    world.SetContactFilter(&filter);
    for (int i = 0; i < 10; ++i) {
        Body* body = AddBody(world, dynamicBody, {0.2f * static_cast<float>(i), 2.0f + 0.5f * static_cast<float>(i)});
        AddCircle(body, 0.15f);
        body->SetLinearVelocity({0.0f, -30.0f});
    }
    for (int step = 0; step < 60; ++step) world.Step(1.0f / 60.0f, 8, 3);
    asked = filter.asked;
    return inspect::GetStateHash(world);
}

/// Steps of seconds to months take bodies so far that what is kept and what is computed anew round in other ways.
TEST(NearStatics, ChangeNoResultOnTheLongestWays) {
    Source random(11);
    int hits = 0;
    for (int i = 0; i < 100 && !HasFailure(); ++i) {
        World knows(vec2Zero), forgets(vec2Zero);
        constexpr int walls = 8, count = 4 * walls;  // no more than a ball holds
        const float dt = std::exp(random.Between(0.0f, 16.0f));
        std::vector<Body*> bodies;
        std::vector<Vec2> velocities;
        for (int k = 0; k < count; ++k) {
            const Vec2 wall = random.InSquare(20.0f), at = random.InSquare(10.0f), velocity = random.InSquare(1000.0f);
            for (World* world : {&knows, &forgets}) {
                if (k < walls) AddBox(AddBody(*world, staticBody, wall), 3.0f, 0.2f);
                Body* body = AddBody(*world, dynamicBody, at);
                AddCircle(body, 0.2f);
                body->SetLinearVelocity(velocity);
                if (world == &knows) bodies.push_back(body), velocities.push_back(velocity);
            }
        }
        knows.Step(1e-6f, 4), forgets.Step(1e-6f, 4);
        forgets.TrimMemory();
        knows.Step(dt, 4), forgets.Step(dt, 4);
        ASSERT_EQ(inspect::GetStateHash(knows), inspect::GetStateHash(forgets)) << "world " << i << ", " << dt << " s";
        for (size_t k = 0; k < bodies.size(); ++k) hits += bodies[k]->GetLinearVelocity() == velocities[k] ? 0 : 1;
    }
    EXPECT_GT(hits, 500);
}

TEST(NearStatics, MayBeForgottenWhileAFilterIsAsked) {
    int with = 0, without = 0;
    EXPECT_EQ(RunRestless(false, with), RunRestless(true, without));
    EXPECT_EQ(with, without);
    EXPECT_GT(with, 20);
}

TEST(LeastDistance, IsNeverMoreThanTheDistance) {
    Source random(9);
    int close = 0;
    for (int i = 0; i < 20000; ++i) {
        World world({0.0f, 0.0f});
        Body* body = AddBody(world, staticBody, random.InSquare(1.0f));
        const Fixture* fixture = AddSomething(body, random);
        ASSERT_EQ(body->SetTransform(body->GetPosition(), random.Between(-3.0f, 3.0f)), ErrorCode::ok);
        const Vec2 p = random.InSquare(4.0f);
        DistanceInput input;
        CircleShape point;
        point.m_p = p;
        point.m_radius = 0.0f;
        input.proxyA.Set(fixture->GetShape(), 0);
        input.proxyB.Set(&point, 0);
        input.transformA = body->GetTransform();
        input.transformB.SetIdentity();
        input.useRadii = true;
        SimplexCache cache;
        cache.count = 0;
        DistanceOutput output;
        Distance(&output, &cache, &input);
        const float least = LeastDistance(*fixture->GetShape(), body->GetTransform(), p);
        EXPECT_LE(least, output.distance + 1e-5f);
        const bool exact = fixture->GetType() == Shape::e_circle || fixture->GetType() == Shape::e_edge;
        if (exact && output.distance > 0.0f) {
            EXPECT_NEAR(least, output.distance, 1e-5f);
        }
        close += least > 0.0f && least > 0.5f * output.distance ? 1 : 0;
    }
    EXPECT_GT(close, 5000);
}

}  // namespace
}  // namespace scree::test
