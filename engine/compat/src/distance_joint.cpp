// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// b2DistanceJoint.

#include "../box2d/b2_distance_joint.h"

#include "../box2d/b2_body.h"
#include "joint_draw.h"
#include "joint_handle.h"

using namespace scree::box2d;

void b2DistanceJointDef::Initialize(b2Body* bA, b2Body* bB, const b2Vec2& anchorA, const b2Vec2& anchorB) {
    bodyA = bA;
    bodyB = bB;
    localAnchorA = bA->GetLocalPoint(anchorA);
    localAnchorB = bB->GetLocalPoint(anchorB);
    length = b2Max(b2Distance(anchorA, anchorB), b2_linearSlop);
    minLength = length;
    maxLength = length;
}

float b2DistanceJoint::GetLength() const { return As<scree::DistanceJoint>(m_handle).GetLength(); }
float b2DistanceJoint::SetLength(float length) {
    As<scree::DistanceJoint>(m_handle).SetLength(b2Max(b2_linearSlop, length));
    return GetLength();
}
float b2DistanceJoint::GetMinLength() const { return As<scree::DistanceJoint>(m_handle).GetMinLength(); }
float b2DistanceJoint::SetMinLength(float minLength) {
    As<scree::DistanceJoint>(m_handle).SetMinLength(b2Clamp(minLength, b2_linearSlop, GetMaxLength()));
    return GetMinLength();
}
float b2DistanceJoint::GetMaxLength() const { return As<scree::DistanceJoint>(m_handle).GetMaxLength(); }
float b2DistanceJoint::SetMaxLength(float maxLength) {
    As<scree::DistanceJoint>(m_handle).SetMaxLength(b2Max(maxLength, GetMinLength()));
    return GetMaxLength();
}
float b2DistanceJoint::GetCurrentLength() const { return As<scree::DistanceJoint>(m_handle).GetCurrentLength(); }
void b2DistanceJoint::SetStiffness(float stiffness) { As<scree::DistanceJoint>(m_handle).SetStiffness(stiffness); }
float b2DistanceJoint::GetStiffness() const { return As<scree::DistanceJoint>(m_handle).GetStiffness(); }
void b2DistanceJoint::SetDamping(float damping) { As<scree::DistanceJoint>(m_handle).SetDamping(damping); }
float b2DistanceJoint::GetDamping() const { return As<scree::DistanceJoint>(m_handle).GetDamping(); }

void b2DistanceJoint::Draw(b2Draw* draw) const {
    const b2Vec2 anchorA = GetAnchorA();
    const b2Vec2 anchorB = GetAnchorB();
    b2Vec2 axis = anchorB - anchorA;
    axis.Normalize();
    draw->DrawSegment(anchorA, anchorB, darkGray);
    draw->DrawPoint(anchorA + GetLength() * axis, 8.0f, gray);
    const float low = GetMinLength();
    const float high = GetMaxLength();
    if (low == high) return;
    if (low > b2_linearSlop) draw->DrawPoint(anchorA + low * axis, 4.0f, green);
    if (high < FLT_MAX) draw->DrawPoint(anchorA + high * axis, 4.0f, red);
}
