// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The extremes for readers: a matrix of grades, case by setting, the reasons, and pictures of the worst moments.

#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "testbed/jobs/extremes/outcome.h"
#include "testbed/page/page.h"

namespace testbed {

/// A case under a setting.
struct ExtremeResult {
    std::string name;     ///< of the case
    std::string setting;  ///< "scree 8/3"
    Ending ending;
    Outcome outcome;
    CaseGrade verdict;
};

[[nodiscard]] nlohmann::ordered_json ToJson(const ExtremeResult& result);
/// Throws FileError; the grade is found anew.
[[nodiscard]] ExtremeResult ExtremeResultFromJson(const nlohmann::ordered_json& fields);

[[nodiscard]] std::string MakeExtremesCsv(std::span<const ExtremeResult> results);
/// `pictures`: SVG by "case/setting".
[[nodiscard]] Page MakeExtremesPage(std::span<const ExtremeResult> results,
                                    const std::map<std::string, std::string>& pictures, const std::string& command);
/// Grades by setting, and every case of ours below 3 with its reasons.
[[nodiscard]] std::string FormatExtremes(std::span<const ExtremeResult> results);

}  // namespace testbed
