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

Vec2 WeldJoint::GetAnchorA() const { return GetBodyA()->GetWorldPoint(Row().localAnchorA); }
Vec2 WeldJoint::GetAnchorB() const { return GetBodyB()->GetWorldPoint(Row().localAnchorB); }
Vec2 WeldJoint::GetReactionForce(float inverseDt) const { return inverseDt * Row().impulse; }
float WeldJoint::GetReactionTorque(float inverseDt) const { return inverseDt * Row().turnImpulse; }
Vec2 WeldJoint::GetLocalAnchorA() const { return Row().localAnchorA; }
Vec2 WeldJoint::GetLocalAnchorB() const { return Row().localAnchorB; }
float WeldJoint::GetReferenceAngle() const { return Row().referenceAngle; }

ErrorCode WeldJoint::SetStiffness(float stiffness) {
    return JointEdit(m_state, this, "WeldJoint::SetStiffness")
        .Amount(stiffness, "stiffness")
        .Set(Row().stiffness, stiffness);
}
float WeldJoint::GetStiffness() const { return Row().stiffness; }
ErrorCode WeldJoint::SetDamping(float damping) {
    return JointEdit(m_state, this, "WeldJoint::SetDamping").Amount(damping, "damping").Set(Row().damping, damping);
}
float WeldJoint::GetDamping() const { return Row().damping; }

}  // namespace scree
