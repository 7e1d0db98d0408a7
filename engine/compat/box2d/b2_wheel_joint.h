// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A wheel on a suspension: body B turns freely and moves along an axis of body A, held by a spring.

#pragma once

#include "b2_api.h"
#include "b2_joint.h"

struct B2_API b2WheelJointDef : public b2JointDef {
    b2WheelJointDef() {
        type = e_wheelJoint;
        localAnchorA.SetZero();
        localAnchorB.SetZero();
        localAxisA.Set(1.0f, 0.0f);
        enableLimit = false;
        lowerTranslation = 0.0f;
        upperTranslation = 0.0f;
        enableMotor = false;
        maxMotorTorque = 0.0f;
        motorSpeed = 0.0f;
        stiffness = 0.0f;
        damping = 0.0f;
    }

    /// From a world point and a world axis.
    void Initialize(b2Body* bodyA, b2Body* bodyB, const b2Vec2& anchor, const b2Vec2& axis);

    b2Vec2 localAnchorA;
    b2Vec2 localAnchorB;
    b2Vec2 localAxisA;
    bool enableLimit;
    float lowerTranslation;
    float upperTranslation;
    bool enableMotor;
    float maxMotorTorque;
    float motorSpeed;
    float stiffness;
    float damping;
};

class B2_API b2WheelJoint : public b2Joint {
public:
    const b2Vec2& GetLocalAnchorA() const { return m_localAnchorA; }
    const b2Vec2& GetLocalAnchorB() const { return m_localAnchorB; }
    const b2Vec2& GetLocalAxisA() const { return m_localAxisA; }
    float GetJointTranslation() const;
    float GetJointLinearSpeed() const;
    float GetJointAngle() const;
    float GetJointAngularSpeed() const;
    bool IsLimitEnabled() const;
    void EnableLimit(bool flag);
    float GetLowerLimit() const;
    float GetUpperLimit() const;
    void SetLimits(float lower, float upper);
    bool IsMotorEnabled() const;
    void EnableMotor(bool flag);
    void SetMotorSpeed(float speed);
    float GetMotorSpeed() const;
    void SetMaxMotorTorque(float torque);
    float GetMaxMotorTorque() const;
    float GetMotorTorque(float inv_dt) const;
    void SetStiffness(float stiffness);
    float GetStiffness() const;
    void SetDamping(float damping);
    float GetDamping() const;
    void Draw(b2Draw* draw) const override;

protected:
    friend struct b2Bridge;
    b2WheelJoint() {}
};
