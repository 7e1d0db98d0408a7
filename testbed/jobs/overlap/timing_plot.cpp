// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Broad-phase time by step as a picture. The data stand in the script itself, so that one file is all that passes to
// gnuplot.

#include "testbed/jobs/overlap/timing_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

#include "testbed/page/gnuplot.h"

namespace testbed {

namespace fs = std::filesystem;

namespace {

struct SeriesLook {
    std::string_view color;
    int pointType;  ///< gnuplot's number: 7 filled circle, 5 filled square
};

constexpr SeriesLook boxTwoDLook{"#0000cc", 7};
/// Of the others, in their order; Okabe and Ito's colours after the first.
constexpr SeriesLook looks[] = {{"#cc0000", 5}, {"#009e73", 9}, {"#e69f00", 11}, {"#cc79a7", 13}, {"#56b4e9", 15}};

constexpr std::string_view header = R"(set terminal pngcairo size 1100,640 font 'DejaVu Sans,12' background '#ffffff'
set border 31 linecolor '#000000'
set grid linecolor '#cccccc' linetype 1
set key top right opaque box width 1
set xlabel 'step'
set ylabel 'broad phase [ms]'
set offsets 0, 0, graph 0.14, 0
set yrange [0:*]
)";

constexpr std::string_view boxTwoDNote =
    "Box2D: pair finding and tree update. Its retest of kept contacts runs inside Collide, cannot be separated,"
    " and is not in these times.";

}  // namespace

std::string MakeTimingScript(std::span<const TimingSeries> series, const std::string& title, const fs::path& picture) {
    std::string data, plots;
    bool hasBox2d = false;
    int lastStep = 1;
    std::size_t others = 0;
    // Drawn last lies on top: Box2D below.
    std::vector<const TimingSeries*> order;
    for (const TimingSeries& one : series) order.push_back(&one);
    std::ranges::stable_partition(order, [](const TimingSeries* one) { return one->engine == "box2d"; });
    for (const TimingSeries* one : order) {
        const bool isBox2d = one->engine == "box2d";
        const SeriesLook& look = isBox2d && !hasBox2d ? boxTwoDLook : looks[others++ % std::size(looks)];
        hasBox2d = hasBox2d || isBox2d;
        const std::string name = one->pane != one->engine ? one->pane : std::string(isBox2d ? "Box2D" : "Scree");
        const std::string block = fmt::format("$series_{}", one - series.data());
        fmt::format_to(std::back_inserter(data), "{} << END\n", block);
        for (const StepRecord& record : one->steps) {
            lastStep = std::max(lastStep, record.step);
            fmt::format_to(std::back_inserter(data), "{} {:.6f}\n", record.step, record.times.broadPhase);
        }
        data += "END\n";
        fmt::format_to(
            std::back_inserter(plots),
            "{}{} with linespoints linecolor '{}' linewidth 1 pointtype {} pointsize 0.9 title '{}' noenhanced",
            plots.empty() ? "plot " : ", ", block, look.color, look.pointType, name);
    }
    std::string script(header);
    fmt::format_to(std::back_inserter(script), "set output {}\nset title {} noenhanced\nset xrange [{}:{}]\n",
                   QuoteForGnuplot(fs::absolute(picture).string()), QuoteForGnuplot(title), -0.04 * lastStep,
                   1.04 * lastStep);
    if (hasBox2d) {
        fmt::format_to(std::back_inserter(script),
                       "set bmargin 5.5\nset label {} at screen 0.5,0.03 center font ',9' noenhanced\n",
                       QuoteForGnuplot(boxTwoDNote));
    }
    return script + data + plots + "\n";
}

void DrawTimingPlot(std::span<const TimingSeries> series, const std::string& title, const fs::path& picture) {
    RunGnuplot(MakeTimingScript(series, title, picture), picture);
}

}  // namespace testbed
