// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Runs by name: engines, and broad phases that follow another engine's motion.

#include <gtest/gtest.h>

#include <stdexcept>

#include "testbed/base/errors.h"
#include "testbed/engines/engine_run.h"
#include "testbed/engines/pair_count.h"
#include "tests/testbed/engines/run_checks.h"

using namespace testbed;

namespace {

Snapshot CaptureAfter(EngineRun& run, int steps) {
    for (int i = 0; i < steps; ++i) run.Step();
    Snapshot snapshot;
    run.Capture(snapshot);
    return snapshot;
}

}  // namespace

TEST(MakeRun, RefusesUnknownNames) {
    const scenes::Scene scene = scenes::Build("n2", 25);
    EXPECT_THROW(MakeRun(scene, {.engine = "bullet"}), UsageError);
    EXPECT_THROW(MakeFollower(scene, {}, {.engine = "bullet"}), UsageError);
    EXPECT_THROW(MakeFollower(scene, {.engine = "bullet"}, {}), UsageError);
    EXPECT_THROW(MakeRun(scene, {.broadPhase = "no-such-algorithm"}), std::invalid_argument);
    EXPECT_THROW(MakeRun(scene, {.engine = "box2d", .solver = SoftStep{}}), std::invalid_argument);
}

TEST(MakeRun, BothEnginesShowOneMotion) {
    for (const char* name : {"slow-explosion", "add-pair", "falling-squares", "tumbler", "mostly-static-single", "car",
                             "ray-cast-playground"}) {
        SCOPED_TRACE(name);
        const scenes::Scene scene = scenes::Build(name, checks::SmallSize(*scenes::Find(name)));
        for (const char* poses : {"scree", "box2d"}) {
            SCOPED_TRACE(poses);
            const RunSpec source = MakeSpec(poses, likeBox2dPreset);
            const Snapshot ours = CaptureAfter(*MakeFollower(scene, MakeSpec("scree", likeBox2dPreset), source), 30);
            const Snapshot theirs = CaptureAfter(*MakeFollower(scene, MakeSpec("box2d", likeBox2dPreset), source), 30);
            EXPECT_EQ(ours.engine, "scree");
            EXPECT_EQ(theirs.engine, "box2d");
            EXPECT_EQ(ours.stateHash, theirs.stateHash);
            checks::ExpectMatchesScene(ours, scene);
            checks::ExpectMatchesScene(theirs, scene);
            checks::ExpectTreeHoldsFixtures(ours);
            checks::ExpectTreeHoldsFixtures(theirs);
            // Ours reports what the tight boxes give, up to spawns that entered after the search.
            const int64_t truePairs = CountPairs(TightBoxes(theirs));
            EXPECT_GE(theirs.pairsReported, truePairs);
            if (scene.spawns.empty()) {
                EXPECT_EQ(ours.pairsReported, truePairs);
            }
        }
    }
}
