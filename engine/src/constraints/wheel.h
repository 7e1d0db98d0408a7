// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The wheel joint as a constraint: no offset across the axis, a spring and two limits along it, a motor that turns the
// wheel, by sequential impulses.

#pragma once

#include "constraints/joint_traits.h"

namespace scree {

/// What the iterations of one wheel joint need. Scratch of one step.
struct WheelConstraint {
    JointRow row;  ///< in the joint's table
    JointPair pair;
    AxisRow along, across;
    float acrossMass, alongMass, turnMass;  ///< effective; that of turning where there is a motor
    Spring spring;
    float translation;  ///< at the start of the step, m
    // As of then too, and what tells how far the translation may have come since.
    float angleA, angleB;
    Vec2 apart;         ///< from A's centre of mass to B's
    float reach, armB;  ///< where there are limits: `apart` and B's anchor together, and B's anchor alone, m
};

/// Masses and arms of this step; scales the stored impulses.
void Prepare(const JointInput& in, WheelRow& row, WheelConstraint& c);
/// The part of that which keeps the offset across the axis at 0.
void PrepareAcross(const Arms& arms, Vec2 axis, WheelConstraint& c);
/// The same as Prepare for limits, motors and springs alone.
void PrepareBounds(const JointInput& in, WheelRow& row, WheelConstraint& c);
void WarmStart(const WheelConstraint& c, const WheelRow& row, Column<BodyIndex, Velocity>& velocity);
/// Only limits, motors and springs.
void SolveBounds(const WheelConstraint& c, WheelRow& row, const JointStep& step, Column<BodyIndex, Velocity>& velocity);
void SolveVelocity(const WheelConstraint& c, WheelRow& row, const JointStep& step,
                   Column<BodyIndex, Velocity>& velocity);
/// True if SolvePosition finds nothing to do for limits.
bool KeepsBounds(const WheelConstraint& c, const WheelRow& row, const JointStep& step, const BodyTable& bodies);
/// True if the joint's errors are within the slop.
bool SolvePosition(const WheelConstraint& c, const WheelRow& row, const JointStep& step, BodyTable& bodies);

template <>
struct JointTraits<WheelRow> : CommonJointTraits {
    using Constraint = WheelConstraint;
    static const JointPhases& GetPhases();
    static bool Describe(const WheelRow& row, TreeShape& shape, bool& bounded);
    static void Keep(WheelRow& row, const TreeShape& shape, const TreeRows& rows, const float (&impulse)[maxTreeRows]);
    static float GetError(const BodyTable& bodies, const JointInfo& info, const WheelRow& row);
};

}  // namespace scree
