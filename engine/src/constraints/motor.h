// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The motor joint as a constraint: body B is driven to an offset and an angle in body A by a bounded force and torque,
// by sequential impulses.

#pragma once

#include "constraints/joint_traits.h"

namespace scree {

/// What the iterations of one motor joint need. Scratch of one step.
struct MotorConstraint {
    JointRow row;  ///< in the joint's table
    JointPair pair;
    Arms arms;
    Mat22 pointMass;  ///< effective mass of the point
    float turnMass;   ///< of relative turning
    Vec2 drift;       ///< speed that removes the share of the offset error in this step, m/s
    float turnDrift;  ///< rad/s
};

/// Masses and arms of this step; scales the stored impulses.
void Prepare(const JointInput& in, MotorRow& row, MotorConstraint& c);
void WarmStart(const MotorConstraint& c, const MotorRow& row, Column<BodyIndex, Velocity>& velocity);
void SolveVelocity(const MotorConstraint& c, MotorRow& row, const JointStep& step,
                   Column<BodyIndex, Velocity>& velocity);
/// True if the joint's errors are within the slop.
bool SolvePosition(const MotorConstraint& c, const MotorRow& row, const JointStep& step, BodyTable& bodies);

template <>
struct JointTraits<MotorRow> : CommonJointTraits {
    using Constraint = MotorConstraint;
    static const JointPhases& GetPhases();
};

}  // namespace scree
