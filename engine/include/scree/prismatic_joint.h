// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A slider: body B moves along an axis fixed in body A and does not turn against it, with an optional limit and motor.

#pragma once

#include <limits>

#include "scree/api.h"
#include "scree/joint.h"

namespace scree {

struct PrismaticRow;

/// Input for a prismatic joint.
struct SCREE_API PrismaticJointDef : JointDef {
    PrismaticJointDef() : JointDef(e_prismaticJoint) {}

    /// Sets bodies, local anchors, local axis and the reference angle from a world point and a world axis.
    void Initialize(Body* a, Body* b, Vec2 anchor, Vec2 axis);

    Vec2 localAnchorA{0.0f, 0.0f};  ///< in A, m
    Vec2 localAnchorB{0.0f, 0.0f};  ///< in B, m
    Vec2 localAxisA{1.0f, 0.0f};    ///< direction of sliding in A, not zero; normalised on creation
    float referenceAngle = 0.0f;    ///< angleB − angleA that the joint keeps, rad
    bool enableLimit = false;
    float lowerTranslation = 0.0f;  ///< m, ≤ upperTranslation
    float upperTranslation = 0.0f;  ///< m
    bool enableMotor = false;
    float maxMotorForce = 0.0f;      ///< N, ≥ 0
    float motorSpeed = 0.0f;         ///< m/s
    bool enableSpring = false;       ///< drives the translation towards targetTranslation
    float stiffness = 0.0f;          ///< N/m, ≥ 0; LinearStiffness makes both from hertz and damping ratio
    float damping = 0.0f;            ///< N·s/m, ≥ 0
    float targetTranslation = 0.0f;  ///< m
    float maxSpringForce = std::numeric_limits<float>::infinity();  ///< N, ≥ 0
};

/// A slider joint. Setters that change something wake both bodies.
class SCREE_API PrismaticJoint final : public Joint {
public:
    [[nodiscard]] Vec2 GetAnchorA() const override;
    [[nodiscard]] Vec2 GetAnchorB() const override;
    [[nodiscard]] Vec2 GetReactionForce(float inverseDt) const override;
    [[nodiscard]] float GetReactionTorque(float inverseDt) const override;
    [[nodiscard]] Vec2 GetLocalAnchorA() const;
    [[nodiscard]] Vec2 GetLocalAnchorB() const;
    /// Unit length.
    [[nodiscard]] Vec2 GetLocalAxisA() const;
    [[nodiscard]] float GetReferenceAngle() const;
    /// m along the axis, 0 where the anchors meet
    [[nodiscard]] float GetJointTranslation() const;
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
    /// N, ≥ 0
    ErrorCode SetMaxMotorForce(float force);
    [[nodiscard]] float GetMaxMotorForce() const;
    /// Of the last step, N.
    [[nodiscard]] float GetMotorForce(float inverseDt) const;
    [[nodiscard]] bool IsSpringEnabled() const;
    ErrorCode EnableSpring(bool flag);
    /// N/m and N·s/m, ≥ 0. As all of the spring, a change wakes the bodies.
    ErrorCode SetSpring(float stiffness, float damping);
    [[nodiscard]] float GetStiffness() const;
    [[nodiscard]] float GetDamping() const;
    /// m along the axis
    ErrorCode SetTargetTranslation(float translation);
    [[nodiscard]] float GetTargetTranslation() const;
    /// N, ≥ 0; infinity: no limit.
    ErrorCode SetMaxSpringForce(float force);
    [[nodiscard]] float GetMaxSpringForce() const;
    /// Of the last step, N.
    [[nodiscard]] float GetSpringForce(float inverseDt) const;

    PrismaticJoint(WorldState* state, JointIndex index, JointRow row) : Joint(state, index, row) {}

private:
    [[nodiscard]] PrismaticRow& Row() const;
};

}  // namespace scree
