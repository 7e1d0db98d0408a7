// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Where parts of our engine begin to pay: the same world with a part on and off, over the share of the bodies that it
// is made for.

#pragma once

#include <functional>
#include <string>
#include <vector>

namespace testbed {

struct BreakEvenPoint {
    double share = 0;  ///< 0 … 1
    double nsWithout = 0, nsWith = 0;
};

/// Where the part begins to pay for good, by linear interpolation: "pays above a share of 0.18; saves 7 % at 0.50".
[[nodiscard]] std::string DescribeBreakEven(const std::vector<BreakEvenPoint>& points);

struct BreakEvenPlan {
    int movers = 6000;
    int steps = 40;
    int repeats = 9;
    std::vector<double> shares;
};

/// Where static circles lie: among the moving ones, or on a field of their own beside them.
enum class StaticLayout { scattered, beside };

/// Broad phase, ns a mover and step: static circles as a share of all, others drift; in one tree with them (without),
/// or in a tree of their own (with).
[[nodiscard]] std::vector<BreakEvenPoint> MeasureStaticShare(const BreakEvenPlan& plan, StaticLayout layout,
                                                             const std::function<void()>& onPoint = {});
/// Cost of continuous collision: the whole step, ns a mover, with it off (without) and on (with). A share of the
/// circles crosses more than its diameter in a step, above a row of static boxes.
[[nodiscard]] std::vector<BreakEvenPoint> MeasureFastShare(const BreakEvenPlan& plan,
                                                           const std::function<void()>& onPoint = {});
/// Cost of bodies that nothing touches: islands and solver, ns a mover. A share of the circles falls freely, each of
/// the others lies on the ground. Free ones go through the solver like the others (without), or are integrated apart
/// from it (with). With `substeps` of the soft step; 0: sequential impulses.
[[nodiscard]] std::vector<BreakEvenPoint> MeasureIsolatedShare(const BreakEvenPlan& plan, int substeps,
                                                               const std::function<void()>& onPoint = {});

}  // namespace testbed
