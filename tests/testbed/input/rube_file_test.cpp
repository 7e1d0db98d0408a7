// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Worlds exported by R.U.B.E. Random ones read back as what was written. Masses, velocities and springs are those of
// Box2D itself. What no scene can say is told, whatever is wrong is named, and damaged files do no more than that.

#include "testbed/input/rube_file.h"

#include <box2d/box2d.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "testbed/base/errors.h"
#include "testbed/engines/engine_run.h"
#include "testbed/input/body_names.h"
#include "testbed/input/file_kind.h"
#include "testbed/input/scene_file.h"
#include "tests/testbed/input/damage.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

using Json = nlohmann::ordered_json;
using scenes::JointType;
using scenes::ShapeType;
using scenes::Vec2;

RubeWorld ReadWorld(const Json& file) { return ReadRube(file.dump(), "levels/cave.json"); }

std::string ErrorOfWorld(const Json& file) {
    try {
        (void)ReadWorld(file);
    } catch (const FileError& error) {
        return error.what();
    }
    return {};
}

bool Holds(std::string_view text, std::string_view words) { return text.find(words) != std::string_view::npos; }

bool Tells(const RubeWorld& world, std::string_view words) {
    return std::ranges::any_of(world.notices, [&](const std::string& notice) { return Holds(notice, words); });
}

/// How a file writes numbers: both forms of vectors and of numbers occur in the wild.
struct Writing {
    std::mt19937& random;
    bool isHex = false;

    [[nodiscard]] Json Number(float value) const {
        if (isHex && value != 0.0f) {
            const auto bits = std::bit_cast<std::uint32_t>(value);
            return Below(2, random) == 0 ? fmt::format("{:08X}", bits) : fmt::format("{:08x}", bits);
        }
        return value;
    }
    [[nodiscard]] Json Vector(Vec2 v) const {
        if (v == Vec2{} && Below(2, random) == 0) return 0;
        return {{"x", Number(v.x)}, {"y", Number(v.y)}};
    }
    [[nodiscard]] Json Points(const std::vector<Vec2>& points) const {
        Json x = Json::array(), y = Json::array();
        for (const Vec2 point : points) {
            x.push_back(Number(point.x));
            y.push_back(Number(point.y));
        }
        return {{"x", x}, {"y", y}};
    }
};

/// A world that R.U.B.E. could have exported, what it is as a scene, and the same in Box2D.
class RandomWorld {
public:
    RandomWorld(std::mt19937& random, bool isHex) : m_random(random), m_write{random, isHex} {
        scene.gravity = Point(20.0f);
        const float rate = static_cast<float>(30 + Below(200, random));
        scene.timeStep = 1.0f / rate;
        scene.velocityIterations = static_cast<int>(1 + Below(20, random));
        scene.positionIterations = static_cast<int>(Below(9, random));
        file = {{"gravity", m_write.Vector(scene.gravity)},
                {"allowSleep", true},
                {"autoClearForces", true},
                {"stepsPerSecond", m_write.Number(rate)},
                {"velocityIterations", scene.velocityIterations},
                {"positionIterations", scene.positionIterations},
                {"continuousPhysics", true},
                {"warmStarting", true},
                {"subStepping", false},
                {"body", Json::array()},
                {"joint", Json::array()}};
        AddBody(scenes::BodyType::dynamic);  // joints need two
        AddBody(scenes::BodyType::dynamic);
        const std::size_t more = Below(8, random);
        for (std::size_t i = 0; i < more; ++i) AddBody(static_cast<scenes::BodyType>(Below(3, random)));
        const std::size_t joints = Below(8, random);
        for (std::size_t i = 0; i < joints; ++i) AddJoint();
    }

    Json file;
    scenes::Scene scene;
    b2World box2d{b2Vec2(0.0f, 0.0f)};
    std::vector<b2Body*> bodies;

private:
    float Real(float low, float high) { return std::uniform_real_distribution<float>(low, high)(m_random); }
    bool Coin() { return Below(2, m_random) == 0; }
    Vec2 Point(float size) { return Below(4, m_random) == 0 ? Vec2{} : Vec2{Real(-size, size), Real(-size, size)}; }
    void Put(Json& node, const char* key, float value) {
        if (value != 0.0f || Coin()) node[key] = m_write.Number(value);
    }
    void Put(Json& node, const char* key, bool value) {
        if (value || Coin()) node[key] = value;
    }

    void AddBody(scenes::BodyType type) {
        scenes::Body body;
        body.type = type;
        body.position = Point(50.0f);
        body.angle = Coin() ? 0.0f : Real(-4.0f, 4.0f);
        body.firstFixture = static_cast<int>(scene.fixtures.size());
        if (type != scenes::BodyType::isStatic) {
            body.linearVelocity = Point(9.0f);
            body.angularVelocity = Coin() ? 0.0f : Real(-5.0f, 5.0f);
        }
        body.linearDamping = Coin() ? 0.0f : Real(0.0f, 2.0f);
        body.angularDamping = Coin() ? 0.0f : Real(0.0f, 2.0f);
        body.gravityScale = Coin() ? 1.0f : Real(-2.0f, 2.0f);
        body.awake = Coin();
        body.fixedRotation = Below(5, m_random) == 0;
        body.bullet = Coin();
        b2BodyDef def;
        def.type = static_cast<b2BodyType>(type);
        def.position.Set(body.position.x, body.position.y);
        def.angle = body.angle;
        def.linearVelocity.Set(body.linearVelocity.x, body.linearVelocity.y);
        def.angularVelocity = body.angularVelocity;
        def.fixedRotation = body.fixedRotation;
        b2Body* made = box2d.CreateBody(&def);
        Json node{{"type", static_cast<int>(type)}, {"position", m_write.Vector(body.position)}};
        if (Coin()) node["name"] = fmt::format("body {}", scene.bodies.size());
        Put(node, "angle", body.angle);
        if (body.linearVelocity != Vec2{} || Coin()) node["linearVelocity"] = m_write.Vector(body.linearVelocity);
        Put(node, "angularVelocity", body.angularVelocity);
        Put(node, "linearDamping", body.linearDamping);
        Put(node, "angularDamping", body.angularDamping);
        if (body.gravityScale != 1.0f) node["gravityScale"] = m_write.Number(body.gravityScale);
        Put(node, "awake", body.awake);
        Put(node, "fixedRotation", body.fixedRotation);
        Put(node, "bullet", body.bullet);
        const std::size_t fixtures = Below(4, m_random);
        for (std::size_t i = 0; i < fixtures; ++i) node["fixture"].push_back(AddFixture(*made));
        body.fixtureCount = static_cast<int>(scene.fixtures.size()) - body.firstFixture;
        b2MassData mass;
        made->GetMassData(&mass);
        Put(node, "massData-mass", mass.mass);
        Put(node, "massData-I", mass.I);
        if (mass.center.LengthSquared() > 0.0f) {
            node["massData-center"] = m_write.Vector({mass.center.x, mass.center.y});
        }
        file["body"].push_back(node);
        scene.bodies.push_back(body);
        bodies.push_back(made);
    }

    Json AddFixture(b2Body& body) {
        scenes::Fixture fixture;
        fixture.friction = Coin() ? 0.0f : Real(0.0f, 1.0f);
        fixture.restitution = Coin() ? 0.0f : Real(0.0f, 1.0f);
        fixture.density = Real(0.1f, 5.0f);
        fixture.isSensor = Below(4, m_random) == 0;
        Json node = Json::object();
        if (Coin()) node["name"] = "some fixture";
        Put(node, "density", fixture.density);
        Put(node, "friction", fixture.friction);
        Put(node, "restitution", fixture.restitution);
        Put(node, "sensor", fixture.isSensor);
        if (Coin()) {
            fixture.categoryBits = static_cast<std::uint16_t>(Below(65536, m_random));
            fixture.maskBits = static_cast<std::uint16_t>(Below(65536, m_random));
            fixture.groupIndex = static_cast<std::int16_t>(static_cast<int>(Below(65536, m_random)) - 32768);
            node["filter-categoryBits"] = fixture.categoryBits;
            node["filter-maskBits"] = fixture.maskBits;
            node["filter-groupIndex"] = fixture.groupIndex;
        }
        const Vec2 middle = Point(3.0f);
        if (Coin()) {
            fixture.shape.type = ShapeType::circle;
            fixture.shape.center = middle;
            fixture.shape.radius = Real(0.1f, 3.0f);
            node["circle"] = {{"center", m_write.Vector(middle)}, {"radius", m_write.Number(fixture.shape.radius)}};
            b2CircleShape circle;
            circle.m_p.Set(middle.x, middle.y);
            circle.m_radius = fixture.shape.radius;
            body.CreateFixture(&circle, fixture.density);
        } else {
            fixture.shape.type = ShapeType::polygon;
            std::vector<Vec2> vertices = Ring(3 + Below(6, m_random), middle);
            std::ranges::copy(vertices, fixture.shape.vertices.begin());
            fixture.shape.vertexCount = static_cast<std::uint8_t>(vertices.size());
            b2PolygonShape polygon;
            polygon.Set(reinterpret_cast<const b2Vec2*>(vertices.data()), static_cast<int>(vertices.size()));
            body.CreateFixture(&polygon, fixture.density);
            node["polygon"]["vertices"] = m_write.Points(vertices);
        }
        scene.fixtures.push_back(fixture);
        return node;
    }

    /// Convex and counter-clockwise.
    std::vector<Vec2> Ring(std::size_t count, Vec2 middle) {
        const float radius = Real(0.3f, 3.0f), begin = Real(0.0f, 6.0f);
        std::vector<Vec2> ring;
        for (std::size_t i = 0; i < count; ++i) {
            const float angle = begin + 6.2831853f * static_cast<float>(i) / static_cast<float>(count);
            ring.push_back({middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle)});
        }
        return ring;
    }

    void AddJoint() {
        scenes::Joint joint;
        joint.bodyA = static_cast<int>(Below(scene.bodies.size(), m_random));
        joint.bodyB = static_cast<int>(Below(scene.bodies.size(), m_random));
        if (joint.bodyA == joint.bodyB) joint.bodyB = (joint.bodyA + 1) % static_cast<int>(scene.bodies.size());
        joint.collideConnected = Coin();
        Json node{{"bodyA", joint.bodyA}, {"bodyB", joint.bodyB}};
        if (Coin()) node["name"] = "some joint";
        Put(node, "collideConnected", joint.collideConnected);
        constexpr const char* types[]{"revolute", "prismatic", "wheel",    "distance", "rope",
                                      "motor",    "weld",      "friction", "pulley"};
        const std::string type = types[Below(std::size(types), m_random)];
        node["type"] = type;
        if (type != "motor") {
            joint.localAnchorA = Point(4.0f);
            joint.localAnchorB = Point(4.0f);
            node["anchorA"] = m_write.Vector(joint.localAnchorA);
            node["anchorB"] = m_write.Vector(joint.localAnchorB);
        }
        FillJoint(type, node, joint);
        file["joint"].push_back(node);
        scene.joints.push_back(joint);
    }

    void FillMotor(Json& node, scenes::Joint& joint, const char* key, float& most) {
        joint.enableMotor = Coin();
        joint.motorSpeed = Real(-5.0f, 5.0f);
        most = Real(0.0f, 100.0f);
        Put(node, "enableMotor", joint.enableMotor);
        Put(node, "motorSpeed", joint.motorSpeed);
        Put(node, key, most);
    }
    void FillLimits(Json& node, scenes::Joint& joint, float& lower, float& upper) {
        joint.enableLimit = Coin();
        lower = Real(-3.0f, 0.0f);
        upper = Real(0.0f, 3.0f);
        Put(node, "enableLimit", joint.enableLimit);
        Put(node, "lowerLimit", lower);
        Put(node, "upperLimit", upper);
    }
    void FillAngle(Json& node, float& angle) {
        angle = Coin() ? 0.0f : Real(-3.0f, 3.0f);
        Put(node, "refAngle", angle);
    }
    void FillAxis(Json& node, scenes::Joint& joint) {
        const float angle = Real(0.0f, 6.0f);
        joint.localAxisA = {std::cos(angle), std::sin(angle)};
        node[Coin() ? "localAxisA" : "localAxis1"] = m_write.Vector(joint.localAxisA);
    }
    /// Stiffness and damping as Box2D's own function makes them of frequency and ratio.
    template <typename Function>
    void FillSpring(Json& node, scenes::Joint& joint, const char* frequencyKey, const char* ratioKey,
                    Function&& stiffness) {
        const float frequency = Coin() ? 0.0f : Real(0.5f, 20.0f), ratio = Real(0.0f, 1.5f);
        Put(node, frequencyKey, frequency);
        Put(node, ratioKey, ratio);
        stiffness(joint.stiffness, joint.damping, frequency, ratio, bodies[static_cast<std::size_t>(joint.bodyA)],
                  bodies[static_cast<std::size_t>(joint.bodyB)]);
    }

    void FillJoint(const std::string& type, Json& node, scenes::Joint& joint) {
        if (type == "revolute") {
            joint.type = JointType::revolute;
            FillAngle(node, joint.referenceAngle);
            FillLimits(node, joint, joint.lowerAngle, joint.upperAngle);
            FillMotor(node, joint, "maxMotorTorque", joint.maxMotorTorque);
        } else if (type == "prismatic") {
            joint.type = JointType::prismatic;
            FillAngle(node, joint.referenceAngle);
            FillAxis(node, joint);
            FillLimits(node, joint, joint.lowerTranslation, joint.upperTranslation);
            FillMotor(node, joint, "maxMotorForce", joint.maxMotorForce);
        } else if (type == "wheel") {
            joint.type = JointType::wheel;
            FillAxis(node, joint);
            FillMotor(node, joint, "maxMotorTorque", joint.maxMotorTorque);
            FillSpring(node, joint, "springFrequency", "springDampingRatio", b2LinearStiffness);
        } else if (type == "distance") {
            joint.type = JointType::distance;
            joint.length = Real(0.5f, 9.0f);
            node["length"] = m_write.Number(joint.length);
            FillSpring(node, joint, "frequency", "dampingRatio", b2LinearStiffness);
            if (joint.stiffness == 0.0f) joint.minLength = joint.maxLength = joint.length;
        } else if (type == "rope") {
            joint.type = JointType::distance;
            joint.length = joint.maxLength = Real(0.5f, 9.0f);
            node["maxLength"] = m_write.Number(joint.maxLength);
        } else if (type == "motor") {
            joint.type = JointType::motor;
            joint.linearOffset = Point(3.0f);
            node[Coin() ? "linearOffset" : "anchorA"] = m_write.Vector(joint.linearOffset);
            FillAngle(node, joint.angularOffset);
            joint.correctionFactor = Real(0.0f, 1.0f);
            node["correctionFactor"] = m_write.Number(joint.correctionFactor);
            FillForces(node, joint);
        } else if (type == "weld") {
            joint.type = JointType::weld;
            FillAngle(node, joint.referenceAngle);
            FillSpring(node, joint, "frequency", "dampingRatio", b2AngularStiffness);
        } else if (type == "friction") {
            joint.type = JointType::friction;
            FillForces(node, joint);
        } else {
            joint.type = JointType::pulley;
            joint.groundAnchorA = Point(9.0f);
            joint.groundAnchorB = Point(9.0f);
            node["groundAnchorA"] = m_write.Vector(joint.groundAnchorA);
            node["groundAnchorB"] = m_write.Vector(joint.groundAnchorB);
            for (const auto& [key, value] : {std::pair{"lengthA", &joint.lengthA}, std::pair{"lengthB", &joint.lengthB},
                                             std::pair{"ratio", &joint.ratio}}) {
                *value = Real(0.5f, 5.0f);
                node[key] = m_write.Number(*value);
            }
        }
    }
    void FillForces(Json& node, scenes::Joint& joint) {
        joint.maxForce = Real(0.0f, 100.0f);
        joint.maxTorque = Real(0.0f, 100.0f);
        Put(node, "maxForce", joint.maxForce);
        Put(node, "maxTorque", joint.maxTorque);
    }

    std::mt19937& m_random;
    Writing m_write;
};

TEST(RubeFile, RandomWorldsReadBackAsWhatTheyWereWrittenFrom) {
    std::mt19937 random(11);
    int springs = 0, spins = 0;
    for (int round = 0; round < 300; ++round) {
        RandomWorld world(random, round % 2 == 1);
        for (scenes::Fixture& fixture : world.scene.fixtures) {
            // A missing density is none.
            ASSERT_GT(fixture.density, 0.0f);
        }
        const RubeWorld read = ReadWorld(world.file);
        SCOPED_TRACE(world.file.dump(1));
        EXPECT_TRUE(read.notices.empty()) << read.notices.front();
        EXPECT_EQ(read.scene.name, "cave");
        EXPECT_EQ(read.scene.gravity, world.scene.gravity);
        EXPECT_EQ(read.scene.timeStep, world.scene.timeStep);
        EXPECT_EQ(read.scene.velocityIterations, world.scene.velocityIterations);
        EXPECT_EQ(read.scene.positionIterations, world.scene.positionIterations);
        EXPECT_TRUE(read.scene.fixtures == world.scene.fixtures);
        ASSERT_EQ(read.scene.bodies.size(), world.scene.bodies.size());
        for (std::size_t i = 0; i < world.bodies.size(); ++i) {
            scenes::Body expected = world.scene.bodies[i];
            const scenes::Body& body = read.scene.bodies[i];
            const b2Vec2 velocity = world.bodies[i]->GetLinearVelocity();
            EXPECT_NEAR(body.linearVelocity.x, velocity.x, 1e-4) << i;
            EXPECT_NEAR(body.linearVelocity.y, velocity.y, 1e-4) << i;
            spins += body.linearVelocity != expected.linearVelocity;
            expected.linearVelocity = body.linearVelocity;
            EXPECT_TRUE(body == expected) << i;
        }
        ASSERT_EQ(read.scene.joints.size(), world.scene.joints.size());
        for (std::size_t i = 0; i < world.scene.joints.size(); ++i) {
            scenes::Joint expected = world.scene.joints[i];
            const scenes::Joint& joint = read.scene.joints[i];
            // Masses are sums of floats there and of doubles here.
            EXPECT_NEAR(joint.stiffness, expected.stiffness, 1e-3f * expected.stiffness) << i;
            EXPECT_NEAR(joint.damping, expected.damping, 1e-3f * expected.damping) << i;
            springs += joint.stiffness > 0.0f;
            expected.stiffness = joint.stiffness;
            expected.damping = joint.damping;
            if (joint.localAxisA != expected.localAxisA) {  // made of length 1
                EXPECT_NEAR(joint.localAxisA.x, expected.localAxisA.x, 1e-6) << i;
                EXPECT_NEAR(joint.localAxisA.y, expected.localAxisA.y, 1e-6) << i;
                expected.localAxisA = joint.localAxisA;
            }
            EXPECT_TRUE(joint == expected) << i;
        }
        const scenes::Scene again = ReadScene(WriteScene(read.scene), "again");
        EXPECT_EQ(WriteScene(again), WriteScene(read.scene));
    }
    EXPECT_GT(springs, 50);
    EXPECT_GT(spins, 50) << "bodies whose centre is beside their origin, and that turn";
}

Json Ground() {
    return Json::parse(R"({"gravity": {"x": 0, "y": -10}, "allowSleep": true, "stepsPerSecond": 60, "body": [
        {"type": 0, "name": "ground", "fixture": [{"name": "floor", "friction": 0.5,
            "chain": {"vertices": {"x": [-20, 20], "y": [0, 0]}}}]},
        {"type": 2, "name": "hero", "awake": true, "position": {"x": 1, "y": 3}, "massData-mass": 1, "massData-I": 0.1667,
         "fixture": [{"density": 1, "polygon": {"vertices": {"x": [-0.5, 0.5, 0.5, -0.5], "y": [-0.5, -0.5, 0.5, 0.5]}}}]},
        {"type": 2, "awake": true, "position": {"x": 4, "y": 2},
         "fixture": [{"density": 1, "circle": {"center": 0, "radius": 0.5}}]}],
        "joint": [{"type": "distance", "name": "leash", "bodyA": 1, "bodyB": 2, "length": 3, "frequency": 2}]})");
}

TEST(RubeFile, NamesAreKeptBesideTheScene) {
    const RubeWorld world = ReadWorld(Ground());
    const auto user = nlohmann::json::parse(world.scene.user);
    EXPECT_EQ(user.at("bodies").at("0").at("name"), "ground");
    EXPECT_EQ(user.at("bodies").at("1").at("name"), "hero");
    EXPECT_FALSE(user.at("bodies").contains("2"));
    EXPECT_EQ(user.at("fixtures").at("0").at("name"), "floor");
    EXPECT_EQ(user.at("joints").at("0").at("name"), "leash");
}

/// Whatever its direction, things rest on it from above and from below, as they do in the editor.
TEST(RubeFile, ChainsCollideOnBothSidesInBothEngines) {
    for (const bool isTurned : {false, true}) {
        for (const float up : {-10.0f, 10.0f}) {
            Json file = Ground();
            file["gravity"]["y"] = up;
            if (isTurned) file["body"][0]["fixture"][0]["chain"]["vertices"]["x"] = {20, -20};
            for (const std::size_t i : {1u, 2u}) file["body"][i]["position"]["y"] = up < 0 ? 3 : -3;
            const RubeWorld world = ReadWorld(file);
            EXPECT_TRUE(Tells(world, "collides on both sides")) << "or nobody knows why there are two";
            for (const auto& make : {MakeBox2dRun(world.scene, {}), MakeScreeRun(world.scene, {})}) {
                for (int i = 0; i < 200; ++i) make->Step();
                Snapshot snapshot;
                make->Capture(snapshot);
                for (const int body : {1, 2}) {
                    const float y = snapshot.bodies[static_cast<std::size_t>(body)].position.y;
                    EXPECT_NEAR(std::abs(y), 0.5f, 0.05f) << snapshot.engine << " " << isTurned << " " << up;
                }
            }
        }
    }
}

TEST(RubeFile, ChainsThatCloseAreLoops) {
    Json file = Ground();
    Json& chain = file["body"][0]["fixture"][0]["chain"];
    const Json ring{{"x", {-20, 20, 0, -20}}, {"y", {0, 0, 9, 0}}};
    chain = {{"vertices", ring}};
    EXPECT_TRUE(ReadWorld(file).scene.fixtures[0].shape.IsLoop());
    EXPECT_EQ(ReadWorld(file).scene.fixtures[0].shape.chainVertexCount, 3);
    chain = {{"vertices", ring},
             {"hasPrevVertex", true},
             {"prevVertex", {{"x", 0}, {"y", 9}}},
             {"hasNextVertex", true},
             {"nextVertex", {{"x", 20}, {"y", 0}}}};
    EXPECT_TRUE(ReadWorld(file).scene.fixtures[0].shape.IsLoop()) << "the ghosts are the neighbours";
    chain["prevVertex"] = {{"x", -30}, {"y", 9}};
    const scenes::Scene open = ReadWorld(file).scene;
    EXPECT_FALSE(open.fixtures[0].shape.IsLoop());
    EXPECT_EQ(open.fixtures[0].shape.vertices[0], (Vec2{-30, 9}));
    EXPECT_EQ(open.fixtures[0].shape.vertices[1], (Vec2{20, 0}));
    EXPECT_EQ(open.fixtures[1].shape.vertices[1], (Vec2{-30, 9})) << "turned round";
    file["body"][0]["fixture"][0].erase("chain");
    file["body"][0]["fixture"][0]["loop"]["vertices"] = {{"x", {-20, 20, 0}}, {"y", {0, 0, 9}}};
    EXPECT_TRUE(ReadWorld(file).scene.fixtures[0].shape.IsLoop());
}

TEST(RubeFile, PolygonsAreTheirHulls) {
    Json file = Ground();
    Json& vertices = file["body"][1]["fixture"][0]["polygon"]["vertices"];
    file["body"][1].erase("massData-mass");
    vertices = {{"x", {-1, -1, 1, 1}}, {"y", {-1, 1, 1, -1}}};  // clockwise
    scenes::Shape shape = ReadWorld(file).scene.fixtures[2].shape;
    EXPECT_EQ(shape.vertexCount, 4);
    EXPECT_EQ(shape.vertices[0], (Vec2{1, -1}));
    vertices = {{"x", {-1, 1, 1, -1, 0, 0, 1.0005}}, {"y", {-1, -1, 1, 1, 0, -1, 1}}};  // inside, between, twice
    shape = ReadWorld(file).scene.fixtures[2].shape;
    EXPECT_EQ(shape.vertexCount, 4);
    Json x = Json::array(), y = Json::array();
    for (int i = 0; i < 20; ++i) {
        x.push_back(std::cos(0.314159 * i));
        y.push_back(std::sin(0.314159 * i));
    }
    vertices = {{"x", x}, {"y", y}};
    const RubeWorld large = ReadWorld(file);
    EXPECT_EQ(large.scene.fixtures[2].shape.type, ShapeType::largePolygon);
    EXPECT_EQ(large.scene.fixtures[2].shape.chainVertexCount, 20);
    EXPECT_TRUE(Tells(large, "body[1].fixture[0].polygon: more than 8 vertices"));
    vertices = {{"x", {-1, 1}}, {"y", {0, 0}}};
    EXPECT_EQ(ReadWorld(file).scene.fixtures[2].shape.type, ShapeType::edge);
}

TEST(RubeFile, MassesThatDensitiesCanGiveAreGiven) {
    Json file = Ground();
    Json& hero = file["body"][1];
    hero["massData-mass"] = 4;
    hero["massData-I"] = 4.0 / 6;
    const RubeWorld scaled = ReadWorld(file);
    EXPECT_TRUE(Tells(scaled, "densities are scaled"));
    EXPECT_NEAR(scaled.scene.fixtures[2].density, 4.0f, 1e-5f);
    const double mass = 4.0 * 0.785398163 / (4.0 + 0.785398163), omega = 2 * 6.283185307;
    EXPECT_NEAR(scaled.scene.joints[0].stiffness, mass * omega * omega, 1e-3) << "springs feel it";
    hero["massData-center"] = {{"x", 0.2}, {"y", 0}};
    const RubeWorld other = ReadWorld(file);
    EXPECT_TRUE(Tells(other, "body[1].massData-mass: its mass, centre or inertia is not what its fixtures give"));
    EXPECT_EQ(other.scene.fixtures[2].density, 1.0f);
}

TEST(RubeFile, GearsComeBehindWhatTheyCouple) {
    Json file = Ground();
    file["joint"] = Json::parse(R"([
        {"type": "gear", "bodyA": 1, "bodyB": 2, "joint1": 1, "joint2": 2, "ratio": 2, "name": "gear"},
        {"type": "revolute", "bodyA": 0, "bodyB": 1},
        {"type": "prismatic", "bodyA": 0, "bodyB": 2, "localAxisA": {"x": 0, "y": 3}}])");
    const scenes::Scene scene = ReadWorld(file).scene;
    ASSERT_EQ(scene.joints.size(), 3u);
    EXPECT_EQ(scene.joints[2].type, JointType::gear);
    EXPECT_EQ(scene.joints[2].joint1, 0);
    EXPECT_EQ(scene.joints[2].joint2, 1);
    EXPECT_EQ(scene.joints[2].bodyA, 1);
    EXPECT_EQ(scene.joints[1].localAxisA, (Vec2{0, 1}));
    EXPECT_EQ(nlohmann::json::parse(scene.user).at("joints").at("2").at("name"), "gear");
    file["joint"][0]["joint1"] = 0;
    EXPECT_TRUE(Tells(ReadWorld(file), "joint[0]: couples a joint that is left out or a gear"));
}

TEST(RubeFile, AMouseJointsAnchorIsAPointOfTheWorld) {
    Json file = Ground();
    file["body"][1]["angle"] = 1.5707963267948966;
    file["joint"] = Json::parse(R"([{"type": "mouse", "bodyA": 0, "bodyB": 1, "target": {"x": 9, "y": 8}, "maxForce": 7,
        "anchorB": {"x": 1, "y": 3.5}, "frequency": 5, "dampingRatio": 0.7}])");
    const scenes::Joint joint = ReadWorld(file).scene.joints[0];
    EXPECT_NEAR(joint.localAnchorB.x, 0.5f, 1e-6f);
    EXPECT_NEAR(joint.localAnchorB.y, 0.0f, 1e-6f);
    EXPECT_EQ(joint.target, (Vec2{9, 8}));
    EXPECT_NEAR(joint.stiffness, 986.96f, 0.1f);
}

TEST(RubeFile, WhatNoSceneSaysIsToldOnceAKind) {
    Json file = Ground();
    file["image"] = Json::parse(R"([{"name": "sky", "file": "sky.png"}, {"name": "hero", "body": 1}])");
    file["customProperties"] = Json::parse(R"([{"name": "level", "int": 3}])");
    for (const std::size_t i : {0u, 2u}) file["body"][i]["customProperties"] = file["customProperties"];
    file["warmStarting"] = false;
    file["continuousPhysics"] = false;
    file["subStepping"] = true;
    file["body"][1]["active"] = false;
    file["body"][2]["gravtyScale"] = 2;
    const RubeWorld world = ReadWorld(file);
    EXPECT_TRUE(Tells(world, "image: images are left out, 2 of them"));
    EXPECT_EQ(std::ranges::count_if(world.notices, [](const auto& n) { return Holds(n, "custom properties"); }), 1);
    EXPECT_TRUE(Tells(world, "and 2 more: custom properties"));
    EXPECT_TRUE(Tells(world, "--set warmStarting=off"));
    EXPECT_TRUE(Tells(world, "--set continuous=off"));
    EXPECT_TRUE(Tells(world, "subStepping: belongs to a run"));
    EXPECT_TRUE(Tells(world, "body[1]: not active"));
    EXPECT_TRUE(Tells(world, "joint[0]: joins a body that is not active"));
    EXPECT_TRUE(Tells(world, "body[2]: 'gravtyScale' is not a key"));
    EXPECT_EQ(world.scene.bodies[1].type, scenes::BodyType::isStatic);
    EXPECT_EQ(world.scene.bodies[1].fixtureCount, 0);
    EXPECT_EQ(world.scene.bodies[2].fixtureCount, 1);
    EXPECT_TRUE(world.scene.joints.empty());
    file["allowSleep"] = false;
    for (const scenes::Body& body : ReadWorld(file).scene.bodies) EXPECT_FALSE(body.allowSleep);
}

TEST(RubeFile, ErrorsNameThePlaceInTheFileAndTheCure) {
    const struct {
        const char* pointer;
        Json value;
        const char* says;
    } cases[] = {
        {"/gravity", "x", "gravity: give {\"x\": number, \"y\": number}, or 0"},
        {"/gravity/x", "3f8000", "gravity.x: give a number, or the bits"},
        {"/gravity/x", "7F800000", "gravity.x: give a finite number"},
        {"/stepsPerSecond", 0, "stepsPerSecond: give 0.1 to 1e6"},
        {"/body/1/type", 3, "body[1].type: give a whole number from 0 to 2"},
        {"/body/1/awake", "yes", "body[1].awake: give true or false"},
        {"/body/2/fixture/0/circle/radius", -1, "body[2].fixture[0].shape.radius: give a radius"},
        {"/body/2/fixture/0/density", -1, "body[2].fixture[0].density: give a number from 0"},
        {"/body/2/fixture/0/chain", {{"vertices", 0}}, "body[2].fixture[0]: has both 'circle' and 'chain'"},
        {"/body/2/fixture/0/circle", nullptr, "body[2].fixture[0].circle: give an object"},
        {"/body/1/fixture/0/polygon/vertices/x",
         {1, 2, 3},
         "polygon.vertices: give {\"x\": [numbers], \"y\": [as many]}"},
        {"/body/1/fixture/0/polygon/vertices/x/2", true, "fixture[0].polygon.vertices.x[2]: give a number"},
        {"/joint/0/type", "distanc", "joint[0].type: unknown joint 'distanc'; did you mean 'distance'"},
        {"/joint/0/bodyB", 3, "joint[0].bodyB: give a whole number from 0 to 2"},
        {"/joint/0/bodyB", 1, "joint[0].bodyB: give another body than bodyA"},
        {"/joint/0/frequency", -2, "joint[0].frequency: give a frequency of 0 or more"},
        {"/body", 3, "body: give an array"},
    };
    for (const auto& one : cases) {
        Json file = Ground();
        file[Json::json_pointer(one.pointer)] = one.value;
        const std::string error = ErrorOfWorld(file);
        EXPECT_TRUE(error.starts_with("levels/cave.json: ")) << error;
        EXPECT_TRUE(Holds(error, one.says)) << error << "\n does not say " << one.says;
    }
    EXPECT_TRUE(Holds(ErrorOfWorld(Json::object()), "\"gravity\" and \"body\""));
}

TEST(RubeFile, DamagedFilesEndInAnErrorOrInASceneThatIsGood) {
    const int count = CountOfMutations(3000);
    std::mt19937 random(21);
    static const std::vector<std::string> hostile{"1e308",        "-1e39", "null", "[[[[",  "{}", "\"7F800000\"",
                                                  "\"FFC00000\"", "-1",    "true", "1e-40", "\"", "65536"};
    int refused = 0;
    for (int i = 0; i < count; ++i) {
        std::string text = i % 3 == 0 ? Ground().dump() : RandomWorld(random, i % 2 == 0).file.dump();
        Damage(text, random, 2, [&](std::string& whole, std::size_t at) {
            const std::size_t digit = whole.find_first_of("0123456789", at);
            if (digit == std::string::npos) return;
            const std::size_t end = whole.find_first_not_of("0123456789.-+e", digit);
            whole.replace(digit, end == std::string::npos ? end : end - digit, hostile[Below(hostile.size(), random)]);
        });
        try {
            const RubeWorld world = ReadRube(text, "x");
            ASSERT_EQ(DescribeFault(world.scene), "");
            (void)WriteScene(world.scene);
        } catch (const FileError& error) {
            ++refused;
            ASSERT_TRUE(std::string_view(error.what()).starts_with("x")) << error.what();
        }
    }
    EXPECT_GT(refused, count / 3);
    RecordMutations(count, refused);
}

TEST(RubeFile, AreToldFromScenesByTheirKeys) {
    EXPECT_EQ(KindOfBytes(Ground().dump(2)), FileKind::rube);
    EXPECT_EQ(KindOfBytes(R"( {"gravity": 0, "stepsPerSecond": 60})"), FileKind::rube);
    EXPECT_EQ(KindOfBytes(R"({"gravity": [0, 1], "user": {"body": 1}, "format": "scree-scene"})"), FileKind::scene);
    EXPECT_EQ(KindOfBytes(R"({"name": "x\"body\":", "gravity": 0})"), std::nullopt);
    EXPECT_EQ(KindOfEnding("a.scene.json"), FileKind::scene);
    EXPECT_EQ(KindOfEnding("a.json"), FileKind::rube);
}

TEST(RubeFile, EveryCommandThatTakesASceneTakesThem) {
    const ScratchFolder folder;
    Json file = Ground();
    file["image"] = Json::array({{{"name", "sky"}}});
    std::ofstream(folder.GetPath() / "cave.json") << file.dump(1);
    std::ofstream(folder.GetPath() / "cave.txt") << file.dump(1);
    std::ofstream(folder.GetPath() / "other.json") << "{\"a\": 1}";
    const ProgramResult info = folder.Run("info cave.json cave.txt");
    EXPECT_EQ(info.exitCode, 0) << info.output;
    EXPECT_NE(info.output.find("kind             rube"), std::string::npos) << info.output;
    EXPECT_NE(info.output.find("writer           R.U.B.E.\n"), std::string::npos) << info.output;
    EXPECT_NE(info.output.find("\nmoving extent    "), std::string::npos) << info.output;
    EXPECT_NE(info.output.find("notice           image: images are left out"), std::string::npos) << info.output;
    const ProgramResult converted = folder.Run("convert cave.json cave.scene.json");
    EXPECT_EQ(converted.exitCode, 0) << converted.output;
    EXPECT_NE(converted.output.find("scree: cave.json: image: images are left out"), std::string::npos);
    EXPECT_EQ(ReadSceneFile(folder.GetPath() / "cave.scene.json"),
              WithWriter(ReadRube(file.dump(), "cave.json").scene));
    EXPECT_EQ(folder.Run("metrics cave.txt --format rube --steps 30 --image 320x200 -o a").exitCode, 0);
    EXPECT_EQ(folder.Run("metrics cave.scene.json --steps 30 --image 320x200 -o b").exitCode, 0);
    const auto hash = [&](const std::string& path) {
        return nlohmann::json::parse(folder.Read(path)).at("rows").back().at("state_hash");
    };
    EXPECT_EQ(hash("a/cave/metrics.json"), hash("b/cave/metrics.json"));
    EXPECT_EQ(folder.Run("view cave.json --offscreen --frames 2").exitCode, 0);
    const ProgramResult found = folder.Run("find cave.json --steps 200 --when 'body(\"hero\").y < 1'");
    EXPECT_EQ(found.exitCode, 1) << found.output;
    const ProgramResult written = folder.Run("convert pyramid pyramid.json");
    EXPECT_EQ(written.exitCode, exitUsage);
    EXPECT_NE(written.output.find("only read; give *.scene.json"), std::string::npos) << written.output;
    const ProgramResult scene = folder.Run("info cave.scene.json --format rube");
    EXPECT_EQ(scene.exitCode, exitIo);
    EXPECT_NE(scene.output.find("--format scene reads it"), std::string::npos) << scene.output;
    EXPECT_EQ(folder.Run("render other.json").exitCode, exitIo);
}

}  // namespace
}  // namespace testbed
