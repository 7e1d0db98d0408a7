// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Phases of the distance joint. Two points that coincide have no line between them: the velocity rows rest for that
// step and start anew; the position iterations pull the points apart.

#include "constraints/distance.h"

#include <limits>

#include "constraints/joint_phases.h"

namespace scree {

namespace {

bool IsRod(const DistanceRow& row) { return row.limit.lower >= row.limit.upper; }

/// The line from A's anchor to B's, of length 1; zero if it has no direction, being `shortest` or less.
AxisRow MakeLine(const Arms& arms, float length, float shortest) {
    const Vec2 axis = length > shortest ? (1.0f / length) * arms.gap : vec2Zero;
    return {axis, Cross(arms.a, axis), Cross(arms.b, axis)};
}

}  // namespace

void Prepare(const JointInput& in, DistanceRow& row, DistanceConstraint& c) {
    c.pair = MakePair(in);
    const Arms arms = MakeArms(c.pair, PoseOf(c.pair, in.bodies), row.localAnchorA, row.localAnchorB);
    c.length = arms.gap.Length();
    c.along = MakeLine(arms, c.length, row.shortest);
    row.axis = c.along.axis;
    const float inverse = InverseMass(c.pair, c.along);
    c.mass = InverseOrZero(inverse);
    c.spring = {};
    if (row.stiffness > 0.0f && !IsRod(row) && inverse > 0.0f) {
        c.spring = MakeSpring({row.stiffness, row.damping, c.length - row.length, inverse}, in.step.dt);
    } else if (!IsRod(row)) {
        row.impulse = 0.0f;
    }
    const float scale = c.mass > 0.0f ? in.step.impulseScale : 0.0f;
    row.impulse = Scaled(row.impulse, scale);
    ScaleLimit(row.limit, scale);
}

void WarmStart(const DistanceConstraint& c, const DistanceRow& row, Column<BodyIndex, Velocity>& velocity) {
    PairVelocity v = Load(c.pair, velocity);
    Apply(c.pair, c.along, row.impulse + row.limit.lowerImpulse - row.limit.upperImpulse, v);
    Store(c.pair, v, velocity);
}

void SolveBounds(const DistanceConstraint&, DistanceRow&, const JointStep&, Column<BodyIndex, Velocity>&) {
    // A rod has none; springs are never held directly.
}

void SolveVelocity(const DistanceConstraint& c, DistanceRow& row, const JointStep& step,
                   Column<BodyIndex, Velocity>& velocity) {
    PairVelocity v = Load(c.pair, velocity);
    if (IsRod(row)) {
        const float impulse = -c.mass * Speed(c.along, v);
        row.impulse += impulse;
        Apply(c.pair, c.along, impulse, v);
    } else {
        if (c.spring.mass > 0.0f) {
            const float most = step.dt * row.maxSpringForce;
            Apply(c.pair, c.along, SolveSpring(c.spring, Speed(c.along, v), row.impulse, most), v);
        }
        SolveLimits(c.pair, c.along, row.limit, v, {c.length, c.mass, step.inverseDt});
    }
    Store(c.pair, v, velocity);
}

bool SolvePosition(const DistanceConstraint& c, const DistanceRow& row, const JointStep& step, BodyTable& bodies) {
    PairPosition pose = Load(c.pair, bodies);
    const Arms arms = MakeArms(c.pair, pose, row.localAnchorA, row.localAnchorB);
    const float length = arms.gap.Length();
    const float error = length - Clamp(length, row.limit.lower, row.limit.upper);
    const AxisRow line = MakeLine(arms, length, std::numeric_limits<float>::min());
    const float mass = c.mass > 0.0f ? c.mass : InverseOrZero(InverseMass(c.pair, line));
    Apply(c.pair, line, -mass * error, pose);
    Store(c.pair, pose, bodies);
    return Abs(error) < step.slop;
}

const JointPhases& JointTraits<DistanceRow>::GetPhases() {
    static constexpr JointPhases phases = MakePhases<DistanceRow>();
    return phases;
}
bool JointTraits<DistanceRow>::Describe(const DistanceRow& row, TreeShape& shape, bool& bounded) {
    shape.kind = TreeKind::rod;
    shape.reference = double{row.limit.lower};
    shape.shortest = double{row.shortest};
    bounded = false;
    return row.limit.lower >= row.limit.upper;
}
void JointTraits<DistanceRow>::Keep(DistanceRow& row, const TreeShape&, const TreeRows& rows,
                                    const float (&impulse)[maxTreeRows]) {
    row.impulse = impulse[0];
    row.axis = AxisOf(rows);
    ClearLimit(row.limit);
}
float JointTraits<DistanceRow>::GetError(const BodyTable& bodies, const JointInfo& info, const DistanceRow& row) {
    const float length = GapOf(bodies, info, row).Length();
    return Abs(length - Clamp(length, row.limit.lower, row.limit.upper));
}

}  // namespace scree
