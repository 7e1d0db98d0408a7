// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What each feature of our engine costs a scene that does not use it: the scene runs with everything on, and with
// everything but the feature. Features that share a kernel are left out together, since one of them alone keeps it.

#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "testbed/report/page.h"
#include "testbed/report/requirement.h"

namespace testbed {

/// One feature in one scene.
struct AblationRow {
    std::string scene;
    int size = 0;
    std::string feature;
    std::string leftOut;  ///< what was left out with it, itself included, with commas; empty: the scene needs it
    bool hasKernel = false;
    int users = 0;
    VariantCost full, without;  ///< nothing in `without` if the scene needs the feature
};

/// Rows of all features, in the engine's order.
[[nodiscard]] std::vector<AblationRow> MeasureAblation(const scenes::Scene& scene, const RequirementPlan& plan,
                                                       const std::function<void()>& onRepeat = {});
/// Lockstep runs that MeasureAblation makes of a scene, at most, times the plan's repeats.
[[nodiscard]] int CountAblationRuns();

[[nodiscard]] std::string MakeAblationCsv(std::span<const AblationRow> rows);
[[nodiscard]] std::string MakeAblationJson(std::span<const AblationRow> rows);
/// The page of a report: what every scene requires, and the table of ablations.
[[nodiscard]] Page MakeAblationPage(std::span<const Requirement> requirements, std::span<const AblationRow> rows,
                                    const std::string& command);

}  // namespace testbed
