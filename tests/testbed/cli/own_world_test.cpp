// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Every command of testbed/docs/own-world.md, as it stands there, on the session of the game that it shows.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "scree/scree.h"
#include "scree/snapshot.h"
#include "testbed/base/errors.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

/// The lines of the page's blocks of a language.
std::vector<std::string> Lines(const std::string& language) {
    std::ifstream page(SCREE_SOURCE_DIR "/testbed/docs/own-world.md");
    std::vector<std::string> lines;
    bool isInside = false;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("```")) {
            isInside = line == "```" + language;
        } else if (isInside) {
            lines.push_back(line);
        }
    }
    return lines;
}

/// session.track of the game that the page records, from that step of it on.
void PlayGame(const ScratchFolder& folder, int stepsBefore = 0) {
    const std::string command =
        "cd '" + folder.GetPath().string() + "' && '" SCREE_GAME_PROGRAM "' " + std::to_string(stepsBefore);
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
}

TEST(OwnWorld, EveryCommandOfThePageRuns) {
    const ScratchFolder folder;
    ASSERT_NO_FATAL_FAILURE(PlayGame(folder));
    int commands = 0;
    for (std::string line : Lines("sh")) {
        ASSERT_TRUE(line.starts_with("scree ")) << line;
        line = line.substr(6, line.find('#') - 6);
        const std::string tenMinutes = "--steps 36000";
        if (const std::size_t at = line.find(tenMinutes); at != std::string::npos) {
            line.replace(at, tenMinutes.size(), "--steps 60");
        }
        const ProgramResult result = folder.Run(line + (line.starts_with("overlap") ? " --image 320x200" : ""));
        const bool finds = line.starts_with("find");
        EXPECT_TRUE(result.exitCode == exitDone || (finds && result.exitCode == exitDiffers)) << line << "\n"
                                                                                              << result.output;
        if (finds && line.find("--escape") != std::string::npos) {
            EXPECT_EQ(result.exitCode, exitDiffers);
            EXPECT_NE(result.output.find("escape: player (175): left the box"), std::string::npos) << result.output;
            EXPECT_TRUE(std::filesystem::exists(folder.GetPath() / "out/escape")) << result.output;
        }
        ++commands;
    }
    EXPECT_GT(commands, 10);
    EXPECT_TRUE(folder.Has("out/session/step-0060/compare.png"));
    EXPECT_TRUE(folder.Has("out/both/session/step-0001/render-box2d.png"));
    EXPECT_TRUE(folder.Has("level.scene.json"));
}

/// Counts of a tree by the columns of metrics.csv, of the rows in which a column has this value.
std::vector<std::string> TreeCounts(const std::string& csv, const std::string& column = "engine",
                                    const std::string& value = "box2d") {
    std::istringstream lines(csv);
    std::string line;
    std::vector<std::string> names, rows;
    while (std::getline(lines, line)) {
        std::vector<std::string> cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
        if (names.empty()) {
            names = cells;
            continue;
        }
        std::string counts;
        bool isMeant = false;
        for (std::size_t i = 0; i < std::min(cells.size(), names.size()); ++i) {
            isMeant = isMeant || (names[i] == column && cells[i] == value);
            for (const char* name :
                 {"step", "nodes", "height", "sibling_overlap", "overlap_mean", "pairs_reported", "false_pair_ratio"}) {
                if (names[i] == name) counts += cells[i] + " ";
            }
        }
        if (isMeant) rows.push_back(counts);
    }
    return rows;
}

TEST(OwnWorld, ACapturedMotionGivesTheTreesOfTheWorldThatWasCaptured) {
    const ScratchFolder folder;
    ASSERT_EQ(folder.Run("convert tiles tiles.track --size 16 --engine box2d --steps 60").exitCode, exitDone);
    const std::string steps = " --steps 15:60:15 --image 320x200 -o ";
    ASSERT_EQ(folder.Run("metrics tiles --size 16 --poses box2d" + steps + "run").exitCode, exitDone);
    ASSERT_EQ(folder.Run("metrics tiles.track --poses track" + steps + "captured").exitCode, exitDone);
    const std::vector<std::string> run = TreeCounts(folder.Read("run/tiles/metrics.csv"));
    EXPECT_EQ(run.size(), 4u);
    EXPECT_EQ(run, TreeCounts(folder.Read("captured/tiles/metrics.csv")));
}

TEST(OwnWorld, ARecordedTreeIsTheLiveOneAndNotAFreshOne) {
    const ScratchFolder folder;
    for (const std::string engine : {"box2d", "scree"}) {
        const std::string track = engine + ".track";
        ASSERT_EQ(folder.Run("convert tiles " + track + " --size 16 --steps 60 --tree --engine " + engine).exitCode,
                  exitDone);
        const std::string steps = " --steps 15:60:15 --image 320x200 -o ";
        // The tree of the engine that follows from the beginning is the one that was recorded.
        ASSERT_EQ(folder.Run("metrics " + track + " --engines recorded," + engine + steps + engine).exitCode, exitDone);
        const std::string csv = folder.Read(engine + "/" + engine + "/metrics.csv");
        const std::vector<std::string> recorded = TreeCounts(csv, "pane", "recorded");
        EXPECT_EQ(recorded.size(), 4u);
        if (engine == "box2d") {
            EXPECT_EQ(recorded, TreeCounts(csv, "pane", engine));
        }
    }
    // Of a world that lived before it was recorded only the nodes tell its tree: a fresh one is another.
    ASSERT_NO_FATAL_FAILURE(PlayGame(folder, 100));
    const ProgramResult shown = folder.Run("metrics session.track --engines recorded,box2d,scree --steps 1:1 -o late");
    ASSERT_EQ(shown.exitCode, exitDone) << shown.output;
    const std::string csv = folder.Read("late/session/metrics.csv");
    EXPECT_NE(TreeCounts(csv, "pane", "recorded"), TreeCounts(csv, "pane", "box2d"));
    // By itself the recorded tree stands in place of its engine's, and what has none says how to get it.
    EXPECT_NE(folder.Run("overlap session.track --image 320x200 -o late").output.find("recorded/scree"),
              std::string::npos);
    ASSERT_EQ(folder.Run("convert pyramid plain.track --size 3 --steps 5").exitCode, exitDone);
    for (const char* command : {"overlap plain.track --engines recorded", "overlap pyramid --engines recorded",
                                "overlap session.track --engines recorded --from 3", "bench pyramid --engines recorded",
                                "timeline plain.track --nodes every:2"}) {
        const ProgramResult refused = folder.Run(command);
        EXPECT_EQ(refused.exitCode, exitUsage) << command << "\n" << refused.output;
        EXPECT_NE(refused.output.find("Options::tree"), std::string::npos) << command << "\n" << refused.output;
    }
    EXPECT_EQ(folder.Run("overlap session.track --engines recorded:solver=soft").exitCode, exitUsage);
}

TEST(OwnWorld, AnImageTellsWhatASceneLeavesOut) {
    const ScratchFolder folder;
    scree::World world({0.0f, -10.0f});
    scree::BodyDef def;
    scree::Body* ground = world.CreateBody(&def);
    scree::PolygonShape box;
    box.SetAsBox(5.0f, 0.5f);
    scree::FixtureDef belt;
    belt.shape = &box;
    belt.tangentSpeed = 2.0f;
    ground->CreateFixture(&belt);
    def.type = scree::dynamicBody;
    def.position = {0.0f, 3.0f};
    scree::Body* body = world.CreateBody(&def);
    scree::FixtureDef high;
    high.shape = &box;
    high.filter.categoryBits = std::uint64_t{1} << 40;
    body->CreateFixture(&high);
    const auto save = [&](const char* name) {
        const std::vector<std::byte> image = scree::SaveWorld(world);
        std::ofstream file(folder.GetPath() / name, std::ios::binary);
        file.write(reinterpret_cast<const char*>(image.data()), static_cast<std::streamsize>(image.size()));
    };
    save("one.world");
    ProgramResult made = folder.Run("convert one.world one.scene.json");
    ASSERT_EQ(made.exitCode, exitDone) << made.output;
    EXPECT_NE(made.output.find("one.world: a scene leaves out categories of filters above the 16th: 1"),
              std::string::npos)
        << made.output;
    EXPECT_EQ(made.output.find("disabled"), std::string::npos) << made.output;
    EXPECT_NE(folder.Read("one.scene.json").find("\"tangentSpeed\": 2"), std::string::npos);
    EXPECT_NE(folder.Read("one.scene.json").find("\"categoryBits\": 32768"), std::string::npos);
    body->SetEnabled(false);
    save("two.world");
    made = folder.Run("info two.world");
    EXPECT_NE(made.output.find("a scene leaves out that bodies are disabled: 1"), std::string::npos) << made.output;
}

TEST(OwnWorld, MarksAreMomentsOfASession) {
    const ScratchFolder folder;
    ASSERT_NO_FATAL_FAILURE(PlayGame(folder));
    const ProgramResult found = folder.Run("find session.track --marks --json found.json");
    EXPECT_EQ(found.exitCode, exitDiffers) << found.output;
    EXPECT_NE(found.output.find("the player is on the jump pad"), std::string::npos) << found.output;
    EXPECT_NE(folder.Read("found.json").find("\"step\": 100"), std::string::npos) << folder.Read("found.json");
    EXPECT_NE(folder.Run("info session.track").output.find("marks            1"), std::string::npos);
    ASSERT_EQ(folder.Run("timeline session.track -o page.html").exitCode, exitDone);
    EXPECT_NE(folder.Read("page.html").find("the player is on the jump pad"), std::string::npos);
    // Without being asked for they are no fault.
    EXPECT_EQ(folder.Run("find session.track").exitCode, exitDone);
    EXPECT_EQ(folder.Run("find pyramid --size 3 --steps 5 --marks").exitCode, exitUsage);
}

TEST(OwnWorld, TheLinesOfCodeAreThoseOfTheHeaders) {
    // What stands on the page stands in the game, which is compiled.
    std::ifstream own(SCREE_SOURCE_DIR "/tests/capture/game_program.cpp");
    std::string text{std::istreambuf_iterator<char>(own), {}};
    for (const char* line : {"options.contacts = true;", "options.stages = true;", "options.tree = true;",
                             "track.Name(player, \"player\");", "track.Step(dt);"}) {
        EXPECT_NE(text.find(line), std::string::npos);
        bool isOnPage = false;
        for (const std::string& onPage : Lines("cpp")) isOnPage = isOnPage || onPage.find(line) != std::string::npos;
        EXPECT_TRUE(isOnPage) << line;
    }
}

}  // namespace
}  // namespace testbed
