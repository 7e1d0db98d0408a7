// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A bounded drive of body B to a pose in body A.

#pragma once

#include "b2_api.h"
#include "b2_joint.h"

struct B2_API b2MotorJointDef : public b2JointDef {
    b2MotorJointDef() {
        type = e_motorJoint;
        linearOffset.SetZero();
        angularOffset = 0.0f;
        maxForce = 1.0f;
        maxTorque = 1.0f;
        correctionFactor = 0.3f;
    }

    /// From the present poses.
    void Initialize(b2Body* bodyA, b2Body* bodyB);

    b2Vec2 linearOffset;
    float angularOffset;
    float maxForce;
    float maxTorque;
    float correctionFactor;
};

class B2_API b2MotorJoint : public b2Joint {
public:
    void SetLinearOffset(const b2Vec2& linearOffset);
    const b2Vec2& GetLinearOffset() const;
    void SetAngularOffset(float angularOffset);
    float GetAngularOffset() const;
    void SetMaxForce(float force);
    float GetMaxForce() const;
    void SetMaxTorque(float torque);
    float GetMaxTorque() const;
    void SetCorrectionFactor(float factor);
    float GetCorrectionFactor() const;

protected:
    friend struct b2Bridge;
    b2MotorJoint() {}

    mutable b2Vec2 m_linearOffset;
};
