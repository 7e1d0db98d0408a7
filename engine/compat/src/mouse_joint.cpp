// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// b2MouseJoint.

#include "../box2d/b2_mouse_joint.h"

#include "joint_handle.h"

using namespace scree::box2d;

void b2MouseJoint::SetTarget(const b2Vec2& target) { As<scree::MouseJoint>(m_handle).SetTarget(ToScree(target)); }
const b2Vec2& b2MouseJoint::GetTarget() const {
    m_target = ToBox2d(As<scree::MouseJoint>(m_handle).GetTarget());
    return m_target;
}
void b2MouseJoint::SetMaxForce(float force) { As<scree::MouseJoint>(m_handle).SetMaxForce(force); }
float b2MouseJoint::GetMaxForce() const { return As<scree::MouseJoint>(m_handle).GetMaxForce(); }
void b2MouseJoint::SetStiffness(float stiffness) { As<scree::MouseJoint>(m_handle).SetStiffness(stiffness); }
float b2MouseJoint::GetStiffness() const { return As<scree::MouseJoint>(m_handle).GetStiffness(); }
void b2MouseJoint::SetDamping(float damping) { As<scree::MouseJoint>(m_handle).SetDamping(damping); }
float b2MouseJoint::GetDamping() const { return As<scree::MouseJoint>(m_handle).GetDamping(); }
