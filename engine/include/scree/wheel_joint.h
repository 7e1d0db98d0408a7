// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A wheel on a suspension: body B turns freely and moves along an axis fixed in body A, held by a spring. The travel
// may have a limit, and a motor may turn the wheel.

#pragma once

#include <limits>

#include "scree/api.h"
#include "scree/joint.h"

namespace scree {

struct WheelRow;

/// Input for a wheel joint.
struct SCREE_API WheelJointDef : JointDef {
    WheelJointDef() : JointDef(e_wheelJoint) {}

    /// Sets bodies, local anchors and the local axis from a world point and a world axis.
    void Initialize(Body* a, Body* b, Vec2 anchor, Vec2 axis);

    Vec2 localAnchorA{0.0f, 0.0f};  ///< in A, m
    Vec2 localAnchorB{0.0f, 0.0f};  ///< in B, m
    Vec2 localAxisA{1.0f, 0.0f};    ///< direction of travel in A, not zero; normalised on creation
    bool enableLimit = false;
    float lowerTranslation = 0.0f;  ///< m, ≤ upperTranslation
    float upperTranslation = 0.0f;  ///< m
    bool enableMotor = false;
    float maxMotorTorque = 0.0f;                                    ///< N·m, ≥ 0
    float motorSpeed = 0.0f;                                        ///< rad/s
    float stiffness = 0.0f;                                         ///< of the suspension, N/m, ≥ 0; 0: none
    float damping = 0.0f;                                           ///< N·s/m, ≥ 0
    float maxSpringForce = std::numeric_limits<float>::infinity();  ///< N, ≥ 0
};

/// A wheel joint. Setters of limits and motor that change something wake both bodies.
class SCREE_API WheelJoint final : public Joint {
public:
    [[nodiscard]] Vec2 GetAnchorA() const override;
    [[nodiscard]] Vec2 GetAnchorB() const override;
    [[nodiscard]] Vec2 GetReactionForce(float inverseDt) const override;
    [[nodiscard]] float GetReactionTorque(float inverseDt) const override;
    [[nodiscard]] Vec2 GetLocalAnchorA() const;
    [[nodiscard]] Vec2 GetLocalAnchorB() const;
    /// Unit length.
    [[nodiscard]] Vec2 GetLocalAxisA() const;
    /// m along the axis
    [[nodiscard]] float GetJointTranslation() const;
    [[nodiscard]] float GetJointLinearSpeed() const;
    /// rad, not wrapped
    [[nodiscard]] float GetJointAngle() const;
    [[nodiscard]] float GetJointAngularSpeed() const;
    [[nodiscard]] bool IsLimitEnabled() const;
    ErrorCode EnableLimit(bool flag);
    [[nodiscard]] float GetLowerLimit() const;
    [[nodiscard]] float GetUpperLimit() const;
    /// lower ≤ upper; wakes the bodies on a change.
    ErrorCode SetLimits(float lower, float upper);
    [[nodiscard]] bool IsMotorEnabled() const;
    ErrorCode EnableMotor(bool flag);
    ErrorCode SetMotorSpeed(float speed);
    [[nodiscard]] float GetMotorSpeed() const;
    /// N·m, ≥ 0
    ErrorCode SetMaxMotorTorque(float torque);
    [[nodiscard]] float GetMaxMotorTorque() const;
    /// Of the last step, N·m.
    [[nodiscard]] float GetMotorTorque(float inverseDt) const;
    /// N/m, ≥ 0; 0 turns the spring off. Does not wake.
    ErrorCode SetStiffness(float stiffness);
    [[nodiscard]] float GetStiffness() const;
    /// N·s/m, ≥ 0. Does not wake.
    ErrorCode SetDamping(float damping);
    [[nodiscard]] float GetDamping() const;
    /// N, ≥ 0; infinity: no limit. Does not wake.
    ErrorCode SetMaxSpringForce(float force);
    [[nodiscard]] float GetMaxSpringForce() const;

    WheelJoint(WorldState* state, JointIndex index, JointRow row) : Joint(state, index, row) {}

private:
    [[nodiscard]] WheelRow& Row() const;
};

}  // namespace scree
