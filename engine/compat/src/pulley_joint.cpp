// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// b2PulleyJoint.

#include "../box2d/b2_pulley_joint.h"

#include "../box2d/b2_body.h"
#include "joint_handle.h"

using namespace scree::box2d;

void b2PulleyJointDef::Initialize(b2Body* bA, b2Body* bB, const b2Vec2& groundA, const b2Vec2& groundB,
                                  const b2Vec2& anchorA, const b2Vec2& anchorB, float r) {
    bodyA = bA;
    bodyB = bB;
    groundAnchorA = groundA;
    groundAnchorB = groundB;
    localAnchorA = bA->GetLocalPoint(anchorA);
    localAnchorB = bB->GetLocalPoint(anchorB);
    lengthA = b2Distance(anchorA, groundA);
    lengthB = b2Distance(anchorB, groundB);
    ratio = r;
}

b2Vec2 b2PulleyJoint::GetGroundAnchorA() const { return ToBox2d(As<scree::PulleyJoint>(m_handle).GetGroundAnchorA()); }
b2Vec2 b2PulleyJoint::GetGroundAnchorB() const { return ToBox2d(As<scree::PulleyJoint>(m_handle).GetGroundAnchorB()); }
float b2PulleyJoint::GetLengthA() const { return As<scree::PulleyJoint>(m_handle).GetLengthA(); }
float b2PulleyJoint::GetLengthB() const { return As<scree::PulleyJoint>(m_handle).GetLengthB(); }
float b2PulleyJoint::GetRatio() const { return As<scree::PulleyJoint>(m_handle).GetRatio(); }
float b2PulleyJoint::GetCurrentLengthA() const { return As<scree::PulleyJoint>(m_handle).GetCurrentLengthA(); }
float b2PulleyJoint::GetCurrentLengthB() const { return As<scree::PulleyJoint>(m_handle).GetCurrentLengthB(); }
