// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What every adapter may rely on, for every scene. Fixture ranges are contiguous, spawned bodies are last and in order,
// and joints are between initial bodies. Numbers are finite, polygons are convex and counter-clockwise, and every build
// gives the same data.

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "scenes/catalog.h"
#include "scenes/outline.h"

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
            return (shape.vertexCount == 2 || shape.vertexCount == 4) && shape.vertices[0] != shape.vertices[1]
                       ? ""
                       : "edge";
        case ShapeType::chain:
            return "a chain is looked at by its edges";
        default:
            return "type";
    }
}

// Box2D and ours refuse chains with neighbours closer than 5 mm.
std::string ChainDefect(const Scene& scene, const Shape& chain) {
    const int end = chain.firstChainVertex + chain.chainVertexCount;
    if (chain.firstChainVertex < 0 || end > static_cast<int>(scene.chainVertices.size())) return "chain range";
    if (chain.chainVertexCount < (chain.IsLoop() ? 3 : 2)) return "chain too short";
    if (chain.vertexCount != 0 && chain.vertexCount != 2) return "chain ghosts";
    for (int child = 0; child < chain.ChildCount(); ++child) {
        const Shape edge = scenes::ChildOf(scene, chain, child);
        if (!edge.IsOneSidedEdge() || !std::ranges::all_of(edge.Vertices(), Finite)) return "chain edge";
        if (std::hypot(edge.vertices[1].x - edge.vertices[0].x, edge.vertices[1].y - edge.vertices[0].y) < 0.01f) {
            return "chain edge too short";
        }
    }
    return "";
}

std::string JointDefect(const Scene& scene, int index) {
    const scenes::Joint& joint = scene.joints[static_cast<std::size_t>(index)];
    if (joint.bodyA == joint.bodyB) return "joint of one body";
    for (int body : {joint.bodyA, joint.bodyB}) {
        if (body < 0 || body >= scene.InitialBodyCount()) return "joint to a body that is not there";
    }
    if (joint.type != scenes::JointType::gear) return "";
    for (int coupled : {joint.joint1, joint.joint2}) {
        if (coupled < 0 || coupled >= index) return "gear before its joints";
        const scenes::JointType type = scene.joints[static_cast<std::size_t>(coupled)].type;
        if (type != scenes::JointType::revolute && type != scenes::JointType::prismatic) return "gear of other joints";
    }
    const bool isBetween = scene.joints[static_cast<std::size_t>(joint.joint1)].bodyB == joint.bodyA &&
                           scene.joints[static_cast<std::size_t>(joint.joint2)].bodyB == joint.bodyB;
    return isBetween ? "" : "gear between other bodies";
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
        const bool isChain = fixture.shape.type == ShapeType::chain;
        const bool isFurther = scenes::IsFurtherConvex(fixture.shape.type);
        // What the further shapes are, and what stands for them, must be good polygons.
        const std::string defect =
            isChain     ? ChainDefect(scene, fixture.shape)
            : isFurther ? ShapeDefect(scenes::PolygonInstead(scene, fixture.shape)) +
                              (IsConvexCcw(scenes::SampleOutline(scene, fixture.shape, 64)) ? "" : "outline")
                        : ShapeDefect(fixture.shape);
        if (!defect.empty()) return defect;
        if (scenes::Find(scene.name)->isClassic) continue;
        if (fixture.friction != 0.2f || fixture.restitution != 0.0f) return "the suite's material";
    }
    int spawned = scene.InitialBodyCount();
    int lastStep = 1;
    for (const scenes::Spawn& spawn : scene.spawns) {
        if (spawn.body != spawned++) return "spawned bodies are not the last in order";
        if (spawn.afterStep < lastStep) return "spawns are not sorted";
        lastStep = spawn.afterStep;
    }
    for (int i = 0; i < static_cast<int>(scene.joints.size()); ++i) {
        if (const std::string defect = JointDefect(scene, i); !defect.empty()) return defect;
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
    // Up to three times the sweep: enough to enter the rules above it, small enough to stay fast. Classics have none.
    EXPECT_TRUE(rc::check("scenes are well-formed and deterministic", [] {
        const auto catalog = scenes::Catalog();
        const auto& info = catalog[*rc::gen::inRange<std::size_t>(0, catalog.size())];
        const int top =
            info.sweep ? std::min(info.maxSize, 3 * info.sweep->end) : std::min(info.maxSize, 5 * info.defaultSize);
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

TEST(Structure, TheDefectSearchFindsDefectsOfChainsAndGears) {
    const Scene car = scenes::Build("car"), gears = scenes::Build("gears");
    const auto defectAfter = [](Scene scene, auto mutate) {
        mutate(scene);
        return Defect(scene);
    };
    const auto chainOf = [](Scene& s) -> Shape& {
        return std::ranges::find(s.fixtures, ShapeType::chain, [](const scenes::Fixture& f) { return f.shape.type; })
            ->shape;
    };
    EXPECT_NE(defectAfter(car, [](Scene& s) { s.chainVertices.pop_back(); }), "");
    EXPECT_NE(defectAfter(car, [](Scene& s) { s.chainVertices[3] = s.chainVertices[4]; }), "");
    EXPECT_NE(defectAfter(car, [&](Scene& s) { chainOf(s).chainVertexCount = 1; }), "");
    EXPECT_NE(defectAfter(car, [&](Scene& s) { chainOf(s).firstChainVertex = -1; }), "");
    EXPECT_NE(defectAfter(gears, [](Scene& s) { s.joints.back().joint2 = static_cast<int>(s.joints.size()) - 1; }), "");
    EXPECT_NE(defectAfter(gears, [](Scene& s) { std::swap(s.joints.back().bodyA, s.joints.back().bodyB); }), "");
    EXPECT_NE(defectAfter(gears, [](Scene& s) { s.joints[0].type = scenes::JointType::weld; }), "");
}

TEST(Structure, EveryJointTypeAndShapeTypeOccurs) {
    std::set<scenes::JointType> joints;
    std::set<ShapeType> shapes;
    bool hasLoop = false, hasOneSidedEdge = false, hasConveyor = false;
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        if (!info.isClassic) continue;
        const Scene scene = scenes::Build(info.name);
        for (const scenes::Joint& joint : scene.joints) joints.insert(joint.type);
        for (const scenes::Fixture& fixture : scene.fixtures) {
            shapes.insert(fixture.shape.type);
            hasLoop |= fixture.shape.IsLoop();
            hasOneSidedEdge |= fixture.shape.IsOneSidedEdge();
            hasConveyor |= fixture.tangentSpeed != 0.0f;
        }
    }
    EXPECT_EQ(static_cast<int>(joints.size()), scenes::jointTypeCount);
    EXPECT_EQ(shapes.size(), 11u);
    EXPECT_TRUE(hasLoop && hasOneSidedEdge && hasConveyor);
}

TEST(Structure, LargestSizesStayInMemory) {
    // The two scenes with most bodies and most fixtures a body; 2e6 bodies are about 350 MB, so one at a time.
    EXPECT_EQ(scenes::Build("slow-explosion", 2000000).bodies.size(), 2000000u);
    EXPECT_EQ(scenes::Build("tiles", 2000).fixtures.size(), 2003000u);
}

}  // namespace
