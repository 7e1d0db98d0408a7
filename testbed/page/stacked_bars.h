// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Sums beside each other with what they consist of: horizontal bars of coloured parts over one numbered axis, as an SVG
// document. A part has its number where that fits.

#pragma once

#include <string>
#include <vector>

namespace testbed {

struct StackedBar {
    std::string label;
    std::vector<double> parts;  ///< in the order of StackedBars::parts, each ≥ 0
    bool isLeast = false;       ///< the run was stopped: the sum is a lower bound
};

struct StackedBars {
    std::string unit;                ///< "ms"
    std::vector<std::string> parts;  ///< names, at most six
    std::vector<StackedBar> bars;    ///< from top to bottom
};

/// All texts have room of their own; a longer label makes the picture's left part wider.
[[nodiscard]] std::string DrawStackedBars(const StackedBars& bars);

}  // namespace testbed
