// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What every adapter may rely on, for every scene: contiguous fixture ranges, spawned bodies last and in order, joints
// between initial bodies, finite numbers, convex counter-clockwise polygons, and the same data from every build.

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <algorithm>
#include <cmath>

#include "scenes/catalog.h"

namespace {

using scenes::Scene;
using scenes::Shape;
using scenes::ShapeType;
using scenes::Vec2;

bool Finite(Vec2 v) { return std::isfinite(v.x) && std::isfinite(v.y); }

double Cross(Vec2 a, Vec2 b, Vec2 c) {
    return (static_cast<double>(b.x) - a.x) * (static_cast<double>(c.y) - a.y) -
           (static_cast<double>(b.y) - a.y) * (static_cast<double>(c.x) - a.x);
}

// Convex and counter-clockwise: every vertex lies strictly left of every edge it is no end of.
bool IsConvexCcw(std::span<const Vec2> v) {
    for (std::size_t i = 0; i < v.size(); ++i) {
        const std::size_t next = (i + 1) % v.size();
        for (std::size_t k = 0; k < v.size(); ++k) {
            if (k != i && k != next && Cross(v[i], v[next], v[k]) <= 0.0) return false;
        }
    }
    return v.size() >= 3;
}

std::string ShapeDefect(const Shape& shape) {
    if (!Finite(shape.center) || !std::isfinite(shape.angle)) return "not finite";
    switch (shape.type) {
        case ShapeType::circle:
            return shape.radius > 0.0f && std::isfinite(shape.radius) ? "" : "radius";
        case ShapeType::box:
            return Finite(shape.halfExtents) && shape.halfExtents.x > 0.0f && shape.halfExtents.y > 0.0f
                       ? ""
                       : "half extents";
        case ShapeType::polygon:
            return shape.vertexCount <= scenes::maxPolygonVertices && IsConvexCcw(shape.Vertices()) ? ""
                                                                                                    : "not convex ccw";
        case ShapeType::edge:
            return shape.vertexCount == 2 && shape.vertices[0] != shape.vertices[1] ? "" : "edge";
    }
    return "type";
}

// "" or the first defect found.
std::string Defect(const Scene& scene) {
    int nextFixture = 0;
    for (const scenes::Body& body : scene.bodies) {
        if (body.firstFixture != nextFixture || body.fixtureCount < 0) return "fixture ranges leave a gap";
        nextFixture += body.fixtureCount;
        if (!Finite(body.position) || !Finite(body.linearVelocity)) return "body not finite";
    }
    if (nextFixture != static_cast<int>(scene.fixtures.size())) return "fixtures without a body";
    for (const scenes::Fixture& fixture : scene.fixtures) {
        if (const std::string defect = ShapeDefect(fixture.shape); !defect.empty()) return defect;
        if (fixture.friction != 0.2f || fixture.restitution != 0.0f) return "the suite's material";
    }
    int spawned = scene.InitialBodyCount();
    int lastStep = 1;
    for (const scenes::Spawn& spawn : scene.spawns) {
        if (spawn.body != spawned++) return "spawned bodies are not the last in order";
        if (spawn.afterStep < lastStep) return "spawns are not sorted";
        lastStep = spawn.afterStep;
    }
    for (const scenes::Joint& joint : scene.joints) {
        if (joint.bodyA == joint.bodyB) return "joint of one body";
        for (int body : {joint.bodyA, joint.bodyB}) {
            if (body < 0 || body >= scene.InitialBodyCount()) return "joint to a body that is not there";
        }
    }
    if (scene.showStep < 1 || scene.showStep > scene.steps) return "showStep outside the run";
    return "";
}

// A dynamic body with no mass is replaced by one of 1 kg in Box2D: no scene may depend on that.
bool DynamicBodiesHaveMass(const Scene& scene) {
    for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) {
        if (scene.bodies[static_cast<std::size_t>(i)].type != scenes::BodyType::dynamic) continue;
        const auto fixtures = scene.FixturesOf(i);
        if (std::ranges::none_of(fixtures, [](const scenes::Fixture& f) { return f.density > 0.0f; })) return false;
    }
    return true;
}

TEST(Structure, DefaultSizesAreWellFormed) {
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        const Scene scene = scenes::Build(info.name);
        EXPECT_EQ(Defect(scene), "") << info.name;
        EXPECT_TRUE(DynamicBodiesHaveMass(scene)) << info.name;
        EXPECT_TRUE(scene == scenes::Build(info.name)) << info.name << ": two builds differ";
    }
}

TEST(Structure, AnyLegalSizeIsWellFormedAndDeterministic) {
    // Up to three times the sweep: enough to enter the rules above it, small enough to stay fast.
    EXPECT_TRUE(rc::check("scenes are well-formed and deterministic", [] {
        const auto catalog = scenes::Catalog();
        const auto& info = catalog[*rc::gen::inRange<std::size_t>(0, catalog.size())];
        const int top = info.sweep ? std::min(info.maxSize, 3 * info.sweep->end) : info.maxSize;
        const int size = *rc::gen::inRange(info.minSize, top + 1);
        const Scene scene = scenes::Build(info.name, size);
        RC_ASSERT(Defect(scene) == "");
        RC_ASSERT(DynamicBodiesHaveMass(scene));
        RC_ASSERT(scene.size == size);
        RC_ASSERT(scene == scenes::Build(info.name, size));
    }));
}

TEST(Structure, TheDefectSearchFindsDefects) {
    // A check that cannot fail is worth nothing: each mutation of a good scene must be named.
    const Scene good = scenes::Build("mild-n2", 1);
    ASSERT_EQ(Defect(good), "");
    const auto defectAfter = [&good](auto mutate) {
        Scene scene = good;
        mutate(scene);
        return Defect(scene);
    };
    EXPECT_NE(defectAfter([](Scene& s) {
                  std::swap(s.fixtures.back().shape.vertices[0], s.fixtures.back().shape.vertices[1]);
              }),
              "");
    EXPECT_NE(defectAfter([](Scene& s) { ++s.bodies[1].firstFixture; }), "");
    EXPECT_NE(defectAfter([](Scene& s) { --s.bodies[2].fixtureCount; }), "");
    EXPECT_NE(defectAfter([](Scene& s) { s.bodies[0].position.x = NAN; }), "");
    EXPECT_NE(defectAfter([](Scene& s) { s.spawns.push_back({.afterStep = 1, .body = 0}); }), "");
    EXPECT_NE(defectAfter([](Scene& s) { s.joints.push_back({.bodyA = 0, .bodyB = 99}); }), "");
}

TEST(Structure, LargestSizesStayInMemory) {
    // The two scenes with most bodies and most fixtures a body; 2e6 bodies are about 330 MB, so one at a time.
    EXPECT_EQ(scenes::Build("slow-explosion", 2000000).bodies.size(), 2000000u);
    EXPECT_EQ(scenes::Build("tiles", 2000).fixtures.size(), 2003000u);
}

}  // namespace
