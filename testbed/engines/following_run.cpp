// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of following_run.h.

#include "testbed/engines/following_run.h"

#include <algorithm>
#include <utility>

#include "testbed/base/stopwatch.h"

namespace testbed {
namespace {

std::vector<BodyState> TakeBodies(EngineRun& run) {
    Snapshot snapshot;
    run.Capture(snapshot, {.fixtures = false, .contacts = false, .joints = false, .nodes = false});
    return std::move(snapshot.bodies);
}

}  // namespace

void FollowingRun::CreateIn(const BodyState& body) {
    Slots& slots = m_slots[static_cast<size_t>(body.index)];
    slots.begin = slots.end = m_fixtureOf.size();
    for (const scenes::Fixture& fixture : m_scene.FixturesOf(body.index)) {
        slots.end += static_cast<size_t>(fixture.shape.ChildCount());
    }
    m_fixtureOf.resize(slots.end, -1);
    Create(body);
}

void FollowingRun::ListFixtures() {
    std::fill(m_fixtureOf.begin(), m_fixtureOf.end(), -1);
    int next = 0;
    for (const BodyState& body : m_bodies) {
        const Slots slots = SlotsOf(body);
        for (size_t slot = slots.begin; slot < slots.end; ++slot) m_fixtureOf[slot] = next++;
    }
}

void FollowingRun::Load() {
    m_bodies = TakeBodies(*m_source);
    m_slots.resize(m_scene.bodies.size());
    m_heap.Measure([&] {
        for (const BodyState& body : m_bodies) CreateIn(body);
    });
}

void FollowingRun::Step() {
    m_source->Step();
    std::vector<BodyState> now = TakeBodies(*m_source), before, after, made, gone;
    auto old = m_bodies.begin();
    for (const BodyState& body : now) {
        for (; old != m_bodies.end() && old->index < body.index; ++old) gone.push_back(*old);
        if (old == m_bodies.end() || old->index > body.index) {
            made.push_back(body);
            continue;
        }
        before.push_back(*old++);
        after.push_back(body);
    }
    gone.insert(gone.end(), old, m_bodies.end());
    m_heap.Measure([&] {
        for (const BodyState& body : gone) Destroy(body);
        const Stopwatch watch;
        Move(before, after);
        m_times = {};
        m_times.broadPhase = m_times.step = watch.GetMilliseconds();
        for (const BodyState& body : made) CreateIn(body);
    });
    m_bodies = std::move(now);
}

void FollowingRun::Capture(Snapshot& snapshot, const CaptureParts& parts) {
    CaptureParts sourceParts = parts;
    sourceParts.nodes = false;
    m_source->Capture(snapshot, sourceParts);
    snapshot.times = m_times;
    snapshot.memoryBytes = m_heap.GetBytes();
    ListFixtures();
    CaptureBroadPhase(snapshot, parts.nodes);
}

}  // namespace testbed
