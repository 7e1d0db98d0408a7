// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A bounded damped spring that pulls a point of body B to a world point. Body A only anchors the joint in the world
// (any static body will do).

#pragma once

#include "scree/api.h"
#include "scree/joint.h"

namespace scree {

struct MouseRow;

/// Input for a mouse joint.
struct MouseJointDef : JointDef {
    MouseJointDef() : JointDef(e_mouseJoint) {}

    Vec2 target{0.0f, 0.0f};  ///< world; the point of B that lies there on creation is the one that is pulled, m
    float maxForce = 0.0f;    ///< N, ≥ 0
    float stiffness = 0.0f;   ///< N/m, ≥ 0
    float damping = 0.0f;     ///< N·s/m, ≥ 0
};

/// A mouse joint. Changing the target wakes body B; the other setters do not.
class SCREE_API MouseJoint final : public Joint {
public:
    [[nodiscard]] Vec2 GetAnchorA() const override;
    [[nodiscard]] Vec2 GetAnchorB() const override;
    [[nodiscard]] Vec2 GetReactionForce(float inverseDt) const override;
    [[nodiscard]] float GetReactionTorque(float inverseDt) const override;
    ErrorCode SetTarget(Vec2 target);
    [[nodiscard]] Vec2 GetTarget() const;
    /// N, ≥ 0
    ErrorCode SetMaxForce(float force);
    [[nodiscard]] float GetMaxForce() const;
    /// N/m, ≥ 0. Does not wake.
    ErrorCode SetStiffness(float stiffness);
    [[nodiscard]] float GetStiffness() const;
    /// N·s/m, ≥ 0. Does not wake.
    ErrorCode SetDamping(float damping);
    [[nodiscard]] float GetDamping() const;

    MouseJoint(WorldState* state, JointIndex index, JointRow row) : Joint(state, index, row) {}

private:
    [[nodiscard]] MouseRow& Row() const;
};

}  // namespace scree
