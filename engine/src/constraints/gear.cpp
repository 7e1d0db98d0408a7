// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Phases of the gear joint. Its bodies may coincide (two joints on one ground or on one carrier), so changes go to the
// body table one by one.

#include "constraints/gear.h"

#include "constraints/joint_phases.h"

namespace scree {

namespace {

/// Axis and arms of one side for the present poses, times the ratio; returns the side's share of the inverse mass.
float UpdateSide(const GearSide& side, const BodyTable& bodies, float ratio, GearConstraint::Side& c) {
    if (!side.slides) {
        c.axis = vec2Zero;
        c.arm = c.againstArm = ratio;
    } else {
        const Vec2 frame = FrameOf(bodies, c.body, c.against);
        const Position body = PositionIn(frame, bodies, c.body);
        const Position against = PositionIn(frame, bodies, c.against);
        const Rot turn(against.a);
        const Vec2 axis = Mul(turn, side.againstAxis);
        const Vec2 arm = Mul(Rot(body.a), side.localAnchor - c.mass.localCenter);
        c.axis = ratio * axis;
        c.arm = ratio * Cross(arm, axis);
        // The axis turns with the carrier, whose arm therefore reaches to the slider's anchor.
        c.againstArm = ratio * Cross(body.c + arm - against.c, axis);
    }
    return (c.mass.invMass + c.againstMass.invMass) * c.axis.LengthSquared() + c.mass.invI * c.arm * c.arm +
           c.againstMass.invI * c.againstArm * c.againstArm;
}

/// Angle or translation of a side's joint.
float Coordinate(const GearSide& side, const BodyTable& bodies, const GearConstraint::Side& c) {
    const Vec2 frame = FrameOf(bodies, c.body, c.against);
    const Position body = PositionIn(frame, bodies, c.body);
    const Position against = PositionIn(frame, bodies, c.against);
    if (!side.slides) return body.a - against.a - side.referenceAngle;
    const Rot turn(against.a);
    const Vec2 anchor = body.c + Mul(Rot(body.a), side.localAnchor - c.mass.localCenter);
    const Vec2 origin = against.c + Mul(turn, side.againstAnchor - c.againstMass.localCenter);
    return Dot(anchor - origin, Mul(turn, side.againstAxis));
}

void ApplyImpulseTo(const MassRow& mass, Vec2 impulse, float turn, BodyIndex body,
                    Column<BodyIndex, Velocity>& velocity) {
    ApplyImpulse(mass, impulse, turn, velocity[body]);
}
void ApplyImpulseTo(const MassRow& mass, Vec2 impulse, float turn, BodyIndex body, BodyTable& bodies) {
    bodies.Shift(body, mass.invMass * impulse);
    bodies.position[body].a += mass.invI * turn;
}

template <typename Bodies>
void ApplyGear(const GearConstraint& c, float impulse, Bodies& bodies) {
    for (const GearConstraint::Side& s : c.side) {
        if (s.mass.invMass > 0.0f) ApplyImpulseTo(s.mass, impulse * s.axis, impulse * s.arm, s.body, bodies);
        if (s.againstMass.invMass > 0.0f) {
            ApplyImpulseTo(s.againstMass, -impulse * s.axis, -impulse * s.againstArm, s.against, bodies);
        }
    }
}

float UpdateSides(const GearRow& row, const BodyTable& bodies, GearConstraint& c) {
    return UpdateSide(row.side[0], bodies, 1.0f, c.side[0]) + UpdateSide(row.side[1], bodies, row.ratio, c.side[1]);
}

}  // namespace

void Prepare(const JointInput& in, GearRow& row, GearConstraint& c) {
    c.active = true;
    for (int i = 0; i < 2; ++i) {
        GearConstraint::Side& s = c.side[i];
        s.body = row.side[i].body;
        s.against = row.side[i].against;
        s.mass = in.bodies.mass[s.body];
        s.againstMass = in.bodies.mass[s.against];
        c.active = c.active && in.bodies.Has(s.body, BodyFlag::enabled) && in.bodies.Has(s.against, BodyFlag::enabled);
    }
    c.mass = InverseOrZero(UpdateSides(row, in.bodies, c));
    for (int i = 0; i < 2; ++i) {
        row.side[i].axis = c.side[i].axis;
        row.side[i].arm = c.side[i].arm;
    }
    row.impulse = c.active ? Scaled(row.impulse, in.step.impulseScale) : 0.0f;
}

void WarmStart(const GearConstraint& c, const GearRow& row, Column<BodyIndex, Velocity>& velocity) {
    if (c.active) ApplyGear(c, row.impulse, velocity);
}

void SolveVelocity(const GearConstraint& c, GearRow& row, const JointStep&, Column<BodyIndex, Velocity>& velocity) {
    if (!c.active) return;
    float speed = 0.0f;
    for (const GearConstraint::Side& s : c.side) {
        const Velocity& body = velocity[s.body];
        const Velocity& against = velocity[s.against];
        speed += Dot(s.axis, body.v - against.v) + s.arm * body.w - s.againstArm * against.w;
    }
    const float impulse = -c.mass * speed;
    row.impulse += impulse;
    ApplyGear(c, impulse, velocity);
}

bool SolvePosition(const GearConstraint& c, const GearRow& row, const JointStep& step, BodyTable& bodies) {
    if (!c.active) return true;
    GearConstraint now = c;
    now.mass = InverseOrZero(UpdateSides(row, bodies, now));
    const float error = Coordinate(row.side[0], bodies, now.side[0]) +
                        row.ratio * Coordinate(row.side[1], bodies, now.side[1]) - row.constant;
    ApplyGear(now, -now.mass * error, bodies);
    return Abs(error) <= (row.side[0].slides ? step.slop : angularSlop);
}

const JointPhases& JointTraits<GearRow>::GetPhases() {
    static constexpr JointPhases phases = MakePhases<GearRow>();
    return phases;
}

}  // namespace scree
