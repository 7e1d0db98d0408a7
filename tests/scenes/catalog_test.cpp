// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The catalogue: its rows are complete, look-up names what is nearest, and illegal input is refused with the cure in
// the message.

#include "scenes/catalog.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace {

using scenes::SceneInfo;

// The message of the Exception that `call` throws; fails the test if it throws nothing or something else.
template <typename Exception, typename Call>
std::string MessageOf(Call call) {
    try {
        call();
    } catch (const Exception& error) {
        return error.what();
    } catch (...) {
        ADD_FAILURE() << "another type of exception";
        return {};
    }
    ADD_FAILURE() << "no exception";
    return {};
}

TEST(Catalog, HoldsTheWholeSuite) {
    std::set<std::string_view> names;
    for (const SceneInfo& info : scenes::Catalog()) names.insert(info.name);
    const std::set<std::string_view> suite = {"falling-squares",
                                              "falling-circles",
                                              "tumbler",
                                              "add-pair",
                                              "add-pair-400",
                                              "mild-n2",
                                              "n2",
                                              "multi-fixture",
                                              "mostly-static-single",
                                              "mostly-static-multi",
                                              "diagonal",
                                              "mixed",
                                              "big-mobile",
                                              "slow-explosion",
                                              "tiles"};
    for (std::string_view name : suite) EXPECT_TRUE(names.contains(name)) << name;
    EXPECT_EQ(names.size(), scenes::Catalog().size()) << "a name occurs twice";
    for (const SceneInfo& info : scenes::Catalog()) {
        EXPECT_EQ(info.isClassic, !suite.contains(info.name)) << info.name;
    }
}

TEST(Catalog, HoldsTheClassics) {
    for (std::string_view name : {"pyramid",
                                  "box-stack",
                                  "domino-row",
                                  "bridge",
                                  "chain-heavy-end",
                                  "cantilever",
                                  "car",
                                  "ragdolls",
                                  "conveyor",
                                  "pulley",
                                  "gears",
                                  "slider-crank",
                                  "web",
                                  "character-corner-cases",
                                  "sensors",
                                  "ray-cast-playground",
                                  "restitution-row",
                                  "friction-row",
                                  "platformer",
                                  "cars",
                                  "bin",
                                  "bullets",
                                  "joint-distance",
                                  "joint-friction",
                                  "joint-gear",
                                  "joint-motor",
                                  "joint-mouse",
                                  "joint-prismatic",
                                  "joint-pulley",
                                  "joint-revolute",
                                  "joint-weld",
                                  "joint-wheel"}) {
        ASSERT_NE(scenes::Find(name), nullptr) << name;
        EXPECT_TRUE(scenes::Find(name)->isClassic) << name;
    }
}

TEST(Catalog, RowsAreComplete) {
    for (const SceneInfo& info : scenes::Catalog()) {
        SCOPED_TRACE(info.name);
        EXPECT_EQ(info.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), std::string_view::npos);
        EXPECT_FALSE(info.title.empty());
        EXPECT_FALSE(info.exercises.empty());
        EXPECT_FALSE(info.folder.empty());
        EXPECT_GE(info.minSize, 1);
        EXPECT_LE(info.minSize, info.defaultSize);
        EXPECT_LE(info.defaultSize, info.maxSize);
        EXPECT_GE(info.showStep, 1);
        EXPECT_LE(info.showStep, info.steps);
        EXPECT_NE(info.build, nullptr);
        if (!info.hasSize) {
            EXPECT_EQ(info.minSize, info.maxSize);
            EXPECT_FALSE(info.sweep.has_value());
        }
        if (info.sweep) {
            EXPECT_GE(info.sweep->begin, info.minSize);
            EXPECT_LT(info.sweep->end, info.maxSize) << "sizes above the sweep are legal";
            EXPECT_EQ((info.sweep->end - info.sweep->begin) % info.sweep->increment, 0)
                << "the end is a size of the sweep";
        }
    }
}

TEST(Catalog, StepsOfTheSuite) {
    const std::pair<std::string_view, int> steps[] = {{"falling-squares", 1300},
                                                      {"falling-circles", 1300},
                                                      {"tumbler", 1500},
                                                      {"add-pair", 1000},
                                                      {"add-pair-400", 100},
                                                      {"mild-n2", 100},
                                                      {"n2", 100},
                                                      {"multi-fixture", 500},
                                                      {"mostly-static-single", 400},
                                                      {"mostly-static-multi", 500},
                                                      {"diagonal", 1000},
                                                      {"mixed", 400},
                                                      {"big-mobile", 1000},
                                                      {"slow-explosion", 1000},
                                                      {"tiles", 100}};
    for (const auto& [name, count] : steps) EXPECT_EQ(scenes::Build(name).steps, count) << name;
    EXPECT_EQ(scenes::Find("tiles")->showStep, 90);
    EXPECT_EQ(scenes::Find("add-pair-400")->showStep, 20);
}

TEST(Catalog, FindsExactNamesOnly) {
    ASSERT_NE(scenes::Find("tiles"), nullptr);
    EXPECT_EQ(scenes::Find("tiles")->name, "tiles");
    EXPECT_EQ(scenes::Find("Tiles"), nullptr);
    EXPECT_EQ(scenes::Find("tile"), nullptr);
    EXPECT_EQ(scenes::Find(""), nullptr);
}

TEST(Catalog, NearestNamesByEditDistance) {
    EXPECT_EQ(scenes::NearestNames("tyles").front(), "tiles");
    EXPECT_EQ(scenes::NearestNames("falling-square").front(), "falling-squares");
    EXPECT_EQ(scenes::NearestNames("add-pair-40").front(), "add-pair-400");
    EXPECT_EQ(scenes::NearestNames("bigmobile").front(), "big-mobile");
    EXPECT_EQ(scenes::NearestNames("n").front(), "n2");
    for (const SceneInfo& info : scenes::Catalog()) EXPECT_EQ(scenes::NearestNames(info.name).front(), info.name);
    EXPECT_EQ(scenes::NearestNames("tiles", 0).size(), 0u);
    EXPECT_LT(scenes::NearestNames("tiles", 1000).size(), scenes::Catalog().size()) << "some are too far off";
    EXPECT_TRUE(scenes::NearestNames("quartz").empty());
    EXPECT_TRUE(scenes::NearestNames("").empty());
}

TEST(Catalog, UnknownNameIsRefusedWithTheNearest) {
    const std::string message = MessageOf<std::invalid_argument>([] { (void)scenes::Build("tyles"); });
    EXPECT_NE(message.find("'tyles'"), std::string::npos) << message;
    EXPECT_NE(message.find("nearest: tiles"), std::string::npos) << message;
    (void)MessageOf<std::invalid_argument>([] { (void)scenes::Build("tyles", 10); });
}

TEST(Catalog, IllegalSizesAreRefusedWithTheRange) {
    for (const SceneInfo& info : scenes::Catalog()) {
        for (int size : {info.minSize - 1, info.maxSize + 1, -1, 2147483647, -2147483647 - 1}) {
            const std::string message = MessageOf<std::out_of_range>([&] { (void)scenes::Build(info.name, size); });
            EXPECT_NE(message.find(info.name), std::string::npos) << message;
            EXPECT_NE(message.find(std::to_string(size)), std::string::npos) << message;
            const std::string range = info.hasSize
                                          ? std::to_string(info.minSize) + " to " + std::to_string(info.maxSize)
                                          : "always " + std::to_string(info.defaultSize);
            EXPECT_NE(message.find(range), std::string::npos) << message;
        }
    }
}

TEST(Catalog, TableNeedsNoStaticInitialisation) {
    // A row that is trivially destructible and built from literals is constant-initialised: no order can go wrong.
    EXPECT_TRUE(std::is_trivially_destructible_v<SceneInfo>);
}

TEST(Catalog, BuildFillsInTheHeader) {
    for (const SceneInfo& info : scenes::Catalog()) {
        const scenes::Scene scene = scenes::Build(info.name);
        EXPECT_EQ(scene.name, info.name);
        EXPECT_EQ(scene.size, info.defaultSize);
        EXPECT_EQ(scene.steps, info.steps);
        EXPECT_EQ(scene.showStep, info.showStep);
        EXPECT_EQ(scene.timeStep, 1.0f / 60.0f);
        EXPECT_EQ(scene.velocityIterations, 8);
        EXPECT_EQ(scene.positionIterations, 3);
    }
}

}  // namespace
