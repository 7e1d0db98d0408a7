// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the engine asks of a type of joints beside its row (state/joint_rows.h): JointTraits, one specialisation a type
// in the header of its constraint.

#pragma once

#include "constraints/joint_math.h"
#include "constraints/joint_tree_rows.h"

namespace scree {

struct JointPhases;

/// `Constraint` is the scratch of one joint in a step, `GetPhases()` the phases of sequential impulses.
template <typename Row>
struct JointTraits;

/// What the traits of a type hold that is no different: no direct solve takes its joints over, and they hold no two
/// points together.
struct CommonJointTraits {
    /// What is exact of a joint; false: nothing. `bounded`: it has limits, motors or springs besides.
    template <typename Row>
    static bool Describe(const Row&, TreeShape&, bool& /*bounded*/) {
        return false;
    }
    /// Impulses of the exact rows → the row.
    template <typename Row>
    static void Keep(Row&, const TreeShape&, const TreeRows&, const float (&)[maxTreeRows]) {}
    /// How far apart are what the joint holds together, m.
    template <typename Row>
    static float GetError(const BodyTable&, const JointInfo&, const Row&) {
        return 0.0f;
    }
};

// What several types share.

inline bool IsBounded(const LimitState& limit, const MotorState& motor) { return limit.enabled || motor.enabled; }
/// What is switched off pushes no more.
inline void ClearIdle(LimitState& limit, MotorState& motor) {
    if (!limit.enabled) ClearLimit(limit);
    if (!motor.enabled) motor.impulse = 0.0f;
}
inline void ClearIdle(SpringState& spring) {
    if (!spring.enabled) spring.impulse = 0.0f;
}
inline Vec2 ToVec(const float (&impulse)[maxTreeRows]) { return {impulse[0], impulse[1]}; }
inline Vec2 AxisOf(const TreeRows& rows) { return {static_cast<float>(rows.axisX), static_cast<float>(rows.axisY)}; }

/// From the one anchor to the other in world coordinates.
template <typename Row>
Vec2 GapOf(const BodyTable& bodies, const JointInfo& info, const Row& row) {
    return GapBetween(bodies, info.bodyA, row.localAnchorA, info.bodyB, row.localAnchorB);
}
/// Off an axis that is fixed in A, or beyond the limits on it.
template <typename Row>
float SlideError(const BodyTable& bodies, const JointInfo& info, const Row& row) {
    const Vec2 gap = GapOf(bodies, info, row);
    const Vec2 axis = Mul(bodies.transform[info.bodyA].q, row.localAxisA);
    const float x = Dot(axis, gap);
    const float beyond = row.limit.enabled ? Abs(x - Clamp(x, row.limit.lower, row.limit.upper)) : 0.0f;
    return Max(Abs(Cross(axis, gap)), beyond);
}

}  // namespace scree
