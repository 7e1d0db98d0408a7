// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Rows of `scree bench` as a table to read: one line per row, printed as soon as its case is done.

#pragma once

#include <span>
#include <string>

#include "testbed/jobs/bench/row.h"

namespace testbed {

/// The two lines above the rows.
[[nodiscard]] std::string FormatBenchHeader();

/// A line per row, then a line per void ratio. "≥" marks a run that was stopped at the time limit.
[[nodiscard]] std::string FormatBenchRows(std::span<const BenchRow> rows);

/// What the columns and the ratio mean: lines below the table.
[[nodiscard]] std::string FormatBenchNotes();

}  // namespace testbed
