// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The public Steps: what they are asked, checked and turned into a request; the settings and calls of its solver; its
// report.

#include <algorithm>
#include <optional>

#include "pipeline/measure_errors.h"
#include "scree/inspect.h"
#include "world/guard.h"
#include "world/step.h"

namespace scree {

namespace {

/// Number of sub-steps that stands for this many velocity iterations.
int SubstepsFor(int velocityIterations) {
    constexpr int least = 4;
    return std::max(least, (velocityIterations + 1) / 2);
}

/// The request as WorldDef::solver wants it. A tolerance is of no use to sequential impulses.
StepRequest Resolve(const WorldState& s, const StepRequest& asked) {
    StepRequest request = asked;
    if (s.def.solver == SolverKind::softStep && asked.substeps == 0) {
        request.substeps = SubstepsFor(asked.velocityIterations);
    } else if (s.def.solver == SolverKind::sequentialImpulses && asked.substeps > 0) {
        request.velocityIterations = 2 * asked.substeps;
        request.positionIterations = std::max(1, 3 * asked.substeps / 4);
        request.substeps = 0;
        request.tolerance = nullptr;
    }
    return request;
}

/// By how much the impulses of the last step are to be scaled for this one; 0: they are of no use for it.
float ImpulseScale(float dt, float lastInverseDt) {
    const float ratio = dt * lastInverseDt;
    return ratio <= mostStepRatio ? ratio : 0.0f;
}

/// What is left after a step; with a tolerance the bodies' demands are noted, too.
StepErrors MeasureStep(WorldState& s, const StepRequest& request, const SolveReport& solved) {
    if (request.tolerance == nullptr || solved.bodySubsteps == 0) return s.world->MeasureErrors();
    return MeasureDemand({s.bodies, s.fixtures, s.contacts, s.joints}, linearSlop * s.def.lengthScale,
                         1.0f / s.lastInverseDt, s.bodies.demand);
}

StepReport Run(World& world, const StepRequest& asked, const Recording& recording) {
    const StepReport report = RunStep(world.GetState(), Resolve(world.GetState(), asked));
    if (recording.IsOn()) recording.NoteHash(inspect::GetStateHash(world));
    return report;
}

}  // namespace

int CountWorkToShare(const WorldState& s) {
    constexpr int leastConstraints = 128;
    const size_t movers = s.bodies.Listed().size();
    // Of joints nobody counts those that act. They are seldom more than the bodies that move.
    const int joints = std::min(s.joints.slots.Count(), static_cast<int>(movers));
    const int constraints = s.contacts.active.Count() + joints;
    const bool isEnough = s.pool->SharesAlways() || movers >= leastBoxesToShare ||
                          (movers >= leastBodies && constraints >= leastConstraints);
    return isEnough ? static_cast<int>(movers) + constraints : 0;
}

SolveReport RunSolver(WorldState& s, const SolverSettings& settings, const ContactEvents& events) {
    s.idleSubsteps = WorldState::notIdle;  // also when a callback throws
    const SolveReport report =
        Solve(settings, s.fixtures, s.Lists(), events, {*s.pool, s.bodies, s.contacts, s.joints}, s.solverScratch);
    if (report.awakeCount == 0) s.idleSubsteps = settings.substeps;
    return report;
}

ContinuousReport RunContinuous(WorldState& s, const SolverSettings& settings, const ContactEvents& events,
                               int substeps) {
    const std::vector<BodyIndex>& isolated = SolvedOf(settings, s.Lists()).isolated;
    ContinuousSettings own = MakeContinuousSettings(settings, substeps, isolated, s.def.subStepping);
    SolverSettings ofRest = settings;
    ofRest.substeps = substeps;
    std::optional<TaskPool> alone;  // several rests at a time do not share their loops
    const auto solveRest = [&](const JointedRest& jointed) {
        RestScratch& scratch = *s.restScratches[ToSize(jointed.worker)];
        scratch.lists.bodies.assign(jointed.bodies.begin(), jointed.bodies.end());
        scratch.lists.contacts.assign(jointed.contacts.begin(), jointed.contacts.end());
        scratch.lists.joints.assign(jointed.joints.begin(), jointed.joints.end());
        return SolveRest(ofRest, jointed.dt, s.fixtures, scratch.lists, events,
                         {alone ? *alone : *s.pool, s.bodies, s.contacts, s.joints}, scratch.solver);
    };
    const auto prepareRests = [&](int workers) {
        PrepareKernels(s);  // listeners of contacts may have changed materials on the way
        while (s.restScratches.size() < ToSize(workers)) s.restScratches.push_back(std::make_unique<RestScratch>());
        s.contacts.steady.resize(s.contacts.flags.size());
        MakeRollingRows(settings, s.contacts);
        alone.reset();
        if (workers > 1) alone.emplace(1, TaskCallbacks{});
    };
    if (settings.substeps > 0 && s.joints.slots.Count() > 0) {
        // A step that goes on knows no more than the image of a world that it was loaded from.
        if (s.continuousScratch.resuming) s.solverScratch.startVelocities.Forget();
        own.startVelocities = &s.solverScratch.startVelocities;
        own.rest = {prepareRests, solveRest};
    }
    return SolveContinuous(own, events, {*s.pool, s.bodies, s.fixtures, s.joints, s.contacts, *s.broadPhase},
                           s.continuousScratch);
}

SolverSettings MakeSettings(const WorldState& s, const StepRequest& request) {
    return {.dt = request.dt,
            .impulseScale = s.def.warmStarting ? ImpulseScale(request.dt, s.lastInverseDt) : 0.0f,
            .velocityIterations = request.velocityIterations,
            .positionIterations = request.positionIterations,
            .substeps = request.substeps,
            .gravity = s.def.gravity,
            .maxTranslation = s.def.maxTranslation,
            .maxRotation = s.def.maxRotation,
            .kernels = s.kernels,
            .allowSleep = s.def.allowSleep,
            .exactDrift = s.def.exactDrift,
            .directJoints = s.directJoints,
            .contactHertz = s.def.softStep.contactHertz,
            .contactDampingRatio = s.def.softStep.contactDampingRatio,
            .contactPushSpeed = s.def.softStep.contactPushSpeed * s.def.lengthScale,
            .lengthScale = s.def.lengthScale,
            .tolerance = request.tolerance};
}

StepReport MakeReport(WorldState& s, const StepRequest& request, Stopwatch& watch, StepResults& results) {
    Profile& laps = results.profile;
    laps.step = watch.Stop(laps.broadPhase, laps.narrowPhase, laps.islands, laps.solver, laps.continuous);
    const SolveReport& solved = results.solved;
    const ContinuousReport& continuous = results.continuous;
    StepReport report{.profile = results.profile,
                      .bodyCount = s.bodies.slots.Count(),
                      .awakeBodyCount = solved.awakeCount,
                      .isolatedBodyCount = solved.isolatedCount,
                      .islandCount = solved.islandCount,
                      .contactCount = s.contacts.Count(),
                      .touchingCount = results.touchingCount,
                      .pairCount = static_cast<int64_t>(s.pairs.size()),
                      .cappedCount = solved.counts.capped + continuous.capped,
                      .continuousEventCount = continuous.events,
                      .abandonedCount = continuous.abandoned,
                      .lostTime = continuous.lostTime,
                      .substeps = solved.substeps,
                      .bodySubsteps = solved.bodySubsteps,
                      .nonFiniteCount = solved.counts.nonFinite + continuous.nonFinite,
                      .errors = {}};
    if (request.measureErrors || s.measureErrors) report.errors = MeasureStep(s, request, solved);
    return report;
}

StepReport World::Step(float timeStep, int velocityIterations, int positionIterations) {
    Guard guard(*m_state, "World::Step");
    guard.Unlocked("call Step outside of callbacks").Amount(timeStep, "timeStep");
    guard.Require(velocityIterations >= 0, ErrorCode::outOfRange, "velocityIterations", "give at least 0");
    guard.Require(positionIterations >= 0, ErrorCode::outOfRange, "positionIterations", "give at least 0");
    if (guard.Failed()) return m_state->report;
    const Recording recording = guard.RecordMotion(timeStep, velocityIterations, positionIterations);
    return Run(*this, {timeStep, velocityIterations, positionIterations, 0}, recording);
}

StepReport World::Step(float timeStep, int substeps) {
    Guard guard(*m_state, "World::Step (sub-steps)");
    guard.Unlocked("call Step outside of callbacks").Amount(timeStep, "timeStep");
    guard.Require(substeps >= 1, ErrorCode::outOfRange, "substeps", "give at least 1");
    if (guard.Failed()) return m_state->report;
    const Recording recording = guard.RecordMotion(timeStep, substeps);
    return Run(*this, {timeStep, 0, 0, substeps}, recording);
}

StepReport World::Step(float timeStep, Accuracy accuracy) {
    switch (accuracy) {
        case Accuracy::draft:
            return Step(timeStep, 4, 2);
        case Accuracy::game:
            return Step(timeStep, 4);
        case Accuracy::fine:
            return Step(timeStep, 8);
        case Accuracy::precise:
            return Step(timeStep, 16);
    }
    Guard(*m_state, "World::Step (accuracy)")
        .Require(false, ErrorCode::outOfRange, "accuracy", "give a mark of enum Accuracy");
    return m_state->report;
}

StepReport World::Step(float timeStep, const Tolerance& tolerance) {
    Guard guard(*m_state, "World::Step (tolerance)");
    guard.Unlocked("call Step outside of callbacks").Amount(timeStep, "timeStep");
    guard.Finite(tolerance.overlap, "tolerance.overlap").Finite(tolerance.jointGap, "tolerance.jointGap");
    guard.Require(tolerance.overlap > linearSlop * m_state->def.lengthScale, ErrorCode::outOfRange, "tolerance.overlap",
                  "give more than linearSlop times WorldDef::lengthScale");
    guard.Require(tolerance.jointGap > 0.0f, ErrorCode::outOfRange, "tolerance.jointGap", "give more than 0");
    guard.Require(tolerance.leastSubsteps >= 1, ErrorCode::outOfRange, "tolerance.leastSubsteps", "give at least 1");
    guard.Require(tolerance.mostSubsteps >= tolerance.leastSubsteps, ErrorCode::outOfRange, "tolerance.mostSubsteps",
                  "give at least leastSubsteps");
    if (guard.Failed()) return m_state->report;
    const Recording recording = guard.RecordMotion(timeStep, tolerance);
    return Run(*this, {timeStep, 0, 0, tolerance.leastSubsteps, &tolerance, true}, recording);
}

}  // namespace scree
