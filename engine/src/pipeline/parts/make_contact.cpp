// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// New contacts.

#include "pipeline/parts/make_contact.h"

#include <utility>

#include "geometry/collide.h"
#include "pipeline/parts/mix_materials.h"

namespace scree {

bool MayHaveContact(FixtureIndex fixtureA, FixtureIndex fixtureB, const ContactEvents& events, FixtureTable& fixtures,
                    JointTable& joints) {
    // The filters first: the limbs of a ragdoll have one group, and each step asks about all that overlap.
    if (events.filter == nullptr && !ShouldCollide(fixtures.filter[fixtureA], fixtures.filter[fixtureB])) return false;
    if (!joints.MayCollide(fixtures.body[fixtureA], fixtures.body[fixtureB])) return false;
    return events.filter == nullptr ||
           events.filter->ShouldCollide(&fixtures.handles[fixtureA], &fixtures.handles[fixtureB]);
}

ContactIndex MakeContact(FixtureIndex fixtureA, FixtureIndex fixtureB, const ContactEvents& events,
                         const FixtureTable& fixtures, ContactTable& contacts) {
    const Shape::Type typeA = fixtures.type[fixtureA];
    const Shape::Type typeB = fixtures.type[fixtureB];
    const CollideEntry entry = FindCollide(typeA, typeB);
    if (entry.function == nullptr) return ContactIndex::none;
    if (entry.swap) std::swap(fixtureA, fixtureB);
    const ContactIndex contact = contacts.Add({fixtureA, fixtureB, fixtures.body[fixtureA], fixtures.body[fixtureB]});
    contacts.flags[contact] |= ContactFlag::enabled;
    if (fixtures.isSensor[fixtureA] || fixtures.isSensor[fixtureB]) contacts.flags[contact] |= ContactFlag::sensor;
    contacts.material[contact] = MixMaterials(fixtureA, fixtureB, fixtures, events.mixer);
    return contact;
}

}  // namespace scree
