// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Motor joint: definition and handle.

#include "scree/motor_joint.h"

#include "state/frames.h"
#include "world/joints/joint_access.h"
#include "world/joints/joint_definitions.h"

namespace scree {

MotorRow& MotorJoint::Row() const { return RowOf<MotorRow>(m_state, m_row); }

void MotorJointDef::Initialize(Body* a, Body* b) {
    bodyA = a;
    bodyB = b;
    if (a == nullptr || b == nullptr) return;  // CreateJoint says so, and so if they do not live in one world
    const WorldState& s = a->GetWorld()->GetState();
    if (!Owns(s, a) || !Owns(s, b)) return;
    const BodyTable& bodies = s.bodies;
    linearOffset = a->GetLocalVector(GapBetween(bodies, IndexOf(*a), vec2Zero, IndexOf(*b), vec2Zero));
    angularOffset = b->GetAngle() - a->GetAngle();
}

void Check(const MotorJointDef& def, Guard& guard) {
    guard.Finite(def.linearOffset, "MotorJointDef::linearOffset")
        .Finite(def.angularOffset, "MotorJointDef::angularOffset")
        .Amount(def.maxForce, "MotorJointDef::maxForce")
        .Amount(def.maxTorque, "MotorJointDef::maxTorque")
        .Amount(def.correctionFactor, "MotorJointDef::correctionFactor")
        .Require(def.correctionFactor <= 1.0f, ErrorCode::outOfRange, "MotorJointDef::correctionFactor",
                 "give a share from 0 to 1");
}

MotorRow MakeRow(const MotorJointDef& def) {
    return {.linearOffset = def.linearOffset,
            .angularOffset = def.angularOffset,
            .maxForce = def.maxForce,
            .maxTorque = def.maxTorque,
            .correctionFactor = def.correctionFactor};
}

Vec2 MotorJoint::GetAnchorA() const { return Lives("MotorJoint::GetAnchorA") ? GetBodyA()->GetPosition() : vec2Zero; }
Vec2 MotorJoint::GetAnchorB() const { return Lives("MotorJoint::GetAnchorB") ? GetBodyB()->GetPosition() : vec2Zero; }
Vec2 MotorJoint::GetReactionForce(float inverseDt) const {
    return Lives("MotorJoint::GetReactionForce") ? inverseDt * Row().impulse : vec2Zero;
}
float MotorJoint::GetReactionTorque(float inverseDt) const {
    return Lives("MotorJoint::GetReactionTorque") ? inverseDt * Row().turnImpulse : 0.0f;
}

ErrorCode MotorJoint::SetLinearOffset(Vec2 linearOffset) {
    return JointEdit(m_state, this, "MotorJoint::SetLinearOffset")
        .Finite(linearOffset, "linearOffset")
        .SetAndWake(Row().linearOffset, linearOffset);
}
Vec2 MotorJoint::GetLinearOffset() const {
    return Lives("MotorJoint::GetLinearOffset") ? Row().linearOffset : vec2Zero;
}
ErrorCode MotorJoint::SetAngularOffset(float angularOffset) {
    return JointEdit(m_state, this, "MotorJoint::SetAngularOffset")
        .Finite(angularOffset, "angularOffset")
        .SetAndWake(Row().angularOffset, angularOffset);
}
float MotorJoint::GetAngularOffset() const {
    return Lives("MotorJoint::GetAngularOffset") ? Row().angularOffset : 0.0f;
}
ErrorCode MotorJoint::SetMaxForce(float force) {
    return JointEdit(m_state, this, "MotorJoint::SetMaxForce").Amount(force, "force").Set(Row().maxForce, force);
}
float MotorJoint::GetMaxForce() const { return Lives("MotorJoint::GetMaxForce") ? Row().maxForce : 0.0f; }
ErrorCode MotorJoint::SetMaxTorque(float torque) {
    return JointEdit(m_state, this, "MotorJoint::SetMaxTorque").Amount(torque, "torque").Set(Row().maxTorque, torque);
}
float MotorJoint::GetMaxTorque() const { return Lives("MotorJoint::GetMaxTorque") ? Row().maxTorque : 0.0f; }
ErrorCode MotorJoint::SetCorrectionFactor(float factor) {
    return JointEdit(m_state, this, "MotorJoint::SetCorrectionFactor")
        .Amount(factor, "factor")
        .Require(factor <= 1.0f, "factor", "give a share from 0 to 1")
        .Set(Row().correctionFactor, factor);
}
float MotorJoint::GetCorrectionFactor() const {
    return Lives("MotorJoint::GetCorrectionFactor") ? Row().correctionFactor : 0.0f;
}

}  // namespace scree
