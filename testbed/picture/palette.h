// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Colours for counts: one table per style and scale, computed without pow so that every machine gets the same bytes.

#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "testbed/picture/image.h"
#include "testbed/picture/theme.h"

namespace testbed {

/// alpha: n layers of one translucent red over dark grey; heat: linear scale; bands: equal steps with hard edges;
/// log: heat over the logarithm of the count.
enum class Style { alpha, heat, bands, log };

/// "alpha", "heat", "bands" or "log"; throws std::invalid_argument naming them for anything else.
[[nodiscard]] Style ParseStyle(std::string_view text);
[[nodiscard]] const char* GetStyleName(Style style);

/// Where no node is, in every style of the dark theme: the dissertation's dark grey.
inline constexpr Color backgroundColor{51, 51, 51, 255};

/// Of one layer in the style alpha: the dissertation's.
inline constexpr double usualOpacity = 0.04;

/// Colours of counts 0…scaleMax (size scaleMax + 1, at least 2 entries); larger counts take the last colour.
/// alpha: background·(1 − a)^n + red·(1 − (1 − a)^n).
[[nodiscard]] std::vector<Color> MakePalette(Style style, double opacity, uint32_t scaleMax, Theme theme = Theme::dark);

/// Where a count lies on a colour bar of this style, 0…1: the count's share of scaleMax, for log that of the
/// logarithms.
[[nodiscard]] double GetScalePosition(Style style, double count, uint32_t scaleMax);

/// Colour of a signed difference: blue below 0, background at 0, red above; |value| ≥ scaleMax takes the end colour.
[[nodiscard]] Color GetDifferenceColor(int64_t value, int64_t scaleMax, Theme theme = Theme::dark);

/// Counts through a table.
[[nodiscard]] Image ColorCounts(const CountImage& counts, const std::vector<Color>& palette);

/// first − second, coloured; both of one size, else std::invalid_argument.
[[nodiscard]] Image ColorDifference(const CountImage& first, const CountImage& second, int64_t scaleMax,
                                    Theme theme = Theme::dark);

}  // namespace testbed
