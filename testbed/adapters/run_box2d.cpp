// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A scene running in Box2D 2.4.1: loading, stepping, times by stage, capture. Times: Box2D measures `broadphase`
// (synchronising fixtures and finding pairs) inside its `solve`, so the solver's time is the difference. When fixtures
// were created since the last step it also searches pairs for them before its first timer; that share is the rest of
// `step` after all measured stages. Its retest of fattened boxes is inside `collide` and cannot be separated.

#include <box2d/box2d.h>

#include <algorithm>

#include "testbed/adapters/box2d_shape.h"
#include "testbed/adapters/box2d_tree_dump.h"
#include "testbed/adapters/pair_count.h"
#include "testbed/adapters/scene_run.h"
#include "testbed/adapters/stopwatch.h"

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
int IndexOf(b2Fixture* fixture) { return static_cast<int>(fixture->GetUserData().pointer); }
int FixtureOfProxy(void* proxy) { return IndexOf(static_cast<b2FixtureProxy*>(proxy)->fixture); }

class Box2dRun final : public SceneRun {
public:
    Box2dRun(const scenes::Scene& scene, const RunOptions& options) : SceneRun(scene) {
        m_bodies.reserve(scene.bodies.size());
        m_fixtures.reserve(scene.fixtures.size());
        m_joints.reserve(scene.joints.size());
        Measure([&] {
            m_world = std::make_unique<b2World>(ToB2(scene.gravity));
            m_world->SetContinuousPhysics(options.continuous);
            m_world->SetAllowSleeping(true);
            m_world->SetWarmStarting(true);
            Load();
        });
    }

    [[nodiscard]] int GetContactCount() const override { return m_world->GetContactCount(); }

protected:
    void CreateBody(const scenes::Body& body) override;
    void CreateJoint(const scenes::Joint& joint) override;
    StepTimes StepEngine(bool newFixtures) override;
    void CaptureHeader(Snapshot& snapshot) override;
    void CaptureBodies(std::vector<BodyState>& bodies) override;
    void CaptureRest(Snapshot& snapshot, const CaptureParts& parts) override;

private:
    /// A fixture and its index into the scene's fixtures.
    struct Entry {
        b2Fixture* fixture;
        int sceneIndex;
    };

    void CaptureFixtures(std::vector<FixtureState>& fixtures) const;
    void CaptureContacts(std::vector<ContactState>& contacts) const;
    void CaptureJoints(std::vector<JointState>& joints) const;
    void CaptureNodes(Snapshot& snapshot) const;

    std::unique_ptr<b2World> m_world;
    std::vector<b2Body*> m_bodies;   ///< by body index
    std::vector<Entry> m_fixtures;   ///< by index into Snapshot::fixtures
    std::vector<b2Joint*> m_joints;  ///< by joint index
};

void Box2dRun::CreateBody(const scenes::Body& body) {
    b2BodyDef bodyDef = MakeB2BodyDef(body);
    bodyDef.userData.pointer = m_bodies.size();
    b2Body* made = m_world->CreateBody(&bodyDef);
    m_bodies.push_back(made);
    for (int i = body.firstFixture; i < body.firstFixture + body.fixtureCount; ++i) {
        const scenes::Fixture& fixture = GetScene().fixtures[static_cast<size_t>(i)];
        const Box2dShape shape = MakeBox2dShape(fixture.shape);
        const b2FixtureDef fixtureDef = MakeB2FixtureDef(fixture, AsB2Shape(shape), m_fixtures.size());
        m_fixtures.push_back({made->CreateFixture(&fixtureDef), i});
    }
    // A scene gives the velocity of the centre of mass, Box2D's definition that of the origin; they differ in a spin.
    if (body.angularVelocity != 0.0f) made->SetLinearVelocity(ToB2(body.linearVelocity));
}

void Box2dRun::CreateJoint(const scenes::Joint& joint) {
    b2RevoluteJointDef def;
    def.bodyA = m_bodies[static_cast<size_t>(joint.bodyA)];
    def.bodyB = m_bodies[static_cast<size_t>(joint.bodyB)];
    def.collideConnected = joint.collideConnected;
    def.localAnchorA = ToB2(joint.localAnchorA);
    def.localAnchorB = ToB2(joint.localAnchorB);
    def.referenceAngle = joint.referenceAngle;
    def.enableLimit = joint.enableLimit;
    def.lowerAngle = joint.lowerAngle;
    def.upperAngle = joint.upperAngle;
    def.enableMotor = joint.enableMotor;
    def.motorSpeed = joint.motorSpeed;
    def.maxMotorTorque = joint.maxMotorTorque;
    m_joints.push_back(m_world->CreateJoint(&def));
}

StepTimes Box2dRun::StepEngine(bool newFixtures) {
    const scenes::Scene& scene = GetScene();
    const Stopwatch watch;
    m_world->Step(scene.timeStep, scene.velocityIterations, scene.positionIterations);
    StepTimes times;
    times.step = watch.GetMilliseconds();
    const b2Profile& p = m_world->GetProfile();
    times.broadPhase = double{p.broadphase};
    if (newFixtures) times.broadPhase += std::max(0.0, double{p.step} - p.collide - p.solve - p.solveTOI);
    times.narrowPhase = double{p.collide};
    times.solver = std::max(0.0, double{p.solve} - p.broadphase);
    return times;
}

void Box2dRun::CaptureHeader(Snapshot& snapshot) {
    snapshot.engine = "box2d";
    snapshot.broadPhase = "b2DynamicTree";
    snapshot.threads = 1;
    snapshot.contactCount = m_world->GetContactCount();
    snapshot.touchingCount = 0;
    snapshot.pairsReported = 0;
    for (const b2Contact* c = m_world->GetContactList(); c; c = c->GetNext()) snapshot.touchingCount += c->IsTouching();
}

void Box2dRun::CaptureBodies(std::vector<BodyState>& bodies) {
    for (size_t i = 0; i < m_bodies.size(); ++i) {
        const b2Body& b = *m_bodies[i];
        const scenes::BodyType type = GetScene().bodies[i].type;
        bodies.push_back({.index = static_cast<int>(i),
                          .type = type,
                          .position = FromB2(b.GetPosition()),
                          .sin = b.GetTransform().q.s,
                          .cos = b.GetTransform().q.c,
                          .angle = b.GetAngle(),
                          .linearVelocity = FromB2(b.GetLinearVelocity()),
                          .angularVelocity = b.GetAngularVelocity(),
                          // Box2D flags static bodies that an island touched as awake, which means nothing.
                          .awake = type != scenes::BodyType::isStatic && b.IsAwake(),
                          .bullet = b.IsBullet()});
    }
}

void Box2dRun::CaptureFixtures(std::vector<FixtureState>& fixtures) const {
    fixtures.reserve(m_fixtures.size());
    for (const Entry& entry : m_fixtures) {
        b2AABB tight;
        b2Body* body = entry.fixture->GetBody();
        entry.fixture->GetShape()->ComputeAABB(&tight, body->GetTransform(), 0);
        fixtures.push_back({.body = IndexOf(body),
                            .fixture = entry.sceneIndex,
                            .shape = GetScene().fixtures[static_cast<size_t>(entry.sceneIndex)].shape,
                            .sensor = entry.fixture->IsSensor(),
                            .tight = FromB2(tight)});
    }
}

void Box2dRun::CaptureContacts(std::vector<ContactState>& contacts) const {
    contacts.reserve(static_cast<size_t>(m_world->GetContactCount()));
    for (b2Contact* c = m_world->GetContactList(); c; c = c->GetNext()) {
        ContactState state{};
        state.fixtureA = IndexOf(c->GetFixtureA());
        state.fixtureB = IndexOf(c->GetFixtureB());
        state.touching = c->IsTouching();
        const b2Manifold& manifold = *c->GetManifold();
        state.pointCount = manifold.pointCount;
        if (state.pointCount > 0) {
            b2WorldManifold world;
            c->GetWorldManifold(&world);
            state.normal = FromB2(world.normal);
            for (int k = 0; k < state.pointCount; ++k) {
                state.points[k] = FromB2(world.points[k]);
                state.separations[k] = world.separations[k];
                state.normalImpulses[k] = manifold.points[k].normalImpulse;
                state.tangentImpulses[k] = manifold.points[k].tangentImpulse;
            }
        }
        contacts.push_back(state);
    }
}

void Box2dRun::CaptureJoints(std::vector<JointState>& joints) const {
    for (b2Joint* j : m_joints) {
        joints.push_back(
            {IndexOf(j->GetBodyA()), IndexOf(j->GetBodyB()), FromB2(j->GetAnchorA()), FromB2(j->GetAnchorB())});
    }
}

void Box2dRun::CaptureNodes(Snapshot& snapshot) const {
    DumpBox2dTree(m_world->GetContactManager().m_broadPhase, FixtureOfProxy, snapshot.nodes);
    snapshot.treeHeight = m_world->GetTreeHeight();
    snapshot.leafSize = snapshot.nodes.empty() ? 0 : 1;
    if (!snapshot.fixtures.empty()) snapshot.pairsReported = CountPairs(LeafBoxes(snapshot));
}

void Box2dRun::CaptureRest(Snapshot& snapshot, const CaptureParts& parts) {
    if (parts.fixtures) CaptureFixtures(snapshot.fixtures);
    if (parts.contacts) CaptureContacts(snapshot.contacts);
    if (parts.joints) CaptureJoints(snapshot.joints);
    if (parts.nodes) CaptureNodes(snapshot);
}

}  // namespace

std::unique_ptr<EngineRun> MakeBox2dRun(const scenes::Scene& scene, const RunOptions& options) {
    return std::make_unique<Box2dRun>(scene, options);
}

}  // namespace testbed
