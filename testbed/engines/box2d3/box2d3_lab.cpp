// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The laboratory over Box2D 3. Box2D 3 names everything differently from what lab_world.h reads, so it has code of its
// own; the same is measured.

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "testbed/base/stopwatch.h"
#include "testbed/engines/box2d3/box2d3_engine.h"
#include "testbed/engines/box2d3/box2d3_world.h"
#include "testbed/engines/state_hash.h"

namespace testbed {
namespace box2d3 {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

template <typename Vec>
Point ToPoint(const Vec& v) {
    return {double{v.x}, double{v.y}};
}
b2Vec2 ToVec(Point p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

RunSpec Check(RunSpec spec) {
    if (const std::string problem = FindProblem(spec); !problem.empty()) throw std::invalid_argument(problem);
    return spec;
}

class Lab final : public LabWorld {
public:
    Lab(const scenes::Scene& scene, const RunSpec& spec, const LabNeeds& needs)
        : LabWorld(scene),
          m_spec(Check(Resolve(spec, scene))),
          m_world(m_spec, static_cast<float>(needs.restitutionThreshold)) {
        if (!scene.spawns.empty()) throw std::invalid_argument("a laboratory has no spawns");
        for (const scenes::Body& body : scene.bodies) {
            m_world.AddBody(scene, body, needs.place.x, needs.place.y);
            m_angles.push_back(double{body.angle});
        }
        for (const scenes::Joint& joint : scene.joints) m_world.AddJoint(joint);
    }

    StepFacts Step() override { return Step(*m_spec.timeStep); }
    StepFacts Step(double dt) override {
        const Stopwatch watch;
        b2World_Step(m_world.Get(), static_cast<float>(dt), std::get<SoftStep>(m_spec.solver).substeps);
        if (m_listens) {
            const b2ContactEvents events = b2World_GetContactEvents(m_world.Get());
            m_heard += events.beginCount + events.endCount;
        }
        StepFacts facts;
        facts.milliseconds = watch.GetMilliseconds();
        facts.contacts = b2World_GetCounters(m_world.Get()).contactCount;
        FollowTurns(dt);
        return facts;
    }

    [[nodiscard]] BodyReading Read(int body) const override {
        const b2BodyId id = At(body);
        const b2WorldTransform pose = b2Body_GetTransform(id);
        BodyReading reading;
        reading.origin = ToPoint(pose.p);
        reading.centre = ToPoint(b2Body_GetWorldCenter(id));
        reading.cos = double{pose.q.c};
        reading.sin = double{pose.q.s};
        reading.angle = m_angles[static_cast<size_t>(body)];
        reading.velocity = ToPoint(b2Body_GetLinearVelocity(id));
        reading.spin = double{b2Body_GetAngularVelocity(id)};
        reading.mass = double{b2Body_GetMass(id)};
        reading.inertia = double{b2Body_GetRotationalInertia(id)};
        reading.awake = b2Body_IsAwake(id);
        return reading;
    }
    [[nodiscard]] int GetBodyCount() const override { return static_cast<int>(m_world.GetBodies().size()); }
    void SetVelocity(int body, Point velocity, double spin) override {
        b2Body_SetLinearVelocity(At(body), ToVec(velocity));
        b2Body_SetAngularVelocity(At(body), static_cast<float>(spin));
    }
    void SetDamping(int body, double linear, double angular) override {
        b2Body_SetLinearDamping(At(body), static_cast<float>(linear));
        b2Body_SetAngularDamping(At(body), static_cast<float>(angular));
    }
    void SetGravity(Point gravity) override { b2World_SetGravity(m_world.Get(), ToVec(gravity)); }
    void ApplyForce(int body, Point force) override { b2Body_ApplyForceToCenter(At(body), ToVec(force), true); }
    void DestroyBody(int body) override {
        (void)At(body);
        m_world.DestroyBody(body);
    }

    void SetPose(int body, Point origin, double angle) override {
        b2Body_SetTransform(At(body), b2ToPos(ToVec(origin)), b2MakeRot(static_cast<float>(angle)));
    }
    void RemakeBody(int body) override {
        (void)At(body);
        m_world.RemakeBody(GetScene(), body);
    }
    [[nodiscard]] double CastRay(Point from, Point to) const override {
        const b2RayResult result =
            b2World_CastRayClosest(m_world.Get(), b2ToPos(ToVec(from)), ToVec(to - from), b2DefaultQueryFilter());
        return result.hit ? double{result.fraction} : 1.0;
    }
    [[nodiscard]] int CountInBox(Point low, Point high) const override {
        int number = 0;
        const b2AABB box{ToVec(low), ToVec(high)};
        const auto count = [](b2ShapeId, void* context) { return ++*static_cast<int*>(context) > 0; };
        b2World_OverlapAABB(m_world.Get(), b2ToPos({0.0f, 0.0f}), box, b2DefaultQueryFilter(), count, &number);
        return number;
    }
    void Listen() override { m_listens = true; }
    [[nodiscard]] long GetHeard() const override { return m_heard; }

    [[nodiscard]] Point GetJointForce(int joint) const override {
        return ToPoint(b2Joint_GetConstraintForce(m_world.GetJoints()[static_cast<size_t>(joint)]));
    }
    void GetContacts(std::vector<ContactReading>& contacts) const override {
        contacts.clear();
        m_world.ForEachContact([&](const b2ContactData& contact) {
            ContactReading reading;
            reading.bodyA = World::IndexOf(b2Shape_GetBody(contact.shapeIdA));
            reading.bodyB = World::IndexOf(b2Shape_GetBody(contact.shapeIdB));
            reading.pointCount = contact.manifold.pointCount;
            reading.normal = ToPoint(contact.manifold.normal);
            for (int k = 0; k < reading.pointCount; ++k) {
                reading.separations[k] = double{contact.manifold.points[k].separation};
                reading.impulses[k] = double{contact.manifold.points[k].totalNormalImpulse};
            }
            contacts.push_back(reading);
        });
    }
    [[nodiscard]] std::uint64_t GetStateHash() const override {
        std::vector<BodyState> states;
        for (int i = 0; i < GetBodyCount(); ++i) {
            if (b2Body_IsValid(m_world.GetBody(i))) states.push_back(CaptureBody(m_world, GetScene(), i));
        }
        return HashState(states);
    }

private:
    [[nodiscard]] b2BodyId At(int body) const {
        const b2BodyId id = m_world.GetBodies()[static_cast<size_t>(body)];
        if (!b2Body_IsValid(id)) throw std::invalid_argument("the body was destroyed");
        return id;
    }

    /// Box2D 3 keeps rotations, not turns: the spin tells how many whole ones a step added.
    void FollowTurns(double dt) {
        for (size_t i = 0; i < m_angles.size(); ++i) {
            const b2BodyId id = m_world.GetBodies()[i];
            if (!b2Body_IsValid(id)) continue;
            const b2Rot q = b2Body_GetRotation(id);
            const double expected = m_angles[i] + double{b2Body_GetAngularVelocity(id)} * dt;
            const double part = std::atan2(double{q.s}, double{q.c});
            m_angles[i] = part + turn * std::round((expected - part) / turn);
        }
    }

    RunSpec m_spec;
    World m_world;
    std::vector<double> m_angles;  ///< with whole turns, by body
    bool m_listens = false;
    long m_heard = 0;
};

}  // namespace
}  // namespace box2d3

std::unique_ptr<LabWorld> MakeBox2d3Lab(const scenes::Scene& scene, const RunSpec& spec, const LabNeeds& needs) {
    return std::make_unique<box2d3::Lab>(scene, spec, needs);
}

}  // namespace testbed
