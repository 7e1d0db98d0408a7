// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A gear between two revolute or prismatic joints: coordinate1 + ratio·coordinate2 stays constant, where a coordinate
// is a joint angle (rad) or a translation (m).

#pragma once

#include "scree/api.h"
#include "scree/joint.h"

namespace scree {

struct GearRow;

/// Input for a gear joint.
struct GearJointDef : JointDef {
    GearJointDef() : JointDef(e_gearJoint) {}

    /// Revolute or prismatic, with different bodies B. These are the gear's bodies A and B. Where one of them is static
    /// or kinematic, and body A of that joint is dynamic, it is that one instead: a gear belongs to what it pushes.
    Joint *joint1 = nullptr, *joint2 = nullptr;
    float ratio = 1.0f;  ///< not 0; in units of coordinate1 / coordinate2
};

/// A gear joint. It lives no longer than its two joints: destroying one of them (or a body under it) destroys the gear
/// first.
class SCREE_API GearJoint final : public Joint {
public:
    [[nodiscard]] Vec2 GetAnchorA() const override;
    [[nodiscard]] Vec2 GetAnchorB() const override;
    [[nodiscard]] Vec2 GetReactionForce(float inverseDt) const override;
    [[nodiscard]] float GetReactionTorque(float inverseDt) const override;
    [[nodiscard]] Joint* GetJoint1() const;
    [[nodiscard]] Joint* GetJoint2() const;
    /// Keeps the constant of creation: the joints move to the coordinates that fit the new ratio. Does not wake.
    ErrorCode SetRatio(float ratio);
    [[nodiscard]] float GetRatio() const;

    GearJoint(WorldState* state, JointIndex index, JointRow row) : Joint(state, index, row) {}

private:
    [[nodiscard]] GearRow& Row() const;
};

}  // namespace scree
