// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Top-down friction: a bounded force and torque against the relative motion of two bodies at a point.

#pragma once

#include "scree/api.h"
#include "scree/joint.h"

namespace scree {

struct FrictionRow;

/// Input for a friction joint.
struct SCREE_API FrictionJointDef : JointDef {
    FrictionJointDef() : JointDef(e_frictionJoint) {}

    /// Sets bodies and local anchors from a world point.
    void Initialize(Body* a, Body* b, Vec2 anchor);

    Vec2 localAnchorA{0.0f, 0.0f};  ///< in A, m
    Vec2 localAnchorB{0.0f, 0.0f};  ///< in B, m
    float maxForce = 0.0f;          ///< N, ≥ 0
    float maxTorque = 0.0f;         ///< N·m, ≥ 0
};

/// A friction joint. Its setters do not wake the bodies.
class SCREE_API FrictionJoint final : public Joint {
public:
    [[nodiscard]] Vec2 GetAnchorA() const override;
    [[nodiscard]] Vec2 GetAnchorB() const override;
    [[nodiscard]] Vec2 GetReactionForce(float inverseDt) const override;
    [[nodiscard]] float GetReactionTorque(float inverseDt) const override;
    [[nodiscard]] Vec2 GetLocalAnchorA() const;
    [[nodiscard]] Vec2 GetLocalAnchorB() const;
    /// N, ≥ 0
    ErrorCode SetMaxForce(float force);
    [[nodiscard]] float GetMaxForce() const;
    /// N·m, ≥ 0
    ErrorCode SetMaxTorque(float torque);
    [[nodiscard]] float GetMaxTorque() const;

    FrictionJoint(WorldState* state, JointIndex index, JointRow row) : Joint(state, index, row) {}

private:
    [[nodiscard]] FrictionRow& Row() const;
};

}  // namespace scree
