// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Classes to derive from to hear of contacts and of destruction. Callbacks come on the thread that calls Step, in a
// deterministic order; creating and destroying objects inside them is refused (World::IsLocked).

#pragma once

#include "scree/api.h"
#include "scree/collision.h"
#include "scree/settings.h"

namespace scree {

class Contact;
class Fixture;
class Joint;

/// Impulses of one step, N·s.
struct ContactImpulse {
    float normalImpulses[maxManifoldPoints];
    float tangentImpulses[maxManifoldPoints];
    int count;
};

/// Decides which pairs get a contact at all.
class SCREE_API ContactFilter {
public:
    virtual ~ContactFilter() = default;
    /// The default looks at Filter: group first, then category and mask.
    virtual bool ShouldCollide(Fixture* fixtureA, Fixture* fixtureB);
};

/// Mixes the materials of fixtures with MixRule::custom: when their contact begins and when one of the materials
/// changes. It is asked inside of Step, must not change anything, and must give the same answers in a replay. What is
/// no finite number, and friction below 0, is replaced by the standard rule's.
class SCREE_API MaterialMixer {
public:
    virtual ~MaterialMixer() = default;
    virtual float MixFriction(const Fixture* fixtureA, const Fixture* fixtureB);
    virtual float MixRestitution(const Fixture* fixtureA, const Fixture* fixtureB);
};

/// Hears of objects that go because another is destroyed: the joints and fixtures of a body in World::DestroyBody. They
/// are still alive in the call; creating and destroying are refused there.
class SCREE_API DestructionListener {
public:
    virtual ~DestructionListener() = default;
    virtual void SayGoodbye(Joint* joint) = 0;
    virtual void SayGoodbye(Fixture* fixture) = 0;
};

/// Hears of contacts.
class SCREE_API ContactListener {
public:
    virtual ~ContactListener() = default;
    /// Two fixtures begin to touch (sensors too).
    virtual void BeginContact(Contact*) {}
    /// Two fixtures cease to touch; also outside of Step when something is destroyed.
    virtual void EndContact(Contact*) {}
    /// After the manifold is known and before it is solved; not for sensors.
    virtual void PreSolve(Contact*, const Manifold* /*oldManifold*/) {}
    /// After solving.
    virtual void PostSolve(Contact*, const ContactImpulse*) {}
};

}  // namespace scree
