// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Distance joint: definition and handle.

#include "scree/distance_joint.h"

#include "world/joints/joint_access.h"
#include "world/joints/joint_definitions.h"

namespace scree {

DistanceRow& DistanceJoint::Row() const { return RowOf<DistanceRow>(m_state, m_row); }

void DistanceJointDef::Initialize(Body* a, Body* b, Vec2 anchorA, Vec2 anchorB) {
    bodyA = a;
    bodyB = b;
    if (a == nullptr || b == nullptr) return;  // CreateJoint says so
    localAnchorA = a->GetLocalPoint(anchorA);
    localAnchorB = b->GetLocalPoint(anchorB);
    length = Distance(anchorA, anchorB);
    minLength = length;
    maxLength = length;
}

void Check(const DistanceJointDef& def, Guard& guard) {
    guard.Finite(def.localAnchorA, "DistanceJointDef::localAnchorA")
        .Finite(def.localAnchorB, "DistanceJointDef::localAnchorB")
        .Amount(def.length, "DistanceJointDef::length")
        .Amount(def.minLength, "DistanceJointDef::minLength")
        .Amount(def.maxLength, "DistanceJointDef::maxLength")
        .Require(def.minLength <= def.maxLength, ErrorCode::outOfRange, "DistanceJointDef::minLength",
                 "keep it at or below maxLength")
        .Amount(def.stiffness, "DistanceJointDef::stiffness")
        .Amount(def.damping, "DistanceJointDef::damping")
        .Require(def.maxSpringForce >= 0.0f, ErrorCode::outOfRange, "DistanceJointDef::maxSpringForce",
                 "give a number of at least 0");
}

DistanceRow MakeRow(const DistanceJointDef& def, float slop) {
    const float lower = Max(def.minLength, slop);
    return {.localAnchorA = def.localAnchorA,
            .localAnchorB = def.localAnchorB,
            .length = Max(def.length, slop),
            .stiffness = def.stiffness,
            .damping = def.damping,
            .maxSpringForce = def.maxSpringForce,
            .shortest = slop,
            .limit = {.enabled = true, .lower = lower, .upper = Max(def.maxLength, lower)}};
}

Vec2 DistanceJoint::GetAnchorA() const {
    return Lives("DistanceJoint::GetAnchorA") ? GetBodyA()->GetWorldPoint(Row().localAnchorA) : vec2Zero;
}
Vec2 DistanceJoint::GetAnchorB() const {
    return Lives("DistanceJoint::GetAnchorB") ? GetBodyB()->GetWorldPoint(Row().localAnchorB) : vec2Zero;
}
Vec2 DistanceJoint::GetReactionForce(float inverseDt) const {
    if (!Lives("DistanceJoint::GetReactionForce")) return vec2Zero;
    const DistanceRow& row = Row();
    return (inverseDt * (row.impulse + row.limit.lowerImpulse - row.limit.upperImpulse)) * row.axis;
}
float DistanceJoint::GetReactionTorque(float) const {
    (void)Lives("DistanceJoint::GetReactionTorque");
    return 0.0f;
}
Vec2 DistanceJoint::GetLocalAnchorA() const {
    return Lives("DistanceJoint::GetLocalAnchorA") ? Row().localAnchorA : vec2Zero;
}
Vec2 DistanceJoint::GetLocalAnchorB() const {
    return Lives("DistanceJoint::GetLocalAnchorB") ? Row().localAnchorB : vec2Zero;
}
float DistanceJoint::GetLength() const { return Lives("DistanceJoint::GetLength") ? Row().length : 0.0f; }
ErrorCode DistanceJoint::SetLength(float length) {
    JointEdit edit = JointEdit(m_state, this, "DistanceJoint::SetLength").Amount(length, "length");
    if (!edit.Failed()) Row().impulse = 0.0f;
    return edit.Set(Row().length, Max(length, Row().shortest));
}
float DistanceJoint::GetMinLength() const { return Lives("DistanceJoint::GetMinLength") ? Row().limit.lower : 0.0f; }
ErrorCode DistanceJoint::SetMinLength(float minLength) {
    JointEdit edit = JointEdit(m_state, this, "DistanceJoint::SetMinLength").Amount(minLength, "minLength");
    const ErrorCode code = edit.Set(Row().limit.lower, Clamp(minLength, Row().shortest, Row().limit.upper));
    if (code == ErrorCode::ok) Row().limit.lowerImpulse = 0.0f;
    return code;
}
float DistanceJoint::GetMaxLength() const { return Lives("DistanceJoint::GetMaxLength") ? Row().limit.upper : 0.0f; }
ErrorCode DistanceJoint::SetMaxLength(float maxLength) {
    JointEdit edit = JointEdit(m_state, this, "DistanceJoint::SetMaxLength").Amount(maxLength, "maxLength");
    const ErrorCode code = edit.Set(Row().limit.upper, Max(maxLength, Row().limit.lower));
    if (code == ErrorCode::ok) Row().limit.upperImpulse = 0.0f;
    return code;
}
float DistanceJoint::GetCurrentLength() const {
    if (!Lives("DistanceJoint::GetCurrentLength")) return 0.0f;
    return GetAnchorGap(*this, Row().localAnchorA, Row().localAnchorB).Length();
}

ErrorCode DistanceJoint::SetStiffness(float stiffness) {
    return JointEdit(m_state, this, "DistanceJoint::SetStiffness")
        .Amount(stiffness, "stiffness")
        .Set(Row().stiffness, stiffness);
}
float DistanceJoint::GetStiffness() const { return Lives("DistanceJoint::GetStiffness") ? Row().stiffness : 0.0f; }
ErrorCode DistanceJoint::SetDamping(float damping) {
    return JointEdit(m_state, this, "DistanceJoint::SetDamping").Amount(damping, "damping").Set(Row().damping, damping);
}
float DistanceJoint::GetDamping() const { return Lives("DistanceJoint::GetDamping") ? Row().damping : 0.0f; }
ErrorCode DistanceJoint::SetMaxSpringForce(float force) {
    return JointEdit(m_state, this, "DistanceJoint::SetMaxSpringForce")
        .Bound(force, "force")
        .Set(Row().maxSpringForce, force);
}
float DistanceJoint::GetMaxSpringForce() const {
    return Lives("DistanceJoint::GetMaxSpringForce") ? Row().maxSpringForce : 0.0f;
}

}  // namespace scree
