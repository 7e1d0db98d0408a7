// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Phases of the friction joint.

#include "constraints/friction.h"

#include "constraints/joint_phases.h"

namespace scree {

void Prepare(const JointInput& in, FrictionRow& row, FrictionConstraint& c) {
    c.pair = MakePair(in);
    c.arms = MakeArms(c.pair, PoseOf(c.pair, in.bodies), row.localAnchorA, row.localAnchorB);
    c.pointMass = PointMatrix(c.pair, c.arms).GetInverse();
    c.turnMass = InverseOrZero(InverseMass(c.pair, turning));
    row.impulse = Scaled(row.impulse, in.step.impulseScale);
    row.turnImpulse = Scaled(row.turnImpulse, in.step.impulseScale);
}

void WarmStart(const FrictionConstraint& c, const FrictionRow& row, Column<BodyIndex, Velocity>& velocity) {
    PairVelocity v = Load(c.pair, velocity);
    ApplyPoint(c.pair, c.arms, row.impulse, v);
    Apply(c.pair, turning, row.turnImpulse, v);
    Store(c.pair, v, velocity);
}

void SolveVelocity(const FrictionConstraint& c, FrictionRow& row, const JointStep& step,
                   Column<BodyIndex, Velocity>& velocity) {
    PairVelocity v = Load(c.pair, velocity);
    const float turn = -c.turnMass * Speed(turning, v);
    Apply(c.pair, turning, SolveBounded(row.turnImpulse, turn, step.dt * row.maxTorque), v);
    const Vec2 impulse = Mul(c.pointMass, -PointSpeed(c.arms, v));
    ApplyPoint(c.pair, c.arms, SolveBounded(row.impulse, impulse, step.dt * row.maxForce), v);
    Store(c.pair, v, velocity);
}

bool SolvePosition(const FrictionConstraint&, const FrictionRow&, const JointStep&, BodyTable&) { return true; }

const JointPhases& JointTraits<FrictionRow>::GetPhases() {
    static constexpr JointPhases phases = MakePhases<FrictionRow>();
    return phases;
}

}  // namespace scree
