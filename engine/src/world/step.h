// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a step is asked for, what its stages find out, and the step itself.

#pragma once

#include "base/clock.h"
#include "state/limits.h"
#include "world/world_state.h"

namespace scree {

/// As WorldDef::solver wants it.
struct StepRequest {
    float dt;                                    ///< s, ≥ 0
    int velocityIterations, positionIterations;  ///< of sequential impulses
    int substeps;                                ///< of the soft step; 0: sequential impulses
    const Tolerance* tolerance = nullptr;        ///< of the soft step: islands may take more than `substeps`
    bool measureErrors = false;                  ///< the report is to tell the errors that are left

    /// Contacts are brought up to date, and nothing moves.
    [[nodiscard]] bool IsTooShort() const { return dt < shortestStep; }
};

/// What the stages of a step found out, and how long they took.
struct StepResults {
    Profile profile{};
    int touchingCount = 0;
    SolveReport solved{};
    ContinuousReport continuous{};
};

/// One step of a world whose caller has checked the request.
StepReport RunStep(WorldState& state, const StepRequest& request);

/// Bodies and contacts of the coming step; 0 if they are so few that they are done before workers wake.
int CountWorkToShare(const WorldState& state);
/// The solver of these settings for the lists that are gathered; notes whether they are empty.
SolveReport RunSolver(WorldState& state, const SolverSettings& settings, const ContactEvents& events);
/// Times of impact after the solver; `substeps` are those that it took.
ContinuousReport RunContinuous(WorldState& state, const SolverSettings& settings, const ContactEvents& events,
                               int substeps);

SolverSettings MakeSettings(const WorldState& state, const StepRequest& request);
/// The report of a step that is over: times it, and then measures errors if they are asked for.
StepReport MakeReport(WorldState& state, const StepRequest& request, Stopwatch& watch, StepResults& results);

}  // namespace scree
