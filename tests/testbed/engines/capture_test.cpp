// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Worlds that a program built for itself, with its own user data, as snapshots. Every object is there once, at its
// place. The shapes that were read back fill the boxes that the engine itself computes.

#include <box2d/box2d.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "scree/convex_shape.h"
#include "scree/pulley_joint.h"
#include "scree/revolute_joint.h"
#include "scree/world.h"
#include "testbed/engines/capture_box2d.h"
#include "testbed/engines/capture_scree.h"
#include "testbed/engines/state_hash.h"

namespace testbed {
namespace {

constexpr std::uintptr_t ownData = 4242;  // a program's own; a capture must not read it

struct ScreeTypes {
    using World = scree::World;
    using Vec = scree::Vec2;
    using BodyDef = scree::BodyDef;
    using FixtureDef = scree::FixtureDef;
    using Circle = scree::CircleShape;
    using Polygon = scree::PolygonShape;
    using Edge = scree::EdgeShape;
    using Chain = scree::ChainShape;
    using RevoluteDef = scree::RevoluteJointDef;
    using PulleyDef = scree::PulleyJointDef;
    static constexpr auto movingType = scree::dynamicBody;
    static void AddFurther(scree::Body& body, float size, scree::FixtureDef def) {
        const scree::ConvexShape capsule = scree::MakeCapsule({-size, 0}, {size, size}, 0.5f * size);
        def.shape = &capsule;
        body.CreateFixture(&def);
    }
};

struct Box2dTypes {
    using World = b2World;
    using Vec = b2Vec2;
    using BodyDef = b2BodyDef;
    using FixtureDef = b2FixtureDef;
    using Circle = b2CircleShape;
    using Polygon = b2PolygonShape;
    using Edge = b2EdgeShape;
    using Chain = b2ChainShape;
    using RevoluteDef = b2RevoluteJointDef;
    using PulleyDef = b2PulleyJointDef;
    static constexpr auto movingType = b2_dynamicBody;
    static void AddFurther(b2Body& body, float size, b2FixtureDef def) {
        b2PolygonShape box;
        box.SetAsBox(size, 0.5f * size);
        def.shape = &box;
        body.CreateFixture(&def);
    }
};

/// A chain as ground, an edge, and `count` bodies of all kinds of shapes above, two by two held by joints.
template <class T>
void Fill(typename T::World& world, int count, std::mt19937& random) {
    using Vec = typename T::Vec;
    std::uniform_real_distribution<float> place(-8.0f, 8.0f), size(0.2f, 0.6f), angle(-3.0f, 3.0f);
    typename T::FixtureDef def;
    def.density = 1.0f;
    def.userData.pointer = ownData;
    typename T::BodyDef groundDef;
    groundDef.userData.pointer = ownData;
    auto* ground = world.CreateBody(&groundDef);
    const Vec points[] = {Vec{10, 1}, Vec{3, 0}, Vec{-3, 0}, Vec{-10, 1}};
    typename T::Chain chain;
    (void)chain.CreateChain(points, 4, Vec{12, 3}, Vec{-12, 3});
    def.shape = &chain;
    ground->CreateFixture(&def);
    typename T::Edge edge;
    edge.SetTwoSided(Vec{-10, 1}, Vec{-10, 6});
    def.shape = &edge;
    ground->CreateFixture(&def);
    std::vector<decltype(ground)> bodies;
    for (int i = 0; i < count; ++i) {
        typename T::BodyDef bodyDef;
        bodyDef.type = T::movingType;
        bodyDef.position = Vec{place(random), 4.0f + 0.3f * static_cast<float>(i)};
        bodyDef.angle = angle(random);
        bodyDef.userData.pointer = ownData;
        auto* body = world.CreateBody(&bodyDef);
        const float s = size(random);
        typename T::Circle circle;
        circle.m_p = Vec{0.5f * s, 0};
        circle.m_radius = s;
        typename T::Polygon polygon;
        const Vec corners[] = {Vec{-s, -s}, Vec{s, -s}, Vec{0, s}};
        if (i % 2 == 0) {
            (void)polygon.Set(corners, 3);
        } else {
            polygon.SetAsBox(s, 0.7f * s, Vec{0.1f, 0}, 0.3f);
        }
        if (i % 3 != 1) def.shape = &circle, body->CreateFixture(&def);
        if (i % 3 != 2) def.shape = &polygon, body->CreateFixture(&def);
        if (i % 3 == 2) T::AddFurther(*body, s, def);
        bodies.push_back(body);
        if (i % 4 == 1) {
            typename T::RevoluteDef joint;
            joint.Initialize(bodies[bodies.size() - 2], body, body->GetPosition());
            world.CreateJoint(&joint);
        } else if (i % 4 == 3) {
            typename T::PulleyDef joint;
            auto* other = bodies[bodies.size() - 2];
            joint.Initialize(other, body, Vec{-1, 30}, Vec{1, 30}, other->GetPosition(), body->GetPosition(), 1.0f);
            world.CreateJoint(&joint);
        }
    }
}

/// The box of a fixture's shape as the snapshot tells it.
Box BoxOf(const FixtureState& fixture, const BodyState& body) {
    std::vector<Vec2> points(fixture.outline);
    float radius = 0;
    if (fixture.shape.type == scenes::ShapeType::circle) {
        points = {fixture.shape.center};
        radius = fixture.shape.radius;
    } else if (points.empty()) {
        const std::span<const Vec2> vertices = fixture.shape.Vertices();
        const bool isEdge = fixture.shape.type == scenes::ShapeType::edge;
        points.assign(vertices.begin(), isEdge ? vertices.begin() + 2 : vertices.end());
    }
    Box box{{1e9f, 1e9f}, {-1e9f, -1e9f}};
    for (const Vec2 p : points) {
        const float x = body.position.x + body.cos * p.x - body.sin * p.y;
        const float y = body.position.y + body.sin * p.x + body.cos * p.y;
        box.lower = {std::min(box.lower.x, x - radius), std::min(box.lower.y, y - radius)};
        box.upper = {std::max(box.upper.x, x + radius), std::max(box.upper.y, y + radius)};
    }
    return box;
}

template <class T>
void CheckCapture() {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    const int count = *rc::gen::inRange(4, 30);
    typename T::World world(typename T::Vec{0, -10});
    Fill<T>(world, count, random);
    for (int step = *rc::gen::inRange(1, 90); step > 0; --step) world.Step(1.0f / 60.0f, 8, 3);
    Snapshot s;
    s.scene = "mine";
    s.contacts.resize(3);
    Capture(world, s);
    RC_ASSERT(s.scene == "mine");
    RC_ASSERT(static_cast<int>(s.bodies.size()) == count + 1);
    RC_ASSERT(static_cast<int>(s.contacts.size()) == world.GetContactCount());
    RC_ASSERT(s.stateHash == HashState(s.bodies));
    RC_ASSERT(static_cast<int>(s.joints.size()) == world.GetJointCount());
    // The further shape has a fixture beside the circle; the ground has three edges of a chain and one of its own.
    RC_ASSERT(static_cast<int>(s.fixtures.size()) == 4 + count + (count + 2) / 3 + count / 3);
    RC_ASSERT(s.bodies.front().type == scenes::BodyType::isStatic);
    int leaves = 0;
    for (const NodeState& node : s.nodes) leaves += node.fixture >= 0;
    RC_ASSERT(leaves == static_cast<int>(s.fixtures.size()));
    for (int i = 0; i < 3; ++i) {
        RC_ASSERT(s.fixtures[static_cast<size_t>(i)].fixture == 0);
        RC_ASSERT(s.fixtures[static_cast<size_t>(i)].child == i);
    }
    const float slack = 0.03f;  // the skin on both sides, and the chords of a sampled outline
    for (const FixtureState& fixture : s.fixtures) {
        const Box box = BoxOf(fixture, s.bodies[static_cast<size_t>(fixture.body)]);
        RC_ASSERT(std::abs(box.lower.x - fixture.tight.lower.x) < slack);
        RC_ASSERT(std::abs(box.lower.y - fixture.tight.lower.y) < slack);
        RC_ASSERT(std::abs(box.upper.x - fixture.tight.upper.x) < slack);
        RC_ASSERT(std::abs(box.upper.y - fixture.tight.upper.y) < slack);
    }
    for (const ContactState& contact : s.contacts) {
        RC_ASSERT(contact.fixtureA >= 0 && contact.fixtureA < static_cast<int>(s.fixtures.size()));
        RC_ASSERT(contact.fixtureB >= 0 && contact.fixtureB < static_cast<int>(s.fixtures.size()));
        RC_ASSERT(s.fixtures[static_cast<size_t>(contact.fixtureA)].body !=
                  s.fixtures[static_cast<size_t>(contact.fixtureB)].body);
    }
    for (const JointState& joint : s.joints) {
        RC_ASSERT(joint.bodyB == joint.bodyA + 1);
        const bool isPulley = joint.type == scenes::JointType::pulley;
        RC_ASSERT(isPulley || joint.type == scenes::JointType::revolute);
        if (isPulley) RC_ASSERT((joint.groundAnchorA == Vec2{-1, 30} && joint.groundAnchorB == Vec2{1, 30}));
    }
}

TEST(Capture, AnyWorldOfOursIsReadBack) {
    EXPECT_TRUE(rc::check("our worlds", [] { CheckCapture<ScreeTypes>(); }));
}

TEST(Capture, AnyWorldOfBox2dIsReadBack) {
    EXPECT_TRUE(rc::check("Box2D's worlds", [] { CheckCapture<Box2dTypes>(); }));
}

}  // namespace
}  // namespace testbed
