// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// b2WeldJoint.

#include "../box2d/b2_weld_joint.h"

#include "../box2d/b2_body.h"
#include "joint_handle.h"

using namespace scree::box2d;

void b2WeldJointDef::Initialize(b2Body* bA, b2Body* bB, const b2Vec2& anchor) {
    bodyA = bA;
    bodyB = bB;
    localAnchorA = bA->GetLocalPoint(anchor);
    localAnchorB = bB->GetLocalPoint(anchor);
    referenceAngle = bB->GetAngle() - bA->GetAngle();
}

float b2WeldJoint::GetReferenceAngle() const { return As<scree::WeldJoint>(m_handle).GetReferenceAngle(); }
void b2WeldJoint::SetStiffness(float stiffness) { As<scree::WeldJoint>(m_handle).SetStiffness(stiffness); }
float b2WeldJoint::GetStiffness() const { return As<scree::WeldJoint>(m_handle).GetStiffness(); }
void b2WeldJoint::SetDamping(float damping) { As<scree::WeldJoint>(m_handle).SetDamping(damping); }
float b2WeldJoint::GetDamping() const { return As<scree::WeldJoint>(m_handle).GetDamping(); }
