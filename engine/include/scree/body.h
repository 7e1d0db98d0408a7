// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Rigid bodies.

#pragma once

#include <cstdint>

#include "scree/api.h"
#include "scree/errors.h"
#include "scree/fixture.h"
#include "scree/function_ref.h"
#include "scree/math.h"
#include "scree/shape.h"

namespace scree {

class Contact;
class Joint;
class World;
enum class BodyIndex : int;  // state/indices.h

/// static: never moves by itself; kinematic: moves by its velocity, infinite mass; dynamic: moved by forces.
enum BodyType : uint8_t { staticBody = 0, kinematicBody, dynamicBody };

/// Application data of a body.
struct BodyUserData {
    uintptr_t pointer = 0;
};

/// Motions that are locked, whatever acts on a dynamic body: along the world's x or y, or rotation. A step makes the
/// velocity along a locked axis 0. A locked angle is Box2D's fixed rotation: nothing turns the body, but a spin that
/// you give it goes on.
struct MotionLocks {
    bool x = false, y = false, angle = false;
    friend bool operator==(const MotionLocks&, const MotionLocks&) = default;
};

/// Input of World::CreateBody. Every number must be finite.
struct BodyDef {
    BodyType type = staticBody;
    Vec2 position{0.0f, 0.0f};        ///< of the body's origin, m
    Vec2 positionRest{0.0f, 0.0f};    ///< digits that do not fit into `position`, m: the origin is at the sum
    float angle = 0.0f;               ///< rad
    Vec2 linearVelocity{0.0f, 0.0f};  ///< of the origin, m/s
    float angularVelocity = 0.0f;     ///< rad/s
    float linearDamping = 0.0f;       ///< ≥ 0, 1/s
    float angularDamping = 0.0f;      ///< ≥ 0, 1/s
    bool allowSleep = true;
    bool awake = true;
    bool fixedRotation = false;
    bool bullet = false;
    bool enabled = true;
    BodyUserData userData;
    float gravityScale = 1.0f;
    MotionLocks locks;  ///< `locks.angle` and `fixedRotation` are the same: either one locks the angle
};

/// A handle of a body, created by World::CreateBody and valid until World::DestroyBody. Afterwards every call reports
/// an error (ErrorCode::foreignHandle) and returns 0, false or null.
class SCREE_API Body {
public:
    /// Attaches a fixture and updates the mass if its density is not 0. Returns null (and changes nothing) for a null
    /// shape, a degenerate shape, a number out of range, or while the world is locked. A ChainShape makes one fixture
    /// per segment, each with the def's material, filter and sensor flag; the first is returned.
    Fixture* CreateFixture(const FixtureDef* def);
    /// Short form with default material.
    Fixture* CreateFixture(const Shape* shape, float density);
    /// Detaches and destroys a fixture with its contacts and updates the mass.
    ErrorCode DestroyFixture(Fixture* fixture);

    /// Destroys all edges of the chain that `fixture` belongs to.
    ErrorCode DestroyChain(Fixture* fixture);

    /// Moves the body at once; its contacts follow in the next step. Its origin is then at position + positionRest, m.
    /// Refused while the world is locked.
    ErrorCode SetTransform(Vec2 position, float angle, Vec2 positionRest = {0.0f, 0.0f});
    /// Gives the body the velocity with which a step of `timeStep` > 0 s takes its origin to `position` and its angle
    /// to `angle`. So a kinematic body carries or pushes what it touches. Refused: a static body.
    ErrorCode SetTargetTransform(Vec2 position, float angle, float timeStep);
    [[nodiscard]] Transform GetTransform() const;
    [[nodiscard]] Vec2 GetPosition() const;
    [[nodiscard]] float GetAngle() const;
    [[nodiscard]] Vec2 GetWorldCenter() const;
    /// Digits that do not fit into GetPosition and GetWorldCenter, m. Far from the origin (WorldDef::farDistance) the
    /// body is at the sum of both; add them in double. 0 in worlds without far bodies.
    [[nodiscard]] Vec2 GetPositionRest() const;
    [[nodiscard]] Vec2 GetWorldCenterRest() const;
    [[nodiscard]] Vec2 GetLocalCenter() const;

    /// Velocity of the centre of mass, m/s. Static bodies ignore it; a non-zero one wakes the body.
    ErrorCode SetLinearVelocity(Vec2 v);
    [[nodiscard]] Vec2 GetLinearVelocity() const;
    ErrorCode SetAngularVelocity(float omega);
    [[nodiscard]] float GetAngularVelocity() const;

    /// Force in N at a world point, for the next step. Dynamic bodies only; `wake` wakes a sleeping one.
    ErrorCode ApplyForce(Vec2 force, Vec2 point, bool wake);
    ErrorCode ApplyForceToCenter(Vec2 force, bool wake);
    /// Torque in N·m.
    ErrorCode ApplyTorque(float torque, bool wake);
    /// Impulse in N·s at a world point, at once.
    ErrorCode ApplyLinearImpulse(Vec2 impulse, Vec2 point, bool wake);
    ErrorCode ApplyLinearImpulseToCenter(Vec2 impulse, bool wake);
    /// Impulse in N·m·s.
    ErrorCode ApplyAngularImpulse(float impulse, bool wake);

    /// kg. A dynamic body has mass 0 until it gets a fixture with density or SetMassData; forces do not move it then.
    [[nodiscard]] float GetMass() const;
    /// About the body's origin, kg·m².
    [[nodiscard]] float GetInertia() const;
    void GetMassData(MassData* data) const;
    /// Replaces the mass data of the fixtures until the next ResetMassData. Dynamic bodies only.
    ErrorCode SetMassData(const MassData* data);
    /// Recomputes mass, centre and inertia from the fixtures.
    void ResetMassData();

    [[nodiscard]] Vec2 GetWorldPoint(Vec2 localPoint) const;
    [[nodiscard]] Vec2 GetWorldVector(Vec2 localVector) const;
    [[nodiscard]] Vec2 GetLocalPoint(Vec2 worldPoint) const;
    [[nodiscard]] Vec2 GetLocalVector(Vec2 worldVector) const;
    [[nodiscard]] Vec2 GetLinearVelocityFromWorldPoint(Vec2 worldPoint) const;
    [[nodiscard]] Vec2 GetLinearVelocityFromLocalPoint(Vec2 localPoint) const;

    [[nodiscard]] float GetLinearDamping() const;
    ErrorCode SetLinearDamping(float damping);
    [[nodiscard]] float GetAngularDamping() const;
    ErrorCode SetAngularDamping(float damping);
    [[nodiscard]] float GetGravityScale() const;
    ErrorCode SetGravityScale(float scale);

    [[nodiscard]] BodyType GetType() const;
    /// Changes the type at once: computes the mass, removes contacts until the next step, wakes the body and clears
    /// its forces; a body that becomes static stops. Refused while the world is locked.
    ErrorCode SetType(BodyType type);
    ErrorCode SetBullet(bool flag);
    [[nodiscard]] bool IsBullet() const;
    /// If false, the body wakes and never falls asleep.
    ErrorCode SetSleepingAllowed(bool flag);
    [[nodiscard]] bool IsSleepingAllowed() const;
    /// False puts the body to sleep, which clears velocity and forces.
    ErrorCode SetAwake(bool flag);
    [[nodiscard]] bool IsAwake() const;
    /// A disabled body keeps its state but neither moves nor collides. Refused while the world is locked.
    ErrorCode SetEnabled(bool flag);
    [[nodiscard]] bool IsEnabled() const;
    ErrorCode SetFixedRotation(bool flag);
    [[nodiscard]] bool IsFixedRotation() const;
    /// Locks and unlocks motions; the angle as SetFixedRotation does. A motion that is locked now stops.
    ErrorCode SetMotionLocks(const MotionLocks& locks);
    [[nodiscard]] MotionLocks GetMotionLocks() const;

    /// Fixtures, newest first.
    [[nodiscard]] Fixture* GetFixtureList();
    [[nodiscard]] const Fixture* GetFixtureList() const;
    /// Number of contacts of this body, touching or not. O(contacts of the body); the first call after a step that
    /// added contacts costs O(contacts of the world).
    [[nodiscard]] int GetContactCount() const;
    /// Calls visit(contact) for each of them, newest first, until it returns false.
    void VisitContacts(FunctionRef<bool(Contact*)> visit) const;
    /// Calls visit(joint) for each joint of this body, newest first, until it returns false.
    void VisitJoints(FunctionRef<bool(Joint*)> visit) const;
    [[nodiscard]] int GetJointCount() const;
    /// The newest joint of this body, or null; Joint::GetNext(body) gives the next.
    [[nodiscard]] Joint* GetJointList() const;
    /// The next body of the world: bodies that can move come first, then static ones, newest first; null at the end.
    [[nodiscard]] Body* GetNext();
    [[nodiscard]] const Body* GetNext() const;
    [[nodiscard]] BodyUserData GetUserData() const;
    ErrorCode SetUserData(const BodyUserData& data);
    [[nodiscard]] World* GetWorld();
    /// Number of this body in its world, from 0; used again after destruction.
    [[nodiscard]] int GetIndex() const { return static_cast<int>(m_index); }

    Body(WorldState* state, BodyIndex index) : m_state(state), m_index(index) {}
    Body(const Body&) = delete;
    Body& operator=(const Body&) = delete;

private:
    [[nodiscard]] Vec2 FromCentre(Vec2 worldPoint) const;
    [[nodiscard]] bool Lives(const char* accessor) const;

    WorldState* m_state;
    BodyIndex m_index;
};

}  // namespace scree
