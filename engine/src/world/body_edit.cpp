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
#include "world/joints/joint_definitions.h"
#include "world/refresh.h"

namespace scree {

namespace {

/// Adds a fixture in front of the body's list; the mass is not updated. `knownShape`: FixtureTable::FindShape.
FixtureIndex AttachFixture(WorldState& s, BodyIndex body, const FixtureDef& def, int knownShape) {
    const FixtureIndex fixture = s.fixtures.Add(&s, body, def, knownShape);
    Undo undo([&] { s.fixtures.UndoAdd(fixture); });
    ScaleDefaultSkin(s, fixture);
    if (s.bodies.Has(body, BodyFlag::enabled)) AddProxy(s, fixture);
    undo.Dismiss();
    s.fixtures.next[fixture] = std::exchange(s.bodies.fixtureHead[body], fixture);
    ++s.bodies.info[body].fixtureCount;
    AddFixtureFeatures(s, fixture, 1);
    return fixture;
}

/// Unlinks and frees every fixture of the body for which `goes(fixture)` holds. Their contacts are gone already.
template <typename Predicate>
void DetachFixtures(WorldState& s, BodyIndex body, Predicate goes) {
    for (FixtureIndex* link = &s.bodies.fixtureHead[body]; IsSome(*link);) {
        const FixtureIndex fixture = *link;
        FixtureIndex& next = s.fixtures.next[fixture];
        if (!goes(fixture)) {
            link = &next;
            continue;
        }
        *link = next;
        --s.bodies.info[body].fixtureCount;
        RemoveProxy(s, fixture);
        AddFixtureFeatures(s, fixture, -1);
        s.fixtures.Remove(fixture);
    }
}

/// Takes back the edges of a chain that is not whole, the newest first.
void UndoChain(WorldState& s, BodyIndex body, int chainId) {
    FixtureIndex& head = s.bodies.fixtureHead[body];
    while (IsSome(head) && s.fixtures.info[head].chainId == chainId) {
        const FixtureIndex fixture = std::exchange(head, s.fixtures.next[head]);
        --s.bodies.info[body].fixtureCount;
        RemoveProxy(s, fixture);
        AddFixtureFeatures(s, fixture, -1);
        s.fixtures.UndoAdd(fixture);
    }
}

/// One edge per segment; returns the first.
FixtureIndex AttachChain(WorldState& s, BodyIndex body, const FixtureDef& def, const ChainShape& chain) {
    const int id = s.fixtures.nextChainId;
    FixtureDef edgeDef = def;
    EdgeShape edge;
    edgeDef.shape = &edge;
    FixtureIndex first = FixtureIndex::none;
    const bool wereStale = s.isEdited;
    Undo undo([&] {
        UndoChain(s, body, id);
        s.isEdited = wereStale;
    });
    for (int i = 0; i < chain.GetChildCount(); ++i) {
        chain.GetChildEdge(&edge, i);
        const FixtureIndex fixture = AttachFixture(s, body, edgeDef, -1);
        s.fixtures.info[fixture].chainId = id;
        s.fixtures.info[fixture].chainIndex = i;
        if (i == 0) first = fixture;
    }
    undo.Dismiss();
    ++s.fixtures.nextChainId;
    return first;
}

/// What the body and its fixtures would use if it were of that type.
Features FeaturesAs(WorldState& s, BodyIndex body, BodyType type) {
    BodyType& own = s.bodies.type[body];
    const BodyType before = std::exchange(own, type);
    Features f = FeaturesOfBody(s.bodies, body);
    for (const FixtureIndex i : s.fixtures.From(s.bodies.fixtureHead[body])) {
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
    if (guard.Failed()) return nullptr;
    const int knownShape = def->shape != nullptr ? s.fixtures.FindShape(*def->shape) : -1;
    if (guard.Accept(Check(*def, knownShape >= 0)).Failed()) return nullptr;
    if (guard.Uses(UnderSettings(FeaturesOf(*def, s.bodies.type[m_index]), s.def)).Failed()) return nullptr;
    const Recording recording = guard.Record(m_index, *def);
    const bool isChain = def->shape->GetType() == Shape::e_chain;
    const FixtureIndex fixture = isChain ? AttachChain(s, m_index, *def, static_cast<const ChainShape&>(*def->shape))
                                         : AttachFixture(s, m_index, *def, knownShape);
    if (def->density > 0.0f) ResetMass(s, m_index);
    return &s.fixtures.handles[fixture];
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
    guard.Require(Owns(s, fixture) && s.fixtures.body[IndexOf(*fixture)] == m_index, ErrorCode::foreignHandle,
                  "fixture", "pass a living fixture of this body");
    if (guard.Unlocked("destroy fixtures outside of Step and callbacks").Failed()) return guard.Code();
    const FixtureIndex index = IndexOf(*fixture);
    const Recording recording = guard.Record(m_index, index);
    DestroyContactsOfFixture(s, index);
    DetachFixtures(s, m_index, [index](FixtureIndex f) { return f == index; });
    ResetMass(s, m_index);
    return ErrorCode::ok;
}

ErrorCode Body::DestroyChain(Fixture* fixture) {
    WorldState& s = *m_state;
    Guard guard(s, "Body::DestroyChain");
    guard.Living(s.bodies.slots, m_index).NotNull(fixture != nullptr, "fixture", "pass an edge of a chain");
    if (guard.Failed()) return guard.Code();
    guard.Require(Owns(s, fixture) && s.fixtures.body[IndexOf(*fixture)] == m_index, ErrorCode::foreignHandle,
                  "fixture", "pass a living fixture of this body");
    if (guard.Unlocked("destroy chains outside of Step and callbacks").Failed()) return guard.Code();
    const int id = s.fixtures.info[IndexOf(*fixture)].chainId;
    if (guard.Require(id >= 0, ErrorCode::outOfRange, "fixture", "pass an edge that a ChainShape made").Failed())
        return guard.Code();
    const Recording recording = guard.Record(m_index, fixture->GetIndex());
    DestroyContactsOfChain(s, m_index, id);
    DetachFixtures(s, m_index, [&](FixtureIndex f) { return s.fixtures.info[f].chainId == id; });
    ResetMass(s, m_index);
    return ErrorCode::ok;
}

ErrorCode Body::SetTransform(Vec2 position, float angle, Vec2 positionRest) {
    WorldState& s = *m_state;
    Guard guard(s, "Body::SetTransform");
    guard.Living(s.bodies.slots, m_index).Unlocked("move bodies outside of Step and callbacks");
    guard.Near(position, "position").Near(angle, "angle").Near(positionRest, "positionRest");
    if (guard.Failed()) return guard.Code();
    const Recording recording = guard.RecordMotion(m_index, position, angle, positionRest);
    NotePosition(s, position, positionRest);
    s.bodies.Place(m_index, position, positionRest, angle);
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
    if (s.bodies.type[m_index] == type) return ErrorCode::ok;
    {
        // Contacts end after it: what the body's fixtures report counts then.
        const BodyFeatureEdit edit(s, m_index, true);
        ForgetGeometry(s, m_index);  // as what it was
        const bool changesList = (s.bodies.type[m_index] == staticBody) != (type == staticBody);
        s.bodies.type[m_index] = type;
        if (changesList) s.bodies.Relist(m_index);
        s.bodies.NoteTarget(m_index);
        ResetMass(s, m_index);
        if (type == staticBody) {
            s.bodies.PutToSleep(m_index);  // clears velocity; the flag is never set on static bodies
            s.bodies.NoteStart(m_index);   // what it had before it in a sub-stepped step is over
        } else {
            s.bodies.Wake(m_index);
        }
        s.bodies.ClearForce(m_index);
    }
    DestroyContactsOfBody(s, m_index);
    RehangGears(s);
    // The broad phase sorts its boxes by motion type.
    for (const FixtureIndex f : s.fixtures.From(s.bodies.fixtureHead[m_index])) {
        if (!s.fixtures.info[f].inBroadPhase) continue;
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
    uint16_t& flags = s.bodies.flags[m_index];
    flags = static_cast<uint16_t>(flag ? flags | BodyFlag::enabled : flags & ~BodyFlag::enabled);
    if (!flag) DestroyContactsOfBody(s, m_index);
    for (const FixtureIndex f : s.fixtures.From(s.bodies.fixtureHead[m_index])) {
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
    ForgetGeometry(s, m_index);
    s.bodies.motion[m_index].mass = mass;
    s.bodies.info[m_index].inertia = inertia;
    s.bodies.mass[m_index].invMass = 1.0f / mass;
    s.bodies.mass[m_index].invI = rotates ? 1.0f / inertia : 0.0f;
    s.bodies.velocity[m_index].v += Cross(s.bodies.velocity[m_index].w, s.bodies.SetLocalCenter(m_index, data->center));
    return ErrorCode::ok;
}

void Body::ResetMassData() {
    Guard guard(*m_state, "Body::ResetMassData");
    if (guard.Living(m_state->bodies.slots, m_index).Failed()) return;
    const Recording recording = guard.Record(m_index);
    ResetMass(*m_state, m_index);
}

}  // namespace scree
