// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Broad-phase time by step as a picture, drawn by gnuplot in the layout of the dissertation's figures 8 and 10 (Tsamis
// 2020, section 3.8): steps on x, ms on y, Box2D as blue circles, ours as red squares, light grid, legend top right.

#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "testbed/engines/timing.h"

namespace testbed {

/// The gnuplot program that draws `series` into the file `picture`.
[[nodiscard]] std::string MakeTimingScript(std::span<const TimingSeries> series, const std::string& title,
                                           const std::filesystem::path& picture);

/// Draws the PNG at `picture` (not renamed: give a temporary name). Throws ToolError with gnuplot's own words.
void DrawTimingPlot(std::span<const TimingSeries> series, const std::string& title,
                    const std::filesystem::path& picture);

}  // namespace testbed
