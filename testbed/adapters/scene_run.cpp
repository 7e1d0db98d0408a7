// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of scene_run.h.

#include "testbed/adapters/scene_run.h"

#include <algorithm>

#include "testbed/adapters/state_hash.h"

namespace testbed {

void SceneRun::Load() {
    CreateBodiesUpTo(m_scene.InitialBodyCount());
    for (const scenes::Joint& joint : m_scene.joints) CreateJoint(joint);
}

bool SceneRun::HasConveyor() const {
    return std::ranges::any_of(m_scene.fixtures, [](const scenes::Fixture& f) { return f.tangentSpeed != 0.0f; });
}

void SceneRun::CreateBodiesUpTo(int count) {
    for (; m_bodyCount < count; ++m_bodyCount) {
        const scenes::Body& body = m_scene.bodies[static_cast<size_t>(m_bodyCount)];
        m_newFixtures |= body.fixtureCount > 0;
        CreateBody(body);
    }
}

void SceneRun::Step() {
    m_heap.Measure([&] {
        const CpuStopwatch watch;
        m_times = StepEngine(m_newFixtures);
        m_times.cpu = watch.GetMilliseconds();
    });
    m_newFixtures = false;
    ++m_step;
    int due = m_bodyCount;
    while (m_spawnCount < m_scene.spawns.size() && m_scene.spawns[m_spawnCount].afterStep <= m_step) {
        due = m_scene.spawns[m_spawnCount++].body + 1;
    }
    if (due > m_bodyCount) Create([&] { CreateBodiesUpTo(due); });
}

void SceneRun::Capture(Snapshot& snapshot, const CaptureParts& parts) {
    snapshot.scene = m_scene.name;
    snapshot.size = m_scene.size;
    snapshot.step = m_step;
    snapshot.times = m_times;
    snapshot.memoryBytes = m_heap.GetBytes();
    CaptureHeader(snapshot);
    snapshot.bodies.clear();
    snapshot.bodies.reserve(static_cast<size_t>(m_bodyCount));
    CaptureBodies(snapshot.bodies);
    snapshot.stateHash = HashState(snapshot.bodies);
    snapshot.fixtures.clear();
    snapshot.contacts.clear();
    snapshot.joints.clear();
    snapshot.nodes.clear();
    snapshot.treeHeight = 0;
    snapshot.leafSize = 0;
    CaptureRest(snapshot, parts);
}

}  // namespace testbed
