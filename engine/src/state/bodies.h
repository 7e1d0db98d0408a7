// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The table of bodies: one column per thing that a stage reads or writes together. A row is a body's index for life;
// freed rows are used again.

#pragma once

#include <deque>
#include <span>
#include <vector>

#include "base/index_set.h"
#include "base/shared_count.h"
#include "base/slots.h"
#include "scree/body.h"
#include "scree/math.h"

namespace scree {

/// Of the centre of mass. 16 bytes, so that a row is one aligned load.
struct alignas(16) Velocity {
    Vec2 v;
    float w;
    float unused;
};

/// Centre of mass and angle. 16 bytes.
struct alignas(16) Position {
    Vec2 c;
    float a;
    float aRest;  ///< what the angle lacks below its last digit, rad; kept by the soft step
};

/// What the centre of a body far from the origin lacks below the last digit of `position` and `startPosition`, m: it is
/// at c + rest, exactly. 16 bytes.
struct alignas(16) PositionRest {
    Vec2 end{0.0f, 0.0f}, start{0.0f, 0.0f};
};

/// What the constraints need of a mass. 16 bytes; all zero for static and kinematic bodies but the centre.
struct alignas(16) MassRow {
    float invMass;  ///< 1/kg
    float invI;     ///< about the centre of mass, 1/(kg·m²)
    Vec2 localCenter;
};

/// 16 bytes.
struct alignas(16) ForceRow {
    Vec2 force;  ///< N
    float torque;
    float unused;
};

/// 16 bytes.
struct alignas(16) MotionRow {
    float linearDamping, angularDamping, gravityScale;
    float mass;  ///< kg; 0 for static and kinematic bodies
};

/// What a step with a tolerance found at a body; the next one picks its sub-steps from it.
struct BodyDemand {
    float overlap = 0.0f;   ///< deepest, of the skins, m
    float jointGap = 0.0f;  ///< largest, m
    float pullRate = 0.0f;  ///< how fast pulled links swing, 1/s (JointTree::NotePullRates)
    int substeps = 0;       ///< of that step; 0: there was none
    float wanted = 0.0f;    ///< sub-steps that the body called for by itself; falls slowly
};

struct BodyFlag {
    static constexpr uint16_t awake = 1, autoSleep = 2, bullet = 4, fixedRotation = 8, enabled = 16;
    static constexpr uint16_t lockX = 32, lockY = 64;  ///< of dynamic bodies
};

/// Cold data of a body.
struct BodyInfo {
    float inertia = 0.0f;  ///< about the centre of mass
    int fixtureCount = 0;
    int jointCount = 0;
    int listPrev = -1, listNext = -1;
    int moverRow = -1;  ///< position in BodyTable::movers, −1 for static bodies
    BodyUserData userData;
};

struct BodyTable {
    Slots slots;
    std::vector<Velocity> velocity;
    std::vector<Velocity> startVelocity;  ///< at the start of the last step; empty until a step drifts exactly
    std::vector<Position> position;       ///< at the end of the last step
    std::vector<Position> startPosition;  ///< at its start
    std::vector<PositionRest> rest;       ///< empty until a body is far (WorldDef::farDistance): all are 0
    std::vector<Transform> transform;     ///< of the origin
    std::vector<MassRow> mass;
    std::vector<ForceRow> force;  ///< empty until a step or a call needs it: nobody has any
    std::vector<MotionRow> motion;
    std::vector<BodyDemand> demand;  ///< empty until a step has a tolerance
    std::vector<float> sleepTime;    ///< s
    std::vector<uint16_t> flags;     ///< BodyFlag
    std::vector<BodyType> type;
    std::vector<int> fixtureHead;  ///< first fixture, newest first; −1 none (FixtureTable::From)
    std::vector<BodyInfo> info;
    std::deque<Body> handles;

    std::vector<int> movers;  ///< enabled or not: every body that is not static
    int listHead = -1;        ///< movers first, then static bodies
    int lastMover = -1;       ///< last mover in the list

    // Which movers a step looks at: all that are awake are listed, and some that are not, such as those edited since
    // the last step. The others rest: no stage visits them. Whether a body that is asleep is listed changes no result.
    IndexSet listedRows;            ///< rows of `movers`
    IndexSet kinematicRows;         ///< likewise, of kinematic bodies
    std::vector<uint8_t> isListed;  ///< per body
    std::vector<int> risen;         ///< bodies listed again, whose contacts still rest
    std::vector<int> risenProxies;  ///< and those whose proxies do
    int fellAsleep = 0;             ///< bodies put to sleep since sleepers were last unlisted, about

    [[nodiscard]] bool Has(int body, uint16_t flag) const { return (flags[static_cast<size_t>(body)] & flag) != 0; }
    /// Simulated in a step: awake, enabled, not static.
    [[nodiscard]] bool IsActive(int body) const {
        constexpr uint16_t both = BodyFlag::awake | BodyFlag::enabled;
        return (flags[static_cast<size_t>(body)] & both) == both && type[static_cast<size_t>(body)] != staticBody;
    }
    /// Adds a row with every column; the definition is valid.
    int Add(WorldState* state, const BodyDef& def);
    void Remove(int body);
    /// Wakes and restarts the sleep timer; static bodies stay as they are.
    void Wake(int body);
    /// Wakes a mover without a new sleep timer.
    void WakeReached(int body) {
        flags[static_cast<size_t>(body)] |= BodyFlag::awake;
        List(body);
    }
    /// Lets the coming step look at a mover.
    void List(int body) {
        if (isListed[static_cast<size_t>(body)] != 0) return;
        Enlist(body);
        risen.push_back(body);
        risenProxies.push_back(body);
        if (!Has(body, BodyFlag::awake)) fellAsleep = 1;
    }
    /// The mover rests from now on.
    void Unlist(int body);
    /// The listed movers, in the order of `movers`. Valid until one is listed or unlisted.
    [[nodiscard]] std::span<const int> Listed() const {
        if (m_listedChanged) RefreshListed();
        return m_listed;
    }
    [[nodiscard]] bool AreAllListed() const { return static_cast<size_t>(listedRows.Count()) == movers.size(); }
    /// After the fields were read: lists every mover.
    void ListAll();
    /// After a change of type.
    void NoteKinematic(int body);
    /// Adds the kinematic bodies that rest to a list of bodies in the order of `movers`.
    void AddRestingKinematics(std::vector<int>& bodies) const;
    void PutToSleep(int body);
    /// Positions have rests.
    [[nodiscard]] bool IsFar() const { return !rest.empty(); }
    /// Makes `rest` a column like the others; without bodies, from the first one on.
    void EnsureRests() { EnsureRows(rest, position.empty() ? 1 : position.size()); }
    [[nodiscard]] Vec2 GetRest(int body) const { return rest.empty() ? vec2Zero : rest[static_cast<size_t>(body)].end; }
    /// The body starts the step where it is.
    void NoteStart(size_t b) {
        startPosition[b] = position[b];
        if (IsFar()) rest[b].start = rest[b].end;
    }
    /// The body goes back to where it started the step.
    void ReturnToStart(size_t b) {
        position[b] = startPosition[b];
        if (IsFar()) rest[b].end = rest[b].start;
    }
    /// Moves the centre. Far from the origin only the rest changes until UpdateTransform.
    void Shift(size_t b, Vec2 way) { (IsFar() ? rest[b].end : position[b].c) += way; }
    /// Puts the centre where it was at the start of the step plus `way`; the same.
    void SetMotion(size_t b, Vec2 way) {
        position[b].c = IsFar() ? startPosition[b].c : startPosition[b].c + way;
        if (IsFar()) rest[b].end = rest[b].start + way;
    }
    /// The way of the centre since the start of the step.
    [[nodiscard]] Vec2 GetMotion(size_t b) const {
        const Vec2 way = position[b].c - startPosition[b].c;
        return IsFar() ? way + (rest[b].end - rest[b].start) : way;
    }
    /// The origin that belongs to `position`, from the rotation that `transform` has.
    void UpdateOrigin(size_t b) {
        const Vec2 arm = Mul(transform[b].q, mass[b].localCenter);
        if (IsFar()) return UpdateFarOrigin(b, arm);
        transform[b].p = position[b].c - arm;
    }
    /// What `transform[body].p` lacks below its last digit, m.
    [[nodiscard]] Vec2 GetOriginRest(int body) const;
    /// Puts the origin to p + rest with the angle `a`, and the start of the step there.
    void Place(size_t b, Vec2 p, Vec2 originRest, float a);
    /// Moves the centre of mass within the body, which stays where it is. Returns how far.
    Vec2 SetLocalCenter(size_t b, Vec2 center);
    /// Subtracts `newOrigin` from the positions.
    void ShiftOrigin(size_t b, Vec2 newOrigin);
    /// The transform that belongs to `position`.
    void UpdateTransform(int body);
    /// Makes `force` a column like the others.
    void EnsureForces() { EnsureRows(force, position.size()); }
    [[nodiscard]] ForceRow GetForce(int body) const {
        return force.empty() ? ForceRow{vec2Zero, 0.0f, 0.0f} : force[static_cast<size_t>(body)];
    }
    void ClearForce(int body) {
        if (!force.empty()) force[static_cast<size_t>(body)] = {vec2Zero, 0.0f, 0.0f};
    }
    /// After a change of type: list and movers.
    void Relist(int body);

    template <typename Self, typename Visit>
    static void Fields(Self& t, Visit& visit) {
        auto& [slots, velocity, startVelocity, position, startPosition, rest, transform, mass, force, motion, demand,
               sleepTime, flags, type, fixtureHead, info, handles, movers, listHead, lastMover, listedRows,
               kinematicRows, isListed, risen, risenProxies, fellAsleep, listed, listedChanged] = t;
        visit(slots), visit.Hashed(t.IsFar());
        visit.Rows(slots, velocity, startVelocity, position, startPosition, rest, transform, mass, force, motion,
                   demand, sleepTime, flags, type, fixtureHead, info);
        visit(movers, listHead, lastMover);
        visit.LeftOut(handles, listedRows, kinematicRows, isListed, risen, risenProxies, fellAsleep, listed,
                      listedChanged);
    }

private:
    /// The same with rests, each of which it makes as small as it can be.
    void UpdateFarOrigin(size_t b, Vec2 arm);
    void Link(int body);
    void Unlink(int body);
    void Enlist(int body);
    void RefreshListed() const;

    mutable std::vector<int> m_listed;
    mutable bool m_listedChanged = false;
};

}  // namespace scree
