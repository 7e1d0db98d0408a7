// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree find` names the moments that were hidden in sessions, in every kind of input, for readers and for programs.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "scree/world.h"
#include "testbed/base/errors.h"
#include "testbed/capture/scree_capture.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

using Json = nlohmann::json;

/// A box full of balls that a paddle stirs, without continuous collision. In step `hidden` one of them goes through a
/// wall: body 137, "escapee". Returns its number in the track.
void RecordStirredBox(const std::string& path, int balls, int steps, int hidden) {
    std::mt19937 random(11);
    scree::WorldDef worldDef;
    worldDef.continuousPhysics = false;
    scree::World world(worldDef);
    const scree::BodyDef groundDef;
    scree::Body* walls = world.CreateBody(&groundDef);
    const scree::Vec2 corners[] = {{-10, 0}, {10, 0}, {10, 20}, {-10, 20}};
    for (int i = 0; i < 4; ++i) {
        scree::EdgeShape edge;
        edge.SetTwoSided(corners[i], corners[(i + 1) % 4]);
        walls->CreateFixture(&edge, 0.0f);
    }
    std::vector<scree::Body*> bodies;
    for (int i = 0; i < balls; ++i) {
        scree::BodyDef def;
        def.type = scree::dynamicBody;
        def.position = {static_cast<float>(i % 18) - 8.5f, 1.0f + static_cast<float>(i / 18)};
        bodies.push_back(world.CreateBody(&def));
        scree::CircleShape circle;
        circle.m_radius = 0.3f;
        scree::FixtureDef fixture;
        fixture.shape = &circle;
        fixture.density = 1.0f;
        bodies.back()->CreateFixture(&fixture);
    }
    scree::BodyDef paddleDef;
    paddleDef.type = scree::kinematicBody;
    paddleDef.position = {0.0f, 4.0f};
    paddleDef.angularVelocity = 1.0f;
    scree::PolygonShape paddle;
    paddle.SetAsBox(4.0f, 0.2f);
    world.CreateBody(&paddleDef)->CreateFixture(&paddle, 0.0f);
    scree_capture::Options options;
    options.contacts = true;
    scree_capture::Track track(world, path, options);
    scree::Body* escapee = bodies[136];
    track.Name(escapee, "escapee");
    track.Name(walls, "walls");
    for (int step = 1; step <= steps; ++step) {
        if (step == hidden - 1) {
            // Near a wall, where no other is,
            escapee->SetTransform({9.0f, 19.0f}, 0.0f);
            escapee->SetLinearVelocity({0.0f, 0.0f});
        } else if (step == hidden) {
            // and much too fast.
            escapee->SetLinearVelocity({150.0f, 0.0f});
        }
        world.Step(1.0f / 60.0f, 8, 3);
        track.Step(1.0f / 60.0f);
    }
    track.Close();
}

class Find : public testing::Test {
protected:
    [[nodiscard]] ProgramResult Run(const std::string& arguments) const { return folder.Run("find " + arguments); }
    void Expect(const std::string& arguments, int exitCode, const std::string& says) const {
        const ProgramResult result = Run(arguments);
        EXPECT_EQ(result.exitCode, exitCode) << arguments << "\n" << result.output;
        EXPECT_NE(result.output.find(says), std::string::npos) << arguments << "\n" << result.output;
    }
    ScratchFolder folder;
};

TEST_F(Find, WhatSomebodyWritesIsFound) {
    const int hidden = 40;
    RecordStirredBox(folder.GetPath() / "stirred.track", 300, 60, hidden);
    Expect("stirred.track --when 'body(\"escapee\").x > 10'", exitDiffers,
           "step 40-60, 0.67 s: when: escapee (137): body(\"escapee\").x > 10 holds");
    Expect("stirred.track --when 'contacts(\"walls\") < 0' --when 'body(137).speed > 100 and step > 45'", exitDiffers,
           "step 46-60, 0.77 s: when-2: escapee (137)");
    Expect("stirred.track --when 'contacts(\"walls\") < 0'", exitDone, "0 moments in 60 steps: when");
    Expect("stirred.track --when 'body(\"escape\").x > 10'", exitUsage,
           "--when 'body(\"escape\").x > 10': character 6, 'escape': no body is called so; did you mean 'escapee'?");
    // The same bodies by the same names where an engine starts from a step of it.
    Expect("stirred.track --from 39 --steps 5 --set continuous=off --when 'body(137).y > 100'", exitDone,
           "0 moments in 5");
}

/// A session of ten seconds; SCREE_LONG_SESSION asks for ten minutes.
TEST_F(Find, TheHiddenTunnelOfALongSessionIsNamed) {
    const int steps = std::getenv("SCREE_LONG_SESSION") != nullptr ? 36'000 : 600, hidden = steps / 3 * 2;
    RecordStirredBox(folder.GetPath() / "stirred.track", 300, steps, hidden);
    const ProgramResult result = Run("stirred.track --tunnel --json found.json --junit found.xml --pictures pictures");
    EXPECT_EQ(result.exitCode, exitDiffers) << result.output;
    EXPECT_NE(
        result.output.find(fmt::format("step {}, {:.2f} s: tunnel: escapee (137), walls (0): went through, at 150 "
                                       "m/s; pictures/01-tunnel-step-{:04}.png",
                                       hidden, hidden / 60.0, hidden)),
        std::string::npos)
        << result.output;
    const Json found = Json::parse(folder.Read("found.json"));
    EXPECT_EQ(found.at("steps"), steps);
    ASSERT_EQ(found.at("moments").size(), 1u) << found.dump(1);
    const Json& moment = found.at("moments")[0];
    EXPECT_EQ(moment.at("condition"), "tunnel");
    EXPECT_EQ(moment.at("step"), hidden);
    EXPECT_EQ(moment.at("bodies")[0].at("index"), 137);
    EXPECT_EQ(moment.at("bodies")[0].at("name"), "escapee");
    EXPECT_TRUE(folder.Has(moment.at("picture").get<std::string>()));
    EXPECT_NE(folder.Read("found.xml").find("failures=\"1\""), std::string::npos);
    EXPECT_NE(folder.Read("found.xml").find(fmt::format("<failure message=\"step {}", hidden)), std::string::npos);

    Expect("stirred.track --speed 100", exitDiffers, "speed: escapee (137): as fast as");
    Expect("stirred.track --escape=-11,-1,11,21", exitDiffers,
           fmt::format("step {}, {:.2f} s: escape: escapee (137)", hidden, hidden / 60.0));
    // A part of it, with its times.
    Expect(fmt::format("stirred.track --tunnel --steps {}:{}", hidden, hidden + 9), exitDiffers,
           fmt::format("step {}, {:.2f} s: tunnel: escapee (137)", hidden, hidden / 60.0));
    Expect(fmt::format("stirred.track --tunnel --steps {}:{}", hidden + 1, hidden + 9), exitDone,
           "0 moments in 9 steps");
    Expect(fmt::format("stirred.track --tunnel --steps {}", hidden - 1), exitDone,
           fmt::format("0 moments in {} steps", hidden - 1));
    Expect(fmt::format("stirred.track --steps {}:{}", steps + 1, steps + 2), exitUsage,
           fmt::format("the last step is {}", steps));
    Expect("stirred.track --steps 1:9:2", exitUsage, "give first:last");
    Expect("stirred.track --overlap 2", exitDone, fmt::format("0 moments in {} steps: overlap", steps));
    Expect("stirred.track", exitDiffers, fmt::format("1 moment in {} steps: tunnel, non-finite", steps));
    const ProgramResult page = folder.Run("timeline stirred.track --contacts off -o page.html");
    EXPECT_EQ(page.exitCode, exitDone) << page.output;
    EXPECT_NE(folder.Read("page.html").find(fmt::format("step {}: tunnel: escapee (137), walls (0)", hidden)),
              std::string::npos);

    // A link into that page, wherever the list of moments stands.
    const std::string link = fmt::format("page.html#step={}&body=137,0", hidden);
    Expect("stirred.track --tunnel --timeline page.html --json linked.json --page pictures/moments.html", exitDiffers,
           link);
    EXPECT_EQ(Json::parse(folder.Read("linked.json")).at("moments")[0].at("link"), link);
    const std::string moments = folder.Read("pictures/moments.html");
    EXPECT_NE(moments.find(fmt::format("href=\"../page.html#step={}&amp;body=137,0\"", hidden)), std::string::npos);
    EXPECT_NE(moments.find("data:image/png;base64,"), std::string::npos);
    Expect("stirred.track --tunnel --timeline none.html", exitUsage, "`scree timeline stirred.track -o none.html`");
}

TEST_F(Find, ScenesAreRunInAnyEngine) {
    std::ofstream(folder.GetPath() / "bullet.scene.json")
        << R"({"format": "scree-scene", "version": 1, "gravity": [0, 0],
        "bodies": [{"fixtures": [{"shape": {"type": "edge", "vertices": [[0, -5], [0, 5]]}}]},
                   {"type": "dynamic", "position": [-5.2, 0], "linearVelocity": [100, 0],
                    "fixtures": [{"density": 1, "shape": {"type": "circle", "radius": 0.1}}]}],
        "user": {"bodies": {"1": {"name": "shot"}}}})";
    Expect("pyramid --size 4 --steps 60", exitDone, "0 moments in 60 steps: tunnel, non-finite");
    Expect("pyramid --size 4 --steps 60 --engine box2d --pile-on 3", exitDiffers, "contacts");
    Expect("bullet.scene.json --steps 60 --set continuous=off", exitDiffers,
           "step 4, 0.07 s: tunnel: shot (1), body 0");
    Expect("bullet.scene.json --steps 60 --set continuous=on", exitDone, "0 moments");
    Expect("pyramid --size 6 --steps 60 --spike 1000000", exitDone, "0 moments");
    Expect("tumbler --size 20 --steps 40 --diverge box2d --distance 100 --engine scree", exitDone, "moments in 40");
    Expect("pyramid --size 4 --steps 30 --diverge scree:threads=3", exitDone, "0 moments");
    Expect("pyramid --size 4 --steps 30 --diverge scree:solver=soft@4", exitDiffers, "away from where it is");
}

TEST_F(Find, WhateverABodyOrAFileIsCalled) {
    std::ofstream(folder.GetPath() / "my level.scene.json") << R"({"format": "scree-scene", "version": 1,
        "bodies": [{"type": "dynamic", "fixtures": [{"density": 1, "shape": {"type": "circle", "radius": 0.1}}]}],
        "user": {"bodies": {"0": {"name": "M\u00fcller \"</b>\"\n\u001b[31m"}}}})";
    // What a shell would take apart is quoted, so that the line can be given to it again.
    Expect("'my level.scene.json' --speed 1 --timeline 'run #1.html'", exitUsage,
           "`scree timeline 'my level.scene.json' -o 'run #1.html'`");
    ASSERT_EQ(folder.Run("timeline 'my level.scene.json' --steps 9 -o 'run #1.html'").exitCode, exitDone);
    Expect(
        "'my level.scene.json' --steps 9 --speed 1 --timeline 'run #1.html' --json a.json --junit a.xml --page a.html",
        exitDiffers, "M\u00fcller \"</b>\"\u240a\u241b[31m (0): as fast as");
    const Json found = Json::parse(folder.Read("a.json"));
    EXPECT_EQ(
        found.at("command"),
        "scree find 'my level.scene.json' --steps 9 --speed 1 --timeline 'run #1.html' --json a.json --junit a.xml "
        "--page a.html");
    EXPECT_EQ(found.at("moments")[0].at("bodies")[0].at("name"), "M\u00fcller \"</b>\"\n\u001b[31m");
    EXPECT_EQ(found.at("moments")[0].at("link"), "run%20%231.html#step=6&body=0");
    EXPECT_NE(folder.Read("a.html").find("href=\"run%20%231.html#step=6&amp;body=0\""), std::string::npos);
    const std::string check =
        "python3 -c 'import xml.dom.minidom as m; m.parse(\"" + (folder.GetPath() / "a.xml").string() + "\")'";
    EXPECT_EQ(std::system(check.c_str()), 0) << folder.Read("a.xml");
    // Names stay in a track of a run, in both engines.
    for (const char* engine : {"scree", "box2d"}) {
        const std::string convert = "convert 'my level.scene.json' run.track --steps 9 --engine ";
        ASSERT_EQ(folder.Run(convert + engine).exitCode, exitDone);
        Expect("run.track --speed 1", exitDiffers, "M\u00fcller \"</b>\"\u240a\u241b[31m (0): as fast as");
    }
}

TEST_F(Find, TwoFilesDivergeWhereTheyDo) {
    ASSERT_EQ(folder.Run("convert pyramid --size 5 a.track --steps 80").exitCode, 0);
    ASSERT_EQ(folder.Run("convert pyramid --size 5 b.track --steps 80 --engine box2d").exitCode, 0);
    Expect("a.track --diverge a.track", exitDone, "0 moments in 80 steps: diverge");
    Expect("a.track --diverge b.track", exitDiffers, "1 moment in 80 steps: diverge");
    Expect("a.track --from 10 --steps 20 --diverge box2d --distance 100", exitDone, "0 moments in 20 steps");
}

TEST_F(Find, WhatCannotBeMeantIsRefused) {
    scree::World world({0.0f, -10.0f});
    {
        scree_capture::Track track(world, (folder.GetPath() / "bare.track").string());
        for (int i = 0; i < 5; ++i) world.Step(1.0f / 60.0f, 8, 3), track.Step(1.0f / 60.0f);
    }
    Expect("", exitUsage, "where? Give a file");
    Expect("bare.track --overlap 0.1", exitUsage, "recorded without contacts");
    Expect("bare.track --spike 3", exitUsage, "recorded without times");
    Expect("bare.track --engine box2d", exitUsage, "need --from K");
    Expect("bare.track --diverge box2d", exitUsage, "give another file");
    Expect("bare.track --escape 1,2,3", exitUsage, "give left,bottom,right,top");
    Expect("pyramid --overlap -1", exitUsage, "--overlap");
    Expect("pyramid --longer 1", exitUsage, "--longer requires --overlap");
    Expect("pyramid --distance 1", exitUsage, "--distance requires --diverge");
    for (const char* option : {"--json", "--junit", "--page"}) {
        Expect(fmt::format("tumbler --steps 1000000 {} no-folder/file", option), exitIo, "cannot write no-folder/file");
    }
    Expect("pyramid --engine scree,box2d", exitUsage, "give one engine");
    Expect("pyramid --engine bulet", exitUsage, "unknown engine");
}

}  // namespace
}  // namespace testbed
