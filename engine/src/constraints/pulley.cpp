// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Phases of the pulley joint.

#include "constraints/pulley.h"

#include "constraints/joint_phases.h"

namespace scree {

namespace {

/// A rope shorter than this many slops has no direction and does not pull.
constexpr float shortestRope = 10.0f;

/// One part of the rope.
struct Rope {
    Vec2 axis;
    float arm, length;
};
Rope MakeRope(Vec2 arm, Vec2 anchor, Vec2 groundAnchor, float shortest) {
    const Vec2 line = anchor - groundAnchor;
    const float length = line.Length();
    const Vec2 axis = length > shortest ? (1.0f / length) * line : vec2Zero;
    return {axis, Cross(arm, axis), length};
}

/// Fills the geometry for a pose; returns how much rope is missing.
float Update(const PulleyRow& row, const JointStep& step, const BodyTable& bodies, const PairPosition& pose,
             PulleyConstraint& c) {
    const float shortest = shortestRope * step.slop;
    const Vec2 frame = FrameOf(bodies, c.pair.a, c.pair.b);
    const Arms arms = MakeArms(c.pair, pose, row.localAnchorA, row.localAnchorB);
    const Rope a = MakeRope(arms.a, pose.a.c + arms.a, row.groundAnchorA - frame, shortest);
    const Rope b = MakeRope(arms.b, pose.b.c + arms.b, row.groundAnchorB - frame, shortest);
    c.axisA = a.axis;
    c.axisB = b.axis;
    c.armA = a.arm;
    c.armB = b.arm;
    const float inverseA = c.pair.massA.invMass + c.pair.massA.invI * a.arm * a.arm;
    const float inverseB = c.pair.massB.invMass + c.pair.massB.invI * b.arm * b.arm;
    c.mass = InverseOrZero(inverseA + row.ratio * row.ratio * inverseB);
    return row.constant - a.length - row.ratio * b.length;
}

/// Tension pulls both bodies towards their ground anchors, B by the ratio more.
template <typename T>
void Pull(const PulleyConstraint& c, float tension, float ratio, PairState<T>& state) {
    ApplyImpulse(c.pair.massA, -tension * c.axisA, -tension * c.armA, state.a);
    ApplyImpulse(c.pair.massB, -ratio * tension * c.axisB, -ratio * tension * c.armB, state.b);
}

}  // namespace

void Prepare(const JointInput& in, PulleyRow& row, PulleyConstraint& c) {
    c.pair = MakePair(in);
    Update(row, in.step, in.bodies, PoseOf(c.pair, in.bodies), c);
    row.axis = c.axisB;
    row.impulse = Scaled(row.impulse, in.step.impulseScale);
}

void WarmStart(const PulleyConstraint& c, const PulleyRow& row, Column<BodyIndex, Velocity>& velocity) {
    PairVelocity v = Load(c.pair, velocity);
    Pull(c, row.impulse, row.ratio, v);
    Store(c.pair, v, velocity);
}

void SolveVelocity(const PulleyConstraint& c, PulleyRow& row, const JointStep&, Column<BodyIndex, Velocity>& velocity) {
    PairVelocity v = Load(c.pair, velocity);
    const float speedA = Dot(c.axisA, v.a.v) + c.armA * v.a.w;
    const float speedB = Dot(c.axisB, v.b.v) + c.armB * v.b.w;
    const float tension = c.mass * (speedA + row.ratio * speedB);
    row.impulse += tension;
    Pull(c, tension, row.ratio, v);
    Store(c.pair, v, velocity);
}

bool SolvePosition(const PulleyConstraint& c, const PulleyRow& row, const JointStep& step, BodyTable& bodies) {
    PairPosition pose = Load(c.pair, bodies);
    PulleyConstraint now = c;
    const float missing = Update(row, step, bodies, pose, now);
    Pull(now, -now.mass * missing, row.ratio, pose);
    Store(c.pair, pose, bodies);
    return Abs(missing) < step.slop;
}

const JointPhases& JointTraits<PulleyRow>::GetPhases() {
    static constexpr JointPhases phases = MakePhases<PulleyRow>();
    return phases;
}
float JointTraits<PulleyRow>::GetError(const BodyTable& bodies, const JointInfo& info, const PulleyRow& row) {
    const Vec2 frame = FrameOf(bodies, info.bodyA, info.bodyB);
    const Vec2 a = Mul(TransformIn(frame, bodies, info.bodyA), row.localAnchorA);
    const Vec2 b = Mul(TransformIn(frame, bodies, info.bodyB), row.localAnchorB);
    return Abs(row.constant - Distance(a, row.groundAnchorA - frame) -
               row.ratio * Distance(b, row.groundAnchorB - frame));
}

}  // namespace scree
