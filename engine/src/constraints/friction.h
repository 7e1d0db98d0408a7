// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The friction joint as a constraint: relative motion at a point is stopped by a bounded force and torque, by
// sequential impulses.

#pragma once

#include "constraints/joint_traits.h"

namespace scree {

/// What the iterations of one friction joint need. Scratch of one step.
struct FrictionConstraint {
    JointRow row;  ///< in the joint's table
    JointPair pair;
    Arms arms;
    Mat22 pointMass;  ///< effective mass of the point
    float turnMass;   ///< of relative turning
};

/// Masses and arms of this step; scales the stored impulses.
void Prepare(const JointInput& in, FrictionRow& row, FrictionConstraint& c);
void WarmStart(const FrictionConstraint& c, const FrictionRow& row, Column<BodyIndex, Velocity>& velocity);
void SolveVelocity(const FrictionConstraint& c, FrictionRow& row, const JointStep& step,
                   Column<BodyIndex, Velocity>& velocity);
/// True if the joint's errors are within the slop.
bool SolvePosition(const FrictionConstraint& c, const FrictionRow& row, const JointStep& step, BodyTable& bodies);

template <>
struct JointTraits<FrictionRow> : CommonJointTraits {
    using Constraint = FrictionConstraint;
    static const JointPhases& GetPhases();
};

}  // namespace scree
