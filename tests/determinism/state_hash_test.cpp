// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The same input gives the same bits: on repeat, and in every build and on every machine. The golden values hold for
// release, debug and sanitizer builds alike. A deliberate change of the engine's arithmetic updates them.

#include <gtest/gtest.h>

#include <cinttypes>
#include <cstdio>
#include <map>

#include "scenes/catalog.h"
#include "scree/inspect.h"
#include "scree/scree.h"
#include "testbed/engines/engine_run.h"
#include "tests/determinism/golden_hashes.h"
#include "tests/determinism/round_shapes.h"

namespace {

using determinism::golden;
using determinism::GoldenHash;

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

TEST(StateHash, RepeatsAndEqualsItsGoldenValue) {
    for (const GoldenHash& c : golden) {
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

TEST(StateHash, OfRoundShapesAndOfATolerantStepEqualsItsGoldenValue) {
    for (const bool withTolerance : {false, true}) {
        const uint64_t hash = determinism::HashOfRoundShapes(withTolerance);
        EXPECT_EQ(hash, determinism::HashOfRoundShapes(withTolerance));
        char actual[32];
        std::snprintf(actual, sizeof actual, "0x%016" PRIx64, hash);
        EXPECT_EQ(hash, determinism::goldenRound[withTolerance ? 1 : 0])
            << "tolerance " << withTolerance << ": now " << actual;
    }
}

TEST(StateHash, IsTheSameForAnyNumberOfThreads) {
    constexpr GoldenHash large[] = {{"falling-squares", 60, 150, 0, 0},
                                    {"mixed", 1500, 60, 0, 0},
                                    {"n2", 150, 10, 0, 0},
                                    {"slow-explosion", 1000, 30, 0, 0},
                                    {"tumbler", 400, 450, 0, 0}};
    for (const GoldenHash& c : large) {
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
    for (const GoldenHash& c : golden) {
        const auto [it, isNew] = seen.try_emplace(HashAfter(c.scene, c.size, c.steps), c.scene);
        EXPECT_TRUE(isNew) << c.scene << " and " << it->second;
    }
    EXPECT_NE(HashAfter("tiles", 30, 60), HashAfter("tiles", 30, 61));
}

}  // namespace
