// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of timing_plot.h.

#include "testbed/jobs/overlap/timing_plot.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace testbed {

namespace {

constexpr std::string_view boxTwoDNote =
    "Box2D: pair finding and tree update. Its retest of kept contacts runs inside Collide, cannot be separated,"
    " and is not in these times.";

}  // namespace

Plot MakeTimingPlot(std::span<const TimingSeries> series, const std::string& title) {
    Plot plot{.title = title, .xLabel = "step", .yLabel = "broad phase [ms]"};
    plot.legend = PlotLegend::topRight;
    plot.roomAbove = 0.14;
    plot.roomBeside = 0.04;
    // Drawn last lies on top: Box2D below.
    std::vector<const TimingSeries*> order;
    for (const TimingSeries& one : series) {
        if (HasTimes(one)) order.push_back(&one);
    }
    std::ranges::stable_partition(order, [](const TimingSeries* one) { return one->engine == "box2d"; });
    std::size_t others = 0;
    for (const TimingSeries* one : order) {
        const bool isBox2d = one->engine == "box2d", isFirst = one->pane == one->engine;
        if (isBox2d) plot.note = boxTwoDNote;
        PlotCurve curve{.title = isFirst && isBox2d                  ? "Box2D"
                                 : isFirst && one->engine == "scree" ? "Scree"
                                                                     : one->pane,
                        .look = isBox2d && isFirst ? boxTwoDLook : ourLooks[others++ % std::size(ourLooks)],
                        .pointSize = 0.9};
        for (const StepRecord& record : one->steps) {
            curve.points.push_back({static_cast<double>(record.step), record.times.broadPhase});
        }
        plot.curves.push_back(std::move(curve));
    }
    SpareFirstStep(plot);
    return plot;
}

}  // namespace testbed
