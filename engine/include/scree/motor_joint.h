// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A bounded drive towards a relative pose: body B is pushed to an offset and angle in body A.

#pragma once

#include "scree/api.h"
#include "scree/joint.h"

namespace scree {

struct MotorRow;

/// Input for a motor joint.
struct SCREE_API MotorJointDef : JointDef {
    MotorJointDef() : JointDef(e_motorJoint) {}

    /// Sets bodies and offsets from the present poses.
    void Initialize(Body* a, Body* b);

    Vec2 linearOffset{0.0f, 0.0f};  ///< B's origin in A, m
    float angularOffset = 0.0f;     ///< angleB − angleA, rad
    float maxForce = 1.0f;          ///< N, ≥ 0
    float maxTorque = 1.0f;         ///< N·m, ≥ 0
    float correctionFactor = 0.3f;  ///< share of the error removed in a step, 0…1
};

/// A motor joint. Changing an offset wakes the bodies; the other setters do not.
class SCREE_API MotorJoint final : public Joint {
public:
    [[nodiscard]] Vec2 GetAnchorA() const override;
    [[nodiscard]] Vec2 GetAnchorB() const override;
    [[nodiscard]] Vec2 GetReactionForce(float inverseDt) const override;
    [[nodiscard]] float GetReactionTorque(float inverseDt) const override;
    /// In A, m.
    ErrorCode SetLinearOffset(Vec2 linearOffset);
    [[nodiscard]] Vec2 GetLinearOffset() const;
    ErrorCode SetAngularOffset(float angularOffset);
    [[nodiscard]] float GetAngularOffset() const;
    /// N, ≥ 0
    ErrorCode SetMaxForce(float force);
    [[nodiscard]] float GetMaxForce() const;
    /// N·m, ≥ 0
    ErrorCode SetMaxTorque(float torque);
    [[nodiscard]] float GetMaxTorque() const;
    /// 0…1
    ErrorCode SetCorrectionFactor(float factor);
    [[nodiscard]] float GetCorrectionFactor() const;

    MotorJoint(WorldState* state, JointIndex index, JointRow row) : Joint(state, index, row) {}

private:
    [[nodiscard]] MotorRow& Row() const;
};

}  // namespace scree
