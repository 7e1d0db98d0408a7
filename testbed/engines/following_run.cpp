// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of following_run.h.

#include "testbed/engines/following_run.h"

#include "testbed/base/stopwatch.h"

namespace testbed {
namespace {

std::vector<BodyState> TakeBodies(EngineRun& run) {
    Snapshot snapshot;
    run.Capture(snapshot, {.fixtures = false, .contacts = false, .joints = false, .nodes = false});
    return std::move(snapshot.bodies);
}

}  // namespace

void FollowingRun::Load() {
    m_bodies = TakeBodies(*m_source);
    m_heap.Measure([&] {
        for (const BodyState& body : m_bodies) Create(body);
    });
}

void FollowingRun::Step() {
    m_source->Step();
    std::vector<BodyState> after = TakeBodies(*m_source);
    const size_t known = m_bodies.size();
    const std::vector<BodyState> spawned(after.begin() + static_cast<std::ptrdiff_t>(known), after.end());
    after.resize(known);
    m_heap.Measure([&] {
        const Stopwatch watch;
        Move(m_bodies, after);
        m_times = {};
        m_times.broadPhase = m_times.step = watch.GetMilliseconds();
        for (const BodyState& body : spawned) Create(body);
    });
    m_bodies = std::move(after);
    m_bodies.insert(m_bodies.end(), spawned.begin(), spawned.end());
}

void FollowingRun::Capture(Snapshot& snapshot, const CaptureParts& parts) {
    CaptureParts sourceParts = parts;
    sourceParts.nodes = false;
    m_source->Capture(snapshot, sourceParts);
    snapshot.times = m_times;
    snapshot.memoryBytes = m_heap.GetBytes();
    CaptureBroadPhase(snapshot, parts.nodes);
}

}  // namespace testbed
