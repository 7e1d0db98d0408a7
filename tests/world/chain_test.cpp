// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Chains: the edges they make, what belongs to a chain, and that bodies slide over seams as over one surface.

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/world/engines.h"
#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

const Vec2 square[4] = {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}};

TEST(Chain, LoopMakesOneEdgePerVertexWithItsNeighboursAsGhosts) {
    World world({0, 0});
    Body* body = AddBody(world, staticBody, {0, 0});
    ChainShape chain;
    ASSERT_TRUE(chain.CreateLoop(square, 4));
    Fixture* first = body->CreateFixture(&chain, 1.0f);
    ASSERT_NE(first, nullptr);
    EXPECT_EQ(first->GetChainIndex(), 0);
    EXPECT_EQ(world.GetFixtureCount(), 4);
    int index = 3;  // the list has the newest first
    for (Fixture* f = body->GetFixtureList(); f; f = f->GetNext(), --index) {
        EXPECT_EQ(f->GetChainId(), first->GetChainId());
        EXPECT_EQ(f->GetChainIndex(), index);
        ASSERT_EQ(f->GetType(), Shape::e_edge);
        const auto& edge = static_cast<const EdgeShape&>(*f->GetShape());
        EXPECT_TRUE(edge.m_oneSided);
        EXPECT_EQ(edge.m_vertex0, square[(index + 3) % 4]);
        EXPECT_EQ(edge.m_vertex1, square[index]);
        EXPECT_EQ(edge.m_vertex2, square[(index + 1) % 4]);
        EXPECT_EQ(edge.m_vertex3, square[(index + 2) % 4]);
    }
    EXPECT_FLOAT_EQ(body->GetMass(), 0.0f);
}

TEST(Chain, EdgesAreBox2DsChildEdges) {
    const b2Vec2 points[5] = {{0, 0}, {1, 0.5f}, {2, 0}, {4, 1}, {5, -1}};
    b2ChainShape theirs;
    theirs.CreateChain(points, 5, {-1, 0}, {6, 6});
    Vec2 same[5];
    for (int i = 0; i < 5; ++i) same[i] = {points[i].x, points[i].y};
    ChainShape ours;
    ASSERT_TRUE(ours.CreateChain(same, 5, {-1, 0}, {6, 6}));
    ASSERT_EQ(ours.GetChildCount(), theirs.GetChildCount());
    for (int i = 0; i < ours.GetChildCount(); ++i) {
        EdgeShape a;
        b2EdgeShape b;
        ours.GetChildEdge(&a, i);
        theirs.GetChildEdge(&b, i);
        const auto expectEqual = [&](Vec2 p, b2Vec2 q) {
            EXPECT_EQ(p.x, q.x) << i;
            EXPECT_EQ(p.y, q.y) << i;
        };
        expectEqual(a.m_vertex0, b.m_vertex0);
        expectEqual(a.m_vertex1, b.m_vertex1);
        expectEqual(a.m_vertex2, b.m_vertex2);
        expectEqual(a.m_vertex3, b.m_vertex3);
        EXPECT_EQ(a.m_radius, b.m_radius);
    }
}

TEST(Chain, MaterialFilterAndSensorAreEachEdgesOwn) {
    World world({0, 0});
    Body* body = AddBody(world, staticBody, {0, 0});
    ChainShape chain;
    ASSERT_TRUE(chain.CreateLoop(square, 4));
    FixtureDef def;
    def.shape = &chain;
    def.friction = 0.7f;
    def.restitution = 0.3f;
    def.isSensor = true;
    def.filter.categoryBits = 4;
    def.userData.pointer = 99;
    Fixture* first = body->CreateFixture(&def);
    for (Fixture* f = body->GetFixtureList(); f; f = f->GetNext()) {
        EXPECT_EQ(f->GetFriction(), 0.7f);
        EXPECT_EQ(f->GetRestitution(), 0.3f);
        EXPECT_TRUE(f->IsSensor());
        EXPECT_EQ(f->GetFilterData().categoryBits, 4);
        EXPECT_EQ(f->GetUserData().pointer, 99u);
    }
    first->SetFriction(0.1f);
    EXPECT_EQ(body->GetFixtureList()->GetFriction(), 0.7f);
}

TEST(Chain, DestroyChainTakesItsEdgesAndNoOthers) {
    World world({0, -10});
    Body* body = AddBody(world, staticBody, {0, 0});
    AddCircle(body, 1.0f);
    ChainShape chain;
    ASSERT_TRUE(chain.CreateLoop(square, 4));
    Fixture* first = body->CreateFixture(&chain, 0.0f);
    Fixture* second = body->CreateFixture(&chain, 0.0f);
    AddCircle(body, 0.5f);
    EXPECT_NE(first->GetChainId(), second->GetChainId());
    Body* ball = AddBody(world, dynamicBody, {0, 2.5f});
    AddCircle(ball, 0.5f);
    StepFor(world, 3);
    EXPECT_EQ(ball->GetContactCount(), 2);
    const FixtureId id = world.GetId(first);
    EXPECT_EQ(body->DestroyChain(second->GetNext()),
              ErrorCode::ok);  // any edge names it; this one is of the first chain
    EXPECT_EQ(world.Find(id), nullptr);
    EXPECT_EQ(world.GetFixtureCount(), 1 + 1 + 4 + 1);
    EXPECT_EQ(world.GetProxyCount(), 7);
    EXPECT_EQ(ball->GetContactCount(), 1);
    for (Fixture* f = body->GetFixtureList(); f; f = f->GetNext()) {
        if (f->GetType() == Shape::e_edge) {
            EXPECT_EQ(f->GetChainId(), second->GetChainId());
        }
    }
    StepFor(world, 10);
    EXPECT_EQ(body->DestroyChain(second), ErrorCode::ok);
    EXPECT_EQ(world.GetFixtureCount(), 3);
}

TEST(Chain, BadVerticesAreRefusedAndLeaveTheChainAsItWas) {
    ChainShape chain;
    ASSERT_TRUE(chain.CreateLoop(square, 4));
    const Vec2 same[3] = {{0, 0}, {0, 0.001f}, {1, 0}};
    const Vec2 notFinite[3] = {{0, 0}, {nan, 1}, {1, 0}};
    const Vec2 closes[3] = {{0, 0}, {1, 0}, {0, 0}};
    EXPECT_FALSE(chain.CreateLoop(nullptr, 4));
    EXPECT_FALSE(chain.CreateLoop(square, 2));
    EXPECT_FALSE(chain.CreateLoop(same, 3));
    EXPECT_FALSE(chain.CreateLoop(notFinite, 3));
    EXPECT_FALSE(chain.CreateLoop(closes, 3));
    EXPECT_FALSE(chain.CreateChain(square, 1, {0, 0}, {0, 0}));
    EXPECT_FALSE(chain.CreateChain(same, 3, {0, 0}, {0, 0}));
    EXPECT_FALSE(chain.CreateChain(square, 4, {nan, 0}, {0, 0}));
    EXPECT_FALSE(chain.CreateChain(square, 4, {0, 0}, {0, nan}));
    EXPECT_EQ(chain.GetChildCount(), 4);
    chain.Clear();
    EXPECT_EQ(chain.GetChildCount(), 0);
}

TEST(Chain, RayMeetsTheNearestEdgeFromItsFrontOnly) {
    ChainShape chain;
    ASSERT_TRUE(chain.CreateLoop(square, 4));  // counter-clockwise: solid from outside
    Transform xf;
    xf.Set({10, 0}, 0);
    RayCastOutput out;
    ASSERT_TRUE(chain.RayCast(&out, {{0, 0}, {20, 0}, 1.0f}, xf));
    EXPECT_NEAR(out.fraction, 0.4f, 1e-6f);
    EXPECT_NEAR(out.normal.x, -1.0f, 1e-6f);
    ASSERT_FALSE(chain.RayCast(&out, {{10, 0}, {11, 0}, 1.0f}, xf));
    EXPECT_FALSE(chain.RayCast(&out, {{10, 0}, {20, 0}, 1.0f}, xf));  // from inside, the back of the edge
    AABB box;
    chain.ComputeAABB(&box, xf);
    EXPECT_NEAR(box.lowerBound.x, 8.0f - polygonRadius, 1e-6f);
    EXPECT_NEAR(box.upperBound.y, 2.0f + polygonRadius, 1e-6f);
    EXPECT_FALSE(chain.TestPoint(xf, {10, 0}));
}

/// Speed lost and largest hop of a body that slides without friction over a chain of `count` segments whose surface
/// follows y(x).
struct Slide {
    float slowest = 1e9f, fastest = 0.0f, highest = -1e9f;
};

template <class E>
Slide SlideAlong(bool circle, float (*height)(float), float pitch) {
    typename E::World world({0.0f, -10.0f});
    world.SetContinuousPhysics(false);
    typename E::Body* ground = MakeBody<E>(world, E::isStatic, 0, 0);
    std::vector<typename E::Vec> points;
    for (float x = 60.0f; x > -10.0f; x -= pitch) points.push_back({x, height(x)});  // leftwards: collides above
    typename E::Chain chain;
    E::MakeChain(chain, points.data(), static_cast<int>(points.size()), {points.front().x + pitch, points.front().y},
                 {points.back().x - pitch, points.back().y});
    typename E::FixtureDef def;
    def.shape = &chain;
    def.friction = 0.0f;
    ground->CreateFixture(&def);
    typename E::Body* body = MakeBody<E>(world, E::isDynamic, 0.05f, height(0) + 0.5f + (circle ? 0.01f : 0.02f));
    typename E::FixtureDef bodyDef;
    const auto ball = CircleOf<E>(0.5f);
    const auto box = BoxShape<E>(0.5f, 0.5f);
    bodyDef.shape = &ball;
    if (!circle) bodyDef.shape = &box;
    bodyDef.density = 1.0f;
    bodyDef.friction = 0.0f;
    body->CreateFixture(&bodyDef);
    body->SetLinearVelocity({5.0f, 0.0f});
    Slide result;
    for (int i = 0; i < 480 && body->GetPosition().x < 45.0f; ++i) {
        world.Step(1.0f / 60.0f, 8, 3);
        // What friction-free sliding keeps: kinetic and potential energy, as a speed at the height of the start.
        const auto v = body->GetLinearVelocity();
        const float energy = v.x * v.x + v.y * v.y + 20.0f * (body->GetPosition().y - height(0) - 0.5f);
        const float speed = std::sqrt(energy > 0.0f ? energy : 0.0f);
        result.slowest = std::min(result.slowest, speed);
        result.fastest = std::max(result.fastest, speed);
        result.highest = std::max(result.highest, body->GetPosition().y - height(body->GetPosition().x));
    }
    EXPECT_GT(body->GetPosition().x, 30.0f);
    return result;
}

float Flat(float) { return 0.0f; }
/// Curvature at most 0.5·0.15² = 0.011 1/m: at 5 m/s a body stays on the ground.
float Waves(float x) { return 0.5f * std::sin(0.15f * x); }

TEST(Chain, NothingCatchesAtTheSeamsOfAStraightChain) {
    for (const bool circle : {true, false}) {
        const Slide slide = SlideAlong<Ours>(circle, Flat, 0.37f);
        EXPECT_GT(slide.slowest, 5.0f * 0.999f) << circle;  // no seam takes speed
        EXPECT_LT(slide.fastest, 5.0f * 1.01f) << circle;   // the drop onto the surface
        EXPECT_LT(slide.highest, 0.5f + 0.025f) << circle;  // and none throws it up: skins and slop only
    }
}

TEST(Chain, NothingCatchesAtTheSeamsOfAGentlyCurvedChain) {
    for (const bool circle : {true, false}) {
        const Slide ours = SlideAlong<Ours>(circle, Waves, 0.5f);
        const Slide theirs = SlideAlong<Theirs>(circle, Waves, 0.5f);
        // Every bend of a polyline takes some speed; never more than in Box2D, by 1 %.
        EXPECT_GT(ours.slowest, theirs.slowest * 0.99f) << circle;
        EXPECT_LT(ours.highest, theirs.highest + 0.01f) << circle;
        EXPECT_GT(ours.slowest, 5.0f * 0.9f) << circle;
    }
}

}  // namespace
}  // namespace scree::test
