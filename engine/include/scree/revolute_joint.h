// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A hinge: two bodies share a point and turn freely about it, with an optional limit and motor.

#pragma once

#include <limits>

#include "scree/api.h"
#include "scree/joint.h"

namespace scree {

struct RevoluteRow;

/// Input for a revolute joint.
struct SCREE_API RevoluteJointDef : JointDef {
    RevoluteJointDef() : JointDef(e_revoluteJoint) {}

    /// Sets bodies, local anchors and the reference angle from a world point and the present poses.
    void Initialize(Body* a, Body* b, Vec2 anchor);

    Vec2 localAnchorA{0.0f, 0.0f};  ///< in A, m
    Vec2 localAnchorB{0.0f, 0.0f};  ///< in B, m
    float referenceAngle = 0.0f;    ///< angleB − angleA at joint angle 0, rad
    bool enableLimit = false;
    float lowerAngle = 0.0f;  ///< rad, ≤ upperAngle
    float upperAngle = 0.0f;  ///< rad
    bool enableMotor = false;
    float motorSpeed = 0.0f;      ///< rad/s
    float maxMotorTorque = 0.0f;  ///< N·m, ≥ 0
    bool enableSpring = false;    ///< drives the joint angle towards targetAngle
    float stiffness = 0.0f;       ///< N·m/rad, ≥ 0; AngularStiffness makes both from hertz and damping ratio
    float damping = 0.0f;         ///< N·m·s/rad, ≥ 0
    float targetAngle = 0.0f;     ///< rad
    float maxSpringTorque = std::numeric_limits<float>::infinity();  ///< N·m, ≥ 0
};

/// A hinge joint. Setters that change something wake both bodies.
class SCREE_API RevoluteJoint final : public Joint {
public:
    [[nodiscard]] Vec2 GetAnchorA() const override;
    [[nodiscard]] Vec2 GetAnchorB() const override;
    [[nodiscard]] Vec2 GetReactionForce(float inverseDt) const override;
    [[nodiscard]] float GetReactionTorque(float inverseDt) const override;
    [[nodiscard]] Vec2 GetLocalAnchorA() const;
    [[nodiscard]] Vec2 GetLocalAnchorB() const;
    [[nodiscard]] float GetReferenceAngle() const;
    /// rad, not wrapped
    [[nodiscard]] float GetJointAngle() const;
    [[nodiscard]] float GetJointSpeed() const;
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
    [[nodiscard]] bool IsSpringEnabled() const;
    ErrorCode EnableSpring(bool flag);
    /// N·m/rad and N·m·s/rad, ≥ 0. As all of the spring, a change wakes the bodies.
    ErrorCode SetSpring(float stiffness, float damping);
    [[nodiscard]] float GetStiffness() const;
    [[nodiscard]] float GetDamping() const;
    /// rad
    ErrorCode SetTargetAngle(float angle);
    [[nodiscard]] float GetTargetAngle() const;
    /// N·m, ≥ 0; infinity: no limit.
    ErrorCode SetMaxSpringTorque(float torque);
    [[nodiscard]] float GetMaxSpringTorque() const;
    /// Of the last step, N·m.
    [[nodiscard]] float GetSpringTorque(float inverseDt) const;

    RevoluteJoint(WorldState* state, JointIndex index, JointRow row) : Joint(state, index, row) {}

private:
    [[nodiscard]] RevoluteRow& Row() const;
};

}  // namespace scree
