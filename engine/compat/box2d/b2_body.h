// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A rigid body.

#pragma once

#include "b2_api.h"
#include "b2_math.h"
#include "b2_shape.h"

class b2Fixture;
class b2Joint;
class b2Contact;
class b2Controller;
class b2World;
struct b2FixtureDef;
struct b2JointEdge;
struct b2ContactEdge;
struct b2Bridge;

namespace scree {
class Body;
}

/// static: never moves by itself; kinematic: moves by its velocity; dynamic: moved by forces.
enum b2BodyType { b2_staticBody = 0, b2_kinematicBody, b2_dynamicBody };

/// Input of b2World::CreateBody.
struct B2_API b2BodyDef {
    b2BodyDef() {
        position.Set(0.0f, 0.0f);
        angle = 0.0f;
        linearVelocity.Set(0.0f, 0.0f);
        angularVelocity = 0.0f;
        linearDamping = 0.0f;
        angularDamping = 0.0f;
        allowSleep = true;
        awake = true;
        fixedRotation = false;
        bullet = false;
        type = b2_staticBody;
        enabled = true;
        gravityScale = 1.0f;
    }

    b2BodyType type;
    b2Vec2 position;
    float angle;
    b2Vec2 linearVelocity;
    float angularVelocity;
    float linearDamping;
    float angularDamping;
    bool allowSleep;
    bool awake;
    bool fixedRotation;
    bool bullet;
    bool enabled;
    b2BodyUserData userData;
    float gravityScale;
};

/// Made by b2World::CreateBody, gone with DestroyBody. References that its functions return stay valid as long as the
/// body and show the present value after the next call or step.
class B2_API b2Body {
public:
    /// Null, with a message, for bad input or while the world is locked.
    b2Fixture* CreateFixture(const b2FixtureDef* def);
    b2Fixture* CreateFixture(const b2Shape* shape, float density);
    void DestroyFixture(b2Fixture* fixture);

    void SetTransform(const b2Vec2& position, float angle);
    const b2Transform& GetTransform() const;
    const b2Vec2& GetPosition() const;
    /// Not wrapped.
    float GetAngle() const;
    const b2Vec2& GetWorldCenter() const;
    const b2Vec2& GetLocalCenter() const;

    void SetLinearVelocity(const b2Vec2& v);
    const b2Vec2& GetLinearVelocity() const;
    void SetAngularVelocity(float omega);
    float GetAngularVelocity() const;

    void ApplyForce(const b2Vec2& force, const b2Vec2& point, bool wake);
    void ApplyForceToCenter(const b2Vec2& force, bool wake);
    void ApplyTorque(float torque, bool wake);
    void ApplyLinearImpulse(const b2Vec2& impulse, const b2Vec2& point, bool wake);
    void ApplyLinearImpulseToCenter(const b2Vec2& impulse, bool wake);
    void ApplyAngularImpulse(float impulse, bool wake);

    float GetMass() const;
    /// About the origin of the body.
    float GetInertia() const;
    void GetMassData(b2MassData* data) const;
    void SetMassData(const b2MassData* data);
    void ResetMassData();

    b2Vec2 GetWorldPoint(const b2Vec2& localPoint) const;
    b2Vec2 GetWorldVector(const b2Vec2& localVector) const;
    b2Vec2 GetLocalPoint(const b2Vec2& worldPoint) const;
    b2Vec2 GetLocalVector(const b2Vec2& worldVector) const;
    b2Vec2 GetLinearVelocityFromWorldPoint(const b2Vec2& worldPoint) const;
    b2Vec2 GetLinearVelocityFromLocalPoint(const b2Vec2& localPoint) const;

    float GetLinearDamping() const;
    void SetLinearDamping(float linearDamping);
    float GetAngularDamping() const;
    void SetAngularDamping(float angularDamping);
    float GetGravityScale() const;
    void SetGravityScale(float scale);

    void SetType(b2BodyType type);
    b2BodyType GetType() const;
    void SetBullet(bool flag);
    bool IsBullet() const;
    void SetSleepingAllowed(bool flag);
    bool IsSleepingAllowed() const;
    void SetAwake(bool flag);
    bool IsAwake() const;
    void SetEnabled(bool flag);
    bool IsEnabled() const;
    void SetFixedRotation(bool flag);
    bool IsFixedRotation() const;

    /// Lists, newest first.
    b2Fixture* GetFixtureList();
    const b2Fixture* GetFixtureList() const;
    b2JointEdge* GetJointList();
    const b2JointEdge* GetJointList() const;
    b2ContactEdge* GetContactList();
    const b2ContactEdge* GetContactList() const;
    b2Body* GetNext();
    const b2Body* GetNext() const;

    b2BodyUserData& GetUserData();
    void SetUserData(void* data);
    b2World* GetWorld();
    const b2World* GetWorld() const;
    /// Writes nothing but a note to the log.
    void Dump();

private:
    friend struct b2Bridge;

    b2Body() {}
    ~b2Body() {}

    scree::Body* m_handle;
    b2World* m_world;
    b2Body* m_prev;
    b2Body* m_next;
    b2Fixture* m_fixtureList;
    b2JointEdge* m_jointList;
    b2ContactEdge* m_contactList;
    // What functions return by reference is copied here.
    mutable b2Transform m_xf;
    mutable b2Vec2 m_worldCenter;
    mutable b2Vec2 m_localCenter;
    mutable b2Vec2 m_linearVelocity;
    b2BodyUserData m_userData;
    int m_busy = 0;           ///< calls under way whose callbacks may not destroy it
    bool m_dying = false;     ///< no joint may be added
    bool m_goesBare = false;  ///< no fixture may be added
};
