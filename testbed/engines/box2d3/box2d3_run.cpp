// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A scene running in Box2D 3: loading, stepping, times by stage, capture. Nodes are those of box2d3_trees.h, made at
// the first capture that asks for them and moved from one to the next. Times: refitting trees counts to the broad
// phase, bullets to continuous collision; that of other bodies is part of its solver's last stage and cannot be
// separated.

#include <box2d/box2d.h>

#include <algorithm>
#include <memory>
#include <numbers>
#include <vector>

#include "testbed/base/stopwatch.h"
#include "testbed/engines/box2d3/box2d3_engine.h"
#include "testbed/engines/box2d3/box2d3_joint.h"
#include "testbed/engines/box2d3/box2d3_trees.h"
#include "testbed/engines/scene_run.h"
#include "testbed/engines/state_hash.h"

namespace testbed {
namespace box2d3 {
namespace {

b2BodyType MakeType(scenes::BodyType type) {
    switch (type) {
        case scenes::BodyType::kinematic:
            return b2_kinematicBody;
        case scenes::BodyType::dynamic:
            return b2_dynamicBody;
        default:
            return b2_staticBody;
    }
}

// Indices + 1 as user data: null means none.
void* ToUserData(size_t index) { return reinterpret_cast<void*>(index + 1); }
int FromUserData(void* data) { return static_cast<int>(reinterpret_cast<uintptr_t>(data)) - 1; }

/// Owns a world.
class World {
public:
    explicit World(const b2WorldDef& def) : m_id(b2CreateWorld(&def)) {}
    ~World() { b2DestroyWorld(m_id); }
    World(const World&) = delete;
    World& operator=(const World&) = delete;
    [[nodiscard]] b2WorldId Get() const { return m_id; }

private:
    b2WorldId m_id;
};

struct Proxy {
    int body, sceneIndex, child;
    bool isSensor;
    Shape shape;
};

class Run final : public SceneRun {
public:
    Run(const scenes::Scene& scene, const RunSpec& spec, const RunNeeds& needs) : SceneRun(scene, spec, needs) {
        Create([&] {
            b2WorldDef def = b2DefaultWorldDef();
            def.gravity = ToB2(*GetSpec().gravity);
            def.enableSleep = GetSpec().sleeping;
            def.enableContinuous = GetSpec().continuous;
            def.workerCount = GetSpec().threads;
            m_world = std::make_unique<World>(def);
            b2World_EnableWarmStarting(m_world->Get(), GetSpec().warmStarting);
            Load();
        });
    }

    [[nodiscard]] int GetContactCount() const override { return b2World_GetCounters(m_world->Get()).contactCount; }
    [[nodiscard]] StepCounts CountStep() override {
        return {.awake = m_moved, .touching = CountTouching(), .contacts = GetContactCount()};
    }

protected:
    void CreateBody(const scenes::Body& body) override;
    void CreateJoint(const scenes::Joint& joint) override {
        m_joints.push_back(box2d3::CreateJoint(m_world->Get(), joint, m_bodies));
    }
    StepTimes StepEngine(bool newFixtures) override;
    void CaptureWorld(Snapshot& snapshot, const CaptureParts& parts) override;
    void ApplyToWorld(const RunSpec& spec) override;
    void CreateDrag(int body, Vec2 localPoint) override;
    void MoveDragTo(Vec2 target) override { b2Joint_SetLocalFrameA(m_drag, {ToB2(target), b2Rot_identity}); }
    void DestroyDrag() override { b2DestroyJoint(m_drag); }

private:
    void CreateFixture(b2BodyId body, int sceneIndex);
    void CreateChain(b2BodyId body, const scenes::Fixture& fixture, const b2ShapeDef& def);
    /// Calls visit(contact data) once for each contact that touches, in the order of bodies.
    template <typename Visit>
    void ForEachContact(Visit&& visit);
    int CountTouching();
    void CaptureContacts(std::vector<ContactState>& contacts);
    void CaptureJoints(std::vector<JointState>& joints) const;
    void CaptureNodes(Snapshot& snapshot, bool pairs);

    std::unique_ptr<World> m_world;
    std::vector<b2BodyId> m_bodies;  ///< by body index
    std::vector<Proxy> m_proxies;    ///< by index into Snapshot::fixtures
    std::vector<b2JointId> m_joints;
    std::vector<b2ContactData> m_contacts;  ///< of one body, scratch
    std::unique_ptr<Trees> m_trees;         ///< from the first capture of nodes on
    int m_moved = 0;                        ///< bodies that the last step simulated
    bool m_hasDragGround = false;
    b2BodyId m_dragGround{};  ///< carries the spring that drags
    b2JointId m_drag{};
};

/// Chains and one-sided edges: a chain of Box2D 3, whose first and last points are the ghosts.
void Run::CreateChain(b2BodyId body, const scenes::Fixture& fixture, const b2ShapeDef& shapeDef) {
    std::vector<scenes::Vec2> points;
    const scenes::Shape& shape = fixture.shape;
    if (shape.type == scenes::ShapeType::edge) {
        points = {shape.vertices[2], shape.vertices[0], shape.vertices[1], shape.vertices[3]};
    } else {
        const auto vertices = GetScene().ChainVerticesOf(shape);
        if (!shape.IsLoop()) points.push_back(shape.vertices[0]);
        points.insert(points.end(), vertices.begin(), vertices.end());
        if (!shape.IsLoop()) points.push_back(shape.vertices[1]);
    }
    if (points.size() < 4) throw std::invalid_argument("box2d3 makes no loops of three edges");
    const auto list = std::make_unique<b2Vec2[]>(points.size());
    std::ranges::transform(points, list.get(), ToB2);
    b2ChainDef def = b2DefaultChainDef();
    def.points = list.get();
    def.count = static_cast<int>(points.size());
    def.materials = &shapeDef.material;
    def.materialCount = 1;
    def.filter = shapeDef.filter;
    def.isLoop = shape.IsLoop();
    const b2ChainId chain = b2CreateChain(body, &def);
    std::vector<b2ShapeId> segments(static_cast<size_t>(b2Chain_GetSegmentCount(chain)));
    b2Chain_GetSegments(chain, segments.data(), static_cast<int>(segments.size()));
    for (size_t i = 0; i < segments.size(); ++i) b2Shape_SetUserData(segments[i], ToUserData(m_proxies.size() + i));
}

void Run::CreateFixture(b2BodyId body, int sceneIndex) {
    const scenes::Fixture& fixture = GetScene().fixtures[static_cast<size_t>(sceneIndex)];
    b2ShapeDef def = b2DefaultShapeDef();
    def.userData = ToUserData(m_proxies.size());
    def.material.friction = fixture.friction;
    def.material.restitution = fixture.restitution;
    def.material.tangentSpeed = fixture.tangentSpeed;
    def.density = fixture.density;
    def.isSensor = fixture.isSensor;
    def.filter.categoryBits = fixture.categoryBits;
    // The bits of 2.4 fill sixteen; a mask of all of them means everything.
    def.filter.maskBits = fixture.maskBits == 0xFFFF ? ~uint64_t{0} : uint64_t{fixture.maskBits};
    def.filter.groupIndex = fixture.groupIndex;
    if (fixture.shape.type == scenes::ShapeType::chain || fixture.shape.IsOneSidedEdge()) {
        CreateChain(body, fixture, def);
    } else {
        struct Maker {
            b2BodyId body;
            const b2ShapeDef* def;
            void operator()(const b2Circle& s) const { b2CreateCircleShape(body, def, &s); }
            void operator()(const b2Capsule& s) const { b2CreateCapsuleShape(body, def, &s); }
            void operator()(const b2Polygon& s) const { b2CreatePolygonShape(body, def, &s); }
            void operator()(const b2Segment& s) const { b2CreateSegmentShape(body, def, &s); }
        };
        std::visit(Maker{body, &def}, MakeShape(GetScene(), fixture.shape));
    }
    for (int child = 0; child < fixture.shape.ChildCount(); ++child) {
        m_proxies.push_back({static_cast<int>(m_bodies.size()) - 1, sceneIndex, child, fixture.isSensor,
                             MakeShape(GetScene(), scenes::ChildOf(GetScene(), fixture.shape, child))});
    }
}

void Run::CreateBody(const scenes::Body& body) {
    b2BodyDef def = b2DefaultBodyDef();
    def.type = MakeType(body.type);
    def.position = b2ToPos(ToB2(body.position));
    def.rotation = b2MakeRot(body.angle);
    def.linearVelocity = ToB2(body.linearVelocity);
    def.angularVelocity = body.angularVelocity;
    def.linearDamping = body.linearDamping;
    def.angularDamping = body.angularDamping;
    def.gravityScale = body.gravityScale;
    def.enableSleep = body.allowSleep;
    def.isAwake = body.awake;
    def.isBullet = body.bullet;
    def.motionLocks.angularZ = body.fixedRotation;
    def.userData = ToUserData(m_bodies.size());
    const b2BodyId made = b2CreateBody(m_world->Get(), &def);
    m_bodies.push_back(made);
    for (int i = body.firstFixture; i < body.firstFixture + body.fixtureCount; ++i) CreateFixture(made, i);
    // A scene gives the velocity of the centre of mass.
    if (body.angularVelocity != 0.0f) b2Body_SetLinearVelocity(made, ToB2(body.linearVelocity));
}

StepTimes Run::StepEngine(bool) {
    const int substeps = std::get<SoftStep>(GetSpec().solver).substeps;
    const Stopwatch watch;
    b2World_Step(m_world->Get(), GetTimeStep(), substeps);
    StepTimes times;
    times.step = watch.GetMilliseconds();
    const b2Profile p = b2World_GetProfile(m_world->Get());
    times.broadPhase = double{p.pairs} + p.refit;
    times.narrowPhase = double{p.collide};
    times.continuous = double{p.bullets};
    times.solver = std::max(0.0, double{p.solve} - p.refit - p.bullets);
    m_moved = b2World_GetBodyEvents(m_world->Get()).moveCount;
    return times;
}

void Run::ApplyToWorld(const RunSpec& spec) {
    b2World_SetGravity(m_world->Get(), ToB2(*spec.gravity));
    b2World_EnableSleeping(m_world->Get(), spec.sleeping);
    b2World_EnableWarmStarting(m_world->Get(), spec.warmStarting);
    b2World_EnableContinuous(m_world->Get(), spec.continuous);
}

void Run::CreateDrag(int body, Vec2 localPoint) {
    if (!m_hasDragGround) {
        const b2BodyDef ground = b2DefaultBodyDef();
        m_dragGround = b2CreateBody(m_world->Get(), &ground);
        m_hasDragGround = true;
    }
    const b2BodyId dragged = m_bodies[static_cast<size_t>(body)];
    b2MotorJointDef def = b2DefaultMotorJointDef();
    def.base.bodyIdA = m_dragGround;
    def.base.bodyIdB = dragged;
    def.base.localFrameA = {b2Body_GetLocalPoint(m_dragGround, b2Body_GetWorldPoint(dragged, ToB2(localPoint))),
                            b2Rot_identity};
    def.base.localFrameB = {ToB2(localPoint), b2Rot_identity};
    def.linearHertz = dragHertz;
    def.linearDampingRatio = dragDampingRatio;
    def.maxSpringForce = dragAcceleration * b2Body_GetMass(dragged);
    m_drag = b2CreateMotorJoint(m_world->Get(), &def);
    b2Body_SetAwake(dragged, true);
}

template <typename Visit>
void Run::ForEachContact(Visit&& visit) {
    for (const b2BodyId body : m_bodies) {
        const int capacity = b2Body_GetContactCapacity(body);
        if (capacity == 0) continue;
        m_contacts.resize(static_cast<size_t>(capacity));
        const int count = b2Body_GetContactData(body, m_contacts.data(), capacity);
        for (int i = 0; i < count; ++i) {
            const b2ContactData& contact = m_contacts[static_cast<size_t>(i)];
            if (B2_ID_EQUALS(b2Shape_GetBody(contact.shapeIdA), body)) visit(contact);  // each contact has two bodies
        }
    }
}

int Run::CountTouching() {
    int count = 0;
    ForEachContact([&](const b2ContactData&) { ++count; });
    return count;
}

void Run::CaptureContacts(std::vector<ContactState>& contacts) {
    ForEachContact([&](const b2ContactData& contact) {
        ContactState state{};
        state.fixtureA = FromUserData(b2Shape_GetUserData(contact.shapeIdA));
        state.fixtureB = FromUserData(b2Shape_GetUserData(contact.shapeIdB));
        state.touching = true;
        state.pointCount = contact.manifold.pointCount;
        state.normal = FromB2(contact.manifold.normal);
        const b2Pos centre = b2Body_GetWorldCenter(b2Shape_GetBody(contact.shapeIdA));
        for (int k = 0; k < state.pointCount; ++k) {
            const b2ManifoldPoint& point = contact.manifold.points[k];
            state.points[k] = {static_cast<float>(centre.x + point.anchorA.x),
                               static_cast<float>(centre.y + point.anchorA.y)};
            state.separations[k] = point.separation;
            state.normalImpulses[k] = point.totalNormalImpulse;
            state.tangentImpulses[k] = point.tangentImpulse;
        }
        contacts.push_back(state);
    });
}

void Run::CaptureJoints(std::vector<JointState>& joints) const {
    for (size_t i = 0; i < m_joints.size(); ++i) {
        const scenes::Joint& joint = GetScene().joints[i];
        const auto anchorOf = [](b2BodyId body, b2Transform frame) {
            const b2Pos p = b2Body_GetWorldPoint(body, frame.p);
            return Vec2{static_cast<float>(p.x), static_cast<float>(p.y)};
        };
        joints.push_back({.bodyA = joint.bodyA,
                          .bodyB = joint.bodyB,
                          .anchorA = anchorOf(b2Joint_GetBodyA(m_joints[i]), b2Joint_GetLocalFrameA(m_joints[i])),
                          .anchorB = anchorOf(b2Joint_GetBodyB(m_joints[i]), b2Joint_GetLocalFrameB(m_joints[i])),
                          .type = joint.type});
    }
}

void Run::CaptureNodes(Snapshot& snapshot, bool pairs) {
    if (!m_trees) m_trees = std::make_unique<Trees>();
    m_trees->Rebuild();
    for (size_t i = 0; i < m_proxies.size(); ++i) {
        const auto body = static_cast<size_t>(m_proxies[i].body);
        const b2WorldTransform pose = b2Body_GetTransform(m_bodies[body]);
        if (i < m_trees->GetCount()) {
            m_trees->Move(i, pose);
        } else {
            m_trees->Add(GetScene().bodies[body].type, m_proxies[i].shape, pose);
        }
    }
    m_trees->Dump(snapshot, pairs);
}

void Run::CaptureWorld(Snapshot& snapshot, const CaptureParts& parts) {
    ClearWorld(snapshot);
    snapshot.engine = "box2d3";
    snapshot.broadPhase = "b2DynamicTree x 3";
    snapshot.threads = GetSpec().threads;
    for (size_t i = 0; i < m_bodies.size(); ++i) {
        const b2BodyId body = m_bodies[i];
        const b2WorldTransform pose = b2Body_GetTransform(body);
        const scenes::Body& made = GetScene().bodies[i];
        snapshot.bodies.push_back({.index = static_cast<int>(i),
                                   .type = made.type,
                                   .position = {static_cast<float>(pose.p.x), static_cast<float>(pose.p.y)},
                                   .sin = pose.q.s,
                                   .cos = pose.q.c,
                                   .angle = b2Rot_GetAngle(pose.q),
                                   .linearVelocity = FromB2(b2Body_GetLinearVelocity(body)),
                                   .angularVelocity = b2Body_GetAngularVelocity(body),
                                   .awake = made.type != scenes::BodyType::isStatic && b2Body_IsAwake(body),
                                   .bullet = made.bullet});
    }
    snapshot.stateHash = HashState(snapshot.bodies);
    snapshot.contactCount = GetContactCount();
    snapshot.touchingCount = CountTouching();
    if (parts.fixtures) {
        for (const Proxy& proxy : m_proxies) {
            const scenes::Fixture& fixture = GetScene().fixtures[static_cast<size_t>(proxy.sceneIndex)];
            FixtureState state{.body = proxy.body,
                               .fixture = proxy.sceneIndex,
                               .child = proxy.child,
                               .shape = ShownShape(GetScene(), scenes::ChildOf(GetScene(), fixture.shape, proxy.child)),
                               .sensor = proxy.isSensor,
                               .tight = FromB2(ComputeBox(
                                   proxy.shape, b2Body_GetTransform(m_bodies[static_cast<size_t>(proxy.body)])))};
            state.swept = state.tight;
            snapshot.fixtures.push_back(std::move(state));
        }
    }
    if (parts.contacts) CaptureContacts(snapshot.contacts);
    if (parts.joints) CaptureJoints(snapshot.joints);
    if (parts.nodes) CaptureNodes(snapshot, parts.pairs);
}

}  // namespace
}  // namespace box2d3

std::string GetBox2d3Version() {
    const b2Version version = b2GetVersion();
    return std::to_string(version.major) + "." + std::to_string(version.minor) + "." + std::to_string(version.revision);
}

std::unique_ptr<InteractiveRun> MakeBox2d3Run(const scenes::Scene& scene, const RunSpec& spec, const RunNeeds& needs) {
    return std::make_unique<box2d3::Run>(scene, spec, needs);
}

}  // namespace testbed
