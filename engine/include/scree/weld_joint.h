// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Glue: two bodies keep their relative pose; with a stiffness the angle is a spring and only the point is rigid.

#pragma once

#include "scree/api.h"
#include "scree/joint.h"

namespace scree {

struct WeldRow;

/// Input for a weld joint.
struct SCREE_API WeldJointDef : JointDef {
    WeldJointDef() : JointDef(e_weldJoint) {}

    /// Sets bodies, local anchors and the reference angle from a world point and the present poses.
    void Initialize(Body* a, Body* b, Vec2 anchor);

    Vec2 localAnchorA{0.0f, 0.0f};  ///< in A, m
    Vec2 localAnchorB{0.0f, 0.0f};  ///< in B, m
    float referenceAngle = 0.0f;    ///< angleB − angleA that the joint keeps, rad
    float stiffness = 0.0f;         ///< of the angle, N·m/rad, ≥ 0; 0: rigid
    float damping = 0.0f;           ///< N·m·s/rad, ≥ 0
};

/// A weld joint.
class SCREE_API WeldJoint final : public Joint {
public:
    [[nodiscard]] Vec2 GetAnchorA() const override;
    [[nodiscard]] Vec2 GetAnchorB() const override;
    [[nodiscard]] Vec2 GetReactionForce(float inverseDt) const override;
    [[nodiscard]] float GetReactionTorque(float inverseDt) const override;
    [[nodiscard]] Vec2 GetLocalAnchorA() const;
    [[nodiscard]] Vec2 GetLocalAnchorB() const;
    [[nodiscard]] float GetReferenceAngle() const;
    /// N·m/rad, ≥ 0; 0 makes the angle rigid. Does not wake.
    ErrorCode SetStiffness(float stiffness);
    [[nodiscard]] float GetStiffness() const;
    /// N·m·s/rad, ≥ 0. Does not wake.
    ErrorCode SetDamping(float damping);
    [[nodiscard]] float GetDamping() const;

    WeldJoint(WorldState* state, JointIndex index, JointRow row) : Joint(state, index, row) {}

private:
    [[nodiscard]] WeldRow& Row() const;
};

}  // namespace scree
