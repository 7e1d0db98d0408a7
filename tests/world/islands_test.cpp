// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Islands against union-find, those that may fall asleep against the search, the ballistic path against the island
// path, and no allocation in a warm step.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include "pipeline/find_islands.h"
#include "pipeline/parts/rouse.h"
#include "pipeline/parts/sleepy_islands.h"
#include "pipeline/solve_islands.h"
#include "pipeline/solve_soft.h"
#include "scree/snapshot.h"
#include "tests/world/allocation_counter.h"
#include "tests/world/fixtures.h"
#include "world/world_state.h"

namespace scree::test {
namespace {

int Root(std::vector<int>& parent, int i) {
    while (parent[static_cast<size_t>(i)] != i) i = parent[static_cast<size_t>(i)];
    return i;
}

TEST(Islands, ThePathOfIsolatedBodiesGivesTheBitsOfTheSolver) {
    for (const int substeps : {0, 4}) {
        WorldDef def;
        def.continuousPhysics = false;
        World apart(def), among(def);
        inspect::SetIsolatedPath(among, false);
        for (World* world : {&apart, &among}) {
            AddGround(*world, 20.0f);
            for (int i = 0; i < 60; ++i) {
                BodyDef body;
                body.type = i % 7 == 0 ? kinematicBody : dynamicBody;
                body.position = {static_cast<float>(i % 10) - 5.0f, 1.0f + 1.5f * static_cast<float>(i / 10)};
                body.linearVelocity = {0.3f * static_cast<float>(i % 5), 0.0f};
                body.angularVelocity = static_cast<float>(i % 3);
                body.linearDamping = 0.1f * static_cast<float>(i % 2);
                AddBox(world->CreateBody(&body), 0.3f, 0.2f);
            }
        }
        int isolated = 0, touching = 0;
        for (int step = 0; step < 300; ++step) {
            StepReport reports[2];
            for (const int which : {0, 1}) {
                World& world = which == 0 ? apart : among;
                reports[which] = StepWith(world, substeps);
            }
            ASSERT_EQ(inspect::GetStateHash(apart), inspect::GetStateHash(among)) << step << ", " << substeps;
            ASSERT_EQ(reports[0].awakeBodyCount, reports[1].awakeBodyCount);
            ASSERT_EQ(reports[1].isolatedBodyCount, 0);
            isolated += reports[0].isolatedBodyCount;
            touching += reports[0].touchingCount;
        }
        EXPECT_GT(isolated, 1000);
        EXPECT_GT(touching, 1000);
        EXPECT_LT(apart.GetReport().awakeBodyCount, 60);  // some fell asleep, alike
    }
}

TEST(Islands, EqualTheComponentsOfTheContactGraph) {
    EXPECT_TRUE(rc::check("islands = connected components over dynamic bodies", [] {
        World world({0.0f, -10.0f});
        AddGround(world, 20.0f);
        const int count = *rc::gen::inRange(1, 60);
        for (int i = 0; i < count; ++i) {
            Body* body = AddBody(world, dynamicBody,
                                 {static_cast<float>(*rc::gen::inRange(-100, 100)) * 0.1f,
                                  static_cast<float>(*rc::gen::inRange(2, 60)) * 0.1f});
            *rc::gen::arbitrary<bool>() ? AddBox(body, 0.4f, 0.4f) : AddCircle(body, 0.4f);
        }
        world.SetAllowSleeping(false);
        StepFor(world, *rc::gen::inRange(2, 40));
        WorldState& s = world.GetState();
        FindIslands(s.contacts, s.joints, *s.pool, s.bodies, s.islandScratch, s.islands);

        std::vector<int> parent(static_cast<size_t>(s.bodies.slots.Size()));
        std::iota(parent.begin(), parent.end(), 0);
        size_t pushing = 0;
        for (const ContactIndex c : s.contacts.Rows()) {
            if (!s.contacts.Has(c, ContactFlag::touching)) continue;
            ++pushing;
            const ContactPair& p = s.contacts.pair[c];
            if (s.bodies.type[p.bodyA] == staticBody || s.bodies.type[p.bodyB] == staticBody) continue;
            parent[static_cast<size_t>(Root(parent, ToInt(p.bodyA)))] = Root(parent, ToInt(p.bodyB));
        }
        RC_ASSERT(s.islands.contacts.size() == pushing);
        RC_ASSERT(s.islands.bodies.size() + s.islands.isolated.size() == static_cast<size_t>(count));
        std::vector<int> islandOf(parent.size(), -1);
        for (size_t i = 0; i < s.islands.islands.size(); ++i) {
            const Island& island = s.islands.islands[i];
            const int root = Root(parent, ToInt(s.islands.bodies[static_cast<size_t>(island.bodyBegin)]));
            for (int b = island.bodyBegin; b < island.bodyEnd; ++b) {
                const int body = ToInt(s.islands.bodies[static_cast<size_t>(b)]);
                RC_ASSERT(Root(parent, body) == root);
                islandOf[static_cast<size_t>(body)] = static_cast<int>(i);
            }
        }
        for (size_t body = 0; body < parent.size(); ++body) {
            if (islandOf[body] < 0) continue;
            RC_ASSERT(islandOf[static_cast<size_t>(Root(parent, static_cast<int>(body)))] == islandOf[body]);
        }
    }));
}

TEST(Islands, AreTheSameWhoeverListsTheContacts) {
    for (const unsigned seed : {1u, 2u, 3u}) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> place(-6.0f, 6.0f);
        World world({0.0f, -10.0f});
        AddGround(world, 20.0f);
        AddBox(AddBody(world, kinematicBody, {0.0f, 1.0f}), 4.0f, 0.5f);  // which very many contacts meet
        const int count = 900 + static_cast<int>(random() % 600);
        for (int i = 0; i < count; ++i) {
            Body* body = AddBody(world, dynamicBody, {place(random), 7.0f + place(random)});
            i % 2 == 0 ? AddBox(body, 0.3f, 0.3f) : AddCircle(body, 0.3f);
        }
        world.SetAllowSleeping(false);
        StepFor(world, 3);
        WorldState& s = world.GetState();
        FindIslands(s.contacts, s.joints, *s.pool, s.bodies, s.islandScratch, s.islands);
        ASSERT_GT(s.islands.contacts.size(), 2000u);
        for (const int workers : {4, 8}) {
            TaskPool pool(workers, {});
            pool.Begin();
            IslandScratch scratch;
            IslandTable shared;
            FindIslands(s.contacts, s.joints, pool, s.bodies, scratch, shared);
            pool.End();
            EXPECT_EQ(shared.bodies, s.islands.bodies) << seed;
            EXPECT_EQ(shared.contacts, s.islands.contacts) << seed;
            EXPECT_EQ(shared.isolated, s.islands.isolated) << seed;
            EXPECT_EQ(shared.islands.size(), s.islands.islands.size()) << seed;
        }
    }
}

/// Steps two equal worlds by one solver's stage, once with the bodies listed as isolated, once as islands of one.
template <typename Solve>
void CompareBallisticPath(Solve&& solve, int substeps, bool exactDrift) {
    WorldDef def;
    def.maxTranslation = maxTranslation;
    World ballistic(def), island(def);
    for (World* world : {&ballistic, &island}) {
        for (int i = 0; i < 50; ++i) {
            Body* body = AddBody(*world, i % 7 == 0 ? kinematicBody : dynamicBody,
                                 {3.0f * static_cast<float>(i), 1.0f / static_cast<float>(i + 1)});
            AddBox(body, 0.3f, 0.4f);
            body->SetLinearVelocity({0.1f * static_cast<float>(i), 7.0f - static_cast<float>(3 * i)});
            body->SetAngularVelocity(0.37f * static_cast<float>(i));
            body->SetLinearDamping(0.01f * static_cast<float>(i % 5));
        }
    }
    StepFor(ballistic, 1);
    EXPECT_EQ(ballistic.GetReport().isolatedBodyCount, 50);
    StepFor(island, 1);
    for (int step = 0; step < 30; ++step) {
        WorldState& a = ballistic.GetState();
        WorldState& b = island.GetState();
        const KernelSet kernels = ChooseKernels(Features::All());
        for (WorldState* s : {&a, &b}) {
            s->bodies.EnsureForces();
            s->bodies.startVelocity.resize(s->bodies.velocity.size());
        }
        const SolverSettings settings{.dt = 1.0f / 60.0f,
                                      .impulseScale = 1.0f,
                                      .velocityIterations = 8,
                                      .positionIterations = 3,
                                      .substeps = substeps,
                                      .gravity = {0.0f, -10.0f},
                                      .maxTranslation = maxTranslation,
                                      .maxRotation = maxRotation,
                                      .kernels = kernels,
                                      .allowSleep = true,
                                      .exactDrift = exactDrift,
                                      .contactHertz = 30.0f,
                                      .contactDampingRatio = 10.0f,
                                      .contactPushSpeed = 1.0f};
        IslandTable isolated, single;
        for (const BodyIndex body : a.bodies.movers) isolated.isolated.push_back(body);
        for (const BodyIndex body : b.bodies.movers) {
            const int at = static_cast<int>(single.bodies.size());
            single.bodies.push_back(body);
            single.islands.push_back({at, at + 1, 0, 0, 0, 0});
        }
        solve(settings, a.fixtures, isolated, a.Events(), {*a.pool, a.bodies, a.contacts, a.joints}, a.solverScratch);
        solve(settings, b.fixtures, single, b.Events(), {*b.pool, b.bodies, b.contacts, b.joints}, b.solverScratch);
        ASSERT_EQ(inspect::GetStateHash(ballistic), inspect::GetStateHash(island));
    }
}

TEST(Islands, TheBallisticPathGivesTheBitsOfTheIslandPath) {
    CompareBallisticPath(SolveIslands, 0, false);
    CompareBallisticPath(SolveIslands, 0, true);
    CompareBallisticPath(SolveSoft, 4, true);
}

constexpr int withTolerance = -1;

long CountAllocations(World& world, int substeps, int warmUp) {
    const auto stepFor = [&](int steps) {
        for (int i = 0; i < steps; ++i) {
            if (substeps > 0) {
                world.Step(1.0f / 60.0f, substeps);
            } else if (substeps == withTolerance) {
                world.Step(1.0f / 60.0f, Tolerance{.overlap = 0.008f});
            } else {
                world.Step(1.0f / 60.0f, 8, 3);
            }
        }
    };
    stepFor(warmUp);
    const long before = AllocationCount();
    stepFor(60);
    return AllocationCount() - before;
}

/// Two share a step where that pays, so that times decide; or always.
struct Workers {
    int count;
    bool shareAlways;

    friend std::ostream& operator<<(std::ostream& out, const Workers& w) {
        return out << w.count << (w.shareAlways ? ", who always share" : "");
    }
};
constexpr Workers anyWorkers[] = {{1, false}, {2, false}, {2, true}, {3, true}};

/// In which nothing sleeps.
std::unique_ptr<World> MakeAwakeWorld(Workers workers) {
    WorldDef def;
    def.gravity = {0.0f, -10.0f};
    def.allowSleep = false;
    def.workerCount = workers.count;
    auto world = std::make_unique<World>(def);
    if (workers.shareAlways) world->GetState().pool->ShareAlways();
    return world;
}

/// Allocations of 60 steps of settled stacks beside isolated bodies, after 240 steps.
long CountWarmAllocations(int substeps, Workers workers) {
    const std::unique_ptr<World> made = MakeAwakeWorld(workers);
    World& world = *made;
    AddGround(world);
    for (int i = 0; i < 15; ++i) {
        for (int j = 0; j < 20; ++j) {
            Body* body =
                AddBody(world, dynamicBody, {static_cast<float>(i) * 1.05f, 0.5f + static_cast<float>(j) * 1.05f});
            AddBox(body, 0.5f, 0.5f);
        }
        Body* lone = AddBody(world, dynamicBody, {static_cast<float>(i) * 3.0f, 100.0f});
        lone->SetGravityScale(0.0f);
        AddBox(lone, 0.5f, 0.5f);
    }
    return CountAllocations(world, substeps, 240);
}

/// Disks and boxes that bounce about between walls: they meet, part, leave their neighbourhoods and hit static
/// fixtures, some of them as bullets.
std::unique_ptr<World> MakeBouncingWorld(Workers workers) {
    WorldDef def;
    def.gravity = {0.0f, -60.0f};
    def.workerCount = workers.count;
    auto made = std::make_unique<World>(def);
    World& world = *made;
    if (workers.shareAlways) world.GetState().pool->ShareAlways();
    EdgeShape wall;
    Body* walls = AddBody(world, staticBody, {0.0f, 0.0f});
    const Vec2 corners[4] = {{-12.0f, -12.0f}, {12.0f, -12.0f}, {12.0f, 12.0f}, {-12.0f, 12.0f}};
    for (int i = 0; i < 4; ++i) {
        wall.SetTwoSided(corners[i], corners[(i + 1) % 4]);
        FixtureDef fixture;
        fixture.shape = &wall;
        fixture.restitution = 1.0f;
        walls->CreateFixture(&fixture);
    }
    CircleShape disk;
    disk.m_radius = 0.2f;
    PolygonShape box;
    box.SetAsBox(0.2f, 0.2f);
    for (int i = 0; i < 300; ++i) {
        BodyDef body;
        body.type = dynamicBody;
        body.bullet = i % 100 == 0;
        body.position = {static_cast<float>(i % 20) - 9.5f, static_cast<float>(i / 20) - 7.0f};
        body.linearVelocity = {static_cast<float>(i * 7 % 11) - 5.0f, static_cast<float>(i * 5 % 13) - 6.0f};
        FixtureDef fixture;
        fixture.shape = i % 3 == 0 ? static_cast<const Shape*>(&box) : &disk;
        fixture.density = 1.0f;
        fixture.friction = 0.0f;
        fixture.restitution = 1.0f;
        world.CreateBody(&body)->CreateFixture(&fixture);
    }
    return made;
}

/// Of steps in which they bounce. Before that all lay in a heap, which has more contacts than they will have.
long CountBouncingAllocations(int substeps, Workers workers) {
    const std::unique_ptr<World> made = MakeBouncingWorld(workers);
    World& world = *made;
    CountAllocations(world, substeps, 200);
    world.SetGravity({0.0f, 0.0f});
    int i = 0;
    for (Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext(), ++i) {
        if (body->GetType() != dynamicBody) continue;
        body->SetTransform({static_cast<float>(i % 20) - 9.5f, static_cast<float>(i / 20) - 7.0f}, 0.0f);
        body->SetLinearVelocity({static_cast<float>(i * 7 % 11) - 5.0f, static_cast<float>(i * 5 % 13) - 6.0f});
    }
    return CountAllocations(world, substeps, 300);
}

/// Chance decides who finds how much, and now and then one worker finds all.
TEST(Step, EachWorkerHasRoomForAllThatWorkersFind) {
    for (const Workers& workers : anyWorkers) {
        const std::unique_ptr<World> world = MakeBouncingWorld(workers);
        size_t most = 0;
        for (int i = 0; i < 60; ++i) {
            world->Step(1.0f / 60.0f, 8, 3);
            const std::vector<ScreenedCandidates>& rows = world->GetState().continuousScratch.ofWorkers;
            ASSERT_GE(rows.size(), ToSize(workers.count));
            size_t kept = 0;
            for (const ScreenedCandidates& found : rows) kept += found.kept.size();
            most = std::max(most, kept);
            if (!workers.shareAlways) continue;  // the caller may find all of it
            for (const ScreenedCandidates& found : rows) {
                ASSERT_GE(found.kept.capacity(), kept) << workers;
                ASSERT_EQ(found.ofBody.capacity(), rows.front().ofBody.capacity()) << workers;
            }
        }
        EXPECT_GT(most, 20u) << workers;
    }
}

TEST(Step, AWarmStepOfMovingBodiesAllocatesNothing) {
    for (const Workers& workers : anyWorkers) {
        EXPECT_EQ(CountBouncingAllocations(0, workers), 0) << "sequential impulses, workers " << workers;
        EXPECT_EQ(CountBouncingAllocations(4, workers), 0) << "soft step, workers " << workers;
        EXPECT_EQ(CountBouncingAllocations(withTolerance, workers), 0) << "with a tolerance, workers " << workers;
    }
}

/// So many that workers share the search for pairs. They part, so that fewer are found in each step.
long CountPartingAllocations(Workers workers) {
    const std::unique_ptr<World> world = MakeAwakeWorld(workers);
    world->SetGravity({0.0f, 0.0f});
    std::mt19937 random(5);
    std::uniform_real_distribution<float> place(-20.0f, 20.0f), speed(-1.0f, 1.0f);
    for (int i = 0; i < 4000; ++i) {
        Body* const body = AddBody(*world, dynamicBody, {place(random), place(random)});
        body->SetLinearVelocity(0.5f * body->GetPosition() + Vec2{speed(random), speed(random)});
        CircleShape disk;
        disk.m_radius = 0.3f;
        body->CreateFixture(&disk, 1.0f)->SetFilterData({.categoryBits = 1, .maskBits = 0, .groupIndex = 0});
    }
    return CountAllocations(*world, 0, 60);
}

TEST(Step, AWarmStepOfManyBodiesAllocatesNothing) {
    for (const Workers& workers : anyWorkers) EXPECT_EQ(CountPartingAllocations(workers), 0) << "workers " << workers;
}

TEST(Step, AWarmStepAllocatesNothing) {
    for (const Workers& workers : anyWorkers) {
        EXPECT_EQ(CountWarmAllocations(0, workers), 0) << "sequential impulses, workers " << workers;
        EXPECT_EQ(CountWarmAllocations(4, workers), 0) << "soft step, workers " << workers;
        EXPECT_EQ(CountWarmAllocations(withTolerance, workers), 0) << "with a tolerance, workers " << workers;
    }
}

/// The same of chains of 5 to 94 links that swing: groves of unlike size, which any worker may get.
long CountSwingingAllocations(int substeps, Workers workers) {
    const std::unique_ptr<World> made = MakeAwakeWorld(workers);
    World& world = *made;
    Body* const ceiling = AddBody(world, staticBody, {0.0f, 0.0f});
    for (int chain = 0; chain < 40; ++chain) {
        const float x = 200.0f * static_cast<float>(chain);
        Body* last = ceiling;
        const int links = 5 + chain * 37 % 90;
        for (int link = 0; link < links; ++link) {
            const float at = x + static_cast<float>(link);
            Body* body = AddBody(world, dynamicBody, {at + 0.5f, 0.0f});
            AddBox(body, 0.5f, 0.1f);
            RevoluteJointDef joint;
            joint.Initialize(last, body, {at, 0.0f});
            world.CreateJoint(&joint);
            last = body;
        }
    }
    return CountAllocations(world, substeps, 10);
}

TEST(Step, AWarmStepOfJointsAllocatesNothing) {
    for (const Workers& workers : anyWorkers) {
        EXPECT_EQ(CountSwingingAllocations(0, workers), 0) << "sequential impulses, workers " << workers;
        EXPECT_EQ(CountSwingingAllocations(4, workers), 0) << "soft step, workers " << workers;
    }
}

/// Bodies of the islands, each in rising order.
std::set<std::vector<BodyIndex>> SetsOf(const IslandTable& table) {
    std::set<std::vector<BodyIndex>> sets;
    for (const Island& island : table.islands) {
        const auto bodies = Bodies(table, island);
        std::vector<BodyIndex> set(bodies.begin(), bodies.end());
        std::ranges::sort(set);
        sets.insert(set);
    }
    return sets;
}

/// The soft step wakes the bodies that Box2D's search wakes. Of the islands of that search it finds those where nobody
/// has moved of late.
TEST(Islands, ThatMayFallAsleepAreThoseOfTheSearch) {
    int sleepy = 0, woken = 0, awake = 0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        std::mt19937 random(seed);
        const auto draw = [&](float low, float high) {
            return std::uniform_real_distribution<float>(low, high)(random);
        };
        const auto oneIn = [&](unsigned count) { return random() % count == 0; };
        World world({0.0f, -10.0f});
        AddGround(world, 60.0f);
        std::vector<Body*> bodies;
        const int count = 40 + static_cast<int>(random() % 1200);
        const float width = draw(0.01f, 0.1f) * static_cast<float>(count);
        for (int i = 0; i < count; ++i) {
            const BodyType type = oneIn(30) ? kinematicBody : oneIn(25) ? staticBody : dynamicBody;
            bodies.push_back(AddBody(world, type, {draw(-width, width), draw(0.5f, 6.0f)}));
            Fixture* fixture = oneIn(2) ? AddBox(bodies.back(), 0.3f, 0.2f) : AddCircle(bodies.back(), 0.25f);
            fixture->SetSensor(oneIn(20));
            if (!oneIn(12) || i == 0) continue;
            RevoluteJointDef def;
            def.Initialize(bodies[random() % static_cast<unsigned>(i)], bodies.back(), bodies.back()->GetPosition());
            if (def.bodyA->GetType() != staticBody || type != staticBody) world.CreateJoint(&def);
        }
        StepFor(world, 2 + static_cast<int>(random() % 40));
        WorldState& s = world.GetState();
        const float dt = 1.0f / 60.0f;
        const bool areSomeDisabled = oneIn(2);
        const bool haveAllRested = oneIn(2);  // sleepers have left the lists, and a few are woken
        for (Body* body : bodies) {
            if (oneIn(4) || haveAllRested) body->SetAwake(false);
            if (areSomeDisabled && oneIn(40)) body->SetEnabled(false);
        }
        if (haveAllRested) {
            AddBox(AddBody(world, dynamicBody, {0.0f, 1000.0f}), 1.0f, 1.0f);  // or nothing would be done
            world.Step(dt, 4);
            for (Body* body : bodies) {
                if (oneIn(30)) body->SetAwake(true);
            }
        }
        const unsigned few = 1 + random() % 40;
        for (Body* body : bodies) {
            if (body->IsAwake() && body->GetType() != staticBody)
                s.bodies.sleepTime[IndexOf(*body)] = oneIn(few) ? draw(0.0f, timeToSleep) : timeToSleep;
        }
        const std::unique_ptr<World> other = LoadWorld(SaveWorld(world));
        ASSERT_NE(other, nullptr);
        WorldState& o = other->GetState();
        FindIslands(o.contacts, o.joints, *o.pool, o.bodies, o.islandScratch, o.islands);
        std::set<std::vector<BodyIndex>> expected = SetsOf(o.islands);
        std::erase_if(expected, [&](const std::vector<BodyIndex>& island) {
            return std::ranges::any_of(island,
                                       [&](BodyIndex body) { return o.bodies.sleepTime[body] + dt < timeToSleep; });
        });

        TaskPool pool(seed % 2 == 0 ? 4 : 1, {});
        pool.Begin();
        SleepyScratch scratch;
        IslandTable active, found;
        for (const Body* body : bodies) awake += body->IsAwake() ? 1 : 0;
        RouseContacts(s.bodies, s.contacts);
        WakeReached(s.contacts, s.joints, pool, s.bodies, scratch);
        RouseContacts(s.bodies, s.contacts);
        GatherActive(s.contacts, s.joints, pool, s.bodies, s.islandScratch, active);
        FindSleepyIslands(active, s.contacts, s.joints, pool, s.bodies, dt, scratch, found);
        pool.End();
        for (const Body* body : bodies) {
            const BodyIndex b = IndexOf(*body);
            EXPECT_EQ(s.bodies.IsActive(b), o.bodies.IsActive(b)) << seed << ' ' << ToInt(b);
            woken += body->IsAwake() ? 1 : 0;
        }
        EXPECT_EQ(SetsOf(found), expected) << seed;
        EXPECT_EQ(found.islands.size(), expected.size()) << seed;
        // In the order of their lowest bodies, whoever joined them.
        EXPECT_TRUE(std::ranges::is_sorted(
            found.islands, {}, [&](const Island& island) { return std::ranges::min(Bodies(found, island)); }));
        sleepy += static_cast<int>(expected.size());
    }
    EXPECT_GT(sleepy, 300);
    EXPECT_GT(woken - awake, 500);
}

}  // namespace
}  // namespace scree::test
