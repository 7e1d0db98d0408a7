// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One step, as the table of contents of the pipeline: a call a stage, and its lap of the profile.

#include "world/step.h"

#include "base/clock.h"
#include "state/limits.h"
#include "world/guard.h"

namespace scree {

namespace {

/// Few bodies without contacts are done before workers wake.
bool HasWorkToShare(const WorldState& s) {
    constexpr int leastContacts = 128;
    const size_t movers = s.bodies.movers.size();
    return movers >= leastBoxesToShare || (movers >= leastBodies && s.contacts.Count() >= leastContacts);
}

/// Moves the bodies. With sub-stepping a step may end after an event; the next one then only goes on with its rest.
void Advance(WorldState& s, const SolverSettings& settings, Stopwatch& watch, StepResults& r) {
    if (!s.continuousScratch.resuming) {
        GatherLists(settings, s.contacts, s.joints, s.bodies, s.islandScratch, s.isolatedPath, s.Lists());
        r.profile.islands = watch.Lap();
        r.solved = Solve(settings, s.fixtures, s.Lists(), s.Events(), {*s.pool, s.bodies, s.contacts, s.joints},
                         s.solverScratch);
        r.profile.solver = watch.Lap();
    }
    if (NeedsContinuous(s)) {
        const std::vector<int>& isolated = SolvedOf(settings, s.Lists()).isolated;
        auto own = MakeContinuousSettings(settings, r.solved.substeps, isolated, s.def.subStepping);
        SolverSettings ofRest = settings;
        IslandTable& rest = s.solverScratch.rest;
        if (settings.substeps > 0 && s.joints.slots.Count() > 0) {
            ofRest.substeps = r.solved.substeps;
            own.startVelocity = &s.solverScratch.startVelocity;
            own.solveRest = [&](const JointedRest& jointed) {
                PrepareKernels(s);  // listeners of contacts may have changed materials on the way
                rest.bodies.assign(jointed.bodies.begin(), jointed.bodies.end());
                rest.contacts.assign(jointed.contacts.begin(), jointed.contacts.end());
                rest.joints.assign(jointed.joints.begin(), jointed.joints.end());
                SolveRest(ofRest, jointed.dt, s.fixtures, rest, s.Events(), {*s.pool, s.bodies, s.contacts, s.joints},
                          s.solverScratch);
            };
        }
        r.continuous = SolveContinuous(own, s.Events(), {s.bodies, s.fixtures, s.joints, s.contacts, *s.broadPhase},
                                       s.continuousScratch);
    }
    r.profile.continuous = watch.Lap();
    if (r.solved.counts.nonFinite + r.continuous.nonFinite > 0) ForgetNonFiniteImpulses(s.contacts);
    FindPairsOfMoved({&s.active.isolated, &s.active.bodies, &s.islands.isolated, &s.islands.bodies}, s.FarDistance(),
                     s.Events(), s.ForPairs());
    s.pairsStale = false;
    r.profile.broadPhase += watch.Lap();
    s.lastInverseDt = 1.0f / settings.dt;
}

}  // namespace

StepReport RunStep(WorldState& s, const StepRequest& request) {
    Stopwatch total, watch;
    StepResults r{.solved = {.substeps = request.substeps}};
    const WorldLock lock(s);
    s.distanceWork = {};
    if (s.pairsStale) FindPairs(FreshOrder::oldestFirst, s.Events(), s.ForPairs());
    s.pairsStale = false;
    r.profile.broadPhase = watch.Lap();
    s.contacts.keepsSteady = request.substeps > 0;
    s.contacts.steadyReach = 8.0f * linearSlop * s.def.lengthScale;
    const PoolRegion region(*s.pool, HasWorkToShare(s));
    r.touchingCount =
        UpdateManifolds(s.Events(), {*s.pool, s.bodies, s.fixtures, s.joints, s.contacts}, s.narrowPhaseScratch);
    r.profile.narrowPhase = watch.Lap();
    PrepareKernels(s);  // listeners of contacts have had their say
    if (request.dt >= shortestStep) Advance(s, MakeSettings(s, request), watch, r);
    if (s.autoClearForces) s.world->ClearForces();
    r.profile.step = total.Lap();
    s.report = MakeReport(s, request, r);
    return s.report;
}

}  // namespace scree
