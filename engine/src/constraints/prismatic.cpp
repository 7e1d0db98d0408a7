// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Phases of the prismatic joint. Position errors across and along the axis and of the angle are removed together when a
// limit is touched, because they share the bodies' rotation.

#include "constraints/prismatic.h"

#include "constraints/joint_phases.h"

namespace scree {

namespace {

/// Both bodies may have fixed rotation: their angle row then has no mass and must not make the block singular.
float TurnCoupling(const JointPair& p) {
    const float k = InverseMass(p, turning);
    return k > 0.0f ? k : 1.0f;
}

}  // namespace

void Prepare(const JointInput& in, PrismaticRow& row, PrismaticConstraint& c) {
    c.pair = MakePair(in);
    const PairPosition pose = PoseOf(c.pair, in.bodies);
    const Rot turnA(pose.a.a);
    const Arms arms = MakeArms(c.pair, pose, turnA, row.localAnchorA, row.localAnchorB);
    row.axis = Mul(turnA, row.localAxisA);
    c.along = MakeSlide(arms, row.axis);
    c.across = MakeSlide(arms, row.axis.Skew());
    c.alongMass = InverseOrZero(InverseMass(c.pair, c.along));
    const float mixed = Coupling(c.pair, c.across, turning);
    c.k = Scale(Mat22{{InverseMass(c.pair, c.across), mixed}, {mixed, TurnCoupling(c.pair)}});
    c.translation = Dot(row.axis, arms.gap);
    c.spring = PrepareSpring(row.spring, c.translation, InverseMass(c.pair, c.along), in.step);
    if (!row.limit.enabled) ClearLimit(row.limit);
    if (!row.motor.enabled) row.motor.impulse = 0.0f;
    row.impulse = Scaled(row.impulse, in.step.impulseScale);
    row.motor.impulse = Scaled(row.motor.impulse, in.step.impulseScale);
    ScaleLimit(row.limit, in.step.impulseScale);
}

void WarmStart(const PrismaticConstraint& c, const PrismaticRow& row, Column<BodyIndex, Velocity>& velocity) {
    PairVelocity v = Load(c.pair, velocity);
    Apply(c.pair, c.along, row.motor.impulse + row.spring.impulse + row.limit.lowerImpulse - row.limit.upperImpulse, v);
    Apply(c.pair, c.across, row.impulse.x, v);
    Apply(c.pair, turning, row.impulse.y, v);
    Store(c.pair, v, velocity);
}

namespace {

SCREE_INLINE void SolveRange(const PrismaticConstraint& c, PrismaticRow& row, const JointStep& step, PairVelocity& v) {
    if (c.spring.mass > 0.0f) {
        const float most = step.dt * row.spring.maximum;
        Apply(c.pair, c.along, SolveSpring(c.spring, Speed(c.along, v), row.spring.impulse, most), v);
    }
    if (row.motor.enabled) {
        const float impulse = c.alongMass * (row.motor.speed - Speed(c.along, v));
        Apply(c.pair, c.along, SolveBounded(row.motor.impulse, impulse, step.dt * row.motor.maximum), v);
    }
    if (row.limit.enabled) SolveLimits(c.pair, c.along, row.limit, v, {c.translation, c.alongMass, step.inverseDt});
}

}  // namespace

void SolveBounds(const PrismaticConstraint& c, PrismaticRow& row, const JointStep& step,
                 Column<BodyIndex, Velocity>& velocity) {
    PairVelocity v = Load(c.pair, velocity);
    SolveRange(c, row, step, v);
    Store(c.pair, v, velocity);
}

void SolveVelocity(const PrismaticConstraint& c, PrismaticRow& row, const JointStep& step,
                   Column<BodyIndex, Velocity>& velocity) {
    PairVelocity v = Load(c.pair, velocity);
    SolveRange(c, row, step, v);
    const Vec2 impulse = Solve(c.k, -Vec2(Speed(c.across, v), Speed(turning, v)));
    row.impulse += impulse;
    Apply(c.pair, c.across, impulse.x, v);
    Apply(c.pair, turning, impulse.y, v);
    Store(c.pair, v, velocity);
}

bool SolvePosition(const PrismaticConstraint& c, const PrismaticRow& row, const JointStep& step, BodyTable& bodies) {
    PairPosition pose = Load(c.pair, bodies);
    const Rot turnA(pose.a.a);
    const Arms arms = MakeArms(c.pair, pose, turnA, row.localAnchorA, row.localAnchorB);
    const Vec2 axis = Mul(turnA, row.localAxisA);
    const AxisRow along = MakeSlide(arms, axis), across = MakeSlide(arms, axis.Skew());
    const Vec2 error{Dot(across.axis, arms.gap), pose.b.a - pose.a.a - row.referenceAngle};
    const float limitError = row.limit.enabled ? LimitError(row.limit, Dot(axis, arms.gap), step.slop) : 0.0f;
    const Symmetric3 k{InverseMass(c.pair, across), Coupling(c.pair, across, turning), Coupling(c.pair, across, along),
                       TurnCoupling(c.pair),        Coupling(c.pair, turning, along),  InverseMass(c.pair, along)};
    Three impulse{0.0f, 0.0f, 0.0f};
    if (limitError != 0.0f) {
        impulse = Solve(Scale(k), {-error.x, -error.y, -limitError});
    } else {
        const Vec2 two = Solve(Scale(Mat22{{k.xx, k.xy}, {k.xy, k.yy}}), -error);
        impulse = {two.x, two.y, 0.0f};
    }
    Apply(c.pair, across, impulse.x, pose);
    Apply(c.pair, turning, impulse.y, pose);
    Apply(c.pair, along, impulse.z, pose);
    Store(c.pair, pose, bodies);
    return Max(Abs(error.x), Abs(limitError)) <= step.slop && Abs(error.y) <= angularSlop;
}

const JointPhases& JointTraits<PrismaticRow>::GetPhases() {
    static constexpr JointPhases phases = MakePhases<PrismaticRow>();
    return phases;
}
bool JointTraits<PrismaticRow>::Describe(const PrismaticRow& row, TreeShape& shape, bool& bounded) {
    shape.kind = TreeKind::slide;
    shape.axisX = double{row.localAxisA.x}, shape.axisY = double{row.localAxisA.y};
    shape.reference = double{row.referenceAngle};
    bounded = IsBounded(row.limit, row.motor) || row.spring.enabled;
    return true;
}
void JointTraits<PrismaticRow>::Keep(PrismaticRow& row, const TreeShape&, const TreeRows& rows,
                                     const float (&impulse)[maxTreeRows]) {
    row.impulse = ToVec(impulse);
    row.axis = AxisOf(rows);
    ClearIdle(row.limit, row.motor);
    ClearIdle(row.spring);
}
float JointTraits<PrismaticRow>::GetError(const BodyTable& bodies, const JointInfo& info, const PrismaticRow& row) {
    return SlideError(bodies, info, row);
}

}  // namespace scree
