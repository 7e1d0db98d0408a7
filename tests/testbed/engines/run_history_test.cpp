// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Going back in time. Our engine comes to the same bits as on the way forward, whatever its user did. Other engines
// show frames that were kept. What is changed in the past takes the place of the future.

#include "testbed/engines/run_history.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "scenes/catalog.h"
#include "testbed/base/input.h"
#include "testbed/engines/panes.h"
#include "testbed/input/scene_file.h"
#include "testbed/input/track_file.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

constexpr std::size_t plenty = std::size_t{1} << 30;

RunHistory MakeHistory(const std::string& scene, int size, const std::string& engine, std::size_t limit = plenty) {
    const RunSpec spec = ParsePanes(engine).front().spec;
    return {[=] { return MakeRun(scenes::Build(scene, size), spec); }, limit};
}

Snapshot Look(RunHistory& history) {
    Snapshot snapshot;
    history.Capture(snapshot, {});
    return snapshot;
}

/// What somebody might do with the mouse and the panels between two steps.
void DoSomething(RunHistory& history, std::mt19937& random) {
    const auto real = [&](float most) { return std::uniform_real_distribution<float>(-most, most)(random); };
    const Snapshot now = Look(history);
    std::vector<int> dynamic;
    for (const BodyState& body : now.bodies) {
        if (body.type == scenes::BodyType::dynamic) dynamic.push_back(body.index);
    }
    const int body = dynamic[random() % dynamic.size()];
    switch (random() % 9) {
        case 0:
            history.BeginDrag(body, {real(0.2f), real(0.2f)});
            break;
        case 1:
            history.MoveDrag({real(9), real(9)});
            break;
        case 2:
            history.EndDrag();
            break;
        case 3:
            history.ShootBullet({real(9), 9}, {real(50), real(50)});
            break;
        case 4: {
            RunSpec spec = history.GetSpec();
            spec.gravity = Vec2{real(5), real(20)};
            spec.warmStarting = random() % 2 == 0;
            spec.sleeping = random() % 2 == 0;
            spec.timeStep = 1.0 / static_cast<double>(40 + random() % 60);
            history.Apply(spec);
            break;
        }
        case 5:
            history.Edit(body, {.position = Vec2{real(9), 5 + real(4)}, .linearVelocity = Vec2{real(9), real(9)}});
            break;
        case 6:
            history.Edit(body, {.angle = real(3), .angularVelocity = real(9), .density = 1 + random() % 5});
            break;
        case 7:
            history.Edit(body, {.type = static_cast<scenes::BodyType>(random() % 3), .bullet = true});
            break;
        default:
            history.Edit(body, {.linearDamping = 1.0f, .gravityScale = real(2), .fixedRotation = random() % 2 == 0});
    }
}

struct Case {
    const char *scene, *engine;
    int size;
    std::size_t limit;
};

/// Hashes after each step, before anything is done there.
std::vector<std::uint64_t> PlayForward(RunHistory& history, int steps, std::mt19937& random) {
    std::vector<std::uint64_t> hashes{Look(history).stateHash};
    for (int i = 0; i < steps; ++i) {
        for (std::size_t k = random() % 3; k > 0 && i > 0; --k) DoSomething(history, random);
        history.Step();
        hashes.push_back(Look(history).stateHash);
    }
    return hashes;
}

TEST(RunHistory, OurEngineGoesBackBitForBitWhateverItsUserDid) {
    const Case cases[]{{"pyramid", "scree", 6, plenty},
                       {"pyramid", "scree:solver=soft@4:threads=2", 6, plenty},
                       {"tumbler", "scree", 30, 60'000},
                       {"bridge", "scree:solver=soft@8", 12, 150'000},
                       {"joint-row", "scree", 0, 1}};
    for (const Case& one : cases) {
        if (scenes::Find(one.scene) == nullptr) continue;
        SCOPED_TRACE(std::string(one.scene) + " " + one.engine);
        const scenes::SceneInfo& info = *scenes::Find(one.scene);
        const int size = std::clamp(one.size, info.minSize, info.maxSize);
        std::mt19937 random(7);
        RunHistory history = MakeHistory(one.scene, size, one.engine, one.limit);
        constexpr int steps = 90;
        const std::vector<std::uint64_t> hashes = PlayForward(history, steps, random);
        ASSERT_EQ(history.GetLastStep(), steps);
        EXPECT_GT(history.GetActions().size(), 40u);
        if (one.limit < plenty) {
            EXPECT_GT(history.GetSpacing(), 4) << history.GetBytes();
        }
        for (int i = 0; i < 40; ++i) {
            const int step = i == 0 ? steps - 1 : static_cast<int>(random() % steps);
            history.GoTo(step);
            EXPECT_TRUE(history.IsExact());
            EXPECT_EQ(Look(history).stateHash, hashes[static_cast<std::size_t>(step)]) << step;
            EXPECT_EQ(Look(history).step, step);
        }
        // Forward through what was there, the drags and changes of it included.
        history.GoTo(0);
        for (int step = 1; step <= steps; ++step) {
            history.Step();
            ASSERT_EQ(Look(history).stateHash, hashes[static_cast<std::size_t>(step)]) << step;
        }
        EXPECT_EQ(history.GetLastStep(), steps);
    }
}

TEST(RunHistory, TheLimitOfMemoryHolds) {
    for (const char* engine : {"scree", "box2d"}) {
        constexpr std::size_t limit = 400'000;
        RunHistory history = MakeHistory("pyramid", 10, engine, limit);
        for (int i = 0; i < 300; ++i) {
            history.Step();
            (void)Look(history);
            ASSERT_LE(history.GetBytes(), limit);
        }
        EXPECT_GT(history.GetBytes(), limit / 4) << "of what it may";
        history.GoTo(3);
        EXPECT_LE(Look(history).step, 3);
    }
}

TEST(RunHistory, WhatIsDoneInThePastTakesThePlaceOfTheFuture) {
    for (const std::string engine : {"scree", "box2d"}) {
        SCOPED_TRACE(engine);
        const auto play = [&](RunHistory& history, bool goesBack) {
            for (int i = 0; i < 50; ++i) {
                history.Step();
                (void)Look(history);
                if (i == 9) history.BeginDrag(10, {0, 0.1f});
                if (i == 10) history.MoveDrag({3, 8});
            }
            if (goesBack) {
                history.EndDrag();
                history.Edit(10, {.position = Vec2{9, 9}});
                history.GoTo(30);
            }
        };
        RunHistory changed = MakeHistory("pyramid", 4, engine);
        play(changed, true);
        EXPECT_EQ(changed.GetStep(), 30);
        EXPECT_EQ(changed.GetLastStep(), 50);
        changed.ShootBullet({-9, 3}, {40, 0});
        EXPECT_EQ(changed.GetLastStep(), 30) << "what came then has not happened";
        EXPECT_TRUE(changed.IsExact());
        for (int i = 0; i < 20; ++i) changed.Step();

        // The same without any way back.
        RunHistory straight = MakeHistory("pyramid", 4, engine);
        for (int i = 0; i < 30; ++i) {
            straight.Step();
            if (i == 9) straight.BeginDrag(10, {0, 0.1f});
            if (i == 10) straight.MoveDrag({3, 8});
        }
        straight.EndDrag();
        straight.ShootBullet({-9, 3}, {40, 0});
        for (int i = 0; i < 20; ++i) straight.Step();
        EXPECT_EQ(Look(changed).stateHash, Look(straight).stateHash);
    }
}

TEST(RunHistory, OtherEnginesShowFramesThatWereKept) {
    RunHistory history = MakeHistory("pyramid", 5, "box2d");
    std::vector<Snapshot> seen{Look(history)};
    for (int i = 0; i < 40; ++i) {
        history.Step();
        seen.push_back(Look(history));
    }
    for (const int step : {39, 0, 17}) {
        history.GoTo(step);
        EXPECT_FALSE(history.IsExact());
        const Snapshot back = Look(history);
        EXPECT_EQ(back.step, step);
        EXPECT_EQ(back.stateHash, seen[static_cast<std::size_t>(step)].stateHash);
        EXPECT_EQ(back.contacts.size(), seen[static_cast<std::size_t>(step)].contacts.size());
        EXPECT_TRUE(history.ValuesOfBody(1).empty()) << "only the engine knows masses";
    }
    while (history.GetStep() < 40) history.Step();
    EXPECT_TRUE(history.IsExact());
    EXPECT_FALSE(history.ValuesOfBody(1).empty());
    history.Step();
    EXPECT_EQ(history.GetLastStep(), 41);
}

TEST(RunHistory, SavedTracksAndScenesAreWhatWasSeen) {
    const ScratchFolder folder;
    for (const std::string engine : {"scree", "box2d"}) {
        SCOPED_TRACE(engine);
        std::mt19937 random(5);
        RunHistory history = MakeHistory("pyramid", 4, engine);
        for (int i = 0; i < 30; ++i) {
            if (i == 3) history.BeginDrag(9, {0.1f, 0});
            if (i == 4) history.MoveDrag({4, 6});
            if (i == 20) history.EndDrag();
            if (i == 22) history.Edit(5, {.linearVelocity = Vec2{3, 8}});
            history.Step();
            (void)Look(history);
        }
        const std::string file = (folder.GetPath() / (engine + ".track")).string();
        history.GoTo(12);
        history.WriteTrack(file);
        EXPECT_EQ(history.GetStep(), 12) << "writing moves nothing";
        auto track = std::make_shared<TrackFile>(ReadText(file, ""), file);
        EXPECT_EQ(track->GetLastStep(), 30);
        RunHistory recorded(track, 0);
        EXPECT_EQ(recorded.GetLastStep(), 30);
        for (const int step : {30, 5, 21}) {
            history.GoTo(step);
            recorded.GoTo(step);
            EXPECT_EQ(recorded.GetStep(), step);
            // The body to which the mouse pulls is in the track too.
            const Snapshot a = Look(history), b = Look(recorded);
            for (const BodyState& body : a.bodies) {
                const auto same = [&](const BodyState& other) {
                    return other.position == body.position && other.angle == body.angle;
                };
                EXPECT_TRUE(std::ranges::any_of(b.bodies, same)) << step << " body " << body.index;
            }
        }
        EXPECT_THROW(recorded.ShootBullet({}, {}), std::invalid_argument);
        history.GoTo(25);
        const scenes::Scene scene = ReadScene(WriteScene(history.MakeScene()), "saved");
        const Snapshot then = Look(history);
        ASSERT_EQ(scene.bodies.size(), then.bodies.size());
        for (const BodyState& body : then.bodies) {
            EXPECT_EQ(scene.bodies[static_cast<std::size_t>(body.index)].position, body.position);
            EXPECT_EQ(scene.bodies[static_cast<std::size_t>(body.index)].linearVelocity, body.linearVelocity);
        }
    }
}

TEST(RunHistory, AScenesSpawnsAreStillToComeWhereItIsSaved) {
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        scenes::Scene built = scenes::Build(info.name, info.minSize);
        if (built.spawns.empty()) continue;
        const RunSpec spec = ParsePanes("scree").front().spec;
        RunHistory history([&] { return MakeRun(built, spec); }, plenty);
        for (int i = 0; i < 5; ++i) history.Step();
        const scenes::Scene saved = ReadScene(WriteScene(history.MakeScene()), "saved");
        EXPECT_EQ(saved.bodies.size(), built.bodies.size()) << info.name;
        EXPECT_EQ(saved.InitialBodyCount(), static_cast<int>(Look(history).bodies.size())) << info.name;
        return;
    }
    FAIL() << "no scene has spawns";
}

TEST(RunHistory, EditsAreRefusedWholeOrDone) {
    for (const std::string engine : {"scree", "box2d"}) {
        RunHistory history = MakeHistory("pyramid", 4, engine);
        const std::uint64_t before = Look(history).stateHash;
        EXPECT_THROW(history.Edit(99, {}), std::invalid_argument);
        EXPECT_THROW(history.Edit(1, {.angle = 1.0f, .density = -1.0f}), std::invalid_argument);
        EXPECT_THROW(history.Edit(1, {.position = Vec2{std::nanf(""), 0}}), std::invalid_argument);
        EXPECT_EQ(Look(history).stateHash, before);
        EXPECT_TRUE(history.GetActions().empty());
        const auto value = [&](const RunValues& values, std::string_view name) {
            const auto found = std::ranges::find(values, name, &RunValue::name);
            return found == values.end() ? std::string() : found->value;
        };
        const float mass = std::stof(value(history.ValuesOfBody(1), "mass"));
        history.Edit(1, {.density = 3.0f * std::stof(value(history.ValuesOfFixture(1), "density"))});
        EXPECT_NEAR(std::stof(value(history.ValuesOfBody(1), "mass")), 3 * mass, 1e-3f * mass);
        history.Edit(1, {.type = scenes::BodyType::kinematic});
        EXPECT_EQ(value(history.ValuesOfBody(1), "type"), "kinematic");
        EXPECT_THROW(history.BeginDrag(1, {}), std::invalid_argument) << "not dynamic any more";
        history.Edit(1, {.type = scenes::BodyType::dynamic});
        history.BeginDrag(1, {});
    }
}

TEST(RunHistory, EveryKindOfJointTellsItsValues) {
    for (const std::string engine : {"scree", "box2d"}) {
        for (const scenes::SceneInfo& info : scenes::Catalog()) {
            if (info.folder != "joints") continue;
            const RunSpec spec = ParsePanes(engine).front().spec;
            RunHistory history([&] { return MakeRun(scenes::Build(info.name, info.minSize), spec); }, plenty);
            history.Step();
            const Snapshot now = Look(history);
            for (std::size_t i = 0; i < now.joints.size(); ++i) {
                const RunValues values = history.ValuesOfJoint(static_cast<int>(i));
                EXPECT_GE(values.size(), 4u) << info.name;
                for (const RunValue& value : values) EXPECT_FALSE(value.value.empty()) << value.name;
            }
        }
    }
}

}  // namespace
}  // namespace testbed
