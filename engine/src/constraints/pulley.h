// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The pulley joint as a constraint: one row over the two parts of the rope, each pulling its body towards a fixed
// point, by sequential impulses.

#pragma once

#include "constraints/joint_traits.h"

namespace scree {

/// What the iterations of one pulley joint need. Scratch of one step.
struct PulleyConstraint {
    JointRow row;  ///< in the joint's table
    JointPair pair;
    Vec2 axisA, axisB;  ///< from the ground anchors to the bodies; zero for a rope that is hauled in
    float armA, armB;   ///< turning of the bodies about their centres of mass per unit along these axes, m
    float mass;         ///< effective
};

/// Masses and arms of this step; scales the stored impulses.
void Prepare(const JointInput& in, PulleyRow& row, PulleyConstraint& c);
void WarmStart(const PulleyConstraint& c, const PulleyRow& row, Column<BodyIndex, Velocity>& velocity);
void SolveVelocity(const PulleyConstraint& c, PulleyRow& row, const JointStep& step,
                   Column<BodyIndex, Velocity>& velocity);
/// True if the joint's errors are within the slop.
bool SolvePosition(const PulleyConstraint& c, const PulleyRow& row, const JointStep& step, BodyTable& bodies);

template <>
struct JointTraits<PulleyRow> : CommonJointTraits {
    using Constraint = PulleyConstraint;
    static const JointPhases& GetPhases();
    static float GetError(const BodyTable& bodies, const JointInfo& info, const PulleyRow& row);
};

}  // namespace scree
