// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// New contacts.

#include "pipeline/parts/make_contact.h"

#include <utility>

#include "geometry/collide.h"
#include "pipeline/parts/mix_materials.h"

namespace scree {

bool MayHaveContact(int fixtureA, int fixtureB, const ContactEvents& events, FixtureTable& fixtures,
                    JointTable& joints) {
    const auto a = static_cast<size_t>(fixtureA);
    const auto b = static_cast<size_t>(fixtureB);
    if (!joints.MayCollide(fixtures.body[a], fixtures.body[b])) return false;
    if (events.filter == nullptr) return ShouldCollide(fixtures.filter[a], fixtures.filter[b]);
    return events.filter->ShouldCollide(&fixtures.handles[a], &fixtures.handles[b]);
}

int MakeContact(int fixtureA, int fixtureB, const ContactEvents& events, const FixtureTable& fixtures,
                ContactTable& contacts) {
    const Shape::Type typeA = fixtures.type[static_cast<size_t>(fixtureA)];
    const Shape::Type typeB = fixtures.type[static_cast<size_t>(fixtureB)];
    const CollideEntry entry = FindCollide(typeA, typeB);
    if (entry.function == nullptr) return -1;
    if (entry.swap) std::swap(fixtureA, fixtureB);
    const auto a = static_cast<size_t>(fixtureA);
    const auto b = static_cast<size_t>(fixtureB);
    const int contact = contacts.Add(
        {static_cast<uint32_t>(fixtureA), static_cast<uint32_t>(fixtureB), fixtures.body[a], fixtures.body[b]});
    const auto c = static_cast<size_t>(contact);
    contacts.flags[c] |= ContactFlag::enabled;
    if (fixtures.isSensor[a] || fixtures.isSensor[b]) contacts.flags[c] |= ContactFlag::sensor;
    contacts.material[c] =
        MixMaterials(static_cast<uint32_t>(fixtureA), static_cast<uint32_t>(fixtureB), fixtures, events.mixer);
    return contact;
}

}  // namespace scree
