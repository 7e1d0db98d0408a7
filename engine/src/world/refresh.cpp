// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Edits between steps. Boxes change at once; pairs are found again at the start of the next step.

#include "world/refresh.h"

#include "pipeline/parts/destroy_contact.h"
#include "pipeline/parts/update_boxes.h"
#include "state/frames.h"
#include "state/limits.h"
#include "world/guard.h"

namespace scree {

namespace {

/// Destroys the contacts of a body that satisfy the predicate. Their rows are used again after the next pair finding.
template <typename Predicate>
void DestroyIf(WorldState& s, BodyIndex body, Predicate involves) {
    const WorldLock lock(s);
    s.contacts.RouseOf(body);  // so that its list stays as it is while callbacks ask for others
    DestroyContactsOfBodyIf(body, involves, s.Events(), s.bodies, s.contacts);
}

/// The coming step looks at the contacts of the body, and at the body if that is awake.
void Stir(WorldState& s, BodyIndex body) {
    s.isEdited = true;
    if (s.bodies.Has(body, BodyFlag::awake)) s.bodies.List(body);
    s.contacts.RouseOf(body);
}

/// The next step asks the filters again about these contacts, and about pairs that have none.
template <typename Predicate>
void RefilterIf(WorldState& s, BodyIndex body, Predicate involves) {
    Stir(s, body);
    for (const ContactIndex c : s.contacts.OfBody(body)) {
        if (s.contacts.IsAlive(c) && involves(s.contacts.pair[c])) {
            s.contacts.flags[c] |= ContactFlag::refilter;
            s.contacts.filtersAgree = false;
        }
    }
}

/// The centre of mass where the sum of moments overflows, or rounding leads out of range.
Vec2 MeanOfCenters(const WorldState& s, BodyIndex body, float invMass) {
    Vec2 mean = vec2Zero;
    for (const FixtureIndex f : s.fixtures.From(s.bodies.fixtureHead[body])) {
        MassData part;
        s.fixtures.shape[f]->ComputeMass(&part, s.fixtures.info[f].density);
        mean += (part.mass * invMass) * part.center;
    }
    return {Clamp(mean.x, -farthest, farthest), Clamp(mean.y, -farthest, farthest)};
}

Motion MotionOf(BodyType type) {
    return type == staticBody ? Motion::isStatic : type == dynamicBody ? Motion::dynamic : Motion::kinematic;
}

}  // namespace

void ForgetGeometry(WorldState& s, BodyIndex body) {
    NearStatics& near = s.continuousScratch.nearStatics;
    const BodyType type = s.bodies.type[body];
    if (type == staticBody) near.ForgetAll();
    if (type == dynamicBody) near.Forget(body);  // of kinematic bodies nothing is known
    if (s.contacts.steady.empty() || !s.contacts.MayHave(body)) return;
    for (const ContactIndex contact : s.contacts.OfBody(body)) s.contacts.ForgetSteady(contact);
}

void NoteBodyEdit(WorldState& s, BodyIndex body) {
    for (const FixtureIndex f : s.fixtures.From(s.bodies.fixtureHead[body])) {
        s.edited.Add(f);
    }
    Stir(s, body);
}

void ScaleDefaultSkin(WorldState& s, FixtureIndex fixture) {
    // A radius that was chosen stays: that of a circle, or one that is solid.
    const Shape& shape = *s.fixtures.shape[fixture];
    if (s.def.lengthScale == 1.0f || shape.m_radius != polygonRadius || shape.GetType() == Shape::e_circle) return;
    if (shape.GetType() == Shape::e_convex && static_cast<const ConvexShape&>(shape).m_solidRadius > 0.0f) return;
    s.fixtures.GetOwnShape(fixture)->m_radius *= s.def.lengthScale;
}

void NoteShapeEdit(WorldState& s, FixtureIndex fixture) {
    const BodyIndex body = s.fixtures.body[fixture];
    ForgetGeometry(s, body);
    if (!s.fixtures.info[fixture].inBroadPhase) return;
    s.bodies.Wake(body);
    std::vector<ContactIndex> contacts;
    s.contacts.ListOfBody(body, contacts);
    for (const ContactIndex contact : contacts) {
        const ContactPair& pair = s.contacts.pair[contact];
        if (!s.contacts.IsAlive(contact) || (pair.fixtureA != fixture && pair.fixtureB != fixture)) continue;
        if (!s.contacts.Has(contact, ContactFlag::touching) || s.contacts.Has(contact, ContactFlag::sensor)) continue;
        s.bodies.Wake(pair.bodyA), s.bodies.Wake(pair.bodyB);
    }
    s.broadPhase->Update(ProxyOf(fixture), FindBox(s.bodies, s.fixtures, fixture), vec2Zero);
    s.edited.Add(fixture);
    Stir(s, body);
}

void NoteParting(WorldState& s, BodyIndex bodyA, BodyIndex bodyB) {
    const auto count = [&](BodyIndex body) { return s.bodies.info[body].fixtureCount; };
    NoteBodyEdit(s, count(bodyA) <= count(bodyB) ? bodyA : bodyB);
}

void AddProxy(WorldState& s, FixtureIndex fixture) {
    const BodyIndex body = s.fixtures.body[fixture];
    const BodyPlace place(s.bodies, body);
    AABB box;
    s.fixtures.shape[fixture]->ComputeAABB(&box, place.xf);
    box = place.OutOf(box);
    s.edited.Add(fixture);
    s.broadPhase->Insert(ProxyOf(fixture), OwnerOf(body), MotionOf(s.bodies.type[body]), box);
    const bool rests = s.bodies.type[body] != staticBody && s.bodies.isListed[body] == 0;
    if (rests) s.broadPhase->SetResting(ProxyOf(fixture), true);
    s.fixtures.info[fixture].inBroadPhase = true;
    ForgetGeometry(s, body);
    Stir(s, body);
}

void RestoreProxy(WorldState& s, FixtureIndex fixture, const AABB& box) {
    const BodyIndex body = s.fixtures.body[fixture];
    ForgetGeometry(s, body);
    s.broadPhase->Restore(ProxyOf(fixture), OwnerOf(body), MotionOf(s.bodies.type[body]), box);
}

void RemoveProxy(WorldState& s, FixtureIndex fixture) {
    FixtureInfo& info = s.fixtures.info[fixture];
    if (!info.inBroadPhase) return;
    s.broadPhase->Remove(ProxyOf(fixture));
    info.inBroadPhase = false;
    s.contacts.refused.Forget(fixture);
    ForgetGeometry(s, s.fixtures.body[fixture]);
    s.isEdited = true;
}

void DestroyContactsOfFixture(WorldState& s, FixtureIndex fixture) {
    DestroyIf(s, s.fixtures.body[fixture],
              [=](const ContactPair& p) { return p.fixtureA == fixture || p.fixtureB == fixture; });
}

void DestroyContactsOfChain(WorldState& s, BodyIndex body, int chainId) {
    DestroyIf(s, body, [&](const ContactPair& p) {
        return s.fixtures.info[p.fixtureA].chainId == chainId || s.fixtures.info[p.fixtureB].chainId == chainId;
    });
}

void DestroyContactsOfBody(WorldState& s, BodyIndex body) {
    DestroyIf(s, body, [](const ContactPair&) { return true; });
}

void RefilterFixture(WorldState& s, FixtureIndex fixture) {
    s.contacts.refused.Forget(fixture);
    s.edited.Add(fixture);
    RefilterIf(s, s.fixtures.body[fixture],
               [=](const ContactPair& p) { return p.fixtureA == fixture || p.fixtureB == fixture; });
}

void RefilterBodies(WorldState& s, BodyIndex bodyA, BodyIndex bodyB) {
    RefilterIf(s, bodyA, [=](const ContactPair& p) { return p.bodyA == bodyB || p.bodyB == bodyB; });
}

void ResetMass(WorldState& s, BodyIndex body) {
    ForgetGeometry(s, body);
    BodyInfo& info = s.bodies.info[body];
    MassRow& row = s.bodies.mass[body];
    float& mass = s.bodies.motion[body].mass;
    mass = 0.0f;
    info.inertia = 0.0f;
    row.invMass = row.invI = 0.0f;
    if (s.bodies.type[body] != dynamicBody) {
        s.bodies.SetLocalCenter(body, vec2Zero);
        return;
    }
    Vec2 center = vec2Zero;
    for (const FixtureIndex f : s.fixtures.From(s.bodies.fixtureHead[body])) {
        const float density = s.fixtures.info[f].density;
        if (density == 0.0f) continue;
        MassData part;
        s.fixtures.shape[f]->ComputeMass(&part, density);
        mass += part.mass;
        center += part.mass * part.center;
        info.inertia += part.I;
    }
    row.invMass = UsableInverse(mass);
    center *= row.invMass;
    if (row.invMass == 0.0f) mass = 0.0f, center = vec2Zero;
    if (!IsInRange(center)) center = MeanOfCenters(s, body, row.invMass);
    const bool turns = info.inertia > 0.0f && !s.bodies.Has(body, BodyFlag::fixedRotation);
    if (turns) info.inertia -= mass * Dot(center, center);
    row.invI = turns ? UsableInverse(info.inertia) : 0.0f;
    if (row.invI == 0.0f) info.inertia = 0.0f;
    Velocity& velocity = s.bodies.velocity[body];
    velocity.v += Cross(velocity.w, s.bodies.SetLocalCenter(body, center));
}

void NotePosition(WorldState& s, Vec2 position, Vec2 rest) {
    const bool hasRest = rest.x != 0.0f || rest.y != 0.0f;
    if (hasRest || IsFar(s, Max(Abs(position.x), Abs(position.y)))) s.bodies.EnsureRests();
}

}  // namespace scree
