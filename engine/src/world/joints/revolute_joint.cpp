// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Revolute joint: definition and handle.

#include "scree/revolute_joint.h"

#include "world/joints/joint_access.h"
#include "world/joints/joint_definitions.h"

namespace scree {

RevoluteRow& RevoluteJoint::Row() const { return RowOf<RevoluteRow>(m_state, m_row); }

void RevoluteJointDef::Initialize(Body* a, Body* b, Vec2 anchor) {
    bodyA = a;
    bodyB = b;
    if (a == nullptr || b == nullptr) return;  // CreateJoint says so
    localAnchorA = a->GetLocalPoint(anchor);
    localAnchorB = b->GetLocalPoint(anchor);
    referenceAngle = b->GetAngle() - a->GetAngle();
}

void Check(const RevoluteJointDef& def, Guard& guard) {
    guard.Finite(def.localAnchorA, "RevoluteJointDef::localAnchorA")
        .Finite(def.localAnchorB, "RevoluteJointDef::localAnchorB")
        .Finite(def.referenceAngle, "RevoluteJointDef::referenceAngle")
        .Finite(def.lowerAngle, "RevoluteJointDef::lowerAngle")
        .Finite(def.upperAngle, "RevoluteJointDef::upperAngle")
        .Require(def.lowerAngle <= def.upperAngle, ErrorCode::outOfRange, "RevoluteJointDef::lowerAngle",
                 "keep it at or below upperAngle")
        .Finite(def.motorSpeed, "RevoluteJointDef::motorSpeed")
        .Amount(def.maxMotorTorque, "RevoluteJointDef::maxMotorTorque")
        .Amount(def.stiffness, "RevoluteJointDef::stiffness")
        .Amount(def.damping, "RevoluteJointDef::damping")
        .Finite(def.targetAngle, "RevoluteJointDef::targetAngle")
        .Require(def.maxSpringTorque >= 0.0f, ErrorCode::outOfRange, "RevoluteJointDef::maxSpringTorque",
                 "give a number of at least 0");
}

RevoluteRow MakeRow(const RevoluteJointDef& def) {
    return {.localAnchorA = def.localAnchorA,
            .localAnchorB = def.localAnchorB,
            .referenceAngle = def.referenceAngle,
            .limit = {.enabled = def.enableLimit, .lower = def.lowerAngle, .upper = def.upperAngle},
            .motor = {.enabled = def.enableMotor, .speed = def.motorSpeed, .maximum = def.maxMotorTorque},
            .spring = {.enabled = def.enableSpring,
                       .stiffness = def.stiffness,
                       .damping = def.damping,
                       .target = def.targetAngle,
                       .maximum = def.maxSpringTorque}};
}

Vec2 RevoluteJoint::GetAnchorA() const {
    return Lives("RevoluteJoint::GetAnchorA") ? GetBodyA()->GetWorldPoint(Row().localAnchorA) : vec2Zero;
}
Vec2 RevoluteJoint::GetAnchorB() const {
    return Lives("RevoluteJoint::GetAnchorB") ? GetBodyB()->GetWorldPoint(Row().localAnchorB) : vec2Zero;
}
Vec2 RevoluteJoint::GetReactionForce(float inverseDt) const {
    return Lives("RevoluteJoint::GetReactionForce") ? inverseDt * Row().impulse : vec2Zero;
}
float RevoluteJoint::GetReactionTorque(float inverseDt) const {
    if (!Lives("RevoluteJoint::GetReactionTorque")) return 0.0f;
    const RevoluteRow& row = Row();
    return inverseDt * (row.motor.impulse + row.spring.impulse + row.limit.lowerImpulse - row.limit.upperImpulse);
}
Vec2 RevoluteJoint::GetLocalAnchorA() const {
    return Lives("RevoluteJoint::GetLocalAnchorA") ? Row().localAnchorA : vec2Zero;
}
Vec2 RevoluteJoint::GetLocalAnchorB() const {
    return Lives("RevoluteJoint::GetLocalAnchorB") ? Row().localAnchorB : vec2Zero;
}
float RevoluteJoint::GetReferenceAngle() const {
    return Lives("RevoluteJoint::GetReferenceAngle") ? Row().referenceAngle : 0.0f;
}
float RevoluteJoint::GetJointAngle() const {
    if (!Lives("RevoluteJoint::GetJointAngle")) return 0.0f;
    return GetBodyB()->GetAngle() - GetBodyA()->GetAngle() - Row().referenceAngle;
}
float RevoluteJoint::GetJointSpeed() const {
    if (!Lives("RevoluteJoint::GetJointSpeed")) return 0.0f;
    return GetBodyB()->GetAngularVelocity() - GetBodyA()->GetAngularVelocity();
}

bool RevoluteJoint::IsLimitEnabled() const {
    return Lives("RevoluteJoint::IsLimitEnabled") ? Row().limit.enabled : false;
}
ErrorCode RevoluteJoint::EnableLimit(bool flag) {
    return scree::EnableLimit(JointEdit(m_state, this, "RevoluteJoint::EnableLimit"), Row().limit, flag);
}
float RevoluteJoint::GetLowerLimit() const { return Lives("RevoluteJoint::GetLowerLimit") ? Row().limit.lower : 0.0f; }
float RevoluteJoint::GetUpperLimit() const { return Lives("RevoluteJoint::GetUpperLimit") ? Row().limit.upper : 0.0f; }
ErrorCode RevoluteJoint::SetLimits(float lower, float upper) {
    return scree::SetLimits(JointEdit(m_state, this, "RevoluteJoint::SetLimits"), Row().limit, lower, upper);
}

bool RevoluteJoint::IsMotorEnabled() const {
    return Lives("RevoluteJoint::IsMotorEnabled") ? Row().motor.enabled : false;
}
ErrorCode RevoluteJoint::EnableMotor(bool flag) {
    return JointEdit(m_state, this, "RevoluteJoint::EnableMotor").SetAndWake(Row().motor.enabled, flag);
}
ErrorCode RevoluteJoint::SetMotorSpeed(float speed) {
    return JointEdit(m_state, this, "RevoluteJoint::SetMotorSpeed")
        .Finite(speed, "speed")
        .SetAndWake(Row().motor.speed, speed);
}
float RevoluteJoint::GetMotorSpeed() const { return Lives("RevoluteJoint::GetMotorSpeed") ? Row().motor.speed : 0.0f; }
ErrorCode RevoluteJoint::SetMaxMotorTorque(float torque) {
    return JointEdit(m_state, this, "RevoluteJoint::SetMaxMotorTorque")
        .Amount(torque, "torque")
        .SetAndWake(Row().motor.maximum, torque);
}
float RevoluteJoint::GetMaxMotorTorque() const {
    return Lives("RevoluteJoint::GetMaxMotorTorque") ? Row().motor.maximum : 0.0f;
}
float RevoluteJoint::GetMotorTorque(float inverseDt) const {
    return Lives("RevoluteJoint::GetMotorTorque") ? inverseDt * Row().motor.impulse : 0.0f;
}

bool RevoluteJoint::IsSpringEnabled() const {
    return Lives("RevoluteJoint::IsSpringEnabled") ? Row().spring.enabled : false;
}
ErrorCode RevoluteJoint::EnableSpring(bool flag) {
    return scree::EnableSpring(JointEdit(m_state, this, "RevoluteJoint::EnableSpring"), Row().spring, flag);
}
ErrorCode RevoluteJoint::SetSpring(float stiffness, float damping) {
    return scree::SetSpring(JointEdit(m_state, this, "RevoluteJoint::SetSpring"), Row().spring, stiffness, damping);
}
float RevoluteJoint::GetStiffness() const {
    return Lives("RevoluteJoint::GetStiffness") ? Row().spring.stiffness : 0.0f;
}
float RevoluteJoint::GetDamping() const { return Lives("RevoluteJoint::GetDamping") ? Row().spring.damping : 0.0f; }
ErrorCode RevoluteJoint::SetTargetAngle(float angle) {
    return JointEdit(m_state, this, "RevoluteJoint::SetTargetAngle")
        .Finite(angle, "angle")
        .SetAndWake(Row().spring.target, angle);
}
float RevoluteJoint::GetTargetAngle() const {
    return Lives("RevoluteJoint::GetTargetAngle") ? Row().spring.target : 0.0f;
}
ErrorCode RevoluteJoint::SetMaxSpringTorque(float torque) {
    return JointEdit(m_state, this, "RevoluteJoint::SetMaxSpringTorque")
        .Bound(torque, "torque")
        .SetAndWake(Row().spring.maximum, torque);
}
float RevoluteJoint::GetMaxSpringTorque() const {
    return Lives("RevoluteJoint::GetMaxSpringTorque") ? Row().spring.maximum : 0.0f;
}
float RevoluteJoint::GetSpringTorque(float inverseDt) const {
    return Lives("RevoluteJoint::GetSpringTorque") ? inverseDt * Row().spring.impulse : 0.0f;
}

}  // namespace scree
