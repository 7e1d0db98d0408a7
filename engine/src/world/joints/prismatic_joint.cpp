// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Prismatic joint: definition and handle.

#include "scree/prismatic_joint.h"

#include "world/joints/joint_access.h"
#include "world/joints/joint_definitions.h"

namespace scree {

PrismaticRow& PrismaticJoint::Row() const { return RowOf<PrismaticRow>(m_state, m_row); }

void PrismaticJointDef::Initialize(Body* a, Body* b, Vec2 anchor, Vec2 axis) {
    bodyA = a;
    bodyB = b;
    if (a == nullptr || b == nullptr) return;  // CreateJoint says so
    localAnchorA = a->GetLocalPoint(anchor);
    localAnchorB = b->GetLocalPoint(anchor);
    localAxisA = a->GetLocalVector(axis);
    referenceAngle = b->GetAngle() - a->GetAngle();
}

void Check(const PrismaticJointDef& def, Guard& guard) {
    guard.Finite(def.localAnchorA, "PrismaticJointDef::localAnchorA")
        .Finite(def.localAnchorB, "PrismaticJointDef::localAnchorB")
        .Finite(def.localAxisA, "PrismaticJointDef::localAxisA")
        .Require(!(UnitAxis(def.localAxisA) == vec2Zero), ErrorCode::outOfRange, "PrismaticJointDef::localAxisA",
                 "give a direction, best of length 1")
        .Finite(def.referenceAngle, "PrismaticJointDef::referenceAngle")
        .Finite(def.lowerTranslation, "PrismaticJointDef::lowerTranslation")
        .Finite(def.upperTranslation, "PrismaticJointDef::upperTranslation")
        .Require(def.lowerTranslation <= def.upperTranslation, ErrorCode::outOfRange,
                 "PrismaticJointDef::lowerTranslation", "keep it at or below upperTranslation")
        .Finite(def.motorSpeed, "PrismaticJointDef::motorSpeed")
        .Amount(def.maxMotorForce, "PrismaticJointDef::maxMotorForce")
        .Amount(def.stiffness, "PrismaticJointDef::stiffness")
        .Amount(def.damping, "PrismaticJointDef::damping")
        .Finite(def.targetTranslation, "PrismaticJointDef::targetTranslation")
        .Require(def.maxSpringForce >= 0.0f, ErrorCode::outOfRange, "PrismaticJointDef::maxSpringForce",
                 "give a number of at least 0");
}

PrismaticRow MakeRow(const PrismaticJointDef& def) {
    return {.localAnchorA = def.localAnchorA,
            .localAnchorB = def.localAnchorB,
            .localAxisA = UnitAxis(def.localAxisA),
            .referenceAngle = def.referenceAngle,
            .limit = {.enabled = def.enableLimit, .lower = def.lowerTranslation, .upper = def.upperTranslation},
            .motor = {.enabled = def.enableMotor, .speed = def.motorSpeed, .maximum = def.maxMotorForce},
            .spring = {.enabled = def.enableSpring,
                       .stiffness = def.stiffness,
                       .damping = def.damping,
                       .target = def.targetTranslation,
                       .maximum = def.maxSpringForce}};
}

Vec2 PrismaticJoint::GetAnchorA() const {
    return Lives("PrismaticJoint::GetAnchorA") ? GetBodyA()->GetWorldPoint(Row().localAnchorA) : vec2Zero;
}
Vec2 PrismaticJoint::GetAnchorB() const {
    return Lives("PrismaticJoint::GetAnchorB") ? GetBodyB()->GetWorldPoint(Row().localAnchorB) : vec2Zero;
}
Vec2 PrismaticJoint::GetReactionForce(float inverseDt) const {
    if (!Lives("PrismaticJoint::GetReactionForce")) return vec2Zero;
    const PrismaticRow& row = Row();
    const float along = row.motor.impulse + row.spring.impulse + row.limit.lowerImpulse - row.limit.upperImpulse;
    return inverseDt * (row.impulse.x * row.axis.Skew() + along * row.axis);
}
float PrismaticJoint::GetReactionTorque(float inverseDt) const {
    return Lives("PrismaticJoint::GetReactionTorque") ? inverseDt * Row().impulse.y : 0.0f;
}
Vec2 PrismaticJoint::GetLocalAnchorA() const {
    return Lives("PrismaticJoint::GetLocalAnchorA") ? Row().localAnchorA : vec2Zero;
}
Vec2 PrismaticJoint::GetLocalAnchorB() const {
    return Lives("PrismaticJoint::GetLocalAnchorB") ? Row().localAnchorB : vec2Zero;
}
Vec2 PrismaticJoint::GetLocalAxisA() const {
    return Lives("PrismaticJoint::GetLocalAxisA") ? Row().localAxisA : vec2Zero;
}
float PrismaticJoint::GetReferenceAngle() const {
    return Lives("PrismaticJoint::GetReferenceAngle") ? Row().referenceAngle : 0.0f;
}
float PrismaticJoint::GetJointTranslation() const {
    if (!Lives("PrismaticJoint::GetJointTranslation")) return 0.0f;
    const PrismaticRow& row = Row();
    return GetSlide(*this, {row.localAnchorA, row.localAnchorB, row.localAxisA});
}
float PrismaticJoint::GetJointSpeed() const {
    if (!Lives("PrismaticJoint::GetJointSpeed")) return 0.0f;
    const PrismaticRow& row = Row();
    return GetSlideSpeed(*this, {row.localAnchorA, row.localAnchorB, row.localAxisA});
}

bool PrismaticJoint::IsLimitEnabled() const {
    return Lives("PrismaticJoint::IsLimitEnabled") ? Row().limit.enabled : false;
}
ErrorCode PrismaticJoint::EnableLimit(bool flag) {
    return scree::EnableLimit(JointEdit(m_state, this, "PrismaticJoint::EnableLimit"), Row().limit, flag);
}
float PrismaticJoint::GetLowerLimit() const {
    return Lives("PrismaticJoint::GetLowerLimit") ? Row().limit.lower : 0.0f;
}
float PrismaticJoint::GetUpperLimit() const {
    return Lives("PrismaticJoint::GetUpperLimit") ? Row().limit.upper : 0.0f;
}
ErrorCode PrismaticJoint::SetLimits(float lower, float upper) {
    return scree::SetLimits(JointEdit(m_state, this, "PrismaticJoint::SetLimits"), Row().limit, lower, upper);
}

bool PrismaticJoint::IsMotorEnabled() const {
    return Lives("PrismaticJoint::IsMotorEnabled") ? Row().motor.enabled : false;
}
ErrorCode PrismaticJoint::EnableMotor(bool flag) {
    return JointEdit(m_state, this, "PrismaticJoint::EnableMotor").SetAndWake(Row().motor.enabled, flag);
}
ErrorCode PrismaticJoint::SetMotorSpeed(float speed) {
    return JointEdit(m_state, this, "PrismaticJoint::SetMotorSpeed")
        .Finite(speed, "speed")
        .SetAndWake(Row().motor.speed, speed);
}
float PrismaticJoint::GetMotorSpeed() const {
    return Lives("PrismaticJoint::GetMotorSpeed") ? Row().motor.speed : 0.0f;
}
ErrorCode PrismaticJoint::SetMaxMotorForce(float force) {
    return JointEdit(m_state, this, "PrismaticJoint::SetMaxMotorForce")
        .Amount(force, "force")
        .SetAndWake(Row().motor.maximum, force);
}
float PrismaticJoint::GetMaxMotorForce() const {
    return Lives("PrismaticJoint::GetMaxMotorForce") ? Row().motor.maximum : 0.0f;
}
float PrismaticJoint::GetMotorForce(float inverseDt) const {
    return Lives("PrismaticJoint::GetMotorForce") ? inverseDt * Row().motor.impulse : 0.0f;
}

bool PrismaticJoint::IsSpringEnabled() const {
    return Lives("PrismaticJoint::IsSpringEnabled") ? Row().spring.enabled : false;
}
ErrorCode PrismaticJoint::EnableSpring(bool flag) {
    return scree::EnableSpring(JointEdit(m_state, this, "PrismaticJoint::EnableSpring"), Row().spring, flag);
}
ErrorCode PrismaticJoint::SetSpring(float stiffness, float damping) {
    return scree::SetSpring(JointEdit(m_state, this, "PrismaticJoint::SetSpring"), Row().spring, stiffness, damping);
}
float PrismaticJoint::GetStiffness() const {
    return Lives("PrismaticJoint::GetStiffness") ? Row().spring.stiffness : 0.0f;
}
float PrismaticJoint::GetDamping() const { return Lives("PrismaticJoint::GetDamping") ? Row().spring.damping : 0.0f; }
ErrorCode PrismaticJoint::SetTargetTranslation(float translation) {
    return JointEdit(m_state, this, "PrismaticJoint::SetTargetTranslation")
        .Finite(translation, "translation")
        .SetAndWake(Row().spring.target, translation);
}
float PrismaticJoint::GetTargetTranslation() const {
    return Lives("PrismaticJoint::GetTargetTranslation") ? Row().spring.target : 0.0f;
}
ErrorCode PrismaticJoint::SetMaxSpringForce(float force) {
    return JointEdit(m_state, this, "PrismaticJoint::SetMaxSpringForce")
        .Bound(force, "force")
        .SetAndWake(Row().spring.maximum, force);
}
float PrismaticJoint::GetMaxSpringForce() const {
    return Lives("PrismaticJoint::GetMaxSpringForce") ? Row().spring.maximum : 0.0f;
}
float PrismaticJoint::GetSpringForce(float inverseDt) const {
    return Lives("PrismaticJoint::GetSpringForce") ? inverseDt * Row().spring.impulse : 0.0f;
}

}  // namespace scree
