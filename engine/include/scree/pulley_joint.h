// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A rope over two fixed points: lengthA + ratio·lengthB stays constant.

#pragma once

#include "scree/api.h"
#include "scree/joint.h"

namespace scree {

struct PulleyRow;

/// Shortest rope segment that Box2D's documentation suggests, m.
inline constexpr float minPulleyLength = 2.0f;

/// World points of a pulley, m.
struct PulleyPoints {
    Vec2 groundAnchorA, groundAnchorB;  ///< where the rope is hung
    Vec2 anchorA, anchorB;              ///< where it holds the bodies
};

/// Input for a pulley joint.
struct SCREE_API PulleyJointDef : JointDef {
    PulleyJointDef() : JointDef(e_pulleyJoint) { collideConnected = true; }

    /// Sets bodies, anchors and lengths from world points.
    void Initialize(Body* a, Body* b, const PulleyPoints& points, float pulleyRatio);
    /// Box2D's form of the same.
    void Initialize(Body* a, Body* b, Vec2 groundA, Vec2 groundB, Vec2 anchorA, Vec2 anchorB, float pulleyRatio) {
        Initialize(a, b, {groundA, groundB, anchorA, anchorB}, pulleyRatio);
    }

    Vec2 groundAnchorA{-1.0f, 1.0f};  ///< world, m
    Vec2 groundAnchorB{1.0f, 1.0f};   ///< world, m
    Vec2 localAnchorA{-1.0f, 0.0f};   ///< in A, m
    Vec2 localAnchorB{1.0f, 0.0f};    ///< in B, m
    float lengthA = 0.0f;             ///< reference length on A's side, m, ≥ 0
    float lengthB = 0.0f;             ///< on B's side, m, ≥ 0
    float ratio = 1.0f;               ///< of a block and tackle, not 0
};

/// A pulley joint.
class SCREE_API PulleyJoint final : public Joint {
public:
    [[nodiscard]] Vec2 GetAnchorA() const override;
    [[nodiscard]] Vec2 GetAnchorB() const override;
    [[nodiscard]] Vec2 GetReactionForce(float inverseDt) const override;
    [[nodiscard]] float GetReactionTorque(float inverseDt) const override;
    [[nodiscard]] Vec2 GetGroundAnchorA() const;
    [[nodiscard]] Vec2 GetGroundAnchorB() const;
    /// The reference lengths of the definition.
    [[nodiscard]] float GetLengthA() const;
    [[nodiscard]] float GetLengthB() const;
    [[nodiscard]] float GetRatio() const;
    [[nodiscard]] float GetCurrentLengthA() const;
    [[nodiscard]] float GetCurrentLengthB() const;

    PulleyJoint(WorldState* state, JointIndex index, JointRow row) : Joint(state, index, row) {}

private:
    [[nodiscard]] PulleyRow& Row() const;
};

}  // namespace scree
