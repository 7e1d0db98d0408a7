// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of stacked_bars.h. Widths of texts are those of the font of pictures, one of the widest that browsers
// have.

#include "testbed/page/stacked_bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string_view>

#include "testbed/page/page_markup.h"
#include "testbed/picture/font.h"

namespace testbed {

namespace {

// Blue, orange, green, purple, vermilion, grey: Okabe and Ito, 2008.
constexpr std::string_view partColors[] = {"#56b4e9", "#e69f00", "#009e73", "#cc79a7", "#d55e00", "#999999"};
constexpr int barHeight = 16, barDistance = 24, axisWidth = 460, textSize = 12, gap = 10, swatch = 12;

/// At 12 pixels; the font of pictures has 11.
int MeasureLabel(std::string_view text) { return GetTextWidth(text, 1) * 6 / 5 + 2; }

double SumOf(const StackedBar& bar) { return std::accumulate(bar.parts.begin(), bar.parts.end(), 0.0); }

/// 1, 2 or 5 times a power of ten: at most five of it reach `end`.
double ChooseStep(double end) {
    const double power = std::pow(10.0, std::floor(std::log10(end / 5)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power * 5 >= end) return factor * power;
    }
    return 10 * power;
}

std::string Show(double value) { return fmt::format("{:.{}f}", value, value < 10 ? 2 : value < 100 ? 1 : 0); }

std::string WriteText(double x, double y, std::string_view anchor, std::string_view text) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                       EscapeHtml(text));
}

}  // namespace

std::string DrawStackedBars(const StackedBars& bars) {
    if (bars.parts.size() > std::size(partColors)) throw std::invalid_argument("bars of more parts than colours");
    double end = 0;
    int labelWidth = 0, sumWidth = 0, legendWidth = 0;
    for (const StackedBar& bar : bars.bars) {
        end = std::max(end, SumOf(bar));
        labelWidth = std::max(labelWidth, MeasureLabel(bar.label));
        sumWidth = std::max(sumWidth, MeasureLabel("≥ " + Show(SumOf(bar)) + " " + bars.unit));
    }
    for (const std::string& name : bars.parts) legendWidth += swatch + 5 + MeasureLabel(name) + gap;
    if (!(end > 0)) end = 1;
    const int left = labelWidth + gap, right = left + axisWidth;
    const int wholeWidth = std::max(right + gap + sumWidth, legendWidth), legendHeight = 26;
    const int bottom = legendHeight + static_cast<int>(bars.bars.size()) * barDistance, height = bottom + 24;
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
        "font-family=\"DejaVu Sans, Verdana, sans-serif\" font-size=\"{2}\">\n<rect width=\"{0}\" height=\"{1}\" "
        "fill=\"#ffffff\"/>\n",
        wholeWidth, height, textSize);
    int x = 0;
    for (std::size_t i = 0; i < bars.parts.size(); ++i) {
        svg += fmt::format("<rect x=\"{}\" y=\"4\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n", x, swatch, swatch,
                           partColors[i]);
        svg += WriteText(x + swatch + 5, 14, "start", bars.parts[i]);
        x += swatch + 5 + MeasureLabel(bars.parts[i]) + gap;
    }
    const auto place = [&](double value) { return left + value / end * axisWidth; };
    const double step = ChooseStep(end);
    for (int i = 0; i * step <= end * (1 + 1e-9); ++i) {
        svg += fmt::format("<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\" stroke=\"#cccccc\"/>\n",
                           place(i * step), legendHeight - 4, bottom);
        svg += WriteText(place(i * step), bottom + 14, "middle", fmt::format("{:g}", i * step));
    }
    for (std::size_t row = 0; row < bars.bars.size(); ++row) {
        const StackedBar& bar = bars.bars[row];
        const int y = legendHeight + static_cast<int>(row) * barDistance;
        svg += WriteText(left - gap, y + 13, "end", bar.label);
        double begin = 0;
        for (std::size_t i = 0; i < std::min(bar.parts.size(), bars.parts.size()); ++i) {
            const double width = bar.parts[i] / end * axisWidth;
            svg += fmt::format("<rect x=\"{:.2f}\" y=\"{}\" width=\"{:.2f}\" height=\"{}\" fill=\"{}\"/>\n",
                               place(begin), y, width, barHeight, partColors[i]);
            const std::string number = Show(bar.parts[i]);
            if (MeasureLabel(number) < width) svg += WriteText(place(begin) + width / 2, y + 13, "middle", number);
            begin += bar.parts[i];
        }
        svg += WriteText(place(begin) + 6, y + 13, "start",
                         fmt::format("{}{} {}", bar.isLeast ? "≥ " : "", Show(begin), bars.unit));
    }
    return svg + "</svg>\n";
}

}  // namespace testbed
