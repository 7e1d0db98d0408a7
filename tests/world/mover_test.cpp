// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The mover: planes, their solution, and whole moves over level ground, slopes, steps, chains, platforms and into
// corners, in every direction of `up`.

#include "scree/mover.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <vector>

#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

Body* AddEdges(World& world, const std::vector<Vec2>& points) {
    Body* body = AddBody(world, staticBody, {0.0f, 0.0f});
    for (size_t i = 0; i + 1 < points.size(); ++i) {
        EdgeShape edge;
        edge.SetTwoSided(points[i], points[i + 1]);
        body->CreateFixture(&edge, 0.0f);
    }
    return body;
}

/// A mover that walks at a speed and falls when there is nothing below.
struct Walker {
    Walker(World& w, Vec2 position) : world(w) { state.position = position; }
    void Walk(float speed, int steps, float jump = 0.0f) {
        for (int i = 0; i < steps; ++i) {
            const Vec2 right = -1.0f * def.up.Skew();
            const float rise = Dot(state.velocity, def.up);
            const bool jumps = i == 0 && jump > 0.0f;
            state.velocity = speed * right + (state.isGrounded && !jumps ? 0.0f : rise - 10.0f * frame) * def.up;
            if (jumps) state.velocity = speed * right + jump * def.up;
            state = MoveMover(world, def, state, frame);
            ExpectApart();
        }
    }
    /// Not inside of anything.
    void ExpectApart() {
        std::vector<MoverPlane> planes;
        ASSERT_EQ(CollideMover(world, def.capsule, state.position, 0.0f, def.filter, planes), ErrorCode::ok);
        for (const MoverPlane& plane : planes) ASSERT_GE(plane.separation, -2e-3f) << state.position.x;
    }
    World& world;
    MoverDef def;
    MoverState state;
};

TEST(MoverPlanes, AreSolvedToTheNearestTranslation) {
    EXPECT_TRUE(rc::check("one to four planes", [] {
        const auto number = [](int most) { return 0.01f * static_cast<float>(*rc::gen::inRange(-most, most + 1)); };
        const Vec2 wish{number(100), number(100)};
        std::vector<MoverPlane> planes(*rc::gen::inRange<size_t>(1, 5));
        for (MoverPlane& plane : planes) {
            const float angle = number(314);
            plane = {nullptr,
                     {std::cos(angle), std::sin(angle)},
                     vec2Zero,
                     0.01f * static_cast<float>(*rc::gen::inRange(0, 50))};
        }
        for (const MoverPlane& a : planes)
            for (const MoverPlane& b : planes)
                RC_PRE(&a == &b || Dot(a.normal, b.normal) > 0.0f || std::abs(Cross(a.normal, b.normal)) > 0.1f);
        const Vec2 found = SolvePlanes(wish, planes);
        for (const MoverPlane& plane : planes) RC_ASSERT(Dot(plane.normal, found) + plane.separation >= -1e-4f);
        // What was pushed leads there.
        Vec2 pushed = wish;
        for (const MoverPlane& plane : planes) {
            RC_ASSERT(plane.push >= 0.0f);
            pushed += plane.push * plane.normal;
        }
        RC_ASSERT((pushed - found).Length() < 1e-4f * (1.0f + (found - wish).Length()));
        // No point of a fan around it that keeps out is nearer to the wish.
        for (int i = 0; i < 64; ++i) {
            const float angle = 2.0f * pi * static_cast<float>(i) / 64.0f;
            const Vec2 other = found + 0.02f * Vec2{std::cos(angle), std::sin(angle)};
            bool isOut = true;
            for (const MoverPlane& plane : planes) isOut = isOut && Dot(plane.normal, other) + plane.separation >= 0.0f;
            if (isOut) RC_ASSERT((other - wish).Length() >= (found - wish).Length() - 1e-3f);
        }
    }));
}

TEST(MoverPlanes, AreSolvedInASharpCorner) {
    MoverPlane planes[2]{};
    planes[0].normal = {std::cos(0.53f), std::sin(0.53f)};
    planes[1].normal = {std::cos(3.02f), std::sin(-3.02f)};
    const Vec2 found = SolvePlanes({-0.13f, -1.0f}, planes);
    EXPECT_NEAR(found.x, 0.0f, 1e-5f);
    EXPECT_NEAR(found.y, 0.0f, 1e-5f);
}

TEST(MoverPlanes, ThatLeaveNoRoomAreGivenWayToInTurn) {
    MoverPlane planes[2]{};
    planes[0].normal = {1.0f, 0.0f}, planes[0].separation = -0.1f;
    planes[1].normal = {-1.0f, 0.0f}, planes[1].separation = -0.1f;
    const Vec2 found = SolvePlanes({0.0f, 0.5f}, planes);
    EXPECT_LE(std::abs(found.x), 0.1f);
    EXPECT_EQ(found.y, 0.5f);
}

TEST(Mover, WalksOverLevelGroundAtItsSpeedInAnyDirectionOfUp) {
    for (const float turn : {0.0f, 1.0f, 2.5f, -1.7f}) {
        const Rot q(turn);
        World world({0.0f, 0.0f});
        AddEdges(world, {Mul(q, Vec2{-50.0f, 0.0f}), Mul(q, Vec2{50.0f, 0.0f})});
        Walker walker(world, Mul(q, Vec2{0.0f, 2.0f}));
        walker.def.up = Mul(q, Vec2{0.0f, 1.0f});
        for (Vec2* point : {&walker.def.capsule.point1, &walker.def.capsule.point2}) *point = Mul(q, *point);
        walker.Walk(0.0f, 90);
        ASSERT_TRUE(walker.state.isGrounded);
        const Vec2 start = MulT(q, walker.state.position);
        EXPECT_NEAR(start.y, 0.8f + walker.def.skin, 0.01f);
        walker.Walk(3.0f, 120);
        const Vec2 end = MulT(q, walker.state.position);
        EXPECT_NEAR(end.x - start.x, 6.0f, 0.01f) << turn;
        EXPECT_NEAR(end.y, start.y, 0.005f);
        EXPECT_TRUE(walker.state.isGrounded);
    }
}

TEST(Mover, GoesUpAndDownSlopesItCanStandOnAndStandsStill) {
    for (const float slope : {0.3f, 0.6f, 1.0f}) {
        World world({0.0f, 0.0f});
        const float height = 8.0f * std::tan(slope);
        AddEdges(world, {{-20.0f, 0.0f}, {2.0f, 0.0f}, {10.0f, height}, {14.0f, height}, {22.0f, 0.0f}, {50.0f, 0.0f}});
        Walker walker(world, {0.0f, 0.85f});
        walker.Walk(0.0f, 10);
        walker.Walk(2.0f, 180);
        if (slope > walker.def.maxSlope) {
            EXPECT_LT(walker.state.position.x, 2.6f) << slope;
            continue;
        }
        EXPECT_GT(walker.state.position.y, 1.5f) << slope;
        const Vec2 before = walker.state.position;
        walker.Walk(0.0f, 120);
        EXPECT_NEAR((walker.state.position - before).Length(), 0.0f, 0.01f) << "stands still on a slope " << slope;
        bool isAlwaysGrounded = true;
        for (int i = 0; i < 900; ++i) {
            walker.Walk(2.0f, 1);
            isAlwaysGrounded = isAlwaysGrounded && walker.state.isGrounded;
        }
        EXPECT_TRUE(isAlwaysGrounded) << "keeps to the ground downhill " << slope;
        EXPECT_GT(walker.state.position.x, 22.0f) << slope;
        EXPECT_NEAR(walker.state.position.y, 0.8f + walker.def.skin, 0.02f);
    }
}

TEST(Mover, GoesUpStepsUpToItsHeight) {
    for (const float height : {0.1f, 0.25f, 0.45f}) {
        World world({0.0f, 0.0f});
        AddEdges(world, {{-20.0f, 0.0f}, {50.0f, 0.0f}});
        for (int i = 0; i < 4; ++i) {
            const float top = height * static_cast<float>(i + 1);
            PolygonShape step;
            step.SetAsBox(10.0f, 0.5f * top, {12.0f + static_cast<float>(i), 0.5f * top}, 0.0f);
            AddBody(world, staticBody, {0.0f, 0.0f})->CreateFixture(&step, 0.0f);
        }
        Walker walker(world, {0.0f, 0.85f});
        walker.Walk(0.0f, 10);
        walker.Walk(2.0f, 300);
        if (height > walker.def.stepHeight) {
            EXPECT_NEAR(walker.state.position.x, 2.0f - 0.3f, 0.03f) << height;
        } else {
            EXPECT_GT(walker.state.position.x, 6.0f) << height;
            EXPECT_NEAR(walker.state.position.y, 4.0f * height + 0.81f, 0.02f) << height;
        }
    }
}

TEST(Mover, IsNotCaughtBySeamsOfAChain) {
    World world({0.0f, 0.0f});
    std::vector<Vec2> points;
    for (int i = 0; i <= 400; ++i)
        points.push_back({0.25f * static_cast<float>(400 - i), 0.3f * std::sin(0.05f * static_cast<float>(i))});
    ChainShape chain;
    ASSERT_TRUE(chain.CreateChain(points.data(), static_cast<int>(points.size()), points.front() + Vec2{1.0f, 0.0f},
                                  points.back() - Vec2{1.0f, 0.0f}));
    FixtureDef def;
    def.shape = &chain;
    AddBody(world, staticBody, {0.0f, 0.0f})->CreateFixture(&def);
    Walker walker(world, {2.0f, 1.6f});
    walker.Walk(0.0f, 60);
    ASSERT_TRUE(walker.state.isGrounded);
    for (int i = 0; i < 1200; ++i) {
        const float before = walker.state.position.x;
        walker.Walk(4.0f, 1);
        ASSERT_GT(walker.state.position.x - before, 0.7f * 4.0f * frame) << walker.state.position.x;
    }
}

TEST(Mover, RidesOnWhatMovesAndTakesItsSpeedAlong) {
    for (const Vec2 speed : {Vec2{2.0f, 0.0f}, Vec2{0.0f, 1.5f}, Vec2{-1.0f, -0.8f}}) {
        World world({0.0f, 0.0f});
        Body* lift = AddBody(world, kinematicBody, {0.0f, 0.0f});
        AddBox(lift, 3.0f, 0.25f);
        lift->SetLinearVelocity(speed);
        Walker walker(world, {0.0f, 1.1f});
        walker.Walk(0.0f, 5);
        ASSERT_TRUE(walker.state.isGrounded);
        const Vec2 start = walker.state.position - lift->GetPosition();
        for (int i = 0; i < 120; ++i) {
            walker.Walk(0.0f, 1);
            world.Step(frame, 4);
        }
        EXPECT_TRUE(walker.state.isGrounded);
        EXPECT_NEAR((walker.state.position - lift->GetPosition() - start).x, 0.0f, 0.05f);
        EXPECT_NEAR((walker.state.position - lift->GetPosition() - start).y, 0.0f, 0.05f);
        walker.Walk(0.0f, 1, 6.0f);
        EXPECT_FALSE(walker.state.isGrounded);
        EXPECT_NEAR(walker.state.velocity.x, speed.x, 0.05f);
        EXPECT_NEAR(walker.state.velocity.y, 6.0f + speed.y, 0.2f);
    }
}

TEST(Mover, StopsInCornersUnderCeilingsAndComesOutOfOverlaps) {
    World world({0.0f, 0.0f});
    AddEdges(world, {{-3.0f, 4.0f}, {-3.0f, 0.0f}, {5.0f, 0.0f}, {5.0f, 1.0f}, {3.0f, 2.4f}, {3.0f, 4.0f}});
    Walker walker(world, {0.0f, 0.85f});
    walker.Walk(0.0f, 5);
    walker.Walk(-5.0f, 120);
    EXPECT_NEAR(walker.state.position.x, -3.0f + 0.31f, 0.02f);
    walker.Walk(5.0f, 240);
    const Vec2 end = walker.state.position;
    walker.Walk(5.0f, 60);
    EXPECT_NEAR((walker.state.position - end).Length(), 0.0f, 0.01f) << "wedged under the slope";
    walker.Walk(0.0f, 1, 8.0f);
    walker.Walk(0.0f, 120);
    EXPECT_TRUE(walker.state.isGrounded);
    walker.state.position = {-2.9f, 0.7f};  // in the wall and in the floor
    for (int i = 0; i < 10; ++i) {
        walker.state.velocity = vec2Zero;
        walker.state = MoveMover(world, walker.def, walker.state, frame);
    }
    walker.ExpectApart();
}

TEST(Mover, SeesWhatItsFilterSees) {
    World world({0.0f, 0.0f});
    AddEdges(world, {{-20.0f, 0.0f}, {20.0f, 0.0f}});
    Body* own = AddBody(world, dynamicBody, {1.5f, 0.8f});
    AddBox(own, 0.3f, 0.7f);
    Body* sensor = AddBody(world, staticBody, {3.0f, 0.8f});
    AddBox(sensor, 0.3f, 0.7f)->SetSensor(true);
    Walker walker(world, {0.0f, 0.85f});
    walker.Walk(2.0f, 60);
    EXPECT_LT(walker.state.position.x, 1.0f);
    walker.def.filter.ignored = own;
    walker.Walk(2.0f, 180);
    EXPECT_GT(walker.state.position.x, 4.0f);
    int asked = 0;
    walker.def.filter.context = &asked;
    walker.def.filter.accepts = [](const Fixture* fixture, void* context) {
        ++*static_cast<int*>(context);
        return fixture->GetType() == Shape::e_edge;
    };
    walker.def.filter.ignored = nullptr;
    walker.Walk(-2.0f, 300);
    EXPECT_LT(walker.state.position.x, 0.0f);
    EXPECT_GT(asked, 0);
}

TEST(Mover, FindsTheSameWayInEveryBroadPhaseAndRefusesBadInput) {
    std::vector<Vec2> ends;
    for (size_t kind = 0; kind < broadPhaseNames.size(); ++kind) {
        WorldDef def;
        def.broadPhase = static_cast<BroadPhaseKind>(kind);
        World world(def);
        AddEdges(world, {{-20.0f, 0.0f}, {4.0f, 0.0f}, {8.0f, 2.0f}, {30.0f, 2.0f}});
        for (int i = 0; i < 20; ++i)
            AddBox(AddBody(world, staticBody, {0.9f * static_cast<float>(i), 0.1f}), 0.1f, 0.1f);
        world.Step(frame, 4);
        Walker walker(world, {0.0f, 1.2f});
        walker.Walk(2.0f, 240);
        ends.push_back(walker.state.position);
        EXPECT_TRUE(ends.back() == ends.front()) << broadPhaseNames[kind];
        ErrorLog errors(world);
        const MoverState before = walker.state;
        EXPECT_TRUE(MoveMover(world, walker.def, before, 0.0f).position == before.position);
        walker.def.maxSlope = 2.0f;
        EXPECT_TRUE(MoveMover(world, walker.def, before, frame).position == before.position);
        walker.def.maxSlope = 0.8f;
        walker.def.capsule.radius = -1.0f;
        EXPECT_TRUE(MoveMover(world, walker.def, before, frame).position == before.position);
        EXPECT_EQ(errors.count, 3);
    }
}

TEST(Mover, ComesAsNearAsItsMarginAllows) {
    const MoverCapsule capsule;
    for (const float margin : {0.0f, 0.004f, 0.01f, 0.1f}) {
        for (const bool isDisk : {false, true}) {
            World world({0.0f, 0.0f});
            Body* wall = AddBody(world, staticBody, {0.0f, 0.0f});
            isDisk ? AddCircle(wall, 1.0f) : AddBox(wall, 1.0f, 3.0f);
            for (const float gap : {0.001f, 0.006f, 0.009f, 0.0101f, 0.012f, 0.05f, 0.5f, 5.0f}) {
                const Vec2 start{-1.0f - capsule.radius - gap, -capsule.point1.y};  // a disk is met with an end
                const float way = 10.0f * CastMover(world, capsule, start, {10.0f, 0.0f}, margin, {});
                const float wanted = Max(gap - margin, 0.0f), most = Max(wanted, 0.5f * gap);
                EXPECT_LE(way, most + 0.003f) << "margin " << margin << ", gap " << gap;
                EXPECT_GE(way, wanted - 0.003f) << "margin " << margin << ", gap " << gap;
                EXPECT_LT(way, gap + 1e-5f) << "margin " << margin << ", gap " << gap;
            }
        }
    }
}

TEST(Mover, StandsOnTheGroundOfAnyLengthScale) {
    for (const float scale : {1.0f, 10.0f, 50.0f}) {
        for (const float speed : {0.0f, 5.0f, 20.0f, 60.0f}) {
            WorldDef def;
            def.lengthScale = scale;
            World world(def);
            AddGround(world, 100.0f * scale);
            MoverDef mover;
            mover.capsule.point1 = scale * mover.capsule.point1, mover.capsule.point2 = scale * mover.capsule.point2;
            mover.capsule.radius *= scale;
            MoverState state;
            state.position = {0.0f, mover.capsule.radius - mover.capsule.point1.y + 0.3f * scale};
            state.velocity = {0.0f, -speed * scale};
            for (int i = 0; i < 200; ++i) {
                if (!state.isGrounded) state.velocity.y -= 10.0f * scale * frame;
                state = MoveMover(world, mover, state, frame);
            }
            EXPECT_TRUE(state.isGrounded) << "scale " << scale << ", " << speed;
            EXPECT_GT(state.position.y, mover.capsule.radius - mover.capsule.point1.y) << "scale " << scale;
        }
    }
}

}  // namespace
}  // namespace scree::test
