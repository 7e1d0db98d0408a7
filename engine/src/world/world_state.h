// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Everything a world owns. Only world/ sees it whole; the stages get the tables they need.

#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "base/task_pool.h"
#include "broad_phase/broad_phase.h"
#include "pipeline/continuous.h"
#include "pipeline/find_pairs.h"
#include "pipeline/narrow_phase.h"
#include "pipeline/solve.h"
#include "scree/world.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/edited_proxies.h"
#include "state/event_log.h"
#include "state/fixtures.h"
#include "state/islands.h"
#include "state/joints.h"
#include "world/feature_counts.h"

namespace scree {

class Recorder;

/// Rows of handles.
inline BodyIndex IndexOf(const Body& body) { return BodyIndex{body.GetIndex()}; }
inline FixtureIndex IndexOf(const Fixture& fixture) { return FixtureIndex{fixture.GetIndex()}; }
inline JointIndex IndexOf(const Joint& joint) { return JointIndex{joint.GetIndex()}; }

/// Which calls that make, change or destroy objects a world has behind it: with an equal number its definitions are the
/// same, and only what moves may differ.
class DefinitionStamp {
public:
    void Note() { m_now = ++m_newest; }
    [[nodiscard]] uint64_t Get() const { return m_now; }
    /// The definitions are those that had this stamp.
    void Return(uint64_t stamp) { m_now = stamp; }
    /// From now on a program may change definitions without a call.
    void Lose() { m_isKnown = false; }
    [[nodiscard]] bool IsKnown() const { return m_isKnown; }

private:
    uint64_t m_now = 0, m_newest = 0;
    bool m_isKnown = true;
};

struct WorldState {
    static constexpr int notIdle = -1;

    World* world = nullptr;
    WorldDef def;
    BodyTable bodies;
    FixtureTable fixtures;
    ContactTable contacts;
    JointTable joints;

    std::unique_ptr<BroadPhase> broadPhase;
    BroadPhaseKind broadPhaseKind = BroadPhaseKind::automatic;  ///< resolved
    std::unique_ptr<TaskPool> pool;
    std::vector<Pair> pairs, editedPairs;  ///< of the last pair findings
    bool isEdited = false;                 ///< contacts must be found or freed before the coming step
    EditedProxies edited;                  ///< of what: in a restored world of all

    IslandTable islands;          ///< of the last step; the soft step may do without
    IslandTable active;           ///< of the last soft step: what was solved, without islands
    SubstepGroups substepGroups;  ///< of the last step if it had a tolerance
    NarrowPhaseScratch narrowPhaseScratch;
    IslandScratch islandScratch;
    SolverScratch solverScratch;
    ContinuousScratch continuousScratch;
    RestScratches restScratches;  ///< of the same stage

    EventLog log{fixtures};

    DestructionListener* destructionListener = nullptr;
    ContactListener* listener = nullptr;
    HeardCalls heard;                 ///< by the listener
    ContactFilter* filter = nullptr;  ///< null: filter data decide
    MaterialMixer* mixer = nullptr;   ///< null: the standard rule
    ErrorHandler errorHandler = nullptr;
    void* errorContext = nullptr;
    Draw* draw = nullptr;
    Recorder* recorder = nullptr;

    mutable DefinitionStamp definitions;
    FeatureCounts featureCounts;
    KernelSet kernels{};  ///< of the last step; a callback may add to it

    /// Callbacks that are running: nothing may be created, destroyed or moved. Queries of several threads count too.
    mutable std::atomic<int> locks{0};
    bool autoClearForces = true;
    float lastInverseDt = 0.0f;
    int idleSubsteps = notIdle;  ///< of the last step if it had nothing to solve: its lists and scratch are empty
    StepReport report;
    TOIStats distanceWork;  ///< of the last step
    bool measureErrors = false;
    IsolatedPath isolatedPath = IsolatedPath::apart;  ///< changes no bit
    bool directJoints = true;                         ///< inspect::SetDirectJoints

    [[nodiscard]] ContactEvents Events(bool restartsTimers = true) {
        const bool someReport = featureCounts.users[static_cast<size_t>(Feature::events)] > 0;
        return {this, listener, heard, filter, mixer, someReport ? &log : nullptr, &distanceWork, restartsTimers};
    }
    [[nodiscard]] SolveLists Lists() { return {islands, active, substepGroups}; }
    [[nodiscard]] PairTables ForPairs() {
        return {*pool, bodies, fixtures, joints, contacts, *broadPhase, pairs, editedPairs};
    }
    /// A coordinate beyond it makes positions have rests, m.
    [[nodiscard]] float FarDistance() const { return def.farDistance * def.lengthScale; }
    [[nodiscard]] bool IsLocked() const { return locks.load(std::memory_order_relaxed) > 0; }
    /// A contact's manifold at the present poses; without points nothing is written.
    void PlaceManifold(ContactIndex contact, WorldManifold& placed) const;
    /// The pool that `def` asks for, in place of the one there was.
    void MakePool();
    /// Tells the error handler and gives the code back.
    ErrorCode Refuse(ErrorCode code, const char* function, const char* field, const char* cure) const;
};

}  // namespace scree
