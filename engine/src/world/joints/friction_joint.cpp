// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Friction joint: definition and handle.

#include "scree/friction_joint.h"

#include "world/joints/joint_access.h"
#include "world/joints/joint_definitions.h"

namespace scree {

FrictionRow& FrictionJoint::Row() const { return RowOf<FrictionRow>(m_state, m_row); }

void FrictionJointDef::Initialize(Body* a, Body* b, Vec2 anchor) {
    bodyA = a;
    bodyB = b;
    if (a == nullptr || b == nullptr) return;  // CreateJoint says so
    localAnchorA = a->GetLocalPoint(anchor);
    localAnchorB = b->GetLocalPoint(anchor);
}

void Check(const FrictionJointDef& def, Guard& guard) {
    guard.Finite(def.localAnchorA, "FrictionJointDef::localAnchorA")
        .Finite(def.localAnchorB, "FrictionJointDef::localAnchorB")
        .Amount(def.maxForce, "FrictionJointDef::maxForce")
        .Amount(def.maxTorque, "FrictionJointDef::maxTorque");
}

FrictionRow MakeRow(const FrictionJointDef& def) {
    return {.localAnchorA = def.localAnchorA,
            .localAnchorB = def.localAnchorB,
            .maxForce = def.maxForce,
            .maxTorque = def.maxTorque};
}

Vec2 FrictionJoint::GetAnchorA() const { return GetBodyA()->GetWorldPoint(Row().localAnchorA); }
Vec2 FrictionJoint::GetAnchorB() const { return GetBodyB()->GetWorldPoint(Row().localAnchorB); }
Vec2 FrictionJoint::GetReactionForce(float inverseDt) const { return inverseDt * Row().impulse; }
float FrictionJoint::GetReactionTorque(float inverseDt) const { return inverseDt * Row().turnImpulse; }
Vec2 FrictionJoint::GetLocalAnchorA() const { return Row().localAnchorA; }
Vec2 FrictionJoint::GetLocalAnchorB() const { return Row().localAnchorB; }

ErrorCode FrictionJoint::SetMaxForce(float force) {
    return JointEdit(m_state, this, "FrictionJoint::SetMaxForce").Amount(force, "force").Set(Row().maxForce, force);
}
float FrictionJoint::GetMaxForce() const { return Row().maxForce; }
ErrorCode FrictionJoint::SetMaxTorque(float torque) {
    return JointEdit(m_state, this, "FrictionJoint::SetMaxTorque")
        .Amount(torque, "torque")
        .Set(Row().maxTorque, torque);
}
float FrictionJoint::GetMaxTorque() const { return Row().maxTorque; }

}  // namespace scree
