// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Checks that hold for a scene running in any engine: counts, spawns, finite state, consistent indices, a tree that
// holds every fixture once and contains its box.

#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "scenes/catalog.h"
#include "scenes/outline.h"
#include "testbed/engines/engine_run.h"

namespace testbed::checks {

using Maker = std::function<std::unique_ptr<EngineRun>(const scenes::Scene&)>;

/// A size at which a scene loads and steps in milliseconds.
inline int SmallSize(const scenes::SceneInfo& info) {
    if (!info.hasSize) return info.defaultSize;
    return info.sweep ? info.sweep->begin : std::min(info.defaultSize, std::max(info.minSize, 10));
}

/// Bodies that exist after `step` steps.
inline int BodiesAfter(const scenes::Scene& scene, int step) {
    int count = scene.InitialBodyCount();
    for (const scenes::Spawn& s : scene.spawns) count += s.afterStep <= step;
    return count;
}

inline bool IsFinite(const BodyState& b) {
    return std::isfinite(b.position.x) && std::isfinite(b.position.y) && std::isfinite(b.angle) &&
           std::isfinite(b.linearVelocity.x) && std::isfinite(b.linearVelocity.y) && std::isfinite(b.angularVelocity);
}

inline bool Contains(const Box& outer, const Box& inner) {
    return outer.lower.x <= inner.lower.x && outer.lower.y <= inner.lower.y && outer.upper.x >= inner.upper.x &&
           outer.upper.y >= inner.upper.y;
}

/// The counts and indices of a full capture against the scene.
inline void ExpectMatchesScene(const Snapshot& s, const scenes::Scene& scene) {
    ASSERT_EQ(static_cast<int>(s.bodies.size()), BodiesAfter(scene, s.step));
    size_t fixtures = 0;
    for (size_t i = 0; i < s.bodies.size(); ++i) {
        for (const scenes::Fixture& f : scene.FixturesOf(static_cast<int>(i))) {
            fixtures += static_cast<size_t>(f.shape.ChildCount());
        }
        EXPECT_EQ(s.bodies[i].index, static_cast<int>(i));
        EXPECT_EQ(s.bodies[i].type, scene.bodies[i].type);
        EXPECT_TRUE(IsFinite(s.bodies[i])) << "body " << i;
    }
    ASSERT_EQ(s.fixtures.size(), fixtures);
    EXPECT_EQ(s.joints.size(), scene.joints.size());
    EXPECT_EQ(static_cast<int>(s.contacts.size()), s.contactCount);
    for (size_t i = 0; i < s.joints.size(); ++i) {
        EXPECT_EQ(s.joints[i].type, scene.joints[i].type);
        EXPECT_EQ(s.joints[i].bodyB, scene.joints[i].bodyB);
    }
    int touching = 0;
    for (const ContactState& c : s.contacts) {
        touching += c.touching;
        EXPECT_NE(s.fixtures[static_cast<size_t>(c.fixtureA)].body, s.fixtures[static_cast<size_t>(c.fixtureB)].body);
    }
    EXPECT_EQ(touching, s.touchingCount);
    for (const FixtureState& f : s.fixtures) {
        const scenes::Body& body = scene.bodies[static_cast<size_t>(f.body)];
        EXPECT_GE(f.fixture, body.firstFixture);
        EXPECT_LT(f.fixture, body.firstFixture + body.fixtureCount);
        const scenes::Shape& shape = scene.fixtures[static_cast<size_t>(f.fixture)].shape;
        ASSERT_GE(f.child, 0);
        ASSERT_LT(f.child, shape.ChildCount());
        // Box2D has polygons of 8 vertices in the place of shapes that it does not know.
        const bool isReplaced = s.engine == "box2d" && scenes::IsFurtherConvex(shape.type);
        EXPECT_EQ(f.shape, isReplaced ? scenes::PolygonInstead(scene, shape) : scenes::ChildOf(scene, shape, f.child));
        EXPECT_EQ(f.outline.empty(), isReplaced || !scenes::IsFurtherConvex(shape.type));
    }
}

/// Every fixture is one leaf, whose box contains the tight one.
inline void ExpectTreeHoldsFixtures(const Snapshot& s) {
    if (s.fixtures.empty()) return;
    ASSERT_EQ(s.nodes.size(), 2 * s.fixtures.size() - 1);
    std::vector<int> seen(s.fixtures.size(), 0);
    for (const NodeState& n : s.nodes) {
        if (n.fixture < 0) continue;
        ++seen[static_cast<size_t>(n.fixture)];
        const FixtureState& f = s.fixtures[static_cast<size_t>(n.fixture)];
        EXPECT_TRUE(Contains(n.box, f.tight)) << "fixture " << n.fixture;
    }
    for (size_t i = 0; i < seen.size(); ++i) EXPECT_EQ(seen[i], 1) << "fixture " << i;
}

/// Loads every scene of the catalogue at a small size and steps it (classics for a second, since they are cheap).
/// Checks the captures at the start and at the end.
inline void ExpectEverySceneRuns(const Maker& make, int steps) {
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        SCOPED_TRACE(std::string(info.name));
        const scenes::Scene scene = scenes::Build(info.name, SmallSize(info));
        const std::unique_ptr<EngineRun> run = make(scene);
        Snapshot snapshot;
        run->Capture(snapshot);
        EXPECT_EQ(snapshot.step, 0);
        ExpectMatchesScene(snapshot, scene);
        const int count = info.isClassic ? 60 : steps;
        for (int i = 0; i < count; ++i) run->Step();
        run->Capture(snapshot);
        EXPECT_EQ(snapshot.step, count);
        EXPECT_EQ(snapshot.scene, scene.name);
        EXPECT_EQ(snapshot.size, scene.size);
        ExpectMatchesScene(snapshot, scene);
        ExpectTreeHoldsFixtures(snapshot);
        for (const double time : {snapshot.times.broadPhase, snapshot.times.narrowPhase, snapshot.times.solver}) {
            EXPECT_GE(time, 0.0);
        }
        EXPECT_GT(snapshot.times.step, 0.0);
        EXPECT_EQ(run->GetContactCount(), snapshot.contactCount);
    }
}

}  // namespace testbed::checks
