// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A hinge: two bodies share a point and turn about it.

#pragma once

#include "b2_api.h"
#include "b2_joint.h"

struct B2_API b2RevoluteJointDef : public b2JointDef {
    b2RevoluteJointDef() {
        type = e_revoluteJoint;
        localAnchorA.Set(0.0f, 0.0f);
        localAnchorB.Set(0.0f, 0.0f);
        referenceAngle = 0.0f;
        lowerAngle = 0.0f;
        upperAngle = 0.0f;
        maxMotorTorque = 0.0f;
        motorSpeed = 0.0f;
        enableLimit = false;
        enableMotor = false;
    }

    /// From a world point.
    void Initialize(b2Body* bodyA, b2Body* bodyB, const b2Vec2& anchor);

    b2Vec2 localAnchorA;
    b2Vec2 localAnchorB;
    float referenceAngle;
    bool enableLimit;
    float lowerAngle;
    float upperAngle;
    bool enableMotor;
    float motorSpeed;
    float maxMotorTorque;
};

class B2_API b2RevoluteJoint : public b2Joint {
public:
    const b2Vec2& GetLocalAnchorA() const { return m_localAnchorA; }
    const b2Vec2& GetLocalAnchorB() const { return m_localAnchorB; }
    float GetReferenceAngle() const;
    /// Not wrapped.
    float GetJointAngle() const;
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
    void SetMaxMotorTorque(float torque);
    float GetMaxMotorTorque() const;
    float GetMotorTorque(float inv_dt) const;
    void Draw(b2Draw* draw) const override;

protected:
    friend struct b2Bridge;
    b2RevoluteJoint() {}
};
