// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Edits between steps. Boxes change at once; pairs are found again at the start of the next step.

#include "world/refresh.h"

#include "pipeline/parts/destroy_contact.h"
#include "state/frames.h"
#include "state/limits.h"
#include "world/guard.h"

namespace scree {

namespace {

/// Destroys the contacts of a body that satisfy the predicate. Their rows are used again after the next pair finding.
template <typename Predicate>
void DestroyIf(WorldState& s, int body, Predicate involves) {
    const WorldLock lock(s);
    s.contacts.RouseOf(body);  // so that its list stays as it is while callbacks ask for others
    DestroyContactsOfBodyIf(body, involves, s.Events(), s.bodies, s.contacts);
}

/// The coming step looks at the body and at its contacts.
void Stir(WorldState& s, int body) {
    s.isEdited = true;
    if (s.bodies.type[static_cast<size_t>(body)] != staticBody) s.bodies.List(body);
    s.contacts.RouseOf(body);
}

/// The next step asks the filters again about these contacts, and about pairs that have none.
template <typename Predicate>
void RefilterIf(WorldState& s, int body, Predicate involves) {
    Stir(s, body);
    for (const int c : s.contacts.OfBody(body)) {
        if (s.contacts.IsAlive(c) && involves(s.contacts.pair[static_cast<size_t>(c)])) {
            s.contacts.flags[static_cast<size_t>(c)] |= ContactFlag::refilter;
        }
    }
}

Motion MotionOf(BodyType type) {
    return type == staticBody ? Motion::isStatic : type == dynamicBody ? Motion::dynamic : Motion::kinematic;
}

}  // namespace

void ForgetGeometry(WorldState& s, int body) {
    NearStatics& near = s.continuousScratch.nearStatics;
    s.bodies.type[static_cast<size_t>(body)] == staticBody ? near.ForgetAll() : near.Forget(body);
    if (s.contacts.steady.empty()) return;
    for (const int contact : s.contacts.OfBody(body)) s.contacts.ForgetSteady(contact);
}

void NoteBodyEdit(WorldState& s, int body) {
    for (const int f : s.fixtures.From(s.bodies.fixtureHead[static_cast<size_t>(body)])) {
        s.edited.Add(static_cast<uint32_t>(f));
    }
    Stir(s, body);
}

void NoteParting(WorldState& s, int bodyA, int bodyB) {
    const auto count = [&](int body) { return s.bodies.info[static_cast<size_t>(body)].fixtureCount; };
    NoteBodyEdit(s, count(bodyA) <= count(bodyB) ? bodyA : bodyB);
}

void AddProxy(WorldState& s, int fixture) {
    const auto f = static_cast<size_t>(fixture);
    const auto b = static_cast<size_t>(s.fixtures.body[f]);
    const BodyPlace place(s.bodies, s.fixtures.body[f]);
    AABB box;
    s.fixtures.shape[f]->ComputeAABB(&box, place.xf);
    box = place.OutOf(box);
    s.edited.Add(static_cast<uint32_t>(fixture));
    s.broadPhase->Insert(static_cast<uint32_t>(fixture), static_cast<uint32_t>(b), MotionOf(s.bodies.type[b]), box);
    s.fixtures.info[f].inBroadPhase = true;
    ForgetGeometry(s, s.fixtures.body[f]);
    Stir(s, s.fixtures.body[f]);
}

void RestoreProxy(WorldState& s, int fixture, const AABB& box) {
    const auto body = static_cast<uint32_t>(s.fixtures.body[static_cast<size_t>(fixture)]);
    ForgetGeometry(s, static_cast<int>(body));
    s.broadPhase->Restore(static_cast<uint32_t>(fixture), body, MotionOf(s.bodies.type[body]), box);
}

void RemoveProxy(WorldState& s, int fixture) {
    FixtureInfo& info = s.fixtures.info[static_cast<size_t>(fixture)];
    if (!info.inBroadPhase) return;
    s.broadPhase->Remove(static_cast<uint32_t>(fixture));
    info.inBroadPhase = false;
    s.contacts.refused.Forget(static_cast<uint32_t>(fixture));
    ForgetGeometry(s, s.fixtures.body[static_cast<size_t>(fixture)]);
    s.isEdited = true;
}

void DestroyContactsOfFixture(WorldState& s, int fixture) {
    const auto f = static_cast<uint32_t>(fixture);
    DestroyIf(s, s.fixtures.body[f], [f](const ContactPair& p) { return p.fixtureA == f || p.fixtureB == f; });
}

void DestroyContactsOfChain(WorldState& s, int body, int chainId) {
    DestroyIf(s, body, [&](const ContactPair& p) {
        return s.fixtures.info[p.fixtureA].chainId == chainId || s.fixtures.info[p.fixtureB].chainId == chainId;
    });
}

void DestroyContactsOfBody(WorldState& s, int body) {
    DestroyIf(s, body, [](const ContactPair&) { return true; });
}

void RefilterFixture(WorldState& s, int fixture) {
    const auto f = static_cast<uint32_t>(fixture);
    s.contacts.refused.Forget(f);
    s.edited.Add(f);
    RefilterIf(s, s.fixtures.body[f], [f](const ContactPair& p) { return p.fixtureA == f || p.fixtureB == f; });
}

void RefilterBodies(WorldState& s, int bodyA, int bodyB) {
    RefilterIf(s, bodyA, [=](const ContactPair& p) { return p.bodyA == bodyB || p.bodyB == bodyB; });
}

void ResetMass(WorldState& s, int body) {
    ForgetGeometry(s, body);
    const auto b = static_cast<size_t>(body);
    BodyInfo& info = s.bodies.info[b];
    MassRow& row = s.bodies.mass[b];
    float& mass = s.bodies.motion[b].mass;
    mass = 0.0f;
    info.inertia = 0.0f;
    row.invMass = row.invI = 0.0f;
    if (s.bodies.type[b] != dynamicBody) {
        s.bodies.SetLocalCenter(b, vec2Zero);
        return;
    }
    Vec2 center = vec2Zero;
    for (const int f : s.fixtures.From(s.bodies.fixtureHead[b])) {
        const auto fi = static_cast<size_t>(f);
        const float density = s.fixtures.info[fi].density;
        if (density == 0.0f) continue;
        MassData part;
        s.fixtures.shape[fi]->ComputeMass(&part, density);
        mass += part.mass;
        center += part.mass * part.center;
        info.inertia += part.I;
    }
    row.invMass = UsableInverse(mass);
    center *= row.invMass;
    if (row.invMass == 0.0f) mass = 0.0f, center = vec2Zero;
    const bool turns = info.inertia > 0.0f && !s.bodies.Has(body, BodyFlag::fixedRotation);
    if (turns) info.inertia -= mass * Dot(center, center);
    row.invI = turns ? UsableInverse(info.inertia) : 0.0f;
    if (row.invI == 0.0f) info.inertia = 0.0f;
    Velocity& velocity = s.bodies.velocity[b];
    velocity.v += Cross(velocity.w, s.bodies.SetLocalCenter(b, center));
}

void NotePosition(WorldState& s, Vec2 position, Vec2 rest) {
    const bool hasRest = rest.x != 0.0f || rest.y != 0.0f;
    if (hasRest || IsFar(s, Max(Abs(position.x), Abs(position.y)))) s.bodies.EnsureRests();
}

}  // namespace scree
