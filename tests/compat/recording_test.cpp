// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Programs written for Box2D that were started with SCREE_RECORD. They say what they say without, and their recordings
// replay to the same states. Where a listener or a filter of the program has a say in a step, a replay parts there.

#include <gtest/gtest.h>
#include <scree/recording.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

std::string RunShell(const std::string& command) {
    FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return "";
    std::string text;
    std::array<char, 4096> buffer;
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
        text.append(buffer.data(), count);
    return pclose(pipe) == 0 ? text : "failed";
}

std::vector<std::byte> Read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const auto* bytes = reinterpret_cast<const std::byte*>(text.data());
    return {bytes, bytes + text.size()};
}

std::vector<std::string> Names() {
    std::vector<std::string> names(1);
    for (const char c : RunShell(SCREE_PROGRAMS_SCREE " --list")) {
        if (c == '\n') {
            names.emplace_back();
        } else {
            names.back() += c;
        }
    }
    names.pop_back();
    return names;
}

TEST(CallFile, ProgramsReplayToTheSameStates) {
    const fs::path folder = fs::path(testing::TempDir()) / "scree-call-files";
    fs::remove_all(folder);
    fs::create_directories(folder);
    int recordings = 0, steps = 0;
    for (const std::string& name : Names()) {
        const std::string program = std::string(SCREE_PROGRAMS_SCREE) + " " + name + " 2>&1";
        const std::string plain = RunShell(program);
        ASSERT_NE(plain, "failed") << name;
        EXPECT_EQ(RunShell("SCREE_RECORD='" + (folder / (name + ".recording")).string() + "' " + program), plain)
            << name;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
            const std::string file = entry.path().filename().string();
            const scree::ReplayReport report = scree::Replay(Read(entry.path()));
            EXPECT_TRUE(report.valid) << file << " at byte " << report.position;
            // Their listeners enable contacts, set speeds, or refuse pairs.
            const bool hasSay = name == "ConveyorBelt" || name == "OneWayPlatform" || name == "Platformer" ||
                                file == "Filters-2.recording";
            EXPECT_EQ(report.firstDifference != 0, hasSay) << file << " parts at step " << report.firstDifference;
            ++recordings;
            steps += report.steps;
            fs::remove(entry.path());
        }
    }
    EXPECT_GT(recordings, 50);
    EXPECT_GT(steps, 5000);
    fs::remove_all(folder);
}

TEST(CallFile, AFileThatCannotBeWrittenCostsALineOnly) {
    const std::string plain = RunShell(SCREE_PROGRAMS_SCREE " HelloWorld 2>&1");
    EXPECT_EQ(RunShell("SCREE_RECORD= " SCREE_PROGRAMS_SCREE " HelloWorld 2>&1"), plain);
    EXPECT_EQ(RunShell("SCREE_RECORD=/no-such-folder/a.recording " SCREE_PROGRAMS_SCREE " HelloWorld 2>/dev/null"),
              plain);
    const std::string both =
        RunShell("SCREE_RECORD=/no-such-folder/a.recording " SCREE_PROGRAMS_SCREE " HelloWorld 2>&1");
    EXPECT_NE(both.find("SCREE_RECORD: cannot write /no-such-folder/a.recording"), std::string::npos) << both;
}

}  // namespace
