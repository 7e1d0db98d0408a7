// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The window as a user meets it: scripts of mouse and keyboard into the program, JSON and pictures out; offscreen, and
// in a real window on a virtual display.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "testbed/base/errors.h"
#include "testbed/picture/png.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

using nlohmann::json;

constexpr const char* common = "--size 4 --window 900x640 --no-times --no-overlap --script input.txt";

void WriteScript(const ScratchFolder& folder, const std::string& text) {
    std::ofstream(folder.GetPath() / "input.txt") << text;
}

json ReadState(const ScratchFolder& folder, const std::string& name) { return json::parse(folder.Read(name)); }

bool AreEqual(const ScratchFolder& folder, const std::string& a, const std::string& b) {
    return ReadPng(folder.GetPath() / a).pixels == ReadPng(folder.GetPath() / b).pixels;
}

/// Runs a script on a pyramid of four rows: body 0 is the ground, 10 the top.
ProgramResult RunScript(const ScratchFolder& folder, const std::string& script, const std::string& more = "") {
    WriteScript(folder, script);
    return folder.Run(std::string("view pyramid --offscreen ") + common + " " + more);
}

TEST(View, PausesStepsAndRestarts) {
    const ScratchFolder folder;
    const ProgramResult result = RunScript(folder, R"(3 key p
4 dump paused.json
7 dump still.json
8 key o
8 dump stepped.json
9 move item step
9 click
11 dump clicked.json
12 key r
12 dump restarted.json
14 key p
20 dump running.json
)");
    ASSERT_EQ(result.exitCode, 0) << result.output;
    const auto step = [&](const char* name) { return ReadState(folder, name)["engines"][1]["step"].get<int>(); };
    EXPECT_TRUE(ReadState(folder, "paused.json")["paused"]);
    EXPECT_EQ(step("paused.json"), 3) << "frames 0 to 2 made a step each";
    EXPECT_EQ(step("still.json"), 3);
    EXPECT_EQ(step("stepped.json"), 4);
    EXPECT_EQ(step("clicked.json"), 5) << "the button does what the key does";
    EXPECT_EQ(step("restarted.json"), 0);
    EXPECT_EQ(step("running.json"), 7) << "frames 14 to 20";
    EXPECT_EQ(ReadState(folder, "clicked.json")["engines"][0]["step"], 5);
}

TEST(View, ADraggedBodyFollowsThePointerInBothEngines) {
    const ScratchFolder folder;
    const ProgramResult result = RunScript(folder, R"(2 move body scree 10
2 screenshot before.png
3 press
4 dump grabbed.json
5 move world scree 3 7
65 dump held.json
65 screenshot held.png
66 release
67 dump released.json
)");
    ASSERT_EQ(result.exitCode, 0) << result.output;
    const json grabbed = ReadState(folder, "grabbed.json"), held = ReadState(folder, "held.json");
    EXPECT_EQ(grabbed["picked_body"], 10);
    EXPECT_TRUE(held["dragging"]);
    EXPECT_FALSE(ReadState(folder, "released.json")["dragging"]);
    for (size_t engine : {0u, 1u}) {
        const json before = grabbed["engines"][engine]["picked"]["position"];
        const json after = held["engines"][engine]["picked"]["position"];
        const auto distance = [](const json& p) { return std::hypot(p[0].get<double>() - 3, p[1].get<double>() - 7); };
        EXPECT_GT(distance(before), 1.5);
        // A second of a spring of 5 Hz; the pointer is on whole pixels, the body was held near its centre.
        EXPECT_LT(distance(after), 0.2) << held["engines"][engine]["engine"];
    }
    EXPECT_FALSE(AreEqual(folder, "before.png", "held.png"));
}

TEST(View, ScrubsLevelsPicksANodeAndTracesAQuery) {
    const ScratchFolder folder;
    const ProgramResult result = RunScript(folder, R"(0 key p
2 move item layer.bvh
2 screenshot before.png
3 click
6 screenshot layer.png
6 dump all.json
7 move item nodes.last 0.02
7 click
10 dump root.json
11 move world box2d 0 1
13 dump hovered.json
13 screenshot hovered.png
14 move body scree 10
15 click
18 dump traced.json
18 screenshot traced.png
19 move item query.size 0.9
19 click
22 dump larger.json
23 key escape
25 dump cleared.json
)");
    ASSERT_EQ(result.exitCode, 0) << result.output;
    EXPECT_EQ(ReadState(folder, "all.json")["nodes"], "internal");
    EXPECT_EQ(ReadState(folder, "all.json")["layers"], (json{"bodies", "bvh", "joints"}));
    EXPECT_EQ(ReadState(folder, "root.json")["nodes"], "level=0");
    const json hovered = ReadState(folder, "hovered.json")["engines"];
    EXPECT_FALSE(hovered[0].contains("hovered")) << "the pointer is in the other pane";
    EXPECT_EQ(hovered[1]["hovered"]["path"], "root") << "the only node shown";
    EXPECT_EQ(hovered[1]["hovered"]["leaves"], 11);
    const json traced = ReadState(folder, "traced.json")["engines"],
               larger = ReadState(folder, "larger.json")["engines"];
    for (size_t engine : {0u, 1u}) {
        const json small = traced[engine]["trace"], large = larger[engine]["trace"];
        EXPECT_GE(small["leaves"], 1);
        EXPECT_GT(small["visited"], small["leaves"]);
        EXPECT_GT(small["tested"], small["visited"]);
        EXPECT_EQ(large["leaves"], 11) << "18 m hold the whole pyramid";
        EXPECT_EQ(large["visited"], 21);
        EXPECT_EQ(large["tested"], 21);
    }
    EXPECT_FALSE(ReadState(folder, "cleared.json").contains("query"));
    EXPECT_FALSE(AreEqual(folder, "before.png", "layer.png"));
    EXPECT_FALSE(AreEqual(folder, "layer.png", "hovered.png"));
    EXPECT_FALSE(AreEqual(folder, "hovered.png", "traced.png"));
}

TEST(View, SwitchesSceneEngineAndAlgorithm) {
    const ScratchFolder folder;
    const ProgramResult result = RunScript(folder, R"(1 move item scene.search
1 click
3 text domino
5 dump searched.json
6 move item scene.domino-row
6 click
9 dump domino.json
10 move item engine.box2d
10 click
13 dump one.json
14 move item solver.broad-phase
14 click
17 move item broad-phase.fat-tree
17 click
20 dump fat.json
21 move item solver.velocity 0.5
21 click
24 dump slider.json
25 key b
27 dump bullet.json
28 key [
30 dump previous.json
)");
    ASSERT_EQ(result.exitCode, 0) << result.output;
    EXPECT_EQ(ReadState(folder, "searched.json")["search"], "domino");
    EXPECT_EQ(ReadState(folder, "searched.json")["scene"], "pyramid");
    EXPECT_EQ(ReadState(folder, "domino.json")["scene"], "domino-row");
    EXPECT_EQ(ReadState(folder, "domino.json")["engines"].size(), 2u);
    const json one = ReadState(folder, "one.json");
    ASSERT_EQ(one["engines"].size(), 1u);
    EXPECT_EQ(one["engines"][0]["engine"], "scree");
    EXPECT_EQ(one["engines"][0]["broad_phase"], "keys");
    const json fat = ReadState(folder, "fat.json");
    EXPECT_EQ(fat["broad_phase"], "fat-tree");
    EXPECT_EQ(fat["engines"][0]["broad_phase"], "fat-tree");
    EXPECT_NEAR(ReadState(folder, "slider.json")["settings"]["velocity_iterations"].get<int>(), 25, 2)
        << "the middle of 1 to 50";
    const json bullet = ReadState(folder, "bullet.json");
    EXPECT_EQ(bullet["bullets"], 1);
    EXPECT_EQ(bullet["engines"][0]["bodies"].get<int>(), fat["engines"][0]["bodies"].get<int>() + 1);
    EXPECT_EQ(ReadState(folder, "previous.json")["scene"], "box-stack");
}

TEST(View, KeysGoToTheTextThatIsBeingTyped) {
    const ScratchFolder folder;
    ASSERT_EQ(RunScript(folder, "1 move item scene.search\n1 click\n3 key p\n3 text p\n6 dump a.json\n").exitCode, 0);
    EXPECT_FALSE(ReadState(folder, "a.json")["paused"]);
    EXPECT_EQ(ReadState(folder, "a.json")["search"], "p");
}

TEST(View, PansAndZooms) {
    const ScratchFolder folder;
    ASSERT_EQ(RunScript(folder, R"(0 key p
1 dump start.json
2 move world scree -0.5 2
3 press right
4 move world scree 0.5 2
6 release right
7 dump panned.json
8 scroll 3
9 dump zoomed.json
10 key f
11 dump fitted.json
)")
                  .exitCode,
              0);
    const auto camera = [&](const char* name) { return ReadState(folder, name)["camera"].get<std::vector<double>>(); };
    const auto start = camera("start.json"), panned = camera("panned.json"), zoomed = camera("zoomed.json");
    // Pointers stand on whole pixels: each end of the way is less than one off.
    EXPECT_NEAR(panned[0], start[0] - 1, 2 / start[2]) << "the world moves with the pointer";
    EXPECT_NEAR(panned[1], start[1], 2 / start[2]);
    EXPECT_EQ(panned[2], start[2]);
    EXPECT_NEAR(zoomed[2] / panned[2], std::pow(1.15, 3), 1e-3);
    EXPECT_EQ(camera("fitted.json"), start) << "paused: the same bodies to fit";
}

TEST(View, SaysWhatIsWrong) {
    const ScratchFolder folder;
    const auto problem = [&](const std::string& arguments, int code) {
        const ProgramResult result = folder.Run("view " + arguments);
        EXPECT_EQ(result.exitCode, code) << arguments << ": " << result.output;
        return result.output;
    };
    EXPECT_NE(problem("piramid", 2).find("did you mean 'pyramid"), std::string::npos);
    EXPECT_NE(problem("--offscreen", 2).find("--frames N or --script FILE"), std::string::npos);
    EXPECT_NE(problem("--window 10x10 --frames 1", 2).find("640x480"), std::string::npos);
    EXPECT_NE(problem("--script none.txt", 4).find("none.txt: cannot be read"), std::string::npos);
    WriteScript(folder, "0 move item nothing\n");
    EXPECT_NE(problem("--offscreen --script input.txt", 2).find("script line 1"), std::string::npos);
    const ProgramResult noDisplay = folder.Run("view --frames 1", "env -u DISPLAY -u WAYLAND_DISPLAY");
    EXPECT_EQ(noDisplay.exitCode, 3);
    EXPECT_NE(noDisplay.output.find("no display"), std::string::npos) << noDisplay.output;
    EXPECT_NE(noDisplay.output.find("--offscreen"), std::string::npos) << noDisplay.output;
}

bool IsInstalled(const std::string& tool) { return std::system(("command -v " + tool + " >/dev/null").c_str()) == 0; }

TEST(View, AWindowShowsWhatOffscreenShows) {
    ASSERT_TRUE(IsInstalled("xvfb-run")) << "tests/run installs it (package xvfb)";
    const ScratchFolder folder;
    WriteScript(folder, "0 move 300 300\n4 move body scree 10\n5 press\n7 move world scree 2 6\n30 dump state.json\n");
    const std::string view = std::string("view pyramid ") + common;
    const ProgramResult window = folder.Run(view + " --screenshot window.png --dump-state window.json",
                                            "xvfb-run -a -s '-screen 0 1280x1024x24'");
    ASSERT_EQ(window.exitCode, 0) << window.output;
    const ProgramResult offscreen =
        folder.Run(view + " --offscreen --screenshot offscreen.png --dump-state offscreen.json");
    ASSERT_EQ(offscreen.exitCode, 0) << offscreen.output;
    EXPECT_TRUE(ReadState(folder, "window.json")["dragging"]);
    EXPECT_EQ(folder.Read("window.json"), folder.Read("offscreen.json"));
    EXPECT_TRUE(AreEqual(folder, "window.png", "offscreen.png")) << "both draw with llvmpipe into the same target";
}

/// Where body 10 of the paused pyramid is in the window, pixels, by the state that a script dumps.
std::pair<int, int> FindTop(const ScratchFolder& folder, const std::string& view) {
    WriteScript(folder, "1 move body scree 10\n2 press\n4 dump d.json\n");
    EXPECT_EQ(folder.Run(view + " --offscreen --script input.txt").exitCode, 0);
    const json state = ReadState(folder, "d.json");
    const json engine = state["engines"][0];
    const auto camera = state["camera"].get<std::vector<double>>();
    const auto area = engine["area"].get<std::vector<double>>();
    const auto at = engine["picked"]["position"].get<std::vector<double>>();
    return {static_cast<int>((area[0] + area[2]) / 2 + (at[0] - camera[0]) * camera[2]),
            static_cast<int>((area[1] + area[3]) / 2 - (at[1] - camera[1]) * camera[2])};
}

// Events of the X server itself (XTest), through GLFW, in a window on a virtual display. The pictures that F12 writes
// must be those that a script of the same events makes without a window.
TEST(View, RealMouseAndKeysDoWhatScriptsDo) {
    ASSERT_TRUE(IsInstalled("xvfb-run")) << "tests/run installs it (package xvfb)";
    ASSERT_TRUE(IsInstalled("xdotool")) << "tests/run installs it (package xdotool)";
    const ScratchFolder folder;
    const std::string view = "view pyramid --size 4 --window 900x640 --no-times --no-overlap --paused --steps-before 3";
    const auto [x, y] = FindTop(folder, view);
    const std::string from = fmt::format("{} {}", x, y), to = fmt::format("{} {}", x + 60, y - 40);
    std::ofstream(folder.GetPath() / "real.sh") << fmt::format(R"(mkdir real && cd real
"{0}" {1} & viewer=$!
trap 'kill $viewer' EXIT
window=$(timeout 60 xdotool search --sync --onlyvisible --name '^scree$' | head -n 1)
Await() {{ for _ in $(seq 600); do compgen -G "$1" >/dev/null && return; sleep 0.1; done; echo "no $1"; exit 1; }}
xdotool mousemove --window "$window" {2} mousedown 1 mousemove --window "$window" {3} key F12
Await screenshot-pyramid-0003.png                  # the pointer is where the steps will find it
for _ in $(seq 20); do xdotool key o; done
xdotool key F12
Await screenshot-pyramid-0023.png                  # 20 single steps, not one more
mv screenshot-pyramid-0023.png held.png
xdotool mouseup 1 key F12
Await screenshot-pyramid-0023.png                  # let go
xdotool key o key F12
Await screenshot-pyramid-0024.png
xdotool key p
Await /proc/$viewer/stat                           # runs
xdotool key p key bracketright key F12
Await screenshot-box-stack-0000.png                # paused again, the next scene
)",
                                                               SCREE_PROGRAM, view, from, to);
    const ProgramResult real = folder.Run("", "xvfb-run -a -s '-screen 0 1280x1024x24' bash real.sh; :");
    ASSERT_TRUE(folder.Has("real/screenshot-pyramid-0024.png")) << real.output;
    EXPECT_TRUE(folder.Has("real/screenshot-box-stack-0000.png")) << real.output;

    std::string script = fmt::format("1 move {}\n2 press\n4 move {}\n6 key f12\n", from, to);
    for (int i = 0; i < 20; ++i) script += fmt::format("{} key o\n", 8 + 2 * i);
    script += "60 key f12\n60 screenshot held.png\n62 release\n64 key f12\n66 key o\n70 key f12\n74 dump d.json\n";
    WriteScript(folder, script);
    ASSERT_EQ(folder.Run(view + " --offscreen --script input.txt").exitCode, 0);
    for (const char* name :
         {"screenshot-pyramid-0003.png", "held.png", "screenshot-pyramid-0023.png", "screenshot-pyramid-0024.png"}) {
        EXPECT_TRUE(AreEqual(folder, std::string("real/") + name, name)) << name;
    }
    EXPECT_FALSE(AreEqual(folder, "screenshot-pyramid-0023.png", "screenshot-pyramid-0024.png"));
    // The drag did something: without it the picture is another.
    ASSERT_EQ(folder
                  .Run("view pyramid --size 4 --window 900x640 --no-times --no-overlap --paused --steps-before 23 "
                       "--offscreen --frames 3 --screenshot undragged.png")
                  .exitCode,
              0);
    EXPECT_FALSE(AreEqual(folder, "held.png", "undragged.png"));
}

TEST(View, TheLightThemeChangesScenesAndPanels) {
    const ScratchFolder folder;
    const std::string view = "view pyramid --size 4 --window 900x640 --no-times --paused --offscreen ";
    ASSERT_EQ(folder.Run(view + "--frames 4 --screenshot dark.png --theme dark").exitCode, 0);
    ASSERT_EQ(folder.Run(view + "--frames 4 --screenshot light.png --theme light --dump-state light.json").exitCode, 0);
    EXPECT_EQ(ReadState(folder, "light.json")["theme"], "light");
    const auto brightShare = [&](const char* name) {
        const Image image = ReadPng(folder.GetPath() / name);
        double bright = 0;
        for (const Color& color : image.pixels) bright += color.r + color.g + color.b > 3 * 160 ? 1 : 0;
        return bright / static_cast<double>(image.pixels.size());
    };
    EXPECT_GT(brightShare("light.png"), 0.75);
    EXPECT_LT(brightShare("dark.png"), 0.15);
    // The switch in the panel does the same.
    WriteScript(folder,
                "2 move item look.light\n2 click\n6 move 5 5\n9 screenshot switched.png\n9 dump switched.json\n");
    ASSERT_EQ(folder.Run(view + "--script input.txt").exitCode, 0);
    EXPECT_EQ(ReadState(folder, "switched.json")["theme"], "light");
    EXPECT_GT(brightShare("switched.png"), 0.75);
    EXPECT_EQ(folder.Run(view + "--frames 1 --theme grey").exitCode, 2);
}

TEST(View, QuitsByItselfAfterItsFrames) {
    const ScratchFolder folder;
    const ProgramResult result =
        folder.Run("view domino-row --offscreen --frames 5 --screenshot shot.png --dump-state state.json");
    ASSERT_EQ(result.exitCode, 0) << result.output;
    EXPECT_NE(result.output.find("5 frames in "), std::string::npos) << result.output;
    const Image shot = ReadPng(folder.GetPath() / "shot.png");
    EXPECT_EQ(shot.width, 1280);
    EXPECT_EQ(shot.height, 800);
    EXPECT_EQ(ReadState(folder, "state.json")["engines"][0]["step"], 5);
}

}  // namespace
}  // namespace testbed
