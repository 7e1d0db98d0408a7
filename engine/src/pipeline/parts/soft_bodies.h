// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the soft step does to one body: kicks by forces and by what contacts are expected to do, and moves.

#pragma once

#include "base/two_sum.h"
#include "pipeline/parts/body_motion.h"
#include "pipeline/parts/solver.h"

namespace scree {

/// Without `forces` as in solve_islands.cpp.
template <bool forces>
SoftBody MakeSoftBody(const SolverSettings& settings, const BodyTable& bodies, BodyIndex body) {
    const float h = settings.dt / static_cast<float>(settings.substeps);
    SoftBody soft{};
    soft.body = body;
    soft.linearDamp = soft.angularDamp = 1.0f;
    if (bodies.type[body] != dynamicBody) return soft;
    const MassRow& mass = bodies.mass[body];
    const MotionRow& motion = bodies.motion[body];
    if constexpr (!forces) {
        soft.kick.v = (0.5f * h * mass.invMass) * (motion.mass * settings.gravity + vec2Zero);
        return soft;
    }
    const ForceRow& force = bodies.force[body];
    soft.kick.v = (0.5f * h * mass.invMass) * ((motion.gravityScale * motion.mass) * settings.gravity + force.force);
    soft.kick.w = 0.5f * h * mass.invI * force.torque;
    // Implicit damping over half a sub-step, dv/dt = −c·v: stable at any c and h.
    soft.linearDamp = 1.0f / (1.0f + 0.5f * h * motion.linearDamping);
    soft.angularDamp = 1.0f / (1.0f + 0.5f * h * motion.angularDamping);
    return soft;
}

/// Half a sub-step of forces, damping, and of what contacts did in the last sub-step.
template <bool forces>
inline void Kick(SoftBody& soft, Velocity& v) {
    if constexpr (forces) {
        soft.unaided = {soft.linearDamp * (v.v + soft.kick.v), soft.angularDamp * (v.w + soft.kick.w)};
    } else {
        soft.unaided = {v.v + soft.kick.v, v.w + 0.0f};
    }
    v.v = soft.unaided.v + 0.5f * soft.byContacts.v;
    v.w = soft.unaided.w + 0.5f * soft.byContacts.w;
}

/// The kicks of both halves at once. Contacts are to see what the whole sub-step brings, or they would hold half of a
/// load before the move and drop it after it. What the body moves by is still the velocity between the halves.
template <bool forces>
inline void KickWhole(SoftBody& soft, Velocity& v) {
    Twist first;
    if constexpr (forces) {
        first = {soft.linearDamp * (v.v + soft.kick.v), soft.angularDamp * (v.w + soft.kick.w)};
        soft.unaided = {soft.linearDamp * (first.v + soft.kick.v), soft.angularDamp * (first.w + soft.kick.w)};
    } else {
        first = {v.v + soft.kick.v, v.w + 0.0f};
        soft.unaided = {first.v + soft.kick.v, first.w + 0.0f};
    }
    soft.gained = {first.v + 0.5f * soft.byContacts.v, first.w + 0.5f * soft.byContacts.w};
    v.v = soft.unaided.v + soft.byContacts.v;
    v.w = soft.unaided.w + soft.byContacts.w;
}

inline void Drift(const Velocity& v, float h, Velocity& delta) {
    delta.v += h * v.v;
    delta.w += h * v.w;
}
/// After KickWhole and what constraints did.
inline void DriftWhole(const SoftBody& soft, const Velocity& v, float h, Velocity& delta) {
    delta.v += h * (soft.gained.v + (v.v - (soft.unaided.v + soft.byContacts.v)));
    delta.w += h * (soft.gained.w + (v.w - (soft.unaided.w + soft.byContacts.w)));
}

/// The end pose from the start pose and the motion, under the caps. Returns true if a cap acted.
template <bool limit>
bool MoveBody(const SolverSettings& settings, BodyTable& bodies, BodyIndex b, Velocity& delta) {
    bool capped = false;
    if constexpr (limit) {
        const CapFactors cap = CapMotion(settings, delta.v, delta.w);
        capped = cap.Acts();
        if (capped) {
            delta.v *= cap.linear, delta.w *= cap.angular;
            bodies.velocity[b].v *= cap.linear, bodies.velocity[b].w *= cap.angular;
        }
    }
    const Position& start = bodies.startPosition[b];
    bodies.SetMotion(b, delta.v);
    // The rounding error of the sum is kept: a wheel that has turned a hundred times is not to lose its phase.
    const RoundedSum angle = TwoSum(start.a, delta.w + start.aRest);
    bodies.position[b].a = angle.sum;
    bodies.position[b].aRest = angle.rest;
    return capped;
}

}  // namespace scree
