// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of timing_plot.h.

#include "testbed/jobs/overlap/timing_plot.h"

#include <algorithm>
#include <string_view>

namespace testbed {

namespace {

struct EngineLook {
    std::string_view engine, title;
    PlotLook look;
};
constexpr EngineLook looks[] = {{"box2d", "Box2D", boxTwoDLook}, {"scree", "Scree", ourLooks[0]}};

constexpr std::string_view boxTwoDNote =
    "Box2D: pair finding and tree update. Its retest of kept contacts runs inside Collide, cannot be separated,"
    " and is not in these times.";

}  // namespace

Plot MakeTimingPlot(std::span<const TimingSeries> series, const std::string& title) {
    Plot plot{.title = title, .xLabel = "step", .yLabel = "broad phase [ms]"};
    plot.legend = PlotLegend::topRight;
    plot.roomAbove = 0.14;
    plot.roomBeside = 0.04;
    for (const EngineLook& look : looks) {
        const auto one = std::ranges::find(series, look.engine, &TimingSeries::engine);
        if (one == series.end()) continue;
        if (look.engine == "box2d") plot.note = boxTwoDNote;
        PlotCurve curve{.title = std::string(look.title), .look = look.look, .pointSize = 0.9};
        for (const StepRecord& record : one->steps) {
            curve.points.push_back({static_cast<double>(record.step), record.times.broadPhase});
        }
        plot.curves.push_back(std::move(curve));
    }
    return plot;
}

}  // namespace testbed
