// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The table of bodies: one column per thing that a stage reads or writes together. A row is a body's index for life;
// freed rows are used again.

#pragma once

#include <span>
#include <vector>

#include "base/index_set.h"
#include "base/shared_count.h"
#include "base/slots.h"
#include "scree/body.h"
#include "scree/math.h"
#include "state/indices.h"

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
    static constexpr uint16_t lost = 128;              ///< within a step: went back to its start, at rest
};

/// Cold data of a body.
struct BodyInfo {
    float inertia = 0.0f;  ///< about the centre of mass
    int fixtureCount = 0;
    int jointCount = 0;
    BodyIndex listPrev = BodyIndex::none, listNext = BodyIndex::none;
    MoverRow moverRow = MoverRow::none;  ///< position in BodyTable::movers, −1 for static bodies
    BodyUserData userData;
};

struct BodyTable {
    Slots<BodyIndex> slots;
    Column<BodyIndex, Velocity> velocity;
    Column<BodyIndex, Velocity> startVelocity;  ///< at the start of the last step; empty until a step drifts exactly
    Column<BodyIndex, Position> position;       ///< at the end of the last step
    Column<BodyIndex, Position> startPosition;  ///< at its start
    Column<BodyIndex, PositionRest> rest;       ///< empty until a body is far (WorldDef::farDistance): all are 0
    Column<BodyIndex, Transform> transform;     ///< of the origin
    Column<BodyIndex, MassRow> mass;
    Column<BodyIndex, ForceRow> force;  ///< empty until a step or a call needs it: nobody has any
    Column<BodyIndex, MotionRow> motion;
    Column<BodyIndex, BodyDemand> demand;  ///< empty until a step has a tolerance
    Column<BodyIndex, float> sleepTime;    ///< s
    Column<BodyIndex, uint16_t> flags;     ///< BodyFlag
    Column<BodyIndex, BodyType> type;
    Column<BodyIndex, FixtureIndex> fixtureHead;  ///< first fixture, newest first; −1 none (FixtureTable::From)
    Column<BodyIndex, BodyInfo> info;
    StableColumn<BodyIndex, Body> handles;

    Column<MoverRow, BodyIndex> movers;     ///< enabled or not: every body that is not static
    BodyIndex listHead = BodyIndex::none;   ///< movers first, then static bodies
    BodyIndex lastMover = BodyIndex::none;  ///< last mover in the list

    // Which movers a step looks at: all that are awake are listed, and some that are not, such as those edited since
    // the last step. The others rest: no stage visits them. Whether a body that is asleep is listed changes no result.
    IndexSet<MoverRow> listedRows;        ///< rows of `movers`
    IndexSet<MoverRow> targetRows;        ///< likewise, of what dynamic bodies must not pass: see IsTarget
    Column<BodyIndex, uint8_t> isListed;  ///< per body
    std::vector<BodyIndex> risen;         ///< bodies listed again, whose contacts still rest
    std::vector<BodyIndex> risenProxies;  ///< and those whose proxies do
    int fellAsleep = 0;                   ///< bodies put to sleep since sleepers were last unlisted, about

    [[nodiscard]] bool Has(BodyIndex body, uint16_t flag) const { return (flags[body] & flag) != 0; }
    /// Simulated in a step: awake, enabled, not static.
    [[nodiscard]] bool IsActive(BodyIndex body) const {
        constexpr uint16_t both = BodyFlag::awake | BodyFlag::enabled;
        return (flags[body] & both) == both && type[body] != staticBody;
    }
    /// Adds a row with every column; the definition is valid.
    BodyIndex Add(WorldState* state, const BodyDef& def);
    void Remove(BodyIndex body);
    /// Wakes and restarts the sleep timer; static bodies stay as they are.
    void Wake(BodyIndex body);
    /// Wakes a mover without a new sleep timer.
    void WakeReached(BodyIndex body) {
        flags[body] |= BodyFlag::awake;
        List(body);
    }
    /// Lets the coming step look at a mover.
    void List(BodyIndex body) {
        if (isListed[body] != 0) return;
        Enlist(body);
        risen.push_back(body);
        risenProxies.push_back(body);
        if (!Has(body, BodyFlag::awake)) fellAsleep = 1;
    }
    /// The mover rests from now on.
    void Unlist(BodyIndex body);
    /// The listed movers, in the order of `movers`. Valid until one is listed or unlisted.
    [[nodiscard]] std::span<const BodyIndex> Listed() const {
        if (m_listedChanged) RefreshListed();
        return m_listed;
    }
    [[nodiscard]] bool AreAllListed() const { return ToSize(listedRows.Count()) == movers.size(); }
    /// After the fields were read: lists every mover.
    void ListAll();
    /// A mover that dynamic bodies must not pass: a kinematic body or a bullet.
    [[nodiscard]] bool IsTarget(BodyIndex body) const {
        return type[body] == kinematicBody || (type[body] == dynamicBody && Has(body, BodyFlag::bullet));
    }
    /// After a change of what IsTarget asks for.
    void NoteTarget(BodyIndex body);
    /// Adds the movers of these rows that rest to a list of bodies in the order of `movers`.
    void AddResting(const IndexSet<MoverRow>& rows, std::vector<BodyIndex>& bodies) const;
    void PutToSleep(BodyIndex body);
    /// Positions have rests.
    [[nodiscard]] bool IsFar() const { return !rest.empty(); }
    /// Makes `rest` a column like the others; without bodies, from the first one on.
    void EnsureRests() { EnsureRows(rest, position.empty() ? 1 : position.size()); }
    [[nodiscard]] Vec2 GetRest(BodyIndex body) const { return rest.empty() ? vec2Zero : rest[body].end; }
    /// The body starts the step where it is.
    void NoteStart(BodyIndex body) {
        startPosition[body] = position[body];
        if (IsFar()) rest[body].start = rest[body].end;
    }
    /// The body is lost: it goes back to where it started the step, at rest.
    void ReturnToStart(BodyIndex body) {
        position[body] = startPosition[body];
        if (IsFar()) rest[body].end = rest[body].start;
        velocity[body] = {vec2Zero, 0.0f, 0.0f};
        flags[body] |= BodyFlag::lost;
    }
    /// Moves the centre. Far from the origin only the rest changes until UpdateTransform.
    void Shift(BodyIndex body, Vec2 way) { (IsFar() ? rest[body].end : position[body].c) += way; }
    /// Puts the centre where it was at the start of the step plus `way`; the same.
    void SetMotion(BodyIndex body, Vec2 way) {
        position[body].c = IsFar() ? startPosition[body].c : startPosition[body].c + way;
        if (IsFar()) rest[body].end = rest[body].start + way;
    }
    /// The way of the centre since the start of the step.
    [[nodiscard]] Vec2 GetMotion(BodyIndex body) const {
        const Vec2 way = position[body].c - startPosition[body].c;
        return IsFar() ? way + (rest[body].end - rest[body].start) : way;
    }
    /// The origin that belongs to `position`, from the rotation that `transform` has.
    void UpdateOrigin(BodyIndex body) {
        const Vec2 arm = Mul(transform[body].q, mass[body].localCenter);
        if (IsFar()) return UpdateFarOrigin(body, arm);
        transform[body].p = position[body].c - arm;
    }
    /// What `transform[body].p` lacks below its last digit, m.
    [[nodiscard]] Vec2 GetOriginRest(BodyIndex body) const;
    /// Puts the origin to p + rest with the angle `a`, and the start of the step there.
    void Place(BodyIndex body, Vec2 p, Vec2 originRest, float a);
    /// Moves the centre of mass within the body, which stays where it is. Returns how far.
    Vec2 SetLocalCenter(BodyIndex body, Vec2 center);
    /// Subtracts `newOrigin` from the positions.
    void ShiftOrigin(BodyIndex body, Vec2 newOrigin);
    /// The transform that belongs to `position`.
    void UpdateTransform(BodyIndex body);
    /// Makes `force` a column like the others.
    void EnsureForces() { EnsureRows(force, position.size()); }
    [[nodiscard]] ForceRow GetForce(BodyIndex body) const {
        return force.empty() ? ForceRow{vec2Zero, 0.0f, 0.0f} : force[body];
    }
    void ClearForce(BodyIndex body) {
        if (!force.empty()) force[body] = {vec2Zero, 0.0f, 0.0f};
    }
    /// After a change of type: list and movers.
    void Relist(BodyIndex body);

    /// Visits the columns that a step or a call that moves a body writes.
    template <typename Self, typename Visit>
    static void MotionFields(Self& t, Visit& visit) {
        visit(t.velocity, t.startVelocity, t.position, t.startPosition, t.rest, t.transform, t.force, t.demand,
              t.sleepTime, t.flags);
    }
    template <typename Self, typename Visit>
    static void Fields(Self& t, Visit& visit) {
        auto& [slots, velocity, startVelocity, position, startPosition, rest, transform, mass, force, motion, demand,
               sleepTime, flags, type, fixtureHead, info, handles, movers, listHead, lastMover, listedRows, targetRows,
               isListed, risen, risenProxies, fellAsleep, listed, listedChanged] = t;
        visit(slots), visit.Hashed(t.IsFar());
        visit.Rows(slots, velocity, startVelocity, position, startPosition, rest, transform, mass, force, motion,
                   demand, sleepTime, flags, type, fixtureHead, info);
        visit(movers, listHead, lastMover);
        visit.LeftOut(handles, listedRows, targetRows, isListed, risen, risenProxies, fellAsleep, listed,
                      listedChanged);
    }

private:
    /// The same with rests, each of which it makes as small as it can be.
    void UpdateFarOrigin(BodyIndex body, Vec2 arm);
    void Link(BodyIndex body);
    void Unlink(BodyIndex body);
    void Enlist(BodyIndex body);
    void RefreshListed() const;

    mutable std::vector<BodyIndex> m_listed;
    mutable bool m_listedChanged = false;
};

}  // namespace scree
