// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The distance joint as a constraint along the line between two points: a rod, or a spring inside a range of lengths,
// by sequential impulses.

#pragma once

#include "constraints/joint_traits.h"

namespace scree {

/// What the iterations of one distance joint need. Scratch of one step.
struct DistanceConstraint {
    JointRow row;  ///< in the joint's table
    JointPair pair;
    AxisRow along;
    float mass;  ///< effective, along the line
    Spring spring;
    float length;  ///< at the start of the step, m
};

/// Masses and arms of this step; scales the stored impulses.
void Prepare(const JointInput& in, DistanceRow& row, DistanceConstraint& c);
void WarmStart(const DistanceConstraint& c, const DistanceRow& row, Column<BodyIndex, Velocity>& velocity);
/// Only limits, motors and springs.
void SolveBounds(const DistanceConstraint& c, DistanceRow& row, const JointStep& step,
                 Column<BodyIndex, Velocity>& velocity);
void SolveVelocity(const DistanceConstraint& c, DistanceRow& row, const JointStep& step,
                   Column<BodyIndex, Velocity>& velocity);
/// True if the joint's errors are within the slop.
bool SolvePosition(const DistanceConstraint& c, const DistanceRow& row, const JointStep& step, BodyTable& bodies);

template <>
struct JointTraits<DistanceRow> : CommonJointTraits {
    using Constraint = DistanceConstraint;
    static const JointPhases& GetPhases();
    static bool Describe(const DistanceRow& row, TreeShape& shape, bool& bounded);
    static void Keep(DistanceRow& row, const TreeShape& shape, const TreeRows& rows,
                     const float (&impulse)[maxTreeRows]);
    static float GetError(const BodyTable& bodies, const JointInfo& info, const DistanceRow& row);
};

}  // namespace scree
