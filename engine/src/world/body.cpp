// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The body handle: its own state. Edits that reach other tables are in body_edit.cpp.

#include "scree/body.h"

#include <vector>

#include "world/guard.h"
#include "world/refresh.h"

namespace scree {

namespace {

/// True if an impulse reaches the body: dynamic, and awake or woken by it.
bool TakesImpulse(BodyTable& bodies, BodyIndex body, bool wake) {
    if (bodies.type[body] != dynamicBody) return false;
    if (wake && !bodies.Has(body, BodyFlag::awake)) bodies.Wake(body);
    return bodies.Has(body, BodyFlag::awake);
}

/// The same for a force, which the step has to look at.
bool TakesForce(WorldState& s, BodyIndex body, bool wake) {
    if (!TakesImpulse(s.bodies, body, wake)) return false;
    s.featureCounts.forces = true;
    NeedKernels(s, {Feature::forces});
    return true;
}

/// What the body's force and torque would add up to.
ForceRow AddForce(const WorldState& s, BodyIndex body, Vec2 force, float torque) {
    ForceRow row = s.bodies.GetForce(body);
    row.force += force;
    row.torque += torque;
    return row;
}

/// What the body's velocity would become.
Velocity AddImpulse(const WorldState& s, BodyIndex body, Vec2 impulse, float turn) {
    Velocity velocity = s.bodies.velocity[body];
    velocity.v += s.bodies.mass[body].invMass * impulse;
    velocity.w += s.bodies.mass[body].invI * turn;
    return velocity;
}

Guard& RequireSum(Guard& guard, const ForceRow& sum, const char* field) {
    return guard.Require(sum.force.IsValid() && std::isfinite(sum.torque), ErrorCode::outOfRange, field,
                         "give less: the sum is not finite");
}
Guard& RequireSum(Guard& guard, const Velocity& sum, const char* field) {
    return guard.Require(IsInRange(sum.v) && IsInRange(sum.w), ErrorCode::outOfRange, field,
                         "give less: the velocity would exceed 1e18");
}

void SetFlag(BodyTable& bodies, BodyIndex body, uint16_t flag, bool on) {
    uint16_t& flags = bodies.flags[body];
    flags = static_cast<uint16_t>(on ? flags | flag : flags & ~flag);
}

}  // namespace

bool Body::Lives(const char* accessor) const { return IsAlive(*m_state, m_state->bodies.slots, m_index, accessor); }

Transform Body::GetTransform() const {
    if (Lives("Body::GetTransform")) return m_state->bodies.transform[m_index];
    Transform identity;
    identity.SetIdentity();
    return identity;
}
Vec2 Body::GetPosition() const { return Lives("Body::GetPosition") ? GetTransform().p : vec2Zero; }
float Body::GetAngle() const { return Lives("Body::GetAngle") ? m_state->bodies.position[m_index].a : 0.0f; }
Vec2 Body::GetWorldCenter() const {
    return Lives("Body::GetWorldCenter") ? m_state->bodies.position[m_index].c : vec2Zero;
}
Vec2 Body::GetPositionRest() const {
    return Lives("Body::GetPositionRest") ? m_state->bodies.GetOriginRest(m_index) : vec2Zero;
}
Vec2 Body::GetWorldCenterRest() const {
    return Lives("Body::GetWorldCenterRest") ? m_state->bodies.GetRest(m_index) : vec2Zero;
}
Vec2 Body::FromCentre(Vec2 worldPoint) const { return worldPoint - GetWorldCenter() - GetWorldCenterRest(); }
Vec2 Body::GetLocalCenter() const {
    return Lives("Body::GetLocalCenter") ? m_state->bodies.mass[m_index].localCenter : vec2Zero;
}

ErrorCode Body::SetLinearVelocity(Vec2 v) {
    Guard guard(*m_state, "Body::SetLinearVelocity");
    if (guard.Living(m_state->bodies.slots, m_index).Near(v, "v").Failed()) return guard.Code();
    const Recording recording = guard.RecordMotion(m_index, v);
    if (GetType() == staticBody) return ErrorCode::ok;
    if (Dot(v, v) > 0.0f) m_state->bodies.Wake(m_index);
    m_state->bodies.velocity[m_index].v = v;
    return ErrorCode::ok;
}
Vec2 Body::GetLinearVelocity() const {
    return Lives("Body::GetLinearVelocity") ? m_state->bodies.velocity[m_index].v : vec2Zero;
}

ErrorCode Body::SetAngularVelocity(float omega) {
    Guard guard(*m_state, "Body::SetAngularVelocity");
    if (guard.Living(m_state->bodies.slots, m_index).Near(omega, "omega").Failed()) return guard.Code();
    if (omega != 0.0f && !guard.Failed() && GetType() != staticBody && guard.Uses({Feature::rotation}).Failed())
        return guard.Code();
    const Recording recording = guard.RecordMotion(m_index, omega);
    if (GetType() == staticBody) return ErrorCode::ok;
    if (omega * omega > 0.0f) m_state->bodies.Wake(m_index);
    m_state->bodies.velocity[m_index].w = omega;
    return ErrorCode::ok;
}
float Body::GetAngularVelocity() const {
    return Lives("Body::GetAngularVelocity") ? m_state->bodies.velocity[m_index].w : 0.0f;
}

ErrorCode Body::ApplyForce(Vec2 force, Vec2 point, bool wake) {
    Guard guard(*m_state, "Body::ApplyForce");
    if (guard.Living(m_state->bodies.slots, m_index).Finite(force, "force").Finite(point, "point").Failed())
        return guard.Code();
    if (GetType() == dynamicBody && guard.Uses({Feature::forces}).Failed()) return guard.Code();
    const ForceRow sum = AddForce(*m_state, m_index, force, Cross(FromCentre(point), force));
    if (RequireSum(guard, sum, "force").Failed()) return guard.Code();
    const Recording recording = guard.RecordMotion(m_index, force, point, wake);
    if (TakesForce(*m_state, m_index, wake)) m_state->bodies.force[m_index] = sum;
    return ErrorCode::ok;
}

ErrorCode Body::ApplyForceToCenter(Vec2 force, bool wake) {
    Guard guard(*m_state, "Body::ApplyForceToCenter");
    if (guard.Living(m_state->bodies.slots, m_index).Finite(force, "force").Failed()) return guard.Code();
    if (GetType() == dynamicBody && guard.Uses({Feature::forces}).Failed()) return guard.Code();
    const ForceRow sum = AddForce(*m_state, m_index, force, 0.0f);
    if (RequireSum(guard, sum, "force").Failed()) return guard.Code();
    const Recording recording = guard.RecordMotion(m_index, force, wake);
    if (TakesForce(*m_state, m_index, wake)) m_state->bodies.force[m_index] = sum;
    return ErrorCode::ok;
}

ErrorCode Body::ApplyTorque(float torque, bool wake) {
    Guard guard(*m_state, "Body::ApplyTorque");
    if (guard.Living(m_state->bodies.slots, m_index).Finite(torque, "torque").Failed()) return guard.Code();
    if (GetType() == dynamicBody && guard.Uses({Feature::forces}).Failed()) return guard.Code();
    const ForceRow sum = AddForce(*m_state, m_index, vec2Zero, torque);
    if (RequireSum(guard, sum, "torque").Failed()) return guard.Code();
    const Recording recording = guard.RecordMotion(m_index, torque, wake);
    if (TakesForce(*m_state, m_index, wake)) m_state->bodies.force[m_index] = sum;
    return ErrorCode::ok;
}

ErrorCode Body::ApplyLinearImpulse(Vec2 impulse, Vec2 point, bool wake) {
    Guard guard(*m_state, "Body::ApplyLinearImpulse");
    if (guard.Living(m_state->bodies.slots, m_index).Finite(impulse, "impulse").Finite(point, "point").Failed())
        return guard.Code();
    const Velocity sum = AddImpulse(*m_state, m_index, impulse, Cross(FromCentre(point), impulse));
    if (RequireSum(guard, sum, "impulse").Failed()) return guard.Code();
    const Recording recording = guard.RecordMotion(m_index, impulse, point, wake);
    if (TakesImpulse(m_state->bodies, m_index, wake)) m_state->bodies.velocity[m_index] = sum;
    return ErrorCode::ok;
}

ErrorCode Body::ApplyLinearImpulseToCenter(Vec2 impulse, bool wake) {
    Guard guard(*m_state, "Body::ApplyLinearImpulseToCenter");
    if (guard.Living(m_state->bodies.slots, m_index).Finite(impulse, "impulse").Failed()) return guard.Code();
    const Velocity sum = AddImpulse(*m_state, m_index, impulse, 0.0f);
    if (RequireSum(guard, sum, "impulse").Failed()) return guard.Code();
    const Recording recording = guard.RecordMotion(m_index, impulse, wake);
    if (TakesImpulse(m_state->bodies, m_index, wake)) m_state->bodies.velocity[m_index] = sum;
    return ErrorCode::ok;
}

ErrorCode Body::ApplyAngularImpulse(float impulse, bool wake) {
    Guard guard(*m_state, "Body::ApplyAngularImpulse");
    if (guard.Living(m_state->bodies.slots, m_index).Finite(impulse, "impulse").Failed()) return guard.Code();
    const Velocity sum = AddImpulse(*m_state, m_index, vec2Zero, impulse);
    if (RequireSum(guard, sum, "impulse").Failed()) return guard.Code();
    const Recording recording = guard.RecordMotion(m_index, impulse, wake);
    if (TakesImpulse(m_state->bodies, m_index, wake)) m_state->bodies.velocity[m_index] = sum;
    return ErrorCode::ok;
}

float Body::GetMass() const { return Lives("Body::GetMass") ? m_state->bodies.motion[m_index].mass : 0.0f; }
float Body::GetInertia() const {
    if (!Lives("Body::GetInertia")) return 0.0f;
    const BodyInfo& info = m_state->bodies.info[m_index];
    const Vec2 center = GetLocalCenter();
    return info.inertia + m_state->bodies.motion[m_index].mass * Dot(center, center);
}
void Body::GetMassData(MassData* data) const {
    if (!Lives("Body::GetMassData")) return;
    Guard guard(*m_state, "Body::GetMassData");
    if (guard.NotNull(data != nullptr, "data", "pass where to write").Failed()) return;
    data->mass = GetMass();
    data->center = GetLocalCenter();
    data->I = GetInertia();
}

Vec2 Body::GetWorldPoint(Vec2 localPoint) const {
    return Lives("Body::GetWorldPoint") ? Mul(GetTransform(), localPoint) : vec2Zero;
}
Vec2 Body::GetWorldVector(Vec2 localVector) const {
    return Lives("Body::GetWorldVector") ? Mul(GetTransform().q, localVector) : vec2Zero;
}
Vec2 Body::GetLocalPoint(Vec2 worldPoint) const {
    if (!Lives("Body::GetLocalPoint")) return vec2Zero;
    return MulT(GetTransform().q, worldPoint - GetPosition() - GetPositionRest());
}
Vec2 Body::GetLocalVector(Vec2 worldVector) const {
    return Lives("Body::GetLocalVector") ? MulT(GetTransform().q, worldVector) : vec2Zero;
}
Vec2 Body::GetLinearVelocityFromWorldPoint(Vec2 worldPoint) const {
    if (!Lives("Body::GetLinearVelocityFromWorldPoint")) return vec2Zero;
    return GetLinearVelocity() + Cross(GetAngularVelocity(), FromCentre(worldPoint));
}
Vec2 Body::GetLinearVelocityFromLocalPoint(Vec2 localPoint) const {
    if (!Lives("Body::GetLinearVelocityFromLocalPoint")) return vec2Zero;
    if (!m_state->bodies.IsFar()) return GetLinearVelocityFromWorldPoint(GetWorldPoint(localPoint));
    return GetLinearVelocity() + Cross(GetAngularVelocity(), GetWorldVector(localPoint - GetLocalCenter()));
}

float Body::GetLinearDamping() const {
    return Lives("Body::GetLinearDamping") ? m_state->bodies.motion[m_index].linearDamping : 0.0f;
}
ErrorCode Body::SetLinearDamping(float damping) {
    Guard guard(*m_state, "Body::SetLinearDamping");
    guard.Living(m_state->bodies.slots, m_index).Amount(damping, "damping");
    if (damping != 0.0f && !guard.Failed() && GetType() == dynamicBody) guard.Uses({Feature::damping});
    if (guard.Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, damping);
    const BodyFeatureEdit edit(*m_state, m_index);
    m_state->bodies.motion[m_index].linearDamping = damping;
    return ErrorCode::ok;
}
float Body::GetAngularDamping() const {
    return Lives("Body::GetAngularDamping") ? m_state->bodies.motion[m_index].angularDamping : 0.0f;
}
ErrorCode Body::SetAngularDamping(float damping) {
    Guard guard(*m_state, "Body::SetAngularDamping");
    guard.Living(m_state->bodies.slots, m_index).Amount(damping, "damping");
    if (damping != 0.0f && !guard.Failed() && GetType() == dynamicBody) guard.Uses({Feature::damping});
    if (guard.Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, damping);
    const BodyFeatureEdit edit(*m_state, m_index);
    m_state->bodies.motion[m_index].angularDamping = damping;
    return ErrorCode::ok;
}
float Body::GetGravityScale() const {
    return Lives("Body::GetGravityScale") ? m_state->bodies.motion[m_index].gravityScale : 0.0f;
}
ErrorCode Body::SetGravityScale(float scale) {
    Guard guard(*m_state, "Body::SetGravityScale");
    guard.Living(m_state->bodies.slots, m_index).Finite(scale, "scale");
    if (scale != 1.0f && !guard.Failed() && GetType() == dynamicBody) guard.Uses({Feature::gravityScale});
    if (guard.Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, scale);
    const BodyFeatureEdit edit(*m_state, m_index);
    m_state->bodies.motion[m_index].gravityScale = scale;
    return ErrorCode::ok;
}

BodyType Body::GetType() const { return Lives("Body::GetType") ? m_state->bodies.type[m_index] : BodyType{}; }

ErrorCode Body::SetBullet(bool flag) {
    Guard guard(*m_state, "Body::SetBullet");
    if (guard.Living(m_state->bodies.slots, m_index).Failed()) return guard.Code();
    if (flag && GetType() == dynamicBody) guard.Uses(UnderSettings({Feature::continuousBullet}, m_state->def));
    if (guard.Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, flag);
    const BodyFeatureEdit edit(*m_state, m_index);
    SetFlag(m_state->bodies, m_index, BodyFlag::bullet, flag);
    m_state->bodies.NoteTarget(m_index);
    return ErrorCode::ok;
}
bool Body::IsBullet() const { return Lives("Body::IsBullet") ? m_state->bodies.Has(m_index, BodyFlag::bullet) : false; }

ErrorCode Body::SetSleepingAllowed(bool flag) {
    Guard guard(*m_state, "Body::SetSleepingAllowed");
    if (guard.Living(m_state->bodies.slots, m_index).Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, flag);
    const BodyFeatureEdit edit(*m_state, m_index);
    SetFlag(m_state->bodies, m_index, BodyFlag::autoSleep, flag);
    if (!flag) m_state->bodies.Wake(m_index);
    return ErrorCode::ok;
}
bool Body::IsSleepingAllowed() const {
    return Lives("Body::IsSleepingAllowed") ? m_state->bodies.Has(m_index, BodyFlag::autoSleep) : false;
}

ErrorCode Body::SetAwake(bool flag) {
    Guard guard(*m_state, "Body::SetAwake");
    if (guard.Living(m_state->bodies.slots, m_index).Failed()) return guard.Code();
    if (!flag && GetType() != staticBody && guard.Uses({Feature::sleeping}).Failed()) return guard.Code();
    const Recording recording = guard.RecordMotion(m_index, flag);
    if (GetType() == staticBody) return ErrorCode::ok;
    if (flag) {
        m_state->bodies.Wake(m_index);
        return ErrorCode::ok;
    }
    m_state->bodies.PutToSleep(m_index);
    // What it had before it in a sub-stepped step is over.
    if (m_state->continuousScratch.resuming && !m_state->IsLocked()) m_state->bodies.NoteStart(m_index);
    return ErrorCode::ok;
}
bool Body::IsAwake() const { return Lives("Body::IsAwake") ? m_state->bodies.Has(m_index, BodyFlag::awake) : false; }

bool Body::IsEnabled() const {
    return Lives("Body::IsEnabled") ? m_state->bodies.Has(m_index, BodyFlag::enabled) : false;
}

ErrorCode Body::SetFixedRotation(bool flag) {
    Guard guard(*m_state, "Body::SetFixedRotation");
    if (guard.Living(m_state->bodies.slots, m_index).Failed()) return guard.Code();
    if (!flag && GetType() != staticBody && guard.Uses({Feature::rotation}).Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, flag);
    if (flag == IsFixedRotation()) return ErrorCode::ok;
    const BodyFeatureEdit edit(*m_state, m_index);
    SetFlag(m_state->bodies, m_index, BodyFlag::fixedRotation, flag);
    m_state->bodies.velocity[m_index].w = 0.0f;
    ResetMassData();
    return ErrorCode::ok;
}
bool Body::IsFixedRotation() const {
    return Lives("Body::IsFixedRotation") ? m_state->bodies.Has(m_index, BodyFlag::fixedRotation) : false;
}

ErrorCode Body::SetMotionLocks(const MotionLocks& locks) {
    Guard guard(*m_state, "Body::SetMotionLocks");
    if (guard.Living(m_state->bodies.slots, m_index).Failed()) return guard.Code();
    if (GetType() == dynamicBody && (locks.x || locks.y)) guard.Uses({Feature::motionLocks});
    if (GetType() != staticBody && !locks.angle) guard.Uses({Feature::rotation});
    if (guard.Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, locks);
    if (locks == GetMotionLocks()) return ErrorCode::ok;
    SetFixedRotation(locks.angle);
    const BodyFeatureEdit edit(*m_state, m_index);
    SetFlag(m_state->bodies, m_index, BodyFlag::lockX, locks.x);
    SetFlag(m_state->bodies, m_index, BodyFlag::lockY, locks.y);
    if (GetType() != dynamicBody) return ErrorCode::ok;
    Vec2& v = m_state->bodies.velocity[m_index].v;
    v = {locks.x ? 0.0f : v.x, locks.y ? 0.0f : v.y};
    m_state->bodies.Wake(m_index);
    return ErrorCode::ok;
}
MotionLocks Body::GetMotionLocks() const {
    if (!Lives("Body::GetMotionLocks")) return {};
    const BodyTable& bodies = m_state->bodies;
    return {bodies.Has(m_index, BodyFlag::lockX), bodies.Has(m_index, BodyFlag::lockY),
            bodies.Has(m_index, BodyFlag::fixedRotation)};
}

ErrorCode Body::SetTargetTransform(Vec2 position, float angle, float timeStep) {
    Guard guard(*m_state, "Body::SetTargetTransform");
    guard.Living(m_state->bodies.slots, m_index).Near(position, "position").Near(angle, "angle");
    guard.Require(timeStep >= shortestStep && std::isfinite(timeStep), ErrorCode::outOfRange, "timeStep",
                  "give the time of the coming step, in seconds");
    if (guard.Failed()) return guard.Code();
    guard.Require(GetType() != staticBody, ErrorCode::outOfRange, "this",
                  "static bodies do not move: use SetTransform");
    const Vec2 arm = Mul(Rot(angle), GetLocalCenter());
    const Vec2 v = (1.0f / timeStep) * ((position - GetWorldCenter() - GetWorldCenterRest()) + arm);
    const float w = (angle - GetAngle()) / timeStep;
    guard.Require(IsInRange(v) && IsInRange(w), ErrorCode::outOfRange, "position",
                  "give less way or more time: the velocity would exceed 1e18");
    if (w != 0.0f) guard.Uses({Feature::rotation});
    if (guard.Failed()) return guard.Code();
    const Recording recording = guard.RecordMotion(m_index, position, angle, timeStep);
    SetLinearVelocity(v);
    return SetAngularVelocity(w);
}

Fixture* Body::GetFixtureList() {
    if (!Lives("Body::GetFixtureList")) return nullptr;
    const FixtureIndex head = m_state->bodies.fixtureHead[m_index];
    return IsNone(head) ? nullptr : &m_state->fixtures.handles[head];
}
const Fixture* Body::GetFixtureList() const { return const_cast<Body*>(this)->GetFixtureList(); }
int Body::GetContactCount() const {
    return Lives("Body::GetContactCount") ? m_state->contacts.CountOfBody(m_index) : 0;
}

void Body::VisitContacts(FunctionRef<bool(Contact*)> visit) const {
    Guard guard(*m_state, "Body::VisitContacts");
    guard.Living(m_state->bodies.slots, m_index);
    if (guard.NotNull(visit != nullptr, "visit", "pass a function").Failed()) return;
    const WorldLock lock(*m_state);
    std::vector<ContactIndex> rows;
    m_state->contacts.ListOfBody(m_index, rows);
    for (const ContactIndex c : rows) {
        if (m_state->contacts.IsAlive(c) && !visit(m_state->contacts.Handle(m_state, c))) return;
    }
}

Joint* Body::GetJointList() const {
    if (!Lives("Body::GetJointList")) return nullptr;
    const JointIndex front = m_state->joints.OfBody(m_index).Front();
    return IsNone(front) ? nullptr : m_state->joints.handles[front];
}
int Body::GetJointCount() const { return Lives("Body::GetJointCount") ? m_state->bodies.info[m_index].jointCount : 0; }

void Body::VisitJoints(FunctionRef<bool(Joint*)> visit) const {
    Guard guard(*m_state, "Body::VisitJoints");
    guard.Living(m_state->bodies.slots, m_index);
    if (guard.NotNull(visit != nullptr, "visit", "pass a function").Failed() || GetJointCount() == 0) return;
    const WorldLock lock(*m_state);
    for (const JointIndex j : m_state->joints.OfBody(m_index)) {
        if (!visit(m_state->joints.handles[j])) return;
    }
}

Body* Body::GetNext() {
    if (!Lives("Body::GetNext")) return nullptr;
    const BodyIndex next = m_state->bodies.info[m_index].listNext;
    return IsNone(next) ? nullptr : &m_state->bodies.handles[next];
}
const Body* Body::GetNext() const { return const_cast<Body*>(this)->GetNext(); }
BodyUserData Body::GetUserData() const {
    return Lives("Body::GetUserData") ? m_state->bodies.info[m_index].userData : BodyUserData{};
}
ErrorCode Body::SetUserData(const BodyUserData& data) {
    if (!Lives("Body::SetUserData")) return ErrorCode::foreignHandle;
    m_state->definitions.Note();
    m_state->bodies.info[m_index].userData = data;
    return ErrorCode::ok;
}
World* Body::GetWorld() { return m_state->world; }

}  // namespace scree
