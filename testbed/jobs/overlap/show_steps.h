// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Runs a scene and hands over the snapshots of the steps that were asked for: one, a range, or the worst ones.

#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "testbed/base/progress.h"
#include "testbed/engines/side_by_side.h"
#include "testbed/options/options.h"

namespace testbed {

enum class WorstBy { time, overlap };

/// Which steps of a scene to show, checked.
struct StepSelection {
    StepRange range;
    int worst = 0;  ///< > 0: only that many of the range, by `worstBy`
    WorstBy worstBy = WorstBy::time;

    /// Number of steps that will be shown.
    [[nodiscard]] int Count() const;
};

/// Largest K of --worst: the snapshots of the K worst steps stay in memory to the end.
inline constexpr int maxWorst = 20;

/// The default is the scene's showStep; --worst without --steps searches its full run. Throws UsageError.
[[nodiscard]] StepSelection SelectSteps(const StepArguments& arguments, const SceneInput& input);

[[nodiscard]] StepRange FullRun(const SceneInput& input);
/// UsageError unless a run can come to all of these steps: a motion ends somewhere.
void CheckSteps(const StepRange& range, const SceneInput& input);

/// A scene to run, checked.
struct SceneJob {
    SceneInput input;
    StepSelection selection;
};

/// One job per name or file, each scene once. Throws UsageError for none, an unknown name, or an illegal size or step;
/// FileError for a file that cannot be read.
[[nodiscard]] std::vector<SceneJob> MakeJobs(const std::vector<std::string>& names, const SceneArguments& run,
                                             const StepArguments& steps);

/// The folder of a step's pictures: <scene>/step-<NNNN>.
[[nodiscard]] std::filesystem::path StepFolder(const Snapshot& snapshot);

/// The work of showing one step, in units of one step of all engines: what a progress bar should expect.
inline constexpr double workPerPicture = 5;

/// Gives the snapshots of every selected step to `visit`, in the order of the steps.
using StepVisits = std::function<void(const std::function<void(std::span<const Snapshot>)>& visit)>;

/// Steps until the last selected step and at least `runTo`, and calls `show` with one snapshot per engine for every
/// selected step, in the order of the steps. Advances `progress` by 1 per step and workPerPicture per call. The worst
/// steps are known at the end: `prepare`, if any, sees all of them before they are shown.
void ShowSteps(SideBySide& engines, const StepSelection& selection, int runTo, Progress& progress,
               const std::function<void(std::span<const Snapshot>)>& show,
               const std::function<void(const StepVisits&)>& prepare = {});

}  // namespace testbed
