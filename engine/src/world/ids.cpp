// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Ids with generations: handle → id while the object lives, id → handle if it still does.

#include "world/validate.h"

namespace scree {

namespace {

template <typename Id, Index I, typename Object>
Id MakeId(const WorldState& s, const Slots<I>& slots, const Object* object) {
    if (!Owns(s, object)) return {};
    return {object->GetIndex(), slots.GetGeneration(IndexOf(*object))};
}

template <Index I, typename Id>
bool Lives(const Slots<I>& slots, Id id) {
    return slots.IsAlive(I{id.index}) && slots.GetGeneration(I{id.index}) == id.generation;
}

}  // namespace

BodyId World::GetId(const Body* body) const { return MakeId<BodyId>(*m_state, m_state->bodies.slots, body); }
FixtureId World::GetId(const Fixture* fixture) const {
    return MakeId<FixtureId>(*m_state, m_state->fixtures.slots, fixture);
}
JointId World::GetId(const Joint* joint) const { return MakeId<JointId>(*m_state, m_state->joints.slots, joint); }

ContactId World::GetId(const Contact* contact) const {
    if (!Owns(*m_state, contact)) return {};
    return {contact->GetIndex(), m_state->contacts.GetGeneration(ContactNumber{contact->GetIndex()})};
}

Body* World::Find(BodyId id) {
    return Lives(m_state->bodies.slots, id) ? &m_state->bodies.handles[BodyIndex{id.index}] : nullptr;
}
Fixture* World::Find(FixtureId id) {
    return Lives(m_state->fixtures.slots, id) ? &m_state->fixtures.handles[FixtureIndex{id.index}] : nullptr;
}
Joint* World::Find(JointId id) {
    return Lives(m_state->joints.slots, id) ? m_state->joints.handles[JointIndex{id.index}] : nullptr;
}

Contact* World::Find(ContactId id) {
    ContactTable& contacts = m_state->contacts;
    Contact* contact = contacts.HandleOf(ContactNumber{id.index});
    return contact != nullptr && contacts.GetGeneration(ContactNumber{id.index}) == id.generation ? contact : nullptr;
}

}  // namespace scree
