// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A rope over two fixed points: lengthA + ratio·lengthB stays constant.

#pragma once

#include "b2_api.h"
#include "b2_joint.h"

const float b2_minPulleyLength = 2.0f;

struct B2_API b2PulleyJointDef : public b2JointDef {
    b2PulleyJointDef() {
        type = e_pulleyJoint;
        groundAnchorA.Set(-1.0f, 1.0f);
        groundAnchorB.Set(1.0f, 1.0f);
        localAnchorA.Set(-1.0f, 0.0f);
        localAnchorB.Set(1.0f, 0.0f);
        lengthA = 0.0f;
        lengthB = 0.0f;
        ratio = 1.0f;
        collideConnected = true;
    }

    /// From world points.
    void Initialize(b2Body* bodyA, b2Body* bodyB, const b2Vec2& groundAnchorA, const b2Vec2& groundAnchorB,
                    const b2Vec2& anchorA, const b2Vec2& anchorB, float ratio);

    b2Vec2 groundAnchorA;
    b2Vec2 groundAnchorB;
    b2Vec2 localAnchorA;
    b2Vec2 localAnchorB;
    float lengthA;
    float lengthB;
    float ratio;
};

class B2_API b2PulleyJoint : public b2Joint {
public:
    b2Vec2 GetGroundAnchorA() const;
    b2Vec2 GetGroundAnchorB() const;
    float GetLengthA() const;
    float GetLengthB() const;
    float GetRatio() const;
    float GetCurrentLengthA() const;
    float GetCurrentLengthB() const;

protected:
    friend struct b2Bridge;
    b2PulleyJoint() {}
};
