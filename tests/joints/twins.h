// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One scene written once and built in both engines, stepped side by side: the largest differences of poses, velocities,
// joint values and reactions over all steps.

#pragma once

#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

#include "scree/scree.h"

namespace scree::test {

/// The same names for both engines.
struct Theirs {
    using World = b2World;
    using Body = b2Body;
    using BodyDef = b2BodyDef;
    using Joint = b2Joint;
    using Vec2 = b2Vec2;
    using PolygonShape = b2PolygonShape;
    using CircleShape = b2CircleShape;
    using DistanceJoint = b2DistanceJoint;
    using DistanceJointDef = b2DistanceJointDef;
    using FrictionJoint = b2FrictionJoint;
    using FrictionJointDef = b2FrictionJointDef;
    using GearJoint = b2GearJoint;
    using GearJointDef = b2GearJointDef;
    using MotorJoint = b2MotorJoint;
    using MotorJointDef = b2MotorJointDef;
    using MouseJoint = b2MouseJoint;
    using MouseJointDef = b2MouseJointDef;
    using PrismaticJoint = b2PrismaticJoint;
    using PrismaticJointDef = b2PrismaticJointDef;
    using PulleyJoint = b2PulleyJoint;
    using PulleyJointDef = b2PulleyJointDef;
    using RevoluteJoint = b2RevoluteJoint;
    using RevoluteJointDef = b2RevoluteJointDef;
    using WeldJoint = b2WeldJoint;
    using WeldJointDef = b2WeldJointDef;
    using WheelJoint = b2WheelJoint;
    using WheelJointDef = b2WheelJointDef;
    static constexpr b2BodyType dynamicBody = b2_dynamicBody, staticBody = b2_staticBody,
                                kinematicBody = b2_kinematicBody;
};

struct Ours {
    using World = scree::World;
    using Body = scree::Body;
    using BodyDef = scree::BodyDef;
    using Joint = scree::Joint;
    using Vec2 = scree::Vec2;
    using PolygonShape = scree::PolygonShape;
    using CircleShape = scree::CircleShape;
    using DistanceJoint = scree::DistanceJoint;
    using DistanceJointDef = scree::DistanceJointDef;
    using FrictionJoint = scree::FrictionJoint;
    using FrictionJointDef = scree::FrictionJointDef;
    using GearJoint = scree::GearJoint;
    using GearJointDef = scree::GearJointDef;
    using MotorJoint = scree::MotorJoint;
    using MotorJointDef = scree::MotorJointDef;
    using MouseJoint = scree::MouseJoint;
    using MouseJointDef = scree::MouseJointDef;
    using PrismaticJoint = scree::PrismaticJoint;
    using PrismaticJointDef = scree::PrismaticJointDef;
    using PulleyJoint = scree::PulleyJoint;
    using PulleyJointDef = scree::PulleyJointDef;
    using RevoluteJoint = scree::RevoluteJoint;
    using RevoluteJointDef = scree::RevoluteJointDef;
    using WeldJoint = scree::WeldJoint;
    using WeldJointDef = scree::WeldJointDef;
    using WheelJoint = scree::WheelJoint;
    using WheelJointDef = scree::WheelJointDef;
    static constexpr auto dynamicBody = scree::dynamicBody, staticBody = scree::staticBody,
                          kinematicBody = scree::kinematicBody;
};

/// One engine's half of a scene: a static body without fixtures, and whatever is added.
template <typename Engine>
struct Half : Engine {
    using E = Engine;
    using Point = typename Engine::Vec2;

    Half() : world(Point(0.0f, -10.0f)) {
        world.SetContinuousPhysics(false);
        typename Engine::BodyDef def;
        ground = world.CreateBody(&def);
    }

    typename Engine::Body* AddBox(float x, float y, float halfWidth, float halfHeight, float angle = 0.0f) {
        typename Engine::Body* body = AddBody(x, y, angle);
        typename Engine::PolygonShape shape;
        shape.SetAsBox(halfWidth, halfHeight);
        body->CreateFixture(&shape, 1.0f);
        return body;
    }
    /// Off the origin by (0.1, 0.05): the centre of mass is not where the body's position is.
    typename Engine::Body* AddLopsided(float x, float y, float halfWidth, float halfHeight, float angle = 0.0f) {
        typename Engine::Body* body = AddBody(x, y, angle);
        typename Engine::PolygonShape shape;
        shape.SetAsBox(halfWidth, halfHeight, Point(0.1f, 0.05f), 0.3f);
        body->CreateFixture(&shape, 1.0f);
        return body;
    }
    typename Engine::Body* AddDisk(float x, float y, float radius) {
        typename Engine::Body* body = AddBody(x, y, 0.0f);
        typename Engine::CircleShape shape;
        shape.m_radius = radius;
        body->CreateFixture(&shape, 1.0f);
        return body;
    }
    template <typename Def>
    auto* Join(Def& def) {
        return world.CreateJoint(&def);
    }

    typename Engine::World world;
    typename Engine::Body* ground;
    std::vector<typename Engine::Body*> bodies;

private:
    typename Engine::Body* AddBody(float x, float y, float angle) {
        typename Engine::BodyDef def;
        def.type = Engine::dynamicBody;
        def.position = Point(x, y);
        def.angle = angle;
        bodies.push_back(world.CreateBody(&def));
        return bodies.back();
    }
};

struct TwinOptions {
    int steps = 300;
    float dt = 1.0f / 60.0f;
    bool warmStarting = true;
    bool uneven = false;  ///< every third step is half as long, so that warm starting has to scale impulses
};

/// Largest differences over all steps and bodies.
struct Worst {
    float pose = 0.0f;      ///< m and rad
    float velocity = 0.0f;  ///< m/s and rad/s
    float value = 0.0f;     ///< of the joint's own values
    float reaction = 0.0f;  ///< of force and torque, as a share of the largest of the run (at least 1 N or N·m)
    int step = -1;          ///< first step with a pose difference above 1e-4
};

inline void Grow(float& worst, float difference) {
    worst = std::isfinite(difference) ? Max(worst, Abs(difference)) : std::numeric_limits<float>::infinity();
}

template <typename BodyA, typename BodyB>
void CompareBodies(const std::vector<BodyA*>& theirs, const std::vector<BodyB*>& ours, Worst& worst) {
    for (size_t i = 0; i < ours.size(); ++i) {
        const auto p = theirs[i]->GetPosition(), v = theirs[i]->GetLinearVelocity();
        Grow(worst.pose, Distance(ours[i]->GetPosition(), {p.x, p.y}));
        Grow(worst.pose, ours[i]->GetAngle() - theirs[i]->GetAngle());
        Grow(worst.velocity, Distance(ours[i]->GetLinearVelocity(), {v.x, v.y}));
        Grow(worst.velocity, ours[i]->GetAngularVelocity() - theirs[i]->GetAngularVelocity());
    }
}

/// build(half) → joint; edit(half, joint, step) before each step; values(joint) → numbers of this joint.
template <typename Build, typename Edit, typename Values>
Worst RunTwins(const TwinOptions& options, Build build, Edit edit, Values values) {
    Half<Theirs> theirs;
    Half<Ours> ours;
    auto* theirJoint = build(theirs);
    auto* ourJoint = build(ours);
    theirs.world.SetWarmStarting(options.warmStarting);
    ours.world.SetWarmStarting(options.warmStarting);
    const float inverseDt = 1.0f / options.dt;
    Worst worst;
    float largest = 1.0f, reaction = 0.0f;
    for (int step = 0; step < options.steps; ++step) {
        edit(theirs, theirJoint, step);
        edit(ours, ourJoint, step);
        const float dt = options.uneven && step % 3 == 0 ? 0.5f * options.dt : options.dt;
        theirs.world.Step(dt, 8, 3);
        ours.world.Step(dt, 8, 3);
        CompareBodies(theirs.bodies, ours.bodies, worst);
        const std::vector<float> a = values(theirJoint), b = values(ourJoint);
        for (size_t i = 0; i < a.size(); ++i) Grow(worst.value, a[i] - b[i]);
        const auto force = theirJoint->GetReactionForce(inverseDt);
        const float torque = theirJoint->GetReactionTorque(inverseDt);
        largest = Max(largest, Max(Vec2(force.x, force.y).Length(), Abs(torque)));
        Grow(reaction, Distance(ourJoint->GetReactionForce(inverseDt), {force.x, force.y}));
        Grow(reaction, ourJoint->GetReactionTorque(inverseDt) - torque);
        const auto anchorA = theirJoint->GetAnchorA(), anchorB = theirJoint->GetAnchorB();
        Grow(worst.pose, Distance(ourJoint->GetAnchorA(), {anchorA.x, anchorA.y}));
        Grow(worst.pose, Distance(ourJoint->GetAnchorB(), {anchorB.x, anchorB.y}));
        if (worst.step < 0 && worst.pose > 1e-4f) worst.step = step;
    }
    worst.reaction = reaction / largest;
    ::testing::Test::RecordProperty("pose", std::to_string(worst.pose * 1e6f) + "e-6");
    ::testing::Test::RecordProperty("velocity", std::to_string(worst.velocity * 1e6f) + "e-6");
    ::testing::Test::RecordProperty("value", std::to_string(worst.value * 1e6f) + "e-6");
    ::testing::Test::RecordProperty("reaction", std::to_string(worst.reaction * 1e6f) + "e-6");
    return worst;
}

/// Nothing to edit between steps.
inline constexpr auto untouched = [](auto&, auto*, int) {};

/// Both engines run the same mathematics in a different order of floating-point operations, and have different sine
/// routines. In a scene without chaos the last bits grow to some 1e-5 over 300 steps of speeds near 10 m/s.
inline void ExpectSame(const Worst& worst, float tolerance = 1e-4f) {
    EXPECT_LT(worst.pose, tolerance) << "first in step " << worst.step;
    EXPECT_LT(worst.velocity, 20.0f * tolerance);  // a pose error of 1e-4 may arise within a few steps of 1/60 s
    EXPECT_LT(worst.value, 20.0f * tolerance);
    EXPECT_LT(worst.reaction, 20.0f * tolerance);
}

}  // namespace scree::test
