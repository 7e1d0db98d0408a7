// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A scene running in our engine, through its public headers alone: loading, stepping, times by stage, capture. The
// solver's time includes finding islands, as Box2D's does.

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "scenes/outline.h"
#include "scree/inspect.h"
#include "scree/mouse_joint.h"
#include "scree/world.h"
#include "testbed/base/stopwatch.h"
#include "testbed/engines/feature_facts.h"
#include "testbed/engines/scene_run.h"
#include "testbed/engines/scree_joint.h"
#include "testbed/engines/scree_shape.h"
#include "testbed/engines/scree_step.h"

namespace testbed {
namespace {

scree::BodyType MakeType(scenes::BodyType type) {
    switch (type) {
        case scenes::BodyType::isStatic:
            return scree::staticBody;
        case scenes::BodyType::kinematic:
            return scree::kinematicBody;
        case scenes::BodyType::dynamic:
            return scree::dynamicBody;
    }
    return scree::staticBody;
}

scree::BodyDef MakeBodyDef(const scenes::Body& body) {
    scree::BodyDef def;
    def.type = MakeType(body.type);
    def.bullet = body.bullet;
    def.allowSleep = body.allowSleep;
    def.awake = body.awake;
    def.fixedRotation = body.fixedRotation;
    def.position = ToScree(body.position);
    def.angle = body.angle;
    def.linearVelocity = ToScree(body.linearVelocity);
    def.angularVelocity = body.angularVelocity;
    def.linearDamping = body.linearDamping;
    def.angularDamping = body.angularDamping;
    def.gravityScale = body.gravityScale;
    return def;
}

scree::FixtureDef MakeFixtureDef(const scenes::Fixture& fixture, const scree::Shape& shape, size_t index) {
    scree::FixtureDef def;
    def.shape = &shape;
    def.density = fixture.density;
    def.friction = fixture.friction;
    def.restitution = fixture.restitution;
    def.isSensor = fixture.isSensor;
    def.filter = {fixture.categoryBits, fixture.maskBits, fixture.groupIndex};
    def.userData.pointer = index;
    return def;
}

/// A refused call means a scene that cannot be loaded as described: nothing to go on with.
void ThrowError(const scree::Error& error, void*) {
    throw std::invalid_argument(std::string(error.function) + ": " + error.field + ": " + scree::GetName(error.code) +
                                "; " + error.cure);
}

/// Of outlines in pictures: chords of 3.75 degrees.
constexpr int outlineDirections = 96;

int BodyIndexOf(scree::Body* body) { return static_cast<int>(body->GetUserData().pointer); }

/// The tangent speed of a contact is that of both surfaces together: it does not depend on which of them is A.
class Conveyor final : public scree::ContactListener {
public:
    explicit Conveyor(const scenes::Scene& scene) : m_scene(scene) {}
    void PreSolve(scree::Contact* contact, const scree::Manifold*) override {
        contact->SetTangentSpeed(SpeedOf(contact->GetFixtureA()) + SpeedOf(contact->GetFixtureB()));
    }

private:
    [[nodiscard]] float SpeedOf(scree::Fixture* fixture) const {
        return m_scene.fixtures[fixture->GetUserData().pointer].tangentSpeed;
    }
    const scenes::Scene& m_scene;
};

class ScreeRun final : public SceneRun {
public:
    ScreeRun(const scenes::Scene& scene, const RunSpec& spec, const RunNeeds& needs)
        : SceneRun(scene, spec, needs), m_conveyor(GetScene()) {
        const scree::WorldDef def = MakeScreeWorldDef(GetSpec());
        m_bodies.reserve(scene.bodies.size());
        m_fixtures.reserve(scene.fixtures.size());
        m_indexOf.reserve(scene.fixtures.size());
        m_joints.reserve(scene.joints.size());
        Create([&] {
            m_world = std::make_unique<scree::World>(def);
            m_world->SetErrorHandler(ThrowError, nullptr);
            if (HasConveyor()) m_world->SetContactListener(&m_conveyor);
            Load();
        });
    }

    [[nodiscard]] const scree::World& GetWorld() const { return *m_world; }
    [[nodiscard]] int GetContactCount() const override { return m_world->GetContactCount(); }
    [[nodiscard]] StepCounts CountStep() override {
        const scree::StepReport& report = m_world->GetReport();
        return {report.awakeBodyCount, report.touchingCount, report.contactCount};
    }

protected:
    void CreateBody(const scenes::Body& body) override;
    void CreateJoint(const scenes::Joint& joint) override;
    StepTimes StepEngine(bool newFixtures) override;
    void CaptureHeader(Snapshot& snapshot) override;
    void CaptureBodies(std::vector<BodyState>& bodies) override;
    void CaptureRest(Snapshot& snapshot, const CaptureParts& parts) override;
    void ApplyToWorld(const RunSpec& spec) override;
    void CreateDrag(int body, Vec2 localPoint) override;
    void MoveDragTo(Vec2 target) override { m_drag->SetTarget(ToScree(target)); }
    void DestroyDrag() override;

private:
    /// A fixture of the engine, the index of its fixture in the scene, and which edge of that it is.
    struct Entry {
        scree::Fixture* fixture;
        int sceneIndex;
        int child;
        std::vector<Vec2> outline{};  ///< of a further convex shape
    };

    void CreateFixture(scree::Body& body, int sceneIndex);
    void AddEntry(Entry entry);
    [[nodiscard]] int IndexOf(const scree::Fixture* fixture) const {
        return m_indexOf[static_cast<size_t>(fixture->GetIndex())];
    }

    void CaptureFixtures(std::vector<FixtureState>& fixtures) const;
    void CaptureContacts(std::vector<ContactState>& contacts) const;
    void CaptureJoints(std::vector<JointState>& joints) const;
    void CaptureNodes(Snapshot& snapshot) const;

    Conveyor m_conveyor;
    std::unique_ptr<scree::World> m_world;
    ScreeBodies m_bodies;                 ///< by body index
    std::vector<Entry> m_fixtures;        ///< by index into Snapshot::fixtures
    std::vector<int> m_indexOf;           ///< Fixture::GetIndex → index into Snapshot::fixtures
    ScreeJoints m_joints;                 ///< by joint index
    scree::Body* m_dragGround = nullptr;  ///< carries the spring that drags
    scree::MouseJoint* m_drag = nullptr;
};

void ScreeRun::AddEntry(Entry entry) {
    const auto slot = static_cast<size_t>(entry.fixture->GetIndex());
    if (m_indexOf.size() <= slot) m_indexOf.resize(slot + 1, -1);
    m_indexOf[slot] = static_cast<int>(m_fixtures.size());
    m_fixtures.push_back(std::move(entry));
}

void ScreeRun::CreateFixture(scree::Body& body, int sceneIndex) {
    const scenes::Fixture& fixture = GetScene().fixtures[static_cast<size_t>(sceneIndex)];
    const auto index = static_cast<size_t>(sceneIndex);
    if (fixture.shape.type != scenes::ShapeType::chain) {
        const ScreeShape shape = MakeScreeShape(GetScene(), fixture.shape);
        const scree::FixtureDef def = MakeFixtureDef(fixture, AsShape(shape), index);
        Entry entry{body.CreateFixture(&def), sceneIndex, 0};
        if (scenes::IsFurtherConvex(fixture.shape.type)) {
            entry.outline = scenes::SampleOutline(GetScene(), fixture.shape, outlineDirections);
        }
        AddEntry(std::move(entry));
        return;
    }
    const scree::ChainShape chain = MakeScreeChain(GetScene(), fixture.shape);
    const scree::FixtureDef def = MakeFixtureDef(fixture, chain, index);
    body.CreateFixture(&def);
    // The list has the newest edge, the last one, first.
    std::vector<scree::Fixture*> edges(static_cast<size_t>(chain.GetChildCount()));
    scree::Fixture* edge = body.GetFixtureList();
    for (size_t left = edges.size(); left-- > 0; edge = edge->GetNext()) edges[left] = edge;
    for (size_t child = 0; child < edges.size(); ++child) {
        AddEntry({edges[child], sceneIndex, static_cast<int>(child)});
    }
}

void ScreeRun::CreateBody(const scenes::Body& body) {
    scree::BodyDef bodyDef = MakeBodyDef(body);
    bodyDef.userData.pointer = m_bodies.size();
    scree::Body* made = m_world->CreateBody(&bodyDef);
    m_bodies.push_back(made);
    for (int i = body.firstFixture; i < body.firstFixture + body.fixtureCount; ++i) {
        CreateFixture(*made, i);
    }
    // A scene gives the velocity of the centre of mass, a body definition that of the origin; they differ in a spin.
    if (body.angularVelocity != 0.0f) made->SetLinearVelocity(ToScree(body.linearVelocity));
}

void ScreeRun::CreateJoint(const scenes::Joint& joint) {
    m_joints.push_back(CreateScreeJoint(*m_world, joint, m_bodies, m_joints));
}

StepTimes ScreeRun::StepEngine(bool) {
    const Stopwatch watch;
    const scree::StepReport report = StepScree(*m_world, GetSpec().solver, GetTimeStep());
    const scree::Profile& p = report.profile;
    return {.broadPhase = double{p.broadPhase},
            .narrowPhase = double{p.narrowPhase},
            .solver = double{p.islands} + p.solver,
            .islands = double{p.islands},
            .continuous = double{p.continuous},
            .step = watch.GetMilliseconds()};
}

void ScreeRun::ApplyToWorld(const RunSpec& spec) {
    m_world->SetGravity(ToScree(*spec.gravity));
    m_world->SetAllowSleeping(spec.sleeping);
    m_world->SetWarmStarting(spec.warmStarting);
    m_world->SetContinuousPhysics(spec.continuous);
}

void ScreeRun::CreateDrag(int body, Vec2 localPoint) {
    const scree::BodyDef groundDef;
    if (!m_dragGround) m_dragGround = m_world->CreateBody(&groundDef);
    scree::Body* dragged = m_bodies[static_cast<size_t>(body)];
    scree::MouseJointDef def;
    def.bodyA = m_dragGround;
    def.bodyB = dragged;
    def.target = dragged->GetWorldPoint(ToScree(localPoint));
    def.maxForce = dragAcceleration * dragged->GetMass();
    scree::LinearStiffness(def.stiffness, def.damping, dragHertz, dragDampingRatio, m_dragGround, dragged);
    m_drag = static_cast<scree::MouseJoint*>(m_world->CreateJoint(&def));
    dragged->SetAwake(true);
}

void ScreeRun::DestroyDrag() {
    m_world->DestroyJoint(m_drag);
    m_drag = nullptr;
}

void ScreeRun::CaptureHeader(Snapshot& snapshot) {
    snapshot.engine = "scree";
    snapshot.broadPhase = scree::GetName(scree::inspect::GetBroadPhase(*m_world));
    snapshot.threads = GetSpec().threads;
    snapshot.contactCount = m_world->GetContactCount();
    snapshot.touchingCount = 0;
    snapshot.pairsReported = m_world->GetReport().pairCount;
    for (scree::Contact* c = m_world->GetContactList(); c; c = c->GetNext()) snapshot.touchingCount += c->IsTouching();
}

void ScreeRun::CaptureBodies(std::vector<BodyState>& bodies) {
    for (size_t i = 0; i < m_bodies.size(); ++i) {
        const scree::Body& b = *m_bodies[i];
        const scenes::BodyType type = GetScene().bodies[i].type;
        bodies.push_back({.index = static_cast<int>(i),
                          .type = type,
                          .position = FromScree(b.GetPosition()),
                          .sin = b.GetTransform().q.s,
                          .cos = b.GetTransform().q.c,
                          .angle = b.GetAngle(),
                          .linearVelocity = FromScree(b.GetLinearVelocity()),
                          .angularVelocity = b.GetAngularVelocity(),
                          .awake = type != scenes::BodyType::isStatic && b.IsAwake(),
                          .bullet = b.IsBullet()});
    }
}

void ScreeRun::CaptureFixtures(std::vector<FixtureState>& fixtures) const {
    fixtures.reserve(m_fixtures.size());
    for (const Entry& entry : m_fixtures) {
        scree::AABB tight;
        scree::Body* body = entry.fixture->GetBody();
        std::as_const(*entry.fixture).GetShape()->ComputeAABB(&tight, body->GetTransform());
        fixtures.push_back(
            {.body = BodyIndexOf(body),
             .fixture = entry.sceneIndex,
             .child = entry.child,
             .shape = scenes::ChildOf(GetScene(), GetScene().fixtures[static_cast<size_t>(entry.sceneIndex)].shape,
                                      entry.child),
             .sensor = entry.fixture->IsSensor(),
             .tight = FromScree(tight)});
        if (!entry.outline.empty()) fixtures.back().outline = entry.outline;
    }
}

void ScreeRun::CaptureContacts(std::vector<ContactState>& contacts) const {
    contacts.reserve(static_cast<size_t>(m_world->GetContactCount()));
    std::vector<int> colours;
    scree::inspect::GetContactColours(*m_world, colours);
    for (scree::Contact* c = m_world->GetContactList(); c; c = c->GetNext()) {
        ContactState state{};
        state.fixtureA = IndexOf(c->GetFixtureA());
        state.fixtureB = IndexOf(c->GetFixtureB());
        state.touching = c->IsTouching();
        state.color = colours[static_cast<size_t>(c->GetIndex())];
        const scree::Manifold& manifold = *c->GetManifold();
        state.pointCount = manifold.pointCount;
        if (state.pointCount > 0) {
            scree::WorldManifold world;
            c->GetWorldManifold(&world);
            state.normal = FromScree(world.normal);
            for (int k = 0; k < state.pointCount; ++k) {
                state.points[k] = FromScree(world.points[k]);
                state.separations[k] = world.separations[k];
                state.normalImpulses[k] = manifold.points[k].normalImpulse;
                state.tangentImpulses[k] = manifold.points[k].tangentImpulse;
            }
        }
        contacts.push_back(state);
    }
}

void ScreeRun::CaptureJoints(std::vector<JointState>& joints) const {
    for (size_t i = 0; i < m_joints.size(); ++i) {
        scree::Joint* j = m_joints[i];
        const scenes::Joint& joint = GetScene().joints[i];
        joints.push_back({BodyIndexOf(j->GetBodyA()), BodyIndexOf(j->GetBodyB()), FromScree(j->GetAnchorA()),
                          FromScree(j->GetAnchorB()), joint.type, joint.groundAnchorA, joint.groundAnchorB});
    }
}

void ScreeRun::CaptureNodes(Snapshot& snapshot) const {
    std::vector<scree::BvhNode> nodes;
    scree::inspect::GetNodes(*m_world, nodes);
    snapshot.leafSize = scree::inspect::GetLeafSize(*m_world);
    snapshot.nodes.reserve(nodes.size());
    for (const scree::BvhNode& n : nodes) {
        const int fixture = n.fixture < 0 ? -1 : m_indexOf[static_cast<size_t>(n.fixture)];
        snapshot.nodes.push_back({FromScree(n.box), n.parent, n.child1, n.child2, fixture, n.level});
        snapshot.treeHeight = std::max(snapshot.treeHeight, n.level);
    }
}

void ScreeRun::CaptureRest(Snapshot& snapshot, const CaptureParts& parts) {
    if (parts.fixtures) CaptureFixtures(snapshot.fixtures);
    if (parts.contacts) CaptureContacts(snapshot.contacts);
    if (parts.joints) CaptureJoints(snapshot.joints);
    if (parts.nodes) CaptureNodes(snapshot);
}

}  // namespace

FeatureFacts GetFeatureFacts(const EngineRun& run) {
    const auto* own = dynamic_cast<const ScreeRun*>(&run);
    if (own == nullptr) throw std::invalid_argument("features are those of our engine");
    const scree::World& world = own->GetWorld();
    FeatureFacts facts;
    const scree::FeatureUsers users = world.GetFeatureUsers();
    for (size_t i = 0; i < users.size(); ++i) facts.uses.push_back({scree::featureNames[i], users[i]});
    facts.kernels = scree::GetName(scree::inspect::GetKernels(world));
    const scree::inspect::MemoryUse memory = scree::inspect::GetMemoryUse(world);
    facts.bytesPerBody = memory.bytesPerBody;
    facts.bytesPerFixture = memory.bytesPerFixture;
    facts.bytesPerContact = memory.bytesPerContact;
    facts.jointBytes = memory.joints;
    facts.bodies = world.GetBodyCount();
    facts.contacts = world.GetContactCount();
    facts.joints = world.GetJointCount();
    facts.stateHash = scree::inspect::GetStateHash(world);
    return facts;
}

std::unique_ptr<InteractiveRun> MakeScreeRun(const scenes::Scene& scene, const RunSpec& spec, const RunNeeds& needs) {
    return std::make_unique<ScreeRun>(scene, spec, needs);
}

}  // namespace testbed
