// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The body handle.

#include "scree/body.h"

#include "pipeline/update_boxes.h"
#include "world/refresh.h"
#include "world/validate.h"

namespace scree {

namespace {

size_t Row(int index) { return static_cast<size_t>(index); }

ErrorCode CheckVector(const WorldState& s, Vec2 v, const char* function, const char* field) {
    return v.IsValid() ? ErrorCode::ok : s.Refuse(ErrorCode::nonFinite, function, field, "give a finite vector");
}

ErrorCode CheckNumber(const WorldState& s, float value, const char* function, const char* field) {
    return std::isfinite(value) ? ErrorCode::ok
                                : s.Refuse(ErrorCode::nonFinite, function, field, "give a finite number");
}

ErrorCode CheckAmount(const WorldState& s, float value, const char* function, const char* field) {
    if (value < 0.0f) return s.Refuse(ErrorCode::outOfRange, function, field, "give a number of at least 0");
    return CheckNumber(s, value, function, field);
}

/// True if a push reaches the body: dynamic, and awake or woken by it.
bool TakesPush(BodyTable& bodies, int body, bool wake) {
    if (bodies.type[Row(body)] != dynamicBody) return false;
    if (wake && !bodies.Has(body, BodyFlag::awake)) bodies.Wake(body);
    return bodies.Has(body, BodyFlag::awake);
}

void SetFlag(BodyTable& bodies, int body, uint16_t flag, bool on) {
    uint16_t& flags = bodies.flags[Row(body)];
    flags = static_cast<uint16_t>(on ? flags | flag : flags & ~flag);
}

}  // namespace

Fixture* Body::CreateFixture(const FixtureDef* def) {
    WorldState& s = *m_state;
    const char* name = "Body::CreateFixture";
    if (def == nullptr) return s.Refuse(ErrorCode::nullArgument, name, "def", "pass a FixtureDef"), nullptr;
    if (s.locked) return s.Refuse(ErrorCode::locked, name, "world", "create fixtures outside of Step"), nullptr;
    if (const Finding bad = Check(*def)) return s.Refuse(bad.code, name, bad.field, bad.cure), nullptr;
    const int fixture = s.fixtures.Add(&s, m_index, *def);
    BodyInfo& info = s.bodies.info[Row(m_index)];
    s.fixtures.info[Row(fixture)].next = info.fixtureHead;
    info.fixtureHead = fixture;
    ++info.fixtureCount;
    if (IsEnabled()) AddProxy(s, fixture);
    if (def->density > 0.0f) ResetMass(s, m_index);
    return &s.fixtures.handles[Row(fixture)];
}

Fixture* Body::CreateFixture(const Shape* shape, float density) {
    FixtureDef def;
    def.shape = shape;
    def.density = density;
    return CreateFixture(&def);
}

ErrorCode Body::DestroyFixture(Fixture* fixture) {
    WorldState& s = *m_state;
    const char* name = "Body::DestroyFixture";
    if (fixture == nullptr) return s.Refuse(ErrorCode::nullArgument, name, "fixture", "pass a fixture");
    if (!Owns(s, fixture) || fixture->GetBody() != this) {
        return s.Refuse(ErrorCode::foreignHandle, name, "fixture", "pass a living fixture of this body");
    }
    if (s.locked) return s.Refuse(ErrorCode::locked, name, "world", "destroy fixtures outside of Step");
    const int index = fixture->GetIndex();
    DestroyContactsOfFixture(s, index);
    RemoveProxy(s, index);
    BodyInfo& info = s.bodies.info[Row(m_index)];
    int* link = &info.fixtureHead;
    while (*link != index) link = &s.fixtures.info[Row(*link)].next;
    *link = s.fixtures.info[Row(index)].next;
    --info.fixtureCount;
    s.fixtures.Remove(index);
    ResetMass(s, m_index);
    return ErrorCode::ok;
}

ErrorCode Body::SetTransform(Vec2 position, float angle) {
    WorldState& s = *m_state;
    const char* name = "Body::SetTransform";
    if (s.locked) return s.Refuse(ErrorCode::locked, name, "world", "move bodies outside of Step");
    if (const ErrorCode code = CheckVector(s, position, name, "position"); code != ErrorCode::ok) return code;
    if (const ErrorCode code = CheckNumber(s, angle, name, "angle"); code != ErrorCode::ok) return code;
    const size_t b = Row(m_index);
    s.bodies.transform[b].Set(position, angle);
    s.bodies.position[b] = {Mul(s.bodies.transform[b], s.bodies.mass[b].localCenter), angle, 0.0f};
    s.bodies.startPosition[b] = s.bodies.position[b];
    if (!IsEnabled()) return ErrorCode::ok;
    UpdateBodyBoxes(s.bodies, s.fixtures, m_index, vec2Zero, *s.broadPhase);
    s.pairsStale = true;
    return ErrorCode::ok;
}

const Transform& Body::GetTransform() const { return m_state->bodies.transform[Row(m_index)]; }
Vec2 Body::GetPosition() const { return GetTransform().p; }
float Body::GetAngle() const { return m_state->bodies.position[Row(m_index)].a; }
Vec2 Body::GetWorldCenter() const { return m_state->bodies.position[Row(m_index)].c; }
Vec2 Body::GetLocalCenter() const { return m_state->bodies.mass[Row(m_index)].localCenter; }

ErrorCode Body::SetLinearVelocity(Vec2 v) {
    if (const ErrorCode code = CheckVector(*m_state, v, "Body::SetLinearVelocity", "v"); code != ErrorCode::ok)
        return code;
    if (GetType() == staticBody) return ErrorCode::ok;
    if (Dot(v, v) > 0.0f) m_state->bodies.Wake(m_index);
    m_state->bodies.velocity[Row(m_index)].v = v;
    return ErrorCode::ok;
}
Vec2 Body::GetLinearVelocity() const { return m_state->bodies.velocity[Row(m_index)].v; }

ErrorCode Body::SetAngularVelocity(float omega) {
    if (const ErrorCode code = CheckNumber(*m_state, omega, "Body::SetAngularVelocity", "omega"); code != ErrorCode::ok)
        return code;
    if (GetType() == staticBody) return ErrorCode::ok;
    if (omega * omega > 0.0f) m_state->bodies.Wake(m_index);
    m_state->bodies.velocity[Row(m_index)].w = omega;
    return ErrorCode::ok;
}
float Body::GetAngularVelocity() const { return m_state->bodies.velocity[Row(m_index)].w; }

ErrorCode Body::ApplyForce(Vec2 force, Vec2 point, bool wake) {
    if (const ErrorCode code = CheckVector(*m_state, force, "Body::ApplyForce", "force"); code != ErrorCode::ok)
        return code;
    if (const ErrorCode code = CheckVector(*m_state, point, "Body::ApplyForce", "point"); code != ErrorCode::ok)
        return code;
    if (!TakesPush(m_state->bodies, m_index, wake)) return ErrorCode::ok;
    ForceRow& row = m_state->bodies.force[Row(m_index)];
    row.force += force;
    row.torque += Cross(point - GetWorldCenter(), force);
    return ErrorCode::ok;
}

ErrorCode Body::ApplyForceToCenter(Vec2 force, bool wake) {
    if (const ErrorCode code = CheckVector(*m_state, force, "Body::ApplyForceToCenter", "force"); code != ErrorCode::ok)
        return code;
    if (TakesPush(m_state->bodies, m_index, wake)) m_state->bodies.force[Row(m_index)].force += force;
    return ErrorCode::ok;
}

ErrorCode Body::ApplyTorque(float torque, bool wake) {
    if (const ErrorCode code = CheckNumber(*m_state, torque, "Body::ApplyTorque", "torque"); code != ErrorCode::ok)
        return code;
    if (TakesPush(m_state->bodies, m_index, wake)) m_state->bodies.force[Row(m_index)].torque += torque;
    return ErrorCode::ok;
}

ErrorCode Body::ApplyLinearImpulse(Vec2 impulse, Vec2 point, bool wake) {
    if (const ErrorCode code = CheckVector(*m_state, impulse, "Body::ApplyLinearImpulse", "impulse");
        code != ErrorCode::ok)
        return code;
    if (const ErrorCode code = CheckVector(*m_state, point, "Body::ApplyLinearImpulse", "point"); code != ErrorCode::ok)
        return code;
    if (!TakesPush(m_state->bodies, m_index, wake)) return ErrorCode::ok;
    Velocity& velocity = m_state->bodies.velocity[Row(m_index)];
    const MassRow& mass = m_state->bodies.mass[Row(m_index)];
    velocity.v += mass.invMass * impulse;
    velocity.w += mass.invI * Cross(point - GetWorldCenter(), impulse);
    return ErrorCode::ok;
}

ErrorCode Body::ApplyLinearImpulseToCenter(Vec2 impulse, bool wake) {
    if (const ErrorCode code = CheckVector(*m_state, impulse, "Body::ApplyLinearImpulseToCenter", "impulse");
        code != ErrorCode::ok)
        return code;
    if (TakesPush(m_state->bodies, m_index, wake)) {
        m_state->bodies.velocity[Row(m_index)].v += m_state->bodies.mass[Row(m_index)].invMass * impulse;
    }
    return ErrorCode::ok;
}

ErrorCode Body::ApplyAngularImpulse(float impulse, bool wake) {
    if (const ErrorCode code = CheckNumber(*m_state, impulse, "Body::ApplyAngularImpulse", "impulse");
        code != ErrorCode::ok)
        return code;
    if (TakesPush(m_state->bodies, m_index, wake)) {
        m_state->bodies.velocity[Row(m_index)].w += m_state->bodies.mass[Row(m_index)].invI * impulse;
    }
    return ErrorCode::ok;
}

float Body::GetMass() const { return m_state->bodies.info[Row(m_index)].mass; }
float Body::GetInertia() const {
    const BodyInfo& info = m_state->bodies.info[Row(m_index)];
    const Vec2 center = GetLocalCenter();
    return info.inertia + info.mass * Dot(center, center);
}
void Body::GetMassData(MassData* data) const {
    data->mass = GetMass();
    data->center = GetLocalCenter();
    data->I = GetInertia();
}

ErrorCode Body::SetMassData(const MassData* data) {
    WorldState& s = *m_state;
    const char* name = "Body::SetMassData";
    if (data == nullptr) return s.Refuse(ErrorCode::nullArgument, name, "data", "pass mass data");
    if (s.locked) return s.Refuse(ErrorCode::locked, name, "world", "change masses outside of Step");
    if (const ErrorCode code = CheckNumber(s, data->mass, name, "MassData::mass"); code != ErrorCode::ok) return code;
    if (const ErrorCode code = CheckNumber(s, data->I, name, "MassData::I"); code != ErrorCode::ok) return code;
    if (const ErrorCode code = CheckVector(s, data->center, name, "MassData::center"); code != ErrorCode::ok)
        return code;
    if (GetType() != dynamicBody) return ErrorCode::ok;
    const float mass = data->mass > 0.0f ? data->mass : 1.0f;
    const bool rotates = data->I > 0.0f && !IsFixedRotation();
    const float inertia = rotates ? data->I - mass * Dot(data->center, data->center) : 0.0f;
    if (rotates && inertia <= 0.0f) {
        return s.Refuse(ErrorCode::outOfRange, name, "MassData::I",
                        "it is about the origin: give more than mass·|center|²");
    }
    const size_t b = Row(m_index);
    s.bodies.info[b].mass = mass;
    s.bodies.info[b].inertia = inertia;
    s.bodies.mass[b] = {1.0f / mass, rotates ? 1.0f / inertia : 0.0f, data->center};
    const Vec2 oldCenter = s.bodies.position[b].c;
    s.bodies.position[b].c = Mul(s.bodies.transform[b], data->center);
    s.bodies.startPosition[b] = s.bodies.position[b];
    s.bodies.velocity[b].v += Cross(s.bodies.velocity[b].w, s.bodies.position[b].c - oldCenter);
    return ErrorCode::ok;
}

void Body::ResetMassData() { ResetMass(*m_state, m_index); }

Vec2 Body::GetWorldPoint(Vec2 localPoint) const { return Mul(GetTransform(), localPoint); }
Vec2 Body::GetWorldVector(Vec2 localVector) const { return Mul(GetTransform().q, localVector); }
Vec2 Body::GetLocalPoint(Vec2 worldPoint) const { return MulT(GetTransform(), worldPoint); }
Vec2 Body::GetLocalVector(Vec2 worldVector) const { return MulT(GetTransform().q, worldVector); }
Vec2 Body::GetLinearVelocityFromWorldPoint(Vec2 worldPoint) const {
    return GetLinearVelocity() + Cross(GetAngularVelocity(), worldPoint - GetWorldCenter());
}
Vec2 Body::GetLinearVelocityFromLocalPoint(Vec2 localPoint) const {
    return GetLinearVelocityFromWorldPoint(GetWorldPoint(localPoint));
}

float Body::GetLinearDamping() const { return m_state->bodies.motion[Row(m_index)].linearDamping; }
ErrorCode Body::SetLinearDamping(float damping) {
    const ErrorCode code = CheckAmount(*m_state, damping, "Body::SetLinearDamping", "damping");
    if (code == ErrorCode::ok) m_state->bodies.motion[Row(m_index)].linearDamping = damping;
    return code;
}
float Body::GetAngularDamping() const { return m_state->bodies.motion[Row(m_index)].angularDamping; }
ErrorCode Body::SetAngularDamping(float damping) {
    const ErrorCode code = CheckAmount(*m_state, damping, "Body::SetAngularDamping", "damping");
    if (code == ErrorCode::ok) m_state->bodies.motion[Row(m_index)].angularDamping = damping;
    return code;
}
float Body::GetGravityScale() const { return m_state->bodies.motion[Row(m_index)].gravityScale; }
ErrorCode Body::SetGravityScale(float scale) {
    const ErrorCode code = CheckNumber(*m_state, scale, "Body::SetGravityScale", "scale");
    if (code == ErrorCode::ok) m_state->bodies.motion[Row(m_index)].gravityScale = scale;
    return code;
}

BodyType Body::GetType() const { return m_state->bodies.type[Row(m_index)]; }

ErrorCode Body::SetBullet(bool flag) {
    SetFlag(m_state->bodies, m_index, BodyFlag::bullet, flag);
    return ErrorCode::ok;
}
bool Body::IsBullet() const { return m_state->bodies.Has(m_index, BodyFlag::bullet); }

ErrorCode Body::SetSleepingAllowed(bool flag) {
    SetFlag(m_state->bodies, m_index, BodyFlag::autoSleep, flag);
    if (!flag) m_state->bodies.Wake(m_index);
    return ErrorCode::ok;
}
bool Body::IsSleepingAllowed() const { return m_state->bodies.Has(m_index, BodyFlag::autoSleep); }

ErrorCode Body::SetAwake(bool flag) {
    if (GetType() == staticBody) return ErrorCode::ok;
    flag ? m_state->bodies.Wake(m_index) : m_state->bodies.PutToSleep(m_index);
    return ErrorCode::ok;
}
bool Body::IsAwake() const { return m_state->bodies.Has(m_index, BodyFlag::awake); }

ErrorCode Body::SetEnabled(bool flag) {
    WorldState& s = *m_state;
    if (s.locked) return s.Refuse(ErrorCode::locked, "Body::SetEnabled", "world", "enable bodies outside of Step");
    if (flag == IsEnabled()) return ErrorCode::ok;
    SetFlag(s.bodies, m_index, BodyFlag::enabled, flag);
    if (!flag) DestroyContactsOfBody(s, m_index);
    for (int f = s.bodies.info[Row(m_index)].fixtureHead; f >= 0; f = s.fixtures.info[Row(f)].next) {
        flag ? AddProxy(s, f) : RemoveProxy(s, f);
    }
    return ErrorCode::ok;
}
bool Body::IsEnabled() const { return m_state->bodies.Has(m_index, BodyFlag::enabled); }

ErrorCode Body::SetFixedRotation(bool flag) {
    if (flag == IsFixedRotation()) return ErrorCode::ok;
    SetFlag(m_state->bodies, m_index, BodyFlag::fixedRotation, flag);
    m_state->bodies.velocity[Row(m_index)].w = 0.0f;
    ResetMassData();
    return ErrorCode::ok;
}
bool Body::IsFixedRotation() const { return m_state->bodies.Has(m_index, BodyFlag::fixedRotation); }

Fixture* Body::GetFixtureList() {
    const int head = m_state->bodies.info[Row(m_index)].fixtureHead;
    return head < 0 ? nullptr : &m_state->fixtures.handles[Row(head)];
}
const Fixture* Body::GetFixtureList() const { return const_cast<Body*>(this)->GetFixtureList(); }
Body* Body::GetNext() {
    const int next = m_state->bodies.info[Row(m_index)].listNext;
    return next < 0 ? nullptr : &m_state->bodies.handles[Row(next)];
}
const Body* Body::GetNext() const { return const_cast<Body*>(this)->GetNext(); }
BodyUserData& Body::GetUserData() { return m_state->bodies.info[Row(m_index)].userData; }
World* Body::GetWorld() { return m_state->world; }

}  // namespace scree
