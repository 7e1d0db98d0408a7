// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of scree_joint.h: one function per joint type fills that type's definition.

#include "testbed/engines/scree_joint.h"

#include "scree/distance_joint.h"
#include "scree/friction_joint.h"
#include "scree/gear_joint.h"
#include "scree/motor_joint.h"
#include "scree/mouse_joint.h"
#include "scree/prismatic_joint.h"
#include "scree/pulley_joint.h"
#include "scree/revolute_joint.h"
#include "scree/weld_joint.h"
#include "scree/wheel_joint.h"

#include <stdexcept>

#include "testbed/engines/scree_shape.h"

namespace testbed {
namespace {

using scenes::JointType;

/// What the definitions of most types have.
template <typename Def>
Def StartDef(const scenes::Joint& joint, const ScreeBodies& bodies) {
    Def def;
    def.bodyA = bodies[static_cast<size_t>(joint.bodyA)];
    def.bodyB = bodies[static_cast<size_t>(joint.bodyB)];
    def.collideConnected = joint.collideConnected;
    return def;
}

template <typename Def>
Def StartAnchoredDef(const scenes::Joint& joint, const ScreeBodies& bodies) {
    Def def = StartDef<Def>(joint, bodies);
    def.localAnchorA = ToScree(joint.localAnchorA);
    def.localAnchorB = ToScree(joint.localAnchorB);
    return def;
}

template <typename Def>
void SetSpring(Def& def, const scenes::Joint& joint) {
    def.stiffness = joint.stiffness;
    def.damping = joint.damping;
}

template <typename Def>
void SetSlider(Def& def, const scenes::Joint& joint) {
    def.localAxisA = ToScree(joint.localAxisA);
    def.enableLimit = joint.enableLimit;
    def.lowerTranslation = joint.lowerTranslation;
    def.upperTranslation = joint.upperTranslation;
    def.enableMotor = joint.enableMotor;
    def.motorSpeed = joint.motorSpeed;
}

scree::RevoluteJointDef MakeRevolute(const scenes::Joint& joint, const ScreeBodies& bodies) {
    auto def = StartAnchoredDef<scree::RevoluteJointDef>(joint, bodies);
    def.referenceAngle = joint.referenceAngle;
    def.enableLimit = joint.enableLimit;
    def.lowerAngle = joint.lowerAngle;
    def.upperAngle = joint.upperAngle;
    def.enableMotor = joint.enableMotor;
    def.motorSpeed = joint.motorSpeed;
    def.maxMotorTorque = joint.maxMotorTorque;
    return def;
}

scree::DistanceJointDef MakeDistance(const scenes::Joint& joint, const ScreeBodies& bodies) {
    auto def = StartAnchoredDef<scree::DistanceJointDef>(joint, bodies);
    def.length = joint.length;
    def.minLength = joint.minLength;
    def.maxLength = joint.maxLength;
    SetSpring(def, joint);
    return def;
}

scree::FrictionJointDef MakeFriction(const scenes::Joint& joint, const ScreeBodies& bodies) {
    auto def = StartAnchoredDef<scree::FrictionJointDef>(joint, bodies);
    def.maxForce = joint.maxForce;
    def.maxTorque = joint.maxTorque;
    return def;
}

scree::MotorJointDef MakeMotor(const scenes::Joint& joint, const ScreeBodies& bodies) {
    auto def = StartDef<scree::MotorJointDef>(joint, bodies);
    def.linearOffset = ToScree(joint.linearOffset);
    def.angularOffset = joint.angularOffset;
    def.maxForce = joint.maxForce;
    def.maxTorque = joint.maxTorque;
    def.correctionFactor = joint.correctionFactor;
    return def;
}

scree::PrismaticJointDef MakePrismatic(const scenes::Joint& joint, const ScreeBodies& bodies) {
    auto def = StartAnchoredDef<scree::PrismaticJointDef>(joint, bodies);
    def.referenceAngle = joint.referenceAngle;
    SetSlider(def, joint);
    def.maxMotorForce = joint.maxMotorForce;
    return def;
}

scree::PulleyJointDef MakePulley(const scenes::Joint& joint, const ScreeBodies& bodies) {
    auto def = StartAnchoredDef<scree::PulleyJointDef>(joint, bodies);
    def.groundAnchorA = ToScree(joint.groundAnchorA);
    def.groundAnchorB = ToScree(joint.groundAnchorB);
    def.lengthA = joint.lengthA;
    def.lengthB = joint.lengthB;
    def.ratio = joint.ratio;
    return def;
}

scree::WeldJointDef MakeWeld(const scenes::Joint& joint, const ScreeBodies& bodies) {
    auto def = StartAnchoredDef<scree::WeldJointDef>(joint, bodies);
    def.referenceAngle = joint.referenceAngle;
    SetSpring(def, joint);
    return def;
}

scree::WheelJointDef MakeWheel(const scenes::Joint& joint, const ScreeBodies& bodies) {
    auto def = StartAnchoredDef<scree::WheelJointDef>(joint, bodies);
    SetSlider(def, joint);
    def.maxMotorTorque = joint.maxMotorTorque;
    SetSpring(def, joint);
    return def;
}

scree::GearJointDef MakeGear(const scenes::Joint& joint, const ScreeBodies& bodies, const ScreeJoints& joints) {
    auto def = StartDef<scree::GearJointDef>(joint, bodies);
    def.joint1 = joints[static_cast<size_t>(joint.joint1)];
    def.joint2 = joints[static_cast<size_t>(joint.joint2)];
    def.ratio = joint.ratio;
    return def;
}

/// The engine grips the point of body B that lies on the target when the joint is made, so that comes first.
scree::Joint* CreateMouse(scree::World& world, const scenes::Joint& joint, const ScreeBodies& bodies) {
    auto def = StartDef<scree::MouseJointDef>(joint, bodies);
    def.target = def.bodyB->GetWorldPoint(ToScree(joint.localAnchorB));
    def.maxForce = joint.maxForce;
    SetSpring(def, joint);
    auto* made = static_cast<scree::MouseJoint*>(world.CreateJoint(&def));
    made->SetTarget(ToScree(joint.target));
    return made;
}

}  // namespace

scree::Joint* CreateScreeJoint(scree::World& world, const scenes::Joint& joint, const ScreeBodies& bodies,
                               const ScreeJoints& joints) {
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
