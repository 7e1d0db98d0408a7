// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Velocity and position iterations of the revolute joint. Limits act one step ahead: a joint that is still inside its
// range may close the gap within this step but not overshoot it.

#include "constraints/revolute.h"

namespace scree {

namespace {

Mat22 PointMatrix(const MassRow& massA, const MassRow& massB, Vec2 rA, Vec2 rB) {
    const float m = massA.invMass + massB.invMass;
    Mat22 k;
    k.ex.x = m + massA.invI * rA.y * rA.y + massB.invI * rB.y * rB.y;
    k.ex.y = -massA.invI * rA.x * rA.y - massB.invI * rB.x * rB.y;
    k.ey.x = k.ex.y;
    k.ey.y = m + massA.invI * rA.x * rA.x + massB.invI * rB.x * rB.x;
    return k;
}

void ApplyPoint(const RevoluteConstraint& c, Vec2 impulse, Velocity& a, Velocity& b) {
    a.v -= c.massA.invMass * impulse;
    a.w -= c.massA.invI * Cross(c.rA, impulse);
    b.v += c.massB.invMass * impulse;
    b.w += c.massB.invI * Cross(c.rB, impulse);
}

void ApplyAxial(const RevoluteConstraint& c, float impulse, Velocity& a, Velocity& b) {
    a.w -= c.massA.invI * impulse;
    b.w += c.massB.invI * impulse;
}

/// Adds to a one-sided accumulated impulse; returns the change. `gap` ≥ 0: how far the limit is away.
float SolveLimit(float& accumulated, float speed, float gap, float dt, float mass) {
    const float total = Max(accumulated - mass * (speed + Max(gap, 0.0f) / dt), 0.0f);
    const float change = total - accumulated;
    accumulated = total;
    return change;
}

}  // namespace

RevoluteConstraint PrepareRevolute(const BodyTable& bodies, const JointInfo& joint, RevoluteRow& state,
                                   float impulseScale) {
    const auto a = static_cast<size_t>(joint.bodyA);
    const auto b = static_cast<size_t>(joint.bodyB);
    RevoluteConstraint c;
    c.row = joint.row;
    c.bodyA = joint.bodyA;
    c.bodyB = joint.bodyB;
    c.massA = bodies.mass[a];
    c.massB = bodies.mass[b];
    c.rA = Mul(Rot(bodies.position[a].a), state.localAnchorA - c.massA.localCenter);
    c.rB = Mul(Rot(bodies.position[b].a), state.localAnchorB - c.massB.localCenter);
    c.k = PointMatrix(c.massA, c.massB, c.rA, c.rB);
    const float axial = c.massA.invI + c.massB.invI;
    c.axialMass = axial > 0.0f ? 1.0f / axial : 0.0f;
    c.angle = bodies.position[b].a - bodies.position[a].a - state.referenceAngle;
    const bool rotates = axial > 0.0f;
    if (!state.enableLimit || !rotates) state.lowerImpulse = state.upperImpulse = 0.0f;
    if (!state.enableMotor || !rotates) state.motorImpulse = 0.0f;
    state.impulse *= impulseScale;
    state.motorImpulse *= impulseScale;
    state.lowerImpulse *= impulseScale;
    state.upperImpulse *= impulseScale;
    c.warmStart = impulseScale > 0.0f;
    return c;
}

void WarmStartRevolute(const RevoluteConstraint& c, const RevoluteRow& state, std::vector<Velocity>& velocity) {
    if (!c.warmStart) return;
    Velocity& a = velocity[static_cast<size_t>(c.bodyA)];
    Velocity& b = velocity[static_cast<size_t>(c.bodyB)];
    ApplyPoint(c, state.impulse, a, b);
    ApplyAxial(c, state.motorImpulse + state.lowerImpulse - state.upperImpulse, a, b);
}

void SolveRevoluteVelocity(const RevoluteConstraint& c, RevoluteRow& state, float dt, std::vector<Velocity>& velocity) {
    Velocity& a = velocity[static_cast<size_t>(c.bodyA)];
    Velocity& b = velocity[static_cast<size_t>(c.bodyB)];
    const bool rotates = c.axialMass > 0.0f;
    if (state.enableMotor && rotates) {
        const float speed = b.w - a.w - state.motorSpeed;
        const float limit = dt * state.maxMotorTorque;
        const float total = Clamp(state.motorImpulse - c.axialMass * speed, -limit, limit);
        ApplyAxial(c, total - state.motorImpulse, a, b);
        state.motorImpulse = total;
    }
    if (state.enableLimit && rotates) {
        ApplyAxial(c, SolveLimit(state.lowerImpulse, b.w - a.w, c.angle - state.lowerAngle, dt, c.axialMass), a, b);
        ApplyAxial(c, -SolveLimit(state.upperImpulse, a.w - b.w, state.upperAngle - c.angle, dt, c.axialMass), a, b);
    }
    const Vec2 speed = b.v + Cross(b.w, c.rB) - a.v - Cross(a.w, c.rA);
    const Vec2 impulse = c.k.Solve(-speed);
    state.impulse += impulse;
    ApplyPoint(c, impulse, a, b);
}

bool SolveRevolutePosition(const RevoluteConstraint& c, const RevoluteRow& state, std::vector<Position>& position) {
    Position& a = position[static_cast<size_t>(c.bodyA)];
    Position& b = position[static_cast<size_t>(c.bodyB)];

    float angularError = 0.0f;
    if (state.enableLimit && c.axialMass > 0.0f) {
        const float angle = b.a - a.a - state.referenceAngle;
        float correction = 0.0f;
        if (Abs(state.upperAngle - state.lowerAngle) < 2.0f * angularSlop) {
            correction = Clamp(angle - state.lowerAngle, -maxAngularCorrection, maxAngularCorrection);
        } else if (angle <= state.lowerAngle) {
            correction = Clamp(angle - state.lowerAngle + angularSlop, -maxAngularCorrection, 0.0f);
        } else if (angle >= state.upperAngle) {
            correction = Clamp(angle - state.upperAngle - angularSlop, 0.0f, maxAngularCorrection);
        }
        const float impulse = -c.axialMass * correction;
        a.a -= c.massA.invI * impulse;
        b.a += c.massB.invI * impulse;
        angularError = Abs(correction);
    }

    const Vec2 rA = Mul(Rot(a.a), state.localAnchorA - c.massA.localCenter);
    const Vec2 rB = Mul(Rot(b.a), state.localAnchorB - c.massB.localCenter);
    const Vec2 gap = b.c + rB - a.c - rA;
    const Vec2 impulse = -PointMatrix(c.massA, c.massB, rA, rB).Solve(gap);
    a.c -= c.massA.invMass * impulse;
    a.a -= c.massA.invI * Cross(rA, impulse);
    b.c += c.massB.invMass * impulse;
    b.a += c.massB.invI * Cross(rB, impulse);
    return gap.Length() <= linearSlop && angularError <= angularSlop;
}

}  // namespace scree
