// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The mouse joint as a constraint: a soft point of body B at a world target with a bounded force, by sequential
// impulses.

#pragma once

#include "constraints/joint_traits.h"

namespace scree {

/// What the iterations of one mouse joint need. Scratch of one step.
struct MouseConstraint {
    JointRow row;  ///< in the joint's table
    BodyIndex body;
    MassRow mass;
    Vec2 arm;        ///< from the centre of mass to the held point
    Mat22 softMass;  ///< effective mass of the softened point
    Vec2 bias;       ///< m/s
    float gamma;
    float spinLeft;  ///< share
};

/// Masses and arms of this step; scales the stored impulses.
void Prepare(const JointInput& in, MouseRow& row, MouseConstraint& c);
void WarmStart(const MouseConstraint& c, const MouseRow& row, Column<BodyIndex, Velocity>& velocity);
void SolveVelocity(const MouseConstraint& c, MouseRow& row, const JointStep& step,
                   Column<BodyIndex, Velocity>& velocity);
/// True if the joint's errors are within the slop.
bool SolvePosition(const MouseConstraint& c, const MouseRow& row, const JointStep& step, BodyTable& bodies);

template <>
struct JointTraits<MouseRow> : CommonJointTraits {
    using Constraint = MouseConstraint;
    static const JointPhases& GetPhases();
};

}  // namespace scree
