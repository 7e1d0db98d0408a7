// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Curves over one axis as a picture, in the layout of the dissertation's figures (Tsamis 2020, section 3.8 and chapter
// 8): light grid, Box2D blue, ours red. The one place that writes programs for gnuplot.

#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace testbed {

/// Colour and point of a curve; the point is gnuplot's number: 5 filled square, 7 circle, 9 triangle, 13 diamond.
struct PlotLook {
    std::string_view color;  ///< "#rrggbb"
    int pointType = 7;
};
inline constexpr PlotLook boxTwoDLook{"#0000cc", 7};
/// Ours: sequential impulses, then soft steps, more threads after fewer.
inline constexpr PlotLook ourLooks[] = {{"#cc0000", 5}, {"#e67700", 9}, {"#0b7a3b", 13}, {"#8a2be2", 11}};

struct PlotPoint {
    double x = 0, y = 0;
    bool isLeast = false;  ///< y is a lower bound: the run was stopped. Drawn within an upward triangle.
};

enum class PlotStyle { linesAndPoints, lines, points };

struct PlotCurve {
    std::string title;  ///< empty: not in the legend
    PlotLook look;
    std::vector<PlotPoint> points{};
    PlotStyle style = PlotStyle::linesAndPoints;
    double pointSize = 0;               ///< 0: by how many points there are
    std::vector<std::string> labels{};  ///< above each point; empty: none
    std::vector<std::string> names{};   ///< what a page says of each point below the pointer; empty: the curve's title
};

enum class PlotLegend { topLeft, topRight, below };

struct Plot {
    std::string title, xLabel, yLabel;
    std::string note{};  ///< small print below; empty: none
    std::vector<PlotCurve> curves{};
    bool logarithmic = false;  ///< both axes
    bool powersOfTen = false;  ///< what y counts in
    bool small = false;        ///< for many beside each other
    PlotLegend legend = PlotLegend::topLeft;
    double most = 0;  ///< higher points stand above the others with their numbers, out of scale; 0: none
    double roomAbove = 0.08, roomBelow = 0, roomBeside = 0;  ///< free, as shares of what the points take
};

/// Of curves over steps: where the first step, which builds everything, is by far the highest, sets `most` to the rest.
void SpareFirstStep(Plot& plot);

/// The gnuplot program that draws a plot by a terminal, "svg" or "pngcairo".
[[nodiscard]] std::string MakePlotScript(const Plot& plot, std::string_view terminal,
                                         const std::filesystem::path& picture);

/// Draws the file `picture` in an existing folder in place: give a temporary name. An SVG carries MakePlotData within.
/// Throws ToolError.
void DrawPlot(const Plot& plot, std::string_view terminal, const std::filesystem::path& picture);

/// What the plot shows, as JSON: a page makes an interactive figure of it (page/figure.js).
[[nodiscard]] std::string MakePlotData(const Plot& plot);

/// Draws `stem`.svg and `stem`.png; each replaces a file whole. Throws ToolError.
void DrawPlotFiles(const Plot& plot, const std::filesystem::path& stem);

}  // namespace testbed
