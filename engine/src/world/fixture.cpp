// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The fixture handle.

#include "scree/fixture.h"

#include <utility>

#include "state/frames.h"
#include "world/guard.h"
#include "world/refresh.h"

namespace scree {

namespace {

/// Row of the handle in the columns of the fixture table.
size_t Row(int index) { return static_cast<size_t>(index); }

/// What the fixture would use if it were a sensor, or none.
Features FeaturesAs(WorldState& s, int fixture, bool sensor) {
    uint8_t& own = s.fixtures.isSensor[Row(fixture)];
    const uint8_t before = std::exchange(own, sensor ? 1 : 0);
    const Features f = UnderSettings(FeaturesOfFixture(s.fixtures, s.bodies, fixture), s.def);
    own = before;
    return f;
}

}  // namespace

bool Fixture::Lives(const char* accessor) const {
    return IsAlive(*m_state, m_state->fixtures.slots, m_index, accessor);
}

Shape::Type Fixture::GetType() const {
    return Lives("Fixture::GetType") ? m_state->fixtures.type[Row(m_index)] : Shape::Type{};
}
Shape* Fixture::GetShape() {
    if (!Lives("Fixture::GetShape")) return nullptr;
    m_state->continuousScratch.nearStatics.Disable();
    return m_state->fixtures.GetOwnShape(m_index);
}
const Shape* Fixture::GetShape() const {
    return Lives("Fixture::GetShape") ? m_state->fixtures.shape[Row(m_index)] : nullptr;
}

ErrorCode Fixture::SetShape(const Shape& shape) {
    Guard guard(*m_state, "Fixture::SetShape");
    guard.Living(m_state->fixtures.slots, m_index).Unlocked("set shapes outside of Step and callbacks");
    if (guard.Failed()) return guard.Code();
    guard.Require(shape.GetType() == m_state->fixtures.type[Row(m_index)], ErrorCode::badShape, "shape",
                  "give one of the fixture's type, or make a new fixture");
    if (guard.Failed() || guard.Accept(Check(shape)).Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, shape);
    WithShapeType(shape.GetType(), [&]<typename T>(std::type_identity<T>) {
        static_cast<T&>(*GetShape()) = static_cast<const T&>(shape);
    });
    return ErrorCode::ok;
}

ErrorCode Fixture::SetSensor(bool sensor) {
    Guard guard(*m_state, "Fixture::SetSensor");
    if (guard.Living(m_state->fixtures.slots, m_index).Failed()) return guard.Code();
    if (guard.Uses(FeaturesAs(*m_state, m_index, sensor)).Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, sensor);
    uint8_t& flag = m_state->fixtures.isSensor[Row(m_index)];
    if ((flag != 0) == sensor) return ErrorCode::ok;
    const FixtureFeatureEdit edit(*m_state, m_index);
    flag = sensor ? 1 : 0;
    const int body = m_state->fixtures.body[Row(m_index)];
    ForgetGeometry(*m_state, body);
    ContactTable& contacts = m_state->contacts;
    for (const int c : contacts.OfBody(body)) {
        if (!contacts.IsAlive(c)) continue;
        const ContactPair& p = contacts.pair[Row(c)];
        const bool any = m_state->fixtures.isSensor[p.fixtureA] || m_state->fixtures.isSensor[p.fixtureB];
        contacts.flags[Row(c)] =
            static_cast<uint8_t>((contacts.flags[Row(c)] & ~ContactFlag::sensor) | (any ? ContactFlag::sensor : 0));
    }
    m_state->bodies.Wake(body);
    return ErrorCode::ok;
}
bool Fixture::IsSensor() const {
    return Lives("Fixture::IsSensor") ? m_state->fixtures.isSensor[Row(m_index)] != 0 : false;
}

ErrorCode Fixture::SetFilterData(const Filter& filter) {
    Guard guard(*m_state, "Fixture::SetFilterData");
    guard.Living(m_state->fixtures.slots, m_index).Unlocked("set filters outside of Step and callbacks");
    if (guard.Failed() || guard.Uses(FeaturesOf(filter)).Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, filter);
    const FixtureFeatureEdit edit(*m_state, m_index);
    m_state->fixtures.filter[Row(m_index)] = filter;
    RefilterFixture(*m_state, m_index);
    return ErrorCode::ok;
}
Filter Fixture::GetFilterData() const {
    return Lives("Fixture::GetFilterData") ? m_state->fixtures.filter[Row(m_index)] : Filter{};
}
void Fixture::Refilter() {
    Guard guard(*m_state, "Fixture::Refilter");
    guard.Living(m_state->fixtures.slots, m_index).Unlocked("refilter outside of Step and callbacks");
    if (guard.Failed()) return;
    const Recording recording = guard.Record(m_index);
    RefilterFixture(*m_state, m_index);
}

int Fixture::GetChainId() const {
    return Lives("Fixture::GetChainId") ? m_state->fixtures.info[Row(m_index)].chainId : 0;
}
int Fixture::GetChainIndex() const {
    return Lives("Fixture::GetChainIndex") ? m_state->fixtures.info[Row(m_index)].chainIndex : 0;
}

Body* Fixture::GetBody() {
    return Lives("Fixture::GetBody") ? &m_state->bodies.handles[Row(m_state->fixtures.body[Row(m_index)])] : nullptr;
}
const Body* Fixture::GetBody() const { return const_cast<Fixture*>(this)->GetBody(); }
Fixture* Fixture::GetNext() {
    if (!Lives("Fixture::GetNext")) return nullptr;
    const int next = m_state->fixtures.next[Row(m_index)];
    return next < 0 ? nullptr : &m_state->fixtures.handles[Row(next)];
}
const Fixture* Fixture::GetNext() const { return const_cast<Fixture*>(this)->GetNext(); }
FixtureUserData Fixture::GetUserData() const {
    return Lives("Fixture::GetUserData") ? m_state->fixtures.info[Row(m_index)].userData : FixtureUserData{};
}
ErrorCode Fixture::SetUserData(const FixtureUserData& data) {
    if (!Lives("Fixture::SetUserData")) return ErrorCode::foreignHandle;
    m_state->fixtures.info[Row(m_index)].userData = data;
    return ErrorCode::ok;
}

bool Fixture::TestPoint(Vec2 p) const {
    if (!Lives("Fixture::TestPoint")) return false;
    const BodyPlace place(m_state->bodies, GetBody()->GetIndex());
    return GetShape()->TestPoint(place.xf, p - place.frame);
}
bool Fixture::RayCast(RayCastOutput* output, const RayCastInput& input) const {
    Guard guard(*m_state, "Fixture::RayCast");
    guard.Living(m_state->fixtures.slots, m_index).NotNull(output != nullptr, "output", "pass where to write");
    if (guard.Failed()) return false;
    guard.Finite(input.p1, "RayCastInput::p1");
    guard.Finite(input.p2, "RayCastInput::p2").Amount(input.maxFraction, "RayCastInput::maxFraction");
    const BodyPlace place(m_state->bodies, GetBody()->GetIndex());
    const RayCastInput ray{input.p1 - place.frame, input.p2 - place.frame, input.maxFraction};
    return !guard.Failed() && GetShape()->RayCast(output, ray, place.xf);
}
void Fixture::GetMassData(MassData* massData) const {
    if (!Lives("Fixture::GetMassData")) return;
    Guard guard(*m_state, "Fixture::GetMassData");
    if (guard.NotNull(massData != nullptr, "massData", "pass where to write").Failed()) return;
    GetShape()->ComputeMass(massData, GetDensity());
}

ErrorCode Fixture::SetDensity(float density) {
    Guard guard(*m_state, "Fixture::SetDensity");
    guard.Living(m_state->fixtures.slots, m_index).Amount(density, "density");
    if (guard.Failed() || guard.Accept(CheckMass(*GetShape(), density, "density")).Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, density);
    m_state->fixtures.info[Row(m_index)].density = density;
    return ErrorCode::ok;
}
float Fixture::GetDensity() const {
    return Lives("Fixture::GetDensity") ? m_state->fixtures.info[Row(m_index)].density : 0.0f;
}

ErrorCode Fixture::SetFriction(float friction) {
    Guard guard(*m_state, "Fixture::SetFriction");
    guard.Living(m_state->fixtures.slots, m_index).Amount(friction, "friction");
    if (friction != 0.0f) guard.Uses({Feature::friction});
    if (guard.Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, friction);
    const FixtureFeatureEdit edit(*m_state, m_index);
    m_state->fixtures.material[Row(m_index)].friction = friction;
    return ErrorCode::ok;
}
float Fixture::GetFriction() const {
    return Lives("Fixture::GetFriction") ? m_state->fixtures.material[Row(m_index)].friction : 0.0f;
}

ErrorCode Fixture::SetRestitution(float restitution) {
    Guard guard(*m_state, "Fixture::SetRestitution");
    guard.Living(m_state->fixtures.slots, m_index).Finite(restitution, "restitution");
    if (restitution != 0.0f) guard.Uses({Feature::restitution});
    if (guard.Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, restitution);
    const FixtureFeatureEdit edit(*m_state, m_index);
    m_state->fixtures.material[Row(m_index)].restitution = restitution;
    return ErrorCode::ok;
}
float Fixture::GetRestitution() const {
    return Lives("Fixture::GetRestitution") ? m_state->fixtures.material[Row(m_index)].restitution : 0.0f;
}

ErrorCode Fixture::SetRestitutionThreshold(float threshold) {
    Guard guard(*m_state, "Fixture::SetRestitutionThreshold");
    guard.Living(m_state->fixtures.slots, m_index).Amount(threshold, "threshold");
    if (guard.Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, threshold);
    m_state->fixtures.material[Row(m_index)].restitutionThreshold = threshold;
    return ErrorCode::ok;
}
float Fixture::GetRestitutionThreshold() const {
    return Lives("Fixture::GetRestitutionThreshold") ? m_state->fixtures.material[Row(m_index)].restitutionThreshold
                                                     : 0.0f;
}

AABB Fixture::GetAABB() const {
    if (!Lives("Fixture::GetAABB")) return AABB{};
    if (m_state->fixtures.info[Row(m_index)].inBroadPhase)
        return m_state->broadPhase->GetBox(static_cast<uint32_t>(m_index));
    AABB box;
    GetShape()->ComputeAABB(&box, GetBody()->GetTransform());
    return box;
}

}  // namespace scree
