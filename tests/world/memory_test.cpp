// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Memory: a creation that runs out of it changes nothing. The report of what is in use agrees with what was allocated.
// What past steps needed can be given back.

#include <gtest/gtest.h>

#include <new>

#include "tests/world/allocation_counter.h"
#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

/// Runs the creation with its first, second, … allocation failing, until it needs no more; the world must stay as it
/// was each time.
template <typename Create>
void ExpectWhole(World& world, Create create) {
    for (long allowed = 0;; ++allowed) {
        ASSERT_LT(allowed, 200);
        const uint64_t before = inspect::GetStateHash(world);
        const int bodies = world.GetBodyCount(), fixtures = world.GetFixtureCount(), joints = world.GetJointCount(),
                  proxies = world.GetProxyCount();
        bool failed = false;
        FailAllocation(allowed);
        try {
            create();
        } catch (const std::bad_alloc&) {
            failed = true;
        }
        FailAllocation(-1);
        if (!failed) return;
        EXPECT_EQ(inspect::GetStateHash(world), before) << allowed;
        EXPECT_EQ(world.GetBodyCount(), bodies);
        EXPECT_EQ(world.GetFixtureCount(), fixtures);
        EXPECT_EQ(world.GetJointCount(), joints);
        EXPECT_EQ(world.GetProxyCount(), proxies);
        ASSERT_NE(LoadWorld(SaveWorld(world)), nullptr) << allowed;
    }
}

TEST(Memory, ACreationThatRunsOutOfItChangesNothing) {
    for (size_t kind = 0; kind < broadPhaseNames.size(); ++kind) {
        WorldDef def;
        def.broadPhase = static_cast<BroadPhaseKind>(kind);
        World world(def), plain(def);
        std::vector<Body*> bodies, plainBodies;
        Vec2 points[] = {{-3.0f, -1.0f}, {-1.0f, -1.2f}, {2.0f, -1.0f}, {4.0f, -1.1f}};
        ChainShape chain;
        (void)chain.CreateChain(points, 4, {-4.0f, -1.0f}, {5.0f, -1.0f});
        for (int i = 0; i < 20; ++i) {
            BodyDef body;
            body.type = i % 4 == 0 ? staticBody : dynamicBody;
            body.position = {static_cast<float>(i), 0.1f * static_cast<float>(i)};
            ExpectWhole(world, [&] { bodies.push_back(nullptr), bodies.back() = world.CreateBody(&body); });
            std::erase(bodies, nullptr);
            plainBodies.push_back(plain.CreateBody(&body));
            PolygonShape box;
            box.SetAsBox(0.4f + 0.01f * static_cast<float>(i), 0.3f);
            ExpectWhole(world, [&] { bodies.back()->CreateFixture(&box, 1.0f); });
            plainBodies.back()->CreateFixture(&box, 1.0f);
            if (i % 5 == 0) {
                ExpectWhole(world, [&] { bodies.back()->CreateFixture(&chain, 0.0f); });
                plainBodies.back()->CreateFixture(&chain, 0.0f);
            }
            if (i < 2) continue;
            const auto join = [i](World& w, const std::vector<Body*>& all) {
                RevoluteJointDef joint;
                const auto at = static_cast<size_t>(i);
                joint.Initialize(all[at - 1], all[at], all[at]->GetPosition());
                w.CreateJoint(&joint);
            };
            ExpectWhole(world, [&] { join(world, bodies); });
            join(plain, plainBodies);
        }
        EXPECT_EQ(inspect::GetStateHash(world), inspect::GetStateHash(plain)) << broadPhaseNames[kind];
        StepFor(world, 30);
        StepFor(plain, 30);
        EXPECT_EQ(inspect::GetStateHash(world), inspect::GetStateHash(plain)) << broadPhaseNames[kind];
    }
}

size_t Sum(const inspect::MemoryUse& use) {
    return use.bodies + use.fixtures + use.contacts + use.joints + use.broadPhase + use.solverScratch;
}

/// What workers need is made for those that there are.
TEST(Memory, ASmallWorldTakesLittle) {
    for (const int substeps : {0, 4}) {
        const long before = AllocatedBytes();
        World world({0.0f, -10.0f});
        EXPECT_LT(AllocatedBytes() - before, 32 * 1024);
        AddGround(world);
        for (int i = 0; i < 10; ++i)
            AddBox(AddBody(world, dynamicBody, {1.1f * static_cast<float>(i), 0.6f}), 0.5f, 0.5f);
        for (int i = 0; i < 30; ++i) StepWith(world, substeps);
        EXPECT_LT(AllocatedBytes() - before, 128 * 1024);
    }
}

TEST(Memory, TheReportCountsWhatIsAllocatedAndTrimGivesItBack) {
    for (const int substeps : {0, 4}) {
        const long before = AllocatedBytes();
        World world({0.0f, -10.0f});
        std::vector<Body*> bodies;
        for (int i = 0; i < 300; ++i) {
            bodies.push_back(AddBody(world, dynamicBody, {0.0001f * static_cast<float>(i), 0.0f}));
            AddCircle(bodies.back(), 0.5f);
        }
        const auto step = [&] { StepWith(world, substeps); };
        step();
        const auto inUse = static_cast<double>(AllocatedBytes() - before);
        const auto reported = static_cast<double>(Sum(inspect::GetMemoryUse(world)));
        EXPECT_GT(inUse, 1.0e7);
        EXPECT_GT(reported, 0.9 * inUse);
        EXPECT_LT(reported, 1.02 * inUse);
        for (Body* body : bodies) world.DestroyBody(body);
        step();
        EXPECT_EQ(world.TrimMemory(), ErrorCode::ok);
        EXPECT_LT(static_cast<double>(AllocatedBytes() - before), 0.15 * inUse);
    }
}

/// Trimming in the middle of a run changes no bit of it.
TEST(Memory, TrimmingChangesNoResult) {
    for (const int substeps : {0, 4}) {
        World trimmed({0.0f, -10.0f}), plain({0.0f, -10.0f});
        for (World* world : {&trimmed, &plain}) {
            AddGround(*world, 20.0f);
            for (int i = 0; i < 40; ++i) {
                AddBox(
                    AddBody(*world, dynamicBody, {static_cast<float>(i % 8) * 1.1f, 1.0f + static_cast<float>(i / 8)}),
                    0.5f, 0.4f);
            }
        }
        for (int step = 0; step < 40; ++step) {
            for (World* world : {&trimmed, &plain}) {
                StepWith(*world, substeps);
                if (step == 10) world->DestroyBody(world->GetBodyList()->GetNext());
            }
            if (step % 5 == 0) {
                EXPECT_EQ(trimmed.TrimMemory(), ErrorCode::ok);
            }
        }
        EXPECT_EQ(inspect::GetStateHash(trimmed), inspect::GetStateHash(plain));
    }
}

}  // namespace
}  // namespace scree::test
