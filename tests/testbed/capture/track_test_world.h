// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Scenes as worlds that a test records, and what a track must then say: the same bits of every body after every step.

#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "scenes/build.h"
#include "scenes/catalog.h"
#include "testbed/input/scene_file.h"
#include "testbed/input/track_file.h"
#include "tests/testbed/program.h"

namespace testbed {

/// Pose, velocity and whether it is awake, as bits.
struct BodyBits {
    std::uint32_t bits[6];
    bool awake;

    friend bool operator==(const BodyBits&, const BodyBits&) = default;
};

inline BodyBits BitsOf(const TrackState& state) {
    const float values[6] = {state.position.x,       state.position.y,       state.angle,
                             state.linearVelocity.x, state.linearVelocity.y, state.angularVelocity};
    BodyBits bits{.bits = {}, .awake = state.awake};
    std::transform(std::begin(values), std::end(values), bits.bits,
                   [](float value) { return std::bit_cast<std::uint32_t>(value); });
    return bits;
}

/// Of a body of either engine.
template <typename Body>
BodyBits BitsOf(const Body& body, bool isStatic) {
    const TrackState state{.isThere = true,
                           .awake = !isStatic && body.IsAwake(),
                           .position = {body.GetPosition().x, body.GetPosition().y},
                           .angle = body.GetAngle(),
                           .linearVelocity = {body.GetLinearVelocity().x, body.GetLinearVelocity().y},
                           .angularVelocity = body.GetAngularVelocity()};
    return BitsOf(state);
}

inline std::string ReadBytes(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Bytes of a track without its header: those of steps.
inline double CountStepBytes(const std::filesystem::path& path) {
    const std::string bytes = ReadBytes(path);
    std::uint32_t header = 0;
    std::memcpy(&header, bytes.data() + 8, sizeof header);
    return static_cast<double>(bytes.size()) - 16.0 - header;
}

/// Steps of a body that changed: what the size of a track is measured by.
inline std::int64_t CountMoves(const std::vector<std::vector<BodyBits>>& history) {
    std::int64_t moves = 0;
    for (std::size_t step = 1; step < history.size(); ++step) {
        for (std::size_t i = 0; i < history[step - 1].size(); ++i) moves += history[step][i] != history[step - 1][i];
    }
    return moves;
}

/// A size of a scene that has at most about some hundred bodies, so that all scenes can be run.
inline scenes::Scene BuildSmall(const scenes::SceneInfo& info) {
    for (int size = info.defaultSize; size > info.minSize; size = std::max(size / 2, info.minSize)) {
        scenes::Scene scene = scenes::Build(info.name, size);
        if (scene.bodies.size() <= 200 && scene.fixtures.size() <= 500) return scene;
    }
    return scenes::Build(info.name, info.minSize);
}

/// A scene in an engine, made as the testbed makes it, with nothing else in the world's user data.
template <typename T>
class TestWorld {
public:
    using Body = typename T::Body;

    explicit TestWorld(const scenes::Scene& scene)
        : m_scene(scene), m_world(typename T::Vec{scene.gravity.x, scene.gravity.y}) {
        for (int i = 0; i < scene.InitialBodyCount(); ++i) CreateBody(scene.bodies[static_cast<std::size_t>(i)]);
        for (const scenes::Joint& joint : scene.joints) {
            m_joints.push_back(T::createJoint(m_world, joint, m_bodies, m_joints));
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
        for (const Body* body : m_bodies) bits.push_back(BitsOf(*body, static_cast<int>(body->GetType()) == 0));
        return bits;
    }
    typename T::World& GetWorld() { return m_world; }

private:
    void CreateBody(const scenes::Body& body) {
        typename T::BodyDef def;
        def.type = static_cast<typename T::BodyType>(body.type);
        def.bullet = body.bullet;
        def.allowSleep = body.allowSleep;
        def.awake = body.awake;
        def.fixedRotation = body.fixedRotation;
        def.position = {body.position.x, body.position.y};
        def.angle = body.angle;
        def.linearVelocity = {body.linearVelocity.x, body.linearVelocity.y};
        def.angularVelocity = body.angularVelocity;
        def.linearDamping = body.linearDamping;
        def.angularDamping = body.angularDamping;
        def.gravityScale = body.gravityScale;
        Body* made = m_world.CreateBody(&def);
        m_bodies.push_back(made);
        for (int i = body.firstFixture; i < body.firstFixture + body.fixtureCount; ++i) {
            const scenes::Fixture& fixture = m_scene.fixtures[static_cast<std::size_t>(i)];
            typename T::FixtureDef fixtureDef;
            fixtureDef.density = fixture.density;
            fixtureDef.friction = fixture.friction;
            fixtureDef.restitution = fixture.restitution;
            fixtureDef.isSensor = fixture.isSensor;
            fixtureDef.filter.categoryBits = fixture.categoryBits;
            fixtureDef.filter.maskBits = fixture.maskBits;
            fixtureDef.filter.groupIndex = fixture.groupIndex;
            T::CreateFixture(*made, fixtureDef, m_scene, fixture.shape);
        }
        // The definition has the velocity of the origin, a scene that of the centre of mass.
        if (body.angularVelocity != 0.0f) made->SetLinearVelocity(def.linearVelocity);
    }

    scenes::Scene m_scene;
    typename T::World m_world;
    std::vector<Body*> m_bodies;
    std::vector<typename T::Joint*> m_joints;
    std::size_t m_spawned = 0;
    int m_step = 0;
};

/// Expects that a track says what was noted after each step, forwards and at random.
inline void ExpectSameMotion(TrackFile& track, const std::vector<std::vector<BodyBits>>& history,
                             const std::string& name) {
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

/// Records all scenes and reads them back; returns the bytes that a body's step takes.
template <typename T, typename Track>
double ExpectAllScenesReadBack(const std::string& engine) {
    const ScratchFolder folder;
    const std::string path = folder.GetPath() / "session.track";
    double allBytes = 0.0, allMoves = 0.0;
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        const scenes::Scene scene = BuildSmall(info);
        TestWorld<T> world(scene);
        std::vector<std::vector<BodyBits>> history{world.GetBits()};
        {
            Track track(world.GetWorld(), path);
            for (int step = 1; step <= std::min(scene.steps, 130); ++step) {
                world.Step();
                track.Step(scene.timeStep);
                history.push_back(world.GetBits());
            }
            track.Close();
            EXPECT_EQ(track.GetError(), "");
            EXPECT_EQ(track.GetSkippedSteps(), 0);
        }
        TrackFile track = ReadTrackFile(path);
        ExpectSameMotion(track, history, std::string(info.name));
        EXPECT_EQ(track.GetInfo().engine, engine);
        EXPECT_EQ(track.GetInfo().timeStep, scene.timeStep);
        const double bytes = CountStepBytes(path);
        const auto moves = static_cast<double>(CountMoves(history));
        allBytes += bytes;
        allMoves += moves;
        // Even if no body could be predicted.
        EXPECT_LT(bytes, 26.0 * moves + 60.0 * static_cast<double>(history.size())) << info.name;
    }
    EXPECT_LT(allBytes, 20.0 * allMoves);
    return allBytes / allMoves;
}

/// Writes each scene from an engine, reads it and expects the same motion of both.
template <typename T, typename Write>
void ExpectWrittenScenesAreTheSame(Write&& write) {
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
        TestWorld<T> world(scene);
        ASSERT_TRUE(write(world.GetWorld(), path)) << info.name;
        scenes::Scene read = ReadSceneFile(path);
        EXPECT_EQ(read.bodies.size(), scene.bodies.size()) << info.name;
        EXPECT_EQ(read.joints.size(), scene.joints.size()) << info.name;
        if (!isExact(scene)) continue;
        read.timeStep = scene.timeStep;
        read.velocityIterations = scene.velocityIterations;
        read.positionIterations = scene.positionIterations;
        TestWorld<T> again(read);
        for (int step = 1; step <= 60; ++step) {
            world.Step();
            again.Step();
            ASSERT_TRUE(world.GetBits() == again.GetBits()) << info.name << " step " << step;
        }
        ++compared;
    }
    EXPECT_GT(compared, 35);
}

}  // namespace testbed
