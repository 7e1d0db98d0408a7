// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The same scenario for two engines: a template over the names of this library or of Box2D 2.4.1, so that what a
// program sees can be compared line by line.

#pragma once

#include <box2d/box2d.h>

#include <string>
#include <vector>

#include "scree/scree.h"

namespace scree::test {

struct Ours {
    using World = scree::World;
    using Vec = scree::Vec2;
    using Transform = scree::Transform;
    using Body = scree::Body;
    using BodyDef = scree::BodyDef;
    using BodyType = scree::BodyType;
    using Fixture = scree::Fixture;
    using FixtureDef = scree::FixtureDef;
    using Contact = scree::Contact;
    using ContactListener = scree::ContactListener;
    using ContactFilter = scree::ContactFilter;
    using ContactImpulse = scree::ContactImpulse;
    using DestructionListener = scree::DestructionListener;
    using Manifold = scree::Manifold;
    using Joint = scree::Joint;
    using RevoluteJointDef = scree::RevoluteJointDef;
    using DistanceJointDef = scree::DistanceJointDef;
    using PrismaticJointDef = scree::PrismaticJointDef;
    using WheelJointDef = scree::WheelJointDef;
    using PulleyJointDef = scree::PulleyJointDef;
    using MouseJointDef = scree::MouseJointDef;
    using WeldJointDef = scree::WeldJointDef;
    using FrictionJointDef = scree::FrictionJointDef;
    using MotorJointDef = scree::MotorJointDef;
    using Circle = scree::CircleShape;
    using Edge = scree::EdgeShape;
    using Polygon = scree::PolygonShape;
    using Chain = scree::ChainShape;
    using MassData = scree::MassData;
    using Draw = scree::Draw;
    using Color = scree::Color;
    using Aabb = scree::AABB;
    using RayCastCallback = scree::RayCastCallback;
    using QueryCallback = scree::QueryCallback;
    static constexpr BodyType isStatic = scree::staticBody, isKinematic = scree::kinematicBody,
                              isDynamic = scree::dynamicBody;
    static void MakeLoop(Chain& chain, const Vec* v, int n) { (void)chain.CreateLoop(v, n); }
    static void MakeChain(Chain& chain, const Vec* v, int n, Vec before, Vec after) {
        (void)chain.CreateChain(v, n, before, after);
    }
};

struct Theirs {
    using World = b2World;
    using Vec = b2Vec2;
    using Transform = b2Transform;
    using Body = b2Body;
    using BodyDef = b2BodyDef;
    using BodyType = b2BodyType;
    using Fixture = b2Fixture;
    using FixtureDef = b2FixtureDef;
    using Contact = b2Contact;
    using ContactListener = b2ContactListener;
    using ContactFilter = b2ContactFilter;
    using ContactImpulse = b2ContactImpulse;
    using DestructionListener = b2DestructionListener;
    using Manifold = b2Manifold;
    using Joint = b2Joint;
    using RevoluteJointDef = b2RevoluteJointDef;
    using DistanceJointDef = b2DistanceJointDef;
    using PrismaticJointDef = b2PrismaticJointDef;
    using WheelJointDef = b2WheelJointDef;
    using PulleyJointDef = b2PulleyJointDef;
    using MouseJointDef = b2MouseJointDef;
    using WeldJointDef = b2WeldJointDef;
    using FrictionJointDef = b2FrictionJointDef;
    using MotorJointDef = b2MotorJointDef;
    using Circle = b2CircleShape;
    using Edge = b2EdgeShape;
    using Polygon = b2PolygonShape;
    using Chain = b2ChainShape;
    using MassData = b2MassData;
    using Draw = b2Draw;
    using Color = b2Color;
    using Aabb = b2AABB;
    using RayCastCallback = b2RayCastCallback;
    using QueryCallback = b2QueryCallback;
    static constexpr BodyType isStatic = b2_staticBody, isKinematic = b2_kinematicBody, isDynamic = b2_dynamicBody;
    static void MakeLoop(Chain& chain, const Vec* v, int n) { chain.CreateLoop(v, n); }
    static void MakeChain(Chain& chain, const Vec* v, int n, Vec before, Vec after) {
        chain.CreateChain(v, n, before, after);
    }
};

using Log = std::vector<std::string>;

/// Writes a name on a fixture that exists.
inline void SetName(scree::Fixture* fixture, uintptr_t name) { fixture->SetUserData({name}); }
inline void SetName(b2Fixture* fixture, uintptr_t name) { fixture->GetUserData().pointer = name; }

/// A body whose fixtures carry `name`, so that logs of both engines can be compared.
template <class E>
typename E::Body* MakeBody(typename E::World& world, typename E::BodyType type, float x, float y, uintptr_t name = 0) {
    typename E::BodyDef def;
    def.type = type;
    def.position = {x, y};
    def.userData.pointer = name;
    return world.CreateBody(&def);
}

template <class E, class Shape>
typename E::Fixture* Attach(typename E::Body* body, const Shape& shape, float density = 1.0f, bool sensor = false) {
    typename E::FixtureDef def;
    def.shape = &shape;
    def.density = density;
    def.isSensor = sensor;
    def.userData.pointer = body->GetUserData().pointer;
    return body->CreateFixture(&def);
}

template <class E>
typename E::Polygon BoxShape(float hx, float hy) {
    typename E::Polygon shape;
    shape.SetAsBox(hx, hy);
    return shape;
}

template <class E>
typename E::Circle CircleOf(float radius) {
    typename E::Circle shape;
    shape.m_radius = radius;
    return shape;
}

template <class E>
typename E::Edge EdgeOf(typename E::Vec v1, typename E::Vec v2) {
    typename E::Edge shape;
    shape.SetTwoSided(v1, v2);
    return shape;
}

template <class World>
void StepTimes(World& world, int steps) {
    for (int i = 0; i < steps; ++i) world.Step(1.0f / 60.0f, 8, 3);
}

}  // namespace scree::test
