// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A scene running in Box2D 2.4.1: loading, stepping, times by stage, capture. Times: Box2D measures `broadphase`
// (synchronising fixtures and finding pairs) inside its `solve`, so the solver's time is the difference. When fixtures
// were created since the last step it also searches pairs for them before its first timer; that share is the rest of
// `step` after all measured stages. Its retest of fattened boxes is inside `collide` and cannot be separated.

#include <box2d/box2d.h>

#include <algorithm>

#include "testbed/base/stopwatch.h"
#include "testbed/engines/box2d_joint.h"
#include "testbed/engines/box2d_shape.h"
#include "testbed/engines/box2d_tree_dump.h"
#include "testbed/engines/pair_count.h"
#include "testbed/engines/scene_run.h"

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
int IndexOf(b2Fixture* fixture, int32 child) { return static_cast<int>(fixture->GetUserData().pointer) + child; }
int FixtureOfProxy(void* userData) {
    const auto* proxy = static_cast<b2FixtureProxy*>(userData);
    return IndexOf(proxy->fixture, proxy->childIndex);
}

/// Box2D flags static bodies that an island touched as awake, which means nothing.
bool IsSimulated(const b2Body& body) { return body.GetType() != b2_staticBody && body.IsAwake(); }

class Box2dRun final : public SceneRun {
public:
    Box2dRun(const scenes::Scene& scene, const RunSpec& spec, const RunNeeds& needs) : SceneRun(scene, spec, needs) {
        m_bodies.reserve(scene.bodies.size());
        m_fixtures.reserve(scene.fixtures.size());
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

    [[nodiscard]] int GetContactCount() const override { return m_world->GetContactCount(); }
    [[nodiscard]] StepCounts CountStep() override;

protected:
    void CreateBody(const scenes::Body& body) override;
    void CreateJoint(const scenes::Joint& joint) override;
    StepTimes StepEngine(bool newFixtures) override;
    void CaptureHeader(Snapshot& snapshot) override;
    void CaptureBodies(std::vector<BodyState>& bodies) override;
    void CaptureRest(Snapshot& snapshot, const CaptureParts& parts) override;
    void ApplyToWorld(const RunSpec& spec) override;
    void CreateDrag(int body, Vec2 localPoint) override;
    void MoveDragTo(Vec2 target) override { m_drag->SetTarget(ToB2(target)); }
    void DestroyDrag() override;

private:
    /// A fixture, its index into the scene's fixtures, and which child of it is meant.
    struct Entry {
        b2Fixture* fixture;
        int sceneIndex;
        int child;
    };

    /// The tangent speed of a contact is that of both surfaces together: it does not depend on which of them is A.
    class Conveyor final : public b2ContactListener {
    public:
        explicit Conveyor(const Box2dRun& run) : m_run(run) {}
        void PreSolve(b2Contact* contact, const b2Manifold*) override {
            contact->SetTangentSpeed(SpeedOf(contact->GetFixtureA()) + SpeedOf(contact->GetFixtureB()));
        }

    private:
        [[nodiscard]] float SpeedOf(b2Fixture* fixture) const {
            const Entry& entry = m_run.m_fixtures[static_cast<size_t>(IndexOf(fixture, 0))];
            return m_run.GetScene().fixtures[static_cast<size_t>(entry.sceneIndex)].tangentSpeed;
        }
        const Box2dRun& m_run;
    };

    void CreateFixture(b2Body& body, int sceneIndex);
    void NoteAwake();

    void CaptureFixtures(std::vector<FixtureState>& fixtures) const;
    void CaptureContacts(std::vector<ContactState>& contacts) const;
    void CaptureJoints(std::vector<JointState>& joints) const;
    void CaptureNodes(Snapshot& snapshot, bool pairs) const;

    Conveyor m_conveyor{*this};
    std::unique_ptr<b2World> m_world;
    Box2dBodies m_bodies;            ///< by body index
    std::vector<Entry> m_fixtures;   ///< by index into Snapshot::fixtures
    Box2dJoints m_joints;            ///< by joint index
    std::vector<bool> m_wasAwake;    ///< by body index, after the step that was counted last
    b2Body* m_dragGround = nullptr;  ///< carries the spring that drags
    b2MouseJoint* m_drag = nullptr;
};

void Box2dRun::CreateFixture(b2Body& body, int sceneIndex) {
    const scenes::Fixture& fixture = GetScene().fixtures[static_cast<size_t>(sceneIndex)];
    b2Fixture* made = nullptr;
    if (fixture.shape.type == scenes::ShapeType::chain) {
        b2ChainShape chain;
        MakeBox2dChain(GetScene(), fixture.shape, chain);
        const b2FixtureDef def = MakeB2FixtureDef(fixture, chain, m_fixtures.size());
        made = body.CreateFixture(&def);
    } else {
        const Box2dShape shape = MakeBox2dShape(Box2dShapeOf(GetScene(), fixture.shape));
        const b2FixtureDef def = MakeB2FixtureDef(fixture, AsB2Shape(shape), m_fixtures.size());
        made = body.CreateFixture(&def);
    }
    for (int child = 0; child < fixture.shape.ChildCount(); ++child) m_fixtures.push_back({made, sceneIndex, child});
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
    m_world->DestroyJoint(m_drag);
    m_drag = nullptr;
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
                          .awake = IsSimulated(b),
                          .bullet = b.IsBullet()});
    }
}

void Box2dRun::CaptureFixtures(std::vector<FixtureState>& fixtures) const {
    fixtures.reserve(m_fixtures.size());
    for (const Entry& entry : m_fixtures) {
        b2AABB tight;
        b2Body* body = entry.fixture->GetBody();
        entry.fixture->GetShape()->ComputeAABB(&tight, body->GetTransform(), entry.child);
        fixtures.push_back(
            {.body = IndexOf(body),
             .fixture = entry.sceneIndex,
             .child = entry.child,
             .shape = Box2dShapeOf(
                 GetScene(),
                 scenes::ChildOf(GetScene(), GetScene().fixtures[static_cast<size_t>(entry.sceneIndex)].shape,
                                 entry.child)),
             .sensor = entry.fixture->IsSensor(),
             .tight = FromB2(tight)});
    }
}

void Box2dRun::CaptureContacts(std::vector<ContactState>& contacts) const {
    contacts.reserve(static_cast<size_t>(m_world->GetContactCount()));
    for (b2Contact* c = m_world->GetContactList(); c; c = c->GetNext()) {
        ContactState state{};
        state.fixtureA = IndexOf(c->GetFixtureA(), c->GetChildIndexA());
        state.fixtureB = IndexOf(c->GetFixtureB(), c->GetChildIndexB());
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
    for (size_t i = 0; i < m_joints.size(); ++i) {
        b2Joint* j = m_joints[i];
        const scenes::Joint& joint = GetScene().joints[i];
        joints.push_back({IndexOf(j->GetBodyA()), IndexOf(j->GetBodyB()), FromB2(j->GetAnchorA()),
                          FromB2(j->GetAnchorB()), joint.type, joint.groundAnchorA, joint.groundAnchorB});
    }
}

void Box2dRun::CaptureNodes(Snapshot& snapshot, bool pairs) const {
    DumpBox2dTree(m_world->GetContactManager().m_broadPhase, FixtureOfProxy, snapshot.nodes);
    snapshot.treeHeight = m_world->GetTreeHeight();
    snapshot.leafSize = snapshot.nodes.empty() ? 0 : 1;
    if (pairs && !snapshot.fixtures.empty()) snapshot.pairsReported = CountPairs(LeafBoxes(snapshot));
}

void Box2dRun::CaptureRest(Snapshot& snapshot, const CaptureParts& parts) {
    if (parts.fixtures) CaptureFixtures(snapshot.fixtures);
    if (parts.contacts) CaptureContacts(snapshot.contacts);
    if (parts.joints) CaptureJoints(snapshot.joints);
    if (parts.nodes) CaptureNodes(snapshot, parts.pairs);
}

}  // namespace

std::unique_ptr<InteractiveRun> MakeBox2dRun(const scenes::Scene& scene, const RunSpec& spec, const RunNeeds& needs) {
    return std::make_unique<Box2dRun>(scene, spec, needs);
}

}  // namespace testbed
