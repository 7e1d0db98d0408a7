// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One step, as a table of contents of the pipeline.

#include <algorithm>

#include "base/clock.h"
#include "pipeline/continuous.h"
#include "pipeline/find_islands.h"
#include "pipeline/group_substeps.h"
#include "pipeline/match_contacts.h"
#include "pipeline/measure_errors.h"
#include "pipeline/narrow_phase.h"
#include "pipeline/solve_islands.h"
#include "pipeline/solve_soft.h"
#include "pipeline/update_boxes.h"
#include "scree/inspect.h"
#include "state/limits.h"
#include "world/guard.h"
#include "world/refresh.h"
#include "world/world_state.h"

namespace scree {

namespace {

/// Boxes of everything that moved, then pairs and contacts of the new poses.
void RunBroadPhase(WorldState& s) {
    const float farthest =
        UpdateMovedBoxes(s.bodies, s.fixtures,
                         {&s.active.isolated, &s.active.bodies, &s.islands.isolated, &s.islands.bodies}, *s.broadPhase);
    if (IsFar(s, farthest)) s.bodies.EnsureRests();
    FindPairsAndMatch(s, FreshOrder::newestFirst);
}

/// Number of sub-steps that stands for this many velocity iterations, and the other way round.
constexpr int minSubsteps = 4;
int SubstepsFor(int velocityIterations) { return std::max(minSubsteps, (velocityIterations + 1) / 2); }

/// As one of the two Steps was asked: `substeps` is 0 for sequential impulses.
struct StepRequest {
    float dt;
    int velocityIterations, positionIterations;
    int substeps;
    const Tolerance* tolerance = nullptr;  ///< if given, islands may take more than `substeps`
};

/// The request as WorldDef::solver wants it.
StepRequest Resolve(const WorldState& s, StepRequest request) {
    if (s.def.solver == SolverKind::softStep && request.substeps == 0) {
        request.substeps = SubstepsFor(request.velocityIterations);
    } else if (s.def.solver == SolverKind::sequentialImpulses && request.substeps > 0) {
        request = {request.dt, 2 * request.substeps, std::max(1, 3 * request.substeps / 4), 0};
    }
    return request;
}

/// By how much the impulses of the last step are to be scaled for this one; 0: they are of no use for it.
float ImpulseScale(float dt, float lastInverseDt) {
    const float ratio = dt * lastInverseDt;
    return ratio <= mostStepRatio ? ratio : 0.0f;
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
            .contactHertzRatio = s.def.softStep.contactHertzRatio,
            .contactDampingRatio = s.def.softStep.contactDampingRatio,
            .contactPushSpeed = s.def.softStep.contactPushSpeed * s.def.lengthScale,
            .lengthScale = s.def.lengthScale};
}

void RunContinuous(WorldState& s, const SolverSettings& settings, StepReport& report) {
    std::span<const int> ballistic;
    if (settings.substeps > 0) {
        ballistic = s.active.isolated;
    } else if (settings.exactDrift) {
        ballistic = s.islands.isolated;
    }
    const int iterations = settings.substeps > 0 ? 2 * report.substeps : settings.velocityIterations;
    const ContinuousReport done =
        SolveContinuous({settings.dt, iterations, settings.maxTranslation, settings.maxRotation, s.def.subStepping,
                         settings.lengthScale, settings.gravity, ballistic},
                        s.Events(), {s.bodies, s.fixtures, s.joints, s.contacts, *s.broadPhase}, s.continuousScratch);
    report.continuousEventCount = done.events;
    report.abandonedCount = done.abandoned;
    report.lostTime = done.lostTime;
    report.cappedCount += done.capped;
    report.nonFiniteCount += done.nonFinite;
}

/// A step that goes on with the rest of the last one has its events to finish.
bool NeedsContinuous(WorldState& s) {
    s.kernels.continuous = NeededKernels(s).continuous;  // a listener may have made a bullet
    return s.kernels.continuous || (s.def.continuousPhysics && s.continuousScratch.resuming);
}

SolverCounts RunSequentialImpulses(WorldState& s, const SolverSettings& settings, Stopwatch& watch,
                                   StepReport& report) {
    s.active.Clear();
    if (s.solverScratch.anglesHaveRests) {
        for (const int body : s.bodies.movers) s.bodies.position[static_cast<size_t>(body)].aRest = 0.0f;
        s.solverScratch.anglesHaveRests = false;
    }
    FindIslands(s.contacts, s.joints, s.bodies, s.islandScratch, s.islands, s.isolated);
    report.profile.islands = watch.Lap();
    return SolveIslands(settings, s.fixtures, s.islands, s.Events(), {*s.pool, s.bodies, s.contacts, s.joints},
                        s.solverScratch);
}

/// Islands are only looked for when something may fall asleep or wake, or when each has its own number of sub-steps.
SolverCounts RunSoftStep(WorldState& s, const SolverSettings& settings, const Tolerance* tolerance, Stopwatch& watch,
                         StepReport& report) {
    s.islands.Clear();
    s.solverScratch.anglesHaveRests = true;
    if (tolerance != nullptr || NeedsIslands(s.contacts, s.joints, s.bodies, settings.dt)) {
        FindIslands(s.contacts, s.joints, s.bodies, s.islandScratch, s.islands, s.isolated);
    }
    GatherActive(s.contacts, s.joints, s.bodies, s.islandScratch, s.active, s.isolated);
    const auto solve = [&](const SolverSettings& own, const IslandTable& lists) {
        report.substeps = own.substeps;  // groups come with rising numbers
        report.bodySubsteps += static_cast<int64_t>(lists.bodies.size() + lists.isolated.size()) * own.substeps;
        return SolveSoft(own, s.fixtures, lists, s.Events(),
                         {*s.pool, s.bodies, s.contacts, s.joints, tolerance != nullptr}, s.solverScratch);
    };
    SolverCounts counts;
    if (tolerance == nullptr) {
        report.profile.islands = watch.Lap();
        counts = solve(settings, s.active);
    } else {
        GroupBySubsteps({s.islands, s.active, s.contacts, s.joints, *tolerance, settings.Slop(), settings.dt}, s.bodies,
                        s.substepGroups);
        report.profile.islands = watch.Lap();
        for (const SubstepGroup& group : s.substepGroups.Get()) {
            SolverSettings own = settings;
            own.substeps = group.substeps;
            counts += solve(own, group.lists);
        }
    }
    SleepIslands(settings, s.active, s.islands, s.bodies);
    return counts;
}

void SolveWholeStep(WorldState& s, const SolverSettings& settings, const Tolerance* tolerance, Stopwatch& watch,
                    StepReport& report) {
    s.substepGroups.Clear();
    const SolverCounts counts = settings.substeps > 0 ? RunSoftStep(s, settings, tolerance, watch, report)
                                                      : RunSequentialImpulses(s, settings, watch, report);
    report.profile.solver = watch.Lap();
    report.cappedCount = counts.capped;
    report.nonFiniteCount = counts.nonFinite;
    const IslandTable& solved = settings.substeps > 0 ? s.active : s.islands;
    report.isolatedBodyCount = static_cast<int>(solved.isolated.size());
    report.islandCount = static_cast<int>(s.islands.islands.size());
    report.awakeBodyCount = report.isolatedBodyCount + static_cast<int>(solved.bodies.size());
}

/// What is not finite would come back by warm starting.
void ForgetNonFiniteImpulses(ContactTable& contacts) {
    for (Manifold& m : contacts.manifold) {
        for (ManifoldPoint& point : m.points) {
            if (!std::isfinite(point.normalImpulse)) point.normalImpulse = 0.0f;
            if (!std::isfinite(point.tangentImpulse)) point.tangentImpulse = 0.0f;
        }
    }
}

void Simulate(WorldState& s, const SolverSettings& settings, const Tolerance* tolerance, Stopwatch& watch,
              StepReport& report) {
    // With sub-stepping a step may end after an event; this one then only goes on with the rest.
    if (!s.continuousScratch.resuming) SolveWholeStep(s, settings, tolerance, watch, report);
    if (NeedsContinuous(s)) RunContinuous(s, settings, report);
    report.profile.continuous = watch.Lap();
    if (report.nonFiniteCount > 0) ForgetNonFiniteImpulses(s.contacts);
    RunBroadPhase(s);
    report.profile.broadPhase += watch.Lap();
    s.lastInverseDt = 1.0f / settings.dt;
}

/// Whether the step has enough that is worth sharing: few bodies without contacts are done before workers wake.
bool HasWorkToShare(const WorldState& s) {
    constexpr int leastContacts = 128;
    const size_t movers = s.bodies.movers.size();
    return movers >= leastBoxesToShare || (movers >= leastBodies && s.contacts.Count() >= leastContacts);
}

/// Keeps the workers awake for the rest of a step that has work for them.
class PoolRegion {
public:
    explicit PoolRegion(WorldState& s) : m_pool(HasWorkToShare(s) ? s.pool.get() : nullptr) {
        if (m_pool != nullptr) m_pool->Begin();
    }
    ~PoolRegion() {
        if (m_pool != nullptr) m_pool->End();
    }
    PoolRegion(const PoolRegion&) = delete;
    PoolRegion& operator=(const PoolRegion&) = delete;

private:
    TaskPool* m_pool;
};

/// As World::MeasureErrors, and for the bodies' demands.
StepErrors NoteDemand(WorldState& s) {
    return MeasureDemand({s.bodies, s.fixtures, s.contacts, s.joints}, linearSlop * s.def.lengthScale,
                         1.0f / s.lastInverseDt, s.bodies.demand);
}

StepReport Run(World& world, const StepRequest& asked, const Recording& recording) {
    WorldState& s = world.GetState();
    const StepRequest request = Resolve(s, asked);
    Stopwatch total;
    Stopwatch watch;
    StepReport report;
    report.substeps = request.substeps;
    s.distanceWork = {};
    const WorldLock lock(s);
    if (s.pairsStale) FindPairsAndMatch(s, FreshOrder::oldestFirst);
    report.profile.broadPhase = watch.Lap();
    const PoolRegion region(s);
    report.touchingCount =
        UpdateManifolds(s.Events(), {*s.pool, s.bodies, s.fixtures, s.joints, s.contacts}, s.narrowPhaseScratch);
    report.profile.narrowPhase = watch.Lap();
    s.kernels = NeededKernels(s);  // the listener has had its say about contacts
    if (s.kernels.bodyForces) s.bodies.EnsureForces();
    if (s.def.exactDrift) s.bodies.startVelocity.resize(s.bodies.velocity.size());
    if (request.dt >= shortestStep) Simulate(s, MakeSettings(s, request), request.tolerance, watch, report);
    if (s.autoClearForces) world.ClearForces();

    report.bodyCount = s.bodies.slots.Count();
    report.contactCount = s.contacts.Count();
    report.pairCount = static_cast<int64_t>(s.pairs.size());
    report.profile.step = total.Lap();
    if (asked.tolerance != nullptr || s.measureErrors) {
        const bool solved = report.bodySubsteps > 0;
        report.errors = request.tolerance != nullptr && solved ? NoteDemand(s) : world.MeasureErrors();
    }
    s.report = report;
    if (recording.IsOn()) recording.NoteHash(inspect::GetStateHash(world));
    return report;
}

}  // namespace

StepReport World::Step(float timeStep, int velocityIterations, int positionIterations) {
    Guard guard(*m_state, "World::Step");
    guard.Unlocked("call Step outside of callbacks").Amount(timeStep, "timeStep");
    guard.Require(velocityIterations >= 0, ErrorCode::outOfRange, "velocityIterations", "give at least 0");
    guard.Require(positionIterations >= 0, ErrorCode::outOfRange, "positionIterations", "give at least 0");
    if (guard.Failed()) return m_state->report;
    const Recording recording = guard.Record(timeStep, velocityIterations, positionIterations);
    return Run(*this, {timeStep, velocityIterations, positionIterations, 0}, recording);
}

StepReport World::Step(float timeStep, int substeps) {
    Guard guard(*m_state, "World::Step (sub-steps)");
    guard.Unlocked("call Step outside of callbacks").Amount(timeStep, "timeStep");
    guard.Require(substeps >= 1, ErrorCode::outOfRange, "substeps", "give at least 1");
    if (guard.Failed()) return m_state->report;
    const Recording recording = guard.Record(timeStep, substeps);
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
    const Recording recording = guard.Record(timeStep, tolerance);
    return Run(*this, {timeStep, 0, 0, tolerance.leastSubsteps, &tolerance}, recording);
}

}  // namespace scree
