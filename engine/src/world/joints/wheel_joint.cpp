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
        .Amount(def.damping, "WheelJointDef::damping")
        .Require(def.maxSpringForce >= 0.0f, ErrorCode::outOfRange, "WheelJointDef::maxSpringForce",
                 "give a number of at least 0");
}

WheelRow MakeRow(const WheelJointDef& def) {
    return {.localAnchorA = def.localAnchorA,
            .localAnchorB = def.localAnchorB,
            .localAxisA = UnitAxis(def.localAxisA),
            .stiffness = def.stiffness,
            .damping = def.damping,
            .maxSpringForce = def.maxSpringForce,
            .limit = {.enabled = def.enableLimit, .lower = def.lowerTranslation, .upper = def.upperTranslation},
            .motor = {.enabled = def.enableMotor, .speed = def.motorSpeed, .maximum = def.maxMotorTorque}};
}

Vec2 WheelJoint::GetAnchorA() const {
    return Lives("WheelJoint::GetAnchorA") ? GetBodyA()->GetWorldPoint(Row().localAnchorA) : vec2Zero;
}
Vec2 WheelJoint::GetAnchorB() const {
    return Lives("WheelJoint::GetAnchorB") ? GetBodyB()->GetWorldPoint(Row().localAnchorB) : vec2Zero;
}
Vec2 WheelJoint::GetReactionForce(float inverseDt) const {
    if (!Lives("WheelJoint::GetReactionForce")) return vec2Zero;
    const WheelRow& row = Row();
    const float along = row.springImpulse + row.limit.lowerImpulse - row.limit.upperImpulse;
    return inverseDt * (row.impulse * row.axis.Skew() + along * row.axis);
}
float WheelJoint::GetReactionTorque(float inverseDt) const {
    return Lives("WheelJoint::GetReactionTorque") ? inverseDt * Row().motor.impulse : 0.0f;
}
Vec2 WheelJoint::GetLocalAnchorA() const {
    return Lives("WheelJoint::GetLocalAnchorA") ? Row().localAnchorA : vec2Zero;
}
Vec2 WheelJoint::GetLocalAnchorB() const {
    return Lives("WheelJoint::GetLocalAnchorB") ? Row().localAnchorB : vec2Zero;
}
Vec2 WheelJoint::GetLocalAxisA() const { return Lives("WheelJoint::GetLocalAxisA") ? Row().localAxisA : vec2Zero; }
float WheelJoint::GetJointTranslation() const {
    if (!Lives("WheelJoint::GetJointTranslation")) return 0.0f;
    const WheelRow& row = Row();
    return GetSlide(*this, {row.localAnchorA, row.localAnchorB, row.localAxisA});
}
float WheelJoint::GetJointLinearSpeed() const {
    if (!Lives("WheelJoint::GetJointLinearSpeed")) return 0.0f;
    const WheelRow& row = Row();
    return GetSlideSpeed(*this, {row.localAnchorA, row.localAnchorB, row.localAxisA});
}
float WheelJoint::GetJointAngle() const {
    return Lives("WheelJoint::GetJointAngle") ? GetBodyB()->GetAngle() - GetBodyA()->GetAngle() : 0.0f;
}
float WheelJoint::GetJointAngularSpeed() const {
    if (!Lives("WheelJoint::GetJointAngularSpeed")) return 0.0f;
    return GetBodyB()->GetAngularVelocity() - GetBodyA()->GetAngularVelocity();
}

bool WheelJoint::IsLimitEnabled() const { return Lives("WheelJoint::IsLimitEnabled") ? Row().limit.enabled : false; }
ErrorCode WheelJoint::EnableLimit(bool flag) {
    return scree::EnableLimit(JointEdit(m_state, this, "WheelJoint::EnableLimit"), Row().limit, flag);
}
float WheelJoint::GetLowerLimit() const { return Lives("WheelJoint::GetLowerLimit") ? Row().limit.lower : 0.0f; }
float WheelJoint::GetUpperLimit() const { return Lives("WheelJoint::GetUpperLimit") ? Row().limit.upper : 0.0f; }
ErrorCode WheelJoint::SetLimits(float lower, float upper) {
    return scree::SetLimits(JointEdit(m_state, this, "WheelJoint::SetLimits"), Row().limit, lower, upper);
}

bool WheelJoint::IsMotorEnabled() const { return Lives("WheelJoint::IsMotorEnabled") ? Row().motor.enabled : false; }
ErrorCode WheelJoint::EnableMotor(bool flag) {
    return JointEdit(m_state, this, "WheelJoint::EnableMotor").SetAndWake(Row().motor.enabled, flag);
}
ErrorCode WheelJoint::SetMotorSpeed(float speed) {
    return JointEdit(m_state, this, "WheelJoint::SetMotorSpeed")
        .Finite(speed, "speed")
        .SetAndWake(Row().motor.speed, speed);
}
float WheelJoint::GetMotorSpeed() const { return Lives("WheelJoint::GetMotorSpeed") ? Row().motor.speed : 0.0f; }
ErrorCode WheelJoint::SetMaxMotorTorque(float torque) {
    return JointEdit(m_state, this, "WheelJoint::SetMaxMotorTorque")
        .Amount(torque, "torque")
        .SetAndWake(Row().motor.maximum, torque);
}
float WheelJoint::GetMaxMotorTorque() const {
    return Lives("WheelJoint::GetMaxMotorTorque") ? Row().motor.maximum : 0.0f;
}
float WheelJoint::GetMotorTorque(float inverseDt) const {
    return Lives("WheelJoint::GetMotorTorque") ? inverseDt * Row().motor.impulse : 0.0f;
}

ErrorCode WheelJoint::SetStiffness(float stiffness) {
    return JointEdit(m_state, this, "WheelJoint::SetStiffness")
        .Amount(stiffness, "stiffness")
        .Set(Row().stiffness, stiffness);
}
float WheelJoint::GetStiffness() const { return Lives("WheelJoint::GetStiffness") ? Row().stiffness : 0.0f; }
ErrorCode WheelJoint::SetDamping(float damping) {
    return JointEdit(m_state, this, "WheelJoint::SetDamping").Amount(damping, "damping").Set(Row().damping, damping);
}
float WheelJoint::GetDamping() const { return Lives("WheelJoint::GetDamping") ? Row().damping : 0.0f; }
ErrorCode WheelJoint::SetMaxSpringForce(float force) {
    return JointEdit(m_state, this, "WheelJoint::SetMaxSpringForce")
        .Bound(force, "force")
        .Set(Row().maxSpringForce, force);
}
float WheelJoint::GetMaxSpringForce() const {
    return Lives("WheelJoint::GetMaxSpringForce") ? Row().maxSpringForce : 0.0f;
}

}  // namespace scree
