// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// How one body moves, whatever solver runs: caps, the pose at the end of a step, the sleep timer.

#pragma once

#include "pipeline/parts/solver.h"
#include "state/limits.h"

namespace scree {

/// Shortens the body's motion `translation`, `rotation` of this step to the caps; returns the factors. 1 where no cap
/// acts.
struct CapFactors {
    float linear = 1.0f, angular = 1.0f;
    [[nodiscard]] bool Acts() const { return linear != 1.0f || angular != 1.0f; }
};
inline CapFactors CapMotion(const SolverSettings& settings, Vec2 translation, float rotation) {
    CapFactors factors;
    const float lengthSquared = Dot(translation, translation);
    if (lengthSquared > settings.maxTranslation * settings.maxTranslation) {
        factors.linear = settings.maxTranslation / std::sqrt(lengthSquared);
    }
    if (rotation * rotation > settings.maxRotation * settings.maxRotation) {
        factors.angular = settings.maxRotation / Abs(rotation);
    }
    return factors;
}

/// A body that is not finite any more, or beyond all bounds (limits.h), goes back to its start, at rest. Returns true
/// if it did.
inline bool ReturnIfLost(BodyTable& bodies, BodyIndex body) {
    const bool finite = IsInRange(bodies.position[body], bodies.velocity[body]) &&
                        (!bodies.IsFar() || IsInRange(bodies.rest[body].end));
    if (finite) return false;
    bodies.ReturnToStart(body);
    return true;
}
/// Bodies that do not turn keep their rotation: the sine and cosine would be the same.
inline bool HasTurned(const BodyTable& bodies, BodyIndex body) {
    const Position& start = bodies.startPosition[body];
    return bodies.position[body].a != start.a || bodies.position[body].aRest != start.aRest;
}
/// Updates the transform. Returns true if the body was lost.
inline bool FinishPose(BodyTable& bodies, BodyIndex body) {
    const bool isLost = ReturnIfLost(bodies, body);
    HasTurned(bodies, body) ? bodies.UpdateTransform(body) : bodies.UpdateOrigin(body);
    return isLost;
}
/// The same where the body's rotation is known.
inline bool FinishPose(BodyTable& bodies, BodyIndex body, Rot rotation) {
    const bool isLost = ReturnIfLost(bodies, body);
    if (HasTurned(bodies, body)) bodies.transform[body].q = rotation;
    bodies.UpdateOrigin(body);
    return isLost;
}

/// Below this a body is slow, m/s.
inline float SleepSpeed(const SolverSettings& settings) { return linearSleepTolerance * settings.lengthScale; }

/// Advances the body's sleep timer and returns it.
inline float UpdateSleepTimer(BodyTable& bodies, BodyIndex body, const SolverSettings& settings) {
    const Velocity& v = bodies.velocity[body];
    const float tolerance = SleepSpeed(settings);
    const bool slow =
        v.w * v.w <= angularSleepTolerance * angularSleepTolerance && Dot(v.v, v.v) <= tolerance * tolerance;
    if (!bodies.Has(body, BodyFlag::autoSleep) || !slow) {
        bodies.sleepTime[body] = 0.0f;
        return 0.0f;
    }
    bodies.sleepTime[body] += settings.dt;
    return bodies.sleepTime[body];
}

/// Puts the island's bodies to sleep if all of them have been slow for long enough.
inline void SleepIsland(BodyTable& bodies, std::span<const BodyIndex> island, const SolverSettings& settings,
                        bool positionsSolved) {
    float shortest = std::numeric_limits<float>::max();
    for (const BodyIndex body : island) shortest = Min(shortest, UpdateSleepTimer(bodies, body, settings));
    if (shortest < timeToSleep || !positionsSolved) return;
    for (const BodyIndex body : island) bodies.PutToSleep(body);
}

}  // namespace scree
