// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Two builds of this program side by side, before and after a change. Each times the same cases in a process of its
// own, in turns. Every case gets a ratio with an interval and the answer whether both came to the same states.

#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "testbed/page/page.h"

namespace testbed {

/// What both builds are asked for.
struct AgainstPlan {
    std::filesystem::path program;     ///< the other build's
    std::vector<std::string> scenes;   ///< as `bench` takes them, each timed apart
    std::vector<std::string> options;  ///< of `bench`, the same for both
    int rounds = 9;                    ///< of both builds in turn; six and more give an interval of 95 %
};

/// The program in a build folder, or the file itself. Throws UsageError for what is neither.
[[nodiscard]] std::filesystem::path FindBuiltProgram(const std::filesystem::path& given);

/// Where a median lies. With fewer than six values the interval is their whole range, which says less.
struct MedianInterval {
    double low = 0.0, median = 0.0, high = 0.0;
    bool isSure = false;  ///< the true median is inside with a probability of at least 95 %
};
/// From the order of the values alone, whatever their distribution (the sign test turned round; Conover, Practical
/// Nonparametric Statistics, section 3.2). `values` is not empty.
[[nodiscard]] MedianInterval FindMedianInterval(std::span<const double> values);

/// One case in both builds.
struct AgainstRow {
    std::string scene, pane, solver;
    int size = 0, threads = 1;
    bool continuous = false;
    double hereMs = 0.0, thereMs = 0.0;  ///< medians; processor time with one thread, wall time with more
    MedianInterval ratio;                ///< there / here of each round: above 1 this build is faster
    bool sameSteps = false, sameState = false;
};

struct AgainstResult {
    std::vector<AgainstRow> rows;
    std::vector<nlohmann::ordered_json> made;  ///< what both builds say of themselves (engines/provenance.h)
};

/// Runs both. Throws FileError for a program that does not run or whose rows cannot be read, with what it said.
[[nodiscard]] AgainstResult RunAgainst(const AgainstPlan& plan);

/// Whether a case is surely slower than `least` times the other build: its whole interval is below.
[[nodiscard]] bool IsSlower(const AgainstRow& row, double least);

[[nodiscard]] std::string FormatAgainst(const AgainstResult& result);
[[nodiscard]] Page MakeAgainstPage(const AgainstResult& result, const std::string& command);

}  // namespace testbed
