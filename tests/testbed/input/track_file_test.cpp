// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Reading tracks. A file that is cut anywhere reads up to its last whole record. Whatever is wrong is named with its
// place, and no damage does more than that. Other readers of CBOR understand the records.

#include "testbed/input/track_file.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "scree/revolute_joint.h"
#include "testbed/base/errors.h"
#include "testbed/base/input.h"
#include "testbed/capture/scree_capture.h"
#include "testbed/input/scene_file.h"
#include "tests/testbed/input/damage.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

namespace format = scree_capture::detail;

/// A recording with one of everything: contacts, nodes, marks, bodies and joints that come and go.
std::string RecordSample(int steps) {
    const ScratchFolder folder;
    const std::string path = folder.GetPath() / "sample.track";
    scree::World world(scree::Vec2{0.0f, -10.0f});
    const scree::BodyDef groundDef;
    scree::Body* ground = world.CreateBody(&groundDef);
    scree::ChainShape chain;
    const scree::Vec2 points[] = {{9.0f, 0.0f}, {0.0f, -0.5f}, {-9.0f, 0.0f}};
    EXPECT_TRUE(chain.CreateChain(points, 3, {10.0f, 0.0f}, {-10.0f, 0.0f}));
    ground->CreateFixture(&chain, 0.0f);
    std::vector<scree::Body*> bodies;
    const auto make = [&](float x) {
        scree::BodyDef def;
        def.type = scree::dynamicBody;
        def.position = {x, 2.0f};
        def.angularVelocity = 3.0f;
        scree::CircleShape circle;
        circle.m_radius = 0.5f;
        bodies.push_back(world.CreateBody(&def));
        bodies.back()->CreateFixture(&circle, 1.0f);
    };
    make(0.0f);
    make(0.7f);
    scree_capture::Options options;
    options.contacts = options.tree = options.stages = true;
    scree_capture::Track track(world, path, options);
    track.Name(bodies[0], "player");
    for (int step = 1; step <= steps; ++step) {
        if (step == 3) make(-1.0f);
        if (step == 5) {
            scree::RevoluteJointDef def;
            def.Initialize(bodies[0], bodies[1], {0.3f, 2.0f});
            world.CreateJoint(&def);
            track.Mark("hinged");
        }
        if (step == 8) {
            world.DestroyBody(bodies[1]);
            bodies.erase(bodies.begin() + 1);
        }
        world.Step(1.0f / 60.0f, 8, 3);
        track.Step(1.0f / 60.0f);
        if (step % 4 == 0) track.Flush();
    }
    track.Close();
    EXPECT_EQ(track.GetError(), "");
    return ReadText(path, "");
}

struct Records {
    std::vector<std::string> payloads;

    /// Of a whole track.
    explicit Records(std::string_view bytes) {
        for (std::size_t at = 8; at < bytes.size();) {
            std::uint32_t size = 0;
            std::memcpy(&size, bytes.data() + at, 4);
            payloads.emplace_back(bytes.substr(at + 8, size));
            at += 8 + size;
        }
    }
    [[nodiscard]] std::string Join() const {
        std::string bytes("\x89TRACK\r\n");
        for (const std::string& payload : payloads) {
            format::Bytes head;
            format::PutLittle32(head, static_cast<std::uint32_t>(payload.size()));
            const auto* const data = reinterpret_cast<const unsigned char*>(payload.data());
            format::PutLittle32(head, format::Crc32::Of(data, payload.size()));
            bytes.append(head.begin(), head.end());
            bytes += payload;
        }
        return bytes;
    }
};

/// A payload of steps as one that is deflated.
std::string Deflate(const std::string& payload) {
    format::Bytes packed(compressBound(payload.size()));
    uLongf size = packed.size();
    compress(packed.data(), &size, reinterpret_cast<const Bytef*>(payload.data()), payload.size());
    format::CborWriter out;
    out.BeginMap();
    out.Key("deflated");
    out.BeginArray();
    out.Value(static_cast<std::int64_t>(payload.size()));
    const std::size_t begin = out.BeginBytes();
    out.GetBytes().insert(out.GetBytes().end(), packed.begin(), packed.begin() + static_cast<std::ptrdiff_t>(size));
    out.EndBytes(begin);
    out.EndArray();
    out.EndMap();
    return {out.GetBytes().begin(), out.GetBytes().end()};
}

std::string TrackErrorOf(const std::string& bytes) {
    try {
        (void)TrackFile(bytes, "some/session.track");
    } catch (const FileError& error) {
        return error.what();
    }
    return {};
}

TEST(TrackFile, OtherReadersOfCborUnderstandIt) {
    const Records records(RecordSample(12));
    ASSERT_EQ(records.payloads.size(), 4u);
    const auto header = nlohmann::json::from_cbor(records.payloads[0]).at("header");
    EXPECT_EQ(header.at("format"), "scree-track");
    EXPECT_EQ(header.at("timeStep").get<float>(), 1.0f / 60.0f);
    EXPECT_EQ(header.at("scene").at("bodies").size(), 3u);
    // What stands in the header is a scene file.
    EXPECT_EQ(ReadScene(header.at("scene").dump(), "x").bodies.size(), 3u);
    const auto steps = nlohmann::json::from_cbor(records.payloads[1]).at("steps");
    ASSERT_EQ(steps.size(), 4u);
    EXPECT_EQ(steps[2].at("step"), 3);
    EXPECT_EQ(steps[2].at("created").at(0).at("id"), 3);
}

TEST(TrackFile, AFileCutAnywhereReadsToItsLastWholeRecord) {
    const std::string bytes = RecordSample(12);
    const std::size_t header = 8 + 8 + Records(bytes).payloads[0].size();
    std::set<std::size_t> ends{8};
    for (const std::string& payload : Records(bytes).payloads) ends.insert(*ends.rbegin() + 8 + payload.size());
    int last = 0;
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        const std::string cut = bytes.substr(0, size);
        if (size < header) {
            ASSERT_TRUE(TrackErrorOf(cut).starts_with("some/session.track: ")) << TrackErrorOf(cut);
            continue;
        }
        const TrackFile track(cut, "x");
        ASSERT_GE(track.GetLastStep(), last);
        last = track.GetLastStep();
        ASSERT_EQ(last % 4, 0);
        ASSERT_EQ(track.GetInfo().damage.empty(), ends.contains(size)) << size << track.GetInfo().damage;
    }
    EXPECT_EQ(last, 8);
    EXPECT_EQ(TrackFile(bytes, "x").GetLastStep(), 12);
    EXPECT_EQ(TrackFile(bytes.substr(0, bytes.size() - 1), "x").GetInfo().damage.substr(0, 20), "ends within record 4");
}

TEST(TrackFile, DeflatedBlocksAreTheSameTrack) {
    const std::string bytes = RecordSample(12);
    Records records(bytes);
    for (std::size_t i = 1; i < records.payloads.size(); ++i) records.payloads[i] = Deflate(records.payloads[i]);
    TrackFile plain(bytes, "x"), deflated(records.Join(), "x");
    ASSERT_EQ(deflated.GetInfo().damage, "");
    for (const int step : {12, 1, 7, 0, 3, 4}) {
        EXPECT_TRUE(plain.SceneAt(step) == deflated.SceneAt(step)) << step;
        EXPECT_EQ(plain.Read(step).contacts.size(), deflated.Read(step).contacts.size()) << step;
    }
}

TEST(TrackFile, ASceneOfAStepHoldsWhatWasThere) {
    TrackFile track(RecordSample(12), "some/session.track");
    EXPECT_EQ(track.GetBodies()[1].name, "player");
    const scenes::Scene start = track.SceneAt(0), third = track.SceneAt(3), fifth = track.SceneAt(5),
                        ninth = track.SceneAt(9);
    EXPECT_EQ(start.InitialBodyCount(), 3);
    EXPECT_EQ(start.spawns.size(), 1u);
    EXPECT_EQ(start.spawns[0].afterStep, 3);
    EXPECT_EQ(start.steps, 12);
    EXPECT_EQ(start.name, "session");
    EXPECT_EQ(third.InitialBodyCount(), 4);
    EXPECT_TRUE(third.spawns.empty());
    EXPECT_EQ(fifth.joints.size(), 1u);
    EXPECT_EQ(ninth.InitialBodyCount(), 3);
    EXPECT_TRUE(ninth.joints.empty());
    EXPECT_NE(ninth.user.find("player"), std::string::npos);
    // What is written as a scene file is read back.
    EXPECT_TRUE(ReadScene(WriteScene(ninth), "again").bodies == ninth.bodies);
    EXPECT_THROW((void)track.Read(13), UsageError);
}

TEST(TrackFile, ErrorsNameThePlaceAndTheCure) {
    const std::string bytes = RecordSample(12);
    EXPECT_NE(TrackErrorOf("").find("not a track"), std::string::npos);
    EXPECT_NE(TrackErrorOf("PNG").find("recorded"), std::string::npos);
    const auto change = [&](std::size_t record, const std::string& from, const std::string& to) {
        Records records(bytes);
        std::string& payload = records.payloads[record];
        const std::size_t at = payload.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        payload.replace(at, from.size(), to);
        return TrackErrorOf(records.Join());
    };
    EXPECT_NE(change(0, "scree-track", "other-track").find("record 1, byte"), std::string::npos);
    EXPECT_NE(change(0, "fixtures", "fixturex").find("did you mean 'fixtures'"), std::string::npos);
    EXPECT_NE(change(1, "dstep", "dstop").find("record 2, byte"), std::string::npos);
    const std::string step("dstep\x01");
    EXPECT_NE(change(1, step, std::string("dstep\x00", 6)).find("give a whole number from 1"), std::string::npos);
    EXPECT_NE(change(1, "bid", "bxd").find("id"), std::string::npos);
}

/// Flips, cuts, splices, huge numbers and deep nesting, at places where they are read.
std::string MutateTrack(const std::string& good, std::mt19937& random) {
    const auto below = [&](std::size_t end) { return Below(end, random); };
    static const std::vector<std::string> hostile{
        std::string("\x1b\x7f\xff\xff\xff\xff\xff\xff\xff", 9),  // a huge number
        std::string("\x5b\x00\x00\x00\xff\xff\xff\xff\xff", 9),  // huge bytes
        std::string("\x9b\x00\x00\x00\xff\xff\xff\xff\xff", 9),  // a huge array
        std::string("\xbb\xff\xff\xff\xff\xff\xff\xff\xff", 9),  // a huge map
        std::string(200, '\x81'),
        std::string(200, '\xa1'),  // nested
        std::string(200, '\x7f'),
        std::string(200, '\x9f'),
        std::string(200, '\xc1'),
        std::string("\xfa\x7f\xc0\x00\x00", 5),
        std::string("\xfa\xff\x80\x00\x00", 5),  // no numbers
        std::string("\xf9\x7c\x00", 3),
        "\xf6",
        "\xf5",
        "\xff",
        std::string("\0", 1),
        "\x20",
        "\x80",
        "\xa0"};
    Records records(good);
    const bool mustSum = below(4) > 0;  // else the checksum is wrong, too
    std::string whole = good;
    Damage(mustSum ? records.payloads[below(records.payloads.size())] : whole, random, 2,
           [&](std::string& text, std::size_t at) {
               if (below(2) == 0) {
                   text.replace(at, 1 + below(4), hostile[below(hostile.size())]);
                   return;
               }
               // In the place of what a key holds.
               static const std::vector<std::string> keys{"step",    "dt",        "bodies", "contacts", "nodes",
                                                          "created", "destroyed", "joints", "names",    "id",
                                                          "body",    "joint",     "key",    "position", "fixtures"};
               const std::string& key = keys[below(keys.size())];
               const std::size_t found = text.find(key, at);
               if (found == std::string::npos) return;
               text.replace(found + key.size(), 1 + below(3), hostile[below(hostile.size())]);
           });
    return mustSum ? records.Join() : whole;
}

TEST(TrackFile, DamagedFilesEndInAnErrorOrInATrackThatIsGood) {
    const int count = CountOfMutations(5000);
    std::mt19937 random(22);
    const std::string plain = RecordSample(12);
    Records records(plain);
    for (std::size_t i = 1; i < records.payloads.size(); ++i) records.payloads[i] = Deflate(records.payloads[i]);
    const std::string texts[] = {plain, records.Join()};
    int refused = 0, cut = 0;
    for (int i = 0; i < count; ++i) {
        const std::string bytes = MutateTrack(texts[i % 2], random);
        try {
            TrackFile track(bytes, "x");
            cut += !track.GetInfo().damage.empty();
            for (const int step : track.GetSteps()) (void)track.Read(step);
            try {
                const scenes::Scene scene = track.SceneAt(track.GetLastStep());
                ASSERT_EQ(DescribeFault(scene), "");
            } catch (const FileError& error) {
                ASSERT_TRUE(std::string_view(error.what()).starts_with("x, step ")) << error.what();
            }
        } catch (const FileError& error) {
            ++refused;
            ASSERT_TRUE(std::string_view(error.what()).starts_with("x: ")) << error.what();
        }
    }
    EXPECT_GT(refused, count / 3);
    EXPECT_GT(cut, count / 20);
    RecordMutations(count, refused);
}

}  // namespace
}  // namespace testbed
