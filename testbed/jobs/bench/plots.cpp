// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Curves of the bench, in the colours of the dissertation's figures.

#include "testbed/jobs/bench/plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <string_view>

namespace testbed {

namespace {

constexpr std::string_view assertsNote = "Box2D 2.4.1 as Debian builds it, with its asserts";

std::string CurveTitle(const BenchRow& row) {
    if (row.GetName() != row.engine) return row.pane;
    if (row.engine == "box2d") return "Box2D";
    std::string title = "Scree";
    if (row.solver == "soft") {
        title += ", soft step";
    } else if (row.solver != "si") {
        title += ", " + row.solver;
    }
    if (row.threads > 1) title += fmt::format(", {} threads", row.threads);
    return title;
}

/// The curve of the row's engine and setting, made when it is new.
PlotCurve& CurveOf(Plot& plot, const BenchRow& row) {
    const std::string title = CurveTitle(row);
    for (PlotCurve& curve : plot.curves) {
        if (curve.title == title) return curve;
    }
    const auto ours = static_cast<std::size_t>(
        std::ranges::count_if(plot.curves, [](const PlotCurve& curve) { return curve.title != "Box2D"; }));
    plot.curves.push_back({title, title == "Box2D" ? boxTwoDLook : ourLooks[ours % std::size(ourLooks)]});
    return plot.curves.back();
}

}  // namespace

Plot MakeTotalsPlot(std::span<const BenchRow> rows) {
    Plot plot;
    plot.xLabel = "fixtures";
    plot.yLabel = "total time [ms]";
    plot.note = assertsNote;
    if (rows.empty()) return plot;
    plot.title = fmt::format("{}: {} steps, continuous collision {}", rows.front().scene, rows.front().steps,
                             rows.front().continuous ? "on" : "off");
    for (const BenchRow& row : rows) {
        CurveOf(plot, row).points.push_back({static_cast<double>(row.fixtures), row.totalMs, !row.complete});
    }
    return plot;
}

Plot MakeCostPlot(std::span<const BenchRow> rows) {
    Plot plot;
    plot.title = "Time of a moving body in one step";
    plot.xLabel = "moving bodies";
    plot.yLabel = "time [ns per body and step]";
    if (std::ranges::find(rows, "box2d", &BenchRow::engine) != rows.end()) plot.note = assertsNote;
    plot.logarithmic = true;
    constexpr double leastSpread = 10.0;
    constexpr PlotLook looks[] = {ourLooks[0], ourLooks[1], ourLooks[2], ourLooks[3], boxTwoDLook};
    for (const BenchRow& row : rows) {
        const auto ofScene = [&](const BenchRow& other) { return other.scene == row.scene; };
        int least = row.movers, most = row.movers;
        for (const BenchRow& other : rows) {
            if (!ofScene(other)) continue;
            least = std::min(least, other.movers), most = std::max(most, other.movers);
        }
        if (most < leastSpread * least) continue;
        const std::string title = row.scene + ", " + CurveTitle(row);
        auto curve = std::ranges::find(plot.curves, title, &PlotCurve::title);
        if (curve == plot.curves.end()) {
            plot.curves.push_back({title, looks[plot.curves.size() % std::size(looks)]});
            curve = plot.curves.end() - 1;
        }
        curve->points.push_back({static_cast<double>(row.movers), row.nsPerBodyStep});
    }
    if (plot.curves.empty()) return plot;
    const std::vector<PlotPoint> first = plot.curves.front().points;
    PlotCurve growth{"growth by log n", {"#777777", 1}};
    for (const PlotPoint& point : first) {
        growth.points.push_back({point.x, first.front().y * std::log(point.x) / std::log(first.front().x)});
    }
    plot.curves.push_back(growth);
    return plot;
}

Plot MakeStepsPlot(std::span<const BenchRow> rows, std::span<const TimingSeries> timing) {
    Plot plot;
    plot.xLabel = "step";
    plot.yLabel = "broad phase [ms]";
    plot.note = assertsNote;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        plot.title = fmt::format("{}, size {}: broad phase of every step", rows[i].scene, rows[i].size);
        PlotCurve& curve = CurveOf(plot, rows[i]);
        for (const StepRecord& record : timing[i].steps) {
            curve.points.push_back({static_cast<double>(record.step), record.times.broadPhase});
        }
    }
    SpareFirstStep(plot);
    return plot;
}

}  // namespace testbed
