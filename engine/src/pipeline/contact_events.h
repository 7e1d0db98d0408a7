// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Who is asked and told about contacts, and where their distance work is counted; handed to the stages that create,
// update and destroy them.

#pragma once

#include "base/shared_count.h"
#include "pipeline/parts/heard_calls.h"
#include "scree/time_of_impact.h"
#include "scree/world_callbacks.h"

namespace scree {

class EventLog;
struct WorldState;

struct ContactEvents {
    WorldState* state;  ///< only passed on to make handles
    /// The world's, looked up at each use because a callback may change them.
    /// Null listener: nobody is told; null filter: the fixtures' filter data
    /// decide alone.
    ContactListener* const& listener;
    const HeardCalls& heard;  ///< by the listener
    ContactFilter* const& filter;
    MaterialMixer* const& mixer;  ///< null: the standard rule
    EventLog* log;                ///< of World::GetEvents; null: no fixture reports
    TOIStats* work;               ///< distance and time-of-impact work of the step
    /// A contact that begins or ends restarts the sleep timers of bodies that are
    /// awake, too, as in Box2D 2.4. Without it such a contact wakes sleepers
    /// only: one that flickers would keep its island awake for ever.
    bool restartsTimers = true;

    [[nodiscard]] bool HearsBegin() const { return listener != nullptr && heard.begin; }
    [[nodiscard]] bool HearsEnd() const { return listener != nullptr && heard.end; }
    [[nodiscard]] bool HearsPreSolve() const { return listener != nullptr && heard.preSolve; }
    [[nodiscard]] bool HearsPostSolve() const { return listener != nullptr && heard.postSolve; }
};

/// Counts one run of GJK. Sums and a maximum: the same in any order, from any thread.
inline void CountDistance(TOIStats& work, int iterations) {
    AddShared(work.distanceCalls, 1);
    AddShared(work.distanceIterations, iterations);
    RaiseShared(work.maxDistanceIterations, iterations);
}

/// Counts searches for times of impact; the same.
inline void CountSearches(TOIStats& work, const TOIStats& more) {
    AddShared(work.calls, more.calls);
    AddShared(work.iterations, more.iterations);
    RaiseShared(work.maxIterations, more.maxIterations);
    AddShared(work.rootIterations, more.rootIterations);
    RaiseShared(work.maxRootIterations, more.maxRootIterations);
    AddShared(work.distanceCalls, more.distanceCalls);
    AddShared(work.distanceIterations, more.distanceIterations);
    RaiseShared(work.maxDistanceIterations, more.maxDistanceIterations);
}

}  // namespace scree
