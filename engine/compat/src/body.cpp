// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// b2Body: the engine's body under Box2D's name, with the lists of Box2D.

#include "../box2d/b2_body.h"

#include "convert.h"
#include "world_data.h"

using namespace scree::box2d;

b2Body* b2Bridge::MakeBody(b2World& world, const b2BodyDef& def, scree::Body* handle) {
    b2WorldData& data = Data(world);
    auto* body = new b2Body;
    body->m_handle = handle;
    body->m_world = &world;
    body->m_prev = nullptr;
    body->m_next = data.bodies;
    if (data.bodies != nullptr) data.bodies->m_prev = body;
    data.bodies = body;
    body->m_fixtureList = nullptr;
    body->m_jointList = nullptr;
    body->m_contactList = nullptr;
    body->m_userData = def.userData;
    handle->SetUserData({reinterpret_cast<uintptr_t>(body)});
    body->m_xf.SetIdentity();
    body->m_worldCenter.SetZero();
    body->m_localCenter.SetZero();
    body->m_linearVelocity.SetZero();
    Refresh(*body);
    return body;
}

void b2Bridge::FreeBody(b2Body* body) {
    b2WorldData& data = Data(*body);
    if (body->m_prev != nullptr) body->m_prev->m_next = body->m_next;
    if (body->m_next != nullptr) body->m_next->m_prev = body->m_prev;
    if (data.bodies == body) data.bodies = body->m_next;
    delete body;
}

void b2Bridge::Refresh(const b2Body& body) {
    // Nothing is written when nothing changed: several threads may read a body between steps.
    const auto set = [](b2Vec2& to, const b2Vec2& value) {
        if (to != value) to = value;
    };
    const scree::Body& handle = *body.m_handle;
    const b2Transform xf = ToBox2d(handle.GetTransform());
    set(body.m_xf.p, xf.p);
    if (body.m_xf.q.s != xf.q.s || body.m_xf.q.c != xf.q.c) body.m_xf.q = xf.q;
    set(body.m_worldCenter, ToBox2d(handle.GetWorldCenter()));
    set(body.m_localCenter, ToBox2d(handle.GetLocalCenter()));
    set(body.m_linearVelocity, ToBox2d(handle.GetLinearVelocity()));
}

b2Fixture* b2Body::CreateFixture(const b2FixtureDef* def) {
    if (def == nullptr || def->shape == nullptr) {
        scree::FixtureDef empty;
        m_handle->CreateFixture(def != nullptr ? &empty : nullptr);  // tells the error handler
        return nullptr;
    }
    if (m_goesBare) {
        Complain("b2Body::CreateFixture", "this body is being destroyed");
        return nullptr;
    }
    return b2Bridge::MakeFixture(*this, *def);
}

b2Fixture* b2Body::CreateFixture(const b2Shape* shape, float density) {
    b2FixtureDef def;
    def.shape = shape;
    def.density = density;
    return CreateFixture(&def);
}

void b2Body::DestroyFixture(b2Fixture* fixture) {
    if (fixture == nullptr) {
        m_handle->DestroyFixture(nullptr);
        return;
    }
    b2WorldData& data = b2Bridge::Data(*this);
    if (fixture->GetBody() != this || data.stepping) {
        m_handle->DestroyFixture(b2Bridge::FirstHandle(*fixture));  // refuses with the reason
        return;
    }
    b2Bridge::DestroyFixture(data, *this, fixture);
}

void b2Body::SetTransform(const b2Vec2& position, float angle) {
    m_handle->SetTransform(ToScree(position), angle);
    b2Bridge::Refresh(*this);
    b2Bridge::Touch(b2Bridge::Data(*this));
}

const b2Transform& b2Body::GetTransform() const {
    b2Bridge::Refresh(*this);
    return m_xf;
}
const b2Vec2& b2Body::GetPosition() const { return GetTransform().p; }
float b2Body::GetAngle() const { return m_handle->GetAngle(); }
const b2Vec2& b2Body::GetWorldCenter() const {
    b2Bridge::Refresh(*this);
    return m_worldCenter;
}
const b2Vec2& b2Body::GetLocalCenter() const {
    b2Bridge::Refresh(*this);
    return m_localCenter;
}

void b2Body::SetLinearVelocity(const b2Vec2& v) {
    m_handle->SetLinearVelocity(ToScree(v));
    b2Bridge::Refresh(*this);
}
const b2Vec2& b2Body::GetLinearVelocity() const {
    b2Bridge::Refresh(*this);
    return m_linearVelocity;
}
void b2Body::SetAngularVelocity(float omega) { m_handle->SetAngularVelocity(omega); }
float b2Body::GetAngularVelocity() const { return m_handle->GetAngularVelocity(); }

void b2Body::ApplyForce(const b2Vec2& force, const b2Vec2& point, bool wake) {
    m_handle->ApplyForce(ToScree(force), ToScree(point), wake);
}
void b2Body::ApplyForceToCenter(const b2Vec2& force, bool wake) { m_handle->ApplyForceToCenter(ToScree(force), wake); }
void b2Body::ApplyTorque(float torque, bool wake) { m_handle->ApplyTorque(torque, wake); }
void b2Body::ApplyLinearImpulse(const b2Vec2& impulse, const b2Vec2& point, bool wake) {
    m_handle->ApplyLinearImpulse(ToScree(impulse), ToScree(point), wake);
    b2Bridge::Refresh(*this);
}
void b2Body::ApplyLinearImpulseToCenter(const b2Vec2& impulse, bool wake) {
    m_handle->ApplyLinearImpulseToCenter(ToScree(impulse), wake);
    b2Bridge::Refresh(*this);
}
void b2Body::ApplyAngularImpulse(float impulse, bool wake) { m_handle->ApplyAngularImpulse(impulse, wake); }

float b2Body::GetMass() const { return m_handle->GetMass(); }
float b2Body::GetInertia() const { return m_handle->GetInertia(); }
void b2Body::GetMassData(b2MassData* data) const {
    scree::MassData mass;
    m_handle->GetMassData(&mass);
    *data = ToBox2d(mass);
}
void b2Body::SetMassData(const b2MassData* data) {
    scree::MassData mass;
    if (data != nullptr) mass = ToScree(*data);
    m_handle->SetMassData(data != nullptr ? &mass : nullptr);
    b2Bridge::Refresh(*this);
}
void b2Body::ResetMassData() {
    b2Bridge::SyncShapes(b2Bridge::Data(*this));
    m_handle->ResetMassData();
    b2Bridge::Refresh(*this);
}

b2Vec2 b2Body::GetWorldPoint(const b2Vec2& localPoint) const { return b2Mul(GetTransform(), localPoint); }
b2Vec2 b2Body::GetWorldVector(const b2Vec2& localVector) const { return b2Mul(GetTransform().q, localVector); }
b2Vec2 b2Body::GetLocalPoint(const b2Vec2& worldPoint) const { return b2MulT(GetTransform(), worldPoint); }
b2Vec2 b2Body::GetLocalVector(const b2Vec2& worldVector) const { return b2MulT(GetTransform().q, worldVector); }
b2Vec2 b2Body::GetLinearVelocityFromWorldPoint(const b2Vec2& worldPoint) const {
    return ToBox2d(m_handle->GetLinearVelocityFromWorldPoint(ToScree(worldPoint)));
}
b2Vec2 b2Body::GetLinearVelocityFromLocalPoint(const b2Vec2& localPoint) const {
    return ToBox2d(m_handle->GetLinearVelocityFromLocalPoint(ToScree(localPoint)));
}

float b2Body::GetLinearDamping() const { return m_handle->GetLinearDamping(); }
void b2Body::SetLinearDamping(float linearDamping) { m_handle->SetLinearDamping(linearDamping); }
float b2Body::GetAngularDamping() const { return m_handle->GetAngularDamping(); }
void b2Body::SetAngularDamping(float angularDamping) { m_handle->SetAngularDamping(angularDamping); }
float b2Body::GetGravityScale() const { return m_handle->GetGravityScale(); }
void b2Body::SetGravityScale(float scale) { m_handle->SetGravityScale(scale); }

void b2Body::SetType(b2BodyType type) { b2Bridge::SetType(b2Bridge::Data(*this), *this, type); }
b2BodyType b2Body::GetType() const { return static_cast<b2BodyType>(m_handle->GetType()); }
void b2Body::SetBullet(bool flag) { m_handle->SetBullet(flag); }
bool b2Body::IsBullet() const { return m_handle->IsBullet(); }
void b2Body::SetSleepingAllowed(bool flag) { m_handle->SetSleepingAllowed(flag); }
bool b2Body::IsSleepingAllowed() const { return m_handle->IsSleepingAllowed(); }
void b2Body::SetAwake(bool flag) {
    m_handle->SetAwake(flag);
    b2Bridge::Refresh(*this);
}
bool b2Body::IsAwake() const { return m_handle->IsAwake(); }
void b2Body::SetEnabled(bool flag) { b2Bridge::SetEnabled(b2Bridge::Data(*this), *this, flag); }
bool b2Body::IsEnabled() const { return m_handle->IsEnabled(); }
void b2Body::SetFixedRotation(bool flag) { m_handle->SetFixedRotation(flag); }
bool b2Body::IsFixedRotation() const { return m_handle->IsFixedRotation(); }

b2Fixture* b2Body::GetFixtureList() { return m_fixtureList; }
const b2Fixture* b2Body::GetFixtureList() const { return m_fixtureList; }
b2JointEdge* b2Body::GetJointList() { return m_jointList; }
const b2JointEdge* b2Body::GetJointList() const { return m_jointList; }
b2ContactEdge* b2Body::GetContactList() {
    b2Bridge::SyncContacts(b2Bridge::Data(*this));
    return m_contactList;
}
const b2ContactEdge* b2Body::GetContactList() const {
    b2Bridge::SyncContacts(b2Bridge::Data(*this));
    return m_contactList;
}
b2Body* b2Body::GetNext() { return m_next; }
const b2Body* b2Body::GetNext() const { return m_next; }
b2BodyUserData& b2Body::GetUserData() { return m_userData; }
b2World* b2Body::GetWorld() { return m_world; }
const b2World* b2Body::GetWorld() const { return m_world; }
void b2Body::Dump() { b2Dump("// scree writes no dump of bodies\n"); }

namespace {

/// A program's own user data (B2_USER_SETTINGS) need not have a `pointer`.
template <typename UserData>
void SetPointer(UserData& userData, void* data) {
    if constexpr (requires { userData.pointer; }) userData.pointer = reinterpret_cast<uintptr_t>(data);
}

}  // namespace

void b2Body::SetUserData(void* data) { SetPointer(m_userData, data); }
