// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// --set and --engines on the command line: one vocabulary in every command that runs a scene, old options as other
// spellings of it. Also one engine under two settings, and what of it stands in the files.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "testbed/jobs/bench/row.h"
#include "testbed/picture/png.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

using nlohmann::json;

/// Each up to where --set may follow; nothing of it takes long.
constexpr const char* commands[] = {"overlap tiles --size 5 --step 2 --image 320x200",
                                    "render tiles --size 5 --step 2 --image 320x200",
                                    "metrics tiles --size 5 --steps 2",
                                    "find tiles --size 5 --steps 2",
                                    "timeline tiles --size 5 --steps 2 -o page.html",
                                    "convert tiles tiles.track --size 5 --steps 2",
                                    "bench n2 --sizes 5 --steps 2",
                                    "view tiles --size 5 --offscreen --frames 1",
                                    "snapshot check -g '^tiles/'",
                                    "tradeoff --quick -g '^free-spin$'",
                                    "extremes --quick -g '^dt-1-30$'",
                                    "requires n2 5 --quick --steps 2"};

TEST(Settings, EveryCommandNamesTheNearestKey) {
    const ScratchFolder folder;
    for (const char* command : commands) {
        const ProgramResult wrong = folder.Run(std::string(command) + " --set warmStrating=off");
        EXPECT_EQ(wrong.exitCode, 2) << command << wrong.output;
        EXPECT_NE(wrong.output.find("did you mean 'warmStarting'"), std::string::npos) << command << wrong.output;
        const ProgramResult value = folder.Run(std::string(command) + " --set timeStep=soon");
        EXPECT_EQ(value.exitCode, 2) << command << value.output;
        EXPECT_NE(value.output.find("--set timeStep=soon: timeStep takes"), std::string::npos) << value.output;
        const std::string help = folder.Run(std::string(command) + " --help").output;
        EXPECT_NE(help.find("warmStarting"), std::string::npos) << command;
        // The options of single keys are read by the same parser.
        for (const auto& [option, message] :
             {std::pair("--iterations 4", "--iterations 4: iterations takes"),
              {"--substeps 4,2", "--substeps 4,2: substeps takes"},
              {"--accuracy fein", "--accuracy fein: unknown mark 'fein'; did you mean 'fine'?"},
              {"--tolerance big", "--tolerance big: tolerance takes"},
              {"--set gravity=0,-20,1", "--set gravity=0,-20,1: gravity takes"}}) {
            const ProgramResult refused = folder.Run(std::string(command) + " " + option);
            EXPECT_EQ(refused.exitCode, 2) << command << option << refused.output;
            EXPECT_NE(refused.output.find(message), std::string::npos) << command << refused.output;
        }
    }
}

std::string HashOf(const ScratchFolder& folder, const std::string& arguments) {
    const ProgramResult result =
        folder.Run("metrics pyramid --size 5 --steps 30:30 " + arguments +
                   (arguments.find("--engines") == std::string::npos ? " --engines scree" : "") + " -o m");
    EXPECT_EQ(result.exitCode, 0) << arguments << result.output;
    return json::parse(folder.Read("m/pyramid/metrics.json"))["rows"][0]["state_hash"];
}

TEST(Settings, OldOptionsAreOtherSpellings) {
    const ScratchFolder folder;
    const std::string plain = HashOf(folder, "");
    EXPECT_EQ(HashOf(folder, "--set preset=like-box2d"), plain);
    EXPECT_EQ(HashOf(folder, "--threads 2 --broad-phase unified"),
              HashOf(folder, "--set threads=2 --set broadPhase=unified"));
    EXPECT_NE(HashOf(folder, "--set solver=soft@8"), plain);
    EXPECT_EQ(HashOf(folder, "--set substeps=8 --set solver=si"), plain) << "the last one counts";
    EXPECT_EQ(HashOf(folder, "--set accuracy=game"), HashOf(folder, "--set solver=soft"));
    EXPECT_NE(HashOf(folder, "--iterations 4,2"), plain);
    for (const auto& [option, setting] : {std::pair("--iterations 4,2", "--set iterations=4/2"),
                                          {"--substeps 8", "--set substeps=8"},
                                          {"--accuracy fine", "--set accuracy=fine"},
                                          {"--tolerance 0.02", "--set tolerance=0.02"},
                                          {"--set gravity=0,-20", "--set gravity=0/-20"},
                                          {"--set gravity=0,-20 --set timeStep=1/120 --substeps 8",
                                           "--engines scree:gravity=0,-20:timeStep=1/120:substeps=8"},
                                          {"--substeps 8 --set solver=si@4/2", "--iterations 4,2"},
                                          {"--set solver=si@4/2 --substeps 8", "--substeps 8"}}) {
        EXPECT_EQ(HashOf(folder, option), HashOf(folder, setting)) << option;
    }
    const ProgramResult none = folder.Run("metrics pyramid --size 5 --steps 1 --engines box2d --accuracy fine -o m");
    EXPECT_EQ(none.exitCode, 2);
    EXPECT_NE(none.output.find("--accuracy fine: none of the engines of this run"), std::string::npos) << none.output;
    EXPECT_EQ(
        folder.Run("metrics pyramid --size 5 --steps 1 --engines scree --threads 2 --set threads=3 -o m").exitCode, 0);
    EXPECT_EQ(json::parse(folder.Read("m/pyramid/metrics.json"))["rows"][0]["threads"], 3) << "--set counts after";
}

TEST(Settings, OneEngineUnderTwoSettingsHasAPaneEach) {
    const ScratchFolder folder;
    const ProgramResult result = folder.Run(
        "overlap pyramid --size 5 --step 30 --image 320x200 --engines scree,scree:solver=soft@8,box2d "
        "--set sleeping=off");
    ASSERT_EQ(result.exitCode, 0) << result.output;
    const std::string step = "out/pyramid/step-0030/";
    for (const char* name :
         {"scree", "scree-soft-8", "box2d", "compare", "difference-scree", "difference-scree-soft-8"}) {
        EXPECT_TRUE(folder.Has(step + name + ".png")) << name;
        EXPECT_TRUE(folder.Has(step + name + ".json")) << name;
    }
    EXPECT_FALSE(folder.Has(step + "difference.png"));
    EXPECT_FALSE(folder.Has(step + "difference-box2d.png")) << "the baseline is not compared with itself";
    const json rows = json::parse(folder.Read("out/pyramid/metrics.json"))["rows"];
    ASSERT_EQ(rows.size(), 3u);
    std::map<std::string, std::string> settings, hashes;
    for (const json& row : rows) {
        const std::string pane = row["pane"];
        settings[pane] = row["settings"];
        hashes[row["state_hash"]] = pane;
        const json sidecar = json::parse(folder.Read(step + pane + ".json"));
        EXPECT_EQ(sidecar["engines"][0]["pane"], pane);
        EXPECT_EQ(sidecar["engines"][0]["settings"], settings[pane]);
    }
    EXPECT_EQ(hashes.size(), 3u) << "three motions";
    EXPECT_EQ(settings["scree"], "preset=like-box2d sleeping=off");
    EXPECT_EQ(settings["scree-soft-8"], "preset=like-box2d solver=soft@8 sleeping=off");
    EXPECT_NE(result.output.find("box2d/scree-soft-8"), std::string::npos) << result.output;
    EXPECT_NE(result.output.find("settings: scree preset=like-box2d sleeping=off; "), std::string::npos)
        << result.output;
    EXPECT_NE(folder.Read("out/pyramid/timing.csv").find("\nscree-soft-8,1,"), std::string::npos);
    // All panes as one picture, three side by side at a third of the width.
    EXPECT_EQ(ReadPng(folder.GetPath() / (step + "compare.png")).width, 320);
}

TEST(Settings, TheBaselineIsWhatOthersAreComparedWith) {
    const ScratchFolder folder;
    const std::string command = "metrics pyramid --size 5 --steps 3 --engines scree,fine=scree:accuracy=fine,box2d ";
    EXPECT_NE(folder.Run(command).output.find("box2d/fine"), std::string::npos);
    EXPECT_NE(folder.Run(command + "--baseline fine").output.find("fine/box2d"), std::string::npos);
    const ProgramResult wrong = folder.Run(command + "--baseline fien");
    EXPECT_EQ(wrong.exitCode, 2);
    EXPECT_NE(wrong.output.find("did you mean 'fine'"), std::string::npos) << wrong.output;
}

TEST(Settings, RenderHasAPicturePerPane) {
    const ScratchFolder folder;
    ASSERT_EQ(folder.Run("render pyramid --size 5 --step 30 --image 320x200 --engines scree,loose=scree:iterations=1/1")
                  .exitCode,
              0);
    const Image first = ReadPng(folder.GetPath() / "out/pyramid/step-0030/render-scree.png");
    const Image second = ReadPng(folder.GetPath() / "out/pyramid/step-0030/render-loose.png");
    EXPECT_FALSE(first.pixels == second.pixels);
}

TEST(Settings, BenchRunsPanesOnceEachAndComparesWithTheBaseline) {
    const ScratchFolder folder;
    const ProgramResult result = folder.Run(
        "bench n2 --sizes 25 --steps 20 --engines scree,keen=scree:solver=soft@8:continuous=on --solver si "
        "--baseline scree --json rows.json");
    ASSERT_EQ(result.exitCode, 0) << result.output;
    const std::vector<BenchRow> rows = ReadBenchRows("rows.json", folder.Read("rows.json"));
    ASSERT_EQ(rows.size(), 2u) << "a pane with a solver of its own is not run under others";
    EXPECT_EQ(rows[0].pane, "scree");
    EXPECT_EQ(rows[0].solver, "si");
    EXPECT_EQ(rows[1].pane, "keen");
    EXPECT_EQ(rows[1].solver, "soft@8");
    EXPECT_EQ(rows[1].settings, "solver=soft@8 caps=on");
    EXPECT_EQ(rows[1].baseline, "scree");
    EXPECT_NEAR(rows[1].ratio, rows[0].totalMs / rows[1].totalMs, 1e-9);
    // A list of solvers makes a row each, of the engines that have them.
    ASSERT_EQ(
        folder.Run("bench n2 --sizes 25 --steps 2 --solver si,soft,soft@8 --threads 1,2 --json more.json").exitCode, 0);
    EXPECT_EQ(ReadBenchRows("more.json", folder.Read("more.json")).size(), 3u * 2u + 1u);
}

TEST(Settings, ASnapshotCheckTellsWhatASettingChanges) {
    const ScratchFolder folder;
    const std::string references = std::string(" --references ") + SCREE_REFERENCE_FOLDER;
    const std::string check = "snapshot check -g '^pyramid/'" + references;
    EXPECT_EQ(folder.Run(check + " --set threads=2").exitCode, 0);
    const ProgramResult changed = folder.Run(check + " --set iterations=1/0");
    EXPECT_EQ(changed.exitCode, 1);
    EXPECT_EQ(changed.output.find("to accept:"), std::string::npos) << changed.output;
    EXPECT_NE(changed.output.find("nothing of it is to be accepted"), std::string::npos) << changed.output;
    EXPECT_EQ(folder.Run("snapshot update -g '^pyramid/' --set iterations=1/0" + references).exitCode, 2)
        << "references are made with one preset";
}

TEST(Settings, TheWindowShowsPanesUnderTheirSettings) {
    const ScratchFolder folder;
    const ProgramResult result = folder.Run(
        "view pyramid --size 4 --engines scree,scree:solver=soft@8 --set sleeping=off --offscreen --no-times --frames "
        "20 "
        "--dump-state state.json");
    ASSERT_EQ(result.exitCode, 0) << result.output;
    const json state = json::parse(folder.Read("state.json"));
    ASSERT_EQ(state["engines"].size(), 2u);
    EXPECT_EQ(state["engines"][1]["pane"], "scree-soft-8");
    EXPECT_EQ(state["engines"][1]["settings"], "preset=like-box2d solver=soft@8 sleeping=off");
    EXPECT_NE(state["engines"][0]["state_hash"], state["engines"][1]["state_hash"]);
}

TEST(Settings, JobsWithGridsTakeThem) {
    const ScratchFolder folder;
    const ProgramResult trade = folder.Run(
        "tradeoff --quick -g '^free-spin$' --engines scree:accuracy=fine --set sleeping=on -o t --json t.jsonl");
    ASSERT_EQ(trade.exitCode, 0) << trade.output;
    EXPECT_NE(trade.output.find("2 cases: 1 laws, 2 settings"), std::string::npos) << trade.output;
    EXPECT_NE(folder.Read("t.jsonl").find("\"settings\":\"accuracy=fine timeStep=1/60 caps=on\""), std::string::npos)
        << folder.Read("t.jsonl");
    const ProgramResult extremes = folder.Run(
        "extremes --quick -g '^dt-1-30$' --engines scree:solver=soft@8,keen=scree:accuracy=precise --set "
        "warmStarting=off "
        "-o e");
    EXPECT_NE(extremes.output.find("2 runs: 1 cases, 2 settings"), std::string::npos) << extremes.output;
    const std::string cases = folder.Read("e/cases.csv");
    EXPECT_NE(cases.find("scree soft 8"), std::string::npos) << cases;
    EXPECT_NE(cases.find("scree keen"), std::string::npos) << cases;
    const ProgramResult requirement = folder.Run("requires box-stack 2 --quick --steps 5 --set caps=on");
    EXPECT_EQ(requirement.exitCode, 0) << requirement.output;
    EXPECT_NE(requirement.output.find("speedLimit"), std::string::npos) << requirement.output;
    EXPECT_LT(requirement.output.find("speedLimit"), requirement.output.find("does without")) << "it is required";
    EXPECT_EQ(folder.Run("requires box-stack 2 --set features=full").exitCode, 2);
    const ProgramResult report =
        folder.Run("requires box-stack 2 --ablation --quick --steps 2 --substeps 4 -o r --markdown r.md");
    EXPECT_EQ(report.exitCode, 0) << report.output;
    const std::string page = folder.Read("r.md");
    for (const char* part : {"- compiler: ", "- settings: solver=soft@4", "| box-stack | 2 |", "| friction | own |"}) {
        EXPECT_NE(page.find(part), std::string::npos) << part << "\n" << page;
    }
}

}  // namespace
}  // namespace testbed
