// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The fixture handle.

#include "scree/fixture.h"

#include <utility>
#include <vector>

#include "pipeline/parts/mix_materials.h"
#include "state/frames.h"
#include "world/guard.h"
#include "world/refresh.h"

namespace scree {

namespace {

/// What the fixture would use if it were a sensor, or none.
Features FeaturesAs(WorldState& s, FixtureIndex fixture, bool sensor) {
    uint8_t& own = s.fixtures.isSensor[fixture];
    const uint8_t before = std::exchange(own, sensor ? 1 : 0);
    const Features f = UnderSettings(FeaturesOfFixture(s.fixtures, s.bodies, fixture), s.def);
    own = before;
    return f;
}

/// Brackets a change of a fixture's material: its contacts take over what they have by mixing, and bodies that feel a
/// change there wake.
class MaterialEdit {
public:
    MaterialEdit(WorldState& state, FixtureIndex fixture, bool newContactsOnly)
        : m_state(state), m_fixture(fixture), m_rolling(Own().rollingResistance), m_features(state, fixture) {
        if (newContactsOnly) return;
        std::vector<ContactIndex> contacts;
        m_state.contacts.ListOfBody(m_state.fixtures.body[fixture], contacts);
        for (const ContactIndex contact : contacts) {
            if (m_state.contacts.IsAlive(contact) && HasFixture(contact)) m_before.push_back({contact, Mixed(contact)});
        }
    }
    ~MaterialEdit() {
        for (const auto& [contact, before] : m_before) {
            const bool changed = TakeOver(before, Mixed(contact), m_state.contacts.material[contact]);
            if (!changed && Own().rollingResistance == m_rolling) continue;
            m_state.featureCounts.contactsEdited = true;
            NeedKernels(m_state, FeaturesOfContact(m_state.contacts, contact));
            if (!m_state.contacts.Has(contact, ContactFlag::touching)) continue;
            const ContactPair& pair = m_state.contacts.pair[contact];
            m_state.bodies.Wake(pair.bodyA), m_state.bodies.Wake(pair.bodyB);
        }
    }
    MaterialEdit(const MaterialEdit&) = delete;
    MaterialEdit& operator=(const MaterialEdit&) = delete;

private:
    struct Before {
        ContactIndex contact;
        ContactMaterial mixed;
    };

    [[nodiscard]] const Material& Own() const { return m_state.fixtures.material[m_fixture]; }
    [[nodiscard]] bool HasFixture(ContactIndex contact) const {
        const ContactPair& pair = m_state.contacts.pair[contact];
        return pair.fixtureA == m_fixture || pair.fixtureB == m_fixture;
    }
    [[nodiscard]] ContactMaterial Mixed(ContactIndex contact) const {
        const ContactPair& pair = m_state.contacts.pair[contact];
        return MixMaterials(pair.fixtureA, pair.fixtureB, m_state.fixtures, m_state.mixer);
    }
    /// A number that is not what mixing gave was given to the contact itself. Returns whether one has changed.
    static bool TakeOver(const ContactMaterial& before, const ContactMaterial& now, ContactMaterial& material) {
        bool changed = false;
        for (float ContactMaterial::*const number :
             {&ContactMaterial::friction, &ContactMaterial::restitution, &ContactMaterial::restitutionThreshold,
              &ContactMaterial::tangentSpeed}) {
            if (material.*number != before.*number || now.*number == before.*number) continue;
            material.*number = now.*number;
            changed = true;
        }
        return changed;
    }

    WorldState& m_state;
    FixtureIndex m_fixture;
    float m_rolling;
    std::vector<Before> m_before;
    FixtureFeatureEdit m_features;
};

}  // namespace

bool Fixture::Lives(const char* accessor) const {
    return IsAlive(*m_state, m_state->fixtures.slots, m_index, accessor);
}

Shape::Type Fixture::GetType() const {
    return Lives("Fixture::GetType") ? m_state->fixtures.type[m_index] : Shape::Type{};
}
Shape* Fixture::GetShape() {
    if (!Lives("Fixture::GetShape")) return nullptr;
    m_state->continuousScratch.nearStatics.Disable();
    m_state->definitions.Lose();
    return m_state->fixtures.GetOwnShape(m_index);
}
const Shape* Fixture::GetShape() const {
    return Lives("Fixture::GetShape") ? m_state->fixtures.shape[m_index] : nullptr;
}

ErrorCode Fixture::SetShape(const Shape& shape) {
    Guard guard(*m_state, "Fixture::SetShape");
    guard.Living(m_state->fixtures.slots, m_index).Unlocked("set shapes outside of Step and callbacks");
    if (guard.Failed()) return guard.Code();
    guard.Require(shape.GetType() == m_state->fixtures.type[m_index], ErrorCode::badShape, "shape",
                  "give one of the fixture's type, or make a new fixture");
    if (guard.Failed() || guard.Accept(Check(shape)).Failed()) return guard.Code();
    const float density = m_state->fixtures.info[m_index].density;
    if (guard.Accept(CheckMass(shape, density, "shape")).Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, shape);
    WithShapeType(shape.GetType(), [&]<typename T>(std::type_identity<T>) {
        static_cast<T&>(*m_state->fixtures.GetOwnShape(m_index)) = static_cast<const T&>(shape);
    });
    ScaleDefaultSkin(*m_state, m_index);
    NoteShapeEdit(*m_state, m_index);
    return ErrorCode::ok;
}

ErrorCode Fixture::SetSensor(bool sensor) {
    Guard guard(*m_state, "Fixture::SetSensor");
    if (guard.Living(m_state->fixtures.slots, m_index).Failed()) return guard.Code();
    if (guard.Uses(FeaturesAs(*m_state, m_index, sensor)).Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, sensor);
    uint8_t& flag = m_state->fixtures.isSensor[m_index];
    if ((flag != 0) == sensor) return ErrorCode::ok;
    const FixtureFeatureEdit edit(*m_state, m_index);
    flag = sensor ? 1 : 0;
    const BodyIndex body = m_state->fixtures.body[m_index];
    ForgetGeometry(*m_state, body);
    ContactTable& contacts = m_state->contacts;
    for (const ContactIndex c : contacts.OfBody(body)) {
        if (!contacts.IsAlive(c)) continue;
        const ContactPair& p = contacts.pair[c];
        const bool any = m_state->fixtures.isSensor[p.fixtureA] || m_state->fixtures.isSensor[p.fixtureB];
        contacts.flags[c] =
            static_cast<uint8_t>((contacts.flags[c] & ~ContactFlag::sensor) | (any ? ContactFlag::sensor : 0));
        contacts.DisableWithoutPoints(c);
    }
    m_state->bodies.Wake(body);
    return ErrorCode::ok;
}
bool Fixture::IsSensor() const { return Lives("Fixture::IsSensor") ? m_state->fixtures.isSensor[m_index] != 0 : false; }

ErrorCode Fixture::SetFilterData(const Filter& filter) {
    Guard guard(*m_state, "Fixture::SetFilterData");
    guard.Living(m_state->fixtures.slots, m_index).Unlocked("set filters outside of Step and callbacks");
    if (guard.Failed() || guard.Uses(FeaturesOf(filter)).Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, filter);
    const FixtureFeatureEdit edit(*m_state, m_index);
    m_state->fixtures.filter[m_index] = filter;
    RefilterFixture(*m_state, m_index);
    return ErrorCode::ok;
}
Filter Fixture::GetFilterData() const {
    return Lives("Fixture::GetFilterData") ? m_state->fixtures.filter[m_index] : Filter{};
}
void Fixture::Refilter() {
    Guard guard(*m_state, "Fixture::Refilter");
    guard.Living(m_state->fixtures.slots, m_index).Unlocked("refilter outside of Step and callbacks");
    if (guard.Failed()) return;
    const Recording recording = guard.Record(m_index);
    RefilterFixture(*m_state, m_index);
}

int Fixture::GetChainId() const { return Lives("Fixture::GetChainId") ? m_state->fixtures.info[m_index].chainId : 0; }
int Fixture::GetChainIndex() const {
    return Lives("Fixture::GetChainIndex") ? m_state->fixtures.info[m_index].chainIndex : 0;
}

Body* Fixture::GetBody() {
    return Lives("Fixture::GetBody") ? &m_state->bodies.handles[m_state->fixtures.body[m_index]] : nullptr;
}
const Body* Fixture::GetBody() const { return const_cast<Fixture*>(this)->GetBody(); }
Fixture* Fixture::GetNext() {
    if (!Lives("Fixture::GetNext")) return nullptr;
    const FixtureIndex next = m_state->fixtures.next[m_index];
    return IsNone(next) ? nullptr : &m_state->fixtures.handles[next];
}
const Fixture* Fixture::GetNext() const { return const_cast<Fixture*>(this)->GetNext(); }
FixtureUserData Fixture::GetUserData() const {
    return Lives("Fixture::GetUserData") ? m_state->fixtures.info[m_index].userData : FixtureUserData{};
}
ErrorCode Fixture::SetUserData(const FixtureUserData& data) {
    if (!Lives("Fixture::SetUserData")) return ErrorCode::foreignHandle;
    m_state->definitions.Note();
    m_state->fixtures.info[m_index].userData = data;
    return ErrorCode::ok;
}

bool Fixture::TestPoint(Vec2 p) const {
    if (!Lives("Fixture::TestPoint")) return false;
    const BodyPlace place(m_state->bodies, IndexOf(*GetBody()));
    return GetShape()->TestPoint(place.xf, p - place.frame);
}
bool Fixture::RayCast(RayCastOutput* output, const RayCastInput& input) const {
    Guard guard(*m_state, "Fixture::RayCast");
    guard.Living(m_state->fixtures.slots, m_index).NotNull(output != nullptr, "output", "pass where to write");
    if (guard.Failed()) return false;
    guard.Finite(input.p1, "RayCastInput::p1");
    guard.Finite(input.p2, "RayCastInput::p2").Amount(input.maxFraction, "RayCastInput::maxFraction");
    const BodyPlace place(m_state->bodies, IndexOf(*GetBody()));
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
    if (guard.Failed() || guard.Accept(CheckMass(*std::as_const(*this).GetShape(), density, "density")).Failed())
        return guard.Code();
    const Recording recording = guard.Record(m_index, density);
    m_state->fixtures.info[m_index].density = density;
    return ErrorCode::ok;
}
float Fixture::GetDensity() const {
    return Lives("Fixture::GetDensity") ? m_state->fixtures.info[m_index].density : 0.0f;
}

ErrorCode Fixture::SetFriction(float friction, bool newContactsOnly) {
    Guard guard(*m_state, "Fixture::SetFriction");
    guard.Living(m_state->fixtures.slots, m_index).Amount(friction, "friction");
    if (friction != 0.0f) guard.Uses({Feature::friction});
    if (guard.Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, friction, newContactsOnly);
    const MaterialEdit edit(*m_state, m_index, newContactsOnly);
    m_state->fixtures.material[m_index].friction = friction;
    return ErrorCode::ok;
}
float Fixture::GetFriction() const {
    return Lives("Fixture::GetFriction") ? m_state->fixtures.material[m_index].friction : 0.0f;
}

ErrorCode Fixture::SetRestitution(float restitution, bool newContactsOnly) {
    Guard guard(*m_state, "Fixture::SetRestitution");
    guard.Living(m_state->fixtures.slots, m_index).Finite(restitution, "restitution");
    if (restitution != 0.0f) guard.Uses({Feature::restitution});
    if (guard.Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, restitution, newContactsOnly);
    const MaterialEdit edit(*m_state, m_index, newContactsOnly);
    m_state->fixtures.material[m_index].restitution = restitution;
    return ErrorCode::ok;
}
float Fixture::GetRestitution() const {
    return Lives("Fixture::GetRestitution") ? m_state->fixtures.material[m_index].restitution : 0.0f;
}

ErrorCode Fixture::SetRestitutionThreshold(float threshold, bool newContactsOnly) {
    Guard guard(*m_state, "Fixture::SetRestitutionThreshold");
    guard.Living(m_state->fixtures.slots, m_index).Amount(threshold, "threshold");
    if (guard.Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, threshold, newContactsOnly);
    const MaterialEdit edit(*m_state, m_index, newContactsOnly);
    m_state->fixtures.material[m_index].restitutionThreshold = threshold;
    return ErrorCode::ok;
}
float Fixture::GetRestitutionThreshold() const {
    return Lives("Fixture::GetRestitutionThreshold") ? m_state->fixtures.material[m_index].restitutionThreshold : 0.0f;
}

ErrorCode Fixture::SetTangentSpeed(float speed) {
    Guard guard(*m_state, "Fixture::SetTangentSpeed");
    guard.Living(m_state->fixtures.slots, m_index).Near(speed, "speed");
    if (speed != 0.0f) guard.Uses({Feature::tangentSpeed});
    if (guard.Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, speed);
    const MaterialEdit edit(*m_state, m_index, false);
    m_state->fixtures.material[m_index].tangentSpeed = speed;
    return ErrorCode::ok;
}
float Fixture::GetTangentSpeed() const {
    return Lives("Fixture::GetTangentSpeed") ? m_state->fixtures.material[m_index].tangentSpeed : 0.0f;
}

ErrorCode Fixture::SetRollingResistance(float resistance) {
    Guard guard(*m_state, "Fixture::SetRollingResistance");
    guard.Living(m_state->fixtures.slots, m_index).Amount(resistance, "resistance");
    if (resistance != 0.0f) guard.Uses({Feature::rollingResistance});
    if (guard.Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, resistance);
    const MaterialEdit edit(*m_state, m_index, false);
    m_state->fixtures.material[m_index].rollingResistance = resistance;
    return ErrorCode::ok;
}
float Fixture::GetRollingResistance() const {
    return Lives("Fixture::GetRollingResistance") ? m_state->fixtures.material[m_index].rollingResistance : 0.0f;
}

ErrorCode Fixture::SetMixRules(MixRule friction, MixRule restitution) {
    Guard guard(*m_state, "Fixture::SetMixRules");
    guard.Living(m_state->fixtures.slots, m_index);
    if (guard.Accept(CheckRule(friction, "friction")).Accept(CheckRule(restitution, "restitution")).Failed())
        return guard.Code();
    if (friction == MixRule::custom) guard.Uses({Feature::friction});
    if (restitution == MixRule::custom) guard.Uses({Feature::restitution});
    if (guard.Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, friction, restitution);
    const MaterialEdit edit(*m_state, m_index, false);
    Material& material = m_state->fixtures.material[m_index];
    material.frictionRule = friction;
    material.restitutionRule = restitution;
    return ErrorCode::ok;
}
MixRule Fixture::GetFrictionRule() const {
    return Lives("Fixture::GetFrictionRule") ? m_state->fixtures.material[m_index].frictionRule : MixRule{};
}
MixRule Fixture::GetRestitutionRule() const {
    return Lives("Fixture::GetRestitutionRule") ? m_state->fixtures.material[m_index].restitutionRule : MixRule{};
}

ErrorCode Fixture::SetMaterialId(uint64_t id) {
    Guard guard(*m_state, "Fixture::SetMaterialId");
    if (guard.Living(m_state->fixtures.slots, m_index).Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, id);
    const MaterialEdit edit(*m_state, m_index, false);
    m_state->fixtures.info[m_index].materialId = id;
    return ErrorCode::ok;
}
uint64_t Fixture::GetMaterialId() const {
    return Lives("Fixture::GetMaterialId") ? m_state->fixtures.info[m_index].materialId : 0;
}

ErrorCode Fixture::SetReports(uint8_t reports) {
    Guard guard(*m_state, "Fixture::SetReports");
    guard.Living(m_state->fixtures.slots, m_index).Accept(CheckReports(reports, "reports"));
    if (reports != 0) guard.Uses({Feature::events});
    if (guard.Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, reports);
    const FixtureFeatureEdit edit(*m_state, m_index);
    m_state->fixtures.info[m_index].reports = reports;
    return ErrorCode::ok;
}
uint8_t Fixture::GetReports() const {
    return Lives("Fixture::GetReports") ? m_state->fixtures.info[m_index].reports : uint8_t{0};
}

AABB Fixture::GetAABB() const {
    if (!Lives("Fixture::GetAABB")) return AABB{};
    if (m_state->fixtures.info[m_index].inBroadPhase) return m_state->broadPhase->GetBox(ProxyOf(m_index));
    AABB box;
    GetShape()->ComputeAABB(&box, GetBody()->GetTransform());
    return box;
}

}  // namespace scree
