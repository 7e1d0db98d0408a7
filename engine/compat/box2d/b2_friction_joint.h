// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Friction between two bodies seen from above.

#pragma once

#include "b2_api.h"
#include "b2_joint.h"

struct B2_API b2FrictionJointDef : public b2JointDef {
    b2FrictionJointDef() {
        type = e_frictionJoint;
        localAnchorA.SetZero();
        localAnchorB.SetZero();
        maxForce = 0.0f;
        maxTorque = 0.0f;
    }

    void Initialize(b2Body* bodyA, b2Body* bodyB, const b2Vec2& anchor);

    b2Vec2 localAnchorA;
    b2Vec2 localAnchorB;
    float maxForce;
    float maxTorque;
};

class B2_API b2FrictionJoint : public b2Joint {
public:
    const b2Vec2& GetLocalAnchorA() const { return m_localAnchorA; }
    const b2Vec2& GetLocalAnchorB() const { return m_localAnchorB; }
    void SetMaxForce(float force);
    float GetMaxForce() const;
    void SetMaxTorque(float torque);
    float GetMaxTorque() const;

protected:
    friend struct b2Bridge;
    b2FrictionJoint() {}
};
