// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Scenes and drivers of the cases.

#include "testbed/jobs/bench/game_cases.h"

#include <cmath>
#include <vector>

#include "scenes/build.h"
#include "scenes/build_joints.h"
#include "scenes/catalog.h"

namespace testbed {
namespace {

using scenes::AddBody;
using scenes::AddFixture;
using scenes::BodyType;
using scenes::Scene;

/// Of dynamic boxes.
void AddBox(Scene& scene, double x, double y, double half = 0.5) {
    AddBody(scene, BodyType::dynamic, scenes::Point(x, y));
    AddFixture(scene, scenes::Box(half, half), 1.0).friction = 0.6f;
}

void AddGround(Scene& scene, double halfWidth) {
    AddBody(scene, BodyType::isStatic, {});
    AddFixture(scene, scenes::Edge(scenes::Point(-halfWidth, 0.0), scenes::Point(halfWidth, 0.0))).friction = 0.6f;
}

Scene Crates() {
    Scene scene;
    AddGround(scene, 1000.0);
    for (int i = 0; i < 1000; ++i) AddBox(scene, 1.5 * i - 750.0, 0.5);
    return scene;
}

constexpr int stackCount = 2000, stackHeight = 10;

/// Stacks, and behind them (the last body) a lone box in the air.
Scene Stacks(BodyType extra, int extraCount) {
    Scene scene;
    AddGround(scene, 2.0 * stackCount);
    for (int i = 0; i < stackCount; ++i) {
        for (int k = 0; k < stackHeight; ++k) AddBox(scene, 1.5 * i - 0.75 * stackCount, 0.5 + k);
    }
    for (int i = 0; i < extraCount; ++i) {
        AddBody(scene, extra, scenes::Point(40.0 * i - 400.0, 40.0));
        AddFixture(scene, scenes::Box(1.0, 0.25), extra == BodyType::dynamic ? 1.0 : 0.0);
        scene.bodies.back().gravityScale = 0.0f;
    }
    return scene;
}

/// Sleepers far from all else, two side by side, and ten disks that fly.
Scene Sleepers(BodyType type, bool hinged) {
    Scene scene;
    scene.gravity = {};
    for (int i = 0; i < 4000; ++i) {
        AddBody(scene, type, scenes::Point(5.0 * (i / 2 % 100) + 1.1 * (i % 2), 3.0 * (i / 200)));
        scene.bodies.back().awake = false;
        AddFixture(scene, scenes::Box(0.5, 0.5), type == BodyType::dynamic ? 1.0 : 0.0);
        if (!hinged || i % 2 == 0) continue;
        const double x = 5.0 * (i / 2 % 100) + 0.55, y = 3.0 * (i / 200);
        scenes::AddJoint(scene, scenes::JointType::revolute, i - 1, i, scenes::Point(x, y));
    }
    for (int i = 0; i < 10; ++i) {
        AddBody(scene, BodyType::dynamic, scenes::Point(-20.0, 3.0 * i));
        AddFixture(scene, scenes::Circle(0.3), 1.0);
        scene.bodies.back().allowSleep = false;
        scene.bodies.back().linearVelocity = {-1.0f, 0.0f};
    }
    return scene;
}

int Last(const LabWorld& lab) { return static_cast<int>(lab.GetScene().bodies.size()) - 1; }

void MoveLast(LabWorld& lab, int frame) { lab.SetPose(Last(lab), {0.01 * (frame % 400), 40.0}, 0.0); }
void RemakeLast(LabWorld& lab, int) { lab.RemakeBody(Last(lab)); }
void TeleportLast(LabWorld& lab, int frame) { lab.SetPose(Last(lab), {10.0 * (frame % 40) - 200.0, 40.0}, 0.3); }
void MovePlatforms(LabWorld& lab, int frame) {
    for (int i = 0; i < 20; ++i) lab.SetVelocity(Last(lab) - i, {frame % 120 < 60 ? 1.0 : -1.0, 0.0}, 0.0);
}

constexpr int walkerCount = 60;

void Walk(LabWorld& lab, int frame) {
    for (int i = 0; i < walkerCount; ++i) {
        const int body = Last(lab) - i;
        const double speed = (frame / 90 + i) % 2 == 0 ? 3.0 : -3.0;
        const double rise = lab.Read(body).velocity.y;
        lab.SetVelocity(body, {speed, (frame + 7 * i) % 100 == 0 ? 6.0 : rise}, 0.0);
    }
}

Scene TopDown() {
    Scene scene;
    scene.gravity = {};
    for (int i = 0; i < 2000; ++i) {
        AddBody(scene, BodyType::dynamic, scenes::Point(1.4 * (i % 50), 1.4 * (i / 50)));
        scene.bodies.back().linearDamping = 1.0f;
        scene.bodies.back().angularDamping = 1.0f;
        AddFixture(scene, i % 2 == 0 ? scenes::Circle(0.5) : scenes::Box(0.5, 0.4), 1.0);
    }
    return scene;
}
void Push(LabWorld& lab, int frame) {
    for (int i = 0; i < 40; ++i) {
        const double angle = 2.4 * (frame + 3 * i);
        lab.SetVelocity((97 * frame + 53 * i) % 2000, {6.0 * std::cos(angle), 6.0 * std::sin(angle)}, 1.0);
    }
}

constexpr int bulletCount = 20;

void Shoot(LabWorld& lab, int frame) {
    if (frame % 5 == 0) lab.RemakeBody(Last(lab) - frame / 5 % bulletCount);
}

/// Bodies of the rows that begin above the pile: made anew they fall on it.
void Churn(LabWorld& lab, int frame) {
    constexpr int above = 360;
    for (int i = 0; i < 4; ++i) lab.RemakeBody(Last(lab) - (4 * frame + i) % above);
}

/// A stack, a hinge, some loose things.
Scene Tiny() {
    Scene scene;
    AddGround(scene, 20.0);
    for (int i = 0; i < 5; ++i) AddBox(scene, 0.0, 0.5 + i);
    for (int i = 0; i < 4; ++i) AddBox(scene, 3.0 + 2.0 * i, 0.5);
    AddBody(scene, BodyType::dynamic, scenes::Point(-4.0, 5.0));
    AddFixture(scene, scenes::Box(0.5, 0.2), 1.0);
    scenes::AddJoint(scene, scenes::JointType::revolute, 0, scenes::LastBody(scene), scenes::Point(-4.5, 5.0));
    AddBody(scene, BodyType::dynamic, scenes::Point(-8.0, 0.5));
    AddFixture(scene, scenes::Circle(0.5), 1.0);
    return scene;
}
Scene Empty() { return {}; }

void AddLevel(Scene& scene, int count) {
    for (int i = 0; i < count; ++i) {
        AddBody(scene, BodyType::isStatic, scenes::Point(1.7 * (i % 200), 2.3 * (i / 200) - 150.0));
        AddFixture(scene, scenes::Box(0.6, 0.3, {}, 0.1 * (i % 30)));
    }
}
Scene Level() {
    Scene scene;
    AddLevel(scene, 20000);
    for (int i = 0; i < 2000; ++i) AddBox(scene, 1.7 * (i % 200) + 0.3, 2.3 * (i / 200) + 90.0, 0.3);
    return scene;
}
Scene RestingLevel() {
    Scene scene;
    AddLevel(scene, 5000);
    for (scenes::Body& body : scene.bodies) body.position.y += 150.0f;
    return scene;
}
void Ask(LabWorld& lab, int frame) {
    for (int i = 0; i < 2000; ++i) {
        const double x = (37 * i + frame) % 340, y = (53 * i) % 58;
        (void)lab.CastRay({x, y}, {x + 20.0 * std::cos(0.7 * i), y + 20.0 * std::sin(0.7 * i)});
    }
    for (int i = 0; i < 500; ++i) {
        const double x = (61 * i + frame) % 340, y = (29 * i) % 58;
        (void)lab.CountInBox({x, y}, {x + 6.0, y + 4.0});
    }
}

std::vector<GameCase> MakeCases() {
    const auto stacks = [](BodyType extra, int count) { return [extra, count] { return Stacks(extra, count); }; };
    return {
        {.name = "crates", .what = "1,000 boxes at rest, awake", .build = Crates, .sleeping = false},
        {.name = "asleep", .what = "20,000 boxes in stacks, asleep", .build = stacks(BodyType::kinematic, 1)},
        {.name = "asleep-mover",
         .what = "the same, a body set in each frame",
         .build = stacks(BodyType::kinematic, 1),
         .play = MoveLast},
        {.name = "asleep-platforms",
         .what = "the same, 20 platforms that move",
         .build = stacks(BodyType::kinematic, 20),
         .play = MovePlatforms},
        {.name = "asleep-spawn",
         .what = "the same, a body made and destroyed in each frame",
         .build = stacks(BodyType::dynamic, 1),
         .play = RemakeLast},
        {.name = "asleep-teleport",
         .what = "the same, a body teleported in each frame",
         .build = stacks(BodyType::dynamic, 1),
         .play = TeleportLast},
        {.name = "asleep-kinematic",
         .what = "4,000 kinematic bodies at rest, ten disks that fly",
         .build = [] { return Sleepers(BodyType::kinematic, false); }},
        {.name = "asleep-joints",
         .what = "2,000 hinged pairs asleep, ten disks that fly",
         .build = [] { return Sleepers(BodyType::dynamic, true); }},
        {.name = "platformer",
         .what = "a level of a chain, blocks, sensors, crates; 60 walkers; a listener",
         .build = [] { return scenes::Build("platformer", walkerCount); },
         .play = Walk,
         .listens = true},
        {.name = "ragdolls",
         .what = "50 figures fall",
         .build = [] { return scenes::Build("ragdolls", 50); },
         .warmUp = 30},
        {.name = "cars", .what = "50 cars on bumps", .build = [] { return scenes::Build("cars", 50); }, .warmUp = 60},
        {.name = "top-down",
         .what = "2,000 bodies without gravity, 40 pushed in each frame",
         .build = TopDown,
         .play = Push},
        {.name = "bullets",
         .what = "bullets into a heap of 300",
         .build = [] { return scenes::Build("bullets", bulletCount); },
         .play = Shoot,
         .warmUp = 90},
        {.name = "bin",
         .what = "a bin of 2,000, four made anew in each frame",
         .build = [] { return scenes::Build("bin", 2000); },
         .play = Churn,
         .warmUp = 200,
         .frames = 100},
        {.name = "heap-listener",
         .what = "a heap of 1,500, a listener",
         .build = [] { return scenes::Build("bin", 1500); },
         .sleeping = false,
         .listens = true,
         .warmUp = 200,
         .frames = 100},
        {.name = "heap",
         .what = "the same without",
         .build = [] { return scenes::Build("bin", 1500); },
         .sleeping = false,
         .warmUp = 200,
         .frames = 100},
        {.name = "tiny",
         .what = "one of 125 worlds of 12 bodies, awake",
         .build = Tiny,
         .sleeping = false,
         .frames = 100,
         .worlds = 125},
        {.name = "empty", .what = "one of 125 worlds without bodies", .build = Empty, .frames = 100, .worlds = 125},
        {.name = "queries",
         .what = "2,000 rays and 500 boxes against a level of 5,000",
         .build = RestingLevel,
         .play = Ask,
         .warmUp = 2,
         .frames = 20,
         .timing = GameTiming::queries},
        {.name = "load", .what = "a level of 22,000 made", .build = Level, .frames = 1, .timing = GameTiming::creation},
        {.name = "load-step", .what = "its first step", .build = Level, .frames = 1, .timing = GameTiming::firstStep},
        {.name = "load-fresh",
         .what = "the same level made in memory that the program did not have before",
         .build = Level,
         .frames = 1,
         .timing = GameTiming::creation,
         .isFresh = true},
    };
}

}  // namespace

std::span<const GameCase> GetGameCases() {
    static const std::vector<GameCase> cases = MakeCases();
    return cases;
}

}  // namespace testbed
