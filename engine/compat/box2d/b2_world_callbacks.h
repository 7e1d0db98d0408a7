// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Classes to derive from in order to hear of what happens in a world. Callbacks come on the thread that calls;
// creating and destroying objects inside a step is refused (b2World::IsLocked).

#pragma once

#include "b2_api.h"
#include "b2_settings.h"

struct b2Vec2;
struct b2Transform;
class b2Fixture;
class b2Body;
class b2Joint;
class b2Contact;
struct b2ContactResult;
struct b2Manifold;

/// Hears of joints and fixtures that go with their body.
class B2_API b2DestructionListener {
public:
    virtual ~b2DestructionListener() {}

    virtual void SayGoodbye(b2Joint* joint) = 0;
    virtual void SayGoodbye(b2Fixture* fixture) = 0;
};

/// Decides which pairs of fixtures get a contact at all.
class B2_API b2ContactFilter {
public:
    virtual ~b2ContactFilter() {}

    /// By b2Filter unless overridden.
    virtual bool ShouldCollide(b2Fixture* fixtureA, b2Fixture* fixtureB);
};

/// Impulses of a step, one per manifold point.
struct B2_API b2ContactImpulse {
    float normalImpulses[b2_maxManifoldPoints];
    float tangentImpulses[b2_maxManifoldPoints];
    int32 count;
};

class B2_API b2ContactListener {
public:
    virtual ~b2ContactListener() {}

    /// Two fixtures begin, or cease, to touch.
    virtual void BeginContact(b2Contact* contact) { B2_NOT_USED(contact); }
    virtual void EndContact(b2Contact* contact) { B2_NOT_USED(contact); }
    /// A touching pair, no sensor, before it is solved.
    virtual void PreSolve(b2Contact* contact, const b2Manifold* oldManifold) {
        B2_NOT_USED(contact);
        B2_NOT_USED(oldManifold);
    }
    /// The same after it was solved.
    virtual void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) {
        B2_NOT_USED(contact);
        B2_NOT_USED(impulse);
    }
};

class B2_API b2QueryCallback {
public:
    virtual ~b2QueryCallback() {}

    /// A fixture found; false ends the query.
    virtual bool ReportFixture(b2Fixture* fixture) = 0;
};

class B2_API b2RayCastCallback {
public:
    virtual ~b2RayCastCallback() {}

    /// A fixture hit. Returns −1 to ignore it, 0 to end, `fraction` to shorten the ray, 1 to go on.
    virtual float ReportFixture(b2Fixture* fixture, const b2Vec2& point, const b2Vec2& normal, float fraction) = 0;
};
