// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of plot.h.

#include "testbed/page/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "testbed/page/gnuplot.h"

namespace testbed {

namespace fs = std::filesystem;

std::string MakePlotScript(const Plot& plot, const std::string& terminal, const fs::path& picture) {
    std::string script = fmt::format(
        "set terminal {} size 1100,640 font 'DejaVu Sans,12' background '#ffffff'\n"
        "set output {}\nset border 31 linecolor '#000000'\nset grid linecolor '#cccccc' linetype 1\n"
        "set key top left opaque box width 1\nset offsets 0, 0, graph 0.08, 0\n"
        "set title {} noenhanced\nset xlabel {} noenhanced\nset ylabel {} noenhanced\n",
        terminal, QuoteForGnuplot(fs::absolute(picture).string()), QuoteForGnuplot(plot.title),
        QuoteForGnuplot(plot.xLabel), QuoteForGnuplot(plot.yLabel));
    script += plot.logarithmic ? "set logscale xy\n" : "set yrange [0:*]\nset xrange [0:*]\n";
    if (!plot.note.empty()) {
        script += fmt::format("set bmargin 5.5\nset label {} at screen 0.5,0.03 center font ',9' noenhanced\n",
                              QuoteForGnuplot(plot.note));
    }
    std::string curves, least;
    std::size_t longest = 0;
    for (const PlotCurve& curve : plot.curves) longest = std::max(longest, curve.points.size());
    // Many points would hide their lines.
    const double pointSize = longest > 200 ? 0.3 : 0.8;
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        const PlotCurve& curve = plot.curves[i];
        script += fmt::format("$curve{} << END\n", i);
        for (const PlotPoint& point : curve.points) script += fmt::format("{} {}\n", point.x, point.y);
        script += "END\n";
        for (const PlotPoint& point : curve.points) {
            if (point.isLeast) least += fmt::format("{} {}\n", point.x, point.y);
        }
        curves += fmt::format(
            "{}$curve{} with linespoints linecolor '{}' linewidth 1 pointtype {} pointsize {} title {}",
            curves.empty() ? "plot " : ", ", i, curve.color, curve.pointType, pointSize, QuoteForGnuplot(curve.title));
    }
    if (!least.empty()) {
        script += "$least << END\n" + least + "END\n";
        // Hollow and larger than any curve's own points, so that these are seen inside it.
        curves += ", $least with points linecolor '#000000' pointtype 8 pointsize 2.4 title 'stopped: at least this'";
    }
    return script + curves + "\n";
}

void DrawPlot(const Plot& plot, const fs::path& stem) {
    for (const auto& [terminal, extension] : {std::pair("svg", ".svg"), std::pair("pngcairo", ".png")}) {
        const fs::path picture = stem.string() + extension, temporary = stem.string() + ".tmp" + extension;
        RunGnuplot(MakePlotScript(plot, terminal, temporary), temporary);
        fs::rename(temporary, picture);
    }
}

}  // namespace testbed
