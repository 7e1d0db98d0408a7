// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The measured trade for readers: a table, plots of error against cost, and a page with what they come to.

#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "testbed/jobs/tradeoff/verdict.h"
#include "testbed/page/page.h"
#include "testbed/page/plot.h"

namespace testbed {

/// One row per law, setting and error.
[[nodiscard]] std::string MakeTradeCsv(std::span<const TradeCase> cases);
/// One row per error with its bounds and what the dial's marks reach.
[[nodiscard]] std::string MakeBoundsCsv(std::span<const TradeCase> cases);

/// One law's first error against cost: all settings as points, each family's front as a line, defaults marked and
/// named.
[[nodiscard]] Plot MakeTradePlot(const Law& law, std::span<const TradeCase> cases);

/// `plots` holds <law>.svg for every law of the cases.
[[nodiscard]] Page MakeTradePage(std::span<const TradeCase> cases, const std::filesystem::path& plots,
                                 const std::string& command);

/// What the console shows: headline, lost laws, missed bounds.
[[nodiscard]] std::string FormatTrade(std::span<const TradeCase> cases);

}  // namespace testbed
