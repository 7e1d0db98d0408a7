// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Small random worlds whose features come and go in mid-run: a program that makes, edits and destroys bodies, fixtures,
// joints and contacts between steps and in callbacks.

#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <vector>

#include "scree/inspect.h"
#include "scree/scree.h"
#include "world/world_state.h"

namespace scree::test {

/// Pushes bodies and edits contacts and bodies from callbacks, as the mask allows.
class FuzzMeddler final : public ContactListener {
public:
    FuzzMeddler(const Features& mask, uint32_t seed) : random(seed), m_mask(mask) {}
    void PreSolve(Contact* contact, const Manifold*) override {
        if (Uses(8, Feature::tangentSpeed)) contact->SetTangentSpeed(1.5f);
        if (Uses(8, Feature::friction)) contact->SetFriction(0.7f);
        if (Uses(8, Feature::restitution)) contact->SetRestitution(0.4f);
    }
    void PostSolve(Contact* contact, const ContactImpulse*) override {
        Body* body = contact->GetFixtureB()->GetBody();
        if (Uses(4, Feature::forces)) body->ApplyForceToCenter({20.0f, 30.0f}, true);
        if (Uses(16, Feature::damping)) body->SetLinearDamping(0.8f);
        if (Uses(16, Feature::gravityScale)) body->SetGravityScale(0.5f);
        if (Uses(16, Feature::continuousBullet)) body->SetBullet(true);
        if (Uses(16, Feature::restitution)) contact->SetRestitution(0.9f);
        if (Uses(16, Feature::friction)) contact->SetFriction(0.1f);
    }
    Features used;  ///< by calls from here: nobody may use it any more when the step ends
    std::mt19937 random;

private:
    bool Uses(uint32_t one, Feature feature) {
        const bool uses = random() % one == 0 && m_mask.Has(feature);
        used.Add(feature, uses);
        return uses;
    }
    const Features& m_mask;
};

/// Keeps every fifth pair of fixtures apart.
class FifthPair final : public ContactFilter {
    bool ShouldCollide(Fixture* a, Fixture* b) override { return (a->GetIndex() + b->GetIndex()) % 5 != 0; }
};

/// One random life of a world. Everything follows from the seed and from what the world does, which is the same in all
/// modes or the hashes differ.
class Life {
public:
    Life(uint32_t seed, FeatureMode mode, Features set)
        : m_random(seed),
          m_mask(RandomMask()),
          m_meddler(m_mask, seed + 1),
          m_kind(seed % 2 == 0   ? Kind::sequential
                 : seed % 9 == 4 ? Kind::tolerant
                                 : Kind::soft) {
        WorldDef def;
        def.featureMode = mode;
        def.features = set;
        def.broadPhase = seed % 7 == 0 ? BroadPhaseKind::fatTree : BroadPhaseKind::automatic;
        def.allowSleep = m_mask.Has(Feature::sleeping);
        def.continuousPhysics = m_mask.Has(Feature::continuousStatic) || m_mask.Has(Feature::continuousBullet);
        def.exactDrift = seed % 5 == 0;
        if (m_mask.Has(Feature::speedLimit)) def.maxTranslation = 0.2f, def.maxRotation = 0.3f;
        if (m_mask.Has(Feature::multiThreading) && seed % 8 == 0) def.workerCount = 2;
        m_world = std::make_unique<World>(def);
        m_world->GetState().pool->ShareAlways();
        m_world->SetSubStepping(seed % 6 == 4);
        m_world->SetErrorHandler(
            [](const Error& e, void*) {
                if (e.code == ErrorCode::missingFeature) ADD_FAILURE() << e.function << ": " << e.field;
            },
            nullptr);
        const int count = seed % 50 == 0   ? 150
                          : seed % 10 == 0 ? 40
                                           : 8;  // some with large islands, some with many isolated bodies
        for (int i = 0; i < count; ++i) AddBody();
        Note();
    }

    /// What is not part of the world: the state of the program.
    struct Program {
        std::mt19937 random, meddling;
        Features mask;
        bool isFiltered, hears;
        std::vector<Body*> bodies;
        std::vector<Joint*> joints;
    };
    [[nodiscard]] Program GetProgram() const {
        return {m_random, m_meddler.random, m_mask, m_isFiltered, m_hears, m_bodies, m_joints};
    }
    /// Goes on from there, after the world has gone back to that time.
    void Return(const Program& program) {
        m_random = program.random, m_meddler.random = program.meddling, m_mask = program.mask;
        m_bodies = program.bodies, m_joints = program.joints;
        Hear(program.hears);
        Filter(program.isFiltered);
    }
    /// Lives on in another way.
    void Stray(uint32_t seed) { m_random.seed(seed), m_meddler.random.seed(seed + 1); }
    [[nodiscard]] World& GetWorld() { return *m_world; }

    /// Random edits and a step; the hash after it.
    uint64_t Step() {
        m_step = m_meddler.used = {};
        if (Chance(6)) ChangeMask();
        for (int edits = Pick(4); edits > 0; --edits) Edit(), Note();
        m_kind == Kind::tolerant ? m_world->Step(1.0f / 60.0f, Tolerance{})
        : m_kind == Kind::soft   ? m_world->Step(1.0f / 60.0f, 4)
                                 : m_world->Step(1.0f / 60.0f, 6, 2);
        Note();
        return inspect::GetStateHash(*m_world);
    }

    [[nodiscard]] Features GetUsed() const { return m_used; }
    /// In the last step and the edits before it.
    [[nodiscard]] Features GetUsedInStep() const { return m_step; }
    [[nodiscard]] Features GetRequired() const { return m_world->GetRequiredFeatures(); }
    [[nodiscard]] KernelSet GetKernels() const { return inspect::GetKernels(*m_world); }
    /// The running counts are what an exact count finds.
    void ExpectCountsHold() const {
        const WorldState& s = m_world->GetState();
        FeatureUsers counted{};
        for (const BodyIndex b : s.bodies.slots.Rows()) {
            if (s.bodies.slots.IsAlive(b)) Count(counted, FeaturesOfBody(s.bodies, b));
        }
        for (const FixtureIndex f : s.fixtures.slots.Rows()) {
            if (s.fixtures.slots.IsAlive(f)) Count(counted, FeaturesOfFixture(s.fixtures, s.bodies, f));
        }
        EXPECT_EQ(s.featureCounts.users, counted);
    }

private:
    static void Count(FeatureUsers& users, Features features) {
        for (size_t i = 0; i < users.size(); ++i) users[i] += features.Has(static_cast<Feature>(i)) ? 1 : 0;
    }
    int Pick(int count) { return static_cast<int>(m_random() % static_cast<uint32_t>(count)); }
    bool Chance(int one) { return Pick(one) == 0; }
    float Number(float low, float high) {
        return low + (high - low) * static_cast<float>(m_random() >> 8) * (1.0f / 16777216.0f);
    }
    Features RandomMask() { return Features::FromBits(m_random() & m_random()) | Features::FromBits(OneInThree()); }
    uint32_t OneInThree() { return Chance(3) ? m_random() : 0; }
    [[nodiscard]] bool May(Feature feature) const { return m_mask.Has(feature); }
    bool Wants(Feature feature) { return May(feature) && Chance(2); }
    void Note() { m_step = m_step | GetRequired() | m_meddler.used, m_used = m_used | m_step; }

    void Hear(bool hears) {
        m_hears = hears;
        m_world->SetContactListener(hears ? &m_meddler : nullptr);
    }
    void Filter(bool isFiltered) {
        m_isFiltered = isFiltered;
        m_world->SetContactFilter(isFiltered ? &m_filter : nullptr);
    }
    /// Features that left the mask are mostly taken out of what exists.
    void ChangeMask() {
        m_mask = RandomMask();
        m_world->SetAllowSleeping(May(Feature::sleeping));
        m_world->SetContinuousPhysics(May(Feature::continuousStatic) || May(Feature::continuousBullet));
        Hear(May(Feature::events));
        Filter(Wants(Feature::filters));
        Note();
        if (Chance(4)) return;
        for (Body* body : m_bodies) Neutralise(body);
        for (Contact* c = m_world->GetContactList(); c != nullptr; c = c->GetNext()) {
            if (!May(Feature::friction)) c->SetFriction(0.0f);
            if (!May(Feature::restitution)) c->SetRestitution(0.0f);
            if (!May(Feature::tangentSpeed)) c->SetTangentSpeed(0.0f);
        }
        while (!May(Feature::joints) && m_world->GetJointList() != nullptr) {
            m_world->DestroyJoint(m_world->GetJointList());
        }
        m_joints.clear();
        for (Joint* j = m_world->GetJointList(); j != nullptr; j = j->GetNext()) m_joints.push_back(j);
    }

    void Neutralise(Body* body) {
        if (!May(Feature::damping)) body->SetLinearDamping(0.0f), body->SetAngularDamping(0.0f);
        if (!May(Feature::gravityScale)) body->SetGravityScale(1.0f);
        if (!May(Feature::continuousBullet)) body->SetBullet(false);
        if (!May(Feature::rotation)) body->SetFixedRotation(true);
        if (!May(Feature::motionLocks)) body->SetMotionLocks({.angle = body->IsFixedRotation()});
        if (!May(Feature::kinematicBodies) && body->GetType() == kinematicBody) body->SetType(dynamicBody);
        for (Fixture* f = body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
            if (!May(Feature::friction)) f->SetFriction(0.0f);
            if (!May(Feature::restitution)) f->SetRestitution(0.0f);
            if (!May(Feature::tangentSpeed)) f->SetTangentSpeed(0.0f);
            if (!May(Feature::rollingResistance)) f->SetRollingResistance(0.0f);
            if (!May(Feature::sensors)) f->SetSensor(false);
            if (!May(Feature::filters)) f->SetFilterData({});
        }
    }

    void AddBody() {
        BodyDef def;
        def.type = m_bodies.empty() || Chance(6)                ? staticBody
                   : May(Feature::kinematicBodies) && Chance(6) ? kinematicBody
                                                                : dynamicBody;
        def.position = {Number(-2.5f, 2.5f), def.type == staticBody ? Number(-1.0f, 0.0f) : Number(0.3f, 4.0f)};
        def.angle = May(Feature::rotation) ? Number(-1.0f, 1.0f) : 0.0f;
        def.linearVelocity = {Number(-3.0f, 3.0f), Number(-9.0f, 1.0f)};
        def.angularVelocity = Wants(Feature::rotation) ? Number(-3.0f, 3.0f) : -0.0f;
        def.fixedRotation = !May(Feature::rotation);
        def.allowSleep = !Wants(Feature::sleeping);
        def.bullet = Wants(Feature::continuousBullet);
        def.linearDamping = Wants(Feature::damping) ? Number(0.0f, 2.0f) : 0.0f;
        def.angularDamping = Wants(Feature::damping) ? Number(0.0f, 2.0f) : 0.0f;
        def.gravityScale = Wants(Feature::gravityScale) ? Number(-1.0f, 2.0f) : 1.0f;
        m_bodies.push_back(m_world->CreateBody(&def));
        AddFixture(m_bodies.back());
    }

    void AddFixture(Body* body) {
        CircleShape circle;
        circle.m_radius = Number(0.2f, 0.5f);
        PolygonShape box;
        box.SetAsBox(body->GetType() == staticBody ? 2.0f : Number(0.2f, 0.5f), Number(0.2f, 0.5f));
        EdgeShape edge;
        edge.SetTwoSided({-2.0f, Number(-0.2f, 0.2f)}, {2.0f, 0.0f});
        FixtureDef def;
        def.shape = &circle;
        if (Wants(Feature::polygons)) def.shape = &box;
        if (body->GetType() == staticBody && Wants(Feature::edges)) def.shape = &edge;
        def.density = 1.0f;
        def.friction = May(Feature::friction) ? Number(0.0f, 0.8f) : 0.0f;
        def.restitution = Wants(Feature::restitution) ? Number(0.0f, 0.9f) : 0.0f;
        def.isSensor = May(Feature::sensors) && Chance(5);
        if (Wants(Feature::filters)) def.filter.groupIndex = static_cast<int16_t>(Pick(3) - 1);
        body->CreateFixture(&def);
    }

    void AddJoint() {
        Body* a = Any();
        Body* b = Any();
        if (a == b || (a->GetType() != dynamicBody && b->GetType() != dynamicBody)) return;
        if (Chance(2)) {
            RevoluteJointDef def;
            def.Initialize(a, b, b->GetPosition());
            def.enableMotor = Wants(Feature::motors);
            def.motorSpeed = 2.0f, def.maxMotorTorque = 5.0f;
            def.enableLimit = Wants(Feature::limits);
            def.lowerAngle = -0.3f, def.upperAngle = 0.4f;
            m_joints.push_back(m_world->CreateJoint(&def));
        } else {
            DistanceJointDef def;
            def.Initialize(a, b, a->GetPosition(), b->GetPosition());
            if (Wants(Feature::springs)) def.stiffness = 20.0f, def.damping = 0.5f;
            if (Wants(Feature::limits)) def.minLength = 0.3f, def.maxLength = 3.0f;
            m_joints.push_back(m_world->CreateJoint(&def));
        }
    }

    Body* Any() { return m_bodies[static_cast<size_t>(Pick(static_cast<int>(m_bodies.size())))]; }

    void DestroyAny() {
        if (m_bodies.size() < 4) return;
        const size_t i = 1 + static_cast<size_t>(Pick(static_cast<int>(m_bodies.size()) - 1));
        m_world->DestroyBody(m_bodies[i]);
        m_bodies.erase(m_bodies.begin() + static_cast<std::ptrdiff_t>(i));
        m_joints.clear();
        for (Joint* j = m_world->GetJointList(); j != nullptr; j = j->GetNext()) m_joints.push_back(j);
    }

    void EditFixture(Fixture* fixture) {
        if (fixture == nullptr) return;
        if (May(Feature::friction)) fixture->SetFriction(Chance(2) ? 0.0f : 0.6f, Chance(2));
        if (Wants(Feature::tangentSpeed)) fixture->SetTangentSpeed(Chance(2) ? 0.0f : 1.0f);
        if (Wants(Feature::rollingResistance)) fixture->SetRollingResistance(Chance(2) ? 0.0f : 0.3f);
        if (Wants(Feature::restitution)) fixture->SetRestitution(Chance(2) ? 0.0f : 0.5f);
        if (Wants(Feature::sensors)) fixture->SetSensor(!fixture->IsSensor());
        if (Wants(Feature::filters)) fixture->SetFilterData({1, 0xFFFF, static_cast<int16_t>(Pick(3) - 1)});
    }

    void EditBody(Body* body) {
        switch (Pick(11)) {
            case 0:
                if (May(Feature::damping)) body->SetLinearDamping(Chance(2) ? 0.0f : 1.0f);
                break;
            case 1:
                if (May(Feature::damping)) body->SetAngularDamping(Chance(2) ? 0.0f : 1.0f);
                break;
            case 2:
                if (May(Feature::gravityScale)) body->SetGravityScale(Chance(2) ? 1.0f : -0.5f);
                break;
            case 3:
                if (May(Feature::forces)) body->ApplyForce({5.0f, 40.0f}, body->GetWorldPoint({0.1f, 0.2f}), true);
                break;
            case 4:
                if (May(Feature::forces)) body->ApplyTorque(3.0f, true);
                break;
            case 5:
                if (May(Feature::continuousBullet)) body->SetBullet(!body->IsBullet());
                break;
            case 6:
                if (May(Feature::rotation)) body->SetFixedRotation(!body->IsFixedRotation());
                break;
            case 7:
                if (May(Feature::kinematicBodies) && body != m_bodies.front())
                    body->SetType(Chance(2) ? dynamicBody : kinematicBody);
                break;
            case 8:
                if (May(Feature::sleeping)) body->SetAwake(Chance(2));
                break;
            case 9:
                body->SetTransform(body->GetPosition() + Vec2{Number(-0.2f, 0.2f), 0.0f}, body->GetAngle());
                break;
            default:
                if (Wants(Feature::motionLocks)) body->SetMotionLocks({Chance(2), Chance(2), body->IsFixedRotation()});
                body->SetLinearVelocity({Number(-5.0f, 5.0f), Number(-5.0f, 5.0f)});
        }
    }

    void EditContact(Contact* contact) {
        if (contact == nullptr) return;
        if (Wants(Feature::tangentSpeed)) contact->SetTangentSpeed(Chance(2) ? 0.0f : 2.0f);
        if (Wants(Feature::friction)) contact->SetFriction(Chance(2) ? 0.0f : 0.9f);
        if (Wants(Feature::restitution)) contact->SetRestitution(Chance(2) ? 0.0f : 0.9f);
    }

    void Edit() {
        switch (Pick(9)) {
            case 0:
                return AddBody();
            case 1:
                return DestroyAny();
            case 2:
                return May(Feature::joints) ? AddJoint() : void();
            case 3:
                return EditFixture(Any()->GetFixtureList());
            case 4:
                return EditContact(m_world->GetContactList());
            case 5:
                if (m_joints.empty() || m_joints.back()->GetType() != e_revoluteJoint) return;
                if (May(Feature::motors)) static_cast<RevoluteJoint*>(m_joints.back())->EnableMotor(Chance(2));
                if (May(Feature::limits)) static_cast<RevoluteJoint*>(m_joints.back())->EnableLimit(Chance(2));
                return;
            default:
                EditBody(Any());
        }
    }

    std::mt19937 m_random;
    Features m_mask;
    FuzzMeddler m_meddler;
    FifthPair m_filter;
    enum class Kind { sequential, soft, tolerant } m_kind;
    bool m_isFiltered = false, m_hears = false;
    std::unique_ptr<World> m_world;
    std::vector<Body*> m_bodies;
    std::vector<Joint*> m_joints;
    Features m_used, m_step;
};

}  // namespace scree::test
