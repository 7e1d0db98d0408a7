// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// b2World: creation and destruction in Box2D's order, the step, settings, lists.

#include "../box2d/b2_world.h"

#include "convert.h"
#include "counters.h"
#include "scree/inspect.h"
#include "world_data.h"

using namespace scree::box2d;

namespace {

/// Box2D 2.4 has a speed cap; the engine has none unless told.
scree::WorldDef MakeDef() {
    scree::WorldDef def;
    def.gravity = scree::vec2Zero;
    def.maxTranslation = b2_maxTranslation;
    def.maxRotation = b2_maxRotation;
    def.lengthScale = b2_lengthUnitsPerMeter;
    return def;
}

scree::BodyDef ToScree(const b2BodyDef& def) {
    scree::BodyDef out;
    out.type = static_cast<scree::BodyType>(def.type);
    out.position = scree::box2d::ToScree(def.position);
    out.angle = def.angle;
    out.linearVelocity = scree::box2d::ToScree(def.linearVelocity);
    out.angularVelocity = def.angularVelocity;
    out.linearDamping = def.linearDamping;
    out.angularDamping = def.angularDamping;
    out.allowSleep = def.allowSleep;
    out.awake = def.awake;
    out.fixedRotation = def.fixedRotation;
    out.bullet = def.bullet;
    out.enabled = def.enabled;
    out.gravityScale = def.gravityScale;
    return out;
}

}  // namespace

b2WorldData::b2WorldData(b2World* owner, const b2Vec2& gravity) : world(owner), engine(MakeDef()) {
    engine.SetGravity(ToScree(gravity));  // where that is refused there is none: a constructor of Box2D's cannot refuse
    callFile = scree::box2d::CallFile::OpenIfAsked(engine);
}

b2ContactManager::b2ContactManager()
    : m_contactList(nullptr),
      m_contactCount(0),
      m_contactFilter(nullptr),
      m_contactListener(nullptr),
      m_allocator(nullptr) {}

b2World::b2World(const b2Vec2& gravity) : m_data(std::make_unique<b2WorldData>(this, gravity)) {
    b2Bridge::ShowWorld(m_data->manager.m_broadPhase, this);
}

b2World::~b2World() {
    // Box2D calls nobody when a world goes.
    m_data->engine.SetContactListener(nullptr);
    b2WorldData& data = *m_data;
    while (data.joints != nullptr) b2Bridge::FreeJoint(data, data.joints);
    while (data.contacts != nullptr) b2Bridge::FreeContact(data, data.contacts);
    while (data.bodies != nullptr) {
        while (b2Bridge::Fixtures(*data.bodies) != nullptr) b2Bridge::FreeFixture(b2Bridge::Fixtures(*data.bodies));
        b2Bridge::FreeBody(data.bodies);
    }
}

void b2World::SetDestructionListener(b2DestructionListener* listener) { m_data->destruction = listener; }

void b2World::SetContactFilter(b2ContactFilter* filter) {
    m_data->filter = filter;
    m_data->engine.SetContactFilter(&m_data->events);
}

void b2World::SetContactListener(b2ContactListener* listener) {
    m_data->listener = listener;
    m_data->engine.SetContactListener(listener != nullptr ? &m_data->events : nullptr);
}

void b2World::SetDebugDraw(b2Draw* debugDraw) { m_data->draw = debugDraw; }

b2Body* b2World::CreateBody(const b2BodyDef* def) {
    scree::BodyDef converted;
    if (def != nullptr) converted = ToScree(*def);
    scree::Body* handle = m_data->engine.CreateBody(def != nullptr ? &converted : nullptr);
    return handle != nullptr ? b2Bridge::MakeBody(*this, *def, handle) : nullptr;
}

void b2World::DestroyBody(b2Body* body) {
    b2WorldData& data = *m_data;
    if (body == nullptr || body->GetWorld() != this || data.stepping) {
        data.engine.DestroyBody(b2Bridge::Handle(body));  // refuses with the reason
        return;
    }
    b2Bridge::DestroyBody(data, body);
}

b2Joint* b2World::CreateJoint(const b2JointDef* def) {
    if (def == nullptr) {
        m_data->engine.CreateJoint(nullptr);
        return nullptr;
    }
    for (const b2Body* body : {def->bodyA, def->bodyB}) {
        if (body == nullptr || !b2Bridge::IsDying(*body)) continue;
        Complain("b2World::CreateJoint", "one of the bodies is being destroyed");
        return nullptr;
    }
    b2Joint* joint = b2Bridge::MakeJoint(*m_data, *def);
    b2Bridge::Touch(*m_data);
    return joint;
}

void b2World::DestroyJoint(b2Joint* joint) {
    if (joint == nullptr || m_data->stepping || joint->GetBodyA()->GetWorld() != this) {
        m_data->engine.DestroyJoint(b2Bridge::Handle(joint));
        return;
    }
    b2Bridge::DestroyJoint(*m_data, joint);
    b2Bridge::Touch(*m_data);
}

void b2World::Step(float timeStep, int32 velocityIterations, int32 positionIterations) {
    b2WorldData& data = *m_data;
    if (data.stepping) {
        data.engine.Step(timeStep, velocityIterations, positionIterations);  // refuses
        return;
    }
    if (data.destructions > 0) return Complain("b2World::Step", "call it outside of callbacks");
    b2Bridge::SyncShapes(data);
    data.stepping = true;
    const scree::StepReport report =
        data.engine.Step(timeStep, b2Max(velocityIterations, 0), b2Max(positionIterations, 0));
    data.stepping = false;
    if (data.callFile != nullptr) data.callFile->Write();
    for (b2Fixture* fixture : data.refilters) b2Bridge::ApplyFilter(*fixture);
    data.refilters.clear();
    b2Bridge::Touch(data);
    for (b2Body* body = data.bodies; body != nullptr; body = b2Bridge::Next(*body)) b2Bridge::Refresh(*body);
    data.profile = {};
    data.profile.step = report.profile.step;
    data.profile.collide = report.profile.narrowPhase;
    data.profile.solve = report.profile.islands + report.profile.solver;
    data.profile.solveInit = report.profile.islands;
    data.profile.solveVelocity = report.profile.solver;
    data.profile.broadphase = report.profile.broadPhase;
    data.profile.solveTOI = report.profile.continuous;
    CountToi(scree::inspect::GetDistanceWork(data.engine), report.profile.continuous);
}

void b2World::ClearForces() { m_data->engine.ClearForces(); }

b2Body* b2World::GetBodyList() { return m_data->bodies; }
const b2Body* b2World::GetBodyList() const { return m_data->bodies; }
b2Joint* b2World::GetJointList() { return m_data->joints; }
const b2Joint* b2World::GetJointList() const { return m_data->joints; }
b2Contact* b2World::GetContactList() {
    b2Bridge::SyncContacts(*m_data);
    return m_data->contacts;
}
const b2Contact* b2World::GetContactList() const {
    b2Bridge::SyncContacts(*m_data);
    return m_data->contacts;
}

void b2World::SetAllowSleeping(bool flag) { m_data->engine.SetAllowSleeping(flag); }
bool b2World::GetAllowSleeping() const { return m_data->engine.GetAllowSleeping(); }
void b2World::SetWarmStarting(bool flag) { m_data->engine.SetWarmStarting(flag); }
bool b2World::GetWarmStarting() const { return m_data->engine.GetWarmStarting(); }
void b2World::SetContinuousPhysics(bool flag) { m_data->engine.SetContinuousPhysics(flag); }
bool b2World::GetContinuousPhysics() const { return m_data->engine.GetContinuousPhysics(); }
void b2World::SetSubStepping(bool flag) { m_data->engine.SetSubStepping(flag); }
bool b2World::GetSubStepping() const { return m_data->engine.GetSubStepping(); }
int32 b2World::GetProxyCount() const { return m_data->engine.GetProxyCount(); }
int32 b2World::GetBodyCount() const { return m_data->engine.GetBodyCount(); }
int32 b2World::GetJointCount() const { return m_data->engine.GetJointCount(); }
int32 b2World::GetContactCount() const {
    if (m_data->endedRows.empty() && m_data->detached.empty()) return m_data->engine.GetContactCount();
    b2Bridge::SyncContacts(*m_data);
    int32 count = 0;
    for (const b2Contact* contact = m_data->contacts; contact != nullptr; contact = contact->GetNext()) ++count;
    return count;
}
int32 b2World::GetTreeHeight() const { return m_data->engine.GetTreeHeight(); }
int32 b2World::GetTreeBalance() const { return m_data->engine.GetTreeBalance(); }
float b2World::GetTreeQuality() const { return m_data->engine.GetTreeQuality(); }
void b2World::SetGravity(const b2Vec2& gravity) { m_data->engine.SetGravity(scree::box2d::ToScree(gravity)); }
b2Vec2 b2World::GetGravity() const { return ToBox2d(m_data->engine.GetGravity()); }
bool b2World::IsLocked() const { return m_data->stepping; }
void b2World::SetAutoClearForces(bool flag) { m_data->engine.SetAutoClearForces(flag); }
bool b2World::GetAutoClearForces() const { return m_data->engine.GetAutoClearForces(); }

void b2World::ShiftOrigin(const b2Vec2& newOrigin) {
    if (m_data->engine.ShiftOrigin(scree::box2d::ToScree(newOrigin)) != scree::ErrorCode::ok) return;
    for (b2Body* body = m_data->bodies; body != nullptr; body = b2Bridge::Next(*body)) b2Bridge::Refresh(*body);
    b2Bridge::Touch(*m_data);
}

const b2ContactManager& b2World::GetContactManager() const {
    b2ContactManager& manager = m_data->manager;
    b2Bridge::SyncContacts(*m_data);
    manager.m_contactList = m_data->contacts;
    manager.m_contactCount = GetContactCount();
    manager.m_contactFilter = m_data->filter;
    manager.m_contactListener = m_data->listener;
    manager.m_allocator = &m_data->allocator;
    return manager;
}

const b2Profile& b2World::GetProfile() const { return m_data->profile; }
void b2World::Dump() { b2Dump("// scree writes no dump of worlds\n"); }
