// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The page of a session: small, alone, and in headless Chromium it does what a reader asks. Without Chromium the test
// fails and says what to install.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "testbed/base/errors.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

/// A ball that goes through a wall in step 4, and one that rests.
void WriteScene(const std::filesystem::path& path) {
    std::ofstream(path) << R"({"format": "scree-scene", "version": 1, "gravity": [0, 0], "steps": 60,
        "bodies": [{"fixtures": [{"shape": {"type": "edge", "vertices": [[0, -5], [0, 5]]}}]},
                   {"type": "dynamic", "position": [-5.2, 0], "linearVelocity": [100, 0],
                    "fixtures": [{"density": 1, "shape": {"type": "circle", "radius": 0.1}}]},
                   {"type": "dynamic", "position": [3, 2], "awake": false,
                    "fixtures": [{"density": 1, "shape": {"type": "box", "halfExtents": [1, 1]}}]}],
        "user": {"bodies": {"1": {"name": "shot"}, "2": {"name": "crate"}}}})";
}

TEST(Timeline, DoesInABrowserWhatAReaderAsks) {
    const ScratchFolder folder;
    WriteScene(folder.GetPath() / "bullet.scene.json");
    const ProgramResult made = folder.Run("timeline bullet.scene.json --set continuous=off -o page.html");
    ASSERT_EQ(made.exitCode, exitDone) << made.output;
    const std::string page = folder.Read("page.html");
    EXPECT_EQ(page.find("src="), std::string::npos) << "nothing beside the page is needed";
    const std::string command =
        "python3 -B '" SCREE_SOURCE_DIR "/tests/testbed/jobs/timeline/timeline_browser_test.py' '" +
        (folder.GetPath() / "page.html").string() + "' >'" + (folder.GetPath() / "said").string() + "' 2>&1 </dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0) << folder.Read("said");
}

TEST(Timeline, TakesAtMostTwelveBytesAStepOfABody) {
    const ScratchFolder folder;
    const ProgramResult shorter = folder.Run("timeline falling-squares --size 8 --steps 20 -o shorter.html");
    const ProgramResult longer = folder.Run("timeline falling-squares --size 8 --steps 120 -o longer.html");
    ASSERT_EQ(shorter.exitCode, exitDone) << shorter.output;
    ASSERT_EQ(longer.exitCode, exitDone) << longer.output;
    const auto changesOf = [](const std::string& output) {
        const std::size_t end = output.find(" changes of a body");
        return std::stod(output.substr(output.rfind(", ", end) + 2));
    };
    const double changes = changesOf(longer.output) - changesOf(shorter.output);
    EXPECT_GT(changes, 1000);
    EXPECT_LT(static_cast<double>(folder.Read("longer.html").size() - folder.Read("shorter.html").size()),
              12 * changes);
}

TEST(Timeline, WhatCannotBeMeantIsRefused) {
    const ScratchFolder folder;
    EXPECT_EQ(folder.Run("timeline").exitCode, exitUsage);
    EXPECT_EQ(folder.Run("timeline pyramd").exitCode, exitUsage);
    EXPECT_EQ(folder.Run("timeline pyramid --engine scree,box2d").exitCode, exitUsage);
    EXPECT_EQ(folder.Run("timeline pyramid --size 4 --steps 3 -o no-folder/page.html").exitCode, exitIo);
}

}  // namespace
}  // namespace testbed
