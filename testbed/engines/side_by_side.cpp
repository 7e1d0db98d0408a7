// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One scene in one or two engines, stepped in turn.

#include "testbed/engines/side_by_side.h"

#include <string_view>

#include "testbed/engines/poses.h"

namespace testbed {

namespace {

std::unique_ptr<EngineRun> MakeEngine(std::string_view engine, const scenes::Scene& scene, const RunSetup& setup) {
    const bool isScree = engine == "scree";
    if (setup.poses == Poses::own || isScree == (setup.poses == Poses::scree)) {
        return MakeRun(engine, scene, setup.options);
    }
    // The source is a run of its own, not the one shown: simulation is deterministic, so the motion is the same.
    if (isScree) return MakeScreeFollower(scene, setup.options, MakeBox2dRun(scene, setup.options));
    return MakeBox2dFollower(scene, MakeScreeRun(scene, setup.options));
}

}  // namespace

SideBySide::SideBySide(const scenes::Scene& scene, const RunSetup& setup) {
    for (const std::string& engine : setup.engines) {
        m_runs.push_back(MakeEngine(engine, scene, setup));
        m_timing.push_back({engine, {}});
    }
}

void SideBySide::StepRun(std::size_t index) {
    EngineRun& run = *m_runs[index];
    run.Step();
    m_timing[index].steps.push_back({m_step, run.GetTimes(), run.GetContactCount()});
}

void SideBySide::Step() {
    ++m_step;
    const std::size_t count = m_runs.size();
    for (std::size_t i = 0; i < count; ++i) StepRun(m_step % 2 != 0 ? i : count - 1 - i);
}

std::vector<Snapshot> SideBySide::Capture(const CaptureParts& parts) {
    std::vector<Snapshot> snapshots(m_runs.size());
    for (std::size_t i = 0; i < m_runs.size(); ++i) m_runs[i]->Capture(snapshots[i], parts);
    return snapshots;
}

}  // namespace testbed
