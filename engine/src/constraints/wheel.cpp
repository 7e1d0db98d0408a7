// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Phases of the wheel joint.

#include "constraints/wheel.h"

#include "constraints/joint_phases.h"

namespace scree {

namespace {

/// Wheels turn about their centres as a rule: the arm is zero at any angle.
Arms ArmsOf(const JointPair& p, const PairPosition& pose, const Rot& turnA, const WheelRow& row) {
    const Vec2 a = Mul(turnA, row.localAnchorA - p.massA.localCenter);
    const Vec2 local = row.localAnchorB - p.massB.localCenter;
    const Vec2 b = local == vec2Zero ? vec2Zero : Mul(Rot(pose.b.a), local);
    return {a, b, pose.b.c + b - pose.a.c - a};
}

Arms PrepareRange(const JointInput& in, WheelRow& row, WheelConstraint& c) {
    c.pair = MakePair(in);
    const PairPosition pose = PoseOf(c.pair, in.bodies);
    const Rot turnA(pose.a.a);
    const Arms arms = ArmsOf(c.pair, pose, turnA, row);
    row.axis = Mul(turnA, row.localAxisA);
    c.along = MakeSlide(arms, row.axis);
    const float alongInverse = InverseMass(c.pair, c.along);
    c.alongMass = InverseOrZero(alongInverse);
    if (row.motor.enabled) c.turnMass = InverseOrZero(InverseMass(c.pair, turning));
    c.translation = Dot(row.axis, arms.gap);
    c.angleA = pose.a.a, c.angleB = pose.b.a;
    c.apart = pose.b.c - pose.a.c;
    if (row.limit.enabled) {
        c.armB = arms.b.Length();
        c.reach = c.apart.Length() + c.armB;
    }
    c.spring = {};
    if (row.stiffness > 0.0f && alongInverse > 0.0f) {
        c.spring = MakeSpring({row.stiffness, row.damping, c.translation, alongInverse}, in.step.dt);
    } else {
        row.springImpulse = 0.0f;
    }
    if (!row.limit.enabled) ClearLimit(row.limit);
    if (!row.motor.enabled) row.motor.impulse = 0.0f;
    row.impulse = Scaled(row.impulse, in.step.impulseScale);
    row.springImpulse = Scaled(row.springImpulse, in.step.impulseScale);
    row.motor.impulse = Scaled(row.motor.impulse, in.step.impulseScale);
    ScaleLimit(row.limit, in.step.impulseScale);
    return arms;
}

}  // namespace

void PrepareAcross(const Arms& arms, Vec2 axis, WheelConstraint& c) {
    c.across = MakeSlide(arms, axis.Skew());
    c.acrossMass = InverseOrZero(InverseMass(c.pair, c.across));
}

void Prepare(const JointInput& in, WheelRow& row, WheelConstraint& c) {
    const Arms arms = PrepareRange(in, row, c);
    PrepareAcross(arms, row.axis, c);
}

void PrepareBounds(const JointInput& in, WheelRow& row, WheelConstraint& c) {
    const Arms arms = PrepareRange(in, row, c);
    c.across = {};
    c.acrossMass = 0.0f;
    if (row.limit.enabled) PrepareAcross(arms, row.axis, c);  // SolvePosition removes both errors
}

void WarmStart(const WheelConstraint& c, const WheelRow& row, Column<BodyIndex, Velocity>& velocity) {
    PairVelocity v = Load(c.pair, velocity);
    if (row.impulse != 0.0f) Apply(c.pair, c.across, row.impulse, v);
    Apply(c.pair, c.along, row.springImpulse + row.limit.lowerImpulse - row.limit.upperImpulse, v);
    Apply(c.pair, turning, row.motor.impulse, v);
    Store(c.pair, v, velocity);
}

namespace {

SCREE_INLINE void SolveRange(const WheelConstraint& c, WheelRow& row, const JointStep& step, PairVelocity& v) {
    if (c.spring.mass > 0.0f) {
        const float most = step.dt * row.maxSpringForce;
        Apply(c.pair, c.along, SolveSpring(c.spring, Speed(c.along, v), row.springImpulse, most), v);
    }
    if (row.motor.enabled) {
        const float impulse = -c.turnMass * (Speed(turning, v) - row.motor.speed);
        Apply(c.pair, turning, SolveBounded(row.motor.impulse, impulse, step.dt * row.motor.maximum), v);
    }
    if (row.limit.enabled) SolveLimits(c.pair, c.along, row.limit, v, {c.translation, c.alongMass, step.inverseDt});
}

}  // namespace

void SolveBounds(const WheelConstraint& c, WheelRow& row, const JointStep& step,
                 Column<BodyIndex, Velocity>& velocity) {
    PairVelocity v = Load(c.pair, velocity);
    SolveRange(c, row, step, v);
    Store(c.pair, v, velocity);
}

void SolveVelocity(const WheelConstraint& c, WheelRow& row, const JointStep& step,
                   Column<BodyIndex, Velocity>& velocity) {
    PairVelocity v = Load(c.pair, velocity);
    SolveRange(c, row, step, v);
    const float impulse = -c.acrossMass * Speed(c.across, v);
    row.impulse += impulse;
    Apply(c.pair, c.across, impulse, v);
    Store(c.pair, v, velocity);
}

namespace {

/// True if the translation has not come near a limit since the start of the step. It is axis · (apart + arm of B) less
/// a constant. A turn of A moves it by at most its angle times the reach, one of B by its angle times the arm.
bool IsClear(const WheelConstraint& c, const LimitState& limit, const PairPosition& pose, float slop) {
    const Vec2 moved = pose.b.c - pose.a.c - c.apart;
    const float change = moved.Length() + Abs(pose.a.a - c.angleA) * c.reach + Abs(pose.b.a - c.angleB) * c.armB;
    return Min(c.translation - limit.lower, limit.upper - c.translation) > change + slop;
}

}  // namespace

bool KeepsBounds(const WheelConstraint& c, const WheelRow& row, const JointStep& step, const BodyTable& bodies) {
    if (!row.limit.enabled) return true;
    const PairPosition pose = Load(c.pair, bodies);
    if (IsClear(c, row.limit, pose, step.slop)) return true;
    const Rot turnA(pose.a.a);
    const Arms arms = ArmsOf(c.pair, pose, turnA, row);
    return LimitError(row.limit, Dot(Mul(turnA, row.localAxisA), arms.gap), step.slop) == 0.0f;
}

bool SolvePosition(const WheelConstraint& c, const WheelRow& row, const JointStep& step, BodyTable& bodies) {
    PairPosition pose = Load(c.pair, bodies);
    float limitError = 0.0f;
    if (row.limit.enabled) {
        const Rot turnA(pose.a.a);
        const Arms arms = ArmsOf(c.pair, pose, turnA, row);
        // Arms along the axis of the step's start and, below, effective masses of then. The iteration has the same end
        // without its Jacobian, and Box2D's bodies come to rest in the same places.
        AxisRow along = MakeSlide(arms, row.axis);
        along.axis = Mul(turnA, row.localAxisA);
        limitError = LimitError(row.limit, Dot(along.axis, arms.gap), step.slop);
        Apply(c.pair, along, -limitError * InverseOrZero(InverseMass(c.pair, along)), pose);
    }
    const Rot turnA(pose.a.a);
    const Arms arms = ArmsOf(c.pair, pose, turnA, row);
    const AxisRow across = MakeSlide(arms, Mul(turnA, row.localAxisA).Skew());
    const float error = Dot(across.axis, arms.gap);
    Apply(c.pair, across, -error * c.acrossMass, pose);
    Store(c.pair, pose, bodies);
    return Max(Abs(error), Abs(limitError)) <= step.slop;
}

const JointPhases& JointTraits<WheelRow>::GetPhases() {
    static constexpr JointPhases phases = MakePhases<WheelRow>();
    return phases;
}
bool JointTraits<WheelRow>::Describe(const WheelRow& row, TreeShape& shape, bool& bounded) {
    shape.kind = TreeKind::line;
    shape.axisX = double{row.localAxisA.x}, shape.axisY = double{row.localAxisA.y};
    bounded = IsBounded(row.limit, row.motor) || row.stiffness > 0.0f;
    return true;
}
void JointTraits<WheelRow>::Keep(WheelRow& row, const TreeShape&, const TreeRows& rows,
                                 const float (&impulse)[maxTreeRows]) {
    row.impulse = impulse[0];
    row.axis = AxisOf(rows);
    ClearIdle(row.limit, row.motor);
    if (!(row.stiffness > 0.0f)) row.springImpulse = 0.0f;
}
float JointTraits<WheelRow>::GetError(const BodyTable& bodies, const JointInfo& info, const WheelRow& row) {
    return SlideError(bodies, info, row);
}

}  // namespace scree
