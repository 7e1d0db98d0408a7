// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A scene running in Box2D 3: loading, stepping, times by stage, capture. Nodes are those of box2d3_trees.h. They are
// made at the first capture that asks for them, and moved from one capture to the next. Refitting trees counts as broad
// phase, and the continuous collision of bullets as continuous. That of other bodies is part of the last stage of its
// solver and cannot be separated.

#include <box2d/box2d.h>

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "testbed/base/stopwatch.h"
#include "testbed/engines/box2d3/box2d3_engine.h"
#include "testbed/engines/box2d3/box2d3_trees.h"
#include "testbed/engines/box2d3/box2d3_world.h"
#include "testbed/engines/scene_run.h"
#include "testbed/engines/state_hash.h"

namespace testbed {
namespace box2d3 {
namespace {

class Run final : public SceneRun {
public:
    Run(const scenes::Scene& scene, const RunSpec& spec, const RunNeeds& needs) : SceneRun(scene, spec, needs) {
        Create([&] {
            m_world = std::make_unique<World>(GetSpec());
            Load();
        });
    }

    [[nodiscard]] int GetContactCount() const override { return b2World_GetCounters(m_world->Get()).contactCount; }
    [[nodiscard]] StepCounts CountStep() override {
        return {.awake = m_moved, .touching = CountTouching(), .contacts = GetContactCount()};
    }

protected:
    void CreateBody(const scenes::Body& body) override { m_world->AddBody(GetScene(), body); }
    void CreateJoint(const scenes::Joint& joint) override { m_world->AddJoint(joint); }
    StepTimes StepEngine(bool newFixtures) override;
    void CaptureWorld(Snapshot& snapshot, const CaptureParts& parts) override;
    void ApplyToWorld(const RunSpec& spec) override;
    void CreateDrag(int body, Vec2 localPoint) override;
    void MoveDragTo(Vec2 target) override { b2Joint_SetLocalFrameA(m_drag, {ToB2(target), b2Rot_identity}); }
    void DestroyDrag() override { b2DestroyJoint(m_drag); }

private:
    int CountTouching();
    void CaptureContacts(std::vector<ContactState>& contacts);
    void CaptureJoints(std::vector<JointState>& joints) const;
    void CaptureNodes(Snapshot& snapshot, bool pairs);

    std::unique_ptr<World> m_world;
    std::unique_ptr<Trees> m_trees;  ///< from the first capture of nodes on
    int m_moved = 0;                 ///< bodies that the last step simulated
    bool m_hasDragGround = false;
    b2BodyId m_dragGround{};  ///< carries the spring that drags
    b2JointId m_drag{};
};

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
    const b2BodyId dragged = m_world->GetBody(body);
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

int Run::CountTouching() {
    int count = 0;
    m_world->ForEachContact([&](const b2ContactData&) { ++count; });
    return count;
}

void Run::CaptureContacts(std::vector<ContactState>& contacts) {
    m_world->ForEachContact([&](const b2ContactData& contact) {
        ContactState state{};
        state.fixtureA = World::IndexOf(contact.shapeIdA);
        state.fixtureB = World::IndexOf(contact.shapeIdB);
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
    const std::span<const b2JointId> all = m_world->GetJoints();
    for (size_t i = 0; i < all.size(); ++i) {
        const scenes::Joint& joint = GetScene().joints[i];
        const auto anchorOf = [](b2BodyId body, b2Transform frame) {
            const b2Pos p = b2Body_GetWorldPoint(body, frame.p);
            return Vec2{static_cast<float>(p.x), static_cast<float>(p.y)};
        };
        joints.push_back({.bodyA = joint.bodyA,
                          .bodyB = joint.bodyB,
                          .anchorA = anchorOf(b2Joint_GetBodyA(all[i]), b2Joint_GetLocalFrameA(all[i])),
                          .anchorB = anchorOf(b2Joint_GetBodyB(all[i]), b2Joint_GetLocalFrameB(all[i])),
                          .type = joint.type});
    }
}

void Run::CaptureNodes(Snapshot& snapshot, bool pairs) {
    if (!m_trees) m_trees = std::make_unique<Trees>();
    m_trees->Rebuild();
    const std::span<const Proxy> proxies = m_world->GetProxies();
    for (size_t i = 0; i < proxies.size(); ++i) {
        const auto body = static_cast<size_t>(proxies[i].body);
        const b2WorldTransform pose = b2Body_GetTransform(m_world->GetBody(proxies[i].body));
        if (i < m_trees->GetCount()) {
            m_trees->Move(i, pose);
        } else {
            m_trees->Add(GetScene().bodies[body].type, proxies[i].shape, pose);
        }
    }
    m_trees->Dump(snapshot, pairs);
}

void Run::CaptureWorld(Snapshot& snapshot, const CaptureParts& parts) {
    ClearWorld(snapshot);
    snapshot.engine = "box2d3";
    snapshot.broadPhase = "b2DynamicTree x 3";
    snapshot.threads = GetSpec().threads;
    for (size_t i = 0; i < m_world->GetBodies().size(); ++i) {
        snapshot.bodies.push_back(CaptureBody(*m_world, GetScene(), static_cast<int>(i)));
    }
    snapshot.stateHash = HashState(snapshot.bodies);
    snapshot.contactCount = GetContactCount();
    snapshot.touchingCount = CountTouching();
    if (parts.fixtures) {
        for (const Proxy& proxy : m_world->GetProxies()) {
            const scenes::Fixture& fixture = GetScene().fixtures[static_cast<size_t>(proxy.sceneIndex)];
            FixtureState state{
                .body = proxy.body,
                .fixture = proxy.sceneIndex,
                .child = proxy.child,
                .shape = ShownShape(GetScene(), scenes::ChildOf(GetScene(), fixture.shape, proxy.child)),
                .sensor = proxy.isSensor,
                .tight = FromB2(ComputeBox(proxy.shape, b2Body_GetTransform(m_world->GetBody(proxy.body))))};
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
