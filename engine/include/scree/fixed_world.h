// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A world whose features are fixed when the program is compiled. Calls that only serve other features do not exist, so
// that using one is a compile error. If only the value of an argument needs another feature, such as a damping, it is
// refused with ErrorCode::missingFeature. `scree requires SCENE --header FILE` writes the set of a scene.

#pragma once

#include "scree/convex_shape.h"
#include "scree/motor_joint.h"
#include "scree/world.h"

namespace scree {

/// A body of a FixedWorld: the calls that take a feature. Everything else through Get().
template <Features set>
class FixedBody {
public:
    FixedBody(Body* body) : m_body(body) {}  // NOLINT: a plain handle will do
    [[nodiscard]] Body* Get() const { return m_body; }
    explicit operator bool() const { return m_body != nullptr; }

    /// The definition's shape is `shape`.
    Fixture* CreateFixture(const CircleShape& shape, const FixtureDef& def) { return Create(shape, def); }
    Fixture* CreateFixture(const PolygonShape& shape, const FixtureDef& def) requires(set.Has(Feature::polygons)) {
        return Create(shape, def);
    }
    Fixture* CreateFixture(const ConvexShape& shape, const FixtureDef& def) requires(set.Has(Feature::polygons)) {
        return Create(shape, def);
    }
    Fixture* CreateFixture(const EdgeShape& shape, const FixtureDef& def) requires(set.Has(Feature::edges)) {
        return Create(shape, def);
    }
    Fixture* CreateFixture(const ChainShape& shape, const FixtureDef& def) requires(set.Has(Feature::edges)) {
        return Create(shape, def);
    }

    ErrorCode ApplyForce(Vec2 force, Vec2 point, bool wake) requires(set.Has(Feature::forces)) {
        return m_body->ApplyForce(force, point, wake);
    }
    ErrorCode ApplyForceToCenter(Vec2 force, bool wake) requires(set.Has(Feature::forces)) {
        return m_body->ApplyForceToCenter(force, wake);
    }
    ErrorCode ApplyTorque(float torque, bool wake) requires(set.Has(Feature::forces) && set.Has(Feature::rotation)) {
        return m_body->ApplyTorque(torque, wake);
    }
    ErrorCode SetLinearDamping(float damping) requires(set.Has(Feature::damping)) {
        return m_body->SetLinearDamping(damping);
    }
    ErrorCode SetAngularDamping(float damping) requires(set.Has(Feature::damping)) {
        return m_body->SetAngularDamping(damping);
    }
    ErrorCode SetGravityScale(float scale) requires(set.Has(Feature::gravityScale)) {
        return m_body->SetGravityScale(scale);
    }
    ErrorCode SetAngularVelocity(float omega) requires(set.Has(Feature::rotation)) {
        return m_body->SetAngularVelocity(omega);
    }
    ErrorCode SetBullet(bool flag) requires(set.Has(Feature::continuousBullet)) { return m_body->SetBullet(flag); }
    ErrorCode SetLinearVelocity(Vec2 v) { return m_body->SetLinearVelocity(v); }
    ErrorCode SetTransform(Vec2 position, float angle, Vec2 positionRest = {0.0f, 0.0f}) {
        return m_body->SetTransform(position, angle, positionRest);
    }
    [[nodiscard]] Vec2 GetPosition() const { return m_body->GetPosition(); }
    [[nodiscard]] float GetAngle() const { return m_body->GetAngle(); }
    [[nodiscard]] Vec2 GetLinearVelocity() const { return m_body->GetLinearVelocity(); }

private:
    Fixture* Create(const Shape& shape, FixtureDef def) {
        def.shape = &shape;
        return m_body->CreateFixture(&def);
    }

    Body* m_body;
};

/// A world that models `set` and nothing else.
template <Features set>
class FixedWorld {
    static_assert(compiledFeatures.Contains(set),
                  "this build of the library was configured without one of the features");

public:
    static constexpr Features features = set;
    using BodyHandle = FixedBody<set>;

    /// Definitions that use nothing outside the set.
    [[nodiscard]] static WorldDef MakeWorldDef() {
        WorldDef def;
        def.allowSleep = set.Has(Feature::sleeping);
        def.continuousPhysics = set.Has(Feature::continuousStatic) || set.Has(Feature::continuousBullet);
        def.featureMode = FeatureMode::fixed;
        def.features = set;
        return def;
    }
    [[nodiscard]] static BodyDef MakeBodyDef() {
        BodyDef def;
        def.fixedRotation = !set.Has(Feature::rotation);
        return def;
    }
    [[nodiscard]] static FixtureDef MakeFixtureDef() {
        FixtureDef def;
        if (!set.Has(Feature::friction)) def.friction = 0.0f;
        return def;
    }

    /// The definition's features are replaced by the set.
    explicit FixedWorld(const WorldDef& def = MakeWorldDef()) : m_world(WithSet(def)) {}

    [[nodiscard]] BodyHandle CreateBody(const BodyDef& def) { return m_world.CreateBody(&def); }
    ErrorCode DestroyBody(BodyHandle body) { return m_world.DestroyBody(body.Get()); }
    template <typename Definition>
    auto* CreateJoint(const Definition& def) requires(set.Has(Feature::joints) &&
                                                      (set.Has(Feature::motors) ||
                                                       !std::is_same_v<Definition, MotorJointDef>)) {
        return m_world.CreateJoint(&def);
    }
    ErrorCode SetContactListener(ContactListener* listener) requires(set.Has(Feature::events)) {
        return m_world.SetContactListener(listener);
    }
    ErrorCode SetContactFilter(ContactFilter* filter) requires(set.Has(Feature::filters)) {
        return m_world.SetContactFilter(filter);
    }
    ErrorCode SetWorkers(int workerCount, const TaskCallbacks& tasks = {}) requires(set.Has(Feature::multiThreading)) {
        return m_world.SetWorkers(workerCount, tasks);
    }
    StepReport Step(float timeStep, int velocityIterations, int positionIterations) {
        return m_world.Step(timeStep, velocityIterations, positionIterations);
    }
    StepReport Step(float timeStep, int substeps) { return m_world.Step(timeStep, substeps); }

    /// The plain world, for queries, lists and everything that no feature decides; its calls are checked at run time.
    [[nodiscard]] World& Get() { return m_world; }
    [[nodiscard]] const World& Get() const { return m_world; }

private:
    static WorldDef WithSet(WorldDef def) {
        def.featureMode = FeatureMode::fixed;
        def.features = set;
        return def;
    }

    World m_world;
};

}  // namespace scree
