// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One step, as the table of contents of the pipeline: a call a stage, and its lap of the profile.

#include "world/step.h"

#include "base/compiler.h"
#include "base/float_mode.h"
#include "base/undo.h"
#include "pipeline/parts/rouse.h"
#include "world/guard.h"
#include "world/joints/joint_definitions.h"
#include "world/still_step.h"

namespace scree {

namespace {

void ListActive(const BodyTable& bodies, std::vector<BodyIndex>& active) {
    active.clear();
    for (const BodyIndex body : bodies.Listed()) {
        if (bodies.IsActive(body)) active.push_back(body);
    }
}

/// What the step has moved. One that goes on leaves out what was solved before it: an image does not tell of that.
MovedLists MovedBy(const WorldState& s, bool goesOn) {
    if (goesOn) return {&s.continuousScratch.goingOn};
    return {&s.active.isolated, &s.active.bodies, &s.islands.isolated, &s.islands.bodies};
}

/// Moves the bodies. With sub-stepping a step may end after an event; the next one then only goes on with its rest.
void Advance(WorldState& s, const SolverSettings& settings, const ContactEvents& events, Stopwatch& watch,
             StepResults& r) {
    s.contacts.addsFresh = false;
    const bool goesOn = s.continuousScratch.resuming;
    if (goesOn) {
        ListActive(s.bodies, s.continuousScratch.goingOn);
        s.log.NoteAsleep(s.bodies);
    } else {
        GatherLists(settings, *s.pool, s.contacts, s.joints, s.bodies, s.islandScratch, s.isolatedPath, s.Lists());
        s.log.NoteAsleep(s.bodies);
        r.profile.islands = watch.Lap();
        r.solved = RunSolver(s, settings, events);
        r.profile.solver = watch.Lap();
    }
    if (NeedsContinuous(s)) r.continuous = RunContinuous(s, settings, events, r.solved.substeps);
    r.profile.continuous = watch.Lap();
    FindPairsOfMoved(MovedBy(s, goesOn), s.FarDistance(), events, s.ForPairs());
    s.log.NoteMoves(s.bodies);
    RestSleepers(*s.pool, s.bodies, s.fixtures, s.contacts, *s.broadPhase, s.islandScratch.sleepy.rows);
    r.profile.broadPhase += watch.Lap();
    s.lastInverseDt = 1.0f / settings.dt;
    BreakStrainedJoints(s);
    if (r.solved.counts.nonFinite + r.continuous.nonFinite > 0) ForgetLost(s.bodies, s.contacts, s.joints);
}

/// A callback has thrown: the step ends where it is. Queries find what has moved until then where it is.
void EndEarly(WorldState& s) {
    SCREE_TRY {
        ForgetLost(s.bodies, s.contacts, s.joints);
        RouseProxies(s.bodies, s.fixtures, *s.broadPhase);
        UpdateMovedBoxes(s.bodies, s.fixtures, MovedBy(s, false), *s.pool, *s.broadPhase);
        s.broadPhase->PrepareQueries();
    }
    SCREE_CATCH(...) {}  // memory has run out: what moved is found where it was, until the next step
}

/// The stages of a step with something to do. Apart, so that a step without them passes by their code.
SCREE_NOINLINE void RunStages(WorldState& s, const StepRequest& request, const ContactEvents& events, Stopwatch& watch,
                              StepResults& r) {
    const PoolRegion region(*s.pool, CountWorkToShare(s));
    r.touchingCount =
        UpdateManifolds(events, {*s.pool, s.bodies, s.fixtures, s.joints, s.contacts}, s.narrowPhaseScratch);
    r.profile.narrowPhase = watch.Lap();
    PrepareKernels(s);  // listeners of contacts have had their say
    if (request.IsTooShort()) return;
    Advance(s, MakeSettings(s, request), events, watch, r);
}

}  // namespace

StepReport RunStep(WorldState& s, const StepRequest& request) {
    Stopwatch watch;
    StepResults r{.solved = {.substeps = request.substeps}};
    const StandardFloats floats;
    const WorldLock lock(s);
    Undo unlessDone([&s] { EndEarly(s); });
    const ContactEvents events = s.Events(request.substeps == 0);  // Box2D's rule for Box2D's solver
    s.distanceWork = {};
    s.log.BeginStep();
    RouseContacts(s.bodies, s.contacts);
    if (s.isEdited) FindPairsOfEdited(s.edited, events, s.ForPairs());
    s.isEdited = false;
    r.profile.broadPhase = watch.Lap();
    s.contacts.KeepSteady(request.substeps > 0, s.def.lengthScale);
    IsStill(s, request) ? StandStill(s, request, r) : RunStages(s, request, events, watch, r);
    s.log.EndStep();
    s.broadPhase->PrepareQueries();
    if (s.autoClearForces) s.world->ClearForces();
    unlessDone.Dismiss();
    return s.report = MakeReport(s, request, watch, r);
}

}  // namespace scree
