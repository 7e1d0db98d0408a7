// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One scene in one or more panes, stepped in turn.

#include "testbed/engines/side_by_side.h"

namespace testbed {

SideBySide::SideBySide(const RunStart& start, const Panes& panes, const RunNeeds& needs) : m_panes(panes) {
    for (const Pane& pane : panes.panes) {
        if (start.motion != nullptr) {
            m_runs.push_back(MakeFollower(start, pane.spec));
        } else if (panes.source) {
            // A source is a run of its own, not the one shown: simulation is deterministic, so the motion is the same.
            m_runs.push_back(MakeFollower(start, pane.spec, *panes.source, needs));
        } else {
            m_runs.push_back(MakeRun(start, pane.spec, needs));
        }
        m_timing.push_back({pane.name, pane.spec.engine, {}});
    }
}

void SideBySide::StepRun(std::size_t index) {
    EngineRun& run = *m_runs[index];
    run.Step();
    m_timing[index].steps.push_back({run.GetStep(), run.GetTimes(), run.GetContactCount()});
}

void SideBySide::Step() {
    ++m_steps;
    const std::size_t count = m_runs.size();
    for (std::size_t i = 0; i < count; ++i) StepRun(m_steps % 2 != 0 ? i : count - 1 - i);
}

std::vector<Snapshot> SideBySide::Capture(const CaptureParts& parts) {
    std::vector<Snapshot> snapshots(m_runs.size());
    for (std::size_t i = 0; i < m_runs.size(); ++i) {
        m_runs[i]->Capture(snapshots[i], parts);
        snapshots[i].pane = m_panes.panes[i].name;
        snapshots[i].settings = PrintSettings(m_panes.panes[i].spec);
    }
    return snapshots;
}

}  // namespace testbed
