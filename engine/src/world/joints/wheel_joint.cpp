// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Wheel joint: definition and handle.

#include "scree/wheel_joint.h"

#include "world/joints/joint_access.h"
#include "world/joints/joint_definitions.h"

namespace scree {

WheelRow& WheelJoint::Row() const { return RowOf<WheelRow>(m_state, m_row); }

void WheelJointDef::Initialize(Body* a, Body* b, Vec2 anchor, Vec2 axis) {
    bodyA = a;
    bodyB = b;
    if (a == nullptr || b == nullptr) return;  // CreateJoint says so
    localAnchorA = a->GetLocalPoint(anchor);
    localAnchorB = b->GetLocalPoint(anchor);
    localAxisA = a->GetLocalVector(axis);
}

void Check(const WheelJointDef& def, Guard& guard) {
    guard.Finite(def.localAnchorA, "WheelJointDef::localAnchorA")
        .Finite(def.localAnchorB, "WheelJointDef::localAnchorB")
        .Finite(def.localAxisA, "WheelJointDef::localAxisA")
        .Require(!(UnitAxis(def.localAxisA) == vec2Zero), ErrorCode::outOfRange, "WheelJointDef::localAxisA",
                 "give a direction, best of length 1")
        .Finite(def.lowerTranslation, "WheelJointDef::lowerTranslation")
        .Finite(def.upperTranslation, "WheelJointDef::upperTranslation")
        .Require(def.lowerTranslation <= def.upperTranslation, ErrorCode::outOfRange, "WheelJointDef::lowerTranslation",
                 "keep it at or below upperTranslation")
        .Finite(def.motorSpeed, "WheelJointDef::motorSpeed")
        .Amount(def.maxMotorTorque, "WheelJointDef::maxMotorTorque")
        .Amount(def.stiffness, "WheelJointDef::stiffness")
        .Amount(def.damping, "WheelJointDef::damping");
}

WheelRow MakeRow(const WheelJointDef& def) {
    return {.localAnchorA = def.localAnchorA,
            .localAnchorB = def.localAnchorB,
            .localAxisA = UnitAxis(def.localAxisA),
            .stiffness = def.stiffness,
            .damping = def.damping,
            .limit = {.enabled = def.enableLimit, .lower = def.lowerTranslation, .upper = def.upperTranslation},
            .motor = {.enabled = def.enableMotor, .speed = def.motorSpeed, .maximum = def.maxMotorTorque}};
}

Vec2 WheelJoint::GetAnchorA() const { return GetBodyA()->GetWorldPoint(Row().localAnchorA); }
Vec2 WheelJoint::GetAnchorB() const { return GetBodyB()->GetWorldPoint(Row().localAnchorB); }
Vec2 WheelJoint::GetReactionForce(float inverseDt) const {
    const WheelRow& row = Row();
    const float along = row.springImpulse + row.limit.lowerImpulse - row.limit.upperImpulse;
    return inverseDt * (row.impulse * row.axis.Skew() + along * row.axis);
}
float WheelJoint::GetReactionTorque(float inverseDt) const { return inverseDt * Row().motor.impulse; }
Vec2 WheelJoint::GetLocalAnchorA() const { return Row().localAnchorA; }
Vec2 WheelJoint::GetLocalAnchorB() const { return Row().localAnchorB; }
Vec2 WheelJoint::GetLocalAxisA() const { return Row().localAxisA; }
float WheelJoint::GetJointTranslation() const {
    const WheelRow& row = Row();
    return GetSlide(*this, {row.localAnchorA, row.localAnchorB, row.localAxisA});
}
float WheelJoint::GetJointLinearSpeed() const {
    const WheelRow& row = Row();
    return GetSlideSpeed(*this, {row.localAnchorA, row.localAnchorB, row.localAxisA});
}
float WheelJoint::GetJointAngle() const { return GetBodyB()->GetAngle() - GetBodyA()->GetAngle(); }
float WheelJoint::GetJointAngularSpeed() const {
    return GetBodyB()->GetAngularVelocity() - GetBodyA()->GetAngularVelocity();
}

bool WheelJoint::IsLimitEnabled() const { return Row().limit.enabled; }
ErrorCode WheelJoint::EnableLimit(bool flag) {
    return scree::EnableLimit(JointEdit(m_state, this, "WheelJoint::EnableLimit"), Row().limit, flag);
}
float WheelJoint::GetLowerLimit() const { return Row().limit.lower; }
float WheelJoint::GetUpperLimit() const { return Row().limit.upper; }
ErrorCode WheelJoint::SetLimits(float lower, float upper) {
    return scree::SetLimits(JointEdit(m_state, this, "WheelJoint::SetLimits"), Row().limit, lower, upper);
}

bool WheelJoint::IsMotorEnabled() const { return Row().motor.enabled; }
ErrorCode WheelJoint::EnableMotor(bool flag) {
    return JointEdit(m_state, this, "WheelJoint::EnableMotor").SetAndWake(Row().motor.enabled, flag);
}
ErrorCode WheelJoint::SetMotorSpeed(float speed) {
    return JointEdit(m_state, this, "WheelJoint::SetMotorSpeed")
        .Finite(speed, "speed")
        .SetAndWake(Row().motor.speed, speed);
}
float WheelJoint::GetMotorSpeed() const { return Row().motor.speed; }
ErrorCode WheelJoint::SetMaxMotorTorque(float torque) {
    return JointEdit(m_state, this, "WheelJoint::SetMaxMotorTorque")
        .Amount(torque, "torque")
        .SetAndWake(Row().motor.maximum, torque);
}
float WheelJoint::GetMaxMotorTorque() const { return Row().motor.maximum; }
float WheelJoint::GetMotorTorque(float inverseDt) const { return inverseDt * Row().motor.impulse; }

ErrorCode WheelJoint::SetStiffness(float stiffness) {
    return JointEdit(m_state, this, "WheelJoint::SetStiffness")
        .Amount(stiffness, "stiffness")
        .Set(Row().stiffness, stiffness);
}
float WheelJoint::GetStiffness() const { return Row().stiffness; }
ErrorCode WheelJoint::SetDamping(float damping) {
    return JointEdit(m_state, this, "WheelJoint::SetDamping").Amount(damping, "damping").Set(Row().damping, damping);
}
float WheelJoint::GetDamping() const { return Row().damping; }

}  // namespace scree
