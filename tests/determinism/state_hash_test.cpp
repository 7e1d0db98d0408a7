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
    uint64_t hash;
};

uint64_t HashAfter(const char* name, int size, int steps, const std::string& broadPhase = "auto") {
    const scenes::Scene scene = scenes::Build(name, size);
    testbed::RunOptions options;
    options.broadPhase = broadPhase;
    auto run = testbed::MakeScreeRun(scene, options);
    for (int i = 0; i < steps; ++i) run->Step();
    testbed::Snapshot snapshot;
    run->Capture(snapshot, {.fixtures = false, .contacts = false, .joints = false, .nodes = false});
    return snapshot.stateHash;
}

constexpr Case golden[] = {
    {"tiles", 30, 60, 0x09305017abf583e2},
    {"falling-squares", 16, 200, 0x529d8cf0de4e0ccb},
    {"falling-circles", 16, 200, 0x85482ecc97772f78},
    {"tumbler", 100, 150, 0x51a6e034f961b7c5},
    {"add-pair-400", 400, 40, 0x5cceeb9b313c30f6},
    {"mild-n2", 10, 60, 0xcede55bac71f5cb9},
    {"n2", 40, 60, 0xd57cd06bed8d5f1f},
    {"multi-fixture", 5, 60, 0xf50db3001c5b5f6f},
    {"mostly-static-single", 20, 60, 0x5bce04f65da815b9},
    {"big-mobile", 5, 120, 0x7818d578b160ddfb},
    {"mixed", 300, 100, 0x35ea5e9d5ed9447d},
    {"slow-explosion", 300, 100, 0x7ed2baff96f70b4f},
};

TEST(StateHash, RepeatsAndEqualsItsGoldenValue) {
    for (const Case& c : golden) {
        const uint64_t first = HashAfter(c.scene, c.size, c.steps);
        EXPECT_EQ(first, HashAfter(c.scene, c.size, c.steps)) << c.scene;
        char actual[32];
        std::snprintf(actual, sizeof actual, "0x%016" PRIx64, first);
        EXPECT_EQ(first, c.hash) << c.scene << ": now " << actual;
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
