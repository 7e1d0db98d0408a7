// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of box2d_joint.h: one function per joint type fills that type's definition.

#include "testbed/engines/box2d_joint.h"

#include <box2d/box2d.h>

#include <stdexcept>

#include "testbed/engines/box2d_shape.h"

namespace testbed {
namespace {

using scenes::JointType;

/// What the definitions of most types have.
template <typename Def>
Def StartDef(const scenes::Joint& joint, const Box2dBodies& bodies) {
    Def def;
    def.bodyA = bodies[static_cast<size_t>(joint.bodyA)];
    def.bodyB = bodies[static_cast<size_t>(joint.bodyB)];
    def.collideConnected = joint.collideConnected;
    return def;
}

template <typename Def>
Def StartAnchoredDef(const scenes::Joint& joint, const Box2dBodies& bodies) {
    Def def = StartDef<Def>(joint, bodies);
    def.localAnchorA = ToB2(joint.localAnchorA);
    def.localAnchorB = ToB2(joint.localAnchorB);
    return def;
}

template <typename Def>
void SetSpring(Def& def, const scenes::Joint& joint) {
    def.stiffness = joint.stiffness;
    def.damping = joint.damping;
}

template <typename Def>
void SetSlider(Def& def, const scenes::Joint& joint) {
    def.localAxisA = ToB2(joint.localAxisA);
    def.enableLimit = joint.enableLimit;
    def.lowerTranslation = joint.lowerTranslation;
    def.upperTranslation = joint.upperTranslation;
    def.enableMotor = joint.enableMotor;
    def.motorSpeed = joint.motorSpeed;
}

b2RevoluteJointDef MakeRevolute(const scenes::Joint& joint, const Box2dBodies& bodies) {
    auto def = StartAnchoredDef<b2RevoluteJointDef>(joint, bodies);
    def.referenceAngle = joint.referenceAngle;
    def.enableLimit = joint.enableLimit;
    def.lowerAngle = joint.lowerAngle;
    def.upperAngle = joint.upperAngle;
    def.enableMotor = joint.enableMotor;
    def.motorSpeed = joint.motorSpeed;
    def.maxMotorTorque = joint.maxMotorTorque;
    return def;
}

b2DistanceJointDef MakeDistance(const scenes::Joint& joint, const Box2dBodies& bodies) {
    auto def = StartAnchoredDef<b2DistanceJointDef>(joint, bodies);
    def.length = joint.length;
    def.minLength = joint.minLength;
    def.maxLength = joint.maxLength;
    SetSpring(def, joint);
    return def;
}

b2FrictionJointDef MakeFriction(const scenes::Joint& joint, const Box2dBodies& bodies) {
    auto def = StartAnchoredDef<b2FrictionJointDef>(joint, bodies);
    def.maxForce = joint.maxForce;
    def.maxTorque = joint.maxTorque;
    return def;
}

b2MotorJointDef MakeMotor(const scenes::Joint& joint, const Box2dBodies& bodies) {
    auto def = StartDef<b2MotorJointDef>(joint, bodies);
    def.linearOffset = ToB2(joint.linearOffset);
    def.angularOffset = joint.angularOffset;
    def.maxForce = joint.maxForce;
    def.maxTorque = joint.maxTorque;
    def.correctionFactor = joint.correctionFactor;
    return def;
}

b2PrismaticJointDef MakePrismatic(const scenes::Joint& joint, const Box2dBodies& bodies) {
    auto def = StartAnchoredDef<b2PrismaticJointDef>(joint, bodies);
    def.referenceAngle = joint.referenceAngle;
    SetSlider(def, joint);
    def.maxMotorForce = joint.maxMotorForce;
    return def;
}

b2PulleyJointDef MakePulley(const scenes::Joint& joint, const Box2dBodies& bodies) {
    auto def = StartAnchoredDef<b2PulleyJointDef>(joint, bodies);
    def.groundAnchorA = ToB2(joint.groundAnchorA);
    def.groundAnchorB = ToB2(joint.groundAnchorB);
    def.lengthA = joint.lengthA;
    def.lengthB = joint.lengthB;
    def.ratio = joint.ratio;
    return def;
}

b2WeldJointDef MakeWeld(const scenes::Joint& joint, const Box2dBodies& bodies) {
    auto def = StartAnchoredDef<b2WeldJointDef>(joint, bodies);
    def.referenceAngle = joint.referenceAngle;
    SetSpring(def, joint);
    return def;
}

b2WheelJointDef MakeWheel(const scenes::Joint& joint, const Box2dBodies& bodies) {
    auto def = StartAnchoredDef<b2WheelJointDef>(joint, bodies);
    SetSlider(def, joint);
    def.maxMotorTorque = joint.maxMotorTorque;
    SetSpring(def, joint);
    return def;
}

b2GearJointDef MakeGear(const scenes::Joint& joint, const Box2dBodies& bodies, const Box2dJoints& joints) {
    auto def = StartDef<b2GearJointDef>(joint, bodies);
    def.joint1 = joints[static_cast<size_t>(joint.joint1)];
    def.joint2 = joints[static_cast<size_t>(joint.joint2)];
    def.ratio = joint.ratio;
    return def;
}

/// The engine grips the point of body B that lies on the target when the joint is made, so that comes first.
b2Joint* CreateMouse(b2World& world, const scenes::Joint& joint, const Box2dBodies& bodies) {
    auto def = StartDef<b2MouseJointDef>(joint, bodies);
    def.target = def.bodyB->GetWorldPoint(ToB2(joint.localAnchorB));
    def.maxForce = joint.maxForce;
    SetSpring(def, joint);
    auto* made = static_cast<b2MouseJoint*>(world.CreateJoint(&def));
    made->SetTarget(ToB2(joint.target));
    return made;
}

}  // namespace

b2Joint* CreateBox2dJoint(b2World& world, const scenes::Joint& joint, const Box2dBodies& bodies,
                          const Box2dJoints& joints) {
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

}  // namespace testbed
