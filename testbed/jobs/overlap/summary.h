// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The short table printed at the end of a run: tree, contacts and broad-phase times of all panes, and the ratios of the
// baseline to the others.

#pragma once

#include <span>
#include <string>
#include <vector>

#include "testbed/engines/panes.h"
#include "testbed/engines/timing.h"
#include "testbed/jobs/overlap/metrics.h"
#include "testbed/page/page.h"

namespace testbed {

struct RunSummary {
    std::string scene;
    int size = 0;
    std::vector<TimingSeries> timing;  ///< one per pane
    std::vector<MetricsRow> rows;      ///< of the shown steps, all panes; may be empty
    std::size_t baseline = 0;          ///< index of the series that the others are compared with
};

/// The steps over which the claim of the dissertation (section 3.8, Tiles) is summed.
inline constexpr int claimFirstStep = 70, claimLastStep = 100;

/// Lines of text, each ended by a newline. Where several steps were shown, tree figures are the largest of them.
[[nodiscard]] std::string FormatSummary(const RunSummary& summary);

/// The same as a section of a page.
[[nodiscard]] PageSection MakeSummarySection(const RunSummary& summary, const Panes& panes);
/// The page of such sections, with the command, the machine and the commit.
[[nodiscard]] Page MakeSummaryPage(std::vector<PageSection> sections, const std::string& command);

/// "settings: scree preset=like-box2d; box2d preset=like-box2d", a line.
[[nodiscard]] std::string FormatSettings(const Panes& panes);

}  // namespace testbed
