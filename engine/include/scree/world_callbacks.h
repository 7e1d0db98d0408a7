// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Base classes for listeners of contacts and of destruction. Callbacks run on the thread that calls Step, in a
// deterministic order. Creating and destroying objects inside them is refused (World::IsLocked).

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

/// Mixes the materials of fixtures with MixRule::custom, when their contact begins and when one of the materials
/// changes. It is called inside Step, must not change anything, and must return the same in a replay. The standard rule
/// replaces a result that is NaN or infinite, and friction below 0.
class SCREE_API MaterialMixer {
public:
    virtual ~MaterialMixer() = default;
    virtual float MixFriction(const Fixture* fixtureA, const Fixture* fixtureB);
    virtual float MixRestitution(const Fixture* fixtureA, const Fixture* fixtureB);
};

/// Is told of objects that are destroyed with another one, such as the joints and fixtures of a body. They still exist
/// during the call, in which creating and destroying is refused.
class SCREE_API DestructionListener {
public:
    virtual ~DestructionListener() = default;
    virtual void SayGoodbye(Joint* joint) = 0;
    virtual void SayGoodbye(Fixture* fixture) = 0;
};

/// Is told of contacts.
class SCREE_API ContactListener {
public:
    virtual ~ContactListener() = default;
    /// Two fixtures begin to touch; sensors, too.
    virtual void BeginContact(Contact*) {}
    /// Two fixtures stop touching; also outside of Step if something is destroyed.
    virtual void EndContact(Contact*) {}
    /// After the manifold is known and before it is solved; not for sensors.
    virtual void PreSolve(Contact*, const Manifold* /*oldManifold*/) {}
    /// After solving.
    virtual void PostSolve(Contact*, const ContactImpulse*) {}
};

}  // namespace scree
