// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Positions with a low-order part: their arithmetic against double, boxes against exact ones, and every call that
// makes, moves, stores or looks at a body far from the origin.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "base/two_sum.h"
#include "scree/far_position.h"
#include "scree/recording.h"
#include "scree/snapshot.h"
#include "state/frames.h"
#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

struct Exact {
    double x = 0.0, y = 0.0;
};
Exact OriginOf(const Body& b) {
    return {double{b.GetPosition().x} + double{b.GetPositionRest().x},
            double{b.GetPosition().y} + double{b.GetPositionRest().y}};
}
Exact CentreOf(const Body& b) {
    return {double{b.GetWorldCenter().x} + double{b.GetWorldCenterRest().x},
            double{b.GetWorldCenter().y} + double{b.GetWorldCenterRest().y}};
}
void ExpectAt(Exact expected, Exact found, double tolerance) {
    EXPECT_NEAR(expected.x, found.x, tolerance);
    EXPECT_NEAR(expected.y, found.y, tolerance);
}

BodyDef DefAt(double x, double y) {
    BodyDef def;
    def.type = dynamicBody;
    const FarPosition at = ToFarPosition(x, y);
    def.position = at.position;
    def.positionRest = at.positionRest;
    return def;
}

/// A float of either sign from 2^-12 to 2^12: sums of two have at most 48 digits, so a double holds them exactly.
float AnyFloat() {
    const float mantissa = 1.0f + static_cast<float>(*rc::gen::inRange(0, 1 << 23)) * 0x1p-23f;
    return std::ldexp(*rc::gen::arbitrary<bool>() ? mantissa : -mantissa, *rc::gen::inRange(-12, 12));
}

TEST(FarPositions, TwoSumLosesNothing) {
    EXPECT_TRUE(rc::check("sum + rest is the exact sum, and the sum is the nearest float", [] {
        const float a = AnyFloat(), b = AnyFloat();
        const RoundedSum s = TwoSum(a, b);
        RC_ASSERT(double{s.sum} + double{s.rest} == double{a} + double{b});
        RC_ASSERT(s.sum == static_cast<float>(double{a} + double{b}));
    }));
}

TEST(FarPositions, DoublesAreSplitAtTheDigitsOfAFloat) {
    EXPECT_TRUE(rc::check("the sum is the double, to the last digit of the rest", [] {
        const double x = 1024.0 * double{AnyFloat()} + double{AnyFloat()} / 4096.0;
        const double y = 4096.0 * double{AnyFloat()} + double{AnyFloat()} / 1024.0;
        const FarPosition p = ToFarPosition(x, y);
        RC_ASSERT(p.position.x == static_cast<float>(x));
        RC_ASSERT(std::abs(double{p.position.x} + double{p.positionRest.x} - x) <= std::ldexp(std::abs(x), -48));
        RC_ASSERT(p.position.y == static_cast<float>(y));
        RC_ASSERT(std::abs(double{p.position.y} + double{p.positionRest.y} - y) <= std::ldexp(std::abs(y), -48));
    }));
}

TEST(FarPositions, BoxesAreTheSmallestAroundTheExactOnes) {
    EXPECT_TRUE(rc::check("one float less on any side does not cover the box", [] {
        const Vec2 frame{1024.0f * AnyFloat(), 1024.0f * AnyFloat()};
        const Vec2 low{AnyFloat(), AnyFloat()};
        const AABB box{low, low + Vec2{Abs(AnyFloat()), Abs(AnyFloat())}};
        const AABB world = ToWorld(frame, box);
        const auto check = [](float lower, float upper, double least, double most) {
            RC_ASSERT(double{lower} <= least);
            RC_ASSERT(double{upper} >= most);
            RC_ASSERT(double{std::nextafter(lower, INFINITY)} > least);
            RC_ASSERT(double{std::nextafter(upper, -INFINITY)} < most);
        };
        check(world.lowerBound.x, world.upperBound.x, double{frame.x} + double{box.lowerBound.x},
              double{frame.x} + double{box.upperBound.x});
        check(world.lowerBound.y, world.upperBound.y, double{frame.y} + double{box.lowerBound.y},
              double{frame.y} + double{box.upperBound.y});
    }));
}

TEST(FarPositions, ContactsCoverAllPairsThatOverlapExactly) {
    for (size_t kind = 0; kind < broadPhaseNames.size(); ++kind) {
        WorldDef def;
        def.gravity = {0, 0};
        def.broadPhase = static_cast<BroadPhaseKind>(kind);
        World world(def);
        std::vector<Exact> places;
        uint32_t state = 7;
        const auto next = [&state] {
            state = state * 1664525u + 1013904223u;
            return double{static_cast<float>(state >> 8)} / 16777216.0;
        };
        for (int i = 0; i < 150; ++i) {
            const Exact at{3e6 + 8.0 * next(), -5e6 + 8.0 * next()};
            const BodyDef one = DefAt(at.x, at.y);
            AddCircle(world.CreateBody(&one), 0.25f);
            places.push_back(at);
        }
        world.Step(0.0f, 8, 3);
        world.Step(0.0f, 8, 3);
        std::set<std::pair<int, int>> found, touching;
        for (Contact* c = world.GetContactList(); c; c = c->GetNext()) {
            const int a = c->GetFixtureA()->GetBody()->GetIndex(), b = c->GetFixtureB()->GetBody()->GetIndex();
            found.insert(std::minmax(a, b));
            if (c->IsTouching()) touching.insert(std::minmax(a, b));
        }
        int overlaps = 0;
        for (int a = 0; a < 150; ++a) {
            for (int b = a + 1; b < 150; ++b) {
                const Exact p = places[static_cast<size_t>(a)], q = places[static_cast<size_t>(b)];
                const double apart = std::hypot(p.x - q.x, p.y - q.y);
                if (std::max(std::abs(p.x - q.x), std::abs(p.y - q.y)) < 0.5) {
                    EXPECT_TRUE(found.contains({a, b})) << broadPhaseNames[kind];
                }
                overlaps += apart < 0.5 ? 1 : 0;
                if (std::abs(apart - 0.5) > 1e-6) {
                    EXPECT_EQ(touching.contains({a, b}), apart < 0.5) << broadPhaseNames[kind];
                }
            }
        }
        EXPECT_GT(overlaps, 50);
    }
}

TEST(FarPositions, BodiesAreWhereTheyWerePut) {
    World world({0, -10});
    const BodyDef def = DefAt(1e7 + 0.123456, -3e6 + 0.654321);
    Body* body = world.CreateBody(&def);
    ExpectAt({1e7 + 0.123456, -3e6 + 0.654321}, OriginOf(*body), 1e-7);
    // Fixtures off the origin move the centre and leave the body where it is.
    PolygonShape box;
    box.SetAsBox(0.5f, 0.25f, {0.3f, -0.2f}, 0.0f);
    body->CreateFixture(&box, 1.0f);
    ExpectAt({1e7 + 0.123456, -3e6 + 0.654321}, OriginOf(*body), 1e-6);
    ExpectAt({1e7 + 0.423456, -3e6 + 0.454321}, CentreOf(*body), 1e-6);
    const Exact before = OriginOf(*body);
    body->SetType(staticBody);
    ExpectAt(before, CentreOf(*body), 1e-6);
    body->SetType(dynamicBody);
    ExpectAt({before.x + 0.3, before.y - 0.2}, CentreOf(*body), 1e-6);
    EXPECT_EQ(body->SetTransform({-2e6f, 7.0f}, 0.5f * pi, {0.0625f, 1e-4f}), ErrorCode::ok);
    ExpectAt({-2e6 + 0.0625, 7.0001}, OriginOf(*body), 1e-6);
    ExpectAt({-2e6 + 0.0625 + 0.2, 7.3001}, CentreOf(*body), 1e-6);
    EXPECT_EQ(body->SetTransform({5.0f, 7.0f}, 0.0f), ErrorCode::ok);
    ExpectAt({5.0, 7.0}, OriginOf(*body), 1e-6);
}

TEST(FarPositions, AMassMovesTheCentreAlone) {
    EXPECT_TRUE(rc::check("the origin stays to the last bit", [] {
        World world({0, 0});
        const BodyDef far = DefAt(1e7, 0.0);  // from here on all positions have rests
        world.CreateBody(&far);
        const auto place = [] { return double{AnyFloat()} + double{AnyFloat()} / 1024.0; };
        const BodyDef def = DefAt(place(), place());
        Body* body = world.CreateBody(&def);
        for (int i = 0; i < 8; ++i) {
            const float angle = AnyFloat() / 256.0f;
            if (i % 2 == 1)
                RC_ASSERT(body->SetTransform(body->GetPosition(), angle, body->GetPositionRest()) == ErrorCode::ok);
            const Vec2 origin = body->GetPosition();
            const Exact exact = OriginOf(*body);
            const Vec2 center{AnyFloat() / 1024.0f, AnyFloat() / 1024.0f};
            MassData mass{1.0f, center, 1.0f + center.LengthSquared()};
            body->SetMassData(&mass);
            RC_ASSERT(body->GetPosition() == origin);
            const double digit = 1e-6 * (1.0 + double{center.Length()});
            RC_ASSERT(std::hypot(OriginOf(*body).x - exact.x, OriginOf(*body).y - exact.y) < digit);
            const Vec2 arm = Mul(body->GetTransform().q, center);
            const Exact centre = CentreOf(*body);
            RC_ASSERT(std::hypot(centre.x - exact.x - double{arm.x}, centre.y - exact.y - double{arm.y}) < digit);
        }
    }));
}

TEST(FarPositions, AreThereOnceABodyIsFar) {
    World world({0, 0});
    world.SetAllowSleeping(false);
    Body* body = AddBody(world, dynamicBody, {2000, 0});
    AddBox(body, 0.5f, 0.5f);
    const size_t plain = inspect::GetMemoryUse(world).bytesPerBody;
    body->SetLinearVelocity({600, 0});
    StepFor(world, 1);
    EXPECT_EQ(inspect::GetMemoryUse(world).bytesPerBody, plain);
    StepFor(world, 5);
    EXPECT_EQ(inspect::GetMemoryUse(world).bytesPerBody, plain + 16u);
    body->SetLinearVelocity({1e-6f, 0});
    const Exact start = CentreOf(*body);
    StepFor(world, 60);
    EXPECT_NEAR(CentreOf(*body).x - start.x, 1e-6, 1e-8);
}

TEST(FarPositions, ShiftingTheOriginKeepsTheRests) {
    for (const float there : {5e6f, 12345.6f, 3.3f}) {
        WorldDef settings;
        if (there < 1000.0f) settings.farDistance = 0.0f;
        World world(settings);
        const BodyDef def = DefAt(1.1, 0.7);
        Body* body = world.CreateBody(&def);
        AddBox(body, 0.5f, 0.5f);
        StepFor(world, 3);
        const Exact before = CentreOf(*body);
        ASSERT_EQ(world.ShiftOrigin({-there, 2.0f * there}), ErrorCode::ok);
        const double digit = std::ldexp(1.0 + double{there}, -46);  // what two floats cannot hold
        ExpectAt({before.x + double{there}, before.y - 2.0 * double{there}}, CentreOf(*body), digit);
        ASSERT_EQ(world.ShiftOrigin({there, -2.0f * there}), ErrorCode::ok);
        ExpectAt(before, CentreOf(*body), 2.0 * digit);
    }
}

TEST(FarPositions, BadInputIsNamed) {
    World world({0, -10});
    ErrorLog errors(world);
    Body* body = AddBody(world, dynamicBody, {1, 2});
    const uint64_t before = inspect::GetStateHash(world);
    EXPECT_EQ(body->SetTransform({0, 0}, 0, {nan, 0}), ErrorCode::nonFinite);
    EXPECT_STREQ(errors.last.field, "positionRest");
    BodyDef def;
    def.positionRest = {0, INFINITY};
    EXPECT_EQ(world.CreateBody(&def), nullptr);
    EXPECT_STREQ(errors.last.field, "BodyDef::positionRest");
    EXPECT_EQ(errors.count, 2);
    EXPECT_EQ(inspect::GetStateHash(world), before);
    EXPECT_EQ(inspect::GetMemoryUse(world).bytesPerBody, inspect::GetMemoryUse(World({0, -10})).bytesPerBody);
}

/// A pile at a far place, in the middle of something.
void BuildPile(World& world) {
    BodyDef def = DefAt(7e6 + 0.3, -1.0);
    def.type = staticBody;
    AddBox(world.CreateBody(&def), 20, 1);
    for (int i = 0; i < 60; ++i) {
        def = DefAt(7e6 + 1.1 * (i % 8) + 0.05 * i, 0.6 + 1.1 * (i / 8));
        AddBox(world.CreateBody(&def), 0.5f, 0.5f);
    }
}

TEST(FarPositions, AreSavedLoadedAndReplayed) {
    World world({0, -10});
    BuildPile(world);
    StepFor(world, 20);
    Recorder recorder;
    ASSERT_EQ(StartRecording(world, recorder), ErrorCode::ok);
    const BodyDef def = DefAt(7e6 + 3.21, 14.5);
    AddBox(world.CreateBody(&def), 0.5f, 0.5f);
    world.GetBodyList()->GetNext()->SetTransform({7e6f, 16.0f}, 0.0f, {0.21f, 1e-3f});
    for (int step = 0; step < 20; ++step) world.Step(1.0f / 60.0f, 4);
    StopRecording(world);
    const std::unique_ptr<World> loaded = LoadWorld(SaveWorld(world));
    ASSERT_NE(loaded, nullptr);
    EXPECT_EQ(inspect::GetStateHash(*loaded), inspect::GetStateHash(world));
    const ReplayReport replay = Replay(recorder.GetBytes());
    EXPECT_TRUE(replay.valid);
    ASSERT_NE(replay.world, nullptr);
    EXPECT_EQ(inspect::GetStateHash(*replay.world), inspect::GetStateHash(world));
    StepFor(world, 5);
    StepFor(*loaded, 5);
    EXPECT_EQ(inspect::GetStateHash(*loaded), inspect::GetStateHash(world));
}

TEST(FarPositions, DoNotDependOnThreads) {
    for (const bool soft : {false, true}) {
        uint64_t hashes[2];
        for (int workers = 1; workers <= 2; ++workers) {
            WorldDef def;
            def.workerCount = workers;
            World world(def);
            for (int copy = 0; copy < 6; ++copy) BuildPile(world);
            for (int step = 0; step < 15; ++step) StepWith(world, soft ? 4 : 0);
            hashes[workers - 1] = inspect::GetStateHash(world);
        }
        EXPECT_EQ(hashes[0], hashes[1]) << soft;
    }
}

TEST(FarPositions, TheHashSeesTheRest) {
    uint64_t hashes[2];
    for (int i = 0; i < 2; ++i) {
        World world({0, 0});
        const BodyDef def = DefAt(1e7 + 1e-5 * i, 0);
        world.CreateBody(&def);
        hashes[i] = inspect::GetStateHash(world);
    }
    EXPECT_NE(hashes[0], hashes[1]);
}

TEST(FarPositions, QueriesSeeShapesWhereTheyAre) {
    World world({0, 0});
    const BodyDef def = DefAt(1e6 + 0.03, 0.0);  // floats are 1/16 m apart there
    Fixture* fixture = AddCircle(world.CreateBody(&def), 0.5f);
    const Vec2 from{1e6f - 10, 0}, to{1e6f + 10, 0};
    const auto hit = world.RayCastClosest(from, to);
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(20.0 * double{hit->fraction}, 9.53, 1e-5);
    RayCastOutput output;
    ASSERT_TRUE(fixture->RayCast(&output, {from, to, 1.0f}));
    EXPECT_EQ(output.fraction, hit->fraction);
    EXPECT_TRUE(fixture->TestPoint({1e6f + 0.5f, 0}));
    EXPECT_FALSE(fixture->TestPoint({1e6f - 0.5f, 0}));
    int found = 0;
    world.QueryPoint({1e6f - 0.5f, 0}, [&](Fixture*) { return ++found, true; });
    EXPECT_EQ(found, 0);
    CircleShape probe;
    probe.m_radius = 0.5f;
    std::vector<ShapeHit> hits;
    world.ShapeCast(probe, {from, Rot(0.0f)}, to - from, hits);
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_NEAR(20.0 * double{hits[0].fraction}, 9.03, 0.011);  // a slop before the touch
    Body* body = fixture->GetBody();
    EXPECT_NEAR(body->GetLocalPoint({1e6f, 0}).x, -0.03f, 1e-6f);
    body->ApplyLinearImpulse({0, 1}, {1e6f, 0}, true);
    EXPECT_NEAR(body->GetAngularVelocity() * body->GetInertia(), -0.03f, 1e-5f);
}

TEST(FarPositions, ManifoldsAndJointsTellOfTheRest) {
    World world({0, 0});
    const BodyDef left = DefAt(1e7 + 0.2, 0), right = DefAt(1e7 + 1.1, 0);
    Body* a = world.CreateBody(&left);
    Body* b = world.CreateBody(&right);
    AddCircle(a, 0.5f);
    AddCircle(b, 0.5f);
    world.Step(0.0f, 8, 3);
    world.Step(0.0f, 8, 3);
    WorldManifold manifold;
    ASSERT_NE(world.GetContactList(), nullptr);
    world.GetContactList()->GetWorldManifold(&manifold);
    EXPECT_NEAR(manifold.separations[0], -0.1f, 1e-6f);
    EXPECT_EQ(manifold.points[0], (Vec2{1e7f + 1, 0}));
    EXPECT_NEAR(world.MeasureErrors().overlap, 0.1f, 1e-6f);
    DistanceJointDef rod;
    rod.bodyA = a, rod.bodyB = b;
    rod.length = rod.minLength = rod.maxLength = 0.7f;
    EXPECT_NEAR(static_cast<DistanceJoint*>(world.CreateJoint(&rod))->GetCurrentLength(), 0.9f, 1e-6f);
    EXPECT_NEAR(world.MeasureErrors().jointGap, 0.2f, 1e-6f);
    MotorJointDef motor;
    motor.Initialize(a, b);
    EXPECT_NEAR(motor.linearOffset.x, 0.9f, 1e-6f);
    PulleyJointDef pulley;
    pulley.bodyA = a, pulley.bodyB = b;
    pulley.groundAnchorA = pulley.groundAnchorB = {1e7f, 0};
    pulley.localAnchorA = pulley.localAnchorB = {0, 0};
    const auto* ropes = static_cast<PulleyJoint*>(world.CreateJoint(&pulley));
    EXPECT_NEAR(ropes->GetCurrentLengthA(), 0.2f, 1e-6f);
    EXPECT_NEAR(ropes->GetCurrentLengthB(), 1.1f, 1e-6f);
}

}  // namespace
}  // namespace scree::test
