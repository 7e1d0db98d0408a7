// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// b2PrismaticJoint.

#include "../box2d/b2_prismatic_joint.h"

#include "../box2d/b2_body.h"
#include "joint_draw.h"
#include "joint_handle.h"

using namespace scree::box2d;

void b2PrismaticJointDef::Initialize(b2Body* bA, b2Body* bB, const b2Vec2& anchor, const b2Vec2& axis) {
    bodyA = bA;
    bodyB = bB;
    localAnchorA = bA->GetLocalPoint(anchor);
    localAnchorB = bB->GetLocalPoint(anchor);
    localAxisA = bA->GetLocalVector(axis);
    referenceAngle = bB->GetAngle() - bA->GetAngle();
}

float b2PrismaticJoint::GetReferenceAngle() const { return As<scree::PrismaticJoint>(m_handle).GetReferenceAngle(); }
float b2PrismaticJoint::GetJointTranslation() const {
    return As<scree::PrismaticJoint>(m_handle).GetJointTranslation();
}
float b2PrismaticJoint::GetJointSpeed() const { return As<scree::PrismaticJoint>(m_handle).GetJointSpeed(); }
bool b2PrismaticJoint::IsLimitEnabled() const { return As<scree::PrismaticJoint>(m_handle).IsLimitEnabled(); }
void b2PrismaticJoint::EnableLimit(bool flag) { As<scree::PrismaticJoint>(m_handle).EnableLimit(flag); }
float b2PrismaticJoint::GetLowerLimit() const { return As<scree::PrismaticJoint>(m_handle).GetLowerLimit(); }
float b2PrismaticJoint::GetUpperLimit() const { return As<scree::PrismaticJoint>(m_handle).GetUpperLimit(); }
void b2PrismaticJoint::SetLimits(float lower, float upper) {
    As<scree::PrismaticJoint>(m_handle).SetLimits(lower, upper);
}
bool b2PrismaticJoint::IsMotorEnabled() const { return As<scree::PrismaticJoint>(m_handle).IsMotorEnabled(); }
void b2PrismaticJoint::EnableMotor(bool flag) { As<scree::PrismaticJoint>(m_handle).EnableMotor(flag); }
void b2PrismaticJoint::SetMotorSpeed(float speed) { As<scree::PrismaticJoint>(m_handle).SetMotorSpeed(speed); }
float b2PrismaticJoint::GetMotorSpeed() const { return As<scree::PrismaticJoint>(m_handle).GetMotorSpeed(); }
void b2PrismaticJoint::SetMaxMotorForce(float force) { As<scree::PrismaticJoint>(m_handle).SetMaxMotorForce(force); }
float b2PrismaticJoint::GetMaxMotorForce() const { return As<scree::PrismaticJoint>(m_handle).GetMaxMotorForce(); }
float b2PrismaticJoint::GetMotorForce(float inv_dt) const {
    return As<scree::PrismaticJoint>(m_handle).GetMotorForce(inv_dt);
}
void b2PrismaticJoint::Draw(b2Draw* draw) const {
    DrawSlider(*draw, {GetAnchorA(), GetAnchorB(), m_bodyA->GetWorldVector(m_localAxisA), IsLimitEnabled(),
                       GetLowerLimit(), GetUpperLimit()});
}
