// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Texts and their places. All positions are whole pixels.

#include "testbed/view/labels.h"

#include <fmt/format.h>

#include <algorithm>
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
constexpr double barShare = 0.36;  // of a pane's width

/// The bar of a count scale. In the alpha style it ends where more layers no longer change the colour.
ColorBar MakeCountBar(const PixelBox& box, uint32_t scaleMax, const PictureOptions& options) {
    std::vector<Color> palette = MakePalette(options.style, options.opacity, scaleMax, options.theme);
    uint32_t end = std::max(scaleMax, 1u);
    if (options.style == Style::alpha) {
        const auto saturated = std::find(palette.begin(), palette.end(), palette.back());
        end = std::max(static_cast<uint32_t>(saturated - palette.begin()), 1u);
    }
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
    bar.marks.push_back({1, fmt::format("{}{}", end < scaleMax ? "from " : "", end)});
    bar.marks.push_back({0, "0"});
    return bar;
}

void AddMean(ColorBar& bar, double mean, const std::string& name, uint32_t scaleMax, const PictureOptions& options) {
    uint32_t end = std::max(scaleMax, 1u);
    if (options.style == Style::alpha) {
        const std::vector<Color> palette = MakePalette(options.style, options.opacity, scaleMax);
        end = std::max(
            static_cast<uint32_t>(std::find(palette.begin(), palette.end(), palette.back()) - palette.begin()), 1u);
    }
    bar.marks.push_back({GetScalePosition(options.style, mean, end), fmt::format("{} {:.3g}", name, mean)});
}

/// Draws the dark strip of `lines` lines along the lower edge; returns its top row.
int FillFooter(Image& image, int lines, int scale, const ThemeColors& colors) {
    const int top = image.height - GetStripHeight(lines, scale);
    BlendRect(image, {0, top, image.width, image.height}, colors.strip);
    return top;
}

PixelBox GetFooterBar(const Image& image, int top, int scale) {
    const int width = static_cast<int>(image.width * barShare);
    return {image.width - width - 6 * scale, top + 3 * scale, image.width - 6 * scale, top + (lineHeight - 1) * scale};
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
    const std::string inflated =
        options.querySize > 0 ? fmt::format(" grown for queries of {} m", options.querySize) : "";
    return byLevel ? fmt::format("{} nodes of {}{}", stats.nodesDrawn, name, inflated)
                   : fmt::format("{} {} nodes{}", stats.nodesDrawn, name, inflated);
}

std::string MakeStatsText(const OverlapStats& stats, const std::string& note) {
    std::string text = fmt::format("overlap max {}{}mean {:.3f}{}p99 {}", stats.max, gap, stats.mean, gap, stats.p99);
    if (!note.empty()) text += gap + note;
    return text;
}

void DrawHeader(Image& image, const std::string& left, const std::string& right, Theme theme) {
    const ThemeColors& colors = GetTheme(theme);
    const int wanted = GetLabelScale(image.width);
    const int height = GetStripHeight(1, wanted);
    const int scale = FitScale(left + gap + right, wanted, image.width - 12 * wanted);
    BlendRect(image, {0, 0, image.width, height}, colors.strip);
    const int y = (height - 7 * scale) / 2;  // capitals are 7 font pixels high
    DrawText(image, image.width - GetTextWidth(right, scale) - 6 * wanted, y, right, scale, colors.faintText);
    DrawText(image, 6 * wanted, y, left, scale, colors.text);
}

void DrawPaneFooter(Image& image, const OverlapPane& pane, const std::string& note, uint32_t scaleMax,
                    const PictureOptions& options) {
    const ThemeColors& colors = GetTheme(options.theme);
    const int scale = GetLabelScale(image.width);
    const int top = FillFooter(image, footerLines, scale, colors);
    const OverlapStats& stats = pane.count.stats;
    ColorBar bar = MakeCountBar(GetFooterBar(image, top, scale), scaleMax, options);
    AddMean(bar, stats.mean, "mean", scaleMax, options);
    DrawColorBar(image, bar, scale, options.theme);
    const int room = bar.box.x0 - 12 * scale;
    const std::string text = MakeStatsText(stats, "");
    DrawText(image, 6 * scale, top + 3 * scale, text, FitScale(text, scale, room), colors.text);
    const std::string secondLine = MakeNodesText(stats, options) + (note.empty() ? "" : gap + note);
    DrawText(image, 6 * scale, top + (3 + lineHeight) * scale, secondLine, FitScale(secondLine, scale, room),
             colors.text);
}

void DrawDifferenceFooter(Image& image, const DifferenceStats& stats, const std::string& firstName,
                          const std::string& secondName, Theme theme) {
    const ThemeColors& colors = GetTheme(theme);
    const int scale = GetLabelScale(image.width);
    const int top = FillFooter(image, footerLines, scale, colors);
    const int64_t end = std::max<int64_t>({-stats.min, stats.max, 1});
    const auto color = [end, theme](double position) {
        const double value = (position * 2 - 1) * static_cast<double>(end);
        return GetDifferenceColor(static_cast<int64_t>(value < 0 ? value - 0.5 : value + 0.5), end, theme);
    };
    ColorBar bar{GetFooterBar(image, top, scale), color, {}};
    bar.marks = {{0, fmt::format("-{} {}", end, secondName)}, {1, fmt::format("{} +{}", firstName, end)}, {0.5, "0"}};
    DrawColorBar(image, bar, scale, theme);
    const std::string text =
        fmt::format("difference min {}{}max {}{}mean {:.3f}", stats.min, gap, stats.max, gap, stats.mean);
    DrawText(image, 6 * scale, top + 3 * scale, text, FitScale(text, scale, bar.box.x0 - 12 * scale), colors.text);
    const std::string legend = fmt::format("blue: {} counts more, red: {} counts more", secondName, firstName);
    DrawText(image, 6 * scale, top + (3 + lineHeight) * scale, legend, FitScale(legend, scale, bar.box.x0 - 12 * scale),
             colors.text);
}

int GetCompareColumns(std::size_t panes) {
    return panes <= 3 ? static_cast<int>(panes) : static_cast<int>(std::ceil(std::sqrt(static_cast<double>(panes))));
}

Image MakeCompare(std::span<const PaneInput> inputs, std::span<const OverlapPane> panes,
                  std::span<const Image> pictures, uint32_t scaleMax, const PictureOptions& options) {
    const ThemeColors& colors = GetTheme(options.theme);
    const int scale = GetLabelScale(options.width);
    const int titleHeight = options.labels ? GetStripHeight(1, scale) : 0;
    const int captionHeight = options.labels ? GetStripHeight(2, scale) : 0;
    const int barHeight = options.labels ? GetStripHeight(2, scale) : 0;
    const int columns = GetCompareColumns(pictures.size());
    const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
    const int rowHeight = pictures[0].height + captionHeight;
    Image image(options.width, titleHeight + rows * rowHeight + barHeight, colors.strip);
    for (size_t i = 0; i < pictures.size(); ++i) {
        const Image& picture = pictures[i];
        const int x = static_cast<int>(i) % columns * (picture.width + compareGap);
        const int top = titleHeight + static_cast<int>(i) / columns * rowHeight;
        const int paneBottom = top + picture.height;
        for (int y = 0; y < picture.height; ++y) {
            std::copy_n(&picture.At(0, y), picture.width, &image.At(x, top + y));
        }
        if (!options.labels) continue;
        const std::string first =
            MakeEngineText(*inputs[i].snapshot) + gap + MakeNodesText(panes[i].count.stats, options);
        const std::string second = MakeStatsText(panes[i].count.stats, inputs[i].note);
        const int captionScale =
            FitScale(first.size() > second.size() ? first : second, scale, picture.width - 12 * scale);
        DrawText(image, x + 6 * scale, paneBottom + 4 * scale, first, captionScale, colors.text);
        DrawText(image, x + 6 * scale, paneBottom + (4 + lineHeight) * scale, second, captionScale, colors.text);
    }
    if (!options.labels) return image;
    DrawHeader(image, MakeTitle(*inputs[0].snapshot), "tree nodes over each pixel", options.theme);
    const int barTop = titleHeight + rows * rowHeight;
    ColorBar bar =
        MakeCountBar({24 * scale, barTop + 3 * scale, options.width - 24 * scale, barTop + (lineHeight - 1) * scale},
                     scaleMax, options);
    for (const OverlapPane& pane : panes) AddMean(bar, pane.count.stats.mean, pane.name + " mean", scaleMax, options);
    DrawColorBar(image, bar, scale, options.theme);
    return image;
}

}  // namespace testbed
