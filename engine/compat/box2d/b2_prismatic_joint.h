// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A slider: body B moves along an axis of body A.

#pragma once

#include "b2_api.h"
#include "b2_joint.h"

struct B2_API b2PrismaticJointDef : public b2JointDef {
    b2PrismaticJointDef() {
        type = e_prismaticJoint;
        localAnchorA.SetZero();
        localAnchorB.SetZero();
        localAxisA.Set(1.0f, 0.0f);
        referenceAngle = 0.0f;
        enableLimit = false;
        lowerTranslation = 0.0f;
        upperTranslation = 0.0f;
        enableMotor = false;
        maxMotorForce = 0.0f;
        motorSpeed = 0.0f;
    }

    /// From a world point and a world axis.
    void Initialize(b2Body* bodyA, b2Body* bodyB, const b2Vec2& anchor, const b2Vec2& axis);

    b2Vec2 localAnchorA;
    b2Vec2 localAnchorB;
    b2Vec2 localAxisA;
    float referenceAngle;
    bool enableLimit;
    float lowerTranslation;
    float upperTranslation;
    bool enableMotor;
    float maxMotorForce;
    float motorSpeed;
};

class B2_API b2PrismaticJoint : public b2Joint {
public:
    const b2Vec2& GetLocalAnchorA() const { return m_localAnchorA; }
    const b2Vec2& GetLocalAnchorB() const { return m_localAnchorB; }
    const b2Vec2& GetLocalAxisA() const { return m_localAxisA; }
    float GetReferenceAngle() const;
    float GetJointTranslation() const;
    float GetJointSpeed() const;
    bool IsLimitEnabled() const;
    void EnableLimit(bool flag);
    float GetLowerLimit() const;
    float GetUpperLimit() const;
    void SetLimits(float lower, float upper);
    bool IsMotorEnabled() const;
    void EnableMotor(bool flag);
    void SetMotorSpeed(float speed);
    float GetMotorSpeed() const;
    void SetMaxMotorForce(float force);
    float GetMaxMotorForce() const;
    float GetMotorForce(float inv_dt) const;
    void Draw(b2Draw* draw) const override;

protected:
    friend struct b2Bridge;
    b2PrismaticJoint() {}
};
