// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Entries per layer, in the order of the table, and a grid of equal cells for them.

#include "testbed/view/legend.h"

#include <fmt/format.h>

#include <algorithm>

#include "testbed/picture/composite.h"
#include "testbed/picture/font.h"
#include "testbed/view/annotate.h"
#include "testbed/view/islands.h"
#include "testbed/view/scene_layers.h"

namespace testbed {

namespace {

constexpr int cellWidth = 192;   // pixels at scale 1: a swatch and a text
constexpr int swatchWidth = 14;  // pixels at scale 1
constexpr int swatchGap = 5;     // pixels between a swatch and its text, at scale 1
constexpr int border = 6;        // pixels between strip and picture border, at scale 1

/// At scale 1; colours that are taken in turn share it.
int GetSwatchWidth(int parts) { return std::max(swatchWidth, 6 * parts); }

/// How many entries MakeLegend gives: a camera is fitted before there is anything to ask for numbers.
int CountEntries(const Layers& layers) { return static_cast<int>(MakeLegend({}, layers, Theme::dark).size()); }

int GetColumns(int width, int scale) { return std::max(1, (width / scale - border) / cellWidth); }

int GetRows(int entries, int columns) { return (entries + columns - 1) / columns; }

void AddBodies(std::vector<LegendEntry>& entries, const ThemeColors& colors, bool withDynamic) {
    const auto add = [&entries](const Look& look, const char* text) { entries.push_back({{look.border}, text}); };
    if (withDynamic) {
        add(colors.awake, "awake");
        add(colors.sleeping, "sleeping");
        add(colors.bullet, "bullet");
    }
    add(colors.isStatic, "static");
    add(colors.kinematic, "kinematic");
    add(colors.sensor, "sensor");
}

std::string DescribePartitions(const Snapshot& snapshot) {
    const Partitions partitions = FindPartitions(snapshot);
    return fmt::format("{} {} colours", partitions.colorCount, partitions.fromEngine ? "solver" : "greedy");
}

LegendEntry DescribeLevels(const NodeSelection& nodes, int height, const std::vector<Color>& cycle) {
    if (nodes.kind != NodeSelection::Kind::levels) return {cycle, fmt::format("levels 0–{}", height)};
    const int last = std::min(nodes.lastLevel, height);
    if (nodes.firstLevel >= last) {
        return {{cycle[static_cast<std::size_t>(nodes.firstLevel) % cycle.size()]},
                fmt::format("level {}", nodes.firstLevel)};
    }
    std::vector<Color> swatches;
    for (int level = nodes.firstLevel; level <= last && swatches.size() < cycle.size(); ++level) {
        swatches.push_back(cycle[static_cast<std::size_t>(level) % cycle.size()]);
    }
    return {std::move(swatches), fmt::format("levels {}–{}", nodes.firstLevel, last)};
}

}  // namespace

std::vector<LegendEntry> MakeLegend(const Snapshot& snapshot, const Layers& layers, Theme theme,
                                    const std::optional<Peaks>& given, const NodeSelection& nodes) {
    const ThemeColors& colors = GetTheme(theme);
    const std::vector<Color> cycle(colors.cycle.begin(), colors.cycle.end());
    const Peaks peaks = given.value_or(FindPeaks(snapshot));
    std::vector<LegendEntry> entries;
    for (const LayerInfo& info : layerTable) {
        if (!layers.Has(info.layer)) continue;
        const auto add = [&entries](const Color& color, std::string text) {
            entries.push_back({{color}, std::move(text)});
        };
        switch (info.layer) {
            case Layer::bodies:
                AddBodies(entries, colors, !layers.Has(Layer::islands));
                break;
            case Layer::islands:
                entries.push_back({cycle, "islands"});
                break;
            case Layer::partitions:
                entries.push_back({cycle, DescribePartitions(snapshot)});
                break;
            case Layer::bvh:
                entries.push_back(DescribeLevels(nodes, snapshot.treeHeight, cycle));
                break;
            case Layer::fattened:
                add(colors.fattenedBox, "box in the broad phase");
                break;
            case Layer::swept:
                add(colors.sweptBox, "box swept by the step");
                break;
            case Layer::aabbs:
                add(colors.tightBox, "tight box");
                break;
            case Layer::joints:
                add(colors.joint, "joint");
                break;
            case Layer::velocities:
                add(colors.velocity, fmt::format("arrow: to {:.3g} m/s", peaks.speed));
                add(colors.velocity, fmt::format("arc: to {:.3g} rad/s", peaks.turn));
                break;
            case Layer::impulses:
                add(colors.impulse, fmt::format("impulse: to {:.3g} N s", peaks.impulse));
                break;
            case Layer::normals:
                add(colors.normal, "normal, A to B");
                break;
            case Layer::contacts:
                add(colors.contact, "contact point");
                break;
            case Layer::labels:
                add(colors.label, "0 1 2: body index");
                break;
        }
    }
    return entries;
}

int GetLegendTextRoom(int swatches) { return cellWidth - GetSwatchWidth(swatches) - swatchGap; }

int GetLegendHeight(const Layers& layers, int width) {
    const int scale = GetLabelScale(width), entries = CountEntries(layers);
    return entries == 0 ? 0 : GetStripHeight(GetRows(entries, GetColumns(width, scale)), scale);
}

void DrawLegend(Image& image, const std::vector<LegendEntry>& entries, Theme theme) {
    if (entries.empty()) return;
    const ThemeColors& colors = GetTheme(theme);
    const int scale = GetLabelScale(image.width), columns = GetColumns(image.width, scale);
    const int top = image.height - GetStripHeight(GetRows(static_cast<int>(entries.size()), columns), scale);
    BlendRect(image, {0, top, image.width, image.height}, colors.strip);
    for (int i = 0; i < static_cast<int>(entries.size()); ++i) {
        const LegendEntry& entry = entries[static_cast<size_t>(i)];
        const int x = (border + i % columns * cellWidth) * scale;
        const int y = top + (3 + i / columns * lineHeight) * scale;
        const int parts = static_cast<int>(entry.swatches.size()), width = GetSwatchWidth(parts);
        for (int part = 0; part < parts; ++part) {
            BlendRect(
                image,
                {x + width * part / parts * scale, y, x + width * (part + 1) / parts * scale, y + capHeight * scale},
                entry.swatches[static_cast<size_t>(part)]);
        }
        // A picture narrower than a cell cuts.
        const int left = x + (width + swatchGap) * scale;
        const int room = std::min(GetLegendTextRoom(parts) * scale, image.width - left);
        DrawText(image, left, y, CutText(entry.text, scale, room), scale, colors.text);
    }
}

}  // namespace testbed
