// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Snapshots of a folder of somebody's scenes: which pictures snapshots.json asks for, what it is refused for, and that
// check and update work on them as on our own.

#include "testbed/jobs/snapshot/scene_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "testbed/base/errors.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

class SceneFolder : public testing::Test {
protected:
    SceneFolder() {
        const std::filesystem::path levels = folder.GetPath() / "levels";
        std::filesystem::create_directories(levels / "more");
        std::ofstream(levels / "drop.scene.json") << scene;
        std::ofstream(levels / "more" / "it's.scene.json") << scene;
        std::ofstream(levels / "notes.txt") << "no scene";
        EXPECT_EQ(folder.Run("convert levels/drop.scene.json levels/fall.track").exitCode, exitDone);
    }
    void Ask(const std::string& snapshots) const {
        std::ofstream(folder.GetPath() / "levels/snapshots.json")
            << R"({"format": "scree-snapshots", "version": 1, "snapshots": [)" + snapshots + "]}";
    }
    [[nodiscard]] std::vector<std::string> Ids() const {
        std::vector<std::string> ids;
        for (const SnapshotCase& one : ReadSceneFolder(folder.GetPath() / "levels")) ids.push_back(one.GetId());
        return ids;
    }
    void ExpectFault(const std::string& snapshots, const std::string& says) const {
        Ask(snapshots);
        const ProgramResult result = folder.Run("snapshot check --scenes levels");
        EXPECT_NE(result.output.find("levels/snapshots.json: snapshots[0]" + says), std::string::npos)
            << snapshots << "\n"
            << result.output;
        EXPECT_EQ(result.exitCode, exitIo) << snapshots;
    }

    static constexpr const char* scene = R"({"format": "scree-scene", "version": 1, "steps": 30, "showStep": 20,
        "bodies": [{"fixtures": [{"shape": {"type": "edge", "vertices": [[-5, 0], [5, 0]]}}]},
                   {"type": "dynamic", "position": [0, 2],
                    "fixtures": [{"density": 1, "shape": {"type": "circle", "radius": 0.5}}]}]})";
    ScratchFolder folder;
};

TEST_F(SceneFolder, WithoutAFileEverySceneIsDrawnWhereItShowsMost) {
    EXPECT_EQ(Ids(), (std::vector<std::string>{"drop/step-0020-render", "drop/step-0020-overlap",
                                               "fall/step-0030-render", "fall/step-0030-overlap",
                                               "more/it's/step-0020-render", "more/it's/step-0020-overlap"}));
}

TEST_F(SceneFolder, WhatIsAskedForIsDrawnInTheOrderInWhichScenesRun) {
    Ask(R"({"scene": "drop.scene.json", "steps": [9, 3], "name": "a", "theme": "light"},
           {"scene": "drop.scene.json", "steps": [5], "settings": "solver=soft@2", "layers": "aabbs"},
           {"scene": "drop.scene.json", "steps": [4], "kind": "overlap", "layers": "levels=0..1"},
           {"scene": "fall.track", "steps": [7]})");
    EXPECT_EQ(Ids(), (std::vector<std::string>{"drop/step-0003-a", "drop/step-0004-overlap", "drop/step-0009-a",
                                               "drop/step-0005-render", "fall/step-0007-render"}));
}

TEST_F(SceneFolder, FaultsAreNamedAtTheirPlace) {
    ExpectFault("3", ": is not an object");
    ExpectFault(R"({"scene": "drp.scene.json"})",
                ".scene: unknown scene 'drp.scene.json'; did you mean 'drop.scene.json'?");
    ExpectFault(R"({"steps": [3]})", ".scene: is missing");
    ExpectFault(R"({"scene": "*", "step": 3})", ": unknown key 'step'; did you mean 'steps'?");
    ExpectFault(R"({"scene": "*", "steps": [0]})", ".steps: give whole numbers from 1 on");
    ExpectFault(R"({"scene": "fall.track", "steps": [31]})", ".steps: fall has no step 31");
    ExpectFault(R"({"scene": "*", "kind": "rendr"})", ".kind: unknown kind of picture 'rendr'");
    ExpectFault(R"({"scene": "*", "layers": "bodis"})", ".layers: ");
    ExpectFault(R"({"scene": "*", "theme": 3})", ".theme: is not a text in quotes");
    ExpectFault(R"({"scene": "*", "settings": "solver=sft"})", ".settings: ");
    ExpectFault(R"({"scene": "*", "name": "../x"})", ".name: '../x' is not one of letters");
    Ask(R"({"scene": "drop.scene.json"}, {"scene": "drop.scene.json", "theme": "light"})");
    const ProgramResult twice = folder.Run("snapshot check --scenes levels");
    EXPECT_NE(twice.output.find("snapshots[1]: is another picture called drop/step-0020-render; give each a \"name\""),
              std::string::npos)
        << twice.output;
    EXPECT_EQ(folder.Run("snapshot check --scenes nowhere").exitCode, exitIo);
    std::filesystem::create_directory(folder.GetPath() / "empty");
    EXPECT_EQ(folder.Run("snapshot check --scenes empty").exitCode, exitUsage);
}

TEST_F(SceneFolder, ThePrintedCommandAcceptsADifference) {
    const ProgramResult missing = folder.Run("snapshot check --scenes levels");
    EXPECT_EQ(missing.exitCode, exitDiffers) << missing.output;
    EXPECT_NE(
        missing.output.find("scree snapshot update --scenes levels --references levels/references --update missing -g "
                            "'^more/it.s/step-0020-render$'"),
        std::string::npos)
        << missing.output;
    EXPECT_EQ(folder
                  .Run("snapshot update --scenes levels --references 'levels/references' --update missing -g "
                       "'^more/it.s/step-0020-render$'")
                  .exitCode,
              exitDone);
    EXPECT_TRUE(folder.Has("levels/references/more/it's/step-0020-render.png"));
    EXPECT_EQ(folder.Run("snapshot update --scenes levels").exitCode, exitDone);
    EXPECT_EQ(folder.Run("snapshot check --scenes levels").exitCode, exitDone);
    EXPECT_EQ(folder.Run("snapshot verify --scenes levels --skip-missing-backend").exitCode, exitDone);
    std::filesystem::remove(folder.GetPath() / "levels/fall.track");
    const ProgramResult orphan = folder.Run("snapshot check --scenes levels");
    EXPECT_EQ(orphan.exitCode, exitDiffers);
    EXPECT_NE(orphan.output.find("fall/step-0030-overlap"), std::string::npos) << orphan.output;
}

}  // namespace
}  // namespace testbed
