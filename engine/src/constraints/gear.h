// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The gear joint as a constraint: one row over the coordinates of two joints and so over up to four bodies, by
// sequential impulses.

#pragma once

#include "constraints/joint_traits.h"

namespace scree {

/// What the iterations of one gear joint need. Scratch of one step.
struct GearConstraint {
    JointRow row;  ///< in the joint's table
    struct Side {
        BodyIndex body, against;
        MassRow mass, againstMass;
        Vec2 axis;              ///< of the push per unit of impulse; opposite on the other body
        float arm, againstArm;  ///< of the turns
    };
    Side side[2];
    float mass;   ///< effective; 0: nothing can move
    bool active;  ///< all four bodies are enabled
};

/// Masses and arms of this step; scales the stored impulses.
void Prepare(const JointInput& in, GearRow& row, GearConstraint& c);
void WarmStart(const GearConstraint& c, const GearRow& row, Column<BodyIndex, Velocity>& velocity);
void SolveVelocity(const GearConstraint& c, GearRow& row, const JointStep& step, Column<BodyIndex, Velocity>& velocity);
/// True if the joint's errors are within the slop.
bool SolvePosition(const GearConstraint& c, const GearRow& row, const JointStep& step, BodyTable& bodies);

template <>
struct JointTraits<GearRow> : CommonJointTraits {
    using Constraint = GearConstraint;
    static const JointPhases& GetPhases();
};

}  // namespace scree
