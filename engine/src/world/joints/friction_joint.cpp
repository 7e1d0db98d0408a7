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

Vec2 FrictionJoint::GetAnchorA() const {
    return Lives("FrictionJoint::GetAnchorA") ? GetBodyA()->GetWorldPoint(Row().localAnchorA) : vec2Zero;
}
Vec2 FrictionJoint::GetAnchorB() const {
    return Lives("FrictionJoint::GetAnchorB") ? GetBodyB()->GetWorldPoint(Row().localAnchorB) : vec2Zero;
}
Vec2 FrictionJoint::GetReactionForce(float inverseDt) const {
    return Lives("FrictionJoint::GetReactionForce") ? inverseDt * Row().impulse : vec2Zero;
}
float FrictionJoint::GetReactionTorque(float inverseDt) const {
    return Lives("FrictionJoint::GetReactionTorque") ? inverseDt * Row().turnImpulse : 0.0f;
}
Vec2 FrictionJoint::GetLocalAnchorA() const {
    return Lives("FrictionJoint::GetLocalAnchorA") ? Row().localAnchorA : vec2Zero;
}
Vec2 FrictionJoint::GetLocalAnchorB() const {
    return Lives("FrictionJoint::GetLocalAnchorB") ? Row().localAnchorB : vec2Zero;
}

ErrorCode FrictionJoint::SetMaxForce(float force) {
    return JointEdit(m_state, this, "FrictionJoint::SetMaxForce").Amount(force, "force").Set(Row().maxForce, force);
}
float FrictionJoint::GetMaxForce() const { return Lives("FrictionJoint::GetMaxForce") ? Row().maxForce : 0.0f; }
ErrorCode FrictionJoint::SetMaxTorque(float torque) {
    return JointEdit(m_state, this, "FrictionJoint::SetMaxTorque")
        .Amount(torque, "torque")
        .Set(Row().maxTorque, torque);
}
float FrictionJoint::GetMaxTorque() const { return Lives("FrictionJoint::GetMaxTorque") ? Row().maxTorque : 0.0f; }

}  // namespace scree
