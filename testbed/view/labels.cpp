// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Texts and their places. All positions are whole pixels.

#include "testbed/view/labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "testbed/picture/composite.h"
#include "testbed/picture/font.h"
#include "testbed/view/annotate.h"
#include "testbed/view/legend.h"

namespace testbed {

namespace {

constexpr const char* gap = "   ";  // between the parts of a line
constexpr int footerLines = 2;
constexpr double barShare = 0.36;                           // of a pane's width
constexpr int countIntervals = 5, differenceIntervals = 3;  // of a scale; of each half of one
constexpr int edge = 6;                                     // pixels between text and a picture's border, at scale 1

/// The count at the end of the bar: in the alpha style that from which more layers no longer change the colour.
uint32_t GetBarEnd(uint32_t scaleMax, const PictureOptions& options, const std::vector<Color>& palette) {
    if (options.style != Style::alpha) return std::max(scaleMax, 1u);
    const auto saturated = std::find(palette.begin(), palette.end(), palette.back());
    return std::max(static_cast<uint32_t>(saturated - palette.begin()), 1u);
}

/// A line across the bar, with `text` above it.
void AddMean(ColorBar& bar, double mean, std::string text, uint32_t scaleMax, const PictureOptions& options) {
    const uint32_t end = GetBarEnd(scaleMax, options,
                                   MakePalette(options.style, GetOpacity(options, scaleMax), scaleMax, options.theme));
    bar.marks.push_back({GetScalePosition(options.style, mean, end), std::move(text), false});
}

/// Draws the dark strip of `lines` lines along the lower edge; returns its top row.
int FillFooter(Image& image, int lines, int scale, const ThemeColors& colors) {
    const int top = image.height - GetStripHeight(lines, scale);
    BlendRect(image, {0, top, image.width, image.height}, colors.strip);
    return top;
}

PixelBox GetFooterBar(const Image& image, int top, int scale) {
    const int width = static_cast<int>(image.width * barShare);
    return {image.width - width - edge * scale, top + 4 * scale, image.width - edge * scale, top + lineHeight * scale};
}

/// A number with the sign that is as wide as a plus.
std::string WithMinus(const std::string& number) { return number.starts_with('-') ? "−" + number.substr(1) : number; }

using TwoLines = std::array<std::string, footerLines>;

/// What the lines of a footer may take left of its bar.
int GetFooterRoom(int width, int scale) { return width - static_cast<int>(width * barShare) - 4 * edge * scale; }

/// The largest scale not above `scale` at which both lines fit.
int FitLines(const TwoLines& lines, int scale, int room) {
    return FitScale(lines[0], FitScale(lines[1], scale, room), room);
}

/// Both lines from (x, y) on, at one size, cut where even the smallest does not fit.
void DrawLines(Image& image, int x, int y, const TwoLines& lines, int scale, int textScale, int room,
               const Color& color) {
    for (const std::string& line : lines) {
        DrawText(image, x, y, CutText(line, textScale, room), textScale, color);
        y += lineHeight * scale;
    }
}

TwoLines MakeFooterLines(const PaneInput& input, const OverlapPane& pane, const PictureOptions& options) {
    std::string nodes = MakeNodesText(pane.count.stats, options);
    if (options.querySize > 0) nodes += fmt::format(" grown for queries of {} m", options.querySize);
    if (!input.note.empty()) nodes += gap + input.note;
    return {MakeStatsText(pane.count.stats, ""), std::move(nodes)};
}

TwoLines MakeCaptionLines(const PaneInput& input, const OverlapPane& pane, const PictureOptions& options) {
    return {MakeEngineText(*input.snapshot) + gap + MakeNodesText(pane.count.stats, options),
            MakeStatsText(pane.count.stats, input.note)};
}

int FitHeader(const std::string& left, const std::string& right, int width) {
    const int scale = GetLabelScale(width);
    return FitScale(left + gap + right, scale, width - 2 * edge * scale);
}

/// A strip along the upper edge. Text that is too long even when small is cut, the right one first.
void DrawHeaderAt(Image& image, const std::string& left, const std::string& right, int scale, int textScale,
                  Theme theme) {
    const ThemeColors& colors = GetTheme(theme);
    const int height = GetStripHeight(1, scale);
    const int room = image.width - 2 * edge * scale, y = (height - capHeight * textScale) / 2;
    BlendRect(image, {0, 0, image.width, height}, colors.strip);
    const std::string first = CutText(left, textScale, room);
    const int taken = GetTextWidth(first + gap, textScale) + 3 * edge * textScale;
    const std::string second = CutText(right, textScale, room - taken);
    DrawText(image, edge * scale, y, first, textScale, colors.text);
    DrawText(image, image.width - GetTextWidth(second, textScale) - edge * scale, y, second, textScale,
             colors.faintText);
}

}  // namespace

Margins GetPictureMargins(const PictureOptions& options) {
    const int scale = GetLabelScale(options.width);
    const int side = options.width / 64;
    if (!options.labels) return {side, side, side, side};
    const int footer =
        options.legend ? GetLegendHeight(options.layers, options.width) : GetStripHeight(footerLines, scale);
    return {side, GetStripHeight(1, scale) + side / 2, side, footer + side / 2};
}

std::string MakeTitle(const Snapshot& snapshot) {
    return fmt::format("{}{}size {}{}step {}", snapshot.scene, gap, snapshot.size, gap, snapshot.step);
}

std::string MakeEngineText(const Snapshot& snapshot) {
    return fmt::format("{}{}{}{}{} bodies", snapshot.GetName(), gap, snapshot.broadPhase, gap, snapshot.bodies.size());
}

std::string MakeNodesText(const OverlapStats& stats, const PictureOptions& options) {
    const bool byLevel = options.nodes.kind == NodeSelection::Kind::levels;
    const std::string name = GetNodeSelectionName(options.nodes);
    return byLevel ? fmt::format("{} nodes of {}", stats.nodesDrawn, name)
                   : fmt::format("{} {} nodes", stats.nodesDrawn, name);
}

std::string MakeStatsText(const OverlapStats& stats, const std::string& note) {
    std::string text = fmt::format("overlap max {}{}mean {:.3f}{}p99 {}", stats.max, gap, stats.mean, gap, stats.p99);
    if (!note.empty()) text += gap + note;
    return text;
}

ColorBar MakeCountBar(const PixelBox& box, uint32_t scaleMax, const PictureOptions& options) {
    std::vector<Color> palette = MakePalette(options.style, GetOpacity(options, scaleMax), scaleMax, options.theme);
    const uint32_t end = GetBarEnd(scaleMax, options, palette);
    const Style style = options.style;
    const auto color = [palette = std::move(palette), style, end](double position) {
        // The smallest count at or right of the position.
        uint32_t first = 0, last = end;
        while (first < last) {
            const uint32_t middle = first + (last - first) / 2;
            if (GetScalePosition(style, middle, end) < position) {
                first = middle + 1;
            } else {
                last = middle;
            }
        }
        return palette[first];
    };
    ColorBar bar{box, color, {}};
    std::vector<int64_t> ticks = style == Style::log ? ChooseLogarithmicTicks(end) : ChooseTicks(end, countIntervals);
    ticks.pop_back();
    bar.marks.push_back({1, fmt::format("{}{}", end < scaleMax ? "≥ " : "", end)});
    for (const int64_t tick : ticks) {
        bar.marks.push_back({GetScalePosition(style, static_cast<double>(tick), end), fmt::format("{}", tick)});
    }
    return bar;
}

void DrawHeader(Image& image, const std::string& left, const std::string& right, Theme theme) {
    DrawHeaderAt(image, left, right, GetLabelScale(image.width), FitHeader(left, right, image.width), theme);
}

void DrawPaneLabels(std::span<const PaneInput> inputs, std::span<OverlapPane> panes, uint32_t scaleMax,
                    const PictureOptions& options) {
    const int scale = GetLabelScale(options.width), room = GetFooterRoom(options.width, scale);
    int headerScale = scale, footerScale = scale;
    std::vector<TwoLines> footers;
    for (size_t i = 0; i < panes.size(); ++i) {
        const Snapshot& snapshot = *inputs[i].snapshot;
        footers.push_back(MakeFooterLines(inputs[i], panes[i], options));
        headerScale = std::min(headerScale, FitHeader(MakeTitle(snapshot), MakeEngineText(snapshot), options.width));
        footerScale = FitLines(footers.back(), footerScale, room);
    }
    for (size_t i = 0; i < panes.size(); ++i) {
        Image& image = panes[i].image;
        const Snapshot& snapshot = *inputs[i].snapshot;
        DrawHeaderAt(image, MakeTitle(snapshot), MakeEngineText(snapshot), scale, headerScale, options.theme);
        const int top = FillFooter(image, footerLines, scale, GetTheme(options.theme));
        ColorBar bar = MakeCountBar(GetFooterBar(image, top, scale), scaleMax, options);
        AddMean(bar, panes[i].count.stats.mean, "", scaleMax, options);
        DrawColorBar(image, bar, scale, options.theme);
        DrawLines(image, edge * scale, top + 3 * scale, footers[i], scale, footerScale, room,
                  GetTheme(options.theme).text);
    }
}

void DrawDifferenceFooter(Image& image, const DifferenceStats& stats, int64_t end, const std::string& firstName,
                          const std::string& secondName, Theme theme) {
    const int scale = GetLabelScale(image.width), room = GetFooterRoom(image.width, scale);
    const int top = FillFooter(image, footerLines, scale, GetTheme(theme));
    const auto color = [end, theme](double position) {
        const double value = (position * 2 - 1) * static_cast<double>(end);
        return GetDifferenceColor(static_cast<int64_t>(value < 0 ? value - 0.5 : value + 0.5), end, theme);
    };
    ColorBar bar{GetFooterBar(image, top, scale), color, {}};
    // The ends and 0 first: of numbers without room the others are left out.
    std::vector<int64_t> ticks = ChooseTicks(end, differenceIntervals);
    std::rotate(ticks.begin(), ticks.end() - 1, ticks.end());
    for (const int64_t tick : ticks) {
        const double share = static_cast<double>(tick) / static_cast<double>(end) / 2;
        if (tick != 0) bar.marks.push_back({0.5 - share, fmt::format("−{}", tick)});
        bar.marks.push_back({0.5 + share, tick != 0 ? fmt::format("+{}", tick) : "0"});
    }
    DrawColorBar(image, bar, scale, theme);
    const TwoLines lines{fmt::format("difference min {}{}max {}{}mean {}", WithMinus(fmt::format("{}", stats.min)), gap,
                                     stats.max, gap, WithMinus(fmt::format("{:.3f}", stats.mean))),
                         fmt::format("blue: {} counts more, red: {} counts more", secondName, firstName)};
    DrawLines(image, edge * scale, top + 3 * scale, lines, scale, FitLines(lines, scale, room), room,
              GetTheme(theme).text);
}

int GetFooterHeight(int width) { return GetStripHeight(footerLines, GetLabelScale(width)); }

int GetCompareScale(int paneWidth) {
    constexpr int leastWidth = 900;  // of captions at scale 2
    return paneWidth >= leastWidth ? 2 : 1;
}

int GetCompareColumns(std::size_t panes) {
    return panes <= 3 ? static_cast<int>(panes) : static_cast<int>(std::ceil(std::sqrt(static_cast<double>(panes))));
}

Image MakeCompare(std::span<const PaneInput> inputs, std::span<const OverlapPane> panes,
                  std::span<const Image> pictures, uint32_t scaleMax, const PictureOptions& options) {
    const ThemeColors& colors = GetTheme(options.theme);
    const int scale = GetCompareScale(pictures[0].width);
    const int titleHeight = options.labels ? GetStripHeight(1, scale) : 0;
    const int captionHeight = options.labels ? GetStripHeight(2, scale) : 0;
    const int barHeight = options.labels ? GetStripHeight(3, scale) : 0;  // means, colours, ticks
    const int columns = GetCompareColumns(pictures.size());
    const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
    const int rowHeight = pictures[0].height + captionHeight;
    const int room = pictures[0].width - 2 * edge * scale;
    std::vector<TwoLines> captions;
    int captionScale = scale;
    for (size_t i = 0; options.labels && i < pictures.size(); ++i) {
        captions.push_back(MakeCaptionLines(inputs[i], panes[i], options));
        captionScale = FitLines(captions.back(), captionScale, room);
    }
    Image image(options.width, titleHeight + rows * rowHeight + barHeight, colors.strip);
    for (size_t i = 0; i < pictures.size(); ++i) {
        const Image& picture = pictures[i];
        const int x = static_cast<int>(i) % columns * (picture.width + compareGap);
        const int top = titleHeight + static_cast<int>(i) / columns * rowHeight;
        for (int y = 0; y < picture.height; ++y) {
            std::copy_n(&picture.At(0, y), picture.width, &image.At(x, top + y));
        }
        if (!options.labels) continue;
        DrawLines(image, x + edge * scale, top + picture.height + 4 * scale, captions[i], scale, captionScale, room,
                  colors.text);
    }
    if (!options.labels) return image;
    const std::string what = options.querySize > 0
                                 ? fmt::format("tree nodes that a query of {} m visits", options.querySize)
                                 : "tree nodes over each pixel";
    DrawHeaderAt(image, MakeTitle(*inputs[0].snapshot), what, scale, scale, options.theme);
    const int barTop = titleHeight + rows * rowHeight + lineHeight * scale;
    ColorBar bar = MakeCountBar(
        {4 * edge * scale, barTop + 4 * scale, options.width - 4 * edge * scale, barTop + lineHeight * scale}, scaleMax,
        options);
    for (const OverlapPane& pane : panes) {
        const double mean = pane.count.stats.mean;
        AddMean(bar, mean, fmt::format("{} mean {:.3g}", pane.name, mean), scaleMax, options);
    }
    DrawColorBar(image, bar, scale, options.theme);
    return image;
}

}  // namespace testbed
