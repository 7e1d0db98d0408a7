// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A track of a world of Box2D 3 has the states that the program saw, bit for bit, its contacts and joints, and starts
// engines.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include "testbed/engines/engine_run.h"
#include "testbed/input/scene_file.h"
#include "testbed/input/track_file.h"

namespace testbed {
namespace {

/// The folder of the program's files.
std::string Record() {
    static const std::string folder = [] {
        char name[] = "/tmp/scree-box2d3-XXXXXX";
        const std::string made = mkdtemp(name);
        EXPECT_EQ(std::system((std::string(SCREE_BOX2D3_PROGRAM) + " " + made).c_str()), 0);
        return made;
    }();
    return folder;
}

TEST(Box2d3Capture, HasEveryStateBitForBit) {
    TrackFile track = ReadTrackFile(Record() + "/session.track");
    EXPECT_EQ(track.GetLastStep(), 240);
    EXPECT_TRUE(track.GetInfo().engine.starts_with("Box2D 3.")) << track.GetInfo().engine;
    std::map<std::string, std::size_t> places;
    for (std::size_t i = 0; i < track.GetBodies().size(); ++i) places[track.GetBodies()[i].name] = i;
    EXPECT_EQ(places.size(), 16u);
    std::ifstream states(Record() + "/states.txt");
    int lines = 0;
    for (std::string line; std::getline(states, line); ++lines) {
        int step = 0, awake = 0, end = 0;
        double x = 0, y = 0, c = 0, s = 0, vx = 0, vy = 0, spin = 0;
        ASSERT_EQ(std::sscanf(line.c_str(), "%d %la %la %la %la %la %la %la %d %n", &step, &x, &y, &c, &s, &vx, &vy,
                              &spin, &awake, &end),
                  9)
            << line;
        const TrackState& state = track.Read(step).bodies[places.at(line.substr(static_cast<std::size_t>(end)))];
        ASSERT_TRUE(state.isThere) << line;
        const bool isStatic = line.ends_with("floor") || line.ends_with("hill");
        EXPECT_EQ(state.awake, awake != 0 && !isStatic) << line;
        EXPECT_EQ(state.position, (scenes::Vec2{static_cast<float>(x), static_cast<float>(y)})) << line;
        EXPECT_EQ(state.linearVelocity, (scenes::Vec2{static_cast<float>(vx), static_cast<float>(vy)})) << line;
        EXPECT_EQ(state.angularVelocity, static_cast<float>(spin)) << line;
        // Angles go on; rotations do not say how often.
        EXPECT_NEAR(std::cos(double{state.angle}), c, 1e-5) << line;
        EXPECT_NEAR(std::sin(double{state.angle}), s, 1e-5) << line;
    }
    EXPECT_GT(lines, 3000);
    EXPECT_GT(track.Read(240).bodies[places.at("wheel")].angle, 30.0f) << "four seconds at 9 rad/s";
    EXPECT_FALSE(track.Read(60).bodies[places.at("mover 11")].isThere);
    EXPECT_FALSE(track.Read(79).bodies[places.at("late")].isThere);
}

TEST(Box2d3Capture, HasContactsJointsAndTimes) {
    TrackFile track = ReadTrackFile(Record() + "/session.track");
    const TrackStep& step = track.Read(240);
    EXPECT_GT(step.contacts.size(), 8u);
    EXPECT_FALSE(step.stages.empty());
    std::set<std::string> told, expected;
    for (const TrackContact& contact : step.contacts) {
        EXPECT_NEAR(std::hypot(contact.normal.x, contact.normal.y), 1.0, 1e-5);
        const auto nameOf = [&](const TrackPlace& place) {
            return track.GetBodies()[static_cast<std::size_t>(place.body)].name;
        };
        std::string line = nameOf(contact.a) + "|" + nameOf(contact.b);
        for (int i = 0; i < contact.pointCount; ++i) {
            const auto place = static_cast<std::size_t>(i);
            char text[80];
            std::snprintf(text, sizeof text, " %a %a", static_cast<double>(contact.separations[place]),
                          static_cast<double>(contact.normalImpulses[place]));
            line += text;
            // All lie on or above the floor.
            EXPECT_GT(contact.points[place].y, -0.2f) << line;
        }
        told.insert(line);
    }
    std::ifstream lines(Record() + "/contacts.txt");
    for (std::string line; std::getline(lines, line);) expected.insert(line);
    EXPECT_EQ(told, expected) << "as the shapes themselves tell them";
    const scenes::Scene& parts = track.GetParts();
    ASSERT_EQ(parts.joints.size(), 3u) << "filter joints are left out";
    EXPECT_EQ(parts.joints[0].type, scenes::JointType::revolute);
    EXPECT_FLOAT_EQ(parts.joints[0].upperAngle, 1.0f);
    EXPECT_EQ(parts.joints[1].type, scenes::JointType::distance);
    EXPECT_GT(parts.joints[1].stiffness, 0.0f);
    EXPECT_EQ(parts.joints[2].type, scenes::JointType::weld);
}

TEST(Box2d3Capture, StartsEngines) {
    const scenes::Scene start = ReadSceneFile(Record() + "/start.scene.json");
    EXPECT_EQ(start.bodies.size(), 15u);
    TrackFile track = ReadTrackFile(Record() + "/session.track");
    for (const char* engine : {"scree", "box2d", "box2d3"}) {
        for (const scenes::Scene& scene : {start, track.SceneAt(100)}) {
            const std::unique_ptr<InteractiveRun> run = MakeRun(scene, MakeSpec(engine));
            for (int i = 0; i < 60; ++i) run->Step();
            Snapshot snapshot;
            run->Capture(snapshot);
            for (const BodyState& body : snapshot.bodies)
                EXPECT_GT(body.position.y, -1.0f) << engine << " " << body.index;
        }
    }
}

}  // namespace
}  // namespace testbed
