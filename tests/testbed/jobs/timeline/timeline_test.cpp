// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The page of a session: small, alone, and in headless Chromium it does what a reader asks. Without Chromium the test
// fails and says what to install.

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "scenes/catalog.h"
#include "testbed/base/errors.h"
#include "testbed/engines/engine_run.h"
#include "testbed/input/track_file.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

/// A ball that goes through a wall in step 4, a crate that rests on a shelf, and a joint.
void WriteScene(const std::filesystem::path& path) {
    std::ofstream(path) << R"({"format": "scree-scene", "version": 1, "gravity": [0, 0], "steps": 60,
        "bodies": [{"fixtures": [{"shape": {"type": "edge", "vertices": [[0, -5], [0, 5]]}}]},
                   {"type": "dynamic", "position": [-5.2, 0], "linearVelocity": [100, 0],
                    "fixtures": [{"density": 1, "shape": {"type": "circle", "radius": 0.1}}]},
                   {"type": "dynamic", "position": [3, 2],
                    "fixtures": [{"density": 1, "shape": {"type": "box", "halfExtents": [1, 1]}}]},
                   {"fixtures": [{"shape": {"type": "box", "halfExtents": [1, 0.25], "center": [3, 0.75]}}]},
                   {"type": "dynamic", "position": [-4, -4],
                    "fixtures": [{"density": 1, "shape": {"type": "circle", "radius": 0.3, "center": [0.6, 0]}}]}],
        "joints": [{"type": "revolute", "bodyA": 3, "bodyB": 4, "localAnchorA": [-4, -4]}],
        "user": {"bodies": {"1": {"name": "shot"}, "2": {"name": "crate"}, "3": {"name": "shelf"}}}})";
}

/// What the browser's test of this name says of a page; its exit code is 0.
std::string Drive(const ScratchFolder& folder, const std::string& test, const std::string& page) {
    const std::string command =
        "python3 -B '" SCREE_SOURCE_DIR "/tests/testbed/jobs/timeline/timeline_browser_test.py' " + test + " '" +
        (folder.GetPath() / page).string() + "' >'" + (folder.GetPath() / "said").string() + "' 2>&1 </dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0) << folder.Read("said");
    return folder.Read("said");
}

TEST(Timeline, DoesInABrowserWhatAReaderAsks) {
    const ScratchFolder folder;
    WriteScene(folder.GetPath() / "bullet.scene.json");
    const ProgramResult made = folder.Run("timeline bullet.scene.json --set continuous=off -o page.html");
    ASSERT_EQ(made.exitCode, exitDone) << made.output;
    const std::string page = folder.Read("page.html");
    EXPECT_EQ(page.find("src="), std::string::npos) << "nothing beside the page is needed";
    Drive(folder, "reads", "page.html");
}

TEST(Timeline, ShowsEnginesBesideEachOtherWithTheirTrees) {
    const ScratchFolder folder;
    const ProgramResult run =
        folder.Run("timeline pyramid --size 6 --steps 60 --engines scree,box2d --nodes every:15 -o page.html");
    ASSERT_EQ(run.exitCode, exitDone) << run.output;
    Drive(folder, "engines", "page.html");
    // The trees of engines follow a motion that was recorded.
    ASSERT_EQ(folder.Run("convert pyramid session.track --size 6 --steps 60").exitCode, exitDone);
    const ProgramResult followed =
        folder.Run("timeline session.track --engines scree,box2d --nodes at:30,60 -o followed.html");
    ASSERT_EQ(followed.exitCode, exitDone) << followed.output;
    Drive(folder, "engines", "followed.html");
    EXPECT_EQ(folder.Run("timeline session.track --nodes worst:3 -o none.html").exitCode, exitUsage);
    // The same by the word that overlap has for it.
    const ProgramResult track = folder.Run("timeline session.track --poses track --nodes at:30,60 -o track.html");
    ASSERT_EQ(track.exitCode, exitDone) << track.output;
    Drive(folder, "engines", "track.html");
    const auto streamOf = [&folder](const std::string& page, const std::string& name) {
        const std::string text = folder.Read(page);
        const std::size_t at = text.find("id=\"timeline-" + name + "\"");
        EXPECT_NE(at, std::string::npos) << page;
        return text.substr(at, text.find('<', at) - at);
    };
    for (const std::string stream : {"motion-0", "motion-1", "nodes-0", "nodes-1"}) {
        EXPECT_EQ(streamOf("track.html", stream), streamOf("followed.html", stream)) << stream;
    }
    EXPECT_EQ(streamOf("track.html", "motion-0").substr(30), streamOf("track.html", "motion-1").substr(30));
    EXPECT_NE(streamOf("track.html", "nodes-0").substr(30), streamOf("track.html", "nodes-1").substr(30));
}

TEST(Timeline, TellsAMomentOnceWithTheLanesThatHaveIt) {
    const ScratchFolder folder;
    WriteScene(folder.GetPath() / "bullet.scene.json");
    ASSERT_EQ(folder.Run("convert bullet.scene.json bullet.track --set continuous=off").exitCode, exitDone);
    const auto momentsOf = [&folder](const std::string& words) {
        const ProgramResult made = folder.Run("timeline " + words + " -o page.html");
        EXPECT_EQ(made.exitCode, exitDone) << made.output;
        return Drive(folder, "moments", "page.html");
    };
    const std::string tunnel = "step 4: tunnel: shot (1), body 0";
    // Both lanes follow one motion.
    EXPECT_EQ(momentsOf("bullet.track --engines scree,box2d --nodes at:2").rfind(tunnel, 0), 0u);
    EXPECT_EQ(folder.Read("said").find("tunnel", tunnel.size()), std::string::npos);
    // Of three runs, two have it.
    const std::string some = momentsOf(
        "bullet.scene.json --engines a=scree:continuous=off,b=scree:continuous=on,c=scree:continuous=off:solver=si");
    EXPECT_EQ(some.rfind("a, c: " + tunnel, 0), 0u) << some;
    EXPECT_EQ(some.find("b: "), std::string::npos) << some;
}

TEST(Timeline, ExactPositionsHaveAllBitsOfTheRun) {
    const ScratchFolder folder;
    const std::string scene = "falling-squares --size 4 --steps 90";
    ASSERT_EQ(folder.Run("convert " + scene + " session.track --engine box2d").exitCode, exitDone);
    ASSERT_EQ(folder.Run("timeline " + scene + " --positions exact -o run.html").exitCode, exitDone);
    ASSERT_EQ(folder.Run("timeline session.track --positions exact -o track.html").exitCode, exitDone);
    ASSERT_EQ(folder.Run("timeline " + scene + " -o view.html").exitCode, exitDone);
    const auto bitsIn = [&folder](const std::string& page) {
        std::istringstream said(Drive(folder, "places", page));
        std::vector<std::uint32_t> bits;
        for (std::uint32_t one = 0; said >> one;) bits.push_back(one);
        return bits;
    };
    std::vector<std::uint32_t> ofRun, ofTrack;
    const auto add = [](std::vector<std::uint32_t>& bits, scenes::Vec2 position, float angle) {
        for (const float value : {position.x, position.y, angle}) bits.push_back(std::bit_cast<std::uint32_t>(value));
    };
    const auto run = MakeRun(scenes::Build("falling-squares", 4), MakeSpec("scree"));
    TrackFile track(folder.Read("session.track"), "session.track");
    for (int step = 0; step <= 90; ++step) {
        if (step > 0) run->Step();
        Snapshot snapshot;
        run->Capture(snapshot);
        for (const BodyState& body : snapshot.bodies) add(ofRun, body.position, body.angle);
        for (const TrackState& body : track.Read(step).bodies) add(ofTrack, body.position, body.angle);
    }
    EXPECT_EQ(bitsIn("run.html"), ofRun);
    EXPECT_EQ(bitsIn("track.html"), ofTrack);
    EXPECT_NE(ofRun, ofTrack);
    const std::vector<std::uint32_t> rounded = bitsIn("view.html");
    ASSERT_EQ(rounded.size(), ofRun.size());
    EXPECT_NE(rounded, ofRun);
    for (std::size_t i = 0; i < rounded.size(); ++i) {
        EXPECT_NEAR(std::bit_cast<float>(rounded[i]), std::bit_cast<float>(ofRun[i]), 1e-3f) << i;
    }
}

// 65,536 parts of a ground of 4 km would be 6 cm each.
TEST(Timeline, ALongGroundMakesNothingSmallOrCoarse) {
    const ScratchFolder folder;
    std::ofstream(folder.GetPath() / "ground.scene.json") << R"({"format": "scree-scene", "version": 1,
        "bodies": [{"fixtures": [{"shape": {"type": "edge", "vertices": [[-2000, 0], [2000, 0]]}}]},
                   {"type": "dynamic", "position": [0, 4],
                    "fixtures": [{"density": 1, "shape": {"type": "circle", "radius": 0.5}}]},
                   {"type": "dynamic", "position": [8, 2],
                    "fixtures": [{"density": 1, "shape": {"type": "circle", "radius": 0.5}}]}],
        "spawns": [{"afterStep": 3, "body": 2}]})";
    ASSERT_EQ(folder.Run("timeline ground.scene.json --steps 9 -o page.html").exitCode, exitDone);
    const std::string page = folder.Read("page.html");
    const std::size_t view = page.find(R"("view":[)") + 8;
    double left = 0, bottom = 0, right = 0, top = 0;
    ASSERT_EQ(std::sscanf(page.c_str() + view, "%lf,%lf,%lf,%lf", &left, &bottom, &right, &top), 4);
    EXPECT_LE(left, -0.5);
    EXPECT_GE(left, -5.0);
    EXPECT_LE(bottom, 0.0);
    EXPECT_GE(right, 8.5);
    EXPECT_LE(right, 15.0);
    EXPECT_GE(top, 4.5);
}

TEST(Timeline, ShowsWhatThingsFallOnto) {
    const ScratchFolder folder;
    ASSERT_EQ(folder.Run("timeline restitution-row --steps 3 -o page.html").exitCode, exitDone);
    const std::string page = folder.Read("page.html");
    double left = 0, bottom = 0, right = 0, top = 0;
    ASSERT_EQ(std::sscanf(page.c_str() + page.find(R"("view":[)") + 8, "%lf,%lf,%lf,%lf", &left, &bottom, &right, &top),
              4);
    EXPECT_LE(bottom, 0.0);  // the floor
    EXPECT_GE(top, 9.0);     // the balls above it
}

TEST(Timeline, NumbersOfFourEnginesStandBesideEachOther) {
    const ScratchFolder folder;
    const ProgramResult run = folder.Run(
        "timeline pyramid --size 6 --steps 60 --engines scree,box2d,soft=scree:solver=soft@4,fine=scree:accuracy=fine "
        "-o page.html");
    ASSERT_EQ(run.exitCode, exitDone) << run.output;
    Drive(folder, "crowded", "page.html");
}

// What a frame of WebGL costs without a graphics card is its draw calls and corners, which do not depend on the
// machine.
struct DrawnFrame {
    double calls = 0.0;
    double corners = 0.0;
};

std::map<std::string, DrawnFrame> FramesOf(const ScratchFolder& folder, const std::string& page) {
    std::istringstream said(Drive(folder, "plays", page));
    std::map<std::string, DrawnFrame> frames;
    std::string renderer;
    for (DrawnFrame frame; said >> renderer >> frame.calls >> frame.corners;) frames[renderer] = frame;
    return frames;
}

TEST(Timeline, PlaysByCanvasAndByWebGl) {
    const ScratchFolder folder;
    ASSERT_EQ(folder.Run("timeline falling-squares --size 20 --steps 200 --contacts off -o page.html").exitCode,
              exitDone);
    std::map<std::string, DrawnFrame> frames = FramesOf(folder, "page.html");
    ASSERT_EQ(frames.size(), 2);
    EXPECT_EQ(frames["canvas"].calls, 0.0);
    EXPECT_EQ(frames["webgl"].calls, 2.0);  // the insides and the outlines of all bodies
}

// A circle of many triangles, or a call for each circle, plays slower than Canvas 2D: one triangle around it each.
TEST(Timeline, ThousandsOfCirclesAreOneDrawCallOfATriangleEach) {
    const ScratchFolder folder;
    ASSERT_EQ(folder.Run("timeline mixed --size 5000 --steps 200 --contacts off -o page.html").exitCode, exitDone);
    std::map<std::string, DrawnFrame> frames = FramesOf(folder, "page.html");
    ASSERT_EQ(frames.size(), 2);
    EXPECT_EQ(frames["webgl"].calls, 1.0);
    EXPECT_EQ(frames["webgl"].corners, 3.0 * (8427 + 5000));
}

TEST(Timeline, WebGlAndCanvasCoverTheSamePixels) {
    const ScratchFolder folder;
    ASSERT_EQ(folder.Run("timeline mixed --size 60 --steps 60 -o circles.html").exitCode, exitDone);
    ASSERT_EQ(folder.Run("timeline pyramid --size 12 --steps 60 -o boxes.html").exitCode, exitDone);
    Drive(folder, "alike", "circles.html");
    Drive(folder, "alike", "boxes.html");
}

TEST(Timeline, TakesAtMostTwelveBytesAStepOfABody) {
    const ScratchFolder folder;
    const std::string command = "timeline falling-squares --size 8 --contacts off --steps ";
    const ProgramResult shorter = folder.Run(command + "20 -o shorter.html");
    const ProgramResult longer = folder.Run(command + "320 -o longer.html");
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

TEST(Timeline, APartOfASessionKeepsItsStepsAndTimes) {
    const ScratchFolder folder;
    ASSERT_EQ(folder.Run("convert pyramid session.track --size 4 --steps 60").exitCode, exitDone);
    for (const std::string input : {"session.track", "pyramid --size 4 --set preset=like-box2d"}) {
        const ProgramResult run = folder.Run("timeline " + input + " --steps 31:40 -o page.html");
        ASSERT_EQ(run.exitCode, exitDone) << run.output;
        EXPECT_NE(run.output.find("10 steps, "), std::string::npos) << run.output;
        const std::string page = folder.Read("page.html");
        EXPECT_NE(page.find(R"("steps":[30,31,32,33,34,35,36,37,38,39,40])"), std::string::npos) << input;
        EXPECT_NE(page.find(R"("times":[0.5,0.516667,)"), std::string::npos) << input;
    }
    EXPECT_EQ(folder.Run("timeline session.track --steps 61:70 -o page.html").exitCode, exitUsage);
}

TEST(Timeline, WhatCannotBeMeantIsRefused) {
    const ScratchFolder folder;
    EXPECT_EQ(folder.Run("timeline").exitCode, exitUsage);
    EXPECT_EQ(folder.Run("timeline pyramd").exitCode, exitUsage);
    EXPECT_EQ(folder.Run("timeline pyramid --engine box2d --engines scree").exitCode, exitUsage);
    EXPECT_EQ(folder.Run("timeline pyramid --engines scree,scree,scree,scree,scree").exitCode, exitUsage);
    EXPECT_EQ(folder.Run("timeline pyramid --nodes often").exitCode, exitUsage);
    EXPECT_EQ(folder.Run("timeline pyramid --nodes every:0").exitCode, exitUsage);
    EXPECT_EQ(folder.Run("timeline pyramid --size 4 --steps 9 --nodes at:3,10 -o page.html").exitCode, exitUsage);
    EXPECT_FALSE(folder.Has("page.html"));
    EXPECT_EQ(folder.Run("timeline pyramid --contacts some").exitCode, exitUsage);
    EXPECT_EQ(folder.Run("timeline pyramid --positions near").exitCode, exitUsage);
    EXPECT_EQ(folder.Run("timeline pyramid --poses box2d").exitCode, exitUsage);
    EXPECT_NE(folder.Run("timeline pyramid --poses track").output.find("--poses track: pyramid has no motion"),
              std::string::npos);
    EXPECT_EQ(folder.Run("timeline pyramid --when 'body(0).y'").exitCode, exitUsage);
    // Before the run: a folder in place of the page, or none.
    std::filesystem::create_directory(folder.GetPath() / "folder");
    for (const std::string output : {"no-folder/page.html", "folder"}) {
        const ProgramResult run = folder.Run("timeline tumbler --steps 1000000 -o " + output);
        EXPECT_EQ(run.exitCode, exitIo) << run.output;
        EXPECT_NE(run.output.find("cannot write " + output), std::string::npos) << run.output;
    }
}

}  // namespace
}  // namespace testbed
