// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A bounded spring that pulls a point of body B to a world point.

#pragma once

#include "b2_api.h"
#include "b2_joint.h"

struct B2_API b2MouseJointDef : public b2JointDef {
    b2MouseJointDef() {
        type = e_mouseJoint;
        target.Set(0.0f, 0.0f);
        maxForce = 0.0f;
        stiffness = 0.0f;
        damping = 0.0f;
    }

    b2Vec2 target;
    float maxForce;
    float stiffness;
    float damping;
};

class B2_API b2MouseJoint : public b2Joint {
public:
    void SetTarget(const b2Vec2& target);
    const b2Vec2& GetTarget() const;
    void SetMaxForce(float force);
    float GetMaxForce() const;
    void SetStiffness(float stiffness);
    float GetStiffness() const;
    void SetDamping(float damping);
    float GetDamping() const;

protected:
    friend struct b2Bridge;
    b2MouseJoint() {}

    mutable b2Vec2 m_target;
};
