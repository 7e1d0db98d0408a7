// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Phases of the revolute joint. Limits act one step ahead: a joint that is still inside its range may close the gap
// within this step but not overshoot it.

#include "constraints/revolute.h"

#include "constraints/joint_phases.h"

namespace scree {

void PrepareBounds(const JointInput& in, RevoluteRow& row, RevoluteConstraint& c) {
    c.pair = MakePair(in);
    c.turnMass = InverseOrZero(InverseMass(c.pair, turning));
    c.angle = in.bodies.position[c.pair.b].a - in.bodies.position[c.pair.a].a - row.referenceAngle;
    if (!row.limit.enabled || c.turnMass == 0.0f) ClearLimit(row.limit);
    if (!row.motor.enabled || c.turnMass == 0.0f) row.motor.impulse = 0.0f;
    c.spring = PrepareSpring(row.spring, c.angle, InverseMass(c.pair, turning), in.step);
    row.impulse = Scaled(row.impulse, in.step.impulseScale);
    row.motor.impulse = Scaled(row.motor.impulse, in.step.impulseScale);
    ScaleLimit(row.limit, in.step.impulseScale);
}

void Prepare(const JointInput& in, RevoluteRow& row, RevoluteConstraint& c) {
    PrepareBounds(in, row, c);
    const PairPosition pose = PoseOf(c.pair, in.bodies);
    c.arms = MakeArms(c.pair, pose, row.localAnchorA, row.localAnchorB);
    c.k = PointMatrix(c.pair, c.arms);
}

/// What a blow within the step brings beyond the limit, the next one takes back.
bool IsIdle(const JointInput& in, const RevoluteRow& row) {
    constexpr float margin = 0.1f;  // rad
    const bool isAtWork = row.motor.enabled || row.motor.impulse != 0.0f || row.spring.enabled ||
                          row.spring.impulse != 0.0f || row.limit.lowerImpulse != 0.0f ||
                          row.limit.upperImpulse != 0.0f;
    if (isAtWork) return false;
    if (!row.limit.enabled) return true;
    const BodyIndex a = in.info.bodyA, b = in.info.bodyB;
    const float angle = in.bodies.position[b].a - in.bodies.position[a].a - row.referenceAngle;
    const float turn = in.bodies.velocity[b].w - in.bodies.velocity[a].w;
    const float reach = margin + 2.0f * Abs(turn) / in.step.inverseDt;
    return angle - row.limit.lower > reach && row.limit.upper - angle > reach;
}

namespace {

float TurnImpulse(const RevoluteRow& row) {
    return row.motor.impulse + row.spring.impulse + row.limit.lowerImpulse - row.limit.upperImpulse;
}

}  // namespace

void WarmStart(const RevoluteConstraint& c, const RevoluteRow& row, Column<BodyIndex, Velocity>& velocity) {
    PairVelocity v = Load(c.pair, velocity);
    ApplyPoint(c.pair, c.arms, row.impulse, v);
    Apply(c.pair, turning, TurnImpulse(row), v);
    Store(c.pair, v, velocity);
}

void WarmStartBounds(const RevoluteConstraint& c, const RevoluteRow& row, Column<BodyIndex, Velocity>& velocity) {
    const float impulse = TurnImpulse(row);
    if (impulse == 0.0f) return;
    PairVelocity v = LoadTurning(c.pair, velocity);
    Apply(c.pair, turning, impulse, v);
    StoreTurning(c.pair, v, velocity);
}

namespace {

SCREE_INLINE void SolveRange(const RevoluteConstraint& c, RevoluteRow& row, const JointStep& step, PairVelocity& v) {
    if (c.spring.mass > 0.0f) {
        const float most = step.dt * row.spring.maximum;
        Apply(c.pair, turning, SolveSpring(c.spring, Speed(turning, v), row.spring.impulse, most), v);
    }
    if (row.motor.enabled && c.turnMass > 0.0f) {
        const float impulse = -c.turnMass * (Speed(turning, v) - row.motor.speed);
        Apply(c.pair, turning, SolveBounded(row.motor.impulse, impulse, step.dt * row.motor.maximum), v);
    }
    if (row.limit.enabled && c.turnMass > 0.0f) {
        SolveLimits(c.pair, turning, row.limit, v, {c.angle, c.turnMass, step.inverseDt});
    }
}

}  // namespace

void SolveBounds(const RevoluteConstraint& c, RevoluteRow& row, const JointStep& step,
                 Column<BodyIndex, Velocity>& velocity) {
    PairVelocity v = LoadTurning(c.pair, velocity);
    SolveRange(c, row, step, v);
    StoreTurning(c.pair, v, velocity);
}

void SolveVelocity(const RevoluteConstraint& c, RevoluteRow& row, const JointStep& step,
                   Column<BodyIndex, Velocity>& velocity) {
    PairVelocity v = Load(c.pair, velocity);
    SolveRange(c, row, step, v);
    const Vec2 impulse = c.k.Solve(-PointSpeed(c.arms, v));
    row.impulse += impulse;
    ApplyPoint(c.pair, c.arms, impulse, v);
    Store(c.pair, v, velocity);
}

namespace {

/// How far the angle is outside its range, within what one correction may do.
float RangeError(const RevoluteConstraint& c, const RevoluteRow& row, const PairPosition& pose) {
    if (!row.limit.enabled || c.turnMass <= 0.0f) return 0.0f;
    const float angle = pose.b.a - pose.a.a - row.referenceAngle;
    float error = LimitError(row.limit, angle, angularSlop);
    // A range keeps one slop of overshoot, so that a resting limit stays pressed and warm; a single angle does not.
    if (row.limit.upper - row.limit.lower >= 2.0f * angularSlop) {
        error = error < 0.0f ? Min(error + angularSlop, 0.0f) : Max(error - angularSlop, 0.0f);
    }
    return Clamp(error, -maxAngularCorrection, maxAngularCorrection);
}

}  // namespace

bool KeepsBounds(const RevoluteConstraint& c, const RevoluteRow& row, const JointStep&, const BodyTable& bodies) {
    return RangeError(c, row, Load(c.pair, bodies)) == 0.0f;
}

bool SolvePosition(const RevoluteConstraint& c, const RevoluteRow& row, const JointStep& step, BodyTable& bodies) {
    PairPosition pose = Load(c.pair, bodies);
    const float error = RangeError(c, row, pose);
    if (error != 0.0f) Apply(c.pair, turning, -c.turnMass * error, pose);
    const Arms arms = MakeArms(c.pair, pose, row.localAnchorA, row.localAnchorB);
    ApplyPoint(c.pair, arms, PointMatrix(c.pair, arms).Solve(-arms.gap), pose);
    Store(c.pair, pose, bodies);
    return arms.gap.Length() <= step.slop && Abs(error) <= angularSlop;
}

const JointPhases& JointTraits<RevoluteRow>::GetPhases() {
    static constexpr JointPhases phases = MakePhases<RevoluteRow>();
    return phases;
}
bool JointTraits<RevoluteRow>::Describe(const RevoluteRow& row, TreeShape& shape, bool& bounded) {
    shape.kind = TreeKind::point;
    bounded = IsBounded(row.limit, row.motor) || row.spring.enabled;
    return true;
}
void JointTraits<RevoluteRow>::Keep(RevoluteRow& row, const TreeShape&, const TreeRows&,
                                    const float (&impulse)[maxTreeRows]) {
    row.impulse = ToVec(impulse);
    ClearIdle(row.limit, row.motor);
    ClearIdle(row.spring);
}
float JointTraits<RevoluteRow>::GetError(const BodyTable& bodies, const JointInfo& info, const RevoluteRow& row) {
    return GapOf(bodies, info, row).Length();
}

}  // namespace scree
