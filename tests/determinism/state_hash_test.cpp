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
#include "testbed/adapters/engine_run.h"

namespace {

struct Case {
    const char* scene;
    int size;
    int steps;
    uint64_t hash;      ///< sequential impulses
    uint64_t softHash;  ///< soft step, 4 sub-steps
};

uint64_t HashAfter(const char* name, int size, int steps, const std::string& broadPhase = "auto", int substeps = 0) {
    const scenes::Scene scene = scenes::Build(name, size);
    testbed::RunOptions options;
    options.broadPhase = broadPhase;
    options.substeps = substeps;
    auto run = testbed::MakeScreeRun(scene, options);
    for (int i = 0; i < steps; ++i) run->Step();
    testbed::Snapshot snapshot;
    run->Capture(snapshot, {.fixtures = false, .contacts = false, .joints = false, .nodes = false});
    return snapshot.stateHash;
}

constexpr Case golden[] = {
    {"tiles", 30, 60, 0x09305017abf583e2, 0},
    {"falling-squares", 16, 200, 0x1f5ba929a69a9c91, 0},
    {"falling-circles", 16, 200, 0x6d701177aa719716, 0},
    {"tumbler", 100, 150, 0x28ce5ed4668867c1, 0},
    {"add-pair-400", 400, 40, 0x180e752421cde11c, 0},
    {"mild-n2", 10, 60, 0x5183bdc45397c6fe, 0},
    {"n2", 40, 60, 0x45e785587c0676ca, 0},
    {"multi-fixture", 5, 60, 0x2586c8967129a7a0, 0},
    {"mostly-static-single", 20, 60, 0x642b833134143ee0, 0},
    {"big-mobile", 5, 120, 0xaf812665a3e6aba7, 0},
    {"mixed", 300, 100, 0xb34289746cf18e89, 0},
    {"slow-explosion", 300, 100, 0x7ed2baff96f70b4f, 0},
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

TEST(StateHash, TellsWorldsApart) {
    std::map<uint64_t, const char*> seen;
    for (const Case& c : golden) {
        const auto [it, isNew] = seen.try_emplace(HashAfter(c.scene, c.size, c.steps), c.scene);
        EXPECT_TRUE(isNew) << c.scene << " and " << it->second;
    }
    EXPECT_NE(HashAfter("tiles", 30, 60), HashAfter("tiles", 30, 61));
}

}  // namespace
