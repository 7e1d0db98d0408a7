// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One scene in one or two engines, stepped in turn so that noise of the machine hits both alike. Captures happen
// between steps, outside every timed part.

#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "testbed/engines/engine_run.h"
#include "testbed/engines/timing.h"

namespace testbed {

/// Whose motion drives the broad phases.
enum class Poses {
    own,    ///< every engine simulates for itself
    scree,  ///< both broad phases follow the motion simulated by ours
    box2d,  ///< both follow Box2D's
};

struct RunSetup {
    std::vector<std::string> engines;  ///< one or two of "scree", "box2d"; scree first
    Poses poses = Poses::own;
    RunOptions options;
};

class SideBySide {
public:
    SideBySide(const scenes::Scene& scene, const RunSetup& setup);

    /// One step in every engine; odd steps begin with the first engine, even ones with the last.
    void Step();
    [[nodiscard]] int GetStep() const { return m_step; }
    [[nodiscard]] std::size_t GetEngineCount() const { return m_runs.size(); }

    /// One snapshot per engine, in the order of the setup.
    [[nodiscard]] std::vector<Snapshot> Capture(const CaptureParts& parts = {});

    /// Times and contacts of every step so far, one series per engine.
    [[nodiscard]] const std::vector<TimingSeries>& GetTiming() const { return m_timing; }

private:
    void StepRun(std::size_t index);

    std::vector<std::unique_ptr<EngineRun>> m_runs;
    std::vector<TimingSeries> m_timing;
    int m_step = 0;
};

}  // namespace testbed
