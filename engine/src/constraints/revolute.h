// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The revolute joint as a constraint: a shared point (2×2 block), a motor and two limits, by sequential impulses.

#pragma once

#include <vector>

#include "state/bodies.h"
#include "state/joints.h"

namespace scree {

/// What the iterations of one revolute joint need. Scratch of one step.
struct RevoluteConstraint {
    int row;  ///< in JointTable::revolute
    int bodyA, bodyB;
    MassRow massA, massB;
    Vec2 rA, rB;      ///< anchors from the centres of mass
    Mat22 k;          ///< inverse effective mass of the point
    float axialMass;  ///< effective mass of relative rotation; 0: both bodies have fixed rotation
    float angle;      ///< joint angle at the start of the step, rad
    bool warmStart;
};

/// `impulseScale` = dt / last dt, 0 without warm starting (the stored impulses are then cleared).
RevoluteConstraint PrepareRevolute(const BodyTable& bodies, const JointInfo& joint, RevoluteRow& state,
                                   float impulseScale);
void WarmStartRevolute(const RevoluteConstraint& c, const RevoluteRow& state, std::vector<Velocity>& velocity);
void SolveRevoluteVelocity(const RevoluteConstraint& c, RevoluteRow& state, float dt, std::vector<Velocity>& velocity);
/// True if the joint's errors are within the slop.
bool SolveRevolutePosition(const RevoluteConstraint& c, const RevoluteRow& state, std::vector<Position>& position);

}  // namespace scree
