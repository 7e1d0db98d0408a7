// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The prismatic joint as a constraint: no offset across the axis and no turning (2×2 block), a motor and two limits
// along the axis, by sequential impulses.

#pragma once

#include "constraints/joint_traits.h"

namespace scree {

/// What the iterations of one prismatic joint need. Scratch of one step.
struct PrismaticConstraint {
    JointRow row;  ///< in the joint's table
    JointPair pair;
    AxisRow along, across;
    Scaled2 k;          ///< inverse effective mass of (across, turning)
    float alongMass;    ///< effective mass of sliding
    float translation;  ///< at the start of the step, m
    Spring spring;
};

/// Masses and arms of this step; scales the stored impulses.
void Prepare(const JointInput& in, PrismaticRow& row, PrismaticConstraint& c);
void WarmStart(const PrismaticConstraint& c, const PrismaticRow& row, Column<BodyIndex, Velocity>& velocity);
/// Only limits, motors and springs.
void SolveBounds(const PrismaticConstraint& c, PrismaticRow& row, const JointStep& step,
                 Column<BodyIndex, Velocity>& velocity);
void SolveVelocity(const PrismaticConstraint& c, PrismaticRow& row, const JointStep& step,
                   Column<BodyIndex, Velocity>& velocity);
/// True if the joint's errors are within the slop.
bool SolvePosition(const PrismaticConstraint& c, const PrismaticRow& row, const JointStep& step, BodyTable& bodies);

template <>
struct JointTraits<PrismaticRow> : CommonJointTraits {
    using Constraint = PrismaticConstraint;
    static const JointPhases& GetPhases();
    static bool Describe(const PrismaticRow& row, TreeShape& shape, bool& bounded);
    static void Keep(PrismaticRow& row, const TreeShape& shape, const TreeRows& rows,
                     const float (&impulse)[maxTreeRows]);
    static float GetError(const BodyTable& bodies, const JointInfo& info, const PrismaticRow& row);
};

}  // namespace scree
