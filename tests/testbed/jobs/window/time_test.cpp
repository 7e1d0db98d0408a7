// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The window in time, as its user meets it: the bar, keys, break conditions, the inspector and what is saved, by
// scripts into the program.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "scenes/catalog.h"
#include "scree/collision.h"
#include "scree/recording.h"
#include "scree/snapshot.h"
#include "scree/world.h"
#include "testbed/base/errors.h"
#include "testbed/engines/capture_scree.h"
#include "testbed/input/scene_file.h"
#include "testbed/input/track_file.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

using nlohmann::json;

class ViewTime : public testing::Test {
protected:
    /// Runs a script; `scene` with further options.
    ProgramResult Play(const std::string& scene, const std::string& script) {
        return Run(scene + " --offscreen", script, "");
    }
    /// The same in a window on a virtual display.
    ProgramResult PlayOnDisplay(const std::string& scene, const std::string& script, int frames) {
        return Run(fmt::format("{} --frames {}", scene, frames), script, "xvfb-run -a -s '-screen 0 1280x1024x24'");
    }
    ProgramResult Run(const std::string& scene, const std::string& script, const std::string& before) {
        std::ofstream(folder.GetPath() / "time.txt") << script;
        return folder.Run("view " + scene + " --window 1200x760 --no-times --no-overlap --script time.txt", before);
    }
    [[nodiscard]] json State(const std::string& name) const { return json::parse(folder.Read(name)); }
    template <typename Bytes>
    void WriteBytes(const std::string& name, const Bytes& bytes) const {
        std::ofstream(folder.GetPath() / name, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }
    static std::string HashOf(const json& state, std::size_t pane) { return state["engines"][pane]["state_hash"]; }

    ScratchFolder folder;
};

constexpr const char* pyramid = "pyramid --size 4";

TEST_F(ViewTime, GoesBackAndOnAgainToTheSameBits) {
    const ProgramResult result = Play(pyramid, R"(20 key p
21 dump a20.json
22 key o
23 key o
24 key o
26 dump a23.json
27 key left
29 key left
31 key left
33 dump b20.json
34 key home
36 dump b0.json
37 key end
39 dump b23.json
40 move item time.back
41 click
43 dump b22.json
44 key right
46 dump c23.json
47 move item time.scrub 0.5
48 click
51 dump middle.json
52 key j
56 dump backwards.json
57 key p
58 key p
64 dump on.json
)");
    ASSERT_EQ(result.exitCode, 0) << result.output;
    const json a20 = State("a20.json"), a23 = State("a23.json"), b20 = State("b20.json");
    EXPECT_EQ(a20["time"]["step"], 20);
    EXPECT_EQ(a23["time"]["step"], 23);
    EXPECT_EQ(b20["time"]["step"], 20);
    EXPECT_EQ(b20["time"]["last_step"], 23);
    EXPECT_TRUE(b20["paused"]);
    for (const std::size_t pane : {0u, 1u}) {
        EXPECT_EQ(HashOf(b20, pane), HashOf(a20, pane)) << pane;
        EXPECT_EQ(HashOf(State("b23.json"), pane), HashOf(a23, pane)) << pane;
        EXPECT_EQ(HashOf(State("c23.json"), pane), HashOf(a23, pane)) << pane;
    }
    EXPECT_TRUE(b20["engines"][0]["exact"]) << "our engine is there itself";
    EXPECT_FALSE(b20["engines"][1]["exact"]) << "Box2D shows a frame";
    EXPECT_GT(b20["engines"][0]["memory"], 0);
    EXPECT_EQ(State("b0.json")["time"]["step"], 0);
    EXPECT_EQ(State("b22.json")["time"]["step"], 22);
    const int middle = State("middle.json")["time"]["step"];
    EXPECT_NEAR(middle, 12, 1);
    const json backwards = State("backwards.json");
    EXPECT_LT(backwards["time"]["step"], middle);
    EXPECT_TRUE(backwards["time"]["backwards"]);
    EXPECT_FALSE(State("on.json")["time"]["backwards"]);
}

TEST_F(ViewTime, ADragOfThePastIsInTheWayBackAndInTheSavedTrack) {
    const ProgramResult result = Play(pyramid, R"(10 move body scree 10
11 press
13 move world scree 3 7
40 release
45 key p
46 dump end.json
47 key home
50 key end
53 dump again.json
54 move item save.track
55 click
58 move item time.back
59 click
62 move item save.scene
63 click
66 dump saved.json
)");
    ASSERT_EQ(result.exitCode, 0) << result.output;
    const json end = State("end.json"), again = State("again.json");
    EXPECT_GT(end["time"]["step"], 40);
    EXPECT_EQ(again["time"]["step"], end["time"]["step"]);
    EXPECT_EQ(HashOf(again, 0), HashOf(end, 0));
    EXPECT_GT(end["engines"][0]["picked"]["position"][0], 1.5) << "it was pulled there";
    for (const std::size_t pane : {0u, 1u}) {
        const std::string name = "pyramid-" + end["engines"][pane]["pane"].get<std::string>() + ".track";
        ASSERT_TRUE(folder.Has(name)) << State("saved.json")["message"];
        TrackFile track(folder.Read(name), name);
        ASSERT_EQ(track.GetLastStep(), end["time"]["step"]);
        const auto& bodies = track.Read(track.GetLastStep()).bodies;
        const json at = end["engines"][pane]["picked"]["position"];
        EXPECT_TRUE(std::ranges::any_of(bodies, [&](const TrackState& body) {
            return body.position.x == at[0].get<float>() && body.position.y == at[1].get<float>();
        })) << pane;
    }
    const int before = end["time"]["step"].get<int>() - 1;
    const auto file = folder.GetPath() / fmt::format("pyramid-{:04}.scene.json", before);
    ASSERT_TRUE(std::filesystem::exists(file)) << State("saved.json")["message"];
    EXPECT_EQ(ReadSceneFile(file).bodies.size(), 11u);
    EXPECT_EQ(folder.Run("info " + file.string()).exitCode, 0);
}

// The whole way of a user with a window: drag, go back, forward, save, and open what was saved.
TEST_F(ViewTime, AWindowOnADisplayOpensWhatWasDraggedAndSavedInIt) {
    ASSERT_EQ(std::system("command -v xvfb-run >/dev/null"), 0) << "tests/run installs it (package xvfb)";
    const ProgramResult result = PlayOnDisplay(pyramid, R"(10 move body scree 10
11 press
13 move world scree 3 7
40 release
45 key p
46 dump end.json
47 key home
50 dump home.json
51 key end
54 dump again.json
55 move item time.back
56 click
58 dump before.json
60 move item save.track
61 click
64 move item save.scene
65 click
68 dump saved.json
)",
                                               72);
    ASSERT_EQ(result.exitCode, 0) << result.output;
    const json end = State("end.json"), again = State("again.json"), before = State("before.json");
    ASSERT_GT(end["engines"][0]["picked"]["position"][0], 1.5) << "it was pulled there";
    EXPECT_EQ(State("home.json")["time"]["step"], 0);
    EXPECT_EQ(again["time"]["step"], end["time"]["step"]);
    EXPECT_EQ(HashOf(again, 0), HashOf(end, 0));
    const int last = end["time"]["step"];
    const std::string scene = fmt::format("pyramid-{:04}.scene.json", last - 1);
    ASSERT_TRUE(folder.Has(scene)) << State("saved.json")["message"];
    const std::string track = "pyramid-" + end["engines"][0]["pane"].get<std::string>() + ".track";
    ASSERT_TRUE(folder.Has(track)) << State("saved.json")["message"];
    for (const auto& [file, steps] : {std::pair(track, last), {scene, 0}}) {
        const ProgramResult info = folder.Run("info " + file + " --json");
        ASSERT_EQ(info.exitCode, 0) << info.output;
        const json facts = json::parse(info.output)["files"][0];
        // The track also has the body that the pointer held the box by.
        EXPECT_EQ(facts["bodies"], steps > 0 ? 12 : 11) << file;
        if (steps > 0) {
            EXPECT_EQ(facts["last_step"], steps);
        }
    }
    // Without a step more the saved scene is the moment, and the end of the saved track is where the drag ended.
    ASSERT_EQ(PlayOnDisplay(scene + " --paused", "4 dump scene.json\n", 8).exitCode, 0);
    EXPECT_EQ(HashOf(State("scene.json"), 0), HashOf(before, 0));
    ASSERT_EQ(PlayOnDisplay(track + " --paused", "4 key end\n8 dump track.json\n", 12).exitCode, 0);
    EXPECT_EQ(State("track.json")["time"]["step"], last);
    EXPECT_EQ(HashOf(State("track.json"), 0), HashOf(end, 0));
}

TEST_F(ViewTime, ADragInThePastChangesTheFuture) {
    const ProgramResult result = Play(pyramid, R"(30 key p
31 key left
33 key left
35 dump before.json
36 move body scree 10
37 press
39 move world scree 3 7
41 dump held.json
42 key p
60 release
61 key p
62 dump after.json
)");
    ASSERT_EQ(result.exitCode, 0) << result.output;
    EXPECT_EQ(State("before.json")["time"]["last_step"], 30);
    const json held = State("held.json"), after = State("after.json");
    EXPECT_EQ(held["time"]["last_step"], 28);
    EXPECT_TRUE(held["engines"][1]["exact"]) << "Box2D came there too";
    EXPECT_GT(after["time"]["step"], 40);
    for (const std::size_t pane : {0u, 1u}) {
        EXPECT_GT(after["engines"][pane]["picked"]["position"][0], 1.0) << pane;
    }
}

TEST_F(ViewTime, StopsWhereAnExpressionHoldsAsFindDoes) {
    ASSERT_EQ(folder
                  .Run("find falling-squares --size 5 --engine scree --set preset=like-box2d --steps 200 --when "
                       "'contacts() > 3' --json found.json")
                  .exitCode,
              1);
    const int step = json::parse(folder.Read("found.json"))["moments"][0]["step"];
    const ProgramResult result = Play("falling-squares --size 5 --engines scree --when 'contacts() > 3'",
                                      "199 dump stopped.json\n200 key p\n205 dump on.json\n");
    ASSERT_EQ(result.exitCode, 0) << result.output;
    const json stopped = State("stopped.json");
    EXPECT_TRUE(stopped["paused"]);
    EXPECT_EQ(stopped["time"]["step"], step);
    EXPECT_EQ(stopped["time"]["moments"][0]["condition"], "when");
    EXPECT_NE(stopped["message"].get<std::string>().find("contacts() > 3 holds"), std::string::npos);
    EXPECT_GT(State("on.json")["time"]["step"], step) << "it goes on when it is told to";
}

TEST_F(ViewTime, AnExpressionCanBeTypedAndItsMomentIsAMark) {
    const ProgramResult result = Play(pyramid, R"(0 key p
1 move body scree 10
2 press
3 release
4 move item time.when
5 click
7 text step == 25
9 key enter
11 key escape
12 move 600 40
13 key p
60 dump stopped.json
61 key right
63 key right
65 key j
70 dump back.json
71 move item time.when
72 click
74 text x
76 key enter
78 dump refused.json
)");
    ASSERT_EQ(result.exitCode, 0) << result.output;
    EXPECT_EQ(State("stopped.json")["time"]["step"], 25);
    EXPECT_EQ(State("back.json")["time"]["step"], 25) << "a mark stops the way back as well";
    EXPECT_NE(State("refused.json")["message"].get<std::string>().find("character"), std::string::npos)
        << State("refused.json")["message"];
}

TEST_F(ViewTime, TheInspectorTellsAllOfABodyAndItsFieldsAreEdits) {
    // A level with names and a joint.
    scenes::Scene scene = scenes::Build("pyramid", 4);
    scene.user = R"({"bodies": {"10": {"name": "top"}, "0": {"name": "floor"}}})";
    scenes::Joint joint;
    joint.type = scenes::JointType::distance;
    joint.bodyA = 10;
    joint.bodyB = 9;
    joint.length = 1.0f;
    scene.joints.push_back(joint);
    std::ofstream(folder.GetPath() / "level.scene.json") << WriteScene(scene);
    const ProgramResult result = Play("level.scene.json", R"(30 key p
31 key i
33 move item inspect.pick
34 click
36 text top
38 key enter
40 dump picked.json
41 move item edit.velocity
42 click
44 text 0, 7
46 key enter
48 dump pushed.json
49 move item edit.type
50 click
53 move item type.static
54 click
57 dump static.json
58 move item edit.density
59 click
61 text -3
63 key enter
65 dump refused.json
66 move item inspect.follow
67 click
70 dump follows.json
71 move item inspect.joints.0
72 click
76 move item inspect.joints.0.go
77 click
80 dump other.json
)");
    ASSERT_EQ(result.exitCode, 0) << result.output;
    const json picked = State("picked.json");
    ASSERT_EQ(picked["picked_body"], 10) << picked["message"];
    for (const std::size_t pane : {0u, 1u}) {
        const json body = picked["engines"][pane]["inspected"];
        EXPECT_EQ(body["title"], "top (10)");
        for (const char* name : {"type", "mass", "inertia", "damping", "gravity scale", "centre of mass", "density"}) {
            EXPECT_TRUE(body["values"].contains(name)) << name;
        }
        ASSERT_EQ(body["shapes"].size(), 1u);
        EXPECT_TRUE(body["shapes"][0]["values"].contains("friction"));
        EXPECT_EQ(body["contacts"].size(), 1u) << "it stands on two, and does not collide with the one it is joined to";
        EXPECT_TRUE(body["contacts"][0]["values"].contains("normal, A to B"));
        ASSERT_EQ(body["joints"].size(), 1u);
        EXPECT_TRUE(body["joints"][0]["values"].contains("length now"));
        EXPECT_EQ(State("pushed.json")["engines"][pane]["inspected"]["values"]["velocity"], "0, 7 m/s");
        EXPECT_EQ(State("static.json")["engines"][pane]["inspected"]["values"]["type"], "static");
    }
    EXPECT_NE(State("refused.json")["message"].get<std::string>().find("density: give 0 to"), std::string::npos);
    EXPECT_EQ(State("other.json")["picked_body"], 9) << "to which it is joined";
    const json follows = State("follows.json");
    EXPECT_TRUE(follows["follows"]);
    EXPECT_NEAR(follows["camera"][1].get<double>(), follows["engines"][0]["picked"]["position"][1].get<double>(), 1e-4);
}

TEST_F(ViewTime, OpensEveryKindOfInput) {
    ASSERT_EQ(folder.Run("convert pyramid level.track --size 4 --steps 40").exitCode, 0);
    ASSERT_EQ(folder.Run("convert pyramid level.scene.json --size 4").exitCode, 0);
    std::ofstream(folder.GetPath() / "level.json")
        << R"({"gravity": {"x": 0, "y": -10}, "stepsPerSecond": 60, "body": [{"type": 2, "awake": true, "name": "ball",
               "fixture": [{"density": 1, "circle": {"radius": 1}}]}]})";
    scree::Recorder recorder;
    scree::World world({0.0f, -10.0f});
    ASSERT_EQ(scree::StartRecording(world, recorder), scree::ErrorCode::ok);
    scree::BodyDef def;
    def.type = scree::dynamicBody;
    scree::CircleShape circle;
    circle.m_radius = 0.5f;
    world.CreateBody(&def)->CreateFixture(&circle, 1.0f);
    for (int i = 0; i < 20; ++i) world.Step(1.0f / 60.0f, 8, 3);
    scree::StopRecording(world);
    WriteBytes("level.recording", recorder.GetBytes());
    WriteBytes("level.world", scree::SaveWorld(world));
    world.Step(1.0f / 60.0f, 8, 3);
    Snapshot after;
    Capture(world, after);
    const std::string script = "4 key right\n6 dump step.json\n7 key left\n9 dump back.json\n";
    for (const char* file : {"level.track", "level.recording", "level.scene.json", "level.json", "level.world"}) {
        const ProgramResult result = Play(std::string(file) + " --paused", script);
        ASSERT_EQ(result.exitCode, 0) << file << ": " << result.output;
        EXPECT_EQ(State("step.json")["time"]["step"], 1) << file;
        EXPECT_EQ(State("back.json")["time"]["step"], 0) << file;
    }
    EXPECT_EQ(HashOf(State("step.json"), 0), fmt::format("{:016x}", after.stateHash)) << "an image goes on bit for bit";
    const ProgramResult motion =
        Play("level.track", "60 dump end.json\n61 key j\n75 dump back.json\n76 key b\n78 dump shot.json\n");
    ASSERT_EQ(motion.exitCode, 0) << motion.output;
    EXPECT_EQ(State("end.json")["time"]["step"], 40) << "a motion ends";
    EXPECT_TRUE(State("end.json")["paused"]);
    EXPECT_EQ(State("end.json")["engines"][0]["pane"], "as recorded");
    EXPECT_LT(State("back.json")["time"]["step"], 40);
    EXPECT_NE(State("shot.json")["message"].get<std::string>().find("cannot be changed"), std::string::npos);
}

TEST_F(ViewTime, TheMemoryForGoingBackHasALimit) {
    const ProgramResult result = Play("falling-squares --size 60 --memory 2",
                                      "150 key p\n152 dump full.json\n153 key home\n156 dump first.json\n");
    ASSERT_EQ(result.exitCode, 0) << result.output;
    const json full = State("full.json");
    EXPECT_EQ(full["time"]["memory_limit"], 2 << 20);
    for (const std::size_t pane : {0u, 1u}) EXPECT_LE(full["engines"][pane]["memory"], 1 << 20);
    EXPECT_EQ(State("first.json")["time"]["step"], 0);
}

}  // namespace
}  // namespace testbed
