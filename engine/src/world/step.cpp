// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One step, as a table of contents of the pipeline.

#include <cmath>

#include "base/clock.h"
#include "pipeline/find_islands.h"
#include "pipeline/match_contacts.h"
#include "pipeline/narrow_phase.h"
#include "pipeline/solve_islands.h"
#include "pipeline/update_boxes.h"
#include "world/refresh.h"
#include "world/world_state.h"

namespace scree {

namespace {

/// Boxes of everything that moved, then pairs and contacts of the new poses.
void RunBroadPhase(WorldState& s) {
    for (const int body : s.bodies.movers) {
        const auto b = static_cast<size_t>(body);
        if (s.bodies.IsActive(body)) {
            UpdateBodyBoxes(s.bodies, s.fixtures, body, s.bodies.position[b].c - s.bodies.startPosition[b].c,
                            *s.broadPhase);
        }
    }
    FindPairsAndMatch(s);
}

SolverSettings MakeSettings(const WorldState& s, float dt, int velocityIterations, int positionIterations) {
    return {.dt = dt,
            .impulseScale = s.def.warmStarting ? dt * s.lastInverseDt : 0.0f,
            .velocityIterations = velocityIterations,
            .positionIterations = positionIterations,
            .gravity = s.def.gravity,
            .maxTranslation = s.def.maxTranslation,
            .maxRotation = s.def.maxRotation,
            .allowSleep = s.def.allowSleep};
}

void Simulate(WorldState& s, const SolverSettings& settings, Stopwatch& watch, StepReport& report) {
    FindIslands(s.contacts, s.joints, s.bodies, s.islandScratch, s.islands);
    report.profile.islands = watch.Lap();
    const SolverCounts counts =
        SolveIslands(settings, s.fixtures, s.islands, s.Events(), {s.bodies, s.contacts, s.joints}, s.solverScratch);
    report.profile.solver = watch.Lap();
    RunBroadPhase(s);
    report.profile.broadPhase += watch.Lap();
    report.cappedCount = counts.capped;
    report.nonFiniteCount = counts.nonFinite;
    report.isolatedBodyCount = static_cast<int>(s.islands.isolated.size());
    report.islandCount = static_cast<int>(s.islands.islands.size());
    report.awakeBodyCount = report.isolatedBodyCount + static_cast<int>(s.islands.bodies.size());
    s.lastInverseDt = 1.0f / settings.dt;
}

}  // namespace

StepReport World::Step(float timeStep, int velocityIterations, int positionIterations) {
    WorldState& s = *m_state;
    const char* name = "World::Step";
    if (s.locked) {
        s.Refuse(ErrorCode::locked, name, "world", "call Step outside of callbacks");
        return s.report;
    }
    if (!std::isfinite(timeStep))
        return s.Refuse(ErrorCode::nonFinite, name, "timeStep", "give a finite time"), s.report;
    if (timeStep < 0.0f)
        return s.Refuse(ErrorCode::outOfRange, name, "timeStep", "give a time of at least 0"), s.report;
    if (velocityIterations < 0)
        return s.Refuse(ErrorCode::outOfRange, name, "velocityIterations", "give at least 0"), s.report;
    if (positionIterations < 0)
        return s.Refuse(ErrorCode::outOfRange, name, "positionIterations", "give at least 0"), s.report;

    Stopwatch total;
    Stopwatch watch;
    StepReport report;
    s.locked = true;
    if (s.pairsStale) FindPairsAndMatch(s);
    RemoveContacts(s.Events(), {s.bodies, s.fixtures, s.joints, s.contacts});
    report.profile.broadPhase = watch.Lap();
    report.touchingCount = UpdateManifolds(s.fixtures, s.Events(), s.bodies, s.contacts);
    report.profile.narrowPhase = watch.Lap();
    if (timeStep > 0.0f) {
        Simulate(s, MakeSettings(s, timeStep, velocityIterations, positionIterations), watch, report);
    }
    if (s.autoClearForces) ClearForces();
    s.locked = false;

    report.bodyCount = s.bodies.slots.Count();
    report.contactCount = s.contacts.Count();
    report.pairCount = static_cast<int64_t>(s.pairs.size());
    report.profile.step = total.Lap();
    s.report = report;
    return report;
}

}  // namespace scree
