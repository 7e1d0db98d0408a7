// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A world of Box2D 3 with what was made in it of a scene, by the scene's indices: what runs and laboratories share.

#pragma once

#include <box2d/box2d.h>

#include <span>
#include <vector>

#include "scenes/scene.h"
#include "testbed/engines/box2d3/box2d3_joint.h"
#include "testbed/engines/box2d3/box2d3_shape.h"
#include "testbed/engines/run_spec.h"
#include "testbed/engines/snapshot.h"

namespace testbed::box2d3 {

/// A child of a fixture.
struct Proxy {
    int body, sceneIndex, child;
    bool isSensor;
    Shape shape;
};

class World {
public:
    /// As a resolved spec says. Speeds in m/s.
    explicit World(const RunSpec& spec, float restitutionThreshold = b2DefaultWorldDef().restitutionThreshold);
    ~World() { b2DestroyWorld(m_id); }
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    /// At `place` from where the scene has it, m. Throws std::invalid_argument for loops of three edges.
    void AddBody(const scenes::Scene& scene, const scenes::Body& body, double placeX = 0.0, double placeY = 0.0);
    void AddJoint(const scenes::Joint& joint) { m_joints.push_back(CreateJoint(m_id, joint, m_bodies)); }

    [[nodiscard]] b2WorldId Get() const { return m_id; }
    [[nodiscard]] std::span<const b2BodyId> GetBodies() const { return m_bodies; }
    [[nodiscard]] b2BodyId GetBody(int index) const { return m_bodies[static_cast<size_t>(index)]; }
    /// By index into Snapshot::fixtures.
    [[nodiscard]] std::span<const Proxy> GetProxies() const { return m_proxies; }
    [[nodiscard]] std::span<const b2JointId> GetJoints() const { return m_joints; }
    /// The body with this index is gone.
    void DestroyBody(int index);
    /// A body without joints goes and comes anew as the scene has it. Its proxies are not listed again.
    void RemakeBody(const scenes::Scene& scene, int index);

    /// Index into the scene's bodies, and into the proxies.
    [[nodiscard]] static int IndexOf(b2BodyId body) { return FromUserData(b2Body_GetUserData(body)); }
    [[nodiscard]] static int IndexOf(b2ShapeId shape) { return FromUserData(b2Shape_GetUserData(shape)); }

    /// Calls visit(contact data) once for each contact that touches, in the order of bodies.
    template <typename Visit>
    void ForEachContact(Visit&& visit) const {
        std::vector<b2ContactData> contacts;
        for (const b2BodyId body : m_bodies) {
            const int capacity = b2Body_IsValid(body) ? b2Body_GetContactCapacity(body) : 0;
            if (capacity == 0) continue;
            contacts.resize(static_cast<size_t>(capacity));
            const int count = b2Body_GetContactData(body, contacts.data(), capacity);
            for (int i = 0; i < count; ++i) {
                const b2ContactData& contact = contacts[static_cast<size_t>(i)];
                // Each contact has two bodies.
                if (B2_ID_EQUALS(b2Shape_GetBody(contact.shapeIdA), body)) visit(contact);
            }
        }
    }

private:
    // Indices + 1 as user data: null means none.
    static void* ToUserData(size_t index) { return reinterpret_cast<void*>(index + 1); }
    static int FromUserData(void* data) { return static_cast<int>(reinterpret_cast<uintptr_t>(data)) - 1; }

    void CreateFixture(const scenes::Scene& scene, b2BodyId body, int sceneIndex);
    void CreateChain(const scenes::Scene& scene, b2BodyId body, const scenes::Fixture& fixture, const b2ShapeDef& def);

    b2WorldId m_id;
    std::vector<b2BodyId> m_bodies;
    std::vector<Proxy> m_proxies;
    std::vector<b2JointId> m_joints;
};

/// State of a body of a scene that is in the world.
[[nodiscard]] BodyState CaptureBody(const World& world, const scenes::Scene& scene, int index);

}  // namespace testbed::box2d3
