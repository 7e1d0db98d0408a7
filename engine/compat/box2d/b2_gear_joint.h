// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A gear between two revolute or prismatic joints: coordinate1 + ratio·coordinate2 stays constant.

#pragma once

#include "b2_joint.h"

struct B2_API b2GearJointDef : public b2JointDef {
    b2GearJointDef() {
        type = e_gearJoint;
        joint1 = nullptr;
        joint2 = nullptr;
        ratio = 1.0f;
    }

    b2Joint* joint1;
    b2Joint* joint2;
    float ratio;
};

class B2_API b2GearJoint : public b2Joint {
public:
    b2Joint* GetJoint1() { return m_joint1; }
    b2Joint* GetJoint2() { return m_joint2; }
    void SetRatio(float ratio);
    float GetRatio() const;

protected:
    friend struct b2Bridge;
    b2GearJoint() {}

    b2Joint* m_joint1;
    b2Joint* m_joint2;
};
