// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A fixture attaches a shape to a body.

#pragma once

#include "b2_api.h"
#include "b2_body.h"
#include "b2_collision.h"
#include "b2_shape.h"

class b2BlockAllocator;
class b2Body;
class b2BroadPhase;
class b2Fixture;
struct b2Bridge;

namespace scree {
class Fixture;
}

/// Which fixtures collide: equal groups other than 0 decide, then the masks.
struct B2_API b2Filter {
    b2Filter() {
        categoryBits = 0x0001;
        maskBits = 0xFFFF;
        groupIndex = 0;
    }

    uint16 categoryBits;
    uint16 maskBits;
    int16 groupIndex;
};

/// Input of b2Body::CreateFixture.
struct B2_API b2FixtureDef {
    b2FixtureDef() {
        shape = nullptr;
        friction = 0.2f;
        restitution = 0.0f;
        restitutionThreshold = 1.0f * b2_lengthUnitsPerMeter;
        density = 0.0f;
        isSensor = false;
    }

    /// Required; copied.
    const b2Shape* shape;
    b2FixtureUserData userData;
    float friction;
    float restitution;
    float restitutionThreshold;
    float density;
    bool isSensor;
    b2Filter filter;
};

/// One child of a fixture in the broad phase; the user data of b2BroadPhase and of QueryCallback.
struct B2_API b2FixtureProxy {
    b2AABB aabb;
    b2Fixture* fixture;
    int32 childIndex;
    int32 proxyId;
};

/// Made by b2Body::CreateFixture, gone with DestroyFixture or its body.
class B2_API b2Fixture {
public:
    b2Shape::Type GetType() const;
    /// The fixture's own copy. It may be changed; the next step works with the change.
    b2Shape* GetShape();
    const b2Shape* GetShape() const;
    void SetSensor(bool sensor);
    bool IsSensor() const;
    void SetFilterData(const b2Filter& filter);
    const b2Filter& GetFilterData() const;
    /// Asks the filters again in the next step.
    void Refilter();
    b2Body* GetBody();
    const b2Body* GetBody() const;
    /// The next fixture of the body, newest first.
    b2Fixture* GetNext();
    const b2Fixture* GetNext() const;
    b2FixtureUserData& GetUserData();
    bool TestPoint(const b2Vec2& p) const;
    bool RayCast(b2RayCastOutput* output, const b2RayCastInput& input, int32 childIndex) const;
    void GetMassData(b2MassData* massData) const;
    /// The body's mass follows with b2Body::ResetMassData.
    void SetDensity(float density);
    float GetDensity() const;
    /// For new contacts.
    float GetFriction() const;
    void SetFriction(float friction);
    float GetRestitution() const;
    void SetRestitution(float restitution);
    float GetRestitutionThreshold() const;
    void SetRestitutionThreshold(float threshold);
    /// The box the broad phase has of a child.
    const b2AABB& GetAABB(int32 childIndex) const;
    /// Writes nothing but a note to the log.
    void Dump(int32 bodyIndex);

private:
    friend struct b2Bridge;

    b2Fixture() {}
    ~b2Fixture() {}

    b2Fixture* m_next;
    b2Body* m_body;
    b2Shape* m_shape;
    scree::Fixture** m_handles;  ///< the engine's fixture of each child
    b2FixtureProxy* m_proxies;
    int32 m_childCount;
    bool m_shapeExposed;  ///< the program has a pointer through which it may change the shape
    float m_density;
    mutable b2Filter m_filter;
    b2FixtureUserData m_userData;
    int m_busy = 0;  ///< calls under way whose callbacks may not destroy it
};
