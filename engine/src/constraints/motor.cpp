// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Phases of the motor joint: the error is removed by the velocity rows (Baumgarte), so that the force bounds hold.

#include "constraints/motor.h"

#include "constraints/joint_phases.h"

namespace scree {

void Prepare(const JointInput& in, MotorRow& row, MotorConstraint& c) {
    c.pair = MakePair(in);
    const PairPosition pose = PoseOf(c.pair, in.bodies);
    c.arms = MakeArms(c.pair, pose, row.linearOffset, vec2Zero);
    c.pointMass = PointMatrix(c.pair, c.arms).GetInverse();
    c.turnMass = InverseOrZero(InverseMass(c.pair, turning));
    const float rate = in.step.inverseDt * in.step.ShareNow(row.correctionFactor);
    c.drift = rate * c.arms.gap;
    c.turnDrift = rate * (pose.b.a - pose.a.a - row.angularOffset);
    row.impulse = Scaled(row.impulse, in.step.impulseScale);
    row.turnImpulse = Scaled(row.turnImpulse, in.step.impulseScale);
}

void WarmStart(const MotorConstraint& c, const MotorRow& row, Column<BodyIndex, Velocity>& velocity) {
    PairVelocity v = Load(c.pair, velocity);
    ApplyPoint(c.pair, c.arms, row.impulse, v);
    Apply(c.pair, turning, row.turnImpulse, v);
    Store(c.pair, v, velocity);
}

void SolveVelocity(const MotorConstraint& c, MotorRow& row, const JointStep& step,
                   Column<BodyIndex, Velocity>& velocity) {
    PairVelocity v = Load(c.pair, velocity);
    const float turn = -c.turnMass * (Speed(turning, v) + c.turnDrift);
    Apply(c.pair, turning, SolveBounded(row.turnImpulse, turn, step.dt * row.maxTorque), v);
    const Vec2 impulse = Mul(c.pointMass, -(PointSpeed(c.arms, v) + c.drift));
    ApplyPoint(c.pair, c.arms, SolveBounded(row.impulse, impulse, step.dt * row.maxForce), v);
    Store(c.pair, v, velocity);
}

bool SolvePosition(const MotorConstraint&, const MotorRow&, const JointStep&, BodyTable&) { return true; }

const JointPhases& JointTraits<MotorRow>::GetPhases() {
    static constexpr JointPhases phases = MakePhases<MotorRow>();
    return phases;
}

}  // namespace scree
