// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Positions, velocities, shapes and densities of chosen bodies of every scene against the published parameters, worked
// out by hand; and the rules for sizes above a sweep.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "scenes/catalog.h"

namespace {

using scenes::Body;
using scenes::BodyType;
using scenes::Fixture;
using scenes::Scene;
using scenes::Shape;
using scenes::ShapeType;
using scenes::Vec2;

const Body& BodyAt(const Scene& scene, int index) { return scene.bodies.at(static_cast<std::size_t>(index)); }

const Fixture& FixtureAt(const Scene& scene, int body, int fixture = 0) {
    return scene.fixtures.at(static_cast<std::size_t>(BodyAt(scene, body).firstFixture + fixture));
}

// Equal to the float nearest to each coordinate, give or take the rounding of one float operation.
void ExpectPoint(Vec2 actual, double x, double y) {
    EXPECT_FLOAT_EQ(actual.x, static_cast<float>(x));
    EXPECT_FLOAT_EQ(actual.y, static_cast<float>(y));
}

void ExpectBox(const Fixture& fixture, double hx, double hy, double x, double y, double density) {
    EXPECT_EQ(fixture.shape.type, ShapeType::box);
    ExpectPoint(fixture.shape.halfExtents, hx, hy);
    ExpectPoint(fixture.shape.center, x, y);
    EXPECT_FLOAT_EQ(fixture.density, static_cast<float>(density));
}

void ExpectCircle(const Fixture& fixture, double radius, double density) {
    EXPECT_EQ(fixture.shape.type, ShapeType::circle);
    EXPECT_FLOAT_EQ(fixture.shape.radius, static_cast<float>(radius));
    ExpectPoint(fixture.shape.center, 0.0, 0.0);
    EXPECT_FLOAT_EQ(fixture.density, static_cast<float>(density));
}

TEST(Parameters, OnlyAddPairAndSlowExplosionHaveNoGravity) {
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        if (info.isClassic) continue;
        const std::string name(info.name);
        const bool weightless = name == "add-pair" || name == "add-pair-400" || name == "slow-explosion";
        ExpectPoint(scenes::Build(name).gravity, 0.0, weightless ? 0.0 : -10.0);
    }
}

TEST(Parameters, AllBodiesSleepAndNoneIsABullet) {
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        if (info.isClassic) continue;
        const Scene scene = scenes::Build(info.name);
        EXPECT_TRUE(std::ranges::all_of(scene.bodies, [](const Body& b) {
            return b.allowSleep && b.awake && !b.bullet && !b.fixedRotation && b.gravityScale == 1.0f &&
                   b.angle == 0.0f && b.angularVelocity == 0.0f && b.linearDamping == 0.0f && b.angularDamping == 0.0f;
        })) << info.name;
    }
}

TEST(Parameters, FallingSquares) {
    const Scene scene = scenes::Build("falling-squares");
    EXPECT_EQ(BodyAt(scene, 0).type, BodyType::isStatic);
    ExpectPoint(BodyAt(scene, 0).position, 0.0, -10.0);
    ExpectBox(FixtureAt(scene, 0), 100.0, 3.0, 0.0, 0.0, 0.0);
    // Column 0: a = 0.5, rows 0 … 299, the first at 2a·300.
    ExpectPoint(BodyAt(scene, 1).position, -30.0, 300.0);
    ExpectBox(FixtureAt(scene, 1), 0.5, 0.5, 0.0, 0.0, 5.0);
    ExpectPoint(BodyAt(scene, 300).position, -30.0, 1.0);
    // Column 1: a = 0.5 + 1/6, 299 rows from row 1 on.
    ExpectPoint(BodyAt(scene, 301).position, -23.0, 4.0 / 3.0 * 299.0);
    // Column 14, its last row: a = 0.5 + 14/6.
    ExpectPoint(BodyAt(scene, 4395).position, 68.0, 17.0 / 3.0);
    ExpectBox(FixtureAt(scene, 4395), 17.0 / 6.0, 17.0 / 6.0, 0.0, 0.0, 5.0);
}

TEST(Parameters, FallingCircles) {
    const Scene scene = scenes::Build("falling-circles");
    ExpectBox(FixtureAt(scene, 0), 100.0, 3.0, 0.0, 0.0, 0.0);
    ExpectPoint(BodyAt(scene, 1).position, -100.0, 300.0);
    ExpectCircle(FixtureAt(scene, 1), 0.25, 5.0);
    ExpectPoint(BodyAt(scene, 300).position, 0.25 * 299.0 - 100.0, 1.0);
    ExpectPoint(BodyAt(scene, 4395).position, 98.0 + 0.25 * 299.0 - 100.0, 17.0 / 3.0);
    ExpectCircle(FixtureAt(scene, 4395), 17.0 / 12.0, 5.0);
}

TEST(Parameters, FallingScenesRepeatTheirBlockAboveTheSweep) {
    for (std::string name : {"falling-squares", "falling-circles"}) {
        const Scene block = scenes::Build(name, 300);
        const Scene many = scenes::Build(name, 300 * 19 + 1);  // 20 blocks: two rows of ten
        const std::size_t perBlock = block.bodies.size();
        ASSERT_EQ(many.bodies.size(), 20 * perBlock);
        bool unshifted = false;
        for (std::size_t k = 0; k < 20; ++k) {
            // Static against static, so that the difference is the block's offset: a multiple of the pitch.
            const double dx = many.bodies[k * perBlock].position.x - block.bodies[0].position.x;
            const double dy = many.bodies[k * perBlock].position.y - block.bodies[0].position.y;
            EXPECT_EQ(std::fmod(dx, 210.0), 0.0);
            EXPECT_EQ(std::fmod(dy, 1800.0), 0.0);
            unshifted = unshifted || (dx == 0.0 && dy == 0.0);
            for (std::size_t i = 0; i < perBlock; i += 97) {
                const Body& body = many.bodies[k * perBlock + i];
                // Coordinates below 4096 m: half a float's spacing there is 1.3e-4 m.
                EXPECT_NEAR(body.position.x, block.bodies[i].position.x + dx, 1.3e-4);
                EXPECT_NEAR(body.position.y, block.bodies[i].position.y + dy, 1.3e-4);
                const Fixture& fixture = many.fixtures[static_cast<std::size_t>(body.firstFixture)];
                EXPECT_EQ(fixture, block.fixtures[static_cast<std::size_t>(block.bodies[i].firstFixture)]);
            }
            for (std::size_t other = 0; other < k; ++other) {
                EXPECT_NE(many.bodies[k * perBlock].position, many.bodies[other * perBlock].position);
            }
        }
        EXPECT_TRUE(unshifted);
    }
}

TEST(Parameters, Tumbler) {
    const Scene scene = scenes::Build("tumbler", 50);
    EXPECT_EQ(BodyAt(scene, 0).type, BodyType::isStatic);
    EXPECT_EQ(BodyAt(scene, 0).fixtureCount, 0);
    ExpectPoint(BodyAt(scene, 1).position, 0.0, 10.0);
    ASSERT_EQ(BodyAt(scene, 1).fixtureCount, 4);
    ExpectBox(FixtureAt(scene, 1, 0), 0.5, 10.0, 10.0, 0.0, 5.0);
    ExpectBox(FixtureAt(scene, 1, 1), 0.5, 10.0, -10.0, 0.0, 5.0);
    ExpectBox(FixtureAt(scene, 1, 2), 10.0, 0.5, 0.0, 10.0, 5.0);
    ExpectBox(FixtureAt(scene, 1, 3), 10.0, 0.5, 0.0, -10.0, 5.0);
    ASSERT_EQ(scene.joints.size(), 1u);
    const scenes::Joint& joint = scene.joints[0];
    EXPECT_EQ(joint.bodyA, 0);
    EXPECT_EQ(joint.bodyB, 1);
    ExpectPoint(joint.localAnchorA, 0.0, 10.0);
    ExpectPoint(joint.localAnchorB, 0.0, 0.0);
    EXPECT_TRUE(joint.enableMotor);
    EXPECT_FALSE(joint.enableLimit);
    EXPECT_FLOAT_EQ(joint.motorSpeed, 0.157079633f);
    EXPECT_EQ(joint.maxMotorTorque, 1e8f);
    // One box after each of the steps 1 … 50.
    EXPECT_EQ(scene.InitialBodyCount(), 2);
    ASSERT_EQ(scene.spawns.size(), 50u);
    for (int i = 0; i < 50; ++i) {
        EXPECT_EQ(scene.spawns[static_cast<std::size_t>(i)], (scenes::Spawn{.afterStep = i + 1, .body = i + 2}));
        ExpectPoint(BodyAt(scene, i + 2).position, 0.0, 10.0);
        ExpectBox(FixtureAt(scene, i + 2), 0.125, 0.125, 0.0, 0.0, 1.0);
    }
    EXPECT_EQ(scene.steps, 1500);
    EXPECT_EQ(scenes::Build("tumbler", 3000).steps, 3500) << "a run ends 500 steps after the last box";
}

TEST(Parameters, AddPair) {
    const Scene scene = scenes::Build("add-pair");
    ExpectPoint(BodyAt(scene, 0).position, -9.0, 4.0);
    ExpectPoint(BodyAt(scene, 31).position, -9.0 + 18.0 * 31.0 / 2000.0, 4.0 + 62.0 / 32.0);
    ExpectPoint(BodyAt(scene, 32).position, -9.0 + 18.0 * 32.0 / 2000.0, 4.0);
    ExpectPoint(BodyAt(scene, 1999).position, -9.0 + 18.0 * 1999.0 / 2000.0, 4.0 + 2.0 * 15.0 / 32.0);
    ExpectCircle(FixtureAt(scene, 1999), 0.1, 0.01);
    ExpectPoint(BodyAt(scene, 2000).position, -40.0, 5.0);
    ExpectPoint(BodyAt(scene, 2000).linearVelocity, 150.0, 0.0);
    ExpectBox(FixtureAt(scene, 2000), 1.5, 1.5, 0.0, 0.0, 1.0);
}

TEST(Parameters, AddPair400) {
    const Scene scene = scenes::Build("add-pair-400");
    double meanX = 0.0, meanY = 0.0, leftmost = 0.0;
    for (int i = 0; i < 400; ++i) {
        const Vec2 p = BodyAt(scene, i).position;
        ExpectCircle(FixtureAt(scene, i), 0.1, 0.01);
        EXPECT_TRUE(p.x >= -6.0f && p.x <= 0.0f && p.y >= 4.0f && p.y <= 6.0f) << i;
        meanX += p.x / 400.0;
        meanY += p.y / 400.0;
        leftmost = std::min(leftmost, static_cast<double>(p.x));
    }
    // The mean of 400 uniform values deviates by width / √12 / 20: 0.087 and 0.029 m; four of that.
    EXPECT_NEAR(meanX, -3.0, 0.35);
    EXPECT_NEAR(meanY, 5.0, 0.12);
    ExpectPoint(BodyAt(scene, 400).position, -40.0, 5.0);
    ExpectPoint(BodyAt(scene, 400).linearVelocity, 150.0, 0.0);
    ExpectBox(FixtureAt(scene, 400), 1.5, 1.5, 0.0, 0.0, 1.0);
    // At 2 m a step (the cap) the box's right side reaches the first circle in step 17.
    EXPECT_EQ(std::ceil((leftmost - 0.1 - -38.5) / 2.0), 17.0);
}

TEST(Parameters, MildNSquared) {
    const Scene scene = scenes::Build("mild-n2", 10);
    const Shape& edge = FixtureAt(scene, 0).shape;
    EXPECT_EQ(edge.type, ShapeType::edge);
    ExpectPoint(edge.vertices[0], 50.0, 0.0);
    ExpectPoint(edge.vertices[1], -50.0, 0.0);
    for (int i = 1; i <= 10; ++i) {
        ExpectPoint(BodyAt(scene, i).position, -5.0, 1.0);
        ASSERT_EQ(BodyAt(scene, i).fixtureCount, 3);
        ExpectBox(FixtureAt(scene, i, 0), 3.0, 0.5, 0.0, 3.5, 2.0);
        ExpectBox(FixtureAt(scene, i, 1), 0.5, 2.0, -2.5, 2.0, 2.0);
        ExpectBox(FixtureAt(scene, i, 2), 0.5, 2.0, 2.5, 2.0, 2.0);
    }
    for (int i = 11; i <= 20; ++i) {
        ExpectPoint(BodyAt(scene, i).position, 15.0, 1.0);
        ASSERT_EQ(BodyAt(scene, i).fixtureCount, 2);
        for (int f : {0, 1}) {
            const Fixture& wing = FixtureAt(scene, i, f);
            EXPECT_EQ(wing.density, 2.0f);
            ASSERT_EQ(wing.shape.vertexCount, 3);
            // A set, because any counter-clockwise order will do.
            const float side = f == 0 ? 1.0f : -1.0f;
            for (Vec2 corner : {Vec2{-2.0f * side, 0.0f}, Vec2{side, 2.0f}, Vec2{0.0f, 4.0f}}) {
                EXPECT_TRUE(std::ranges::count(wing.shape.Vertices(), corner) == 1);
            }
        }
    }
}

TEST(Parameters, NSquared) {
    const Scene scene = scenes::Build("n2");
    ExpectPoint(BodyAt(scene, 0).position, 0.0, 0.0);
    ExpectPoint(BodyAt(scene, 749).position, 7.49, 7.49);
    ExpectCircle(FixtureAt(scene, 749), 1.0, 1.0);
    EXPECT_TRUE(std::ranges::none_of(scene.bodies, [](const Body& b) { return b.type == BodyType::isStatic; }));
}

TEST(Parameters, MultiFixture) {
    const Scene scene = scenes::Build("multi-fixture");
    ExpectBox(FixtureAt(scene, 0, 0), 35.0, 1.0, 0.0, 0.0, 0.0);
    ExpectBox(FixtureAt(scene, 0, 1), 1.0, 25.0, -36.0, 24.0, 0.0);
    ExpectBox(FixtureAt(scene, 0, 2), 1.0, 25.0, 36.0, 24.0, 0.0);
    // Table 0: 50 slices of b = 0.04; slice 49 is centred 2·49·0.04 + 0.04 = 3.96 up.
    ExpectPoint(BodyAt(scene, 1).position, -20.0, 1.0);
    ASSERT_EQ(BodyAt(scene, 1).fixtureCount, 150);
    ExpectBox(FixtureAt(scene, 1, 0), 0.5, 0.04, -1.5, 0.04, 0.04);
    ExpectBox(FixtureAt(scene, 1, 148), 0.5, 0.04, 1.5, 3.96, 0.04);
    ExpectBox(FixtureAt(scene, 1, 149), 0.04, 0.5, 1.96, 3.5, 0.04);
    // Table 47: c = 50 − 23 = 27, column 5, row 7, shifted by ⌊47/10⌋ = 4.
    ExpectPoint(BodyAt(scene, 48).position, -20.0 + 35.0 + 4.0, 36.0);
    EXPECT_EQ(BodyAt(scene, 48).fixtureCount, 81);
    // Table 99: one slice.
    ExpectPoint(BodyAt(scene, 100).position, -20.0 + 21.0 + 9.0, 81.0);
    ASSERT_EQ(BodyAt(scene, 100).fixtureCount, 3);
    ExpectBox(FixtureAt(scene, 100, 2), 2.0, 0.5, 0.0, 3.5, 2.0);
}

TEST(Parameters, MultiFixtureRepeatsItsHundredHigherUp) {
    const Scene scene = scenes::Build("multi-fixture", 250);
    for (int i = 0; i < 150; ++i) {
        const Vec2 below = BodyAt(scene, 1 + i).position;
        ExpectPoint(BodyAt(scene, 101 + i).position, below.x, below.y + 85.0);
        EXPECT_EQ(BodyAt(scene, 101 + i).fixtureCount, BodyAt(scene, 1 + i).fixtureCount);
    }
}

TEST(Parameters, MostlyStatic) {
    const Scene single = scenes::Build("mostly-static-single");
    ExpectPoint(BodyAt(single, 0).position, 0.0, -0.5);
    // Row 0, column 4 is the first cell more than 3 off the diagonal: (−100 + 4, 0) in body coordinates.
    ExpectBox(FixtureAt(single, 0, 0), 0.5, 0.5, -96.0, 0.0, 0.0);
    ExpectBox(FixtureAt(single, 0, 195), 0.5, 0.5, 99.0, 0.0, 0.0);  // the end of row 0
    ExpectBox(FixtureAt(single, 0, 196), 0.5, 0.5, -95.0, -1.0, 0.0);
    ExpectBox(FixtureAt(single, 0, 38611), 0.5, 0.5, 95.0, -199.0, 0.0);
    // Circles on the diagonal, in world coordinates.
    ExpectPoint(BodyAt(single, 1).position, -100.0, 0.0);
    ExpectPoint(BodyAt(single, 200).position, 99.0, -199.0);
    ExpectCircle(FixtureAt(single, 200), 1.0, 1.0);

    const Scene multi = scenes::Build("mostly-static-multi");
    ExpectPoint(BodyAt(multi, 0).position, -100.0, 0.0);  // row 0: the circle, then boxes from column 4 on
    EXPECT_EQ(BodyAt(multi, 0).type, BodyType::dynamic);
    ExpectPoint(BodyAt(multi, 1).position, -96.0, 0.0);
    EXPECT_EQ(BodyAt(multi, 1).type, BodyType::isStatic);
    ExpectBox(FixtureAt(multi, 1), 0.5, 0.5, 0.0, 0.0, 0.0);
    ExpectPoint(BodyAt(multi, 38811).position, 99.0, -199.0);
    ExpectCircle(FixtureAt(multi, 38811), 1.0, 1.0);
}

TEST(Parameters, Diagonal) {
    const Scene scene = scenes::Build("diagonal");
    ExpectPoint(BodyAt(scene, 0).position, -25.0, 0.0);
    ExpectBox(FixtureAt(scene, 0), 0.5, 0.5, -25.0, 0.0, 0.0);
    // j = 24, i = 49: the last slab, p = (−25 + 196, −96), half length (3·24 + 1)·0.5.
    ExpectPoint(BodyAt(scene, 1249).position, 171.0, -96.0);
    ExpectBox(FixtureAt(scene, 1249), 0.5, 36.5, 171.0, -96.0, 0.0);
    EXPECT_FLOAT_EQ(FixtureAt(scene, 1249).shape.angle, 0.785398163f);
    ExpectPoint(BodyAt(scene, 1250).position, -75.0, 50.0);
    ExpectPoint(BodyAt(scene, 4249).position, 2.0 * 199.0 - 75.0, 78.0);
    ExpectCircle(FixtureAt(scene, 4249), 0.5, 1.0);
    EXPECT_EQ(scenes::Count(scenes::Build("diagonal", 3)).staticBodies, 3) << "one row of three";
}

TEST(Parameters, Mixed) {
    const Scene scene = scenes::Build("mixed");
    ASSERT_EQ(BodyAt(scene, 0).fixtureCount, 8427);
    for (const Fixture& fixture : scene.FixturesOf(0)) {
        const Vec2 c = fixture.shape.center;
        EXPECT_EQ(fixture.shape.radius, 0.5f);
        EXPECT_TRUE(c.x >= 0.0f && c.x < 150.0f && c.y >= 0.0f && c.y < 150.0f);
        EXPECT_TRUE(c.x == std::floor(c.x) && c.y == std::floor(c.y));
        EXPECT_GT(std::hypot(c.x - 75.0f, c.y - 75.0f), 67.0f);
    }
    ExpectPoint(BodyAt(scene, 1).position, 85.0, 75.0);
    ExpectPoint(BodyAt(scene, 1).linearVelocity, 10.0, 0.0);
    // i = 3000: s = 0.5, 15 rad, distance 35.
    ExpectPoint(BodyAt(scene, 3001).position, 35.0 * std::cos(15.0) + 75.0, 35.0 * std::sin(15.0) + 75.0);
    ExpectPoint(BodyAt(scene, 3001).linearVelocity, 35.0 * std::cos(15.0), 35.0 * std::sin(15.0));
    ExpectCircle(FixtureAt(scene, 3001), 0.5, 0.5);
}

TEST(Parameters, SlowExplosion) {
    const Scene scene = scenes::Build("slow-explosion");
    ExpectPoint(BodyAt(scene, 0).position, 5.0, 0.0);
    ExpectPoint(BodyAt(scene, 0).linearVelocity, 1.0, 0.0);
    // i = 3000: s = 5, 150 rad, distance 155.
    ExpectPoint(BodyAt(scene, 3000).position, 155.0 * std::cos(150.0), 155.0 * std::sin(150.0));
    ExpectPoint(BodyAt(scene, 3000).linearVelocity, 31.0 * std::cos(150.0), 31.0 * std::sin(150.0));
    ExpectCircle(FixtureAt(scene, 3000), 0.5, 0.5);
}

TEST(Parameters, SlowExplosionKeepsItsDensityAboveTheSweep) {
    // Four times the bodies: positions twice as far, the same velocities.
    const Scene scene = scenes::Build("slow-explosion", 24000);
    ExpectPoint(BodyAt(scene, 0).position, 10.0, 0.0);
    ExpectPoint(BodyAt(scene, 0).linearVelocity, 1.0, 0.0);
    ExpectPoint(BodyAt(scene, 12000).position, 310.0 * std::cos(150.0), 310.0 * std::sin(150.0));
    ExpectPoint(BodyAt(scene, 12000).linearVelocity, 31.0 * std::cos(150.0), 31.0 * std::sin(150.0));
}

TEST(Parameters, Tiles) {
    for (int n : {20, 200, 300}) {
        const Scene scene = scenes::Build("tiles", n);
        ExpectPoint(BodyAt(scene, 0).position, 0.0, -0.5);
        ExpectBox(FixtureAt(scene, 0, 0), 0.5, 0.5, -100.0, 0.0, 0.0);
        ExpectBox(FixtureAt(scene, 0, 1999), 0.5, 0.5, 99.0, -9.0, 0.0);
        ExpectPoint(BodyAt(scene, 1).position, -7.0, 189.25);
        ExpectBox(FixtureAt(scene, 1), 0.5, 0.5, 0.0, 0.0, 5.0);
        ExpectPoint(BodyAt(scene, n).position, -7.0 + 1.125 * (n - 1), 189.25);
        ExpectPoint(BodyAt(scene, n + 1).position, -7.0 + 0.5625, 188.0);
        ExpectPoint(BodyAt(scene, n * (n + 1) / 2).position, -7.0 + 0.5625 * (n - 1), 189.25 - 1.25 * (n - 1));
    }
}

TEST(Parameters, BigMobile) {
    const Scene scene = scenes::Build("big-mobile");
    ExpectPoint(BodyAt(scene, 0).position, 0.0, 20.0);
    EXPECT_EQ(BodyAt(scene, 0).fixtureCount, 0);
    ExpectPoint(BodyAt(scene, 1).position, 0.0, 19.75);
    ASSERT_EQ(BodyAt(scene, 1).fixtureCount, 2);
    ExpectBox(FixtureAt(scene, 1, 0), 0.0625, 0.25, 0.0, 0.0, 20.0);
    ExpectBox(FixtureAt(scene, 1, 1), 200.0, 0.0625, 0.0, -0.25, 20.0);
    // Depth first, right child first: body 2 hangs at (+200, −0.25) with a bar of half that width.
    ExpectPoint(BodyAt(scene, 2).position, 200.0, 19.25);
    ExpectBox(FixtureAt(scene, 2, 0), 0.0625, 0.25, 0.0, 0.0, 24.0);
    ExpectBox(FixtureAt(scene, 2, 1), 100.0, 0.0625, 0.0, -0.25, 20.0);
    const int left = 2 + 2047;  // after the 2^11 − 1 nodes of the right half
    ExpectPoint(BodyAt(scene, left).position, -200.0, 19.25);
    ExpectBox(FixtureAt(scene, left, 0), 0.0625, 0.25, 0.0, 0.0, 16.0);
    const int leaves =
        static_cast<int>(std::ranges::count_if(scene.bodies, [](const Body& b) { return b.fixtureCount == 1; }));
    EXPECT_EQ(leaves, 2048);
}

TEST(Parameters, BigMobileHangsTogether) {
    // Each joint's anchors coincide in the initial pose, each node hangs on exactly one joint, and the root on the body
    // that does not move.
    const Scene scene = scenes::Build("big-mobile");
    std::vector<int> hangs(scene.bodies.size());
    for (const scenes::Joint& joint : scene.joints) {
        const Vec2 a = BodyAt(scene, joint.bodyA).position;
        const Vec2 b = BodyAt(scene, joint.bodyB).position;
        // Positions below 512 m: a float's spacing there is 3e-5 m.
        EXPECT_NEAR(a.x + joint.localAnchorA.x, b.x + joint.localAnchorB.x, 6e-5);
        EXPECT_NEAR(a.y + joint.localAnchorA.y, b.y + joint.localAnchorB.y, 6e-5);
        ++hangs[static_cast<std::size_t>(joint.bodyB)];
    }
    EXPECT_EQ(hangs[0], 0);
    EXPECT_TRUE(std::all_of(hangs.begin() + 1, hangs.end(), [](int count) { return count == 1; }));
    EXPECT_EQ(scene.joints.back().bodyA, 0);
    EXPECT_EQ(scene.joints.back().bodyB, 1);
}

}  // namespace
