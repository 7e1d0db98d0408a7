// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Semi-implicit Euler of sequential impulses, body by body: velocities before constraints are solved, positions after.

#pragma once

#include "pipeline/parts/body_motion.h"

namespace scree {

/// Without `forces` no body has damping, a gravity scale or a force. Their neutral values change no bit, so only the
/// sum with a force of 0 stays (it turns −0 into 0).
template <bool forces>
void IntegrateVelocity(const SolverSettings& settings, BodyTable& bodies, BodyIndex b) {
    bodies.NoteStart(b);
    if (settings.exactDrift) bodies.startVelocity[b] = bodies.velocity[b];
    if (bodies.type[b] != dynamicBody) return;
    const float h = settings.dt;
    const MassRow& mass = bodies.mass[b];
    const MotionRow& motion = bodies.motion[b];
    Velocity& v = bodies.velocity[b];
    if constexpr (!forces) {
        v.v += (h * mass.invMass) * (motion.mass * settings.gravity + vec2Zero);
        v.w += 0.0f;
        return;
    }
    const ForceRow& force = bodies.force[b];
    v.v += (h * mass.invMass) * ((motion.gravityScale * motion.mass) * settings.gravity + force.force);
    v.w += h * mass.invI * force.torque;
    // Implicit damping, dv/dt = −c·v: stable at any c and h.
    v.v *= 1.0f / (1.0f + h * motion.linearDamping);
    v.w *= 1.0f / (1.0f + h * motion.angularDamping);
}

/// What the body moves in this step, under the caps. `capped` is set if one acted.
template <bool limit>
Velocity MotionOf(const SolverSettings& settings, BodyTable& bodies, BodyIndex b, bool& capped) {
    const float h = settings.dt;
    Velocity& v = bodies.velocity[b];
    Velocity mean = v;
    if (settings.exactDrift) {
        const Velocity& before = bodies.startVelocity[b];
        mean = {0.5f * (before.v + v.v), 0.5f * (before.w + v.w), 0.0f};
    }
    if constexpr (limit) {
        const CapFactors cap = CapMotion(settings, h * mean.v, h * mean.w);
        capped = cap.Acts();
        if (capped) {
            v.v *= cap.linear, v.w *= cap.angular;
            mean.v *= cap.linear, mean.w *= cap.angular;
        }
    }
    return {h * mean.v, h * mean.w, 0.0f};
}

/// Moves the body by its velocity. Returns true if a cap acted.
template <bool limit>
bool IntegratePosition(const SolverSettings& settings, BodyTable& bodies, BodyIndex b) {
    bool capped = false;
    const Velocity motion = MotionOf<limit>(settings, bodies, b, capped);
    bodies.Shift(b, motion.v);
    bodies.position[b].a += motion.w;
    return capped;
}

/// Larger than one slop: the push itself aims at leaving one slop of overlap.
inline float ContactTolerance(const SolverSettings& settings) { return -3.0f * settings.Slop(); }

}  // namespace scree
