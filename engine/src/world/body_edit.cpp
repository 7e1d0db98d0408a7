// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The edits of a body that reach other tables: fixtures and chains, placement, type, enabling, mass. Semantics are
// Box2D 2.4.1's.

#include <utility>

#include "base/undo.h"
#include "pipeline/parts/update_boxes.h"
#include "scree/body.h"
#include "scree/chain_shape.h"
#include "world/guard.h"
#include "world/refresh.h"

namespace scree {

namespace {

size_t Row(int index) { return static_cast<size_t>(index); }

/// Adds a fixture in front of the body's list; the mass is not updated.
int AttachFixture(WorldState& s, int body, const FixtureDef& def) {
    const int fixture = s.fixtures.Add(&s, body, def);
    Undo undo([&] { s.fixtures.UndoAdd(fixture); });
    // The default skin is for bodies of the default size; a radius that was chosen stays.
    const Shape& shape = *s.fixtures.shape[Row(fixture)];
    if (s.def.lengthScale != 1.0f && shape.GetType() != Shape::e_circle && shape.m_radius == polygonRadius)
        s.fixtures.GetOwnShape(fixture)->m_radius *= s.def.lengthScale;
    if (s.bodies.Has(body, BodyFlag::enabled)) AddProxy(s, fixture);
    undo.Dismiss();
    s.fixtures.next[Row(fixture)] = std::exchange(s.bodies.fixtureHead[Row(body)], fixture);
    ++s.bodies.info[Row(body)].fixtureCount;
    AddFixtureFeatures(s, fixture, 1);
    return fixture;
}

/// Unlinks and frees every fixture of the body for which `goes(fixture)` holds. Their contacts are gone already.
template <typename Predicate>
void DetachFixtures(WorldState& s, int body, Predicate goes) {
    for (int* link = &s.bodies.fixtureHead[Row(body)]; *link >= 0;) {
        const int fixture = *link;
        int& next = s.fixtures.next[Row(fixture)];
        if (!goes(fixture)) {
            link = &next;
            continue;
        }
        *link = next;
        --s.bodies.info[Row(body)].fixtureCount;
        RemoveProxy(s, fixture);
        AddFixtureFeatures(s, fixture, -1);
        s.fixtures.Remove(fixture);
    }
}

/// Takes back the edges of a chain that is not whole, the newest first.
void UndoChain(WorldState& s, int body, int chainId) {
    int& head = s.bodies.fixtureHead[Row(body)];
    while (head >= 0 && s.fixtures.info[Row(head)].chainId == chainId) {
        const int fixture = std::exchange(head, s.fixtures.next[Row(head)]);
        --s.bodies.info[Row(body)].fixtureCount;
        RemoveProxy(s, fixture);
        AddFixtureFeatures(s, fixture, -1);
        s.fixtures.UndoAdd(fixture);
    }
}

/// One edge per segment; returns the first.
int AttachChain(WorldState& s, int body, const FixtureDef& def, const ChainShape& chain) {
    const int id = s.fixtures.nextChainId;
    FixtureDef edgeDef = def;
    EdgeShape edge;
    edgeDef.shape = &edge;
    int first = -1;
    const bool wereStale = s.isEdited;
    Undo undo([&] {
        UndoChain(s, body, id);
        s.isEdited = wereStale;
    });
    for (int i = 0; i < chain.GetChildCount(); ++i) {
        chain.GetChildEdge(&edge, i);
        const int fixture = AttachFixture(s, body, edgeDef);
        s.fixtures.info[Row(fixture)].chainId = id;
        s.fixtures.info[Row(fixture)].chainIndex = i;
        if (i == 0) first = fixture;
    }
    undo.Dismiss();
    ++s.fixtures.nextChainId;
    return first;
}

/// What the body and its fixtures would use if it were of that type.
Features FeaturesAs(WorldState& s, int body, BodyType type) {
    BodyType& own = s.bodies.type[Row(body)];
    const BodyType before = std::exchange(own, type);
    Features f = FeaturesOfBody(s.bodies, body);
    for (const int i : s.fixtures.From(s.bodies.fixtureHead[Row(body)])) {
        f = f | FeaturesOfFixture(s.fixtures, s.bodies, i);
    }
    own = before;
    return f;
}

}  // namespace

Fixture* Body::CreateFixture(const FixtureDef* def) {
    WorldState& s = *m_state;
    Guard guard(s, "Body::CreateFixture");
    guard.Living(s.bodies.slots, m_index).NotNull(def != nullptr, "def", "pass a FixtureDef");
    guard.Unlocked("create fixtures outside of Step and callbacks");
    if (guard.Failed() || guard.Accept(Check(*def)).Failed()) return nullptr;
    if (guard.Uses(UnderSettings(FeaturesOf(*def, GetType()), s.def)).Failed()) return nullptr;
    const Recording recording = guard.Record(m_index, *def);
    const bool isChain = def->shape->GetType() == Shape::e_chain;
    const int fixture = isChain ? AttachChain(s, m_index, *def, static_cast<const ChainShape&>(*def->shape))
                                : AttachFixture(s, m_index, *def);
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
    Guard guard(s, "Body::DestroyFixture");
    guard.Living(s.bodies.slots, m_index).NotNull(fixture != nullptr, "fixture", "pass a fixture");
    if (guard.Failed()) return guard.Code();
    guard.Require(Owns(s, fixture) && s.fixtures.body[Row(fixture->GetIndex())] == m_index, ErrorCode::foreignHandle,
                  "fixture", "pass a living fixture of this body");
    if (guard.Unlocked("destroy fixtures outside of Step and callbacks").Failed()) return guard.Code();
    const int index = fixture->GetIndex();
    const Recording recording = guard.Record(m_index, index);
    DestroyContactsOfFixture(s, index);
    DetachFixtures(s, m_index, [index](int f) { return f == index; });
    ResetMass(s, m_index);
    return ErrorCode::ok;
}

ErrorCode Body::DestroyChain(Fixture* fixture) {
    WorldState& s = *m_state;
    Guard guard(s, "Body::DestroyChain");
    guard.Living(s.bodies.slots, m_index).NotNull(fixture != nullptr, "fixture", "pass an edge of a chain");
    if (guard.Failed()) return guard.Code();
    guard.Require(Owns(s, fixture) && s.fixtures.body[Row(fixture->GetIndex())] == m_index, ErrorCode::foreignHandle,
                  "fixture", "pass a living fixture of this body");
    if (guard.Unlocked("destroy chains outside of Step and callbacks").Failed()) return guard.Code();
    const int id = s.fixtures.info[Row(fixture->GetIndex())].chainId;
    if (guard.Require(id >= 0, ErrorCode::outOfRange, "fixture", "pass an edge that a ChainShape made").Failed())
        return guard.Code();
    const Recording recording = guard.Record(m_index, fixture->GetIndex());
    DestroyContactsOfChain(s, m_index, id);
    DetachFixtures(s, m_index, [&](int f) { return s.fixtures.info[Row(f)].chainId == id; });
    ResetMass(s, m_index);
    return ErrorCode::ok;
}

ErrorCode Body::SetTransform(Vec2 position, float angle, Vec2 positionRest) {
    WorldState& s = *m_state;
    Guard guard(s, "Body::SetTransform");
    guard.Living(s.bodies.slots, m_index).Unlocked("move bodies outside of Step and callbacks");
    guard.Near(position, "position").Near(angle, "angle").Near(positionRest, "positionRest");
    if (guard.Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, position, angle, positionRest);
    NotePosition(s, position, positionRest);
    s.bodies.Place(Row(m_index), position, positionRest, angle);
    if (!IsEnabled()) return ErrorCode::ok;
    UpdateBodyBoxes(s.bodies, s.fixtures, m_index, vec2Zero, *s.broadPhase);
    ForgetGeometry(s, m_index);
    NoteBodyEdit(s, m_index);
    return ErrorCode::ok;
}

ErrorCode Body::SetType(BodyType type) {
    WorldState& s = *m_state;
    Guard guard(s, "Body::SetType");
    guard.Living(s.bodies.slots, m_index).Unlocked("change types outside of Step and callbacks");
    guard.Require(type <= dynamicBody, ErrorCode::outOfRange, "type", "use a BodyType");
    if (guard.Failed()) return guard.Code();
    if (guard.Uses(UnderSettings(FeaturesAs(s, m_index, type), s.def)).Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, type);
    const size_t b = Row(m_index);
    if (s.bodies.type[b] == type) return ErrorCode::ok;
    const BodyFeatureEdit edit(s, m_index, true);
    const bool changesList = (s.bodies.type[b] == staticBody) != (type == staticBody);
    ForgetGeometry(s, m_index);  // as what it was
    s.bodies.type[b] = type;
    if (changesList) s.bodies.Relist(m_index);
    s.bodies.NoteKinematic(m_index);
    ResetMass(s, m_index);
    if (type == staticBody) {
        s.bodies.PutToSleep(m_index);  // clears velocity; the flag is never set on static bodies
    } else {
        s.bodies.Wake(m_index);
    }
    s.bodies.ClearForce(m_index);
    DestroyContactsOfBody(s, m_index);
    // The broad phase sorts its boxes by motion type.
    for (const int f : s.fixtures.From(s.bodies.fixtureHead[b])) {
        if (!s.fixtures.info[Row(f)].inBroadPhase) continue;
        RemoveProxy(s, f);
        AddProxy(s, f);
    }
    return ErrorCode::ok;
}

ErrorCode Body::SetEnabled(bool flag) {
    WorldState& s = *m_state;
    Guard guard(s, "Body::SetEnabled");
    if (guard.Living(s.bodies.slots, m_index).Unlocked("enable bodies outside of Step and callbacks").Failed())
        return guard.Code();
    const Recording recording = guard.Record(m_index, flag);
    if (flag == IsEnabled()) return ErrorCode::ok;
    uint16_t& flags = s.bodies.flags[Row(m_index)];
    flags = static_cast<uint16_t>(flag ? flags | BodyFlag::enabled : flags & ~BodyFlag::enabled);
    if (!flag) DestroyContactsOfBody(s, m_index);
    for (const int f : s.fixtures.From(s.bodies.fixtureHead[Row(m_index)])) {
        flag ? AddProxy(s, f) : RemoveProxy(s, f);
    }
    return ErrorCode::ok;
}

ErrorCode Body::SetMassData(const MassData* data) {
    WorldState& s = *m_state;
    Guard guard(s, "Body::SetMassData");
    guard.Living(s.bodies.slots, m_index).NotNull(data != nullptr, "data", "pass mass data");
    if (guard.Unlocked("change masses outside of Step and callbacks").Failed()) return guard.Code();
    guard.Finite(data->mass, "MassData::mass").Finite(data->I, "MassData::I").Near(data->center, "MassData::center");
    if (guard.Failed() || GetType() != dynamicBody) return guard.Code();
    const float mass = data->mass > 0.0f ? data->mass : 1.0f;
    guard.Require(mass >= leastMass && mass <= mostMass, ErrorCode::outOfRange, "MassData::mass",
                  "give 0 (for 1 kg) or 1e-30 to 1e30 kg");
    const bool rotates = data->I > 0.0f && !IsFixedRotation();
    const float inertia = rotates ? data->I - mass * Dot(data->center, data->center) : 0.0f;
    guard.Require(!rotates || UsableInverse(inertia) > 0.0f, ErrorCode::outOfRange, "MassData::I",
                  "it is about the origin: give more than mass·|center|²");
    if (guard.Failed()) return guard.Code();
    const Recording recording = guard.Record(m_index, *data);
    const size_t b = Row(m_index);
    ForgetGeometry(s, m_index);
    s.bodies.motion[b].mass = mass;
    s.bodies.info[b].inertia = inertia;
    s.bodies.mass[b].invMass = 1.0f / mass;
    s.bodies.mass[b].invI = rotates ? 1.0f / inertia : 0.0f;
    s.bodies.velocity[b].v += Cross(s.bodies.velocity[b].w, s.bodies.SetLocalCenter(b, data->center));
    return ErrorCode::ok;
}

void Body::ResetMassData() {
    Guard guard(*m_state, "Body::ResetMassData");
    if (guard.Living(m_state->bodies.slots, m_index).Failed()) return;
    const Recording recording = guard.Record(m_index);
    ResetMass(*m_state, m_index);
}

}  // namespace scree
