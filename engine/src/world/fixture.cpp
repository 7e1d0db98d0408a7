// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The fixture handle.

#include "scree/fixture.h"

#include "world/refresh.h"
#include "world/validate.h"

namespace scree {

namespace {

/// Row of the handle in the columns of the fixture table.
size_t Row(int index) { return static_cast<size_t>(index); }

ErrorCode CheckMaterial(const WorldState& s, float value, bool mayBeNegative, const char* function) {
    if (!std::isfinite(value)) return s.Refuse(ErrorCode::nonFinite, function, "value", "give a finite number");
    if (value < 0.0f && !mayBeNegative)
        return s.Refuse(ErrorCode::outOfRange, function, "value", "give a number of at least 0");
    return ErrorCode::ok;
}

}  // namespace

Shape::Type Fixture::GetType() const { return m_state->fixtures.type[Row(m_index)]; }
Shape* Fixture::GetShape() { return m_state->fixtures.shape[Row(m_index)]; }
const Shape* Fixture::GetShape() const { return m_state->fixtures.shape[Row(m_index)]; }

ErrorCode Fixture::SetSensor(bool sensor) {
    uint8_t& flag = m_state->fixtures.isSensor[Row(m_index)];
    if ((flag != 0) == sensor) return ErrorCode::ok;
    flag = sensor ? 1 : 0;
    ContactTable& contacts = m_state->contacts;
    for (int c = 0; c < contacts.Size(); ++c) {
        const ContactPair& p = contacts.pair[Row(c)];
        const auto self = static_cast<uint32_t>(m_index);
        if (!contacts.Has(c, ContactFlag::alive) || (p.fixtureA != self && p.fixtureB != self)) continue;
        const bool any = m_state->fixtures.isSensor[p.fixtureA] || m_state->fixtures.isSensor[p.fixtureB];
        contacts.flags[Row(c)] =
            static_cast<uint8_t>((contacts.flags[Row(c)] & ~ContactFlag::sensor) | (any ? ContactFlag::sensor : 0));
    }
    m_state->bodies.Wake(m_state->fixtures.body[Row(m_index)]);
    return ErrorCode::ok;
}
bool Fixture::IsSensor() const { return m_state->fixtures.isSensor[Row(m_index)] != 0; }

ErrorCode Fixture::SetFilterData(const Filter& filter) {
    if (m_state->locked)
        return m_state->Refuse(ErrorCode::locked, "Fixture::SetFilterData", "world", "set filters outside of Step");
    m_state->fixtures.filter[Row(m_index)] = filter;
    Refilter();
    return ErrorCode::ok;
}
const Filter& Fixture::GetFilterData() const { return m_state->fixtures.filter[Row(m_index)]; }
void Fixture::Refilter() {
    if (m_state->locked) {
        m_state->Refuse(ErrorCode::locked, "Fixture::Refilter", "world", "refilter outside of Step");
        return;
    }
    RefilterFixture(*m_state, m_index);
}

Body* Fixture::GetBody() { return &m_state->bodies.handles[Row(m_state->fixtures.body[Row(m_index)])]; }
const Body* Fixture::GetBody() const { return const_cast<Fixture*>(this)->GetBody(); }
Fixture* Fixture::GetNext() {
    const int next = m_state->fixtures.info[Row(m_index)].next;
    return next < 0 ? nullptr : &m_state->fixtures.handles[Row(next)];
}
const Fixture* Fixture::GetNext() const { return const_cast<Fixture*>(this)->GetNext(); }
FixtureUserData& Fixture::GetUserData() { return m_state->fixtures.info[Row(m_index)].userData; }

bool Fixture::TestPoint(Vec2 p) const { return GetShape()->TestPoint(GetBody()->GetTransform(), p); }
bool Fixture::RayCast(RayCastOutput* output, const RayCastInput& input) const {
    return GetShape()->RayCast(output, input, GetBody()->GetTransform());
}
void Fixture::GetMassData(MassData* massData) const { GetShape()->ComputeMass(massData, GetDensity()); }

ErrorCode Fixture::SetDensity(float density) {
    const ErrorCode code = CheckMaterial(*m_state, density, false, "Fixture::SetDensity");
    if (code == ErrorCode::ok) m_state->fixtures.info[Row(m_index)].density = density;
    return code;
}
float Fixture::GetDensity() const { return m_state->fixtures.info[Row(m_index)].density; }

ErrorCode Fixture::SetFriction(float friction) {
    const ErrorCode code = CheckMaterial(*m_state, friction, false, "Fixture::SetFriction");
    if (code == ErrorCode::ok) m_state->fixtures.material[Row(m_index)].friction = friction;
    return code;
}
float Fixture::GetFriction() const { return m_state->fixtures.material[Row(m_index)].friction; }

ErrorCode Fixture::SetRestitution(float restitution) {
    const ErrorCode code = CheckMaterial(*m_state, restitution, true, "Fixture::SetRestitution");
    if (code == ErrorCode::ok) m_state->fixtures.material[Row(m_index)].restitution = restitution;
    return code;
}
float Fixture::GetRestitution() const { return m_state->fixtures.material[Row(m_index)].restitution; }

ErrorCode Fixture::SetRestitutionThreshold(float threshold) {
    const ErrorCode code = CheckMaterial(*m_state, threshold, false, "Fixture::SetRestitutionThreshold");
    if (code == ErrorCode::ok) m_state->fixtures.material[Row(m_index)].restitutionThreshold = threshold;
    return code;
}
float Fixture::GetRestitutionThreshold() const { return m_state->fixtures.material[Row(m_index)].restitutionThreshold; }

AABB Fixture::GetAABB() const {
    if (m_state->fixtures.info[Row(m_index)].inBroadPhase)
        return m_state->broadPhase->GetBox(static_cast<uint32_t>(m_index));
    AABB box;
    GetShape()->ComputeAABB(&box, GetBody()->GetTransform());
    return box;
}

}  // namespace scree
