// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What edits between steps must keep true: proxies of fixtures, pairs, filters of contacts.

#pragma once

#include "world/guard.h"
#include "world/world_state.h"

namespace scree {

/// Tells the destruction listener of an object that goes because another does.
template <typename Object>
void SayGoodbye(WorldState& state, Object* object) {
    if (state.destructionListener == nullptr) return;
    const WorldLock lock(state);
    state.destructionListener->SayGoodbye(object);
}

/// What continuous collision knows about static fixtures near the body is forgotten; of all bodies if it is static.
void ForgetGeometry(WorldState& state, BodyIndex body);
/// The boxes of the body have been edited: the coming step finds its pairs again and looks at it.
void NoteBodyEdit(WorldState& state, BodyIndex body);
/// A fixture has got another shape: the coming step finds its pairs again. Its body wakes, and so does what it touches.
void NoteShapeEdit(WorldState& state, FixtureIndex fixture);
/// Of a fixture that has been given a shape: the default skin is for bodies of the default size.
void ScaleDefaultSkin(WorldState& state, FixtureIndex fixture);
/// The pairs of two bodies may have contacts again.
void NoteParting(WorldState& state, BodyIndex bodyA, BodyIndex bodyB);
/// Gives a fixture its proxy, or takes it away (with its contacts).
void AddProxy(WorldState& state, FixtureIndex fixture);
void RemoveProxy(WorldState& state, FixtureIndex fixture);
/// Gives the broad phase back a fixture of a restored world, with the box it had there.
void RestoreProxy(WorldState& state, FixtureIndex fixture, const AABB& box);
/// Destroys the contacts of a fixture, of a chain of a body, or of a body, at once.
void DestroyContactsOfFixture(WorldState& state, FixtureIndex fixture);
void DestroyContactsOfChain(WorldState& state, BodyIndex body, int chainId);
void DestroyContactsOfBody(WorldState& state, BodyIndex body);
/// Lets the next step ask the filters again about the contacts of a fixture, or between two bodies.
void RefilterFixture(WorldState& state, FixtureIndex fixture);
void RefilterBodies(WorldState& state, BodyIndex bodyA, BodyIndex bodyB);
/// Mass, centre and inertia of a body from its fixtures.
void ResetMass(WorldState& state, BodyIndex body);

/// A body with such a coordinate, m, makes the positions of the world have rests (WorldDef::farDistance).
inline bool IsFar(const WorldState& s, float coordinate) { return coordinate > s.FarDistance(); }
/// Makes them have rests if this position calls for it.
void NotePosition(WorldState& s, Vec2 position, Vec2 rest);

}  // namespace scree
