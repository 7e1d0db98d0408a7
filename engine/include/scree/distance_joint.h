// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A rod, rope or spring between two points: a length range that is never left and a spring towards a rest length.

#pragma once

#include <limits>

#include "scree/api.h"
#include "scree/joint.h"

namespace scree {

struct DistanceRow;

/// Input for a distance joint.
struct SCREE_API DistanceJointDef : JointDef {
    DistanceJointDef() : JointDef(e_distanceJoint) {}

    /// Sets bodies, local anchors and the length from two world points; minimum and maximum become that length.
    void Initialize(Body* a, Body* b, Vec2 anchorA, Vec2 anchorB);

    Vec2 localAnchorA{0.0f, 0.0f};  ///< in A, m
    Vec2 localAnchorB{0.0f, 0.0f};  ///< in B, m
    float length = 1.0f;            ///< rest length, m, ≥ 0; at least linearSlop · WorldDef::lengthScale is used
    float minLength = 0.0f;         ///< m, ≥ 0; at least linearSlop · WorldDef::lengthScale is used
    float maxLength = 3.402823466e+38f;                             ///< m, ≥ minLength. Equal to minLength: a rod
    float stiffness = 0.0f;                                         ///< N/m, ≥ 0; 0 (or a rod): no spring
    float damping = 0.0f;                                           ///< N·s/m, ≥ 0
    float maxSpringForce = std::numeric_limits<float>::infinity();  ///< N, ≥ 0
};

/// A distance joint. Its setters do not wake the bodies.
class SCREE_API DistanceJoint final : public Joint {
public:
    [[nodiscard]] Vec2 GetAnchorA() const override;
    [[nodiscard]] Vec2 GetAnchorB() const override;
    [[nodiscard]] Vec2 GetReactionForce(float inverseDt) const override;
    [[nodiscard]] float GetReactionTorque(float inverseDt) const override;
    [[nodiscard]] Vec2 GetLocalAnchorA() const;
    [[nodiscard]] Vec2 GetLocalAnchorB() const;
    [[nodiscard]] float GetLength() const;
    /// Lengths must be finite and ≥ 0. They are clamped as in Box2D. All are at least linearSlop · lengthScale; the
    /// minimum is at most the maximum, the maximum at least the minimum. The getter returns the clamped value.
    ErrorCode SetLength(float length);
    [[nodiscard]] float GetMinLength() const;
    ErrorCode SetMinLength(float minLength);
    [[nodiscard]] float GetMaxLength() const;
    ErrorCode SetMaxLength(float maxLength);
    [[nodiscard]] float GetCurrentLength() const;
    /// N/m, ≥ 0; 0 turns the spring off. Does not wake.
    ErrorCode SetStiffness(float stiffness);
    [[nodiscard]] float GetStiffness() const;
    /// N·s/m, ≥ 0. Does not wake.
    ErrorCode SetDamping(float damping);
    [[nodiscard]] float GetDamping() const;
    /// N, ≥ 0; infinity: no limit. Does not wake.
    ErrorCode SetMaxSpringForce(float force);
    [[nodiscard]] float GetMaxSpringForce() const;

    DistanceJoint(WorldState* state, JointIndex index, JointRow row) : Joint(state, index, row) {}

private:
    [[nodiscard]] DistanceRow& Row() const;
};

}  // namespace scree
