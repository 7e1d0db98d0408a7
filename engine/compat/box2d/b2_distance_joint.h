// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A rod, rope or spring between two points.

#pragma once

#include "b2_api.h"
#include "b2_joint.h"

struct B2_API b2DistanceJointDef : public b2JointDef {
    b2DistanceJointDef() {
        type = e_distanceJoint;
        localAnchorA.Set(0.0f, 0.0f);
        localAnchorB.Set(0.0f, 0.0f);
        length = 1.0f;
        minLength = 0.0f;
        maxLength = FLT_MAX;
        stiffness = 0.0f;
        damping = 0.0f;
    }

    /// From two world points; all three lengths become their distance.
    void Initialize(b2Body* bodyA, b2Body* bodyB, const b2Vec2& anchorA, const b2Vec2& anchorB);

    b2Vec2 localAnchorA;
    b2Vec2 localAnchorB;
    float length;
    float minLength;
    float maxLength;
    float stiffness;
    float damping;
};

class B2_API b2DistanceJoint : public b2Joint {
public:
    const b2Vec2& GetLocalAnchorA() const { return m_localAnchorA; }
    const b2Vec2& GetLocalAnchorB() const { return m_localAnchorB; }
    float GetLength() const;
    /// The setters of lengths return what it became.
    float SetLength(float length);
    float GetMinLength() const;
    float SetMinLength(float minLength);
    float GetMaxLength() const;
    float SetMaxLength(float maxLength);
    float GetCurrentLength() const;
    void SetStiffness(float stiffness);
    float GetStiffness() const;
    void SetDamping(float damping);
    float GetDamping() const;
    void Draw(b2Draw* draw) const override;

protected:
    friend struct b2Bridge;
    b2DistanceJoint() {}
};
