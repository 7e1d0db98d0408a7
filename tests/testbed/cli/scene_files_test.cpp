// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Wherever a command takes a scene it takes a file too. A built-in scene that was written to a file gives what the
// scene itself gives. Files that cannot be meant are refused with the cure.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "scenes/catalog.h"
#include "testbed/base/errors.h"
#include "testbed/input/file_kind.h"
#include "testbed/input/scene_file.h"
#include "testbed/options/scene_input.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

/// Scenes in files, in a folder of the test's own.
class SceneFiles : public testing::Test {
protected:
    /// levels/<name>.scene.json with the scene of that name in it, perhaps called otherwise.
    void Write(const std::string& scene, int size, const std::string& name) {
        scenes::Scene built = scenes::Build(scene, size);
        built.name = name;
        std::filesystem::create_directories(folder.GetPath() / "levels");
        std::ofstream(folder.GetPath() / ("levels/" + name + ".scene.json")) << WriteScene(built);
    }
    [[nodiscard]] std::string PathOf(const std::string& file) const { return (folder.GetPath() / file).string(); }

    ScratchFolder folder;
};

TEST_F(SceneFiles, MetricsOfAFileAreThoseOfItsScene) {
    Write("falling-squares", 8, "level-1");
    const ProgramResult file = folder.Run("metrics levels/level-1.scene.json --steps 40 --image 320x200 -o file");
    const ProgramResult name = folder.Run("metrics falling-squares --size 8 --steps 40 --image 320x200 -o name");
    ASSERT_EQ(file.exitCode, 0) << file.output;
    ASSERT_EQ(name.exitCode, 0) << name.output;
    const auto read = [&](const std::string& path) { return nlohmann::json::parse(folder.Read(path)); };
    const nlohmann::json fromFile = read("file/level-1/metrics.json"),
                         fromName = read("name/falling-squares/metrics.json");
    EXPECT_EQ(fromFile.at("scene"), "level-1");
    EXPECT_EQ(fromFile.at("size"), 8);
    std::size_t rows = 0;
    for (; rows < fromName.at("rows").size(); ++rows) {
        EXPECT_EQ(fromFile.at("rows")[rows].at("state_hash"), fromName.at("rows")[rows].at("state_hash")) << rows;
    }
    EXPECT_EQ(rows, 80u) << "two engines, 40 steps";
    EXPECT_EQ(fromFile.at("rows").size(), rows);
}

TEST_F(SceneFiles, EveryCommandTakesThem) {
    Write("pyramid", 4, "level-2");
    Write("falling-circles", 6, "level-3");
    ProgramResult result = folder.Run(
        "overlap levels/level-2.scene.json levels/level-3.scene.json falling-squares "
        "--step 12 --image 320x200 -o out");
    EXPECT_EQ(result.exitCode, 0) << result.output;
    EXPECT_TRUE(folder.Has("out/level-2/step-0012/compare.png"));
    EXPECT_TRUE(folder.Has("out/level-3/timing.png"));
    EXPECT_TRUE(folder.Has("out/falling-squares/metrics.csv"));
    result = folder.Run("render levels/level-2.scene.json --step 5 --image 320x200 -o out");
    EXPECT_EQ(result.exitCode, 0) << result.output;
    const auto sidecar = nlohmann::json::parse(folder.Read("out/level-2/step-0005/render-scree.json"));
    EXPECT_EQ(sidecar.at("scene"), "level-2");
    result = folder.Run("bench levels/level-2.scene.json --steps 20 --csv bench.csv --set gravity=0/-20");
    EXPECT_EQ(result.exitCode, 0) << result.output;
    EXPECT_NE(folder.Read("bench.csv").find("level-2"), std::string::npos);
    EXPECT_NE(folder.Read("bench.csv").find("gravity=0/-20"), std::string::npos);
    result = folder.Run("requires levels/level-2.scene.json --quick --steps 5");
    EXPECT_EQ(result.exitCode, 0) << result.output;
    EXPECT_NE(result.output.find("\nlevel-2 4, 5 steps\n"), std::string::npos) << result.output;
    result = folder.Run("view levels/level-2.scene.json --offscreen --frames 3 --dump-state state.json");
    EXPECT_EQ(result.exitCode, 0) << result.output;
    EXPECT_EQ(nlohmann::json::parse(folder.Read("state.json")).at("scene"), "level-2");
}

TEST_F(SceneFiles, TheFormatOptionCountsMoreThanTheEnding) {
    Write("pyramid", 4, "level-4");
    std::filesystem::rename(PathOf("levels/level-4.scene.json"), PathOf("level.txt"));
    const ProgramResult refused = folder.Run("metrics level.txt --steps 2");
    EXPECT_EQ(refused.exitCode, exitUsage);
    EXPECT_NE(refused.output.find("*.scene.json (a world at one moment)"), std::string::npos) << refused.output;
    EXPECT_NE(refused.output.find("--format"), std::string::npos) << refused.output;
    const ProgramResult taken = folder.Run("metrics level.txt --format scene --steps 2");
    EXPECT_EQ(taken.exitCode, 0) << taken.output;
    EXPECT_TRUE(folder.Has("out/level-4/metrics.csv"));
}

TEST_F(SceneFiles, WhatCannotBeMeantIsRefused) {
    Write("pyramid", 4, "level-5");
    Write("tiles", 2, "tiles");
    std::ofstream(PathOf("broken.scene.json")) << R"({"format": "scree-scene", "version": 1, "gravty": [0, 1]})";
    const struct {
        std::string arguments;
        int exitCode;
        std::string says;
    } cases[] = {
        {"overlap levels/level-6.scene.json", exitIo, "levels/level-6.scene.json: there is no such file"},
        {"overlap levels", exitUsage, "*.scene.json"},
        {"overlap levels/", exitUsage, "*.scene.json"},
        {"overlap levels --format scene", exitIo, "levels: a folder; give a *.scene.json file"},
        {"render pyramd", exitUsage, "did you mean 'pyramid'"},
        {"render pyramd", exitUsage, "files are *.scene.json"},
        {"bench broken.scene.json", exitIo, "broken.scene.json: unknown key 'gravty'; did you mean 'gravity'"},
        {"view broken.scene.json", exitIo, "did you mean 'gravity'"},
        {"requires broken.scene.json", exitIo, "did you mean 'gravity'"},
        {"metrics levels/level-5.scene.json --format scen", exitUsage, "did you mean 'scene'"},
        {"metrics levels/level-5.scene.json --size 5", exitUsage, "a file has its own size"},
        {"bench levels/level-5.scene.json --sizes 5", exitUsage, "a file has its own size"},
        {"overlap tiles levels/tiles.scene.json", exitUsage, "give it another \"name\""},
    };
    for (const auto& one : cases) {
        const ProgramResult result = folder.Run(one.arguments);
        EXPECT_EQ(result.exitCode, one.exitCode) << one.arguments << "\n" << result.output;
        EXPECT_NE(result.output.find(one.says), std::string::npos) << one.arguments << "\n" << result.output;
        EXPECT_EQ(std::ranges::count(result.output, '\n'), 1) << result.output;
    }
    EXPECT_FALSE(folder.Has("out")) << "nothing is written";
}

TEST_F(SceneFiles, AFileIsBuiltAsOftenAsWanted) {
    Write("gears", scenes::Find("gears")->defaultSize, "level-7");
    const SceneInput input = ChooseScene(PathOf("levels/level-7.scene.json"), std::nullopt, {});
    scenes::Scene built = scenes::Build("gears");
    EXPECT_EQ(input.steps, built.steps);
    EXPECT_EQ(input.showStep, built.showStep);
    EXPECT_EQ(input.info, nullptr);
    built.name = "level-7";
    EXPECT_EQ(input.Build(), built);
    EXPECT_EQ(input.Build(), built);
}

TEST(FileKinds, EachHasANameAndAnEnding) {
    for (const FileKindInfo& info : FileKinds()) {
        EXPECT_EQ(ParseFileKind(info.name), info.kind);
        EXPECT_EQ(KindOfEnding("a" + std::string(info.ending)), info.kind);
        EXPECT_TRUE(LooksLikeFile("a" + std::string(info.ending)));
        EXPECT_EQ(&GetInfo(info.kind), &info);
    }
    EXPECT_FALSE(KindOfEnding(".scene.json")) << "a name is more than its ending";
    EXPECT_FALSE(LooksLikeFile("tiles"));
    EXPECT_TRUE(LooksLikeFile("./tiles"));
}

}  // namespace
}  // namespace testbed
