// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The weld joint as a constraint: a shared point and a shared angle (3×3 block), or a rigid point with an angular
// spring, by sequential impulses.

#pragma once

#include "constraints/joint_traits.h"

namespace scree {

/// What the iterations of one weld joint need. Scratch of one step.
struct WeldConstraint {
    JointRow row;  ///< in the joint's table
    JointPair pair;
    Arms arms;
    Mat22 point;  ///< inverse effective mass of the point
    Scaled3 k;    ///< of the point and the angle
    Spring spring;
    bool soft;  ///< angle by the spring
};

/// Masses and arms of this step; scales the stored impulses.
void Prepare(const JointInput& in, WeldRow& row, WeldConstraint& c);
void WarmStart(const WeldConstraint& c, const WeldRow& row, Column<BodyIndex, Velocity>& velocity);
/// Only limits, motors and springs.
void SolveBounds(const WeldConstraint& c, WeldRow& row, const JointStep& step, Column<BodyIndex, Velocity>& velocity);
void SolveVelocity(const WeldConstraint& c, WeldRow& row, const JointStep& step, Column<BodyIndex, Velocity>& velocity);
/// True if the joint's errors are within the slop.
bool SolvePosition(const WeldConstraint& c, const WeldRow& row, const JointStep& step, BodyTable& bodies);

template <>
struct JointTraits<WeldRow> : CommonJointTraits {
    using Constraint = WeldConstraint;
    static const JointPhases& GetPhases();
    static bool Describe(const WeldRow& row, TreeShape& shape, bool& bounded);
    static void Keep(WeldRow& row, const TreeShape& shape, const TreeRows& rows, const float (&impulse)[maxTreeRows]);
    static float GetError(const BodyTable& bodies, const JointInfo& info, const WeldRow& row);
};

}  // namespace scree
