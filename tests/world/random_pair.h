// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A pair of bodies, joined in any way, in any units.

#pragma once

#include <random>

#include "tests/world/fixtures.h"

namespace scree::test {

/// What numbers of 1 kg and 1 m are given as; powers of two change no digit of what follows.
struct Units {
    float mass = 1.0f, length = 1.0f;

    [[nodiscard]] float Force() const { return mass * length; }
    [[nodiscard]] float Torque() const { return Force() * length; }
};

/// Ten types of joints, a chain of two, and last no joint at all.
inline constexpr int kindsOfPairs = 12, alone = kindsOfPairs - 1;

/// Two boxes in the air. They collide only if they have no joint.
class RandomPair {
public:
    RandomPair(World& world, Body* ground, Units units, int kind, std::mt19937& random)
        : m_world(world), m_ground(ground), m_units(units), m_collides(kind == alone), m_random(random) {
        a = MakeBody({0.0f, 5.0f});
        b = MakeBody({Between(1.0f, 3.0f), 5.0f});
        joint = Join(kind);
    }

    Body *a, *b;
    Joint* joint;  ///< the last one made; null for those alone

private:
    float Between(float from, float to) { return std::uniform_real_distribution<float>(from, to)(m_random); }

    Body* MakeBody(Vec2 at) {
        BodyDef def;
        def.type = dynamicBody, def.position = m_units.length * at, def.angle = Between(-1.0f, 1.0f);
        const Vec2 velocity(Between(-3.0f, 3.0f), Between(-3.0f, 3.0f));
        def.linearVelocity = m_units.length * velocity, def.angularVelocity = Between(-3.0f, 3.0f);
        Body* const body = m_world.CreateBody(&def);
        PolygonShape shape;
        const Vec2 half(Between(0.2f, 1.0f), Between(0.2f, 1.0f));
        shape.SetAsBox(m_units.length * half.x, m_units.length * half.y);
        FixtureDef fixture;
        fixture.shape = &shape;
        fixture.density = Between(0.5f, 3.0f) * m_units.mass / (m_units.length * m_units.length);
        if (!m_collides) fixture.filter.maskBits = 0;
        body->CreateFixture(&fixture);
        return body;
    }

    RevoluteJoint* HingeToGround(Body* body) {
        RevoluteJointDef def;
        def.Initialize(m_ground, body, body->GetWorldCenter());
        return static_cast<RevoluteJoint*>(m_world.CreateJoint(&def));
    }

    /// Gives the definition random limits, motors and springs.
    template <typename Def>
    Joint* Make(Def def) {
        const Units& u = m_units;
        const auto coin = [&] { return m_random() % 2 == 0; };
        if constexpr (requires { def.maxForce; }) def.maxForce = Between(1.0f, 100.0f) * u.Force();
        if constexpr (requires { def.maxTorque; }) def.maxTorque = Between(1.0f, 100.0f) * u.Torque();
        if constexpr (requires { def.stiffness; }) {
            const bool isOfTurn = Def().type == e_weldJoint || Def().type == e_revoluteJoint;
            const float unit = coin() ? 0.0f : isOfTurn ? u.Torque() : u.mass;
            def.stiffness = Between(1.0f, 100.0f) * unit, def.damping = Between(0.0f, 5.0f) * unit;
        }
        if constexpr (requires { def.enableLimit; }) def.enableLimit = coin();
        if constexpr (requires { def.enableSpring; }) def.enableSpring = coin();
        if constexpr (requires { def.enableMotor; }) {
            const bool slides = Def().type == e_prismaticJoint;
            def.enableMotor = coin(), def.motorSpeed = Between(-3.0f, 3.0f) * (slides ? u.length : 1.0f);
        }
        if constexpr (requires { def.maxMotorTorque; }) def.maxMotorTorque = Between(1.0f, 100.0f) * u.Torque();
        if constexpr (requires { def.maxMotorForce; }) def.maxMotorForce = Between(1.0f, 100.0f) * u.Force();
        if constexpr (requires { def.lowerAngle; }) def.lowerAngle = -0.5f, def.upperAngle = 0.5f;
        if constexpr (requires { def.lowerTranslation; }) {
            def.lowerTranslation = -0.5f * u.length, def.upperTranslation = 0.5f * u.length;
        }
        return m_world.CreateJoint(&def);
    }
    template <typename Def, typename... Where>
    Joint* Initialised(Def def, Where... where) {
        def.Initialize(a, b, where...);
        return Make(def);
    }

    Joint* Join(int kind) {
        const Vec2 atA = a->GetWorldCenter(), atB = b->GetWorldCenter(), middle = 0.5f * (atA + atB);
        const Vec2 up(0.0f, 4.0f * m_units.length);
        switch (kind) {
            case 0:
                return Initialised(RevoluteJointDef(), middle);
            case 1:
                return Initialised(PrismaticJointDef(), middle, Vec2(1, 0));
            case 2:
                return Initialised(WheelJointDef(), middle, Vec2(0, 1));
            case 3:
                return Initialised(WeldJointDef(), middle);
            case 4:
                return Initialised(DistanceJointDef(), atA, atB);
            case 5:
                return Initialised(PulleyJointDef(), atA + up, atB + up, atA, atB, 1.0f);
            case 6:
                return Initialised(FrictionJointDef(), middle);
            case 7:
                return Initialised(MotorJointDef());
            case 8: {
                MouseJointDef def;
                def.bodyA = m_ground, def.bodyB = b, def.target = atB + up;
                return Make(def);
            }
            case 9: {
                GearJointDef def;
                def.bodyA = a, def.bodyB = b, def.joint1 = HingeToGround(a), def.joint2 = HingeToGround(b);
                def.ratio = 2.0f;
                return Make(def);
            }
            case 10: {
                HingeToGround(a);
                return Initialised(WeldJointDef(), middle);
            }
            default:
                return nullptr;
        }
    }

    World& m_world;
    Body* m_ground;
    Units m_units;
    bool m_collides;
    std::mt19937& m_random;
};

}  // namespace scree::test
