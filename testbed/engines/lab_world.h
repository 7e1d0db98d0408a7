// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The laboratory over the names of one engine. E gives its types and what is spelled differently: making a world, a
// fixture and a joint, and one step. All readings are the same code for both engines.

#pragma once

#include <stdexcept>
#include <type_traits>
#include <vector>

#include "scenes/build.h"
#include "testbed/base/stopwatch.h"
#include "testbed/engines/lab.h"
#include "testbed/engines/state_hash.h"

namespace testbed {

template <class E>
class LabWorldOf final : public LabWorld {
public:
    using Body = typename E::Body;

    LabWorldOf(const scenes::Scene& scene, const RunSpec& spec, const LabNeeds& needs)
        : LabWorld(scene), m_spec(Checked(Resolve(spec, scene))), m_world(E::MakeWorld(m_spec)) {
        if (!scene.spawns.empty()) throw std::invalid_argument("a laboratory has no spawns");
        for (size_t i = 0; i < scene.bodies.size(); ++i) m_bodies.push_back(MakeBody(static_cast<int>(i), needs));
        for (const scenes::Joint& joint : scene.joints) {
            m_joints.push_back(E::MakeJoint(*m_world, joint, m_bodies, m_joints));
        }
    }

    StepFacts Step() override { return Step(*m_spec.timeStep); }
    StepFacts Step(double dt) override {
        m_lastInverseDt = dt > 0.0 ? 1.0 / dt : 0.0;
        const Stopwatch watch;
        StepFacts facts = E::Step(*m_world, m_spec, static_cast<float>(dt));
        facts.milliseconds = watch.GetMilliseconds();
        facts.contacts = static_cast<int>(m_world->GetContactCount());
        return facts;
    }

    [[nodiscard]] BodyReading Read(int body) const override {
        const Body& b = *At(body);
        const auto& q = b.GetTransform().q;
        BodyReading reading;
        reading.origin = E::GetOrigin(b);
        reading.centre = E::GetCentre(b);
        reading.cos = double{q.c};
        reading.sin = double{q.s};
        // A float angle of hundreds of radians is coarse; the rotation is not.
        const double part = std::atan2(reading.sin, reading.cos), turn = 2.0 * scenes::pi;
        reading.angle = part + turn * std::round((double{b.GetAngle()} - part) / turn);
        reading.velocity = ToPoint(b.GetLinearVelocity());
        reading.spin = double{b.GetAngularVelocity()};
        reading.mass = double{b.GetMass()};
        const Point local = ToPoint(b.GetLocalCenter());
        reading.inertia = double{b.GetInertia()} - reading.mass * Dot(local, local);
        reading.awake = b.IsAwake();
        return reading;
    }
    [[nodiscard]] int GetBodyCount() const override { return static_cast<int>(m_bodies.size()); }
    void SetVelocity(int body, Point velocity, double spin) override {
        At(body)->SetLinearVelocity(E::ToVec(velocity));
        At(body)->SetAngularVelocity(static_cast<float>(spin));
    }
    void SetDamping(int body, double linear, double angular) override {
        At(body)->SetLinearDamping(static_cast<float>(linear));
        At(body)->SetAngularDamping(static_cast<float>(angular));
    }
    void SetGravity(Point gravity) override { m_world->SetGravity(E::ToVec(gravity)); }
    void ApplyForce(int body, Point force) override { At(body)->ApplyForceToCenter(E::ToVec(force), true); }
    void DestroyBody(int body) override {
        m_world->DestroyBody(At(body));
        m_bodies[static_cast<size_t>(body)] = nullptr;
    }

    void SetPose(int body, Point origin, double angle) override {
        At(body)->SetTransform(E::ToVec(origin), static_cast<float>(angle));
    }
    void RemakeBody(int body) override {
        m_world->DestroyBody(At(body));
        m_bodies[static_cast<size_t>(body)] = MakeBody(body, {});
    }
    [[nodiscard]] double CastRay(Point from, Point to) const override {
        return E::CastRay(*m_world, E::ToVec(from), E::ToVec(to));
    }
    [[nodiscard]] int CountInBox(Point low, Point high) const override {
        return E::CountInBox(*m_world, E::ToVec(low), E::ToVec(high));
    }
    void Listen() override { m_world->SetContactListener(&m_counter); }
    [[nodiscard]] long GetHeard() const override { return m_counter.heard; }

    [[nodiscard]] Point GetJointForce(int joint) const override {
        return ToPoint(m_joints[static_cast<size_t>(joint)]->GetReactionForce(static_cast<float>(m_lastInverseDt)));
    }

    void GetContacts(std::vector<ContactReading>& contacts) const override {
        contacts.clear();
        for (auto* c = m_world->GetContactList(); c; c = c->GetNext()) {
            if (!c->IsTouching()) continue;
            const auto manifold = ValueOf(c->GetManifold());
            ContactReading reading;
            reading.bodyA = static_cast<int>(c->GetFixtureA()->GetBody()->GetUserData().pointer);
            reading.bodyB = static_cast<int>(c->GetFixtureB()->GetBody()->GetUserData().pointer);
            reading.pointCount = manifold.pointCount;
            typename E::WorldManifold world;
            c->GetWorldManifold(&world);
            reading.normal = ToPoint(world.normal);
            const double skins = IsSequential(m_spec) ? 0.0 : E::GetSkins(*c, m_spec);
            for (int k = 0; k < manifold.pointCount; ++k) {
                reading.separations[k] = double{world.separations[k]} + skins;
                reading.impulses[k] = E::GetStepImpulse(*c, k);
            }
            contacts.push_back(reading);
        }
    }

    [[nodiscard]] std::uint64_t GetStateHash() const override {
        std::vector<BodyState> states;
        for (size_t i = 0; i < m_bodies.size(); ++i) {
            if (!m_bodies[i]) continue;
            states.push_back(E::Capture(*m_bodies[i], static_cast<int>(i)));
        }
        return HashState(states);
    }

private:
    /// One engine gives manifolds by value, the other a pointer.
    template <typename Manifold>
    static auto ValueOf(const Manifold& manifold) {
        if constexpr (std::is_pointer_v<Manifold>) {
            return *manifold;
        } else {
            return manifold;
        }
    }

    static RunSpec Checked(RunSpec spec) {
        if (const std::string problem = FindProblem(spec); !problem.empty()) throw std::invalid_argument(problem);
        return spec;
    }
    template <class Vec>
    static Point ToPoint(const Vec& v) {
        return {double{v.x}, double{v.y}};
    }
    [[nodiscard]] Body* At(int body) const {
        Body* found = m_bodies.at(static_cast<size_t>(body));
        if (!found) throw std::invalid_argument("the body was destroyed");
        return found;
    }

    struct Counter final : E::ContactListener {
        void BeginContact(typename E::Contact*) override { ++heard; }
        void EndContact(typename E::Contact*) override { ++heard; }
        long heard = 0;
    };

    Body* MakeBody(int index, const LabNeeds& needs) {
        const scenes::Body& body = GetScene().bodies[static_cast<size_t>(index)];
        auto def = E::MakeBodyDef(body, needs.place + ToPoint(body.position));
        def.userData.pointer = static_cast<size_t>(index);
        Body* made = m_world->CreateBody(&def);
        for (int i = body.firstFixture; i < body.firstFixture + body.fixtureCount; ++i) {
            E::AddFixture(*made, GetScene(), i, static_cast<float>(needs.restitutionThreshold));
        }
        // A scene gives the velocity of the centre of mass, a definition that of the origin; they differ in a spin.
        if (body.angularVelocity != 0.0f)
            made->SetLinearVelocity(E::ToVec({body.linearVelocity.x, body.linearVelocity.y}));
        return made;
    }

    RunSpec m_spec;
    Counter m_counter;
    std::unique_ptr<typename E::World> m_world;
    std::vector<Body*> m_bodies;
    std::vector<typename E::Joint*> m_joints;
    double m_lastInverseDt = 0.0;
};

/// What both engines' definitions call by the same names.
template <class Def>
void FillBodyDef(Def& def, const scenes::Body& body) {
    def.bullet = body.bullet;
    def.allowSleep = body.allowSleep;
    def.awake = body.awake;
    def.fixedRotation = body.fixedRotation;
    def.angle = body.angle;
    def.angularVelocity = body.angularVelocity;
    def.linearDamping = body.linearDamping;
    def.angularDamping = body.angularDamping;
    def.gravityScale = body.gravityScale;
}

template <class Def>
void FillMaterial(Def& def, const scenes::Fixture& fixture, float restitutionThreshold) {
    def.density = fixture.density;
    def.friction = fixture.friction;
    def.restitution = fixture.restitution;
    def.restitutionThreshold = restitutionThreshold;
    def.isSensor = fixture.isSensor;
    def.filter.categoryBits = fixture.categoryBits;
    def.filter.maskBits = fixture.maskBits;
    def.filter.groupIndex = fixture.groupIndex;
}

}  // namespace testbed
