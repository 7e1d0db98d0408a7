// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// b2Contact: the engine's contact under Box2D's name.

#include "../box2d/b2_contact.h"

#include "convert.h"
#include "world_data.h"

using namespace scree::box2d;

b2Manifold* b2Contact::GetManifold() {
    // In a callback the first call fetches it; what the program then changes must not be fetched over.
    if (m_handle == nullptr) return &m_manifold;
    if (!m_manifoldExposed) m_manifold = ToBox2d(m_handle->GetManifold());
    m_manifoldExposed = b2Bridge::Data(*m_fixtureA->GetBody()).stepping;
    return &m_manifold;
}

const b2Manifold* b2Contact::GetManifold() const {
    if (m_handle != nullptr && !m_manifoldExposed) m_manifold = ToBox2d(m_handle->GetManifold());
    return &m_manifold;
}

void b2Contact::GetWorldManifold(b2WorldManifold* worldManifold) const {
    const b2Fixture& a = *m_fixtureA;
    const b2Fixture& b = *m_fixtureB;
    worldManifold->Initialize(GetManifold(), a.GetBody()->GetTransform(), a.GetShape()->m_radius,
                              b.GetBody()->GetTransform(), b.GetShape()->m_radius);
}

bool b2Contact::IsTouching() const { return m_handle == nullptr || m_handle->IsTouching(); }
void b2Contact::SetEnabled(bool flag) {
    if (m_handle == nullptr) {
        m_enabled = flag;
    } else {
        m_handle->SetEnabled(flag);
    }
}
bool b2Contact::IsEnabled() const { return m_handle != nullptr ? m_handle->IsEnabled() : m_enabled; }
b2Contact* b2Contact::GetNext() { return m_next; }
const b2Contact* b2Contact::GetNext() const { return m_next; }
b2Fixture* b2Contact::GetFixtureA() { return m_fixtureA; }
const b2Fixture* b2Contact::GetFixtureA() const { return m_fixtureA; }
int32 b2Contact::GetChildIndexA() const { return m_indexA; }
b2Fixture* b2Contact::GetFixtureB() { return m_fixtureB; }
const b2Fixture* b2Contact::GetFixtureB() const { return m_fixtureB; }
int32 b2Contact::GetChildIndexB() const { return m_indexB; }

// A contact that is being ended keeps values that nobody will use any more; the engine's contact checks the others.
void b2Contact::SetFriction(float friction) {
    if (m_handle == nullptr) {
        m_friction = friction;
    } else {
        m_handle->SetFriction(friction);
    }
}
float b2Contact::GetFriction() const { return m_handle != nullptr ? m_handle->GetFriction() : m_friction; }
void b2Contact::ResetFriction() {
    if (m_handle != nullptr) return m_handle->ResetFriction();
    m_friction = b2MixFriction(m_fixtureA->GetFriction(), m_fixtureB->GetFriction());
}
void b2Contact::SetRestitution(float restitution) {
    if (m_handle == nullptr) {
        m_restitution = restitution;
    } else {
        m_handle->SetRestitution(restitution);
    }
}
float b2Contact::GetRestitution() const { return m_handle != nullptr ? m_handle->GetRestitution() : m_restitution; }
void b2Contact::ResetRestitution() {
    if (m_handle != nullptr) return m_handle->ResetRestitution();
    m_restitution = b2MixRestitution(m_fixtureA->GetRestitution(), m_fixtureB->GetRestitution());
}
void b2Contact::SetRestitutionThreshold(float threshold) {
    if (m_handle == nullptr) {
        m_restitutionThreshold = threshold;
    } else {
        m_handle->SetRestitutionThreshold(threshold);
    }
}
float b2Contact::GetRestitutionThreshold() const {
    return m_handle != nullptr ? m_handle->GetRestitutionThreshold() : m_restitutionThreshold;
}
void b2Contact::ResetRestitutionThreshold() {
    if (m_handle != nullptr) return m_handle->ResetRestitutionThreshold();
    m_restitutionThreshold =
        b2MixRestitutionThreshold(m_fixtureA->GetRestitutionThreshold(), m_fixtureB->GetRestitutionThreshold());
}
void b2Contact::SetTangentSpeed(float speed) {
    if (m_handle == nullptr) {
        m_tangentSpeed = speed;
    } else {
        m_handle->SetTangentSpeed(speed);
    }
}
float b2Contact::GetTangentSpeed() const { return m_handle != nullptr ? m_handle->GetTangentSpeed() : m_tangentSpeed; }
