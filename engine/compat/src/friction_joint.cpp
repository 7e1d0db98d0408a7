// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// b2FrictionJoint.

#include "../box2d/b2_friction_joint.h"

#include "../box2d/b2_body.h"
#include "joint_handle.h"

using namespace scree::box2d;

void b2FrictionJointDef::Initialize(b2Body* bA, b2Body* bB, const b2Vec2& anchor) {
    bodyA = bA;
    bodyB = bB;
    localAnchorA = bA->GetLocalPoint(anchor);
    localAnchorB = bB->GetLocalPoint(anchor);
}

void b2FrictionJoint::SetMaxForce(float force) { As<scree::FrictionJoint>(m_handle).SetMaxForce(force); }
float b2FrictionJoint::GetMaxForce() const { return As<scree::FrictionJoint>(m_handle).GetMaxForce(); }
void b2FrictionJoint::SetMaxTorque(float torque) { As<scree::FrictionJoint>(m_handle).SetMaxTorque(torque); }
float b2FrictionJoint::GetMaxTorque() const { return As<scree::FrictionJoint>(m_handle).GetMaxTorque(); }
