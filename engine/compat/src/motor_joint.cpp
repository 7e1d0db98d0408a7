// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// b2MotorJoint.

#include "../box2d/b2_motor_joint.h"

#include "../box2d/b2_body.h"
#include "joint_handle.h"

using namespace scree::box2d;
using Engine = scree::MotorJoint;

void b2MotorJointDef::Initialize(b2Body* bA, b2Body* bB) {
    bodyA = bA;
    bodyB = bB;
    linearOffset = bA->GetLocalPoint(bB->GetPosition());
    angularOffset = bB->GetAngle() - bA->GetAngle();
}

void b2MotorJoint::SetLinearOffset(const b2Vec2& linearOffset) {
    As<Engine>(m_handle).SetLinearOffset(ToScree(linearOffset));
}
const b2Vec2& b2MotorJoint::GetLinearOffset() const {
    m_linearOffset = ToBox2d(As<Engine>(m_handle).GetLinearOffset());
    return m_linearOffset;
}
void b2MotorJoint::SetAngularOffset(float angularOffset) { As<Engine>(m_handle).SetAngularOffset(angularOffset); }
float b2MotorJoint::GetAngularOffset() const { return As<Engine>(m_handle).GetAngularOffset(); }
void b2MotorJoint::SetMaxForce(float force) { As<Engine>(m_handle).SetMaxForce(force); }
float b2MotorJoint::GetMaxForce() const { return As<Engine>(m_handle).GetMaxForce(); }
void b2MotorJoint::SetMaxTorque(float torque) { As<Engine>(m_handle).SetMaxTorque(torque); }
float b2MotorJoint::GetMaxTorque() const { return As<Engine>(m_handle).GetMaxTorque(); }
void b2MotorJoint::SetCorrectionFactor(float factor) { As<Engine>(m_handle).SetCorrectionFactor(factor); }
float b2MotorJoint::GetCorrectionFactor() const { return As<Engine>(m_handle).GetCorrectionFactor(); }
