// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Weld joint: definition and handle.

#include "scree/weld_joint.h"

#include "world/joints/joint_access.h"
#include "world/joints/joint_definitions.h"

namespace scree {

WeldRow& WeldJoint::Row() const { return RowOf<WeldRow>(m_state, m_row); }

void WeldJointDef::Initialize(Body* a, Body* b, Vec2 anchor) {
    bodyA = a;
    bodyB = b;
    if (a == nullptr || b == nullptr) return;  // CreateJoint says so
    localAnchorA = a->GetLocalPoint(anchor);
    localAnchorB = b->GetLocalPoint(anchor);
    referenceAngle = b->GetAngle() - a->GetAngle();
}

void Check(const WeldJointDef& def, Guard& guard) {
    guard.Finite(def.localAnchorA, "WeldJointDef::localAnchorA")
        .Finite(def.localAnchorB, "WeldJointDef::localAnchorB")
        .Finite(def.referenceAngle, "WeldJointDef::referenceAngle")
        .Amount(def.stiffness, "WeldJointDef::stiffness")
        .Amount(def.damping, "WeldJointDef::damping");
}

WeldRow MakeRow(const WeldJointDef& def) {
    return {.localAnchorA = def.localAnchorA,
            .localAnchorB = def.localAnchorB,
            .referenceAngle = def.referenceAngle,
            .stiffness = def.stiffness,
            .damping = def.damping};
}

Vec2 WeldJoint::GetAnchorA() const {
    return Lives("WeldJoint::GetAnchorA") ? GetBodyA()->GetWorldPoint(Row().localAnchorA) : vec2Zero;
}
Vec2 WeldJoint::GetAnchorB() const {
    return Lives("WeldJoint::GetAnchorB") ? GetBodyB()->GetWorldPoint(Row().localAnchorB) : vec2Zero;
}
Vec2 WeldJoint::GetReactionForce(float inverseDt) const {
    return Lives("WeldJoint::GetReactionForce") ? inverseDt * Row().impulse : vec2Zero;
}
float WeldJoint::GetReactionTorque(float inverseDt) const {
    return Lives("WeldJoint::GetReactionTorque") ? inverseDt * Row().turnImpulse : 0.0f;
}
Vec2 WeldJoint::GetLocalAnchorA() const { return Lives("WeldJoint::GetLocalAnchorA") ? Row().localAnchorA : vec2Zero; }
Vec2 WeldJoint::GetLocalAnchorB() const { return Lives("WeldJoint::GetLocalAnchorB") ? Row().localAnchorB : vec2Zero; }
float WeldJoint::GetReferenceAngle() const {
    return Lives("WeldJoint::GetReferenceAngle") ? Row().referenceAngle : 0.0f;
}

ErrorCode WeldJoint::SetStiffness(float stiffness) {
    return JointEdit(m_state, this, "WeldJoint::SetStiffness")
        .Amount(stiffness, "stiffness")
        .Set(Row().stiffness, stiffness);
}
float WeldJoint::GetStiffness() const { return Lives("WeldJoint::GetStiffness") ? Row().stiffness : 0.0f; }
ErrorCode WeldJoint::SetDamping(float damping) {
    return JointEdit(m_state, this, "WeldJoint::SetDamping").Amount(damping, "damping").Set(Row().damping, damping);
}
float WeldJoint::GetDamping() const { return Lives("WeldJoint::GetDamping") ? Row().damping : 0.0f; }

}  // namespace scree
