// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Worlds of our engine recorded by scree_capture.h and read again: the same bits of every body after every step, the
// same scene, the same contacts and nodes, within the promised size; and whatever a program does between two steps.

#include "testbed/capture/scree_capture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>

#include "testbed/base/errors.h"
#include "testbed/engines/scree_joint.h"
#include "testbed/engines/scree_shape.h"
#include "testbed/input/scene_file.h"
#include "tests/testbed/capture/track_test_world.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

/// A scene in our engine, made as ScreeRun makes it.
class SceneWorld {
public:
    explicit SceneWorld(const scenes::Scene& scene)
        : m_scene(scene), m_world(scree::Vec2{scene.gravity.x, scene.gravity.y}) {
        for (int i = 0; i < scene.InitialBodyCount(); ++i) CreateBody(scene.bodies[static_cast<std::size_t>(i)]);
        for (const scenes::Joint& joint : scene.joints) {
            m_joints.push_back(CreateScreeJoint(m_world, joint, m_bodies, m_joints));
        }
    }

    void Step() {
        m_world.Step(m_scene.timeStep, m_scene.velocityIterations, m_scene.positionIterations);
        ++m_step;
        for (; m_spawned < m_scene.spawns.size() && m_scene.spawns[m_spawned].afterStep <= m_step; ++m_spawned) {
            CreateBody(m_scene.bodies[static_cast<std::size_t>(m_scene.spawns[m_spawned].body)]);
        }
    }
    [[nodiscard]] std::vector<BodyBits> GetBits() const {
        std::vector<BodyBits> bits;
        for (const scree::Body* body : m_bodies) bits.push_back(BitsOf(*body, body->GetType() == scree::staticBody));
        return bits;
    }
    scree::World& GetWorld() { return m_world; }
    std::vector<scree::Body*>& GetBodies() { return m_bodies; }

private:
    void CreateBody(const scenes::Body& body) {
        scree::BodyDef def;
        def.type = static_cast<scree::BodyType>(body.type);
        def.bullet = body.bullet;
        def.allowSleep = body.allowSleep;
        def.awake = body.awake;
        def.fixedRotation = body.fixedRotation;
        def.position = ToScree(body.position);
        def.angle = body.angle;
        def.linearVelocity = ToScree(body.linearVelocity);
        def.angularVelocity = body.angularVelocity;
        def.linearDamping = body.linearDamping;
        def.angularDamping = body.angularDamping;
        def.gravityScale = body.gravityScale;
        scree::Body* made = m_world.CreateBody(&def);
        m_bodies.push_back(made);
        for (int i = body.firstFixture; i < body.firstFixture + body.fixtureCount; ++i) {
            CreateFixture(*made, m_scene.fixtures[static_cast<std::size_t>(i)]);
        }
        if (body.angularVelocity != 0.0f) made->SetLinearVelocity(ToScree(body.linearVelocity));
    }
    void CreateFixture(scree::Body& body, const scenes::Fixture& fixture) {
        scree::FixtureDef def;
        def.density = fixture.density;
        def.friction = fixture.friction;
        def.restitution = fixture.restitution;
        def.isSensor = fixture.isSensor;
        def.filter = {fixture.categoryBits, fixture.maskBits, fixture.groupIndex};
        if (fixture.shape.type == scenes::ShapeType::chain) {
            const scree::ChainShape chain = MakeScreeChain(m_scene, fixture.shape);
            def.shape = &chain;
            body.CreateFixture(&def);
        } else {
            const ScreeShape shape = MakeScreeShape(m_scene, fixture.shape);
            def.shape = &AsShape(shape);
            body.CreateFixture(&def);
        }
    }

    scenes::Scene m_scene;
    scree::World m_world;
    std::vector<scree::Body*> m_bodies;
    ScreeJoints m_joints;
    std::size_t m_spawned = 0;
    int m_step = 0;
};

/// Expects that a track says what was noted after each step, forwards and at random.
void ExpectSameMotion(TrackFile& track, const std::vector<std::vector<BodyBits>>& history, const std::string& name) {
    ASSERT_EQ(track.GetInfo().damage, "") << name;
    ASSERT_EQ(track.GetLastStep(), static_cast<int>(history.size()) - 1) << name;
    std::mt19937 random(17);
    for (std::size_t i = 0; i < 2 * history.size(); ++i) {
        const std::size_t step = i < history.size() ? i : random() % history.size();
        const TrackStep& read = track.Read(static_cast<int>(step));
        ASSERT_GE(read.bodies.size(), history[step].size()) << name;
        for (std::size_t k = 0; k < history[step].size(); ++k) {
            ASSERT_TRUE(read.bodies[k].isThere) << name << " step " << step << " body " << k;
            ASSERT_TRUE(BitsOf(read.bodies[k]) == history[step][k]) << name << " step " << step << " body " << k;
        }
    }
}

TEST(ScreeCapture, EveryBuiltInSceneReadsBackToTheSameBits) {
    const ScratchFolder folder;
    const std::string path = folder.GetPath() / "session.track";
    double allBytes = 0.0, allMoves = 0.0;
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        const scenes::Scene scene = BuildSmall(info);
        SceneWorld world(scene);
        std::vector<std::vector<BodyBits>> history{world.GetBits()};
        {
            scree_capture::Track track(world.GetWorld(), path);
            for (int step = 1; step <= std::min(scene.steps, 150); ++step) {
                world.Step();
                track.Step(scene.timeStep);
                history.push_back(world.GetBits());
            }
            ASSERT_EQ(track.GetError(), "");
            ASSERT_EQ(track.GetSkippedSteps(), 0);
        }
        TrackFile track = ReadTrackFile(path);
        ExpectSameMotion(track, history, std::string(info.name));
        EXPECT_EQ(track.GetInfo().engine, "scree");
        EXPECT_EQ(track.GetInfo().timeStep, scene.timeStep);
        const double bytes = CountStepBytes(path);
        const auto moves = static_cast<double>(CountMoves(history));
        allBytes += bytes;
        allMoves += moves;
        // Even if no body could be predicted.
        EXPECT_LT(bytes, 26.0 * moves + 60.0 * static_cast<double>(history.size())) << info.name;
    }
    EXPECT_LT(allBytes, 20.0 * allMoves);
    RecordProperty("bytes a move", std::to_string(allBytes / allMoves));
}

TEST(ScreeCapture, AWrittenSceneIsTheSameWorld) {
    // Shapes with arcs are written as polygons, and the anchors of pulleys and mouse joints are rounded once more.
    const auto isExact = [](const scenes::Scene& scene) {
        return std::ranges::none_of(
                   scene.fixtures,
                   [](const scenes::Fixture& fixture) { return fixture.shape.type >= scenes::ShapeType::ellipse; }) &&
               std::ranges::none_of(scene.joints, [](const scenes::Joint& joint) {
                   return joint.type == scenes::JointType::pulley || joint.type == scenes::JointType::mouse;
               });
    };
    const ScratchFolder folder;
    const std::string path = folder.GetPath() / "level.scene.json";
    int compared = 0;
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        scenes::Scene scene = BuildSmall(info);
        scene.bodies.resize(static_cast<std::size_t>(scene.InitialBodyCount()));
        scene.spawns.clear();
        SceneWorld world(scene);
        ASSERT_TRUE(scree_capture::WriteScene(world.GetWorld(), path)) << info.name;
        scenes::Scene read = ReadSceneFile(path);
        EXPECT_EQ(read.bodies.size(), scene.bodies.size()) << info.name;
        EXPECT_TRUE(read.joints.size() == scene.joints.size()) << info.name;
        if (!isExact(scene)) continue;
        read.timeStep = scene.timeStep;
        read.velocityIterations = scene.velocityIterations;
        read.positionIterations = scene.positionIterations;
        SceneWorld again(read);
        for (int step = 1; step <= 100; ++step) {
            world.Step();
            again.Step();
            ASSERT_TRUE(world.GetBits() == again.GetBits()) << info.name << " step " << step;
        }
        ++compared;
    }
    EXPECT_GT(compared, 35);
}

/// A small world in which a program destroys, makes and changes objects between steps, recorded with everything on.
std::string RecordBusyWorld(const std::string& path, scree_capture::Options options, int steps,
                            std::vector<std::map<std::uintptr_t, BodyBits>>& history) {
    scree::World world(scree::Vec2{0.0f, -10.0f});
    std::mt19937 random(5);
    std::vector<scree::Body*> bodies;
    std::uintptr_t next = 1;
    const auto make = [&] {
        scree::BodyDef def;
        def.type = scree::dynamicBody;
        def.userData.pointer = next++;
        def.position = {static_cast<float>(random() % 20), 2.0f + static_cast<float>(random() % 8)};
        scree::Body* body = world.CreateBody(&def);
        scree::PolygonShape box;
        box.SetAsBox(0.3f + 0.1f * static_cast<float>(random() % 3), 0.4f);
        body->CreateFixture(&box, 1.0f);
        bodies.push_back(body);
    };
    const scree::BodyDef groundDef;
    scree::EdgeShape edge;
    edge.SetTwoSided({-50.0f, 0.0f}, {50.0f, 0.0f});
    world.CreateBody(&groundDef)->CreateFixture(&edge, 0.0f);
    for (int i = 0; i < 12; ++i) make();
    const auto note = [&] {
        std::map<std::uintptr_t, BodyBits>& noted = history.emplace_back();
        for (const scree::Body* body : bodies) noted[body->GetUserData().pointer] = BitsOf(*body, false);
    };
    note();
    options.velocityIterations = 6;
    scree_capture::Track track(world, path, options);
    track.Name(bodies[3], "player");
    for (int step = 1; step <= steps; ++step) {
        const std::size_t one = random() % bodies.size();
        switch (random() % 6) {
            case 0:
                // The new body takes the place of the old one in memory.
                world.DestroyBody(bodies[one]);
                bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(one));
                make();
                break;
            case 1:
                make();
                break;
            case 2: {
                scree::CircleShape circle;
                circle.m_radius = 0.2f;
                circle.m_p = {0.0f, 0.5f};
                bodies[one]->CreateFixture(&circle, 0.5f);
                break;
            }
            case 3: {
                scree::RevoluteJointDef def;
                def.Initialize(bodies[one], bodies[(one + 1) % bodies.size()], bodies[one]->GetPosition());
                world.CreateJoint(&def);
                break;
            }
            case 4:
                if (world.GetJointList() != nullptr) world.DestroyJoint(world.GetJointList());
                break;
            default:
                bodies[one]->SetLinearVelocity({0.0f, 6.0f});
        }
        while (bodies.size() > 15) {
            world.DestroyBody(bodies.front());
            bodies.erase(bodies.begin());
        }
        if (step == 7) track.Mark("the seventh");
        world.Step(1.0f / 60.0f, 6, 2);
        track.Step(1.0f / 60.0f);
        note();
    }
    if (options.keepLast > 0.0) {
        EXPECT_TRUE(track.Save());
    }
    track.Close();
    EXPECT_EQ(track.GetError(), "");
    return ReadBytes(path);
}

/// Bodies carry their own number as user data, which tells them apart in a scene.
std::map<std::uintptr_t, BodyBits> BitsOfScene(const scenes::Scene& scene) {
    std::map<std::uintptr_t, BodyBits> bits;
    const auto user = nlohmann::json::parse(scene.user);
    for (int i = 0; i < scene.InitialBodyCount(); ++i) {
        const scenes::Body& body = scene.bodies[static_cast<std::size_t>(i)];
        const std::string key = std::to_string(i);
        if (body.type == scenes::BodyType::isStatic) continue;
        bits[user.at("bodies").at(key).at("userData").get<std::uintptr_t>()] =
            BitsOf(TrackState{true, body.awake, body.position, body.angle, body.linearVelocity, body.angularVelocity});
    }
    return bits;
}

TEST(ScreeCapture, ObjectsThatComeAndGoAreThereWhenTheyWere) {
    const ScratchFolder folder;
    std::vector<std::map<std::uintptr_t, BodyBits>> history;
    scree_capture::Options options;
    options.contacts = options.tree = options.stages = true;
    const std::string bytes = RecordBusyWorld(folder.GetPath() / "busy.track", options, 400, history);
    TrackFile track(bytes, "busy.track");
    EXPECT_EQ(track.GetLastStep(), 400);
    EXPECT_TRUE(track.GetInfo().hasContacts);
    EXPECT_TRUE(track.GetInfo().hasNodes);
    EXPECT_EQ(track.GetBodies()[4].name, "player");
    EXPECT_EQ(track.Read(7).marks, std::vector<std::string>{"the seventh"});
    EXPECT_EQ(track.Read(8).stages.front().first, "step");
    int points = 0, joints = 0;
    for (int step = 0; step <= 400; ++step) {
        const scenes::Scene scene = track.SceneAt(step);
        ASSERT_TRUE(BitsOfScene(scene) == history[static_cast<std::size_t>(step)]) << step;
        EXPECT_EQ(scene.velocityIterations, 6);
        joints += static_cast<int>(scene.joints.size());
        const TrackStep& read = track.Read(step);
        for (const TrackContact& contact : read.contacts) points += contact.pointCount;
        if (step > 0) {
            // One leaf a fixture.
            const auto leaves =
                std::ranges::count_if(read.nodes, [](const TrackNode& node) { return node.child1 < 0; });
            EXPECT_EQ(
                leaves, std::ssize(scene.fixtures) -
                            [&] {
                                std::ptrdiff_t later = 0;
                                for (const scenes::Spawn& spawn : scene.spawns)
                                    later += scene.bodies[static_cast<std::size_t>(spawn.body)].fixtureCount;
                                return later;
                            }())
                << step;
        }
    }
    EXPECT_GT(points, 1000);
    EXPECT_GT(joints, 100);
}

TEST(ScreeCapture, AFlightRecorderKeepsTheLastSeconds) {
    const ScratchFolder folder;
    std::vector<std::map<std::uintptr_t, BodyBits>> history;
    scree_capture::Options options;
    options.keepLast = 3.0;
    const std::string bytes = RecordBusyWorld(folder.GetPath() / "last.track", options, 1000, history);
    TrackFile track(bytes, "last.track");
    EXPECT_EQ(track.GetLastStep(), 1000);
    EXPECT_GT(track.GetSteps().front(), 1000 - 180 - 2 * 120);
    EXPECT_LE(track.GetSteps().front(), 1000 - 180 + 1);
    for (const int step : track.GetSteps()) {
        ASSERT_TRUE(BitsOfScene(track.SceneAt(step)) == history[static_cast<std::size_t>(step)]) << step;
    }
    EXPECT_THROW((void)track.Read(500), UsageError);
}

}  // namespace
}  // namespace testbed
