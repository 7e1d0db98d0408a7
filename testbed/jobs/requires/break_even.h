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
/// Continuous stage and whole step, ns a mover: a share of the circles crosses more than its diameter in a step, above
/// a row of static boxes; continuous collision off (without) and on (with).
[[nodiscard]] std::vector<BreakEvenPoint> MeasureFastShare(const BreakEvenPlan& plan,
                                                           const std::function<void()>& onPoint = {});
/// Islands and solver, ns a mover: a share of the circles falls freely, each of the others lies on the ground; bodies
/// that nothing touches go through the solver like the others (without), or are integrated apart from it (with). By
/// sequential impulses, or by the soft step with so many sub-steps.
[[nodiscard]] std::vector<BreakEvenPoint> MeasureIsolatedShare(const BreakEvenPlan& plan, int substeps,
                                                               const std::function<void()>& onPoint = {});

}  // namespace testbed
