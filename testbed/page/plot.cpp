// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of plot.h. The data stand in the script itself, so that one file is all that passes to gnuplot.

#include "testbed/page/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "testbed/base/input.h"
#include "testbed/base/new_file.h"
#include "testbed/page/gnuplot.h"
#include "testbed/page/page_markup.h"

namespace testbed {

namespace fs = std::filesystem;

namespace {

/// A string literal in which only the quote itself is special.
std::string Quote(std::string_view text) {
    std::string quoted = "'";
    for (const char c : text) {
        quoted += c;
        if (c == '\'') quoted += c;
    }
    return quoted + "'";
}

constexpr double aboveMost = 0.2;  // of plot.most: room for what is higher

std::string MakeFrame(const Plot& plot, std::string_view terminal, const fs::path& picture) {
    constexpr std::string_view legends[] = {"top left opaque box width 1", "top right opaque box width 1",
                                            "outside bottom horizontal"};
    return fmt::format(
        "set terminal {} size {} background '#ffffff'\nset output {}\nset border 31 linecolor '#000000'\n"
        "set grid linecolor '#cccccc' linetype 1\nset key {}\n"
        "set title {} noenhanced\nset xlabel {} noenhanced\nset ylabel {} noenhanced\n",
        terminal, plot.small ? "640,440 font 'DejaVu Sans,13'" : "1100,640 font 'DejaVu Sans,12'",
        Quote(fs::absolute(picture).string()), legends[static_cast<int>(plot.legend)], Quote(plot.title),
        Quote(plot.xLabel), Quote(plot.yLabel));
}

std::string MakeAxes(const Plot& plot) {
    std::string script;
    double beside = plot.roomBeside;
    if (plot.logarithmic) {
        script = "set logscale xy\n";
    } else {
        // From 0, hence offsets beside would be none: the range has them.
        double last = 0;
        for (const PlotCurve& curve : plot.curves) {
            for (const PlotPoint& point : curve.points) last = std::max(last, point.x);
        }
        const double room = std::exchange(beside, 0.0) * std::max(last, 1.0);
        script = plot.most > 0 ? fmt::format("set yrange [0:{}]\n", plot.most * (1 + aboveMost)) : "set yrange [0:*]\n";
        script += room > 0 ? fmt::format("set xrange [{}:{}]\n", -room, last + room) : "set xrange [0:*]\n";
    }
    const auto offset = [](double share) { return share > 0 ? fmt::format("graph {}", share) : std::string("0"); };
    script +=
        fmt::format("set offsets {0}, {0}, {1}, {2}\n", offset(beside), offset(plot.roomAbove), offset(plot.roomBelow));
    if (plot.powersOfTen) script += "set format y '10^{%L}'\n";
    return script;
}

/// The clause of `plot` that draws data block `i`, and its labels if it has some.
std::string DrawCurve(const PlotCurve& curve, std::size_t i, double pointSize) {
    const double size = curve.pointSize > 0 ? curve.pointSize : pointSize;
    const std::string title = curve.title.empty() ? "notitle" : "title " + Quote(curve.title);
    const std::string look = curve.style == PlotStyle::lines
                                 ? fmt::format("lines linecolor '{}' linewidth 2", curve.look.color)
                                 : fmt::format("{} linecolor '{}' linewidth 1 pointtype {} pointsize {}",
                                               curve.style == PlotStyle::points ? "points" : "linespoints",
                                               curve.look.color, curve.look.pointType, size);
    std::string clause = fmt::format("$curve{} using 1:2 with {} {}", i, look, title);
    if (!curve.labels.empty()) {
        clause += fmt::format(", $curve{} using 1:2:3 with labels offset 0,1 textcolor '{}' font ',11' notitle", i,
                              curve.look.color);
    }
    return clause;
}

/// Triangles and numbers of what is above plot.most, one below the other, and their clauses behind `curves`.
std::string WriteHighPoints(const Plot& plot, std::string& curves) {
    std::string script;
    if (plot.most <= 0) return script;
    int count = 0;
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        const PlotCurve& curve = plot.curves[i];
        std::string list;
        for (const PlotPoint& point : curve.points) {
            if (point.y <= plot.most) continue;
            const double y = plot.most * (1 + aboveMost * (1 - 0.3 * (count++ % 3 + 0.6)));
            list += fmt::format("{} {} \"{} {}: {:.1f}\"\n", point.x, y, plot.xLabel, point.x, point.y);
        }
        if (list.empty()) continue;
        script += fmt::format("$high{} << END\n{}END\n", i, list);
        curves += fmt::format(
            ", $high{0} using 1:2 with points linecolor '{1}' pointtype 9 pointsize 1.5 notitle"
            ", $high{0} using 1:2:3 with labels left offset 1,0 textcolor '{1}' notitle",
            i, curve.look.color);
    }
    return script;
}

std::string ListPoints(const PlotCurve& curve) {
    std::string list;
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        list += fmt::format("{} {}", curve.points[i].x, curve.points[i].y);
        if (!curve.labels.empty()) list += fmt::format(" \"{}\"", curve.labels[i]);
        list += '\n';
    }
    return list;
}

}  // namespace

std::string MakePlotScript(const Plot& plot, std::string_view terminal, const fs::path& picture) {
    std::string script = MakeFrame(plot, terminal, picture) + MakeAxes(plot);
    if (!plot.note.empty()) {
        script += fmt::format("set bmargin 5.5\nset label {} at screen 0.5,0.03 center font ',9' noenhanced\n",
                              Quote(plot.note));
    }
    std::string curves, least;
    std::size_t longest = 0;
    for (const PlotCurve& curve : plot.curves) longest = std::max(longest, curve.points.size());
    // Many points would hide their lines.
    const double pointSize = longest > 200 ? 0.3 : 0.8;
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        const PlotCurve& curve = plot.curves[i];
        script += fmt::format("$curve{} << END\n{}END\n", i, ListPoints(curve));
        for (const PlotPoint& point : curve.points) {
            if (point.isLeast) least += fmt::format("{} {}\n", point.x, point.y);
        }
        curves += (curves.empty() ? "plot " : ", ") + DrawCurve(curve, i, pointSize);
    }
    if (!least.empty()) {
        script += "$least << END\n" + least + "END\n";
        // Hollow and larger than any curve's own points, so that these are seen inside it.
        curves += ", $least with points linecolor '#000000' pointtype 8 pointsize 2.4 title 'stopped: at least this'";
    }
    return script + WriteHighPoints(plot, curves) + curves + "\n";
}

void SpareFirstStep(Plot& plot) {
    constexpr double farAbove = 1.25;
    double first = 0, rest = 0, begin = std::numeric_limits<double>::infinity();
    for (const PlotCurve& curve : plot.curves) {
        for (const PlotPoint& point : curve.points) begin = std::min(begin, point.x);
    }
    for (const PlotCurve& curve : plot.curves) {
        for (const PlotPoint& point : curve.points) {
            double& largest = point.x == begin ? first : rest;
            largest = std::max(largest, point.y);
        }
    }
    plot.most = rest > 0 && first > farAbove * rest ? rest : 0;
}

void DrawPlot(const Plot& plot, std::string_view terminal, const fs::path& picture) {
    RunGnuplot(MakePlotScript(plot, terminal, picture), picture);
    if (terminal == "svg") {
        WriteTextFile(picture, PutPlotData(ReadText(picture, "draw it again"), MakePlotData(plot)));
    }
}

std::string MakePlotData(const Plot& plot) {
    using nlohmann::ordered_json;
    ordered_json curves = ordered_json::array();
    for (const PlotCurve& curve : plot.curves) {
        ordered_json points = ordered_json::array();
        for (const PlotPoint& point : curve.points) points.push_back({point.x, point.y});
        ordered_json object{{"title", curve.title}, {"color", curve.look.color}, {"points", std::move(points)}};
        if (curve.style != PlotStyle::points) object["line"] = true;
        if (curve.style != PlotStyle::lines) object["dots"] = curve.pointSize > 0 ? curve.pointSize : 0.8;
        if (const auto& names = curve.names.empty() ? curve.labels : curve.names; !names.empty())
            object["names"] = names;
        ordered_json least = ordered_json::array();
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            if (curve.points[i].isLeast) least.push_back(i);
        }
        if (!least.empty()) object["least"] = std::move(least);
        curves.push_back(std::move(object));
    }
    return ordered_json{{"x", plot.xLabel},
                        {"y", plot.yLabel},
                        {"logarithmic", plot.logarithmic},
                        {"most", plot.most},
                        {"curves", curves}}
        .dump();
}

void DrawPlotFiles(const Plot& plot, const fs::path& stem) {
    NewFile svg(stem.string() + ".svg");
    DrawPlot(plot, "svg", svg.GetPlace());
    svg.Finish();
    NewFile png(stem.string() + ".png");
    DrawPlot(plot, "pngcairo", png.GetPlace());
    png.Finish();
}

}  // namespace testbed
