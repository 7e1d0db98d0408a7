// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Legends: every layer has an entry, entries fit their cells, and the height promised to the camera is the one drawn.

#include "testbed/view/legend.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "testbed/picture/font.h"
#include "tests/testbed/view/sample_snapshot.h"

namespace testbed {
namespace {

TEST(Legend, EveryLayerHasAnEntryThatFits) {
    Snapshot snapshot = MakeSampleSnapshot(8, 4, "scree");
    snapshot.bodies[9].linearVelocity = {-1.23456e9f, 0};  // the widest numbers
    snapshot.bodies[9].angularVelocity = -1.23456e-9f;
    snapshot.contacts[1].normalImpulses[0] = 1.23456e-9f;
    for (const LayerInfo& info : layerTable) {
        const std::vector<LegendEntry> entries = MakeLegend(snapshot, ParseLayers(info.name), Theme::dark);
        EXPECT_FALSE(entries.empty()) << info.name;
        for (const LegendEntry& entry : entries) {
            EXPECT_FALSE(entry.swatches.empty());
            const int room = GetLegendTextRoom(static_cast<int>(entry.swatches.size())) - 8;
            EXPECT_LE(GetTextWidth(entry.text, 1), room) << entry.text << " touches the next entry";
        }
    }
    EXPECT_TRUE(MakeLegend(snapshot, Layers(), Theme::dark).empty());
}

TEST(Legend, NamesTheLevelsThatAreDrawn) {
    Snapshot snapshot = MakeSampleSnapshot(8, 4, "scree");
    const int height = snapshot.treeHeight = 17;
    const std::vector<Color> cycle(GetTheme(Theme::dark).cycle.begin(), GetTheme(Theme::dark).cycle.end());
    const auto entry = [&](const std::string& nodes) {
        return MakeLegend(snapshot, ParseLayers("bvh"), Theme::dark, std::nullopt, ParseNodeSelection(nodes)).front();
    };
    EXPECT_EQ(entry("level=1").text, "level 1");
    EXPECT_EQ(entry("level=1").swatches, std::vector<Color>{cycle[1]});
    EXPECT_EQ(entry("levels=1..2").text, "levels 1–2");
    EXPECT_EQ(entry("levels=1..2").swatches, (std::vector<Color>{cycle[1], cycle[2]}));
    EXPECT_EQ(entry("levels=0..900").text, fmt::format("levels 0–{}", height));
    EXPECT_EQ(entry("all").text, fmt::format("levels 0–{}", height));
}

TEST(Legend, HeightDependsOnTheLayersAlone) {
    const Snapshot snapshot = MakeSampleSnapshot(8, 4, "scree");
    for (const char* layers : {"bodies", "bodies,contacts,normals,impulses,velocities,bvh,joints,aabbs", "labels"}) {
        for (const int width : {64, 320, 640, 1920}) {
            Image image(width, 400, {1, 2, 3, 255});
            DrawLegend(image, MakeLegend(snapshot, ParseLayers(layers), Theme::dark), Theme::dark);
            int top = 0;
            while (top < 400 && image.At(0, top) == Color{1, 2, 3, 255}) ++top;
            EXPECT_EQ(400 - top, GetLegendHeight(ParseLayers(layers), width)) << layers << " " << width;
        }
    }
    EXPECT_EQ(GetLegendHeight(Layers(), 640), 0);
}

TEST(Legend, SwatchesShowTheColoursOfTheTheme) {
    const Snapshot snapshot = MakeSampleSnapshot(8, 4, "scree");
    for (const Theme theme : {Theme::dark, Theme::light}) {
        Image image(640, 400, {1, 2, 3, 255});
        DrawLegend(image, MakeLegend(snapshot, ParseLayers("islands,contacts"), theme), theme);
        for (const Color& color : GetTheme(theme).cycle) {
            EXPECT_NE(std::find(image.pixels.begin(), image.pixels.end(), color), image.pixels.end());
        }
        EXPECT_NE(std::find(image.pixels.begin(), image.pixels.end(), GetTheme(theme).contact), image.pixels.end());
    }
}

}  // namespace
}  // namespace testbed
