// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The same input gives the same bits: on repeat, and in every build and on every machine (golden values, which hold for
// release, debug and sanitizer builds alike; a deliberate change of the engine's arithmetic updates them).

#include <gtest/gtest.h>

#include <cinttypes>
#include <cstdio>
#include <map>

#include "scenes/catalog.h"
#include "scree/inspect.h"
#include "scree/scree.h"
#include "testbed/engines/engine_run.h"

namespace {

struct Case {
    const char* scene;
    int size;
    int steps;
    uint64_t hash;      ///< sequential impulses
    uint64_t softHash;  ///< soft step, 4 sub-steps
};

uint64_t HashAfter(const char* name, int size, int steps, const std::string& broadPhase = "auto", int substeps = 0,
                   int threads = 1) {
    const scenes::Scene scene = scenes::Build(name, size);
    testbed::RunSpec spec = testbed::MakeSpec("scree", testbed::likeBox2dPreset);
    spec.broadPhase = broadPhase;
    spec.threads = threads;
    if (substeps > 0) spec.solver = testbed::SoftStep{substeps};
    auto run = testbed::MakeRun(scene, spec);
    for (int i = 0; i < steps; ++i) run->Step();
    testbed::Snapshot snapshot;
    run->Capture(snapshot, {.fixtures = false, .contacts = false, .joints = false, .nodes = false});
    return snapshot.stateHash;
}

constexpr Case golden[] = {
    {"tiles", 30, 60, 0x09305017abf583e2, 0xbf1e3b62fdc337e0},
    {"falling-squares", 16, 200, 0x67d5532d5cea1d28, 0x7af4efd5080a9fcc},
    {"falling-circles", 16, 200, 0x4aecc2ed06cc57c2, 0x0edd4c7e1f2b92c7},
    {"tumbler", 100, 150, 0xcaf1ffb7890dfb43, 0x93580cc012de9398},
    {"add-pair-400", 400, 40, 0xfb85f5787237ff4c, 0x926921731ffc185f},
    {"mild-n2", 10, 60, 0xac76f4aa32dd68bb, 0x8289cfde11efa172},
    {"n2", 40, 60, 0xbb1efa84e0a384c9, 0xe5d2db3d1305b3bc},
    {"multi-fixture", 5, 60, 0x2586c8967129a7a0, 0x5e75a03200641f8b},
    {"mostly-static-single", 20, 60, 0x642b833134143ee0, 0xff16f15e2a0532e8},
    {"big-mobile", 5, 120, 0xaf812665a3e6aba7, 0x767df767730ffa46},
    {"mixed", 300, 100, 0x0b12a89b27ff7c4f, 0x25ab08daf7fa48e1},
    {"slow-explosion", 300, 100, 0x7ed2baff96f70b4f, 0x7ed2baff96f70b4f},
};

TEST(StateHash, RepeatsAndEqualsItsGoldenValue) {
    for (const Case& c : golden) {
        const uint64_t first = HashAfter(c.scene, c.size, c.steps);
        EXPECT_EQ(first, HashAfter(c.scene, c.size, c.steps)) << c.scene;
        char actual[32];
        std::snprintf(actual, sizeof actual, "0x%016" PRIx64, first);
        EXPECT_EQ(first, c.hash) << c.scene << ": now " << actual;
        const uint64_t soft = HashAfter(c.scene, c.size, c.steps, "auto", 4);
        EXPECT_EQ(soft, HashAfter(c.scene, c.size, c.steps, "auto", 4)) << c.scene;
        std::snprintf(actual, sizeof actual, "0x%016" PRIx64, soft);
        EXPECT_EQ(soft, c.softHash) << c.scene << ", soft: now " << actual;
    }
}

/// Round corners, whose masses come from angles, and steps whose sub-steps come from what the last one found.
uint64_t HashOfRoundShapes(bool withTolerance) {
    scree::World world(scree::Vec2{0.0f, -10.0f});
    scree::BodyDef groundDef;
    scree::EdgeShape edge;
    edge.SetTwoSided({-30.0f, 0.0f}, {30.0f, 0.0f});
    world.CreateBody(&groundDef)->CreateFixture(&edge, 0.0f);
    scree::Body* before = nullptr;
    for (int i = 0; i < 60; ++i) {
        const auto f = static_cast<float>(i);
        scree::BodyDef def;
        def.type = scree::dynamicBody;
        def.position = {1.3f * static_cast<float>(i % 10) - 6.0f, 1.0f + 1.4f * static_cast<float>(i / 10)};
        def.angle = 0.37f * f;
        scree::Body* body = world.CreateBody(&def);
        const scree::Vec2 corners[] = {
            {-0.3f - 0.002f * f, -0.2f}, {0.4f, -0.25f}, {0.35f, 0.2f + 0.001f * f}, {-0.1f, 0.33f}};
        const scree::ConvexShape shape = i % 3 == 0   ? scree::MakeRoundedPolygon(corners, 4, 0.05f + 0.001f * f)
                                         : i % 3 == 1 ? scree::MakeCapsule({-0.3f, 0.01f * f}, {0.3f, 0.0f}, 0.2f)
                                                      : scree::MakeEllipse(0.4f, 0.25f + 0.001f * f);
        body->CreateFixture(&shape, 1.0f);
        if (i % 6 == 1) {
            scree::RevoluteJointDef joint;
            joint.Initialize(before, body, body->GetPosition());
            world.CreateJoint(&joint);
        }
        before = body;
    }
    for (int step = 0; step < 120; ++step) {
        withTolerance ? world.Step(1.0f / 60.0f, scree::Tolerance{.overlap = 0.008f}) : world.Step(1.0f / 60.0f, 8, 3);
    }
    return scree::inspect::GetStateHash(world);
}

TEST(StateHash, OfRoundShapesAndOfATolerantStepEqualsItsGoldenValue) {
    constexpr uint64_t goldenRound[2] = {0x47235e5acd306d06, 0x1db5a72eb243a25a};
    for (const bool withTolerance : {false, true}) {
        const uint64_t hash = HashOfRoundShapes(withTolerance);
        EXPECT_EQ(hash, HashOfRoundShapes(withTolerance));
        char actual[32];
        std::snprintf(actual, sizeof actual, "0x%016" PRIx64, hash);
        EXPECT_EQ(hash, goldenRound[withTolerance ? 1 : 0]) << "tolerance " << withTolerance << ": now " << actual;
    }
}

TEST(StateHash, IsTheSameForAnyNumberOfThreads) {
    constexpr Case large[] = {{"falling-squares", 60, 150, 0, 0},
                              {"mixed", 1500, 60, 0, 0},
                              {"n2", 150, 10, 0, 0},
                              {"slow-explosion", 1000, 30, 0, 0},
                              {"tumbler", 400, 450, 0, 0}};
    for (const Case& c : large) {
        for (const int substeps : {0, 4}) {
            const uint64_t one = HashAfter(c.scene, c.size, c.steps, "auto", substeps);
            for (const int threads : {2, 3, 5}) {
                EXPECT_EQ(HashAfter(c.scene, c.size, c.steps, "auto", substeps, threads), one)
                    << c.scene << ", " << threads << " threads, sub-steps " << substeps;
            }
        }
    }
}

TEST(StateHash, TellsWorldsApart) {
    std::map<uint64_t, const char*> seen;
    for (const Case& c : golden) {
        const auto [it, isNew] = seen.try_emplace(HashAfter(c.scene, c.size, c.steps), c.scene);
        EXPECT_TRUE(isNew) << c.scene << " and " << it->second;
    }
    EXPECT_NE(HashAfter("tiles", 30, 60), HashAfter("tiles", 30, 61));
}

}  // namespace
