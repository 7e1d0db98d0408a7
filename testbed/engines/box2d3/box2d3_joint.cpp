// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of box2d3_joint.h. A spring of stiffness k and damping c becomes a frequency and a damping ratio,
// which Box2D 3 takes. The mass in between is the effective mass of the two bodies without their rotation, as in
// b2LinearStiffness of Box2D 2.4.

#include "testbed/engines/box2d3/box2d3_joint.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "testbed/engines/box2d3/box2d3_shape.h"

namespace testbed::box2d3 {
namespace {

struct Spring {
    float hertz = 0.0f, dampingRatio = 0.0f;
};

/// `inertia`: of both bodies as one, kg or kg·m².
Spring MakeSpring(float stiffness, float damping, float inertia) {
    if (stiffness <= 0.0f || inertia <= 0.0f) return {};
    const float omega = std::sqrt(stiffness / inertia);
    return {omega / (2.0f * std::numbers::pi_v<float>), damping / (2.0f * inertia * omega)};
}

float Together(float a, float b) {
    if (a > 0.0f && b > 0.0f) return a * b / (a + b);
    return a > 0.0f ? a : b;
}

struct Ends {
    b2BodyId a, b;

    [[nodiscard]] Spring MakeLinear(const scenes::Joint& joint) const {
        return MakeSpring(joint.stiffness, joint.damping, Together(b2Body_GetMass(a), b2Body_GetMass(b)));
    }
    [[nodiscard]] Spring MakeAngular(const scenes::Joint& joint) const {
        return MakeSpring(joint.stiffness, joint.damping,
                          Together(b2Body_GetRotationalInertia(a), b2Body_GetRotationalInertia(b)));
    }
};

/// The frames put the anchors together; `turnA` and `turnB` are their angles in the bodies.
template <typename Def>
void SetBase(Def& def, const scenes::Joint& joint, const Ends& ends, float turnA = 0.0f, float turnB = 0.0f) {
    def.base.bodyIdA = ends.a;
    def.base.bodyIdB = ends.b;
    def.base.localFrameA = {ToB2(joint.localAnchorA), b2MakeRot(turnA)};
    def.base.localFrameB = {ToB2(joint.localAnchorB), b2MakeRot(turnB)};
    def.base.collideConnected = joint.collideConnected;
}

/// Range and drive along an axis.
template <typename Def>
void SetSlider(Def& def, const scenes::Joint& joint) {
    def.enableLimit = joint.enableLimit;
    def.lowerTranslation = joint.lowerTranslation;
    def.upperTranslation = joint.upperTranslation;
    def.enableMotor = joint.enableMotor;
    def.motorSpeed = joint.motorSpeed;
}

float AxisAngle(const scenes::Joint& joint) { return std::atan2(joint.localAxisA.y, joint.localAxisA.x); }

b2JointId CreateRevolute(b2WorldId world, const scenes::Joint& joint, const Ends& ends) {
    b2RevoluteJointDef def = b2DefaultRevoluteJointDef();
    SetBase(def, joint, ends, joint.referenceAngle);
    def.enableLimit = joint.enableLimit;
    def.lowerAngle = joint.lowerAngle;
    def.upperAngle = joint.upperAngle;
    def.enableMotor = joint.enableMotor;
    def.motorSpeed = joint.motorSpeed;
    def.maxMotorTorque = joint.maxMotorTorque;
    return b2CreateRevoluteJoint(world, &def);
}

b2JointId CreateDistance(b2WorldId world, const scenes::Joint& joint, const Ends& ends) {
    b2DistanceJointDef def = b2DefaultDistanceJointDef();
    SetBase(def, joint, ends);
    def.length = joint.length;
    // Without a spring Box2D 3 makes a rod; a rope is a spring without stiffness and a limit.
    const bool isRod = joint.stiffness <= 0.0f && joint.minLength >= joint.maxLength;
    def.enableSpring = !isRod;
    const Spring spring = ends.MakeLinear(joint);
    def.hertz = spring.hertz;
    def.dampingRatio = spring.dampingRatio;
    if (!isRod && joint.maxLength < std::numeric_limits<float>::max()) {
        def.enableLimit = true;
        def.minLength = joint.minLength;
        def.maxLength = joint.maxLength;
    }
    if (isRod) def.length = joint.maxLength;
    return b2CreateDistanceJoint(world, &def);
}

b2JointId CreatePrismatic(b2WorldId world, const scenes::Joint& joint, const Ends& ends) {
    b2PrismaticJointDef def = b2DefaultPrismaticJointDef();
    SetBase(def, joint, ends, AxisAngle(joint), AxisAngle(joint) - joint.referenceAngle);
    SetSlider(def, joint);
    def.maxMotorForce = joint.maxMotorForce;
    return b2CreatePrismaticJoint(world, &def);
}

b2JointId CreateWheel(b2WorldId world, const scenes::Joint& joint, const Ends& ends) {
    b2WheelJointDef def = b2DefaultWheelJointDef();
    SetBase(def, joint, ends, AxisAngle(joint));
    SetSlider(def, joint);
    def.maxMotorTorque = joint.maxMotorTorque;
    const Spring spring = ends.MakeLinear(joint);
    def.enableSpring = spring.hertz > 0.0f;
    def.hertz = spring.hertz;
    def.dampingRatio = spring.dampingRatio;
    return b2CreateWheelJoint(world, &def);
}

b2JointId CreateWeld(b2WorldId world, const scenes::Joint& joint, const Ends& ends) {
    b2WeldJointDef def = b2DefaultWeldJointDef();
    SetBase(def, joint, ends, joint.referenceAngle);
    const Spring spring = ends.MakeAngular(joint);
    def.angularHertz = spring.hertz;
    def.angularDampingRatio = spring.dampingRatio;
    return b2CreateWeldJoint(world, &def);
}

/// A drive to no relative motion, of bounded force.
b2JointId CreateFriction(b2WorldId world, const scenes::Joint& joint, const Ends& ends) {
    b2MotorJointDef def = b2DefaultMotorJointDef();
    SetBase(def, joint, ends);
    def.maxVelocityForce = joint.maxForce;
    def.maxVelocityTorque = joint.maxTorque;
    return b2CreateMotorJoint(world, &def);
}

/// A spring of bounded force from a point of the world to one of the body.
b2JointId CreateMouse(b2WorldId world, const scenes::Joint& joint, const Ends& ends) {
    b2MotorJointDef def = b2DefaultMotorJointDef();
    SetBase(def, joint, ends);
    def.base.localFrameA = {b2Body_GetLocalPoint(ends.a, b2ToPos(ToB2(joint.target))), b2Rot_identity};
    const Spring spring = MakeSpring(joint.stiffness, joint.damping, b2Body_GetMass(ends.b));
    def.linearHertz = spring.hertz;
    def.linearDampingRatio = spring.dampingRatio;
    def.maxSpringForce = joint.maxForce;
    return b2CreateMotorJoint(world, &def);
}

}  // namespace

b2JointId CreateJoint(b2WorldId world, const scenes::Joint& joint, std::span<const b2BodyId> bodies) {
    const Ends ends{bodies[static_cast<size_t>(joint.bodyA)], bodies[static_cast<size_t>(joint.bodyB)]};
    switch (joint.type) {
        case scenes::JointType::revolute:
            return CreateRevolute(world, joint, ends);
        case scenes::JointType::distance:
            return CreateDistance(world, joint, ends);
        case scenes::JointType::friction:
            return CreateFriction(world, joint, ends);
        case scenes::JointType::mouse:
            return CreateMouse(world, joint, ends);
        case scenes::JointType::prismatic:
            return CreatePrismatic(world, joint, ends);
        case scenes::JointType::weld:
            return CreateWeld(world, joint, ends);
        case scenes::JointType::wheel:
            return CreateWheel(world, joint, ends);
        case scenes::JointType::gear:
            throw std::invalid_argument("box2d3 has no gear joints: leave it out of --engines for this scene");
        case scenes::JointType::pulley:
            throw std::invalid_argument("box2d3 has no pulley joints: leave it out of --engines for this scene");
        case scenes::JointType::motor:
            throw std::invalid_argument(
                "box2d3 has no motor joints that correct a share of their error: leave it out of --engines for this "
                "scene");
    }
    throw std::invalid_argument("scene joint of unknown type");
}

}  // namespace testbed::box2d3
