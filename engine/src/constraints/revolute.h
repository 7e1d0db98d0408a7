// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The revolute joint as a constraint: a shared point (2×2 block), a motor and two limits, by sequential impulses.

#pragma once

#include "constraints/joint_traits.h"

namespace scree {

/// What the iterations of one revolute joint need. Scratch of one step.
struct RevoluteConstraint {
    JointRow row;  ///< in the joint's table
    JointPair pair;
    Arms arms;
    Mat22 k;         ///< inverse effective mass of the point
    float turnMass;  ///< effective mass of relative turning; 0: both bodies have fixed rotation
    float angle;     ///< joint angle at the start of the step, rad
    Spring spring;
};

/// Masses and arms of this step; scales the stored impulses.
void Prepare(const JointInput& in, RevoluteRow& row, RevoluteConstraint& c);
/// The same for limits and motors alone.
void PrepareBounds(const JointInput& in, RevoluteRow& row, RevoluteConstraint& c);
/// Whether limits alone could act, and are too far for it.
[[nodiscard]] bool IsIdle(const JointInput& in, const RevoluteRow& row);
void WarmStart(const RevoluteConstraint& c, const RevoluteRow& row, Column<BodyIndex, Velocity>& velocity);
/// The same of limits, motors and springs alone.
void WarmStartBounds(const RevoluteConstraint& c, const RevoluteRow& row, Column<BodyIndex, Velocity>& velocity);
/// Only limits, motors and springs.
void SolveBounds(const RevoluteConstraint& c, RevoluteRow& row, const JointStep& step,
                 Column<BodyIndex, Velocity>& velocity);
void SolveVelocity(const RevoluteConstraint& c, RevoluteRow& row, const JointStep& step,
                   Column<BodyIndex, Velocity>& velocity);
/// True if SolvePosition finds nothing to do for limits.
bool KeepsBounds(const RevoluteConstraint& c, const RevoluteRow& row, const JointStep& step, const BodyTable& bodies);
/// True if the joint's errors are within the slop.
bool SolvePosition(const RevoluteConstraint& c, const RevoluteRow& row, const JointStep& step, BodyTable& bodies);

template <>
struct JointTraits<RevoluteRow> : CommonJointTraits {
    using Constraint = RevoluteConstraint;
    static const JointPhases& GetPhases();
    static bool Describe(const RevoluteRow& row, TreeShape& shape, bool& bounded);
    static void Keep(RevoluteRow& row, const TreeShape& shape, const TreeRows& rows,
                     const float (&impulse)[maxTreeRows]);
    static float GetError(const BodyTable& bodies, const JointInfo& info, const RevoluteRow& row);
};

}  // namespace scree
