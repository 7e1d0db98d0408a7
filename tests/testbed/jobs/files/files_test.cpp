// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Tracks, images and recordings in place of a scene: what `scree info` and `scree convert` say and make of them. Also
// that overlap, render and metrics of them give what the world that was recorded gave.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "scenes/catalog.h"
#include "scree/recording.h"
#include "scree/snapshot.h"
#include "scree/world.h"
#include "testbed/base/errors.h"
#include "testbed/engines/capture_scree.h"
#include "testbed/engines/saved_world.h"
#include "testbed/input/file_kind.h"
#include "testbed/input/scene_file.h"
#include "testbed/input/track_file.h"
#include "tests/testbed/input/damage.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

using Json = nlohmann::json;

/// A floor, a heap of boxes that falls on it, and a seesaw.
std::unique_ptr<scree::World> MakeHeap(int boxes) {
    auto world = std::make_unique<scree::World>(scree::Vec2{0.0f, -10.0f});
    const scree::BodyDef groundDef;
    scree::Body* ground = world->CreateBody(&groundDef);
    scree::EdgeShape edge;
    edge.SetTwoSided({-20.0f, 0.0f}, {20.0f, 0.0f});
    ground->CreateFixture(&edge, 0.0f);
    scree::PolygonShape box;
    box.SetAsBox(0.5f, 0.25f);
    scree::BodyDef def;
    def.type = scree::dynamicBody;
    scree::Body* last = nullptr;
    for (int i = 0; i < boxes; ++i) {
        def.position = {0.3f * static_cast<float>(i % 5), 1.0f + 0.6f * static_cast<float>(i)};
        def.angle = 0.1f * static_cast<float>(i);
        last = world->CreateBody(&def);
        last->CreateFixture(&box, 1.0f);
    }
    scree::RevoluteJointDef hinge;
    hinge.Initialize(ground, last, last->GetPosition());
    world->CreateJoint(&hinge);
    return world;
}

template <typename Bytes>
void WriteBytes(const std::filesystem::path& path, const Bytes& bytes) {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

std::string HashOf(const scree::World& world) {
    Snapshot snapshot;
    Capture(world, snapshot);
    return fmt::format("{:016x}", snapshot.stateHash);
}

class Files : public testing::Test {
protected:
    [[nodiscard]] ProgramResult Run(const std::string& arguments) const { return folder.Run(arguments); }
    void Expect(const std::string& arguments, int exitCode, const std::string& says) const {
        const ProgramResult result = Run(arguments);
        EXPECT_EQ(result.exitCode, exitCode) << arguments << "\n" << result.output;
        EXPECT_NE(result.output.find(says), std::string::npos) << arguments << "\n" << result.output;
    }
    [[nodiscard]] Json InfoOf(const std::string& file) const {
        const ProgramResult result = Run("info " + file + " --json");
        EXPECT_EQ(result.exitCode, 0) << result.output;
        return Json::parse(result.output).at("files").at(0);
    }
    /// A column of metrics.json of one engine.
    [[nodiscard]] std::vector<std::string> Column(const std::string& file, const std::string& engine,
                                                  const std::string& name) const {
        std::vector<std::string> values;
        const Json metrics = Json::parse(folder.Read(file));
        for (const Json& row : metrics.at("rows")) {
            if (row.at("engine") == engine) values.push_back(row.at(name).dump());
        }
        return values;
    }
    /// heap.recording: 60 steps of a heap from the empty world on, and after each step what the world was.
    void Record() {
        recorder = std::make_unique<scree::Recorder>();
        auto empty = std::make_unique<scree::World>(scree::Vec2{0.0f, -10.0f});
        world = MakeHeap(12);
        ASSERT_EQ(scree::StartRecording(*world, *recorder), scree::ErrorCode::ok);
        for (int step = 1; step <= 60; ++step) {
            if (step == 20) world->GetBodyList()->ApplyLinearImpulseToCenter({2.0f, 3.0f}, true);
            world->Step(1.0f / 60.0f, 6, 2);
            hashes.push_back(HashOf(*world));
            if (step == 30) image = scree::SaveWorld(*world);
        }
        WriteBytes(folder.GetPath() / "heap.recording", recorder->GetBytes());
    }

    ScratchFolder folder;
    std::unique_ptr<scree::World> world;
    std::unique_ptr<scree::Recorder> recorder;
    std::vector<std::string> hashes;
    std::vector<std::byte> image;  ///< after step 30
};

TEST_F(Files, ATracksMotionGivesTheTreesOfTheBuiltInComparison) {
    Expect("convert tiles --size 30 tiles.track --engine box2d --steps 40", 0, "tiles.track");
    Expect("metrics tiles.track --steps 40 --image 320x200 -o track", 0, "settings");
    Expect("metrics tiles --size 30 --poses box2d --steps 40 --image 320x200 -o built-in", 0, "settings");
    for (const char* engine : {"scree", "box2d"}) {
        for (const char* column : {"nodes", "height", "area_ratio", "sibling_overlap", "overlap_max", "overlap_mean",
                                   "pairs_reported", "pairs_true", "contacts", "state_hash"}) {
            if (std::string(engine) == "scree" && std::string(column) == "pairs_reported") continue;
            const std::vector<std::string> track = Column("track/tiles/metrics.json", engine, column);
            EXPECT_EQ(track.size(), 40u);
            EXPECT_EQ(track, Column("built-in/tiles/metrics.json", engine, column)) << engine << ' ' << column;
        }
    }
}

TEST_F(Files, InfoSaysWhatIsInEachKind) {
    Record();
    WriteBytes(folder.GetPath() / "heap.world", image);
    Expect("convert heap.recording heap.track", 0, "heap.track");
    Expect("convert pyramid --size 4 level.scene.json", 0, "level.scene.json");
    const Json scene = InfoOf("level.scene.json"), track = InfoOf("heap.track"), saved = InfoOf("heap.world"),
               recording = InfoOf("heap.recording");
    EXPECT_EQ(scene.at("kind"), "scene");
    EXPECT_EQ(scene.at("bodies"), 11);
    EXPECT_EQ(scene.at("gravity"), Json({0, -10}));
    EXPECT_EQ(scene.at("names"), Json::array());
    EXPECT_EQ(track.at("kind"), "track");
    EXPECT_EQ(track.at("stages"), false);
    EXPECT_EQ(track.at("engine"), "scree");
    EXPECT_EQ(track.at("steps"), 60);
    EXPECT_EQ(track.at("damage"), "");
    EXPECT_EQ(saved.at("kind"), "image");
    EXPECT_EQ(recording.at("kind"), "recording");
    EXPECT_EQ(recording.at("calls"), 61);
    EXPECT_EQ(recording.at("steps"), 60);
    EXPECT_EQ(recording.at("damage"), "");
    EXPECT_EQ(scene.at("version"), sceneVersion);
    EXPECT_EQ(saved.at("version"), scree::snapshotVersion);
    EXPECT_EQ(recording.at("version"), scree::recordingVersion);
    EXPECT_EQ(recording.at("version"), recorder->GetBytes()[7]) << "the byte that files have";
    EXPECT_EQ(scene.at("writer").get<std::string>().rfind("scree ", 0), 0u) << scene.dump();
    EXPECT_EQ(saved.at("writer"), "scree");
    EXPECT_EQ(recording.at("writer"), "scree");
    for (const Json& file : {track, saved, recording}) {
        EXPECT_EQ(file.at("gravity"), Json({0, -10}));
        EXPECT_TRUE(file.contains("steps"));
        EXPECT_EQ(file.at("bodies"), 13);
        EXPECT_EQ(file.at("dynamic_bodies"), 12);
        EXPECT_EQ(file.at("joints"), 1);
    }
    // The ground is 40 m long. The heap is as tall as when recording began, in an image as at its moment.
    const auto sizeOf = [](const Json& extent) {
        return std::array{extent.at(2).get<float>() - extent.at(0).get<float>(),
                          extent.at(3).get<float>() - extent.at(1).get<float>()};
    };
    for (const Json& file : {track, saved, recording}) EXPECT_NEAR(sizeOf(file.at("extent"))[0], 40.0f, 0.1f);
    EXPECT_EQ(track.at("extent"), recording.at("extent"));
    EXPECT_GT(sizeOf(track.at("moving_extent"))[1], 7.0f);
    EXPECT_LT(sizeOf(saved.at("moving_extent"))[1], sizeOf(track.at("moving_extent"))[1]);
    EXPECT_LT(sizeOf(track.at("moving_extent"))[0], 20.0f);
    std::ofstream(folder.GetPath() / "two.scene.json") << R"({"format": "scree-scene", "version": 1, "bodies": [
        {"fixtures": [{"shape": {"type": "circle", "radius": 10}}]},
        {"type": "dynamic", "position": [8, 10], "fixtures": [{"shape": {"type": "circle", "radius": 0.5}}]}
    ], "user": {"writer": "level editor"}})";
    Expect("info two.scene.json", 0, "\nwriter           level editor\n");
    Expect("info two.scene.json", 0,
           "\nextent           20 x 20.5 m, from -10, -10 to 10, 10.5\n"
           "moving extent    1 x 1 m, from 7.5, 9.5 to 8.5, 10.5\n");
    Expect("convert two.scene.json again.scene.json", 0, "again.scene.json");
    Expect("info again.scene.json", 0, "\nwriter           level editor\n");
    // Of many names the first ones are printed.
    Json level = {{"format", "scree-scene"}, {"version", 1}};
    for (int i = 0; i < 60; ++i) {
        level["bodies"].push_back({{"type", "dynamic"}});
        level["user"]["bodies"][std::to_string(i)]["name"] = fmt::format("n{:02}", i);
    }
    std::ofstream(folder.GetPath() / "named.scene.json") << level.dump();
    EXPECT_EQ(InfoOf("named.scene.json").at("names").size(), 60u);
    Expect("info named.scene.json", 0, "n48, n49 and 10 more\n");
    Expect("convert named.scene.json named.track --steps 2", 0, "named.track");
    EXPECT_EQ(InfoOf("named.track").at("names"), InfoOf("named.scene.json").at("names"));
    // A file that is called otherwise is known by its bytes.
    std::filesystem::rename(folder.GetPath() / "heap.world", folder.GetPath() / "heap.bin");
    EXPECT_EQ(InfoOf("heap.bin").at("kind"), "image");
    Expect("metrics heap.bin --steps 2", exitUsage, "`scree info` says what it holds");
    Expect("metrics heap.bin --format image --steps 2 -o out", 0, "out/heap.bin/metrics.csv");
}

TEST_F(Files, ACutTrackAndACutRecordingGiveWhatIsWholeAndSaySo) {
    Record();
    Expect("convert falling-squares --size 5 whole.track --steps 300", 0, "");
    for (const char* name : {"whole.track", "heap.recording"}) {
        const std::string bytes = folder.Read(name);
        const std::string cut = std::string("cut.") + name;
        std::ofstream(folder.GetPath() / cut, std::ios::binary) << bytes.substr(0, bytes.size() * 2 / 3);
        const Json info = InfoOf(cut);
        EXPECT_NE(info.at("damage").get<std::string>().find("up to step"), std::string::npos) << info.dump();
        const int last = info.at("last_step");
        EXPECT_GT(last, 0);
        EXPECT_LT(last, 300);
        Expect("metrics " + cut + " -o out --image 320x200", 0, fmt::format("up to step {}", last));
    }
}

TEST_F(Files, ARecordingsMotionIsTheRecordedOne) {
    Record();
    Expect("metrics heap.recording -o out --image 320x200", 0, "settings");
    std::vector<std::string> wanted;
    for (const std::string& hash : hashes) wanted.push_back('"' + hash + '"');
    EXPECT_EQ(Column("out/heap/metrics.json", "scree", "state_hash"), wanted);
    EXPECT_EQ(Column("out/heap/metrics.json", "box2d", "state_hash"), wanted);
    Expect("overlap heap.recording --step 50 -o out --image 320x200", 0, "compare.png");
    EXPECT_EQ(Json::parse(folder.Read("out/heap/step-0050/compare.json")).at("poses"), "track");
    Expect("render heap.recording --steps 58:60 -o out --image 320x200", 0, "render-scree.png");
}

TEST_F(Files, OurEngineGoesOnExactlyFromAnImageAndFromAStepOfARecording) {
    Record();
    WriteBytes(folder.GetPath() / "heap.world", image);
    // The calls that come later are not made from a step on: the impulse was before it.
    const std::vector<std::string> later(hashes.begin() + 30, hashes.end());
    std::vector<std::string> wanted;
    for (const std::string& hash : later) wanted.push_back('"' + hash + '"');
    Expect("metrics heap.recording --from 30 --steps 30 -o a --image 320x200", 0, "settings");
    EXPECT_EQ(Column("a/heap/metrics.json", "scree", "state_hash"), wanted);
    EXPECT_EQ(Column("a/heap/metrics.json", "box2d", "state_hash").size(), 30u);
    Expect("metrics heap.world --set iterations=6/2 --set threads=2 --steps 30 -o b --image 320x200", 0, "settings");
    EXPECT_EQ(Column("b/heap/metrics.json", "scree", "state_hash"), wanted);
    Expect("metrics heap.world --set caps=on --steps 3", exitUsage, "`scree convert` makes a scene of it");
    Expect("convert heap.recording again.world --from 30", 0, "again.world");
    EXPECT_EQ(folder.Read("again.world"), folder.Read("heap.world"));
}

TEST_F(Files, AnyCommandStartsEnginesAtAStep) {
    Record();
    Expect("convert heap.recording heap.track", 0, "heap.track");
    for (const std::string file : {"heap.track", "heap.recording"}) {
        Expect("metrics " + file + " --from 25 --steps 5 -o out --image 320x200", 0, "settings");
        Expect("requires " + file + " --from 25 --quick --steps 3", 0, "heap");
        Expect("view " + file + " --from 25 --offscreen --frames 2 --dump-state state.json", 0, "");
        Expect("convert " + file + " level.scene.json --from 25", 0, "level.scene.json");
        Expect("bench level.scene.json --steps 3 --csv bench.csv", 0, "heap");
        EXPECT_EQ(InfoOf("level.scene.json").at("bodies"), 13);
    }
    Expect("convert heap.track again.track --from 25 --engine box2d --steps 10", 0, "again.track");
    EXPECT_EQ(InfoOf("again.track").at("steps"), 10);
}

TEST_F(Files, WhatCannotBeMeantIsRefusedInALine) {
    Record();
    WriteBytes(folder.GetPath() / "heap.world", image);
    ASSERT_EQ(Run("convert heap.recording heap.track").exitCode, 0);
    std::filesystem::copy_file(folder.GetPath() / "heap.world", folder.GetPath() / "wrong.track");
    std::ofstream(folder.GetPath() / "empty.recording");
    std::ofstream(folder.GetPath() / "notes.txt") << "level 3";
    const struct {
        std::string arguments;
        int exitCode;
        std::string says;
    } cases[] = {
        {"bench heap.track", exitUsage, "`scree convert heap.track OUT.scene.json --from K`"},
        {"requires heap.recording", exitUsage, "--from K"},
        {"metrics heap.track --poses own", exitUsage, "--from K"},
        {"metrics heap.track --poses trak", exitUsage, "did you mean 'track'"},
        {"metrics heap.track --from 61", exitUsage, "heap.track has no step 61: give 0 or one from 1 to 60"},
        {"metrics heap.recording --from 61", exitUsage, "heap.recording has no step 61: give one from 0 to 60"},
        {"metrics heap.track --steps 80", exitUsage, "steps 1:80 are not in its motion; give some from 1 to 60"},
        {"overlap heap.track --step 61", exitUsage, "give some from 1 to 60"},
        {"metrics heap.track --poses track --from 60", exitUsage, "no step after 60"},
        {"metrics heap.world --from 3", exitUsage, "--from 3: heap.world is one moment"},
        {"metrics tiles --poses track", exitUsage, "--poses track: tiles has no motion"},
        {"metrics wrong.track", exitIo,
         "by its content it is a saved world of our engine, not a world and its motion; --format image"},
        {"metrics heap.track --format recording", exitIo,
         "by its content it is a world and its motion, not a program's calls of our engine; --format track"},
        {"metrics empty.recording", exitIo,
         "empty.recording: not a recording, for the world at its start cannot be read: not a snapshot"},
        {"info notes.txt", exitIo, "neither ends nor begins like any of *.scene.json"},
        {"info", exitUsage, "which file?"},
        {"convert heap.track", exitUsage, "scree convert IN OUT"},
        {"convert heap.track heap.track --from 3", exitUsage, "is read and written"},
        {"convert heap.track other.track", exitUsage, "is a track already"},
        {"convert heap.track level.scene.json", exitUsage, "--from K"},
        {"convert tiles tiles.world", exitUsage, "images come from our engine's"},
        {"convert tiles tiles.recording", exitUsage, "only a program that runs makes a recording"},
        {"convert tiles tiles.txt", exitUsage, "its ending says no kind of file"},
        {"convert tiles tiles.scene.json --steps 3", exitUsage, "are for tracks"},
        {"convert tiles no-folder/tiles.track --steps 3", exitIo, "no-folder/tiles.track"},
    };
    for (const auto& one : cases) {
        const ProgramResult result = Run(one.arguments);
        EXPECT_EQ(result.exitCode, one.exitCode) << one.arguments << "\n" << result.output;
        EXPECT_NE(result.output.find(one.says), std::string::npos) << one.arguments << "\n" << result.output;
        EXPECT_EQ(std::ranges::count(result.output, '\n'), 1) << one.arguments << "\n" << result.output;
    }
    EXPECT_FALSE(folder.Has("out")) << "nothing is written";
}

/// Damages a sound file and gives each to its reader, which says whether it was refused, or throws.
template <typename Read>
void ReadDamaged(const std::string& whole, int seed, Read&& read) {
    std::mt19937 random(static_cast<unsigned>(seed));
    const int count = CountOfMutations(200);
    int refused = 0;
    for (int i = 0; i < count; ++i) {
        std::string text = whole;
        Damage(text, random, 1, [&](std::string& damaged, std::size_t at) {
            const float hostile[] = {1e38f, -1.0f, 0.0f, 1e-38f};
            const std::size_t place = std::min(at, damaged.size() - sizeof(float));
            std::memcpy(damaged.data() + place, &hostile[Below(4, random)], sizeof(float));
        });
        try {
            refused += read(text) ? 1 : 0;
        } catch (const FileError& error) {
            EXPECT_NE(std::string(error.what()).find("; give a file that scree::"), std::string::npos) << error.what();
            ++refused;
        }
    }
    EXPECT_GT(refused, count * 3 / 4);
    RecordMutations(count, refused);
}

template <typename Bytes>
std::string TextOf(const Bytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

TEST_F(Files, DamagedImagesEndInAReasonAndNoHarm) {
    Record();
    ReadDamaged(TextOf(image), 29, [](const std::string& text) {
        (void)ReadWorldImage(text, "x.world");
        return false;
    });
}

TEST_F(Files, DamagedRecordingsEndInAReasonAndNoHarm) {
    Record();
    ReadDamaged(TextOf(recorder->GetBytes()), 30, [](const std::string& text) {
        const Replayed replayed = ReplayRecording(text, "x.recording", {.worldAt = 0, .wantsTrack = true});
        (void)TrackFile(replayed.track, "x.track");
        return !replayed.damage.empty();
    });
}

}  // namespace
}  // namespace testbed
