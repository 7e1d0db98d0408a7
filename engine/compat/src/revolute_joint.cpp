// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// b2RevoluteJoint.

#include "../box2d/b2_revolute_joint.h"

#include "../box2d/b2_body.h"
#include "joint_draw.h"
#include "joint_handle.h"

using namespace scree::box2d;

void b2RevoluteJointDef::Initialize(b2Body* bA, b2Body* bB, const b2Vec2& anchor) {
    bodyA = bA;
    bodyB = bB;
    localAnchorA = bA->GetLocalPoint(anchor);
    localAnchorB = bB->GetLocalPoint(anchor);
    referenceAngle = bB->GetAngle() - bA->GetAngle();
}

float b2RevoluteJoint::GetReferenceAngle() const { return As<scree::RevoluteJoint>(m_handle).GetReferenceAngle(); }
float b2RevoluteJoint::GetJointAngle() const { return As<scree::RevoluteJoint>(m_handle).GetJointAngle(); }
float b2RevoluteJoint::GetJointSpeed() const { return As<scree::RevoluteJoint>(m_handle).GetJointSpeed(); }
bool b2RevoluteJoint::IsLimitEnabled() const { return As<scree::RevoluteJoint>(m_handle).IsLimitEnabled(); }
void b2RevoluteJoint::EnableLimit(bool flag) { As<scree::RevoluteJoint>(m_handle).EnableLimit(flag); }
float b2RevoluteJoint::GetLowerLimit() const { return As<scree::RevoluteJoint>(m_handle).GetLowerLimit(); }
float b2RevoluteJoint::GetUpperLimit() const { return As<scree::RevoluteJoint>(m_handle).GetUpperLimit(); }
void b2RevoluteJoint::SetLimits(float lower, float upper) {
    As<scree::RevoluteJoint>(m_handle).SetLimits(lower, upper);
}
bool b2RevoluteJoint::IsMotorEnabled() const { return As<scree::RevoluteJoint>(m_handle).IsMotorEnabled(); }
void b2RevoluteJoint::EnableMotor(bool flag) { As<scree::RevoluteJoint>(m_handle).EnableMotor(flag); }
void b2RevoluteJoint::SetMotorSpeed(float speed) { As<scree::RevoluteJoint>(m_handle).SetMotorSpeed(speed); }
float b2RevoluteJoint::GetMotorSpeed() const { return As<scree::RevoluteJoint>(m_handle).GetMotorSpeed(); }
void b2RevoluteJoint::SetMaxMotorTorque(float torque) { As<scree::RevoluteJoint>(m_handle).SetMaxMotorTorque(torque); }
float b2RevoluteJoint::GetMaxMotorTorque() const { return As<scree::RevoluteJoint>(m_handle).GetMaxMotorTorque(); }
float b2RevoluteJoint::GetMotorTorque(float inv_dt) const {
    return As<scree::RevoluteJoint>(m_handle).GetMotorTorque(inv_dt);
}

void b2RevoluteJoint::Draw(b2Draw* draw) const {
    const b2Vec2 anchorA = GetAnchorA();
    const b2Vec2 anchorB = GetAnchorB();
    const float radius = 0.5f;
    const auto ray = [&](float angle) { return anchorB + radius * b2Vec2(cosf(angle), sinf(angle)); };
    draw->DrawPoint(anchorA, 5.0f, blue);
    draw->DrawPoint(anchorB, 5.0f, darkGray);
    draw->DrawSegment(anchorB, ray(GetJointAngle()), gray);
    draw->DrawCircle(anchorB, radius, gray);
    if (IsLimitEnabled()) {
        draw->DrawSegment(anchorB, ray(GetLowerLimit()), green);
        draw->DrawSegment(anchorB, ray(GetUpperLimit()), red);
    }
    const b2Color color(0.5f, 0.8f, 0.8f);
    draw->DrawSegment(m_bodyA->GetPosition(), anchorA, color);
    draw->DrawSegment(anchorA, anchorB, color);
    draw->DrawSegment(m_bodyB->GetPosition(), anchorB, color);
}
