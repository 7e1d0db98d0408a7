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
float UpdateSide(const GearSide& side, const std::vector<Position>& position, float ratio, GearConstraint::Side& c) {
    if (!side.slides) {
        c.axis = vec2Zero;
        c.arm = c.againstArm = ratio;
    } else {
        const Position& body = position[static_cast<size_t>(c.body)];
        const Position& against = position[static_cast<size_t>(c.against)];
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
float Coordinate(const GearSide& side, const std::vector<Position>& position, const GearConstraint::Side& c) {
    const Position& body = position[static_cast<size_t>(c.body)];
    const Position& against = position[static_cast<size_t>(c.against)];
    if (!side.slides) return body.a - against.a - side.referenceAngle;
    const Rot turn(against.a);
    const Vec2 anchor = body.c + Mul(Rot(body.a), side.localAnchor - c.mass.localCenter);
    const Vec2 origin = against.c + Mul(turn, side.againstAnchor - c.againstMass.localCenter);
    return Dot(anchor - origin, Mul(turn, side.againstAxis));
}

template <typename T>
void ApplyGear(const GearConstraint& c, float impulse, std::vector<T>& column) {
    for (const GearConstraint::Side& s : c.side) {
        if (s.mass.invMass > 0.0f) Push(s.mass, impulse * s.axis, impulse * s.arm, column[static_cast<size_t>(s.body)]);
        if (s.againstMass.invMass > 0.0f) {
            Push(s.againstMass, -impulse * s.axis, -impulse * s.againstArm, column[static_cast<size_t>(s.against)]);
        }
    }
}

float UpdateSides(const GearRow& row, const std::vector<Position>& position, GearConstraint& c) {
    return UpdateSide(row.side[0], position, 1.0f, c.side[0]) + UpdateSide(row.side[1], position, row.ratio, c.side[1]);
}

}  // namespace

void Prepare(const JointInput& in, GearRow& row, GearConstraint& c) {
    c.active = true;
    for (int i = 0; i < 2; ++i) {
        GearConstraint::Side& s = c.side[i];
        s.body = row.side[i].body;
        s.against = row.side[i].against;
        s.mass = in.bodies.mass[static_cast<size_t>(s.body)];
        s.againstMass = in.bodies.mass[static_cast<size_t>(s.against)];
        c.active = c.active && in.bodies.Has(s.body, BodyFlag::enabled) && in.bodies.Has(s.against, BodyFlag::enabled);
    }
    c.mass = InverseOrZero(UpdateSides(row, in.bodies.position, c));
    for (int i = 0; i < 2; ++i) {
        row.side[i].axis = c.side[i].axis;
        row.side[i].arm = c.side[i].arm;
    }
    row.impulse = c.active ? Scaled(row.impulse, in.step.impulseScale) : 0.0f;
}

void WarmStart(const GearConstraint& c, const GearRow& row, std::vector<Velocity>& velocity) {
    ApplyGear(c, row.impulse, velocity);
}

void SolveVelocity(const GearConstraint& c, GearRow& row, const JointStep&, std::vector<Velocity>& velocity) {
    if (!c.active) return;
    float speed = 0.0f;
    for (const GearConstraint::Side& s : c.side) {
        const Velocity& body = velocity[static_cast<size_t>(s.body)];
        const Velocity& against = velocity[static_cast<size_t>(s.against)];
        speed += Dot(s.axis, body.v - against.v) + s.arm * body.w - s.againstArm * against.w;
    }
    const float impulse = -c.mass * speed;
    row.impulse += impulse;
    ApplyGear(c, impulse, velocity);
}

bool SolvePosition(const GearConstraint& c, const GearRow& row, std::vector<Position>& position) {
    if (!c.active) return true;
    GearConstraint now = c;
    now.mass = InverseOrZero(UpdateSides(row, position, now));
    const float error = Coordinate(row.side[0], position, now.side[0]) +
                        row.ratio * Coordinate(row.side[1], position, now.side[1]) - row.constant;
    ApplyGear(now, -now.mass * error, position);
    return Abs(error) <= (row.side[0].slides ? linearSlop : angularSlop);
}

const JointPhases gearPhases = MakePhases<GearRow, GearConstraint>();

}  // namespace scree
