// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Programs written for Box2D, each recorded while it runs, in Box2D and in our library. The track says of every body
// that was there, and of no other, what the world said. find, timeline and overlap take it.

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "testbed/base/errors.h"
#include "testbed/cli/command_line.h"
#include "testbed/input/track_file.h"

namespace testbed {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> Lines(const fs::path& file) {
    std::vector<std::string> lines;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

/// As record_steps.cpp writes it.
std::string Describe(const TrackState& state) {
    char text[100];
    const auto bits = [](float value) { return std::bit_cast<unsigned>(value); };
    std::snprintf(text, sizeof text, "%x %x %x %x %x %x %d ", bits(state.position.x), bits(state.position.y),
                  bits(state.angle), bits(state.linearVelocity.x), bits(state.linearVelocity.y),
                  bits(state.angularVelocity), state.awake ? 1 : 0);
    return text;
}

/// The bodies of a line, in a fixed order: a body whose fixtures changed is a new one for a track, among the youngest.
std::vector<std::string> Sorted(const std::string& line) {
    std::vector<std::string> bodies;
    std::istringstream in(line);
    for (std::string word; in >> word;) {
        std::string body = word + ' ';
        for (int i = 0; i < 6 && in >> word; ++i) body += word + ' ';
        bodies.push_back(body);
    }
    std::sort(bodies.begin(), bodies.end());
    return bodies;
}

/// What people do with a track, on one that a program wrote: every command takes it.
void LookAt(const fs::path& track, const fs::path& folder) {
    const std::string file = track.string(), out = (folder / "looked").string();
    testing::internal::CaptureStdout();
    const int found = RunCommandLine({"find", file});
    const int page = RunCommandLine({"timeline", file, "-o", out + ".html"});
    // A world without a second step has no motion to follow.
    const bool hasMotion = ReadTrackFile(track).GetSteps().size() > 1;
    const int overlap = hasMotion ? RunCommandLine({"overlap", file, "--image", "160x100", "-o", out}) : 0;
    const std::string said = testing::internal::GetCapturedStdout();
    EXPECT_TRUE(found == exitDone || found == exitDiffers) << file << "\n" << said;
    EXPECT_EQ(page, exitDone) << file << "\n" << said;
    EXPECT_EQ(overlap, exitDone) << file << "\n" << said;
}

class Recorded : public testing::TestWithParam<std::string> {};

TEST_P(Recorded, ProgramsReadBackToTheSameBits) {
    const std::string program = SCREE_RECORDED + GetParam();
    const fs::path folder = fs::path(testing::TempDir()) / ("scree-recorded-" + GetParam());
    fs::create_directories(folder);
    const fs::path list = folder / "list";
    ASSERT_EQ(std::system((program + " --list >" + list.string()).c_str()), 0);
    int tracks = 0, trees = 0, steps = 0, contacts = 0;
    for (const std::string& name : Lines(list)) {
        const fs::path own = folder / name;
        fs::remove_all(own);
        fs::create_directories(own);
        const std::string command =
            "SCREE_TRACKS='" + own.string() + "' " + program + " " + name + " >" + (own / "said").string() + " 2>&1";
        ASSERT_EQ(std::system(command.c_str()), 0) << command;
        for (const fs::directory_entry& entry : fs::directory_iterator(own)) {
            if (entry.path().extension() != ".track") continue;
            TrackFile track = ReadTrackFile(entry.path());
            ASSERT_EQ(track.GetInfo().damage, "") << entry.path();
            const std::vector<std::string> states = Lines(fs::path(entry.path()).replace_extension(".states"));
            ASSERT_EQ(track.GetLastStep() + 1, std::ssize(states)) << entry.path();
            for (int step = 0; step <= track.GetLastStep(); ++step) {
                std::string line;
                for (const TrackState& state : track.Read(step).bodies) {
                    if (state.isThere) line += Describe(state);
                }
                ASSERT_EQ(Sorted(line), Sorted(states[static_cast<std::size_t>(step)])) << entry.path() << ' ' << step;
                contacts += static_cast<int>(track.Read(step).contacts.size());
            }
            LookAt(entry.path(), own);
            ++tracks;
            trees += track.GetInfo().hasNodes;
            steps += track.GetLastStep();
        }
    }
    EXPECT_GT(tracks, 40);
    EXPECT_GT(steps, 5000);
    EXPECT_GT(contacts, 5000);
    // Our library has Box2D's interface, and not the members in which its tree lies.
    EXPECT_TRUE(GetParam() == "box2d" ? trees > 40 : trees == 0) << trees;
    fs::remove_all(folder);
}

INSTANTIATE_TEST_SUITE_P(Libraries, Recorded, testing::Values("box2d", "scree"),
                         [](const auto& tested) { return tested.param; });

}  // namespace
}  // namespace testbed
