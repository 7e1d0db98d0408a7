// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a step did and how long its stages took. The names of stages are the same in files, reports and pictures.

#pragma once

#include <cstdint>

namespace scree {

/// Wall times of the last step, ms.
struct Profile {
    float step = 0.0f;         ///< everything
    float broadPhase = 0.0f;   ///< boxes, tree, pairs, and creating and removing contacts
    float narrowPhase = 0.0f;  ///< manifolds and begin/end events
    float islands = 0.0f;      ///< finding islands
    float solver = 0.0f;       ///< constraints, integration, sleeping
    float continuous = 0.0f;   ///< times of impact and their events
};

/// How far the state after a step is from an exact one (World::MeasureErrors).
struct StepErrors {
    float overlap = 0.0f;   ///< deepest overlap of touching shapes, skins included, m; at rest about linearSlop
    float jointGap = 0.0f;  ///< largest distance of points that a joint holds together, or error of a length, m
    /// Largest violation of "push or gap, never both", m: |min(way pushed, gap)| over the points of contact. The way
    /// pushed is how far the step's impulse moved the two bodies apart; the gap is counted from linearSlop of overlap.
    /// 0: every contact either carries its load exactly where it should, or is open and carries none.
    float residual = 0.0f;
};

/// Returned by every step. Counts are those at the end of the step.
struct StepReport {
    Profile profile;
    int bodyCount = 0;
    int awakeBodyCount = 0;     ///< dynamic and kinematic bodies that were simulated
    int isolatedBodyCount = 0;  ///< of these, bodies without contacts and joints: they took the ballistic path
    int islandCount = 0;        ///< islands of two or more bodies, or with a constraint; a soft step without a
                                ///< tolerance looks only for those all of whose bodies may fall asleep in it
    int contactCount = 0;
    int touchingCount = 0;         ///< as found by this step's narrow phase
    int64_t pairCount = 0;         ///< pairs of awake bodies that the broad phase reported last
    int cappedCount = 0;           ///< how often WorldDef::maxTranslation or maxRotation limited a motion
    int continuousEventCount = 0;  ///< impacts that continuous collision found
    int abandonedCount = 0;        ///< bodies held at an impact because their pair had maxSubSteps events in the step
    float lostTime = 0.0f;         ///< simulated time that those bodies lost, s, summed
    int substeps = 0;              ///< of the soft step, in the island that took most; 0 with sequential impulses
    int64_t bodySubsteps = 0;      ///< the same summed over the awake bodies, each with those of its island
    /// Bodies that were put back to where they were, at rest, because their velocity or pose became NaN, infinite or
    /// larger than 1e18. Other bodies and the broad phase never see such a state.
    int nonFiniteCount = 0;
    StepErrors errors;  ///< of steps with a tolerance, and of all while World::SetMeasureErrors is on; else 0
};

}  // namespace scree
