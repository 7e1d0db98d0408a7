// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Phases of the weld joint.

#include "constraints/weld.h"

#include "constraints/joint_phases.h"

namespace scree {

namespace {

Scaled3 WeldMatrix(const JointPair& p, const Arms& arms, const Mat22& point) {
    const float iA = p.massA.invI, iB = p.massB.invI;
    const Symmetric3 k{
        point.ex.x, point.ex.y, -iA * arms.a.y - iB * arms.b.y, point.ey.y, iA * arms.a.x + iB * arms.b.x, iA + iB};
    return Scale(k);
}

/// Impulses that remove speeds or errors of the point and the angle; the angle is left out if nothing can turn.
Three SolveBlock(const Scaled3& k, const Mat22& point, Vec2 linear, float angular) {
    if (k.k.zz > 0.0f) return Solve(k, {-linear.x, -linear.y, -angular});
    const Vec2 two = point.Solve(-linear);
    return {two.x, two.y, 0.0f};
}

template <typename T>
void ApplyBlock(const WeldConstraint& c, const Arms& arms, const Three& impulse, PairState<T>& state) {
    ApplyPoint(c.pair, arms, {impulse.x, impulse.y}, state);
    Apply(c.pair, turning, impulse.z, state);
}

}  // namespace

void Prepare(const JointInput& in, WeldRow& row, WeldConstraint& c) {
    c.pair = MakePair(in);
    const PairPosition pose = PoseOf(c.pair, in.bodies);
    c.arms = MakeArms(c.pair, pose, row.localAnchorA, row.localAnchorB);
    c.point = PointMatrix(c.pair, c.arms);
    c.k = WeldMatrix(c.pair, c.arms, c.point);
    c.soft = row.stiffness > 0.0f;
    c.spring = {};
    if (c.soft) {
        const float angle = pose.b.a - pose.a.a - row.referenceAngle;
        c.spring = MakeSpring({row.stiffness, row.damping, angle, InverseMass(c.pair, turning)}, in.step.dt);
    }
    row.impulse = Scaled(row.impulse, in.step.impulseScale);
    row.turnImpulse = Scaled(row.turnImpulse, in.step.impulseScale);
}

void WarmStart(const WeldConstraint& c, const WeldRow& row, Column<BodyIndex, Velocity>& velocity) {
    PairVelocity v = Load(c.pair, velocity);
    ApplyBlock(c, c.arms, {row.impulse.x, row.impulse.y, row.turnImpulse}, v);
    Store(c.pair, v, velocity);
}

void SolveBounds(const WeldConstraint& c, WeldRow& row, const JointStep&, Column<BodyIndex, Velocity>& velocity) {
    if (!c.soft) return;
    PairVelocity v = Load(c.pair, velocity);
    Apply(c.pair, turning, SolveSpring(c.spring, Speed(turning, v), row.turnImpulse), v);
    Store(c.pair, v, velocity);
}

void SolveVelocity(const WeldConstraint& c, WeldRow& row, const JointStep&, Column<BodyIndex, Velocity>& velocity) {
    PairVelocity v = Load(c.pair, velocity);
    if (c.soft) {
        Apply(c.pair, turning, SolveSpring(c.spring, Speed(turning, v), row.turnImpulse), v);
        const Vec2 impulse = IsMoved(c.pair) ? c.point.Solve(-PointSpeed(c.arms, v)) : vec2Zero;
        row.impulse += impulse;
        ApplyPoint(c.pair, c.arms, impulse, v);
    } else {
        const Three impulse = SolveBlock(c.k, c.point, PointSpeed(c.arms, v), Speed(turning, v));
        row.impulse += Vec2(impulse.x, impulse.y);
        row.turnImpulse += impulse.z;
        ApplyBlock(c, c.arms, impulse, v);
    }
    Store(c.pair, v, velocity);
}

bool SolvePosition(const WeldConstraint& c, const WeldRow& row, const JointStep& step, BodyTable& bodies) {
    PairPosition pose = Load(c.pair, bodies);
    const Arms arms = MakeArms(c.pair, pose, row.localAnchorA, row.localAnchorB);
    const Mat22 point = PointMatrix(c.pair, arms);
    float angularError = 0.0f;
    if (c.soft) {
        ApplyPoint(c.pair, arms, point.Solve(-arms.gap), pose);
    } else {
        const float angle = pose.b.a - pose.a.a - row.referenceAngle;
        ApplyBlock(c, arms, SolveBlock(WeldMatrix(c.pair, arms, point), point, arms.gap, angle), pose);
        angularError = Abs(angle);
    }
    Store(c.pair, pose, bodies);
    return arms.gap.Length() <= step.slop && angularError <= angularSlop;
}

const JointPhases& JointTraits<WeldRow>::GetPhases() {
    static constexpr JointPhases phases = MakePhases<WeldRow>();
    return phases;
}
bool JointTraits<WeldRow>::Describe(const WeldRow& row, TreeShape& shape, bool& bounded) {
    bounded = row.stiffness > 0.0f;  // turning is a spring then
    shape.kind = bounded ? TreeKind::point : TreeKind::pointAndAngle;
    shape.reference = double{row.referenceAngle};
    return true;
}
void JointTraits<WeldRow>::Keep(WeldRow& row, const TreeShape& shape, const TreeRows&,
                                const float (&impulse)[maxTreeRows]) {
    row.impulse = ToVec(impulse);
    if (shape.kind == TreeKind::pointAndAngle) row.turnImpulse = impulse[2];
}
float JointTraits<WeldRow>::GetError(const BodyTable& bodies, const JointInfo& info, const WeldRow& row) {
    return GapOf(bodies, info, row).Length();
}

}  // namespace scree
