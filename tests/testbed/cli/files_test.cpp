// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the commands write: the promised files, numbers that agree with each other, and nothing that tells where or when
// they were made. Small scenes and pictures.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

#include "testbed/base/errors.h"
#include "testbed/engines/engine_list.h"
#include "testbed/picture/png.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

using nlohmann::json;

long CountLines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

TEST(OverlapFiles, AreThosePromisedForOneStep) {
    const ScratchFolder folder;
    const ProgramResult result = folder.Run("overlap tiles --size 6 --step 12 --image 320x200");
    ASSERT_EQ(result.exitCode, 0) << result.output;
    const std::string step = "out/tiles/step-0012/";
    EXPECT_EQ(FilesBelow(folder.GetPath()),
              (std::set<std::string>{step + "scree.png", step + "scree.json", step + "box2d.png", step + "box2d.json",
                                     step + "compare.png", step + "compare.json", step + "difference.png",
                                     step + "difference.json", "out/tiles/metrics.csv", "out/tiles/metrics.json",
                                     "out/tiles/timing.csv", "out/tiles/timing.png"}));
    const Image pane = ReadPng(folder.GetPath() / step / "scree.png");
    EXPECT_EQ(pane.width, 320);
    EXPECT_EQ(pane.height, 200);
    EXPECT_EQ(CountLines(folder.Read("out/tiles/metrics.csv")), 1 + 2) << "a header, a row per engine";
    EXPECT_EQ(CountLines(folder.Read("out/tiles/timing.csv")), 1 + 2 * 100) << "steps 1 to 100 of both engines";
    for (const char* word : {"sibling overlap", "peak contacts", "sum 70-100", "out/tiles/step-0012/compare.png"}) {
        EXPECT_NE(result.output.find(word), std::string::npos) << result.output;
    }
}

TEST(OverlapFiles, SidecarAndMetricsTellTheSame) {
    const ScratchFolder folder;
    ASSERT_EQ(folder
                  .Run("overlap tiles --size 6 --step 5 --image 320x200 --backend cpu --nodes all --style heat "
                       "--broad-phase unified --query-size 0.5 -o result")
                  .exitCode,
              0);
    const json metrics = json::parse(folder.Read("result/tiles/metrics.json"));
    EXPECT_EQ(metrics["schema"], 1);
    EXPECT_EQ(metrics["scene"], "tiles");
    EXPECT_EQ(metrics["size"], 6);
    ASSERT_EQ(metrics["rows"].size(), 2u);
    for (const auto& row : metrics["rows"]) {
        const std::string engine = row["engine"];
        const json sidecar = json::parse(folder.Read("result/tiles/step-0005/" + engine + ".json"));
        ASSERT_EQ(sidecar["engines"].size(), 1u);
        const json& pane = sidecar["engines"][0];
        EXPECT_EQ(pane["metrics"], row);
        EXPECT_EQ(pane["overlap"]["max"], row["overlap_max"]);
        EXPECT_EQ(pane["overlap"]["nodes_drawn"], row["nodes"]) << "--nodes all draws every node";
        EXPECT_EQ(sidecar["kind"], "overlap");
        EXPECT_EQ(sidecar["step"], 5);
        EXPECT_EQ(sidecar["nodes"], "all");
        EXPECT_EQ(sidecar["style"], "heat");
        EXPECT_EQ(sidecar["query_size"], 0.5);
        EXPECT_EQ(sidecar["backend"], "cpu");
    }
    EXPECT_EQ(metrics["rows"][0]["broad_phase"], "unified");
}

TEST(OverlapFiles, DoNotTellWhereTheyWereMade) {
    const ScratchFolder folder;
    const std::string place = folder.GetPath().string();
    ASSERT_EQ(folder.Run("overlap tiles --size 5 --step 3 --image 320x200 -o " + place + "/elsewhere").exitCode, 0);
    const std::set<std::string> files = FilesBelow(folder.GetPath());
    EXPECT_EQ(files.size(), 12u);
    for (const std::string& file : files) {
        EXPECT_EQ(folder.Read(file).find(place), std::string::npos) << file;
        EXPECT_EQ(file.find("tmp"), std::string::npos) << file;
    }
    bool found = false;
    for (const PngText& text : ReadPngText(folder.GetPath() / "elsewhere/tiles/step-0003/compare.png")) {
        if (text.key != "Command") continue;
        found = true;
        EXPECT_EQ(text.value, "scree overlap tiles --size 5 --step 3 --image 320x200");
    }
    EXPECT_TRUE(found);
}

TEST(OverlapFiles, OneEngineHasNothingToCompare) {
    const ScratchFolder folder;
    ASSERT_EQ(folder.Run("overlap tiles --size 5 --step 3 --image 320x200 --engines box2d").exitCode, 0);
    EXPECT_TRUE(folder.Has("out/tiles/step-0003/box2d.png"));
    EXPECT_FALSE(folder.Has("out/tiles/step-0003/scree.png"));
    EXPECT_FALSE(folder.Has("out/tiles/step-0003/compare.png"));
    EXPECT_FALSE(folder.Has("out/tiles/step-0003/difference.png"));
}

TEST(OverlapFiles, RangeGivesEveryStepOfIt) {
    const ScratchFolder folder;
    ASSERT_EQ(folder.Run("overlap tiles add-pair-400 --steps 2:8:3 --image 320x200 --backend cpu").exitCode, 0);
    for (const char* scene : {"tiles", "add-pair-400"}) {
        const std::string base = std::string("out/") + scene;
        for (const char* step : {"/step-0002", "/step-0005", "/step-0008"}) EXPECT_TRUE(folder.Has(base + step));
        EXPECT_FALSE(folder.Has(base + "/step-0003"));
        EXPECT_EQ(CountLines(folder.Read(base + "/metrics.csv")), 1 + 2 * 3);
    }
}

TEST(OverlapFiles, WorstByOverlapAreTheRowsWithMostOfIt) {
    const ScratchFolder folder;
    ASSERT_EQ(folder.Run("metrics add-pair-400 --steps 14:26 -o all").exitCode, 0);
    ASSERT_EQ(folder
                  .Run("overlap add-pair-400 --steps 14:26 --worst 3 --worst-by overlap --image 320x200 "
                       "--backend cpu -o worst")
                  .exitCode,
              0);
    const json all = json::parse(folder.Read("all/add-pair-400/metrics.json"));
    std::vector<std::pair<double, int>> ranked;
    for (int step = 14; step <= 26; ++step) {
        double largest = 0;
        for (const auto& row : all["rows"]) {
            if (row["step"] == step) largest = std::max(largest, row["sibling_overlap"].get<double>());
        }
        ranked.emplace_back(-largest, step);
    }
    std::sort(ranked.begin(), ranked.end());
    std::set<int> expected, actual;
    for (int i = 0; i < 3; ++i) expected.insert(ranked[static_cast<std::size_t>(i)].second);
    const json worst = json::parse(folder.Read("worst/add-pair-400/metrics.json"));
    for (const auto& row : worst["rows"]) actual.insert(row["step"].get<int>());
    EXPECT_EQ(actual, expected);
}

TEST(OverlapFiles, WorstByTimeAreTheStepsWithTheLargestTimes) {
    const ScratchFolder folder;
    ASSERT_EQ(folder.Run("overlap add-pair-400 --steps 1:40 --worst 2 --image 320x200 --backend cpu").exitCode, 0);
    // timing.csv: engine,step,broad_phase_ms,…
    std::istringstream lines(folder.Read("out/add-pair-400/timing.csv"));
    std::vector<double> largest(41, 0.0);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        std::istringstream cells(line);
        std::string engine, step, time;
        std::getline(cells, engine, ',');
        std::getline(cells, step, ',');
        std::getline(cells, time, ',');
        if (std::stoul(step) <= 40) largest[std::stoul(step)] = std::max(largest[std::stoul(step)], std::stod(time));
    }
    std::vector<double> sorted = largest;
    std::sort(sorted.rbegin(), sorted.rend());
    for (std::size_t step = 1; step <= 40; ++step) {
        const bool shown = folder.Has("out/add-pair-400/step-00" + std::string(step < 10 ? "0" : "") +
                                      std::to_string(step) + "/compare.png");
        EXPECT_EQ(shown, largest[step] >= sorted[1]) << "step " << step;
    }
}

TEST(OverlapFiles, OneMotionForBothTreesGivesTheSamePoses) {
    const ScratchFolder folder;
    for (const std::string poses : {"scree", "box2d"}) {
        ASSERT_EQ(
            folder.Run("overlap add-pair-400 --step 25 --image 320x200 --backend cpu --poses " + poses + " -o " + poses)
                .exitCode,
            0);
        const json rows = json::parse(folder.Read(poses + "/add-pair-400/metrics.json"))["rows"];
        ASSERT_EQ(rows.size(), 2u);
        EXPECT_EQ(rows[0]["state_hash"], rows[1]["state_hash"]) << poses;
        EXPECT_EQ(rows[0]["pairs_true"], rows[1]["pairs_true"]) << poses;
        EXPECT_NE(rows[0]["overlap_mean"], rows[1]["overlap_mean"]) << "the trees differ";
    }
}

TEST(RenderFiles, OnePerEngineBesideThoseOfOverlap) {
    const ScratchFolder folder;
    const ProgramResult result =
        folder.Run("render tiles --size 5 --step 4 --image 320x200 --layers bodies,aabbs,contacts,bvh,labels");
    ASSERT_EQ(result.exitCode, 0) << result.output;
    const std::string step = "out/tiles/step-0004/";
    EXPECT_EQ(FilesBelow(folder.GetPath()),
              (std::set<std::string>{step + "render-scree.png", step + "render-scree.json", step + "render-box2d.png",
                                     step + "render-box2d.json"}));
    const json sidecar = json::parse(folder.Read(step + "render-scree.json"));
    EXPECT_EQ(sidecar["kind"], "render");
    EXPECT_EQ(sidecar["engines"][0]["bodies"], 1 + 5 * 6 / 2);
}

TEST(MetricsFiles, ARowPerEngineAndStep) {
    const ScratchFolder folder;
    const ProgramResult result = folder.Run("metrics tumbler --size 20 --steps 7");
    ASSERT_EQ(result.exitCode, 0) << result.output;
    EXPECT_EQ(FilesBelow(folder.GetPath()),
              (std::set<std::string>{"out/tumbler/metrics.csv", "out/tumbler/metrics.json"}));
    const json rows = json::parse(folder.Read("out/tumbler/metrics.json"))["rows"];
    ASSERT_EQ(rows.size(), 14u);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i]["step"], 1 + i / 2);
        EXPECT_EQ(rows[i]["engine"], i % 2 == 0 ? "scree" : "box2d");
        EXPECT_EQ(rows[i]["bodies"], 2 + (1 + i / 2)) << "one body enters after each step";
    }
}

TEST(MetricsFiles, TwoRunsDifferOnlyInTimes) {
    const ScratchFolder folder;
    ASSERT_EQ(folder.Run("metrics add-pair-400 --steps 20:30:5 -o first").exitCode, 0);
    ASSERT_EQ(folder.Run("metrics add-pair-400 --steps 20:30:5 -o second").exitCode, 0);
    json first = json::parse(folder.Read("first/add-pair-400/metrics.json"));
    json second = json::parse(folder.Read("second/add-pair-400/metrics.json"));
    for (json* file : {&first, &second}) {
        for (json& row : (*file)["rows"]) {
            for (const char* column : {"broad_phase_ms", "narrow_phase_ms", "solver_ms", "step_ms"}) row.erase(column);
        }
    }
    EXPECT_EQ(first, second);
}

TEST(ListOutput, JsonHoldsEverySceneWithItsSizes) {
    const ScratchFolder folder;
    const ProgramResult result = folder.Run("list --json");
    ASSERT_EQ(result.exitCode, 0);
    const json list = json::parse(result.output);
    EXPECT_GE(list["scenes"].size(), 15u);
    for (const auto& scene : list["scenes"]) {
        EXPECT_LE(scene["min_size"], scene["default_size"]);
        EXPECT_LE(scene["default_size"], scene["max_size"]);
        EXPECT_LE(scene["show_step"], scene["steps"]);
        EXPECT_NE(folder.Run("list").output.find(scene["name"].get<std::string>()), std::string::npos);
    }
}

TEST(EnvOutput, NamesBackendsAndVersions) {
    const ScratchFolder folder;
    const ProgramResult result = folder.Run("env");
    ASSERT_EQ(result.exitCode, 0);
    for (const char* word : {"osmesa", "egl", "cpu", "compiler", "box2d", "fmt", "CLI11", "zlib", "gnuplot"}) {
        EXPECT_NE(result.output.find(word), std::string::npos) << word << "\n" << result.output;
    }
    EXPECT_EQ(result.output.find("box2d3          not found") == std::string::npos, IsBuilt("box2d3")) << result.output;
}

}  // namespace
}  // namespace testbed
