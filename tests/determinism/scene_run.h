// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A scene run by the engine alone, without the testbed's engines, by each of the three kinds of step: what platforms,
// compilers and numbers of workers are compared on.

#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scree/inspect.h"
#include "scree/scree.h"
#include "testbed/engines/scree_joint.h"
#include "testbed/engines/scree_scene.h"
#include "testbed/engines/scree_shape.h"
#include "testbed/engines/state_hash.h"
#include "world/world_state.h"

namespace determinism {

[[noreturn]] inline void Stop(const scree::Error& error, void*) {
    std::printf("REFUSED %s: %s; %s\n", error.function, error.field, error.cure);
    std::exit(2);
}

enum class StepKind { sequential, soft, tolerant };
inline constexpr StepKind stepKinds[] = {StepKind::sequential, StepKind::soft, StepKind::tolerant};
inline constexpr const char* kindNames[] = {"sequential", "soft", "tolerant"};

/// A scene in a world, stepped with the spawns that are due.
class SceneRun {
public:
    SceneRun(const scenes::Scene& scene, const scree::WorldDef& def, StepKind kind)
        : m_scene(scene), m_kind(kind), m_conveyor(scene), m_world(std::make_unique<scree::World>(def)) {
        m_world->GetState().pool->ShareAlways();  // or few steps would tell what several workers do
        Attach();
        while (m_bodyCount < scene.InitialBodyCount()) AddBody();
        std::vector<scree::Joint*> joints;
        for (const scenes::Joint& joint : scene.joints) {
            joints.push_back(testbed::CreateScreeJoint(*m_world, joint, m_bodies, joints));
        }
    }
    /// Goes on with a saved world as `other` would have.
    SceneRun(const SceneRun& other, std::span<const std::byte> image)
        : m_scene(other.m_scene),
          m_kind(other.m_kind),
          m_conveyor(other.m_scene),
          m_world(scree::LoadWorld(image)),
          m_bodyCount(other.m_bodyCount),
          m_step(other.m_step),
          m_spawned(other.m_spawned) {
        if (m_world != nullptr) Attach();
    }

    void Step(int count = 1) {
        for (; count > 0; --count) {
            StepWorld();
            ++m_step;
            for (; m_spawned < m_scene.spawns.size() && m_scene.spawns[m_spawned].afterStep <= m_step; ++m_spawned) {
                AddBody();
            }
        }
    }
    [[nodiscard]] bool IsLoaded() const { return m_world != nullptr; }
    [[nodiscard]] scree::World& GetWorld() { return *m_world; }
    [[nodiscard]] testbed::Conveyor& GetConveyor() { return m_conveyor; }
    [[nodiscard]] uint64_t GetHash() const { return scree::inspect::GetStateHash(*m_world); }
    /// As the golden hashes are.
    [[nodiscard]] uint64_t GetBodyHash() const {
        std::vector<testbed::BodyState> states;
        for (const scree::Body* body : m_bodies) {
            states.push_back({.index = static_cast<int>(states.size()),
                              .type = {},
                              .position = testbed::FromScree(body->GetPosition()),
                              .sin = 0.0f,
                              .cos = 0.0f,
                              .angle = body->GetAngle(),
                              .linearVelocity = testbed::FromScree(body->GetLinearVelocity()),
                              .angularVelocity = body->GetAngularVelocity(),
                              .awake = body->GetType() != scree::staticBody && body->IsAwake(),
                              .bullet = false});
        }
        return testbed::HashState(states);
    }

private:
    void Attach() {
        m_world->SetErrorHandler(Stop, nullptr);
        m_world->SetContactListener(&m_conveyor);
    }
    void AddBody() { m_bodies.push_back(testbed::CreateScreeBody(*m_world, m_scene, m_bodyCount++)); }
    void StepWorld() {
        switch (m_kind) {
            case StepKind::sequential:
                m_world->Step(m_scene.timeStep, m_scene.velocityIterations, m_scene.positionIterations);
                return;
            case StepKind::soft:
                m_world->Step(m_scene.timeStep, 4);
                return;
            case StepKind::tolerant:
                m_world->Step(m_scene.timeStep, scree::Tolerance{});
                return;
        }
    }

    const scenes::Scene& m_scene;
    const StepKind m_kind;
    testbed::Conveyor m_conveyor;
    std::unique_ptr<scree::World> m_world;
    testbed::ScreeBodies m_bodies;
    int m_bodyCount = 0;
    int m_step = 0;
    size_t m_spawned = 0;
};

inline scree::WorldDef MakeDef(const scenes::Scene& scene, int workers = 1) {
    scree::WorldDef def;
    def.gravity = testbed::ToScree(scene.gravity);
    def.workerCount = workers;
    return def;
}

inline std::string NameOf(const char* scene, StepKind kind) {
    return std::string(scene) + " " + kindNames[static_cast<int>(kind)];
}

}  // namespace determinism
