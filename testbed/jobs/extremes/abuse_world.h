// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The bad calls over the names of one engine. E gives its types and tells of refused calls: MakeWorld(errors) connects
// what the engine reports, if it reports at all.

#pragma once

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <vector>

#include "testbed/jobs/extremes/abuse.h"
#include "testbed/jobs/extremes/abuse_joints.h"

namespace testbed {

/// Refused calls as the engine reported them.
struct AbuseErrors {
    int count = 0;
    int named = 0;  ///< with the name of a field
};

template <class E>
class Abuser {
public:
    using World = typename E::World;
    using Body = typename E::Body;

    explicit Abuser(bool soft) : m_soft(soft) {}

    AbuseResult Run(Abuse abuse) {
        MakeGround();
        switch (abuse) {
            case Abuse::nonFiniteBody:
                for (const float bad : badNumbers) AbuseBodies(bad);
                break;
            case Abuse::nonFiniteFixture:
                for (const float bad : badNumbers) AbuseFixtures(bad);
                break;
            case Abuse::nonFiniteStep:
                for (const float bad : badNumbers) AbuseSteps(bad);
                break;
            case Abuse::nonFiniteJoint:
                for (const float bad : badNumbers) AbuseJoints(bad);
                break;
            case Abuse::nonFiniteQuery:
                for (const float bad : badNumbers) AbuseQueries(bad);
                break;
            case Abuse::denormals:
                AbuseAll(std::numeric_limits<float>::denorm_min());
                break;
            case Abuse::huge:
                AbuseAll(std::numeric_limits<float>::max());
                AbuseAll(-std::numeric_limits<float>::max());
                break;
            case Abuse::badPolygons:
                AbusePolygons();
                break;
            case Abuse::badDensity:
                AbuseDensities();
                break;
            case Abuse::churn:
                Churn();
                break;
            case Abuse::destroyTouching:
                DestroyTouching();
                break;
            case Abuse::destroyInCallback:
                DestroyInCallback();
                break;
            case Abuse::handleReuse:
                ReuseHandles();
                break;
            case Abuse::crash:
                std::raise(SIGABRT);
                break;
            case Abuse::chatter:
                std::puts("an engine says something");
                break;
            case Abuse::hang:
                for (volatile bool forever = true; forever;) {
                }
        }
        Settle();
        return m_result;
    }

private:
    static constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    static constexpr float infinity = std::numeric_limits<float>::infinity();
    static constexpr float badNumbers[] = {nan, infinity, -infinity};

    void Advance(float dt) { E::Step(*m_world, dt, m_soft, m_soft ? 4 : 8); }

    void MakeGround() {
        typename E::BodyDef def;
        m_ground = m_world->CreateBody(&def);
        typename E::Edge edge;
        edge.SetTwoSided({-50.0f, 0.0f}, {50.0f, 0.0f});
        m_ground->CreateFixture(&edge, 0.0f);
        m_box = AddBox(0.0f, 3.0f);
    }

    Body* AddBox(float x, float y) {
        typename E::BodyDef def;
        def.type = E::isDynamic;
        def.position = {x, y};
        Body* body = m_world->CreateBody(&def);
        typename E::Polygon box;
        box.SetAsBox(0.5f, 0.5f);
        body->CreateFixture(&box, 1.0f);
        return body;
    }

    /// Everything a caller could see of the world.
    [[nodiscard]] std::vector<float> Look() {
        std::vector<float> seen;
        for (Body* b = m_world->GetBodyList(); b; b = b->GetNext()) {
            for (const float value : {b->GetPosition().x, b->GetPosition().y, b->GetAngle(), b->GetLinearVelocity().x,
                                      b->GetLinearVelocity().y, b->GetAngularVelocity(), b->GetMass(), b->GetInertia(),
                                      b->GetLinearDamping(), b->GetAngularDamping(), b->GetGravityScale()}) {
                seen.push_back(value);
            }
            for (auto* f = b->GetFixtureList(); f; f = f->GetNext()) {
                seen.insert(seen.end(), {f->GetFriction(), f->GetRestitution(), f->GetDensity()});
            }
        }
        seen.insert(seen.end(), {m_world->GetGravity().x, m_world->GetGravity().y});
        return seen;
    }

    /// One bad call: it is refused if the engine says so.
    template <class Call>
    void Bad(const char* what, Call&& call) {
        const std::vector<float> before = Look();
        const AbuseErrors errors = *m_errors;
        call();
        ++m_result.calls;
        const bool refused = m_errors->count > errors.count;
        m_result.refused += refused;
        m_result.named += m_errors->named > errors.named;
        if (refused && Look() != before) m_result.changed = true;
        if (!refused && m_badIsFatal && m_result.note.find(what) == std::string::npos) {
            m_result.note += (m_result.note.empty() ? "accepted: " : ", ") + std::string(what);
        }
    }

    template <class Set>
    void BadBody(const char* what, Set&& set) {
        Bad(what, [&] {
            typename E::BodyDef def;
            def.type = E::isDynamic;
            set(def);
            Body* body = m_world->CreateBody(&def);
            if (!body) return;
            typename E::Circle circle;
            circle.m_radius = 0.5f;
            body->CreateFixture(&circle, 1.0f);
        });
    }

    void AbuseBodies(float x) {
        using Def = typename E::BodyDef;
        BadBody("position", [x](Def& d) { d.position = {x, 0.0f}; });
        BadBody("position", [x](Def& d) { d.position = {0.0f, x}; });
        BadBody("angle", [x](Def& d) { d.angle = x; });
        BadBody("linearVelocity", [x](Def& d) { d.linearVelocity = {x, 0.0f}; });
        BadBody("linearVelocity", [x](Def& d) { d.linearVelocity = {0.0f, x}; });
        BadBody("angularVelocity", [x](Def& d) { d.angularVelocity = x; });
        BadBody("linearDamping", [x](Def& d) { d.linearDamping = x; });
        BadBody("angularDamping", [x](Def& d) { d.angularDamping = x; });
        BadBody("gravityScale", [x](Def& d) { d.gravityScale = x; });
        Bad("SetTransform", [&] { m_box->SetTransform({x, 1.0f}, 0.0f); });
        Bad("SetTransform angle", [&] { m_box->SetTransform({0.0f, 3.0f}, x); });
        Bad("SetLinearVelocity", [&] { m_box->SetLinearVelocity({x, 0.0f}); });
        Bad("SetAngularVelocity", [&] { m_box->SetAngularVelocity(x); });
        Bad("ApplyForce", [&] { m_box->ApplyForce({x, 0.0f}, {0.0f, 0.0f}, true); });
        Bad("ApplyForceToCenter", [&] { m_box->ApplyForceToCenter({x, 0.0f}, true); });
        Bad("ApplyTorque", [&] { m_box->ApplyTorque(x, true); });
        Bad("ApplyLinearImpulse", [&] { m_box->ApplyLinearImpulse({x, 0.0f}, {0.0f, 0.0f}, true); });
        Bad("ApplyAngularImpulse", [&] { m_box->ApplyAngularImpulse(x, true); });
        Bad("SetLinearDamping", [&] { m_box->SetLinearDamping(x); });
        Bad("SetAngularDamping", [&] { m_box->SetAngularDamping(x); });
        Bad("SetGravityScale", [&] { m_box->SetGravityScale(x); });
    }

    template <class Set>
    void BadFixture(const char* what, Set&& set) {
        Bad(what, [&] {
            typename E::Circle circle;
            circle.m_radius = 0.5f;
            typename E::FixtureDef def;
            def.density = 1.0f;
            set(def, circle);
            def.shape = &circle;
            m_box->CreateFixture(&def);
        });
    }

    void AbuseFixtures(float x) {
        using Def = typename E::FixtureDef;
        using Circle = typename E::Circle;
        BadFixture("density", [x](Def& d, Circle&) { d.density = x; });
        BadFixture("friction", [x](Def& d, Circle&) { d.friction = x; });
        BadFixture("restitution", [x](Def& d, Circle&) { d.restitution = x; });
        BadFixture("restitutionThreshold", [x](Def& d, Circle&) { d.restitutionThreshold = x; });
        BadFixture("radius", [x](Def&, Circle& c) { c.m_radius = x; });
        BadFixture("centre", [x](Def&, Circle& c) { c.m_p = {x, 0.0f}; });
        Bad("edge", [&] {
            typename E::Edge edge;
            edge.SetTwoSided({x, 0.0f}, {1.0f, 0.0f});
            m_ground->CreateFixture(&edge, 0.0f);
        });
        Bad("SetAsBox", [&] {
            typename E::Polygon box;
            box.SetAsBox(x, 1.0f);
            m_box->CreateFixture(&box, 1.0f);
        });
    }

    void AbuseJoints(float x) {
        Body* a = AddBox(-8.0f, 3.0f);
        Body* b = AddBox(-6.5f, 3.0f);
        typename E::RevoluteDef hinge;
        typename E::PrismaticDef slide;
        hinge.bodyA = slide.bodyA = m_ground;
        hinge.bodyB = a;
        slide.bodyB = b;
        auto* revolute = m_world->CreateJoint(&hinge);
        auto* prismatic = m_world->CreateJoint(&slide);
        SpoilJoints<E>(x, a, b, revolute, prismatic,
                       [this](const char* what, const auto& def) { Bad(what, [&] { m_world->CreateJoint(&def); }); });
    }

    void AbuseQueries(float x) {
        typename E::Reporter reporter;
        typename E::Aabb box;
        box.lowerBound = {-1.0f, -1.0f};
        box.upperBound = {x, 1.0f};
        Bad("QueryAABB", [&] { m_world->QueryAABB(&reporter, box); });
        Bad("RayCast", [&] { m_world->RayCast(&reporter, {x, 0.0f}, {1.0f, 1.0f}); });
        Bad("RayCast", [&] { m_world->RayCast(&reporter, {0.0f, 0.0f}, {1.0f, x}); });
    }

    /// Numbers at the end of the range: legal or not, the world must live on.
    void AbuseAll(float x) {
        m_badIsFatal = false;
        AbuseBodies(x);
        AbuseFixtures(x);
        AbuseJoints(x);
        AbuseQueries(x);
        for (int i = 0; i < 10; ++i) Advance(1.0f / 60.0f);
        AbuseSteps(x);
    }

    void AbuseSteps(float x) {
        Bad("Step", [&] { Advance(x); });
        Bad("SetGravity", [&] { m_world->SetGravity({x, 0.0f}); });
        if (m_badIsFatal) {
            Bad("negative Step", [&] { Advance(-1.0f); });
            Bad("negative iterations", [&] { E::Step(*m_world, 0.01f, m_soft, -8); });
        }
    }

    /// A refused polygon counts; one that is taken must be the one that was given.
    void TryPolygon(const char* what, std::vector<typename E::Vec> points, float area) {
        ++m_result.calls;
        typename E::Polygon polygon;
        const bool made = E::SetPolygon(polygon, points);
        Body* body = AddBox(-20.0f + 2.0f * static_cast<float>(m_result.calls), 20.0f);
        const float before = body->GetMass();
        if (!made || !body->CreateFixture(&polygon, 1.0f)) {
            ++m_result.refused;
            ++m_result.named;
            return;
        }
        const float taken = body->GetMass() - before;
        // The hull's area, give or take merged vertices.
        if (std::abs(taken - area) > 0.05f * std::max(area, 0.01f)) {
            m_result.replaced = true;
            m_result.note += (m_result.note.empty() ? "another shape in place of: " : ", ") + std::string(what);
        }
    }

    void AbusePolygons() {
        TryPolygon("a point", {{0.0f, 0.0f}, {0.0f, 0.0f}, {0.0f, 0.0f}}, 0.0f);
        TryPolygon("a line", {{0.0f, 0.0f}, {1.0f, 0.0f}, {2.0f, 0.0f}}, 0.0f);
        TryPolygon("a sliver", {{0.0f, 0.0f}, {1.0f, 0.0f}, {2.0f, 1e-7f}}, 0.0f);
        TryPolygon("two points", {{0.0f, 0.0f}, {1.0f, 0.0f}}, 0.0f);
        TryPolygon("a clockwise square", {{0.0f, 0.0f}, {0.0f, 1.0f}, {1.0f, 1.0f}, {1.0f, 0.0f}}, 1.0f);
        TryPolygon("a bow tie", {{0.0f, 0.0f}, {1.0f, 1.0f}, {1.0f, 0.0f}, {0.0f, 1.0f}}, 1.0f);
        TryPolygon("a spike", {{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}, {0.5f, 1.0f}, {0.5f, 1000.0f}}, 500.0f);
        TryPolygon("near-duplicates", {{0.0f, 0.0f}, {1e-5f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}}, 1.0f);
        TryPolygon("a dent", {{0.0f, 0.0f}, {1.0f, 0.0f}, {0.5f, 0.5f}, {1.0f, 1.0f}, {0.0f, 1.0f}}, 1.0f);
    }

    void AbuseDensities() {
        BadFixture("negative density", [](auto& d, auto&) { d.density = -1.0f; });
        m_badIsFatal = false;  // zero density is legal
        Body* body = AddBox(5.0f, 5.0f);
        body->DestroyFixture(body->GetFixtureList());
        typename E::Circle circle;
        circle.m_radius = 0.5f;
        body->CreateFixture(&circle, 0.0f);
    }

    void Churn() {
        std::vector<Body*> bodies;
        for (int step = 0; step < 20; ++step) {
            for (Body* body : bodies) m_world->DestroyBody(body);
            bodies.clear();
            for (int i = 0; i < 10000; ++i) {
                bodies.push_back(AddBox(static_cast<float>(i % 100) * 1.1f, 1.0f + static_cast<float>(i / 100) * 1.1f));
            }
            Advance(1.0f / 60.0f);
        }
        for (Body* body : bodies) m_world->DestroyBody(body);
        if (m_world->GetBodyCount() != 2) m_result.note = "bodies left over";
        m_result.changed = m_world->GetBodyCount() != 2;
    }

    void DestroyTouching() {
        std::vector<Body*> bodies;
        for (int i = 0; i < 200; ++i) {
            bodies.push_back(AddBox(static_cast<float>(i % 20) - 10.0f, 0.5f + static_cast<float>(i / 20)));
        }
        for (int i = 0; i < 200; ++i) {
            Advance(1.0f / 60.0f);
            m_world->DestroyBody(bodies[static_cast<size_t>((i * 37) % 200)]);
        }
    }

    /// Tries to destroy a body in every callback; an engine refuses that, or puts it off.
    struct Destroyer final : E::ContactListener {
        void BeginContact(typename E::Contact* contact) override {
            ++calls;
            World* world = contact->GetFixtureA()->GetBody()->GetWorld();
            world->DestroyBody(contact->GetFixtureB()->GetBody());
        }
        int calls = 0;
    };
    void DestroyInCallback() {
        Destroyer destroyer;
        m_world->SetContactListener(&destroyer);
        for (int i = 0; i < 20; ++i) AddBox(static_cast<float>(i) * 0.7f, 1.0f);
        const AbuseErrors before = *m_errors;
        for (int i = 0; i < 120; ++i) Advance(1.0f / 60.0f);
        m_result.calls = destroyer.calls;
        m_result.refused = m_errors->count - before.count;
        m_result.named = m_result.refused;
        if (m_result.refused < m_result.calls) m_result.note = "accepted: DestroyBody inside of a callback";
        m_world->SetContactListener(nullptr);
    }

    void ReuseHandles() {
        auto old = E::GetId(*m_world, *m_box);
        m_world->DestroyBody(m_box);
        for (int i = 0; i < 70000; ++i) {
            Body* body = AddBox(0.0f, 3.0f);
            if (E::IsAlive(*m_world, old)) {
                m_result.changed = true;
                m_result.note = "an old handle found a new body";
            }
            m_world->DestroyBody(body);
        }
        m_box = nullptr;
    }

    /// A second of ordinary life afterwards.
    void Settle() {
        for (int i = 0; i < 60; ++i) Advance(1.0f / 60.0f);
        for (Body* b = m_world->GetBodyList(); b; b = b->GetNext()) {
            Note(std::isfinite(b->GetPosition().x) && std::isfinite(b->GetPosition().y), "position");
            Note(std::isfinite(b->GetAngle()), "angle");
            Note(std::isfinite(b->GetLinearVelocity().x) && std::isfinite(b->GetLinearVelocity().y), "velocity");
            Note(std::isfinite(b->GetAngularVelocity()), "angular velocity");
        }
    }

    void Note(bool finite, const char* what) {
        if (finite || !m_result.finite) return;
        m_result.finite = false;
        m_result.note = std::string(what) + " of a body not finite at the end";
    }

    std::unique_ptr<AbuseErrors> m_errors = std::make_unique<AbuseErrors>();
    std::unique_ptr<World> m_world = E::MakeWorld(*m_errors);
    Body *m_ground = nullptr, *m_box = nullptr;
    bool m_soft;
    bool m_badIsFatal = true;
    AbuseResult m_result;
};

}  // namespace testbed
