// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The contact handle.

#include "scree/contact.h"

#include <algorithm>

#include "pipeline/parts/mix_materials.h"
#include "state/frames.h"
#include "world/guard.h"
#include "world/world_state.h"

namespace scree {

namespace {

/// A contact that is alive, with a number to set.
Guard CheckContact(const WorldState& s, ContactIndex contact, const char* function) {
    Guard guard(s, function);
    guard.Require(s.contacts.IsAlive(contact), ErrorCode::foreignHandle, "this",
                  "use a contact whose boxes still overlap");
    return guard;
}

/// What the fixtures' materials make of it.
ContactMaterial MixedMaterial(const WorldState& s, ContactIndex contact) {
    const ContactPair& pair = s.contacts.pair[contact];
    return MixMaterials(pair.fixtureA, pair.fixtureB, s.fixtures, s.mixer);
}

/// Friction or restitution of the contact may differ from its fixtures' now.
void NoteEdit(WorldState& s, ContactIndex contact) {
    s.featureCounts.contactsEdited = true;
    NeedKernels(s, FeaturesOfContact(s.contacts, contact));
}

}  // namespace

bool Contact::Lives(const char* accessor) const { return !CheckContact(*m_state, m_row, accessor).Failed(); }

Manifold Contact::GetManifold() const {
    return Lives("Contact::GetManifold") ? m_state->contacts.manifold[m_row] : Manifold{};
}
ErrorCode Contact::SetManifold(const Manifold& manifold) {
    Guard guard = CheckContact(*m_state, m_row, "Contact::SetManifold");
    guard.Require(manifold.pointCount >= 0 && manifold.pointCount <= maxManifoldPoints, ErrorCode::outOfRange,
                  "pointCount", "give 0, 1 or 2 points");
    guard.Require(manifold.type <= Manifold::e_faceB, ErrorCode::outOfRange, "type",
                  "give e_circles, e_faceA or e_faceB");
    if (guard.Failed()) return guard.Code();
    guard.Finite(manifold.localNormal, "localNormal").Finite(manifold.localPoint, "localPoint");
    for (int i = 0; i < manifold.pointCount; ++i) {
        const ManifoldPoint& p = manifold.points[i];
        guard.Finite(p.localPoint, "points").Finite(p.normalImpulse, "points").Finite(p.tangentImpulse, "points");
    }
    if (guard.Failed()) return guard.Code();
    const Recording recording(Changes::motion, *m_state, "Contact::SetManifold", m_row, manifold);
    m_state->contacts.manifold[m_row] = manifold;
    m_state->contacts.LeaveUnsteady(m_row);
    m_state->contacts.DisableWithoutPoints(m_row);
    ++m_state->contacts.grouping;
    return ErrorCode::ok;
}

void Contact::GetWorldManifold(WorldManifold* worldManifold) const {
    Guard guard = CheckContact(*m_state, m_row, "Contact::GetWorldManifold");
    if (guard.NotNull(worldManifold != nullptr, "worldManifold", "pass where to write").Failed()) return;
    m_state->PlaceManifold(m_row, *worldManifold);
}

void WorldState::PlaceManifold(ContactIndex contact, WorldManifold& placed) const {
    const ContactPair& p = contacts.pair[contact];
    const Vec2 frame = FrameOf(bodies, p.bodyA, p.bodyB);
    placed.Initialize(&contacts.manifold[contact], TransformIn(frame, bodies, p.bodyA),
                      fixtures.shape[p.fixtureA]->m_radius, TransformIn(frame, bodies, p.bodyB),
                      fixtures.shape[p.fixtureB]->m_radius);
    if (!bodies.IsFar()) return;
    for (Vec2& point : placed.points) point += frame;
}

int Contact::GetIndex() const { return ToInt(m_state->contacts.GetNumber(m_row)); }

bool Contact::IsTouching() const {
    return Lives("Contact::IsTouching") ? m_state->contacts.Has(m_row, ContactFlag::touching) : false;
}

void Contact::SetEnabled(bool flag) {
    if (CheckContact(*m_state, m_row, "Contact::SetEnabled").Failed()) return;
    const Recording recording(Changes::motion, *m_state, "Contact::SetEnabled", m_row, flag);
    uint8_t& flags = m_state->contacts.flags[m_row];
    flags = static_cast<uint8_t>((flags & ~ContactFlag::enabled) | (flag ? ContactFlag::enabled : 0));
    m_state->contacts.DisableWithoutPoints(m_row);
}
bool Contact::IsEnabled() const {
    return Lives("Contact::IsEnabled") ? m_state->contacts.Has(m_row, ContactFlag::enabled) : false;
}

Contact* Contact::GetNext() {
    if (!Lives("Contact::GetNext")) return nullptr;
    ContactTable& contacts = m_state->contacts;
    const ContactIndex next = contacts.LastAliveBelow(std::min(m_row, contacts.flags.End()));
    return IsSome(next) ? contacts.Handle(m_state, next) : nullptr;
}
const Contact* Contact::GetNext() const { return const_cast<Contact*>(this)->GetNext(); }

Fixture* Contact::GetFixtureA() {
    return Lives("Contact::GetFixtureA") ? &m_state->fixtures.handles[m_state->contacts.pair[m_row].fixtureA] : nullptr;
}
const Fixture* Contact::GetFixtureA() const { return const_cast<Contact*>(this)->GetFixtureA(); }
Fixture* Contact::GetFixtureB() {
    return Lives("Contact::GetFixtureB") ? &m_state->fixtures.handles[m_state->contacts.pair[m_row].fixtureB] : nullptr;
}
const Fixture* Contact::GetFixtureB() const { return const_cast<Contact*>(this)->GetFixtureB(); }

ErrorCode Contact::SetFriction(float friction) {
    Guard guard = CheckContact(*m_state, m_row, "Contact::SetFriction");
    if (guard.Amount(friction, "friction").Failed()) return guard.Code();
    if (friction != 0.0f && guard.Uses({Feature::friction}).Failed()) return guard.Code();
    const Recording recording = guard.RecordMotion(m_row, friction);
    m_state->contacts.material[m_row].friction = friction;
    NoteEdit(*m_state, m_row);
    return ErrorCode::ok;
}
float Contact::GetFriction() const {
    return Lives("Contact::GetFriction") ? m_state->contacts.material[m_row].friction : 0.0f;
}
void Contact::ResetFriction() {
    if (CheckContact(*m_state, m_row, "Contact::ResetFriction").Failed()) return;
    const Recording recording(Changes::motion, *m_state, "Contact::ResetFriction", m_row);
    m_state->contacts.material[m_row].friction = MixedMaterial(*m_state, m_row).friction;
    NoteEdit(*m_state, m_row);
}

ErrorCode Contact::SetRestitution(float restitution) {
    Guard guard = CheckContact(*m_state, m_row, "Contact::SetRestitution");
    if (guard.Finite(restitution, "restitution").Failed()) return guard.Code();
    if (restitution != 0.0f && guard.Uses({Feature::restitution}).Failed()) return guard.Code();
    const Recording recording = guard.RecordMotion(m_row, restitution);
    m_state->contacts.material[m_row].restitution = restitution;
    NoteEdit(*m_state, m_row);
    return ErrorCode::ok;
}
float Contact::GetRestitution() const {
    return Lives("Contact::GetRestitution") ? m_state->contacts.material[m_row].restitution : 0.0f;
}
void Contact::ResetRestitution() {
    if (CheckContact(*m_state, m_row, "Contact::ResetRestitution").Failed()) return;
    const Recording recording(Changes::motion, *m_state, "Contact::ResetRestitution", m_row);
    m_state->contacts.material[m_row].restitution = MixedMaterial(*m_state, m_row).restitution;
    NoteEdit(*m_state, m_row);
}

ErrorCode Contact::SetRestitutionThreshold(float threshold) {
    Guard guard = CheckContact(*m_state, m_row, "Contact::SetRestitutionThreshold");
    if (guard.Finite(threshold, "threshold").Failed()) return guard.Code();
    const Recording recording = guard.RecordMotion(m_row, threshold);
    m_state->contacts.material[m_row].restitutionThreshold = threshold;
    return ErrorCode::ok;
}
float Contact::GetRestitutionThreshold() const {
    return Lives("Contact::GetRestitutionThreshold") ? m_state->contacts.material[m_row].restitutionThreshold : 0.0f;
}
void Contact::ResetRestitutionThreshold() {
    if (CheckContact(*m_state, m_row, "Contact::ResetRestitutionThreshold").Failed()) return;
    const Recording recording(Changes::motion, *m_state, "Contact::ResetRestitutionThreshold", m_row);
    m_state->contacts.material[m_row].restitutionThreshold = MixedMaterial(*m_state, m_row).restitutionThreshold;
}

ErrorCode Contact::SetTangentSpeed(float speed) {
    Guard guard = CheckContact(*m_state, m_row, "Contact::SetTangentSpeed");
    if (guard.Finite(speed, "speed").Failed()) return guard.Code();
    if (speed != 0.0f && guard.Uses({Feature::tangentSpeed}).Failed()) return guard.Code();
    const Recording recording = guard.RecordMotion(m_row, speed);
    m_state->contacts.material[m_row].tangentSpeed = speed;
    return ErrorCode::ok;
}
float Contact::GetTangentSpeed() const {
    return Lives("Contact::GetTangentSpeed") ? m_state->contacts.material[m_row].tangentSpeed : 0.0f;
}

}  // namespace scree
