// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One scene in one or more panes, stepped in turn so that noise of the machine hits all alike. Captures happen
// between steps, outside every timed part.

#pragma once

#include <memory>
#include <span>
#include <vector>

#include "testbed/engines/engine_run.h"
#include "testbed/engines/panes.h"
#include "testbed/engines/timing.h"

namespace testbed {

class SideBySide {
public:
    SideBySide(const RunStart& start, const Panes& panes, const RunNeeds& needs = {});

    /// One step in every pane; odd steps begin with the first pane, even ones with the last.
    void Step();
    /// Of a motion: as it was recorded.
    [[nodiscard]] int GetStep() const { return m_runs.front()->GetStep(); }
    [[nodiscard]] const Panes& GetPanes() const { return m_panes; }

    /// One snapshot per pane, in their order.
    [[nodiscard]] std::vector<Snapshot> Capture(const CaptureParts& parts = {});

    /// Times and contacts of every step so far, one series per pane.
    [[nodiscard]] const std::vector<TimingSeries>& GetTiming() const { return m_timing; }

private:
    void StepRun(std::size_t index);

    Panes m_panes;
    std::vector<std::unique_ptr<EngineRun>> m_runs;
    std::vector<TimingSeries> m_timing;
    int m_steps = 0;  ///< taken
};

}  // namespace testbed
