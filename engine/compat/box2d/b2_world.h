// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The world: owns bodies, fixtures, contacts and joints and advances them in time.

#pragma once

#include <memory>

#include "b2_api.h"
#include "b2_block_allocator.h"
#include "b2_contact_manager.h"
#include "b2_math.h"
#include "b2_stack_allocator.h"
#include "b2_time_step.h"
#include "b2_world_callbacks.h"

struct b2AABB;
struct b2BodyDef;
struct b2Color;
struct b2JointDef;
struct b2Bridge;
struct b2WorldData;
class b2Body;
class b2Draw;
class b2Fixture;
class b2Joint;

class B2_API b2World {
public:
    b2World(const b2Vec2& gravity);
    ~b2World();
    b2World(const b2World&) = delete;
    b2World& operator=(const b2World&) = delete;

    /// Listeners stay the program's and must outlive their use. A null filter lets everything collide.
    void SetDestructionListener(b2DestructionListener* listener);
    void SetContactFilter(b2ContactFilter* filter);
    void SetContactListener(b2ContactListener* listener);
    void SetDebugDraw(b2Draw* debugDraw);

    /// Null, with a message, for bad input or while locked.
    b2Body* CreateBody(const b2BodyDef* def);
    void DestroyBody(b2Body* body);
    b2Joint* CreateJoint(const b2JointDef* def);
    void DestroyJoint(b2Joint* joint);

    void Step(float timeStep, int32 velocityIterations, int32 positionIterations);
    void ClearForces();
    void DebugDraw();
    /// Fixtures whose box overlaps; a chain once for each edge.
    void QueryAABB(b2QueryCallback* callback, const b2AABB& aabb) const;
    void RayCast(b2RayCastCallback* callback, const b2Vec2& point1, const b2Vec2& point2) const;

    /// Lists, newest first.
    b2Body* GetBodyList();
    const b2Body* GetBodyList() const;
    b2Joint* GetJointList();
    const b2Joint* GetJointList() const;
    b2Contact* GetContactList();
    const b2Contact* GetContactList() const;

    void SetAllowSleeping(bool flag);
    bool GetAllowSleeping() const;
    void SetWarmStarting(bool flag);
    bool GetWarmStarting() const;
    void SetContinuousPhysics(bool flag);
    bool GetContinuousPhysics() const;
    void SetSubStepping(bool flag);
    bool GetSubStepping() const;

    int32 GetProxyCount() const;
    int32 GetBodyCount() const;
    int32 GetJointCount() const;
    int32 GetContactCount() const;
    int32 GetTreeHeight() const;
    int32 GetTreeBalance() const;
    float GetTreeQuality() const;

    void SetGravity(const b2Vec2& gravity);
    b2Vec2 GetGravity() const;
    bool IsLocked() const;
    void SetAutoClearForces(bool flag);
    bool GetAutoClearForces() const;
    void ShiftOrigin(const b2Vec2& newOrigin);
    const b2ContactManager& GetContactManager() const;
    const b2Profile& GetProfile() const;
    /// Writes nothing but a note to the log.
    void Dump();

private:
    friend struct b2Bridge;

    std::unique_ptr<b2WorldData> m_data;
};
