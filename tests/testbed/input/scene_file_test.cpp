// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Scene files. What is written reads back to the same bits, and the schema agrees with both. Whatever is wrong is named
// with its place, and no damage to a file does more than that.

#include "testbed/input/scene_file.h"

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <algorithm>
#include <bit>
#include <cfloat>
#include <chrono>
#include <cstdint>
#include <fstream>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <string>

#include "scenes/build.h"
#include "scenes/build_joints.h"
#include "scenes/catalog.h"
#include "testbed/base/errors.h"
#include "testbed/base/input.h"
#include "testbed/input/scene_fields.h"
#include "tests/testbed/input/damage.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

namespace fs = std::filesystem;

/// The message of the error that reading ends in, or nothing.
std::string ErrorOf(std::string_view text) {
    try {
        (void)ReadScene(text, "some/world.scene.json");
    } catch (const FileError& error) {
        return error.what();
    }
    return {};
}

/// Every member that a type has, to the bit: what is written again is the same text. Shapes that shared vertices have
/// their own then, hence shapes are not compared by their ranges.
void ExpectSame(const scenes::Scene& scene, const std::string& text) {
    const scenes::Scene read = ReadScene(text, "again");
    EXPECT_TRUE(read.bodies == scene.bodies) << scene.name;
    EXPECT_TRUE(read.joints == scene.joints) << scene.name;
    EXPECT_TRUE(read.spawns == scene.spawns) << scene.name;
    EXPECT_TRUE(WriteScene(read) == text) << scene.name;
}

TEST(SceneFile, EveryBuiltInSceneReadsBackToTheSameBits) {
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        const scenes::Scene scene = scenes::Build(info.name);
        EXPECT_EQ(DescribeFault(scene), "") << info.name;
        ExpectSame(scene, WriteScene(scene));
    }
}

TEST(SceneFile, AnyFiniteNumbersReadBackToTheSameBits) {
    // Every bit pattern of a float within the limits, and negative zeros, in the members that may have them.
    EXPECT_TRUE(rc::check("random scenes", [] {
        const auto number = [](float most) {
            const auto bits = *rc::gen::resize(100, rc::gen::arbitrary<std::uint32_t>());
            const float value = std::bit_cast<float>(bits);
            return std::isfinite(value) && std::abs(value) <= most ? value : -0.0f;
        };
        scenes::Scene scene;
        scene.name = "random";
        scene.steps = *rc::gen::inRange(1, 1000);
        scene.showStep = *rc::gen::inRange(1, scene.steps + 1);
        scene.gravity = {number(1e18f), number(1e18f)};
        const int bodies = *rc::gen::inRange(2, 20);
        for (int i = 0; i < bodies; ++i) {
            scenes::Body& body = scenes::AddBody(scene, static_cast<scenes::BodyType>(*rc::gen::inRange(0, 3)),
                                                 {number(1e18f), number(1e18f)});
            body.angle = number(1e6f);
            body.linearVelocity = {number(1e18f), number(1e18f)};
            body.angularVelocity = number(1e18f);
            body.linearDamping = std::abs(number(1e18f));
            body.gravityScale = number(1e18f);
            body.bullet = *rc::gen::arbitrary<bool>();
            body.awake = *rc::gen::arbitrary<bool>();
            const int fixtures = *rc::gen::inRange(0, 4);
            for (int k = 0; k < fixtures; ++k) {
                scenes::Fixture& fixture = scenes::AddFixture(scene, scenes::Circle(1.0 + k), 1.0);
                fixture.friction = std::abs(number(1e18f));
                fixture.tangentSpeed = number(1e18f);
                fixture.categoryBits = *rc::gen::arbitrary<std::uint16_t>();
                fixture.groupIndex = *rc::gen::arbitrary<std::int16_t>();
            }
        }
        for (int type = 0; type < scenes::jointTypeCount; ++type) {
            if (type == static_cast<int>(scenes::JointType::gear)) continue;
            scenes::Joint& joint = scene.joints.emplace_back();
            joint.type = static_cast<scenes::JointType>(type);
            joint.bodyA = *rc::gen::inRange(0, bodies);
            joint.bodyB = (joint.bodyA + 1) % bodies;
            const auto keys = KeysOf(joint.type);
            const auto has = [&](std::string_view key) {
                return std::find(keys.begin(), keys.end(), key) != keys.end();
            };
            if (has("localAnchorA")) joint.localAnchorA = {number(1e18f), number(1e18f)};
            if (has("referenceAngle")) joint.referenceAngle = number(1e18f);
            if (has("motorSpeed")) joint.motorSpeed = number(1e18f);
            if (has("stiffness")) joint.stiffness = std::abs(number(1e18f));
        }
        RC_ASSERT(DescribeFault(scene) == "");
        const std::string text = WriteScene(scene);
        const scenes::Scene read = ReadScene(text, "again");
        RC_ASSERT(read == scene);
        RC_ASSERT(WriteScene(read) == text);
    }));
}

TEST(SceneFile, TheSmallestFileIsAWorld) {
    const scenes::Scene scene = ReadScene(R"({"format": "scree-scene", "version": 1})", "my levels/Level 3.scene.json");
    EXPECT_EQ(scene.name, "Level-3");
    EXPECT_EQ(scene.steps, 600);
    EXPECT_EQ(scene.showStep, 600);
    EXPECT_TRUE(scene.bodies.empty());
    EXPECT_EQ(scene.gravity, (scenes::Vec2{0.0f, -10.0f}));
}

TEST(SceneFile, WhatUsersKeepBesideItStays) {
    const scenes::Scene scene = ReadScene(
        R"({"format": "scree-scene", "version": 1, "user": {"bodies": {"0": {"name": "player"}}, "n": [1, null]}})",
        "x");
    EXPECT_EQ(scene.user, R"({"bodies":{"0":{"name":"player"}},"n":[1,null]})");
    EXPECT_EQ(ReadScene(WriteScene(scene), "x").user, scene.user);
}

/// A scene with one of everything that errors are tried on, as a JSON value.
nlohmann::ordered_json SampleJson() {
    scenes::Scene scene;
    scene.name = "sample";
    scene.steps = 10;
    scene.showStep = 5;
    scenes::AddFlatGround(scene, 10.0);
    scenes::AddBody(scene, scenes::BodyType::dynamic, {0.0f, 2.0f});
    scenes::AddFixture(scene, scenes::Box(0.5, 0.5), 1.0);
    scenes::AddFixture(scene, scenes::Polygon({{0, 0}, {1, 0}, {0, 1}}), 1.0);
    scenes::AddBody(scene, scenes::BodyType::dynamic, {3.0f, 2.0f});
    scenes::AddFixture(scene, scenes::Circle(0.5), 1.0);
    const scenes::Vec2 chain[] = {{-5.0f, 0.0f}, {0.0f, 0.0f}, {5.0f, 0.0f}};
    scenes::AddBody(scene, scenes::BodyType::isStatic, {});
    scenes::AddFixture(scene, scenes::Chain(scene, chain));
    scene.joints.push_back({.type = scenes::JointType::revolute, .bodyA = 1, .bodyB = 2});
    scene.joints.push_back({.type = scenes::JointType::prismatic, .bodyA = 0, .bodyB = 1});
    scenes::AddBody(scene, scenes::BodyType::dynamic, {6.0f, 2.0f});
    scenes::AddFixture(scene, scenes::Circle(0.5), 1.0);
    scene.spawns.push_back({.afterStep = 3, .body = 4});
    return nlohmann::ordered_json::parse(WriteScene(scene));
}

TEST(SceneFile, ErrorsNameThePlaceAndTheCure) {
    using Json = nlohmann::ordered_json;
    const struct {
        std::function<void(Json&)> damage;
        std::string_view place, says;
    } cases[] = {
        {[](Json& j) { j["format"] = "png"; }, "", "no scene file"},
        {[](Json& j) { j["version"] = 2; }, "version", "newer than this program"},
        {[](Json& j) { j["gravty"] = 1; }, "", "did you mean 'gravity'"},
        {[](Json& j) { j["steps"] = 0; }, "steps", "give 1 to"},
        {[](Json& j) { j["showStep"] = 11; }, "showStep", "1 to 10"},
        {[](Json& j) { j["timeStep"] = 0; }, "timeStep", "give"},
        {[](Json& j) { j["name"] = "../x"; }, "name", "give 1 to 64 letters"},
        {[](Json& j) { j["gravity"] = Json::array({0}); }, "gravity", "[x, y]"},
        {[](Json& j) { j["bodies"] = 3; }, "bodies", "an array, not a number"},
        {[](Json& j) { j["bodies"][1]["type"] = "dynamc"; }, "bodies[1].type", "did you mean 'dynamic'"},
        {[](Json& j) { j["bodies"][1]["position"][1] = "2"; }, "bodies[1].position[1]", "a number, not a string"},
        {[](Json& j) { j["bodies"][1]["position"][1] = 1e39; }, "bodies[1].position[1]", "too large for a float"},
        {[](Json& j) { j["bodies"][1]["awake"] = 1; }, "bodies[1].awake", "true or false"},
        {[](Json& j) { j["bodies"][1]["linearDamping"] = -1; }, "bodies[1].linearDamping", "from 0"},
        {[](Json& j) { j["bodies"][1]["fixtures"][0].erase("shape"); }, "bodies[1].fixtures[0]", "\"shape\""},
        {[](Json& j) { j["bodies"][1]["fixtures"][0]["categoryBits"] = 65536; }, "bodies[1].fixtures[0].categoryBits",
         "from 0 to 65535"},
        {[](Json& j) { j["bodies"][1]["fixtures"][0]["density"] = -1; }, "bodies[1].fixtures[0].density", "from 0"},
        {[](Json& j) { j["bodies"][1]["fixtures"][0]["shape"]["radius"] = 1; }, "bodies[1].fixtures[0].shape",
         "unknown key 'radius'"},
        {[](Json& j) { j["bodies"][1]["fixtures"][0]["shape"]["halfExtents"][0] = 0; },
         "bodies[1].fixtures[0].shape.halfExtents", "area"},
        {[](Json& j) {
             std::swap(j["bodies"][1]["fixtures"][1]["shape"]["vertices"][0],
                       j["bodies"][1]["fixtures"][1]["shape"]["vertices"][1]);
         },
         "bodies[1].fixtures[1].shape.vertices", "counter-clockwise"},
        {[](Json& j) { j["bodies"][1]["fixtures"][1]["shape"]["vertices"].erase(0); },
         "bodies[1].fixtures[1].shape.vertices", "2 vertices; give 3 to 8"},
        {[](Json& j) {
             j["bodies"][1]["fixtures"][1]["shape"]["vertices"] = Json::array_t(9, {0, 0});
         },
         "bodies[1].fixtures[1].shape.vertices", "9 vertices, at most 8"},
        {[](Json& j) { j["bodies"][2]["fixtures"][0]["shape"]["radius"] = 0; }, "bodies[2].fixtures[0].shape.radius",
         "at least"},
        {[](Json& j) {
             j["bodies"][3]["fixtures"][0]["shape"]["chainVertices"][1] = {-5, 0};
         },
         "bodies[3].fixtures[0].shape.chainVertices[0]", "nearer than"},
        {[](Json& j) { j["bodies"][3]["fixtures"][0]["shape"].erase("chainVertices"); }, "bodies[3].fixtures[0].shape",
         "give its \"chainVertices\""},
        {[](Json& j) { j["joints"][0]["bodyB"] = 4; }, "joints[0].bodyB", "exists from the start, 0 to 3"},
        {[](Json& j) { j["joints"][0]["bodyB"] = 1; }, "joints[0].bodyB", "another body than bodyA"},
        {[](Json& j) { j["joints"][0]["length"] = 1; }, "joints[0]", "unknown key 'length'"},
        {[](Json& j) { j["joints"][0].erase("type"); }, "joints[0]", "give its \"type\": revolute"},
        {[](Json& j) { j["joints"][0]["lowerAngle"] = 1; }, "joints[0].lowerAngle", "at most upperAngle"},
        {[](Json& j) {
             j["joints"][1]["localAxisA"] = {2, 0};
         },
         "joints[1].localAxisA", "length 1"},
        {[](Json& j) { j["joints"][1]["type"] = "gear"; }, "joints[1].joint1", "gear's bodyA"},
        {[](Json& j) {
             j["joints"][1]["type"] = "gear";
             j["joints"][1]["ratio"] = -1e-46;
         },
         "joints[1].ratio", "other than 0"},
        {[](Json& j) { j["spawns"][0]["body"] = 1; }, "spawns[0].body", "give 4"},
        {[](Json& j) { j["spawns"][0]["afterStep"] = 0; }, "spawns[0].afterStep", "1 or more"},
        {[](Json& j) { j["user"] = 1; }, "user", "give an object"},
        {[](Json& j) {
             j["bodies"][2]["fixtures"][0]["shape"]["center"] = {100000, 0};
             j["bodies"][2]["fixtures"][0]["shape"]["radius"] = 0.01;
         },
         "bodies[2]", "put its position nearer"},
        {[](Json& j) {
             j["bodies"][1]["fixtures"][0]["shape"] = {{"type", "supported"}, {"radius", 0.005}, {"support", "lens"}};
         },
         "bodies[1].fixtures[0].shape.radius", "how far its support function reaches"},
        {[](Json& j) { j["bodies"][1]["fixtures"][0]["density"] = 1e-34; }, "bodies[1].fixtures[0].density",
         "1e-29 to 1e29"},
        // Of a body that does not move, too: the engine computes masses of all fixtures.
        {[](Json& j) {
             j["bodies"][1]["type"] = "kinematic";
             j["bodies"][1]["fixtures"][0]["density"] = 1e-3;
             j["bodies"][1]["fixtures"][0]["shape"]["halfExtents"] = {1e12, 1e10};
         },
         "bodies[1].fixtures[0]", "moment of inertia"},
        {[](Json& j) {
             j["bodies"][1]["fixtures"][0]["shape"]["halfExtents"] = {0.5, 1e18};
             j["bodies"][1]["fixtures"][0]["shape"]["center"] = {0, 1e17};
         },
         "bodies[1].fixtures[0].shape.halfExtents", "reach beyond 1e18"},
        {[](Json& j) {
             j["bodies"][1]["fixtures"][0]["shape"]["halfExtents"] = {9e17, 9e17};
             j["bodies"][1]["fixtures"][0]["shape"]["angle"] = 0.785f;
         },
         "bodies[1].fixtures[0].shape.halfExtents", "reach beyond 1e18"},
    };
    ASSERT_EQ(ErrorOf(SampleJson().dump()), "");
    for (const auto& one : cases) {
        nlohmann::ordered_json json = SampleJson();
        // Members that have their default are not in the text: the joints' axes are put there to be changed.
        one.damage(json);
        const std::string error = ErrorOf(json.dump());
        const std::string start = "some/world.scene.json: " + std::string(one.place) + (one.place.empty() ? "" : ": ");
        EXPECT_TRUE(error.starts_with(start)) << "wanted " << start << " …\n   got " << error;
        EXPECT_NE(error.find(one.says), std::string::npos) << error << "\n does not say " << one.says;
    }
}

/// Programs give the largest number for what has no limit.
TEST(SceneFile, AmountsOfJointsMayBeTheLargestNumber) {
    for (const char* key : {"maxMotorTorque", "maxMotorForce", "maxForce", "maxTorque", "stiffness", "damping"}) {
        const std::string name = key;
        const std::string type = name == "maxMotorTorque"                    ? "revolute"
                                 : name == "maxMotorForce"                   ? "prismatic"
                                 : name == "maxForce" || name == "maxTorque" ? "friction"
                                                                             : "weld";
        nlohmann::ordered_json json = SampleJson();
        json["joints"] = {{{"type", type}, {"bodyA", 0}, {"bodyB", 1}, {name, FLT_MAX}}};
        EXPECT_EQ(ErrorOf(json.dump()), "") << name;
        json["joints"][0][name] = -1;
        EXPECT_NE(ErrorOf(json.dump()).find("joints[0]." + name + ": give a finite number of at least 0"),
                  std::string::npos)
            << ErrorOf(json.dump());
    }
}

TEST(SceneFile, TextThatIsNoJsonIsNamedByLineAndColumn) {
    EXPECT_EQ(ErrorOf("{\n  \"format\": oops"), "some/world.scene.json:2:13: not valid JSON: unexpected \"o\"");
    EXPECT_NE(ErrorOf("").find("ends too early"), std::string::npos);
    EXPECT_NE(ErrorOf(R"({"format": "scree-scene", "format": "x"})").find("stands twice"), std::string::npos);
    EXPECT_NE(ErrorOf(std::string(100000, '[')).find("deeper than"), std::string::npos);
    EXPECT_NE(ErrorOf(R"({"version": 1e999})").find("not valid JSON"), std::string::npos);
}

/// Something hostile in the place of a number, where it is most likely to be read.
void ReplaceNumber(std::string& text, std::size_t at, std::mt19937& random) {
    static const std::vector<std::string> hostile{"1e308",     "-1e39",   "99999999999999999999",
                                                  "null",      "[[[[",    "{}",
                                                  "\"",        "\\u0000", "-0.0",
                                                  "0.0000001", "true",    "-1",
                                                  "\xff",      ",",       "2147483648"};
    const std::size_t digit = text.find_first_of("0123456789", at);
    if (digit == std::string::npos) return;
    const std::size_t end = text.find_first_not_of("0123456789.-+e", digit);
    text.replace(digit, end == std::string::npos ? end : end - digit, hostile[Below(hostile.size(), random)]);
}

TEST(SceneFile, DamagedFilesEndInAnErrorOrInASceneThatIsGood) {
    const int count = CountOfMutations(3000);
    std::mt19937 random(20);
    const std::string texts[] = {SampleJson().dump(1), WriteScene(scenes::Build("gears")),
                                 WriteScene(scenes::Build("convex-shapes"))};
    int refused = 0;
    for (int i = 0; i < count; ++i) {
        std::string text = texts[static_cast<std::size_t>(i) % std::size(texts)];
        Damage(text, random, 1, [&](std::string& whole, std::size_t at) { ReplaceNumber(whole, at, random); });
        try {
            const scenes::Scene scene = ReadScene(text, "x");
            ASSERT_EQ(DescribeFault(scene), "");
            (void)WriteScene(scene);
        } catch (const FileError& error) {
            ++refused;
            ASSERT_TRUE(std::string_view(error.what()).starts_with("x")) << error.what();
        }
    }
    EXPECT_GT(refused, count / 3);
    RecordMutations(count, refused);
}

/// The least of three, s.
double TimeToRead(int bodies) {
    const std::string text = WriteScene(scenes::Build("slow-explosion", bodies));
    double least = std::numeric_limits<double>::max();
    for (int i = 0; i < 3; ++i) {
        const auto start = std::chrono::steady_clock::now();
        EXPECT_EQ(ReadScene(text, "x").bodies.size(), static_cast<size_t>(bodies));
        least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return least;
}

TEST(SceneFile, ReadingTakesTimeInProportionToTheBodies) {
    // Three times what it should be, since caches and busy machines are in it. A square would be a hundredfold.
    EXPECT_LT(TimeToRead(50'000), 30.0 * TimeToRead(5'000));
}

const nlohmann::json& Schema() {
    static const nlohmann::json schema =
        nlohmann::json::parse(ReadText(fs::path(SCREE_SOURCE_DIR) / "testbed/input/scene.schema.json", ""));
    return schema;
}

std::set<std::string> KeysIn(const nlohmann::json& object) {
    std::set<std::string> keys;
    for (const auto& item : object.at("properties").items()) keys.insert(item.key());
    return keys;
}

template <typename Owner>
std::set<std::string> FieldNames(std::set<std::string> others) {
    ForEachField<Owner>([&](const auto& field) { others.insert(std::string(field.name)); });
    return others;
}

TEST(SceneFile, TheSchemaHasTheKeysOfTheReader) {
    const nlohmann::json& definitions = Schema().at("definitions");
    EXPECT_EQ(KeysIn(Schema()), FieldNames<scenes::Scene>({"format", "version", "bodies", "joints", "spawns", "user"}));
    EXPECT_EQ(KeysIn(definitions.at("body")), FieldNames<scenes::Body>({"fixtures"}));
    EXPECT_EQ(KeysIn(definitions.at("fixture")), FieldNames<scenes::Fixture>({"shape"}));
    EXPECT_EQ(KeysIn(definitions.at("spawn")), FieldNames<scenes::Spawn>({}));
    const auto compare = [&](const std::string& kind, std::span<const std::string_view> names, auto keysOf) {
        for (std::size_t i = 0; i < names.size(); ++i) {
            std::set<std::string> keys{"type"};
            for (const std::string_view key : keysOf(i)) keys.insert(std::string(key));
            EXPECT_EQ(KeysIn(definitions.at(kind + "-" + std::string(names[i]))), keys) << names[i];
        }
        EXPECT_EQ(definitions.at(kind).at("properties").at("type").at("enum").size(), names.size());
    };
    compare("shape", shapeTypeNames, [](std::size_t i) { return KeysOf(static_cast<scenes::ShapeType>(i)); });
    compare("joint", jointTypeNames, [](std::size_t i) { return KeysOf(static_cast<scenes::JointType>(i)); });
}

TEST(SceneFile, EveryBuiltInSceneIsValidByTheSchema) {
    // Debian's validator reads the schema as any user's editor does; small sizes, since it takes a millisecond a body.
    const ScratchFolder folder;
    int files = 0;
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        const scenes::Scene scene = scenes::Build(info.name, std::min(info.defaultSize, std::max(info.minSize, 2)));
        if (scene.fixtures.size() > 300) continue;
        std::ofstream(folder.GetPath() / (std::string(info.name) + ".scene.json")) << WriteScene(scene);
        ++files;
    }
    EXPECT_GT(files, 30);
    nlohmann::ordered_json wrong = SampleJson();
    wrong["bodies"][1]["fixtures"][0]["shape"]["radius"] = 1;
    std::ofstream(folder.GetPath() / "wrong.json") << wrong.dump();
    std::ofstream(folder.GetPath() / "validate.py") << R"(
import glob, json, sys
import jsonschema
validator = jsonschema.Draft7Validator(json.load(open(sys.argv[1])))
validator.check_schema(validator.schema)
files = glob.glob("*.scene.json")
for file in files:
    for error in validator.iter_errors(json.load(open(file))):
        print(file, list(error.path), error.message)
if validator.is_valid(json.load(open("wrong.json"))):
    print("wrong.json is valid")
print(len(files), "files")
)";
    const std::string command = "cd '" + folder.GetPath().string() +
                                "' && /usr/bin/python3 validate.py '" SCREE_SOURCE_DIR
                                "/testbed/input/scene.schema.json' >said.txt 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(ReadText(folder.GetPath() / "said.txt", ""), std::to_string(files) + " files\n");
}

}  // namespace
}  // namespace testbed
