// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The contact handle.

#include "scree/contact.h"

#include "world/world_state.h"

namespace scree {

namespace {

size_t Row(int index) { return static_cast<size_t>(index); }

ErrorCode CheckFinite(const WorldState& s, float value, const char* function) {
    return std::isfinite(value) ? ErrorCode::ok
                                : s.Refuse(ErrorCode::nonFinite, function, "value", "give a finite number");
}

}  // namespace

Manifold* Contact::GetManifold() { return &m_state->contacts.manifold[Row(m_index)]; }
const Manifold* Contact::GetManifold() const { return &m_state->contacts.manifold[Row(m_index)]; }

void Contact::GetWorldManifold(WorldManifold* worldManifold) const {
    const ContactPair& p = m_state->contacts.pair[Row(m_index)];
    worldManifold->Initialize(GetManifold(), m_state->bodies.transform[Row(p.bodyA)],
                              m_state->fixtures.shape[p.fixtureA]->m_radius, m_state->bodies.transform[Row(p.bodyB)],
                              m_state->fixtures.shape[p.fixtureB]->m_radius);
}

bool Contact::IsTouching() const { return m_state->contacts.Has(m_index, ContactFlag::touching); }

void Contact::SetEnabled(bool flag) {
    uint8_t& flags = m_state->contacts.flags[Row(m_index)];
    flags = static_cast<uint8_t>((flags & ~ContactFlag::enabled) | (flag ? ContactFlag::enabled : 0));
}
bool Contact::IsEnabled() const { return m_state->contacts.Has(m_index, ContactFlag::enabled); }

Contact* Contact::GetNext() {
    ContactTable& contacts = m_state->contacts;
    for (int c = m_index + 1; c < contacts.Size(); ++c) {
        if (contacts.Has(c, ContactFlag::alive)) return contacts.Handle(m_state, c);
    }
    return nullptr;
}
const Contact* Contact::GetNext() const { return const_cast<Contact*>(this)->GetNext(); }

Fixture* Contact::GetFixtureA() { return &m_state->fixtures.handles[m_state->contacts.pair[Row(m_index)].fixtureA]; }
const Fixture* Contact::GetFixtureA() const { return const_cast<Contact*>(this)->GetFixtureA(); }
Fixture* Contact::GetFixtureB() { return &m_state->fixtures.handles[m_state->contacts.pair[Row(m_index)].fixtureB]; }
const Fixture* Contact::GetFixtureB() const { return const_cast<Contact*>(this)->GetFixtureB(); }

ErrorCode Contact::SetFriction(float friction) {
    if (friction < 0.0f)
        return m_state->Refuse(ErrorCode::outOfRange, "Contact::SetFriction", "friction", "give at least 0");
    const ErrorCode code = CheckFinite(*m_state, friction, "Contact::SetFriction");
    if (code == ErrorCode::ok) m_state->contacts.material[Row(m_index)].friction = friction;
    return code;
}
float Contact::GetFriction() const { return m_state->contacts.material[Row(m_index)].friction; }
void Contact::ResetFriction() {
    m_state->contacts.material[Row(m_index)].friction =
        MixFriction(GetFixtureA()->GetFriction(), GetFixtureB()->GetFriction());
}

ErrorCode Contact::SetRestitution(float restitution) {
    const ErrorCode code = CheckFinite(*m_state, restitution, "Contact::SetRestitution");
    if (code == ErrorCode::ok) m_state->contacts.material[Row(m_index)].restitution = restitution;
    return code;
}
float Contact::GetRestitution() const { return m_state->contacts.material[Row(m_index)].restitution; }
void Contact::ResetRestitution() {
    m_state->contacts.material[Row(m_index)].restitution =
        MixRestitution(GetFixtureA()->GetRestitution(), GetFixtureB()->GetRestitution());
}

ErrorCode Contact::SetRestitutionThreshold(float threshold) {
    const ErrorCode code = CheckFinite(*m_state, threshold, "Contact::SetRestitutionThreshold");
    if (code == ErrorCode::ok) m_state->contacts.material[Row(m_index)].restitutionThreshold = threshold;
    return code;
}
float Contact::GetRestitutionThreshold() const { return m_state->contacts.material[Row(m_index)].restitutionThreshold; }
void Contact::ResetRestitutionThreshold() {
    m_state->contacts.material[Row(m_index)].restitutionThreshold =
        MixRestitutionThreshold(GetFixtureA()->GetRestitutionThreshold(), GetFixtureB()->GetRestitutionThreshold());
}

ErrorCode Contact::SetTangentSpeed(float speed) {
    const ErrorCode code = CheckFinite(*m_state, speed, "Contact::SetTangentSpeed");
    if (code == ErrorCode::ok) m_state->contacts.material[Row(m_index)].tangentSpeed = speed;
    return code;
}
float Contact::GetTangentSpeed() const { return m_state->contacts.material[Row(m_index)].tangentSpeed; }

}  // namespace scree
