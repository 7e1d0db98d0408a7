// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What each feature of our engine costs a scene that does not use it. The scene runs with everything on, and with
// everything but the feature. A kernel that serves several features goes only when all of them are left out, so these
// features have a row together too.

#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "testbed/jobs/requires/requirement.h"
#include "testbed/page/page.h"

namespace testbed {

/// Whether the engine has code that goes with a feature.
enum class FeatureKernel { none, shared, own };

/// One feature, or all features of a shared kernel, in one scene.
struct AblationRow {
    std::string scene;
    int size = 0;
    std::string feature;  ///< several: with commas
    FeatureKernel kernel = FeatureKernel::none;
    int users = 0;              ///< above 0: the scene needs it, and nothing was run
    VariantCost full, without;  ///< of the same repeats

    [[nodiscard]] double GetNsChange() const { return without.nsPerBodyStep - full.nsPerBodyStep; }
    [[nodiscard]] double GetPercent() const { return 100.0 * GetNsChange() / full.nsPerBodyStep; }
    /// Of one body, fixture, contact and joint together.
    [[nodiscard]] long GetBytesChange() const;
};

/// Rows of all features in the engine's order, then of the shared kernels.
[[nodiscard]] std::vector<AblationRow> MeasureAblation(const scenes::Scene& scene, const RequirementTask& task,
                                                       const std::function<void()>& onRepeat = {});
/// Lockstep runs that MeasureAblation makes of a scene, at most, times the task's repeats.
[[nodiscard]] int CountAblationRuns();

[[nodiscard]] std::string MakeAblationCsv(std::span<const AblationRow> rows);
[[nodiscard]] std::string MakeAblationJson(std::span<const AblationRow> rows);
/// What every scene requires; the ablation by feature over all scenes, and, folded, by scene.
[[nodiscard]] PageSection MakeRequirementSection(std::span<const Requirement> requirements);
[[nodiscard]] PageSection MakeAblationSection(std::span<const AblationRow> rows);
[[nodiscard]] PageSection MakeAblationDetails(std::span<const AblationRow> rows);

}  // namespace testbed
