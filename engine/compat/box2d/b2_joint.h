// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What is common to the joints of Box2D 2.4.

#pragma once

#include "b2_api.h"
#include "b2_math.h"

class b2Body;
class b2Draw;
class b2Joint;
struct b2SolverData;
class b2BlockAllocator;
struct b2Bridge;

namespace scree {
class Joint;
}

enum b2JointType {
    e_unknownJoint,
    e_revoluteJoint,
    e_prismaticJoint,
    e_distanceJoint,
    e_pulleyJoint,
    e_mouseJoint,
    e_gearJoint,
    e_wheelJoint,
    e_weldJoint,
    e_frictionJoint,
    e_ropeJoint,
    e_motorJoint
};

struct B2_API b2Jacobian {
    b2Vec2 linear;
    float angularA;
    float angularB;
};

/// A joint seen from one of its bodies, in that body's list.
struct B2_API b2JointEdge {
    b2Body* other;
    b2Joint* joint;
    b2JointEdge* prev;
    b2JointEdge* next;
};

/// Common input of all joints.
struct B2_API b2JointDef {
    b2JointDef() {
        type = e_unknownJoint;
        bodyA = nullptr;
        bodyB = nullptr;
        collideConnected = false;
    }

    /// Set by the definition of each joint.
    b2JointType type;
    b2JointUserData userData;
    b2Body* bodyA;
    b2Body* bodyB;
    /// Whether the two bodies may collide with each other.
    bool collideConnected;
};

/// Stiffness and damping of a spring between two bodies, from its frequency and damping ratio; linear and rotational.
B2_API void b2LinearStiffness(float& stiffness, float& damping, float frequencyHertz, float dampingRatio,
                              const b2Body* bodyA, const b2Body* bodyB);
B2_API void b2AngularStiffness(float& stiffness, float& damping, float frequencyHertz, float dampingRatio,
                               const b2Body* bodyA, const b2Body* bodyB);

/// Made by b2World::CreateJoint; gone with DestroyJoint, one of its bodies, or (a gear) one of its joints.
class B2_API b2Joint {
public:
    b2JointType GetType() const;
    b2Body* GetBodyA();
    b2Body* GetBodyB();
    /// In world coordinates.
    virtual b2Vec2 GetAnchorA() const;
    virtual b2Vec2 GetAnchorB() const;
    /// On body B, N and N·m; inv_dt is 1 / time step.
    virtual b2Vec2 GetReactionForce(float inv_dt) const;
    virtual float GetReactionTorque(float inv_dt) const;
    b2Joint* GetNext();
    const b2Joint* GetNext() const;
    b2JointUserData& GetUserData();
    /// Whether both bodies are.
    bool IsEnabled() const;
    bool GetCollideConnected() const;
    /// Writes nothing but a note to the log.
    virtual void Dump();
    /// Moves what is stored in world coordinates; b2World::ShiftOrigin does it for all joints.
    virtual void ShiftOrigin(const b2Vec2& newOrigin);
    virtual void Draw(b2Draw* draw) const;

protected:
    friend struct b2Bridge;

    b2Joint() {}
    virtual ~b2Joint() {}

    scree::Joint* m_handle;
    b2JointType m_type;
    b2Joint* m_prev;
    b2Joint* m_next;
    b2JointEdge m_edgeA;
    b2JointEdge m_edgeB;
    b2Body* m_bodyA;
    b2Body* m_bodyB;
    b2JointUserData m_userData;
    int m_busy = 0;  ///< calls under way whose callbacks may not destroy it
    // What functions return by reference.
    b2Vec2 m_localAnchorA;
    b2Vec2 m_localAnchorB;
    b2Vec2 m_localAxisA;
};
