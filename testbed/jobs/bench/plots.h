// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The plots of the bench: its rows in, curves out.

#pragma once

#include <span>

#include "testbed/engines/timing.h"
#include "testbed/jobs/bench/row.h"
#include "testbed/page/plot.h"

namespace testbed {

/// Fixtures on x, total ms on y: one curve per engine and setting of the rows of one scene (figures 13–16, 19–31). Runs
/// that were stopped are lower bounds.
[[nodiscard]] Plot MakeTotalsPlot(std::span<const BenchRow> rows);

/// Time over size, both axes logarithmic: moving bodies on x, ns per body and step on y. One curve per scene, engine
/// and setting, for scenes whose sizes lie a factor of ten apart or more. Beside them log n, through the first point of
/// the first curve.
[[nodiscard]] Plot MakeCostPlot(std::span<const BenchRow> rows);

/// Steps on x, ms on y: the broad phase of every step of the case's variants (figures 8 and 10). `timing` belongs to
/// `rows`, one by one.
[[nodiscard]] Plot MakeStepsPlot(std::span<const BenchRow> rows, std::span<const TimingSeries> timing);

}  // namespace testbed
