// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The contact handle.

#include "scree/contact.h"

#include <algorithm>

#include "state/frames.h"
#include "world/guard.h"
#include "world/world_state.h"

namespace scree {

namespace {

size_t Row(int index) { return static_cast<size_t>(index); }

/// A contact that is alive, with a number to set.
Guard CheckContact(const WorldState& s, int contact, const char* function) {
    Guard guard(s, function);
    guard.Require(s.contacts.IsAlive(contact), ErrorCode::foreignHandle, "this",
                  "use a contact whose boxes still overlap");
    return guard;
}

/// Friction or restitution of the contact may differ from its fixtures' now.
void NoteEdit(WorldState& s, int contact) {
    s.featureCounts.contactsEdited = true;
    NeedKernels(s, FeaturesOfContact(s.contacts, contact));
}

}  // namespace

Manifold* Contact::GetManifold() { return &m_state->contacts.manifold[Row(m_index)]; }
const Manifold* Contact::GetManifold() const { return &m_state->contacts.manifold[Row(m_index)]; }

void Contact::GetWorldManifold(WorldManifold* worldManifold) const {
    const ContactPair& p = m_state->contacts.pair[Row(m_index)];
    const BodyTable& bodies = m_state->bodies;
    const Vec2 frame = FrameOf(bodies, p.bodyA, p.bodyB);
    worldManifold->Initialize(GetManifold(), TransformIn(frame, bodies, p.bodyA),
                              m_state->fixtures.shape[p.fixtureA]->m_radius, TransformIn(frame, bodies, p.bodyB),
                              m_state->fixtures.shape[p.fixtureB]->m_radius);
    if (bodies.IsFar()) {
        for (Vec2& point : worldManifold->points) point += frame;
    }
}

bool Contact::IsTouching() const { return m_state->contacts.Has(m_index, ContactFlag::touching); }

void Contact::SetEnabled(bool flag) {
    if (CheckContact(*m_state, m_index, "Contact::SetEnabled").Failed()) return;
    const Recording recording(*m_state, "Contact::SetEnabled", m_index, flag);
    uint8_t& flags = m_state->contacts.flags[Row(m_index)];
    flags = static_cast<uint8_t>((flags & ~ContactFlag::enabled) | (flag ? ContactFlag::enabled : 0));
}
bool Contact::IsEnabled() const { return m_state->contacts.Has(m_index, ContactFlag::enabled); }

Contact* Contact::GetNext() {
    ContactTable& contacts = m_state->contacts;
    for (int c = std::min(m_index, contacts.Size()); c-- > 0;) {
        if (contacts.IsAlive(c)) return contacts.Handle(m_state, c);
    }
    return nullptr;
}
const Contact* Contact::GetNext() const { return const_cast<Contact*>(this)->GetNext(); }

Fixture* Contact::GetFixtureA() { return &m_state->fixtures.handles[m_state->contacts.pair[Row(m_index)].fixtureA]; }
const Fixture* Contact::GetFixtureA() const { return const_cast<Contact*>(this)->GetFixtureA(); }
Fixture* Contact::GetFixtureB() { return &m_state->fixtures.handles[m_state->contacts.pair[Row(m_index)].fixtureB]; }
const Fixture* Contact::GetFixtureB() const { return const_cast<Contact*>(this)->GetFixtureB(); }

ErrorCode Contact::SetFriction(float friction) {
    Guard guard = CheckContact(*m_state, m_index, "Contact::SetFriction");
    if (guard.Amount(friction, "friction").Failed()) return guard.Code();
    if (friction != 0.0f && guard.Uses({Feature::friction}).Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, friction);
    m_state->contacts.material[Row(m_index)].friction = friction;
    NoteEdit(*m_state, m_index);
    return ErrorCode::ok;
}
float Contact::GetFriction() const { return m_state->contacts.material[Row(m_index)].friction; }
void Contact::ResetFriction() {
    if (CheckContact(*m_state, m_index, "Contact::ResetFriction").Failed()) return;
    const Recording recording(*m_state, "Contact::ResetFriction", m_index);
    m_state->contacts.material[Row(m_index)].friction =
        MixFriction(GetFixtureA()->GetFriction(), GetFixtureB()->GetFriction());
    NoteEdit(*m_state, m_index);
}

ErrorCode Contact::SetRestitution(float restitution) {
    Guard guard = CheckContact(*m_state, m_index, "Contact::SetRestitution");
    if (guard.Finite(restitution, "restitution").Failed()) return guard.Code();
    if (restitution != 0.0f && guard.Uses({Feature::restitution}).Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, restitution);
    m_state->contacts.material[Row(m_index)].restitution = restitution;
    NoteEdit(*m_state, m_index);
    return ErrorCode::ok;
}
float Contact::GetRestitution() const { return m_state->contacts.material[Row(m_index)].restitution; }
void Contact::ResetRestitution() {
    if (CheckContact(*m_state, m_index, "Contact::ResetRestitution").Failed()) return;
    const Recording recording(*m_state, "Contact::ResetRestitution", m_index);
    m_state->contacts.material[Row(m_index)].restitution =
        MixRestitution(GetFixtureA()->GetRestitution(), GetFixtureB()->GetRestitution());
    NoteEdit(*m_state, m_index);
}

ErrorCode Contact::SetRestitutionThreshold(float threshold) {
    Guard guard = CheckContact(*m_state, m_index, "Contact::SetRestitutionThreshold");
    if (guard.Finite(threshold, "threshold").Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, threshold);
    m_state->contacts.material[Row(m_index)].restitutionThreshold = threshold;
    return ErrorCode::ok;
}
float Contact::GetRestitutionThreshold() const { return m_state->contacts.material[Row(m_index)].restitutionThreshold; }
void Contact::ResetRestitutionThreshold() {
    if (CheckContact(*m_state, m_index, "Contact::ResetRestitutionThreshold").Failed()) return;
    const Recording recording(*m_state, "Contact::ResetRestitutionThreshold", m_index);
    m_state->contacts.material[Row(m_index)].restitutionThreshold =
        MixRestitutionThreshold(GetFixtureA()->GetRestitutionThreshold(), GetFixtureB()->GetRestitutionThreshold());
}

ErrorCode Contact::SetTangentSpeed(float speed) {
    Guard guard = CheckContact(*m_state, m_index, "Contact::SetTangentSpeed");
    if (guard.Finite(speed, "speed").Failed()) return guard.Code();
    if (speed != 0.0f && guard.Uses({Feature::tangentSpeed}).Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, speed);
    m_state->contacts.material[Row(m_index)].tangentSpeed = speed;
    return ErrorCode::ok;
}
float Contact::GetTangentSpeed() const { return m_state->contacts.material[Row(m_index)].tangentSpeed; }

}  // namespace scree
