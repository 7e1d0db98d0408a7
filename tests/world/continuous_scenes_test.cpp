// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The continuous-collision benchmarks at small sizes beside Box2D 2.4.1, both with continuous collision on. Bodies do
// not overlap static fixtures deeper than in Box2D, nor leave the world in larger numbers.

#include <gtest/gtest.h>

#include <algorithm>

#include "scenes/catalog.h"
#include "testbed/engines/engine_run.h"

namespace {

struct Overlap {
    double worst = 0.0;  ///< deepest overlap of a moving with a static fixture, m
    long deep = 0;       ///< contact points deeper than 5 cm
    long points = 0;
};

Overlap Measure(testbed::EngineRun& run, int steps) {
    Overlap overlap;
    testbed::Snapshot s;
    for (int k = 0; k < steps; ++k) {
        run.Step();
        run.Capture(s, {.fixtures = true, .contacts = true, .joints = false, .nodes = false});
        const auto isStatic = [&](int fixture) {
            const int body = s.fixtures[static_cast<size_t>(fixture)].body;
            return s.bodies[static_cast<size_t>(body)].type == scenes::BodyType::isStatic;
        };
        for (const testbed::ContactState& c : s.contacts) {
            if (!c.touching || (!isStatic(c.fixtureA) && !isStatic(c.fixtureB))) continue;
            for (int i = 0; i < c.pointCount; ++i) {
                ++overlap.points;
                overlap.worst = std::max(overlap.worst, -static_cast<double>(c.separations[i]));
                if (c.separations[i] < -0.05f) ++overlap.deep;
            }
        }
    }
    return overlap;
}

TEST(ContinuousScenes, OverlapNoDeeperThanBox2d) {
    struct Case {
        const char* scene;
        int size, steps;
    };
    for (const Case& c : {Case{"mixed", 1500, 200}, Case{"diagonal", 10, 300}, Case{"falling-squares", 50, 350}}) {
        const scenes::Scene scene = scenes::Build(c.scene, c.size);
        testbed::RunSpec spec = testbed::MakeSpec("scree", testbed::likeBox2dPreset);
        const Overlap off = Measure(*testbed::MakeRun(scene, spec), c.steps);
        spec.continuous = true;
        const Overlap ours = Measure(*testbed::MakeRun(scene, spec), c.steps);
        const Overlap theirs = Measure(*testbed::MakeRun(scene, testbed::MakeSpec("box2d")), c.steps);
        EXPECT_GT(ours.points, 1000) << c.scene;
        EXPECT_LE(ours.deep, theirs.deep) << c.scene;
        // The two runs part after the first contacts; what remains comparable is the worst case, to a fifth.
        EXPECT_LE(ours.worst, 1.2 * theirs.worst) << c.scene << ": Box2D " << theirs.worst;
        EXPECT_GT(off.worst, ours.worst) << c.scene << ": without continuous collision the scene proves nothing";
    }
}

TEST(ContinuousScenes, ABulletBoxHitsTheCloudOfAddPair) {
    scenes::Scene scene = scenes::Build("add-pair", 300);
    scene.bodies.back().bullet = true;
    testbed::RunSpec spec = testbed::MakeSpec("scree", testbed::likeBox2dPreset);
    spec.continuous = true;
    const auto run = testbed::MakeRun(scene, spec);
    testbed::Snapshot s;
    for (int k = 0; k < 20; ++k) run->Step();
    run->Capture(s, {.fixtures = false, .contacts = false, .joints = false, .nodes = false});
    double pushed = 0.0;
    for (const testbed::BodyState& b : s.bodies) {
        if (!b.bullet) pushed = std::max(pushed, static_cast<double>(b.linearVelocity.x));
    }
    EXPECT_GT(pushed, 50.0);
}

}  // namespace
