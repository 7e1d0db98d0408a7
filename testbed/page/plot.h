// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Curves over one axis as a picture, in the layout of the dissertation's figures (Tsamis 2020, chapter 8): points
// joined by lines, light grid, Box2D blue, ours red. One plot becomes two files, SVG and PNG.

#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace testbed {

struct PlotPoint {
    double x = 0, y = 0;
    bool isLeast = false;  ///< y is a lower bound: the run was stopped. Drawn within an upward triangle.
};

struct PlotCurve {
    std::string title;
    std::string color;  ///< "#rrggbb"
    int pointType = 7;  ///< gnuplot's number: 7 filled circle, 5 filled square, 9 triangle, 13 diamond
    std::vector<PlotPoint> points;
};

struct Plot {
    std::string title, xLabel, yLabel;
    std::string note;  ///< small print below; empty: none
    std::vector<PlotCurve> curves;
    bool logarithmic = false;  ///< both axes
};

/// The gnuplot program that draws a plot by a terminal, "svg" or "pngcairo".
[[nodiscard]] std::string MakePlotScript(const Plot& plot, const std::string& terminal,
                                         const std::filesystem::path& picture);

/// Draws `stem`.svg and `stem`.png in an existing folder; each replaces a file whole. Throws ToolError.
void DrawPlot(const Plot& plot, const std::filesystem::path& stem);

}  // namespace testbed
