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
    if (!m_manifoldExposed) m_manifold = ToBox2d(*m_handle->GetManifold());
    m_manifoldExposed = b2Bridge::Data(*m_fixtureA->GetBody()).stepping;
    return &m_manifold;
}

const b2Manifold* b2Contact::GetManifold() const {
    if (!m_manifoldExposed) m_manifold = ToBox2d(*m_handle->GetManifold());
    return &m_manifold;
}

void b2Contact::GetWorldManifold(b2WorldManifold* worldManifold) const {
    const b2Fixture& a = *m_fixtureA;
    const b2Fixture& b = *m_fixtureB;
    worldManifold->Initialize(GetManifold(), a.GetBody()->GetTransform(), a.GetShape()->m_radius,
                              b.GetBody()->GetTransform(), b.GetShape()->m_radius);
}

bool b2Contact::IsTouching() const { return m_handle->IsTouching(); }
void b2Contact::SetEnabled(bool flag) { m_handle->SetEnabled(flag); }
bool b2Contact::IsEnabled() const { return m_handle->IsEnabled(); }
b2Contact* b2Contact::GetNext() { return m_next; }
const b2Contact* b2Contact::GetNext() const { return m_next; }
b2Fixture* b2Contact::GetFixtureA() { return m_fixtureA; }
const b2Fixture* b2Contact::GetFixtureA() const { return m_fixtureA; }
int32 b2Contact::GetChildIndexA() const { return m_indexA; }
b2Fixture* b2Contact::GetFixtureB() { return m_fixtureB; }
const b2Fixture* b2Contact::GetFixtureB() const { return m_fixtureB; }
int32 b2Contact::GetChildIndexB() const { return m_indexB; }
void b2Contact::SetFriction(float friction) { m_handle->SetFriction(friction); }
float b2Contact::GetFriction() const { return m_handle->GetFriction(); }
void b2Contact::ResetFriction() { m_handle->ResetFriction(); }
void b2Contact::SetRestitution(float restitution) { m_handle->SetRestitution(restitution); }
float b2Contact::GetRestitution() const { return m_handle->GetRestitution(); }
void b2Contact::ResetRestitution() { m_handle->ResetRestitution(); }
void b2Contact::SetRestitutionThreshold(float threshold) { m_handle->SetRestitutionThreshold(threshold); }
float b2Contact::GetRestitutionThreshold() const { return m_handle->GetRestitutionThreshold(); }
void b2Contact::ResetRestitutionThreshold() { m_handle->ResetRestitutionThreshold(); }
void b2Contact::SetTangentSpeed(float speed) { m_handle->SetTangentSpeed(speed); }
float b2Contact::GetTangentSpeed() const { return m_handle->GetTangentSpeed(); }
