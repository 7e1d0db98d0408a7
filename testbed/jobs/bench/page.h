// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The report of `scree bench` as one page: key figures, the table of all rows, the targets, the plots.

#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "testbed/jobs/bench/row.h"
#include "testbed/jobs/bench/targets.h"
#include "testbed/page/page.h"

namespace testbed {

struct BenchReport {
    std::string command;
    std::span<const BenchRow> rows;
    std::span<const TargetResult> targets;         ///< empty: none were judged
    std::vector<std::filesystem::path> plots;      ///< SVG files
    std::string notes;                             ///< what the columns mean, bytes per object
    std::span<const nlohmann::ordered_json> made;  ///< where the rows come from (engines/provenance.h)
};

[[nodiscard]] Page MakeBenchPage(const BenchReport& report);

}  // namespace testbed
