// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// b2MotorJoint.

#include "../box2d/b2_motor_joint.h"

#include "../box2d/b2_body.h"
#include "joint_handle.h"

using namespace scree::box2d;

void b2MotorJointDef::Initialize(b2Body* bA, b2Body* bB) {
    bodyA = bA;
    bodyB = bB;
    linearOffset = bA->GetLocalPoint(bB->GetPosition());
    angularOffset = bB->GetAngle() - bA->GetAngle();
}

void b2MotorJoint::SetLinearOffset(const b2Vec2& linearOffset) {
    As<scree::MotorJoint>(m_handle).SetLinearOffset(ToScree(linearOffset));
}
const b2Vec2& b2MotorJoint::GetLinearOffset() const {
    m_linearOffset = ToBox2d(As<scree::MotorJoint>(m_handle).GetLinearOffset());
    return m_linearOffset;
}
void b2MotorJoint::SetAngularOffset(float angularOffset) {
    As<scree::MotorJoint>(m_handle).SetAngularOffset(angularOffset);
}
float b2MotorJoint::GetAngularOffset() const { return As<scree::MotorJoint>(m_handle).GetAngularOffset(); }
void b2MotorJoint::SetMaxForce(float force) { As<scree::MotorJoint>(m_handle).SetMaxForce(force); }
float b2MotorJoint::GetMaxForce() const { return As<scree::MotorJoint>(m_handle).GetMaxForce(); }
void b2MotorJoint::SetMaxTorque(float torque) { As<scree::MotorJoint>(m_handle).SetMaxTorque(torque); }
float b2MotorJoint::GetMaxTorque() const { return As<scree::MotorJoint>(m_handle).GetMaxTorque(); }
void b2MotorJoint::SetCorrectionFactor(float factor) { As<scree::MotorJoint>(m_handle).SetCorrectionFactor(factor); }
float b2MotorJoint::GetCorrectionFactor() const { return As<scree::MotorJoint>(m_handle).GetCorrectionFactor(); }
