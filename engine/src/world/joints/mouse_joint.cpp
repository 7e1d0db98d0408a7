// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Mouse joint: definition and handle.

#include "scree/mouse_joint.h"

#include "world/joints/joint_access.h"
#include "world/joints/joint_definitions.h"

namespace scree {

MouseRow& MouseJoint::Row() const { return RowOf<MouseRow>(m_state, m_row); }

void Check(const MouseJointDef& def, Guard& guard) {
    guard.Finite(def.target, "MouseJointDef::target")
        .Amount(def.maxForce, "MouseJointDef::maxForce")
        .Amount(def.stiffness, "MouseJointDef::stiffness")
        .Amount(def.damping, "MouseJointDef::damping");
}

MouseRow MakeRow(const MouseJointDef& def) {
    return {.target = def.target,
            .localAnchorB = def.bodyB->GetLocalPoint(def.target),
            .maxForce = def.maxForce,
            .stiffness = def.stiffness,
            .damping = def.damping};
}

Vec2 MouseJoint::GetAnchorA() const { return Lives("MouseJoint::GetAnchorA") ? Row().target : vec2Zero; }
Vec2 MouseJoint::GetAnchorB() const {
    return Lives("MouseJoint::GetAnchorB") ? GetBodyB()->GetWorldPoint(Row().localAnchorB) : vec2Zero;
}
Vec2 MouseJoint::GetReactionForce(float inverseDt) const {
    return Lives("MouseJoint::GetReactionForce") ? inverseDt * Row().impulse : vec2Zero;
}
float MouseJoint::GetReactionTorque(float) const {
    (void)Lives("MouseJoint::GetReactionTorque");
    return 0.0f;
}

ErrorCode MouseJoint::SetTarget(Vec2 target) {
    JointEdit edit = JointEdit(m_state, this, "MouseJoint::SetTarget").Finite(target, "target");
    if (edit.Failed()) return edit.Code();
    const Recording recording = edit.Record(target);  // here, since waking would be recorded as a call of its own
    if (!(Row().target == target)) GetBodyB()->SetAwake(true);
    return edit.Set(Row().target, target);
}
Vec2 MouseJoint::GetTarget() const { return Lives("MouseJoint::GetTarget") ? Row().target : vec2Zero; }
ErrorCode MouseJoint::SetMaxForce(float force) {
    return JointEdit(m_state, this, "MouseJoint::SetMaxForce").Amount(force, "force").Set(Row().maxForce, force);
}
float MouseJoint::GetMaxForce() const { return Lives("MouseJoint::GetMaxForce") ? Row().maxForce : 0.0f; }

ErrorCode MouseJoint::SetStiffness(float stiffness) {
    return JointEdit(m_state, this, "MouseJoint::SetStiffness")
        .Amount(stiffness, "stiffness")
        .Set(Row().stiffness, stiffness);
}
float MouseJoint::GetStiffness() const { return Lives("MouseJoint::GetStiffness") ? Row().stiffness : 0.0f; }
ErrorCode MouseJoint::SetDamping(float damping) {
    return JointEdit(m_state, this, "MouseJoint::SetDamping").Amount(damping, "damping").Set(Row().damping, damping);
}
float MouseJoint::GetDamping() const { return Lives("MouseJoint::GetDamping") ? Row().damping : 0.0f; }

}  // namespace scree
