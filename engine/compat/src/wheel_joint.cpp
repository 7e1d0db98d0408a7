// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// b2WheelJoint.

#include "../box2d/b2_wheel_joint.h"

#include "../box2d/b2_body.h"
#include "joint_draw.h"
#include "joint_handle.h"

using namespace scree::box2d;

void b2WheelJointDef::Initialize(b2Body* bA, b2Body* bB, const b2Vec2& anchor, const b2Vec2& axis) {
    bodyA = bA;
    bodyB = bB;
    localAnchorA = bA->GetLocalPoint(anchor);
    localAnchorB = bB->GetLocalPoint(anchor);
    localAxisA = bA->GetLocalVector(axis);
}

float b2WheelJoint::GetJointTranslation() const { return As<scree::WheelJoint>(m_handle).GetJointTranslation(); }
float b2WheelJoint::GetJointLinearSpeed() const { return As<scree::WheelJoint>(m_handle).GetJointLinearSpeed(); }
float b2WheelJoint::GetJointAngle() const { return As<scree::WheelJoint>(m_handle).GetJointAngle(); }
float b2WheelJoint::GetJointAngularSpeed() const { return As<scree::WheelJoint>(m_handle).GetJointAngularSpeed(); }
bool b2WheelJoint::IsLimitEnabled() const { return As<scree::WheelJoint>(m_handle).IsLimitEnabled(); }
void b2WheelJoint::EnableLimit(bool flag) { As<scree::WheelJoint>(m_handle).EnableLimit(flag); }
float b2WheelJoint::GetLowerLimit() const { return As<scree::WheelJoint>(m_handle).GetLowerLimit(); }
float b2WheelJoint::GetUpperLimit() const { return As<scree::WheelJoint>(m_handle).GetUpperLimit(); }
void b2WheelJoint::SetLimits(float lower, float upper) { As<scree::WheelJoint>(m_handle).SetLimits(lower, upper); }
bool b2WheelJoint::IsMotorEnabled() const { return As<scree::WheelJoint>(m_handle).IsMotorEnabled(); }
void b2WheelJoint::EnableMotor(bool flag) { As<scree::WheelJoint>(m_handle).EnableMotor(flag); }
void b2WheelJoint::SetMotorSpeed(float speed) { As<scree::WheelJoint>(m_handle).SetMotorSpeed(speed); }
float b2WheelJoint::GetMotorSpeed() const { return As<scree::WheelJoint>(m_handle).GetMotorSpeed(); }
void b2WheelJoint::SetMaxMotorTorque(float torque) { As<scree::WheelJoint>(m_handle).SetMaxMotorTorque(torque); }
float b2WheelJoint::GetMaxMotorTorque() const { return As<scree::WheelJoint>(m_handle).GetMaxMotorTorque(); }
float b2WheelJoint::GetMotorTorque(float inv_dt) const {
    return As<scree::WheelJoint>(m_handle).GetMotorTorque(inv_dt);
}
void b2WheelJoint::SetStiffness(float stiffness) { As<scree::WheelJoint>(m_handle).SetStiffness(stiffness); }
float b2WheelJoint::GetStiffness() const { return As<scree::WheelJoint>(m_handle).GetStiffness(); }
void b2WheelJoint::SetDamping(float damping) { As<scree::WheelJoint>(m_handle).SetDamping(damping); }
float b2WheelJoint::GetDamping() const { return As<scree::WheelJoint>(m_handle).GetDamping(); }
void b2WheelJoint::Draw(b2Draw* draw) const {
    DrawSlider(*draw, {GetAnchorA(), GetAnchorB(), m_bodyA->GetWorldVector(m_localAxisA), IsLimitEnabled(),
                       GetLowerLimit(), GetUpperLimit()});
}
