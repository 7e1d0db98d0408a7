// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A scene running in Box2D 2.4.1: loading, stepping, times by stage, capture. Box2D measures `broadphase`
// (synchronising fixtures and finding pairs) inside its `solve`, so the time of the solver is the difference. In a step
// that follows new fixtures it searches their pairs before its first timer: that time is what all measured stages leave
// of `step`. The retest of fattened boxes is inside `collide` and cannot be separated.

#include <box2d/box2d.h>

#include <algorithm>

#include "testbed/base/stopwatch.h"
#include "testbed/capture/scree_capture_box2d.h"
#include "testbed/engines/box2d_joint.h"
#include "testbed/engines/box2d_shape.h"
#include "testbed/engines/capture_box2d.h"
#include "testbed/engines/inspect_objects.h"
#include "testbed/engines/scene_run.h"
#include "testbed/engines/track_output.h"
#include "testbed/engines/world_scene.h"
#include "testbed/input/body_names.h"

namespace testbed {
namespace {

b2BodyType MakeB2Type(scenes::BodyType type) {
    switch (type) {
        case scenes::BodyType::isStatic:
            return b2_staticBody;
        case scenes::BodyType::kinematic:
            return b2_kinematicBody;
        case scenes::BodyType::dynamic:
            return b2_dynamicBody;
    }
    return b2_staticBody;
}

b2BodyDef MakeB2BodyDef(const scenes::Body& body) {
    b2BodyDef def;
    def.type = MakeB2Type(body.type);
    def.bullet = body.bullet;
    def.allowSleep = body.allowSleep;
    def.awake = body.awake;
    def.fixedRotation = body.fixedRotation;
    def.position = ToB2(body.position);
    def.angle = body.angle;
    def.linearVelocity = ToB2(body.linearVelocity);
    def.angularVelocity = body.angularVelocity;
    def.linearDamping = body.linearDamping;
    def.angularDamping = body.angularDamping;
    def.gravityScale = body.gravityScale;
    return def;
}

b2FixtureDef MakeB2FixtureDef(const scenes::Fixture& fixture, const b2Shape& shape, size_t index) {
    b2FixtureDef def;
    def.shape = &shape;
    def.density = fixture.density;
    def.friction = fixture.friction;
    def.restitution = fixture.restitution;
    def.isSensor = fixture.isSensor;
    def.filter.categoryBits = fixture.categoryBits;
    def.filter.maskBits = fixture.maskBits;
    def.filter.groupIndex = fixture.groupIndex;
    def.userData.pointer = index;
    return def;
}

int IndexOf(b2Body* body) { return static_cast<int>(body->GetUserData().pointer); }
/// A fixture's user data is the index into Snapshot::fixtures of its first child; the others follow.
int ProxyOf(b2Fixture* fixture) { return static_cast<int>(fixture->GetUserData().pointer); }

/// Box2D flags static bodies that an island touched as awake, which means nothing.
bool IsSimulated(const b2Body& body) { return body.GetType() != b2_staticBody && body.IsAwake(); }

/// Classes of joints, for inspect_objects.h.
struct Box2dJointTypes {
    using Revolute = b2RevoluteJoint;
    using Distance = b2DistanceJoint;
    using Friction = b2FrictionJoint;
    using Gear = b2GearJoint;
    using Motor = b2MotorJoint;
    using Mouse = b2MouseJoint;
    using Prismatic = b2PrismaticJoint;
    using Pulley = b2PulleyJoint;
    using Weld = b2WeldJoint;
    using Wheel = b2WheelJoint;
};

class Box2dRun final : public SceneRun {
public:
    Box2dRun(const scenes::Scene& scene, const RunSpec& spec, const RunNeeds& needs) : SceneRun(scene, spec, needs) {
        m_bodies.reserve(scene.bodies.size());
        m_proxies.reserve(scene.fixtures.size());
        m_joints.reserve(scene.joints.size());
        Create([&] {
            m_world = std::make_unique<b2World>(ToB2(*GetSpec().gravity));
            m_world->SetContinuousPhysics(GetSpec().continuous);
            m_world->SetAllowSleeping(GetSpec().sleeping);
            m_world->SetWarmStarting(GetSpec().warmStarting);
            if (HasConveyor()) m_world->SetContactListener(&m_conveyor);
            Load();
        });
        NoteAwake();
    }

    void Record(const std::string& path, const TrackContents& contents) override {
        m_track.Begin(*m_world, path, contents, GetSpec(), NamesIn(GetScene()));
    }
    void EndRecord() override { m_track.End(); }

    [[nodiscard]] RunValues ValuesOfBody(int body) const override {
        return testbed::ValuesOfBody(*m_bodies[static_cast<size_t>(body)]);
    }
    [[nodiscard]] RunValues ValuesOfFixture(int fixture) const override {
        return testbed::ValuesOfFixture(*m_proxies[static_cast<size_t>(fixture)].fixture);
    }
    [[nodiscard]] RunValues ValuesOfJoint(int joint) const override {
        const auto index = static_cast<size_t>(joint);
        return testbed::ValuesOfJoint<Box2dJointTypes>(*m_joints[index], GetScene().joints[index].type,
                                                       1.0f / GetTimeStep());
    }
    [[nodiscard]] int GetContactCount() const override { return m_world->GetContactCount(); }
    [[nodiscard]] StepCounts CountStep() override;

protected:
    void CreateBody(const scenes::Body& body) override;
    void CreateJoint(const scenes::Joint& joint) override;
    StepTimes StepEngine(bool newFixtures) override;
    void CaptureWorld(Snapshot& snapshot, const CaptureParts& parts) override;
    void ApplyToWorld(const RunSpec& spec) override;
    void CreateDrag(int body, Vec2 localPoint) override;
    void MoveDragTo(Vec2 target) override { m_drag->SetTarget(ToB2(target)); }
    void DestroyDrag() override;
    void RecordStep() override { m_track.Step(GetTimeStep(), m_bodies); }
    void EditBody(int body, const BodyEdit& edit) override {
        ApplyEdit(*m_bodies[static_cast<size_t>(body)], edit, [](Vec2 v) { return ToB2(v); });
    }
    [[nodiscard]] scenes::Scene DescribeWorld() const override {
        return DescribeAsScene<scree_capture::box2d_engine::Api>(*m_world);
    }

private:
    /// The tangent speed of a contact is that of both surfaces together: it does not depend on which of them is A.
    class Conveyor final : public b2ContactListener {
    public:
        explicit Conveyor(const Box2dRun& run) : m_run(run) {}
        void PreSolve(b2Contact* contact, const b2Manifold*) override {
            contact->SetTangentSpeed(SpeedOf(contact->GetFixtureA()) + SpeedOf(contact->GetFixtureB()));
        }

    private:
        [[nodiscard]] float SpeedOf(b2Fixture* fixture) const {
            const Box2dProxy& proxy = m_run.m_proxies[static_cast<size_t>(ProxyOf(fixture))];
            return m_run.GetScene().fixtures[static_cast<size_t>(proxy.sceneIndex)].tangentSpeed;
        }
        const Box2dRun& m_run;
    };

    void CreateFixture(b2Body& body, int sceneIndex);
    void NoteAwake();

    Conveyor m_conveyor{*this};
    std::unique_ptr<b2World> m_world;
    Box2dBodies m_bodies;               ///< by body index
    std::vector<Box2dProxy> m_proxies;  ///< by index into Snapshot::fixtures
    Box2dJoints m_joints;               ///< by joint index
    std::vector<bool> m_wasAwake;       ///< by body index, after the step that was counted last
    b2Body* m_dragGround = nullptr;     ///< carries the spring that drags
    b2MouseJoint* m_drag = nullptr;
    TrackOutput<scree_capture::box2d_engine::Track, b2World> m_track;  ///< ends before the world
};

void Box2dRun::CreateFixture(b2Body& body, int sceneIndex) {
    const scenes::Fixture& fixture = GetScene().fixtures[static_cast<size_t>(sceneIndex)];
    b2Fixture* made = nullptr;
    if (fixture.shape.type == scenes::ShapeType::chain) {
        b2ChainShape chain;
        MakeBox2dChain(GetScene(), fixture.shape, chain);
        const b2FixtureDef def = MakeB2FixtureDef(fixture, chain, m_proxies.size());
        made = body.CreateFixture(&def);
    } else {
        const Box2dShape shape = MakeBox2dShape(Box2dShapeOf(GetScene(), fixture.shape));
        const b2FixtureDef def = MakeB2FixtureDef(fixture, AsB2Shape(shape), m_proxies.size());
        made = body.CreateFixture(&def);
    }
    for (int child = 0; child < fixture.shape.ChildCount(); ++child) m_proxies.push_back({made, sceneIndex, child});
}

void Box2dRun::CreateBody(const scenes::Body& body) {
    b2BodyDef bodyDef = MakeB2BodyDef(body);
    bodyDef.userData.pointer = m_bodies.size();
    b2Body* made = m_world->CreateBody(&bodyDef);
    m_bodies.push_back(made);
    for (int i = body.firstFixture; i < body.firstFixture + body.fixtureCount; ++i) {
        CreateFixture(*made, i);
    }
    // A scene gives the velocity of the centre of mass, Box2D's definition that of the origin; they differ in a spin.
    if (body.angularVelocity != 0.0f) made->SetLinearVelocity(ToB2(body.linearVelocity));
}

void Box2dRun::CreateJoint(const scenes::Joint& joint) {
    m_joints.push_back(CreateBox2dJoint(*m_world, joint, m_bodies, m_joints));
}

StepTimes Box2dRun::StepEngine(bool newFixtures) {
    const Iterations iterations = *std::get<SequentialImpulses>(GetSpec().solver).iterations;
    const Stopwatch watch;
    m_world->Step(GetTimeStep(), iterations.velocity, iterations.position);
    StepTimes times;
    times.step = watch.GetMilliseconds();
    const b2Profile& p = m_world->GetProfile();
    times.broadPhase = double{p.broadphase};
    if (newFixtures) times.broadPhase += std::max(0.0, double{p.step} - p.collide - p.solve - p.solveTOI);
    times.narrowPhase = double{p.collide};
    times.solver = std::max(0.0, double{p.solve} - p.broadphase);
    times.continuous = double{p.solveTOI};
    return times;
}

void Box2dRun::NoteAwake() {
    m_wasAwake.resize(m_bodies.size());
    for (size_t i = 0; i < m_bodies.size(); ++i) m_wasAwake[i] = IsSimulated(*m_bodies[i]);
}

StepCounts Box2dRun::CountStep() {
    StepCounts counts;
    // Bodies beyond those noted were created after the step: it did not simulate them.
    for (size_t i = 0; i < m_wasAwake.size(); ++i) counts.awake += m_wasAwake[i] || IsSimulated(*m_bodies[i]);
    NoteAwake();
    for (const b2Contact* c = m_world->GetContactList(); c; c = c->GetNext()) counts.touching += c->IsTouching();
    counts.contacts = m_world->GetContactCount();
    return counts;
}

void Box2dRun::ApplyToWorld(const RunSpec& spec) {
    m_world->SetGravity(ToB2(*spec.gravity));
    m_world->SetAllowSleeping(spec.sleeping);
    m_world->SetWarmStarting(spec.warmStarting);
    m_world->SetContinuousPhysics(spec.continuous);
}

void Box2dRun::CreateDrag(int body, Vec2 localPoint) {
    const b2BodyDef groundDef;
    if (!m_dragGround) m_dragGround = m_world->CreateBody(&groundDef);
    b2Body* dragged = m_bodies[static_cast<size_t>(body)];
    b2MouseJointDef def;
    def.bodyA = m_dragGround;
    def.bodyB = dragged;
    def.target = dragged->GetWorldPoint(ToB2(localPoint));
    def.maxForce = dragAcceleration * dragged->GetMass();
    b2LinearStiffness(def.stiffness, def.damping, dragHertz, dragDampingRatio, m_dragGround, dragged);
    m_drag = static_cast<b2MouseJoint*>(m_world->CreateJoint(&def));
    dragged->SetAwake(true);
}

void Box2dRun::DestroyDrag() {
    // Its ground goes with it, so that a saved scene has no body that nobody made.
    m_world->DestroyBody(m_dragGround);
    m_drag = nullptr;
    m_dragGround = nullptr;
}

void Box2dRun::CaptureWorld(Snapshot& snapshot, const CaptureParts& parts) {
    const Box2dListing listing{.scene = &GetScene(),
                               .bodies = m_bodies,
                               .indexOf = IndexOf,
                               .proxies = m_proxies,
                               .proxyOf = ProxyOf,
                               .joints = m_joints};
    testbed::Capture(*m_world, listing, snapshot, parts);
}

}  // namespace

std::unique_ptr<InteractiveRun> MakeBox2dRun(const scenes::Scene& scene, const RunSpec& spec, const RunNeeds& needs) {
    return std::make_unique<Box2dRun>(scene, spec, needs);
}

}  // namespace testbed
