// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The world: owns bodies, fixtures, contacts and joints and advances them in time.

#pragma once

#include <functional>
#include <limits>
#include <memory>

#include "scree/body.h"
#include "scree/broad_phase_kind.h"
#include "scree/contact.h"
#include "scree/errors.h"
#include "scree/fixture.h"
#include "scree/joint.h"
#include "scree/profile.h"
#include "scree/revolute_joint.h"
#include "scree/world_callbacks.h"

namespace scree {

/// Input of World. Defaults are Box2D 2.4's, except that nothing caps speed.
struct WorldDef {
    Vec2 gravity{0.0f, -10.0f};  ///< m/s²
    BroadPhaseKind broadPhase = BroadPhaseKind::automatic;
    /// Static fixtures get a tree of their own above this share of all fixtures, 0…1.
    float staticShareThreshold = 1.0f / 8.0f;
    bool allowSleep = true;
    bool warmStarting = true;
    /// Longest way a body may go in one step, m; longer ones are shortened and counted in StepReport::cappedCount.
    float maxTranslation = std::numeric_limits<float>::infinity();
    /// Largest turn of a body in one step, rad.
    float maxRotation = std::numeric_limits<float>::infinity();
};

struct WorldState;

class World {
public:
    explicit World(Vec2 gravity);
    explicit World(const WorldDef& def);
    ~World();
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    /// Null and an error for bad input or while locked. O(1).
    Body* CreateBody(const BodyDef* def);
    /// Destroys a body with its fixtures, contacts and joints.
    ErrorCode DestroyBody(Body* body);
    Joint* CreateJoint(const JointDef* def);
    ErrorCode DestroyJoint(Joint* joint);

    /// Advances by `timeStep` seconds (≥ 0; 0 only updates contacts) with sequential impulses. Box2D suggests 8
    /// velocity and 3 position iterations at 1/60 s. Bad input: an error and an unchanged world.
    StepReport Step(float timeStep, int velocityIterations, int positionIterations);
    [[nodiscard]] const StepReport& GetReport() const;

    /// The listener and filter must outlive their use; null restores the default.
    void SetContactListener(ContactListener* listener);
    void SetContactFilter(ContactFilter* filter);
    /// Receives every refused call; null restores the default, which writes one line to stderr.
    void SetErrorHandler(ErrorHandler handler, void* context);

    /// Forces live until the end of the step; off: until ClearForces.
    void SetAutoClearForces(bool flag);
    [[nodiscard]] bool GetAutoClearForces() const;
    void ClearForces();
    ErrorCode SetGravity(Vec2 gravity);
    [[nodiscard]] Vec2 GetGravity() const;
    /// Turning sleep off wakes everything.
    void SetAllowSleeping(bool flag);
    [[nodiscard]] bool GetAllowSleeping() const;
    void SetWarmStarting(bool flag);
    [[nodiscard]] bool GetWarmStarting() const;
    /// True inside Step.
    [[nodiscard]] bool IsLocked() const;

    /// Lists: movers first, then static bodies; newest first in each.
    [[nodiscard]] Body* GetBodyList();
    [[nodiscard]] const Body* GetBodyList() const;
    [[nodiscard]] Joint* GetJointList();
    [[nodiscard]] Contact* GetContactList();
    [[nodiscard]] int GetBodyCount() const;
    [[nodiscard]] int GetJointCount() const;
    [[nodiscard]] int GetContactCount() const;
    [[nodiscard]] int GetFixtureCount() const;
    [[nodiscard]] int GetProxyCount() const;

    /// Calls visit(fixture) for every fixture whose broad-phase box overlaps `aabb`, until it returns false.
    ErrorCode QueryAABB(const AABB& aabb, const std::function<bool(Fixture*)>& visit);
    /// Calls visit(fixture, point, normal, fraction) for fixtures that the ray p1→p2 hits, in no particular order. It
    /// returns −1 to ignore the fixture, 0 to stop, the fraction to shorten the ray, 1 to go on.
    ErrorCode RayCast(Vec2 p1, Vec2 p2, const std::function<float(Fixture*, Vec2, Vec2, float)>& visit);

    /// The tables behind the handles, for inspect.h.
    [[nodiscard]] WorldState& GetState() { return *m_state; }
    [[nodiscard]] const WorldState& GetState() const { return *m_state; }

private:
    std::unique_ptr<WorldState> m_state;
};

}  // namespace scree
