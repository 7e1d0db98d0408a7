// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The table of layers: complete, in the order of the enumeration, and every name leads to its layer and back.

#include "testbed/view/layers.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

namespace testbed {
namespace {

TEST(Layers, TheTableHasEveryLayerOnce) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < layerTable.size(); ++i) {
        EXPECT_EQ(static_cast<std::size_t>(layerTable[i].layer), i);
        names.insert(layerTable[i].name);
    }
    EXPECT_EQ(names.size(), layerTable.size());
    EXPECT_EQ(static_cast<std::size_t>(Layer::labels) + 1, layerCount) << "labels is the last of the enumeration";
}

TEST(Layers, EveryNameSetsItsLayerAlone) {
    for (const LayerInfo& info : layerTable) {
        const Layers layers = ParseLayers(info.name);
        for (const LayerInfo& other : layerTable) EXPECT_EQ(layers.Has(other.layer), &other == &info);
        EXPECT_EQ(GetLayerNames(layers), info.name);
    }
}

TEST(Layers, ListsAreReadInAnyOrderAndWrittenInTheTables) {
    const Layers layers = ParseLayers("labels,bodies,aabbs-swept,bodies");
    EXPECT_EQ(GetLayerNames(layers), "bodies,aabbs-swept,labels");
    EXPECT_EQ(ParseLayers(GetLayerNames(layers)), layers);
    Layers some = layers;
    some.Set(Layer::swept, false);
    EXPECT_EQ(GetLayerNames(some), "bodies,labels");
}

TEST(Layers, UnknownNamesAreRefusedWithTheKnownOnes) {
    for (const char* bad : {"", "body", "bodies,", ",bodies", "bodies contacts"}) {
        EXPECT_THROW((void)ParseLayers(bad), std::invalid_argument) << bad;
    }
    try {
        (void)ParseLayers("swept");
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("aabbs-swept"), std::string::npos);
    }
}

}  // namespace
}  // namespace testbed
