// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Phases of the mouse joint. Body A takes part in nothing: the target is a point of the world.

#include "constraints/mouse.h"

#include "constraints/joint_phases.h"

namespace scree {

void Prepare(const JointInput& in, MouseRow& row, MouseConstraint& c) {
    c.body = in.info.bodyB;
    const Vec2 frame = FrameOf(in.bodies, c.body, c.body);
    const Position pose = PositionIn(frame, in.bodies, c.body);
    c.mass = in.bodies.mass[c.body];
    c.arm = Mul(Rot(pose.a), row.localAnchorB - c.mass.localCenter);
    const Vec2 error = pose.c + c.arm - (row.target - frame);
    const Spring spring = MakeSpring({row.stiffness, row.damping, 1.0f, 0.0f}, in.step.dt);
    c.gamma = spring.gamma;
    // A body that hangs on one point would spin for long: Box2D's 2 % per step keep the mouse handy.
    constexpr float lost = 0.02f;
    c.spinLeft = 1.0f - in.step.ShareNow(lost) / static_cast<float>(in.step.parts);
    c.bias = spring.bias * error;
    Mat22 k;
    k.ex = {c.mass.invMass + c.mass.invI * c.arm.y * c.arm.y + c.gamma, -c.mass.invI * c.arm.x * c.arm.y};
    k.ey = {k.ex.y, c.mass.invMass + c.mass.invI * c.arm.x * c.arm.x + c.gamma};
    c.softMass = k.GetInverse();
    row.impulse = Scaled(row.impulse, in.step.impulseScale);
}

void WarmStart(const MouseConstraint& c, const MouseRow& row, Column<BodyIndex, Velocity>& velocity) {
    if (c.mass.invMass == 0.0f) return;
    Velocity& v = velocity[c.body];
    v.w *= c.spinLeft;
    ApplyImpulse(c.mass, row.impulse, Cross(c.arm, row.impulse), v);
}

void SolveVelocity(const MouseConstraint& c, MouseRow& row, const JointStep& step,
                   Column<BodyIndex, Velocity>& velocity) {
    if (c.mass.invMass == 0.0f) return;
    Velocity& v = velocity[c.body];
    const Vec2 speed = v.v + Cross(v.w, c.arm) + c.bias + c.gamma * row.impulse;
    const Vec2 impulse = SolveBounded(row.impulse, Mul(c.softMass, -speed), step.dt * row.maxForce);
    ApplyImpulse(c.mass, impulse, Cross(c.arm, impulse), v);
}

bool SolvePosition(const MouseConstraint&, const MouseRow&, const JointStep&, BodyTable&) { return true; }

const JointPhases& JointTraits<MouseRow>::GetPhases() {
    static constexpr JointPhases phases = MakePhases<MouseRow>();
    return phases;
}

}  // namespace scree
