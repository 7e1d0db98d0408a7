// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A scene's joint by the definitions that our engine and Box2D 2.4 have in common: one function per joint type fills
// that type's definition.

#pragma once

#include <cstddef>
#include <stdexcept>
#include <vector>

#include "scenes/scene.h"

namespace testbed {

/// Types has the engine's classes of worlds, bodies, joints and their definitions, and ToOwn for vectors.
template <typename Types>
class JointMaker {
    using World = typename Types::World;
    using Joint = typename Types::Joint;
    using Bodies = std::vector<typename Types::Body*>;
    using Joints = std::vector<Joint*>;
    using JointType = scenes::JointType;

public:
    /// Null if the world refuses it. `joints` holds those that a gear couples.
    static Joint* Create(World& world, const scenes::Joint& joint, const Bodies& bodies, const Joints& joints) {
        const auto create = [&world](const auto& def) { return world.CreateJoint(&def); };
        switch (joint.type) {
            case JointType::revolute:
                return create(MakeRevolute(joint, bodies));
            case JointType::distance:
                return create(MakeDistance(joint, bodies));
            case JointType::friction:
                return create(MakeFriction(joint, bodies));
            case JointType::gear:
                return create(MakeGear(joint, bodies, joints));
            case JointType::motor:
                return create(MakeMotor(joint, bodies));
            case JointType::mouse:
                return CreateMouse(world, joint, bodies);
            case JointType::prismatic:
                return create(MakePrismatic(joint, bodies));
            case JointType::pulley:
                return create(MakePulley(joint, bodies));
            case JointType::weld:
                return create(MakeWeld(joint, bodies));
            case JointType::wheel:
                return create(MakeWheel(joint, bodies));
        }
        throw std::invalid_argument("scene joint of unknown type");
    }

private:
    /// What the definitions of most types have.
    template <typename Def>
    static Def StartDef(const scenes::Joint& joint, const Bodies& bodies) {
        Def def;
        def.bodyA = bodies[static_cast<size_t>(joint.bodyA)];
        def.bodyB = bodies[static_cast<size_t>(joint.bodyB)];
        def.collideConnected = joint.collideConnected;
        return def;
    }

    template <typename Def>
    static Def StartAnchoredDef(const scenes::Joint& joint, const Bodies& bodies) {
        Def def = StartDef<Def>(joint, bodies);
        def.localAnchorA = Types::ToOwn(joint.localAnchorA);
        def.localAnchorB = Types::ToOwn(joint.localAnchorB);
        return def;
    }

    template <typename Def>
    static void SetSpring(Def& def, const scenes::Joint& joint) {
        def.stiffness = joint.stiffness;
        def.damping = joint.damping;
    }

    template <typename Def>
    static void SetSlider(Def& def, const scenes::Joint& joint) {
        def.localAxisA = Types::ToOwn(joint.localAxisA);
        def.enableLimit = joint.enableLimit;
        def.lowerTranslation = joint.lowerTranslation;
        def.upperTranslation = joint.upperTranslation;
        def.enableMotor = joint.enableMotor;
        def.motorSpeed = joint.motorSpeed;
    }

    static auto MakeRevolute(const scenes::Joint& joint, const Bodies& bodies) {
        auto def = StartAnchoredDef<typename Types::RevoluteDef>(joint, bodies);
        def.referenceAngle = joint.referenceAngle;
        def.enableLimit = joint.enableLimit;
        def.lowerAngle = joint.lowerAngle;
        def.upperAngle = joint.upperAngle;
        def.enableMotor = joint.enableMotor;
        def.motorSpeed = joint.motorSpeed;
        def.maxMotorTorque = joint.maxMotorTorque;
        return def;
    }

    static auto MakeDistance(const scenes::Joint& joint, const Bodies& bodies) {
        auto def = StartAnchoredDef<typename Types::DistanceDef>(joint, bodies);
        def.length = joint.length;
        def.minLength = joint.minLength;
        def.maxLength = joint.maxLength;
        SetSpring(def, joint);
        return def;
    }

    static auto MakeFriction(const scenes::Joint& joint, const Bodies& bodies) {
        auto def = StartAnchoredDef<typename Types::FrictionDef>(joint, bodies);
        def.maxForce = joint.maxForce;
        def.maxTorque = joint.maxTorque;
        return def;
    }

    static auto MakeMotor(const scenes::Joint& joint, const Bodies& bodies) {
        auto def = StartDef<typename Types::MotorDef>(joint, bodies);
        def.linearOffset = Types::ToOwn(joint.linearOffset);
        def.angularOffset = joint.angularOffset;
        def.maxForce = joint.maxForce;
        def.maxTorque = joint.maxTorque;
        def.correctionFactor = joint.correctionFactor;
        return def;
    }

    static auto MakePrismatic(const scenes::Joint& joint, const Bodies& bodies) {
        auto def = StartAnchoredDef<typename Types::PrismaticDef>(joint, bodies);
        def.referenceAngle = joint.referenceAngle;
        SetSlider(def, joint);
        def.maxMotorForce = joint.maxMotorForce;
        return def;
    }

    static auto MakePulley(const scenes::Joint& joint, const Bodies& bodies) {
        auto def = StartAnchoredDef<typename Types::PulleyDef>(joint, bodies);
        def.groundAnchorA = Types::ToOwn(joint.groundAnchorA);
        def.groundAnchorB = Types::ToOwn(joint.groundAnchorB);
        def.lengthA = joint.lengthA;
        def.lengthB = joint.lengthB;
        def.ratio = joint.ratio;
        return def;
    }

    static auto MakeWeld(const scenes::Joint& joint, const Bodies& bodies) {
        auto def = StartAnchoredDef<typename Types::WeldDef>(joint, bodies);
        def.referenceAngle = joint.referenceAngle;
        SetSpring(def, joint);
        return def;
    }

    static auto MakeWheel(const scenes::Joint& joint, const Bodies& bodies) {
        auto def = StartAnchoredDef<typename Types::WheelDef>(joint, bodies);
        SetSlider(def, joint);
        def.maxMotorTorque = joint.maxMotorTorque;
        SetSpring(def, joint);
        return def;
    }

    static auto MakeGear(const scenes::Joint& joint, const Bodies& bodies, const Joints& joints) {
        auto def = StartDef<typename Types::GearDef>(joint, bodies);
        def.joint1 = joints[static_cast<size_t>(joint.joint1)];
        def.joint2 = joints[static_cast<size_t>(joint.joint2)];
        def.ratio = joint.ratio;
        return def;
    }

    /// The engine grips the point of body B that lies on the target when the joint is made, so that comes first.
    static auto CreateMouse(World& world, const scenes::Joint& joint, const Bodies& bodies) {
        auto def = StartDef<typename Types::MouseDef>(joint, bodies);
        def.target = def.bodyB->GetWorldPoint(Types::ToOwn(joint.localAnchorB));
        def.maxForce = joint.maxForce;
        SetSpring(def, joint);
        auto* made = static_cast<typename Types::Mouse*>(world.CreateJoint(&def));
        made->SetTarget(Types::ToOwn(joint.target));
        return made;
    }
};

}  // namespace testbed
