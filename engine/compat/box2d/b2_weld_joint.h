// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Glue: two bodies keep their relative pose; with a stiffness the angle is a spring.

#pragma once

#include "b2_api.h"
#include "b2_joint.h"

struct B2_API b2WeldJointDef : public b2JointDef {
    b2WeldJointDef() {
        type = e_weldJoint;
        localAnchorA.Set(0.0f, 0.0f);
        localAnchorB.Set(0.0f, 0.0f);
        referenceAngle = 0.0f;
        stiffness = 0.0f;
        damping = 0.0f;
    }

    /// From a world point and the present poses.
    void Initialize(b2Body* bodyA, b2Body* bodyB, const b2Vec2& anchor);

    b2Vec2 localAnchorA;
    b2Vec2 localAnchorB;
    float referenceAngle;
    float stiffness;
    float damping;
};

class B2_API b2WeldJoint : public b2Joint {
public:
    const b2Vec2& GetLocalAnchorA() const { return m_localAnchorA; }
    const b2Vec2& GetLocalAnchorB() const { return m_localAnchorB; }
    float GetReferenceAngle() const;
    void SetStiffness(float stiffness);
    float GetStiffness() const;
    void SetDamping(float damping);
    float GetDamping() const;

protected:
    friend struct b2Bridge;
    b2WeldJoint() {}
};
