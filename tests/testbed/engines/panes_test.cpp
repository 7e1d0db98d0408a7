// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Panes: the list that --engines takes, which settings reach which pane, names, and the baseline.

#include "testbed/engines/panes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "scenes/catalog.h"
#include "testbed/base/errors.h"
#include "testbed/engines/side_by_side.h"

namespace testbed {
namespace {

std::vector<std::string> NamesOf(const std::vector<Pane>& panes) {
    std::vector<std::string> names;
    for (const Pane& pane : panes) names.push_back(pane.name);
    return names;
}

std::vector<TypedSetting> Typed(const std::vector<std::string>& settings) {
    std::vector<TypedSetting> typed;
    for (const std::string& setting : settings) typed.push_back({setting, "--set " + setting});
    return typed;
}

TEST(Panes, OneEngineUnderTwoSettings) {
    const std::vector<Pane> panes = ParsePanes("scree,scree:solver=soft@8:threads=2,box2d");
    EXPECT_EQ(NamesOf(panes), (std::vector<std::string>{"scree", "scree-soft-8-threads-2", "box2d"}));
    EXPECT_EQ(panes[0].spec, MakeSpec("scree"));
    EXPECT_EQ(PrintSettings(panes[1].spec), "solver=soft@8 threads=2");
    EXPECT_EQ(panes[2].spec, MakeSpec("box2d"));
}

TEST(Panes, ANumberAfterACommaContinuesAValue) {
    const std::vector<Pane> panes =
        ParsePanes("scree:gravity=0,-20,box2d,b=box2d:iterations=4,2:gravity=1,.5:sleeping=off,scree");
    EXPECT_EQ(NamesOf(panes), (std::vector<std::string>{"scree-gravity-0--20", "box2d", "b", "scree"}));
    EXPECT_EQ(PrintSettings(panes[0].spec), "gravity=0/-20");
    EXPECT_EQ(PrintSettings(panes[1].spec), "");
    EXPECT_EQ(PrintSettings(panes[2].spec), "solver=si@4/2 gravity=1/0.5 sleeping=off");
    for (const char* text :
         {"-20,scree", "scree,4", "scree:gravity=0,-20,3", "scree:threads=2,2", "scree,4:threads=2"}) {
        EXPECT_THROW((void)ParsePanes(text), UsageError) << text;
    }
}

TEST(Panes, KeepTheOrderAndTakeNames) {
    EXPECT_EQ(NamesOf(ParsePanes("box2d,scree")), (std::vector<std::string>{"box2d", "scree"}));
    EXPECT_EQ(NamesOf(ParsePanes("scree:solver=soft@8,box2d")), (std::vector<std::string>{"scree", "box2d"}))
        << "nothing to tell apart";
    EXPECT_EQ(NamesOf(ParsePanes("a=scree,b=scree,box2d:solver=si@4/2")),
              (std::vector<std::string>{"a", "b", "box2d"}));
    EXPECT_EQ(NamesOf(ParsePanes("scree,scree,scree:threads=2,scree:threads=2")),
              (std::vector<std::string>{"scree", "scree-2", "scree-threads-2", "scree-threads-2-2"}));
}

TEST(Panes, SettingsComeFromTheBaseThenFromAllThenFromThePane) {
    const std::vector<Pane> panes =
        ParsePanes("scree,scree:solver=soft@8,box2d", Typed({"solver=soft@2", "continuous=on"}), comparisonBase);
    EXPECT_EQ(PrintSettings(panes[0].spec), "solver=soft@2 caps=on");
    EXPECT_EQ(PrintSettings(panes[1].spec), "solver=soft@8 caps=on");
    EXPECT_EQ(PrintSettings(panes[2].spec), "") << "Box2D has no soft step: its own settings stay";
    EXPECT_EQ(ParseSpec("scree", Typed({"threads=2"}), comparisonBase).threads, 2);
}

TEST(Panes, WhatCannotBeMeantIsRefused) {
    for (const char* text : {"", ",", "scree,", ",scree", "box3d", "a=scree,a=box2d", "scree,scree=box2d", "=scree",
                             "a/b=scree", ".a=scree", "scree:", "scree:solver", "scree:solver=", "scree:sovler=soft",
                             "box2d:solver=soft@8", "box2d:threads=2"}) {
        EXPECT_THROW((void)ParsePanes(text), UsageError) << text;
    }
    EXPECT_THROW((void)ParsePanes("box2d", Typed({"threads=2"})), UsageError) << "no pane has it";
    EXPECT_NO_THROW((void)ParsePanes("box2d", {}, "threads=2"));
    const TypedSetting option{"threads=2", "--threads 2", true};
    EXPECT_NO_THROW((void)ParsePanes("box2d", std::span(&option, 1))) << "options of before are left out";
    EXPECT_THROW((void)ParseSpec("box2d", Typed({"solver=soft"})), UsageError);
    std::string many = "scree";
    for (int i = 0; i < 16; ++i) many += ",p" + std::to_string(i) + "=scree";
    EXPECT_THROW((void)ParsePanes(many), UsageError);
}

TEST(Panes, TheBaselineIsNamedOrBox2d) {
    const std::vector<Pane> panes = ParsePanes("scree,fine=scree:accuracy=fine,box2d");
    EXPECT_EQ(FindBaseline(panes), 2u);
    EXPECT_EQ(FindBaseline(panes, "fine"), 1u);
    for (const std::size_t place : {0u, 1u, 2u}) {
        std::vector<Pane> others = ParsePanes("scree,a=scree:accuracy=fine,b=scree:accuracy=precise");
        others[place].spec.engine = "box2d3";
        EXPECT_EQ(FindBaseline(others), place);
        others.push_back(panes[2]);
        EXPECT_EQ(FindBaseline(others), 3u) << "2.4 before 3";
    }
    EXPECT_EQ(FindBaseline(ParsePanes("fine=scree:accuracy=fine,scree")), 0u);
    try {
        (void)FindBaseline(panes, "fien");
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_NE(std::string(error.what()).find("did you mean 'fine'"), std::string::npos) << error.what();
    }
}

TEST(SideBySide, APaneIsTheSameAloneAndBesideOthers) {
    const scenes::Scene scene = scenes::Build("pyramid", 5);
    const std::vector<Pane> all = ParsePanes("scree,scree:solver=soft@8,box2d,loose=scree:warmStarting=off");
    SideBySide together(scene, {.panes = all});
    for (int i = 0; i < 20; ++i) together.Step();
    const std::vector<Snapshot> snapshots = together.Capture();
    ASSERT_EQ(snapshots.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        SideBySide alone(scene, {.panes = {all[i]}});
        for (int step = 0; step < 20; ++step) alone.Step();
        EXPECT_EQ(alone.Capture().front().stateHash, snapshots[i].stateHash) << all[i].name;
        EXPECT_EQ(snapshots[i].GetName(), all[i].name);
        EXPECT_EQ(snapshots[i].settings, PrintSettings(all[i].spec));
        EXPECT_EQ(together.GetTiming()[i].pane, all[i].name);
        EXPECT_EQ(together.GetTiming()[i].steps.size(), 20u);
        for (std::size_t j = 0; j < i; ++j) EXPECT_NE(snapshots[i].stateHash, snapshots[j].stateHash);
    }
}

TEST(SideBySide, AllPanesFollowOneMotion) {
    const scenes::Scene scene = scenes::Build("pyramid", 5);
    Panes panes{.panes = ParsePanes("scree,scree:broadPhase=unified,box2d")};
    panes.source = panes.panes[0].spec;
    SideBySide runs(scene, panes);
    for (int i = 0; i < 10; ++i) runs.Step();
    const std::vector<Snapshot> snapshots = runs.Capture();
    EXPECT_EQ(snapshots[1].stateHash, snapshots[0].stateHash);
    EXPECT_EQ(snapshots[2].stateHash, snapshots[0].stateHash);
    EXPECT_EQ(snapshots[1].broadPhase, "unified");
}

}  // namespace
}  // namespace testbed
