// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A contact: two fixtures (children of fixtures) whose boxes overlap; they may touch or not.

#pragma once

#include "b2_api.h"
#include "b2_collision.h"
#include "b2_fixture.h"
#include "b2_math.h"
#include "b2_shape.h"

class b2Body;
class b2Contact;
class b2Fixture;
class b2World;
class b2BlockAllocator;
class b2StackAllocator;
class b2ContactListener;
struct b2Bridge;

namespace scree {
class Contact;
}

/// Materials of two fixtures: geometric mean, the larger, the smaller.
inline float b2MixFriction(float friction1, float friction2) { return b2Sqrt(friction1 * friction2); }
inline float b2MixRestitution(float restitution1, float restitution2) {
    return restitution1 > restitution2 ? restitution1 : restitution2;
}
inline float b2MixRestitutionThreshold(float threshold1, float threshold2) {
    return threshold1 < threshold2 ? threshold1 : threshold2;
}

typedef b2Contact* b2ContactCreateFcn(b2Fixture* fixtureA, int32 indexA, b2Fixture* fixtureB, int32 indexB,
                                      b2BlockAllocator* allocator);
typedef void b2ContactDestroyFcn(b2Contact* contact, b2BlockAllocator* allocator);

struct B2_API b2ContactRegister {
    b2ContactCreateFcn* createFcn;
    b2ContactDestroyFcn* destroyFcn;
    bool primary;
};

/// A contact seen from one of its bodies, in that body's list.
struct B2_API b2ContactEdge {
    b2Body* other;
    b2Contact* contact;
    b2ContactEdge* prev;
    b2ContactEdge* next;
};

/// The same object as long as the pair's boxes overlap.
class B2_API b2Contact {
public:
    /// What a callback changes in it goes to the solver.
    b2Manifold* GetManifold();
    const b2Manifold* GetManifold() const;
    void GetWorldManifold(b2WorldManifold* worldManifold) const;
    bool IsTouching() const;
    /// For the present step only.
    void SetEnabled(bool flag);
    bool IsEnabled() const;
    b2Contact* GetNext();
    const b2Contact* GetNext() const;
    b2Fixture* GetFixtureA();
    const b2Fixture* GetFixtureA() const;
    int32 GetChildIndexA() const;
    b2Fixture* GetFixtureB();
    const b2Fixture* GetFixtureB() const;
    int32 GetChildIndexB() const;
    void SetFriction(float friction);
    float GetFriction() const;
    void ResetFriction();
    void SetRestitution(float restitution);
    float GetRestitution() const;
    void ResetRestitution();
    void SetRestitutionThreshold(float threshold);
    float GetRestitutionThreshold() const;
    void ResetRestitutionThreshold();
    void SetTangentSpeed(float speed);
    float GetTangentSpeed() const;
    /// The manifold of the two shapes at other poses.
    virtual void Evaluate(b2Manifold* manifold, const b2Transform& xfA, const b2Transform& xfB) = 0;

protected:
    friend struct b2Bridge;

    b2Contact() {}
    virtual ~b2Contact() {}

    scree::Contact* m_handle;  ///< null: the engine's contact is gone, what it was is copied below
    b2Contact* m_prev;
    b2Contact* m_next;
    b2ContactEdge m_nodeA;
    b2ContactEdge m_nodeB;
    b2Fixture* m_fixtureA;
    b2Fixture* m_fixtureB;
    int32 m_indexA;
    int32 m_indexB;
    float m_friction;
    float m_restitution;
    float m_restitutionThreshold;
    float m_tangentSpeed;
    mutable b2Manifold m_manifold;
    bool m_enabled;
    bool m_ending = false;           ///< its end is being told outside of a step
    mutable bool m_manifoldExposed;  ///< the program may have changed m_manifold since the callback began
};
