// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a step did and how long its stages took. One word per stage, the same in files, reports and pictures.

#pragma once

#include <cstdint>

namespace scree {

/// Wall times of the last step, ms.
struct Profile {
    float step = 0.0f;         ///< everything
    float broadPhase = 0.0f;   ///< AABBs + build + detection + matching + contact creation and removal
    float narrowPhase = 0.0f;  ///< manifolds and begin/end events
    float islands = 0.0f;      ///< finding islands
    float solver = 0.0f;       ///< constraints, integration, sleeping
    float continuous = 0.0f;   ///< times of impact and their events
};

/// Returned by every step. Counts are of the end of the step.
struct StepReport {
    Profile profile;
    int bodyCount = 0;
    int awakeBodyCount = 0;     ///< dynamic and kinematic bodies that were simulated
    int isolatedBodyCount = 0;  ///< of these, bodies without contacts and joints: they took the ballistic path
    int islandCount = 0;        ///< islands of two or more bodies, or with a constraint; the soft step looks for
                                ///< islands only when something may fall asleep or wake: 0 else
    int contactCount = 0;
    int touchingCount = 0;         ///< as found by this step's narrow phase
    int64_t pairCount = 0;         ///< pairs reported by the broad phase
    int cappedCount = 0;           ///< bodies slowed by WorldDef::maxTranslation or maxRotation
    int continuousEventCount = 0;  ///< times a body was stopped at an impact on its way
    int abandonedCount = 0;        ///< bodies held at an impact because their pair had maxSubSteps events in the step
    float lostTime = 0.0f;         ///< motion that those bodies lost, s, summed
    int nonFiniteCount = 0;        ///< bodies stopped because their velocity or pose became NaN or infinite
};

}  // namespace scree
