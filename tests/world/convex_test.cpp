// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Convex shapes in a world: they rest, roll, stack, stop at thin walls, wake sensors, are drawn and queried; bad
// descriptions are refused by name.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "scree/draw.h"
#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

Body* Add(World& world, const Shape& shape, Vec2 position, float angle = 0.0f, float density = 1.0f) {
    Body* body = AddBody(world, dynamicBody, position, angle);
    FixtureDef def;
    def.shape = &shape;
    def.density = density;
    def.friction = 0.6f;
    EXPECT_NE(body->CreateFixture(&def), nullptr);
    return body;
}

Body* AddThickGround(World& world, float angle = 0.0f) {
    Body* ground = AddBody(world, staticBody, {0.0f, 0.0f}, angle);
    PolygonShape box;
    box.SetAsBox(100.0f, 1.0f, {0.0f, -1.0f}, 0.0f);
    FixtureDef def;
    def.shape = &box;
    def.friction = 0.6f;
    ground->CreateFixture(&def);
    return ground;
}

int PointsOf(Body* body) {
    int points = 0;
    body->VisitContacts([&](Contact* contact) {
        if (contact->IsTouching()) points += contact->GetManifold().pointCount;
        return true;
    });
    return points;
}

float Power(float x, float exponent) { return std::pow(std::fabs(x), exponent); }

/// The support point of x⁴ + (2y)⁴ = 1.
Vec2 Superellipse(const void*, Vec2 d) {
    const float u = Power(d.x, 1.0f / 3.0f), v = Power(0.5f * d.y, 1.0f / 3.0f);
    const float scale = std::pow(u * u * u * u + v * v * v * v, -0.25f);
    return {std::copysign(u * scale, d.x), std::copysign(0.5f * v * scale, d.y)};
}

ConvexShape MakeSuper() { return MakeFromSupport({.support = Superellipse, .boundingRadius = 1.5f}); }

ConvexShape MakeRegular(int count, float radius) {
    std::vector<Vec2> points;
    for (int i = 0; i < count; ++i) {
        points.push_back(radius * Rot(2.0f * pi * static_cast<float>(i) / static_cast<float>(count)).GetXAxis());
    }
    return MakePolygon(points.data(), count);
}

constexpr Vec2 boxPoints[4] = {{-0.5f, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}};

TEST(ConvexWorld, APolygonOfFourRestsLikeABox) {
    World world({0.0f, -10.0f});
    AddThickGround(world);
    Body* twin = AddBody(world, dynamicBody, {-3.0f, 1.0f});
    AddBox(twin, 0.5f, 0.5f);
    Body* body = Add(world, MakePolygon(boxPoints, 4), {3.0f, 1.0f});
    StepFor(world, 300);
    EXPECT_FALSE(body->IsAwake());
    EXPECT_NEAR(body->GetPosition().y, twin->GetPosition().y, linearSlop);
    EXPECT_NEAR(body->GetAngle(), 0.0f, 1e-3f);
    EXPECT_EQ(PointsOf(body), 2);
}

TEST(ConvexWorld, ACapsuleRestsOnTwoPointsAndRollsDownAslope) {
    World world({0.0f, -10.0f});
    AddThickGround(world);
    Body* flat = Add(world, MakeCapsule({-0.5f, 0.0f}, {0.5f, 0.0f}, 0.25f), {0.0f, 2.0f}, 0.2f);
    StepFor(world, 400);
    EXPECT_EQ(PointsOf(flat), 2);
    EXPECT_FALSE(flat->IsAwake());
    EXPECT_NEAR(flat->GetPosition().y, 0.25f + polygonRadius, linearSlop);
    EXPECT_NEAR(flat->GetAngle(), 0.0f, 0.01f);

    // On end, its round cap is a disk of the same radius that carries more inertia: a = g sin α/(1 + I/(m r²)).
    World slope({0.0f, -10.0f});
    AddThickGround(slope, -0.2f);
    Body* disk = Add(slope, MakeCapsule({0.0f, 0.0f}, {0.0f, 0.0f}, 0.25f), {0.0f, 0.27f});
    StepFor(slope, 60);
    const float ideal = 10.0f * std::sin(0.2f) / 1.5f;
    EXPECT_NEAR(disk->GetLinearVelocity().Length(), ideal, 0.05f * ideal);
}

TEST(ConvexWorld, AnEllipseComesToRestOnItsLongSide) {
    World world({0.0f, -10.0f});
    AddThickGround(world);
    Body* body = Add(world, MakeEllipse(1.0f, 0.5f), {0.0f, 1.5f}, 1.2f);
    body->SetAngularDamping(1.0f);  // a free ellipse rocks for a long time
    StepFor(world, 1500);
    EXPECT_NEAR(std::remainder(body->GetAngle(), pi), 0.0f, 0.02f);
    EXPECT_NEAR(body->GetPosition().y, 0.5f + 2.0f * polygonRadius, 2.0f * linearSlop);
    EXPECT_EQ(PointsOf(body), 1);
    EXPECT_LT(body->GetLinearVelocity().Length(), 0.02f);
}

TEST(ConvexWorld, AnEllipseWithEqualAxesRollsLikeADisk) {
    // Constant speed: a polygon of 64 sides that rolled on its corners would lose a third of its energy in a turn.
    World world({0.0f, -10.0f});
    AddThickGround(world);
    Body* body = Add(world, MakeEllipse(0.5f, 0.5f), {-20.0f, 0.515f});
    body->SetLinearVelocity({4.0f, 0.0f});
    body->SetAngularVelocity(-8.0f);
    StepFor(world, 240);
    EXPECT_NEAR(body->GetLinearVelocity().x, 4.0f, 0.1f);
    EXPECT_NEAR(body->GetPosition().x, -4.0f, 0.5f);
    EXPECT_NEAR(body->GetPosition().y, 0.515f, 0.005f);
}

TEST(ConvexWorld, APolygonOf32SidesRolls) {
    World world({0.0f, -10.0f});
    AddThickGround(world, -0.3f);
    Body* body = Add(world, MakeRegular(32, 0.5f), {0.0f, 0.55f});
    StepFor(world, 120);
    EXPECT_LT(body->GetAngle(), -2.0f * pi);
    EXPECT_GT(body->GetPosition().x, 3.0f);
}

TEST(ConvexWorld, AStackOfRoundedBoxesStands) {
    for (const bool onEdge : {false, true}) {
        World world({0.0f, -10.0f});
        onEdge ? AddGround(world) : AddThickGround(world);
        constexpr Vec2 core[4] = {{-0.4f, -0.4f}, {0.4f, -0.4f}, {0.4f, 0.4f}, {-0.4f, 0.4f}};
        const ConvexShape shape = MakeRoundedPolygon(core, 4, 0.1f);
        std::vector<Body*> stack;
        for (int i = 0; i < 8; ++i) stack.push_back(Add(world, shape, {0.0f, 0.51f + 1.0f * static_cast<float>(i)}));
        StepFor(world, 300);
        for (size_t i = 0; i < stack.size(); ++i) {
            EXPECT_NEAR(stack[i]->GetPosition().x, 0.0f, 0.05f) << i;
            EXPECT_NEAR(stack[i]->GetPosition().y, 0.51f + static_cast<float>(i), 0.02f * static_cast<float>(i + 1));
            EXPECT_NEAR(stack[i]->GetAngle(), 0.0f, 0.02f) << i;
        }
        EXPECT_FALSE(stack[0]->IsAwake());
    }
}

TEST(ConvexWorld, ASectorAndAUserDefinedShapeFallAndRest) {
    World world({0.0f, -10.0f});
    AddGround(world);
    Body* sector = Add(world, MakeCircleSector(1.0f, 1.0f), {-4.0f, 2.0f});
    Body* super = Add(world, MakeSuper(), {4.0f, 1.0f}, 0.1f);
    super->SetAngularDamping(1.0f);
    StepFor(world, 900);
    EXPECT_FALSE(sector->IsAwake());
    EXPECT_EQ(PointsOf(sector), 2);  // on a straight side
    EXPECT_NEAR(super->GetPosition().y, 0.5f + 2.0f * polygonRadius, 2.0f * linearSlop);
    EXPECT_NEAR(super->GetAngle(), 0.0f, 0.05f);
    EXPECT_LT(super->GetLinearVelocity().Length(), 0.05f);
}

TEST(ConvexWorld, NothingCatchesAtTheSeamsOfAChain) {
    World world({0.0f, -10.0f});
    Body* ground = AddBody(world, staticBody, {0.0f, 0.0f});
    std::vector<Vec2> vertices;
    for (int i = 0; i <= 40; ++i) vertices.push_back({20.0f - static_cast<float>(i), 0.0f});
    ChainShape chain;
    ASSERT_TRUE(chain.CreateChain(vertices.data(), 41, {21.0f, 0.0f}, {-21.0f, 0.0f}));
    FixtureDef def;
    def.shape = &chain;
    def.friction = 0.0f;
    ground->CreateFixture(&def);
    const ConvexShape shapes[] = {MakePolygon(boxPoints, 4), MakeCapsule({-0.5f, 0.0f}, {0.5f, 0.0f}, 0.5f),
                                  MakeEllipse(0.5f, 0.5f), MakeRoundedPolygon(boxPoints, 4, 0.05f)};
    for (const ConvexShape& shape : shapes) {
        AABB box;
        shape.ComputeAABB(&box, Transform(vec2Zero, Rot(0.0f)));
        Body* body = Add(world, shape, {-15.0f, -box.lowerBound.y + 0.006f});
        body->SetLinearVelocity({5.0f, 0.0f});
        float highest = -1.0f;
        for (int i = 0; i < 300; ++i) {
            world.Step(frame, 8, 3);
            highest = Max(highest, std::fabs(body->GetLinearVelocity().y));
        }
        EXPECT_NEAR(body->GetLinearVelocity().x, 5.0f, 0.01f);
        EXPECT_LT(highest, 0.2f);
        world.DestroyBody(body);
    }
}

TEST(ConvexWorld, FastShapesDoNotCrossAThinWall) {
    const ConvexShape shapes[] = {MakeCapsule({-0.2f, 0.0f}, {0.2f, 0.0f}, 0.1f), MakeEllipse(0.3f, 0.1f),
                                  MakeRegular(32, 0.2f), MakeCircleSector(0.3f, 1.0f), MakeSuper()};
    for (const ConvexShape& shape : shapes) {
        for (const float speed : {60.0f, 150.0f, 400.0f}) {
            World world({0.0f, 0.0f});
            Body* wall = AddBody(world, staticBody, {5.0f, 0.0f});
            AddBox(wall, 0.01f, 10.0f);
            Body* body = Add(world, shape, {0.0f, 0.0f}, 0.3f);
            body->SetLinearVelocity({speed, 0.0f});
            body->SetAngularVelocity(20.0f);
            StepFor(world, 30);
            EXPECT_LT(body->GetPosition().x, 5.0f) << speed;
        }
    }
}

TEST(ConvexWorld, SensorsAndQueriesSeeConvexShapes) {
    World world({0.0f, 0.0f});
    Body* body = Add(world, MakeCapsule({-1.0f, 0.0f}, {1.0f, 0.0f}, 0.5f), {0.0f, 0.0f});
    Body* probe = AddBody(world, dynamicBody, {1.3f, 0.45f});
    const ConvexShape ellipse = MakeEllipse(0.2f, 0.1f);
    FixtureDef def;
    def.shape = &ellipse;
    def.isSensor = true;
    probe->CreateFixture(&def);
    StepFor(world, 1);
    ASSERT_EQ(probe->GetContactCount(), 1);
    EXPECT_TRUE(world.GetContactList()->IsTouching());

    const auto hit = world.RayCastClosest({0.0f, 5.0f}, {0.0f, -5.0f});
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->point.y, 0.5f, 1e-5f);
    int seen = 0;
    world.QueryPoint({-1.4f, 0.0f}, [&](Fixture* fixture) {
        seen += fixture->GetBody() == body ? 1 : 0;
        return true;
    });
    EXPECT_EQ(seen, 1);
    const auto cast = world.ShapeCastClosest(ellipse, Transform({0.0f, 5.0f}, Rot(0.0f)), {0.0f, -10.0f});
    ASSERT_TRUE(cast.has_value());
    EXPECT_NEAR(cast->point.y, 0.5f, 0.01f);
}

/// Counts what is drawn.
class ShapeCounter : public Draw {
public:
    void DrawPolygon(const Vec2*, int, const Color&) override {}
    void DrawSolidPolygon(const Vec2* vertices, int count, const Color&) override {
        ++polygons;
        for (int i = 0; i < count; ++i) right = Max(right, vertices[i].x);
    }
    void DrawCircle(const Vec2&, float, const Color&) override {}
    void DrawSolidCircle(const Vec2&, float, const Vec2&, const Color&) override { ++circles; }
    void DrawSegment(const Vec2&, const Vec2&, const Color&) override {}
    void DrawTransform(const Transform&) override {}
    void DrawPoint(const Vec2&, float, const Color&) override {}
    int polygons = 0, circles = 0;
    float right = -1.0f;
};

TEST(ConvexWorld, IsDrawnWithItsRoundEnds) {
    World world({0.0f, 0.0f});
    Add(world, MakeCapsule({-1.0f, 0.0f}, {1.0f, 0.0f}, 0.5f), {0.0f, 0.0f});
    Add(world, MakeCapsule({0.0f, 0.0f}, {0.0f, 0.0f}, 0.5f), {0.0f, 5.0f});
    Add(world, MakeRegular(64, 1.0f), {0.0f, -5.0f});
    ShapeCounter counter;
    counter.SetFlags(Draw::e_shapeBit);
    world.SetDebugDraw(&counter);
    world.DebugDraw();
    EXPECT_EQ(counter.polygons, 2);
    EXPECT_EQ(counter.circles, 1);
    EXPECT_NEAR(counter.right, 1.5f, 1e-3f);
}

TEST(ConvexWorld, TwoRunsAreTheSameBitForBit) {
    const auto run = [] {
        World world({0.0f, -10.0f});
        AddThickGround(world);
        const ConvexShape shapes[] = {MakeCapsule({-0.3f, 0.0f}, {0.3f, 0.0f}, 0.2f), MakeEllipse(0.6f, 0.3f),
                                      MakeCircleSector(0.6f, 2.0f), MakeRegular(12, 0.4f), MakeSuper()};
        for (int i = 0; i < 40; ++i) {
            Add(world, shapes[i % 5], {0.3f * static_cast<float>(i % 4), 1.0f + 0.9f * static_cast<float>(i)},
                0.37f * static_cast<float>(i));
        }
        StepFor(world, 400);
        for (Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
            EXPECT_TRUE(body->GetPosition().IsValid());
            if (body->GetType() == dynamicBody) {
                EXPECT_GT(body->GetPosition().y, 0.0f);
            }
        }
        return inspect::GetStateHash(world);
    };
    EXPECT_EQ(run(), run());
}

TEST(ConvexWorld, BadDescriptionsAreRefusedByName) {
    World world({0.0f, -10.0f});
    ErrorLog errors(world);
    Body* body = AddBody(world, dynamicBody, {0.0f, 0.0f});
    const auto expectRefused = [&](const ConvexShape& shape, const char* field) {
        const int before = errors.count;
        EXPECT_EQ(body->CreateFixture(&shape, 1.0f), nullptr) << field;
        EXPECT_EQ(errors.count, before + 1) << field;
        EXPECT_EQ(errors.last.code, ErrorCode::badShape) << field;
        EXPECT_STREQ(errors.last.field, field);
        EXPECT_EQ(world.GetFixtureCount(), 0);
    };
    const Vec2 line[3] = {{0.0f, 0.0f}, {1.0f, 0.0f}, {2.0f, 0.0f}};
    expectRefused(ConvexShape(), "ConvexShape::m_count");
    expectRefused(MakeCapsule({nan, 0.0f}, {1.0f, 0.0f}, 1.0f), "MakeCapsule::p1, p2");
    expectRefused(MakeCapsule({0.0f, 0.0f}, {1.0f, 0.0f}, 0.0f), "MakeCapsule::radius");
    expectRefused(MakePolygon(nullptr, 4), "MakePolygon::points");
    expectRefused(MakePolygon(boxPoints, 2), "MakePolygon::points");
    expectRefused(MakePolygon(boxPoints, 65), "MakePolygon::points");
    expectRefused(MakePolygon(line, 3), "MakePolygon::points");
    expectRefused(MakeRoundedPolygon(boxPoints, 4, -1.0f), "MakeRoundedPolygon::radius");
    expectRefused(MakeRoundedPolygon(line, 3, 1.0f), "MakeRoundedPolygon::points");
    expectRefused(MakeEllipse(-1.0f, 1.0f), "MakeEllipse::semiAxisX");
    expectRefused(MakeEllipse(1.0f, 0.0f), "MakeEllipse::semiAxisY");
    expectRefused(MakeEllipse(1.0f, nan), "MakeEllipse::semiAxisY");
    expectRefused(MakeEllipse(1.0f, 1.0f, {nan, 0.0f}), "MakeEllipse::center");
    expectRefused(MakeEllipse(1.0f, 1.0f, {0.0f, 0.0f}, nan), "MakeEllipse::angle");
    expectRefused(MakeCircleSector(0.0f, 1.0f), "MakeCircleSector::radius");
    expectRefused(MakeCircleSector(1.0f, 3.2f), "MakeCircleSector::opening");
    expectRefused(MakeCircleSector(1.0f, 1.0f, {nan, 0.0f}), "MakeCircleSector::apex");
    expectRefused(MakeFromSupport({}), "SupportDef::support");
    expectRefused(MakeFromSupport({.support = Superellipse}), "SupportDef::boundingRadius");
    expectRefused(MakeFromSupport({.support = Superellipse, .boundingRadius = 0.1f}), "SupportDef::support");
    // A function that reaches back instead of forth describes no convex shape.
    const auto inward = [](const void*, Vec2 d) { return -d; };
    expectRefused(MakeFromSupport({.support = inward, .boundingRadius = 2.0f}), "SupportDef::support");
    const auto badMass = [](const void*) { return MassData{nan, {0.0f, 0.0f}, 1.0f}; };
    expectRefused(MakeFromSupport({.support = Superellipse, .boundingRadius = 2.0f, .mass = badMass}),
                  "SupportDef::mass");
    ConvexShape bent = MakePolygon(boxPoints, 4);
    bent.m_vertices[2] = {0.3f, 0.0f};  // pushed in
    expectRefused(bent, "ConvexShape::m_vertices");
}

}  // namespace
}  // namespace scree::test
