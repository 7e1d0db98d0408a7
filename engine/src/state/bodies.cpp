// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Rows of the body table: made, removed, woken, listed.

#include "state/bodies.h"

#include <algorithm>
#include <bit>

#include "base/sin_cos_terms.h"
#include "base/two_sum.h"

namespace scree {

namespace {

/// c + below as the float nearest to it and what that lacks.
void Normalize(Vec2& c, Vec2& below) {
    const RoundedSum x = TwoSum(c.x, below.x), y = TwoSum(c.y, below.y);
    c = {x.sum, y.sum};
    below = {x.rest, y.rest};
}

}  // namespace

BodyIndex BodyTable::Add(WorldState* state, const BodyDef& def) {
    const BodyIndex index = slots.Prepare();
    const size_t rows = ToSize(index) + 1;
    // When memory runs out nothing has changed yet.
    ReserveRows(rows, velocity, position, startPosition, transform, mass, motion, sleepTime, flags, type, fixtureHead,
                info);
    if (!startVelocity.empty()) ReserveRows(rows, startVelocity);
    if (IsFar()) ReserveRows(rows, rest);
    if (!force.empty()) ReserveRows(rows, force);
    if (!demand.empty()) ReserveRows(rows, demand);
    ReserveRows(movers.size() + 1, movers);
    ReserveRows(rows, isListed, risen, risenProxies, m_listed);
    listedRows.Reserve(movers.size() + 1);
    targetRows.Reserve(movers.size() + 1);
    while (handles.size() < rows) handles.emplace_back(state, handles.End());

    slots.Allocate();
    if (velocity.size() < rows) {
        AppendRow(velocity, position, startPosition, transform, mass, motion, sleepTime, flags, type, fixtureHead,
                  info);
    }
    EnsureRow(isListed, index);
    if (!startVelocity.empty()) EnsureRow(startVelocity, index);
    if (IsFar()) EnsureRow(rest, index);
    if (!force.empty()) EnsureRow(force, index);
    if (!demand.empty()) EnsureRow(demand, index);

    type[index] = def.type;
    const bool isStatic = def.type == staticBody;
    velocity[index] = {isStatic ? vec2Zero : def.linearVelocity, isStatic ? 0.0f : def.angularVelocity, 0.0f};
    mass[index] = {0.0f, 0.0f, vec2Zero};
    position[index] = {vec2Zero, 0.0f, 0.0f};
    transform[index].SetIdentity();
    Place(index, def.position, def.positionRest, def.angle);
    ClearForce(index);
    motion[index] = {def.linearDamping, def.angularDamping, def.gravityScale, 0.0f};
    if (!demand.empty()) demand[index] = {};
    sleepTime[index] = 0.0f;
    flags[index] = static_cast<uint16_t>(
        (def.awake && !isStatic ? BodyFlag::awake : 0) | (def.allowSleep ? BodyFlag::autoSleep : 0) |
        (def.bullet ? BodyFlag::bullet : 0) | (def.fixedRotation || def.locks.angle ? BodyFlag::fixedRotation : 0) |
        (def.locks.x ? BodyFlag::lockX : 0) | (def.locks.y ? BodyFlag::lockY : 0) |
        (def.enabled ? BodyFlag::enabled : 0));
    fixtureHead[index] = FixtureIndex::none;
    info[index] = BodyInfo{};
    info[index].userData = def.userData;
    Link(index);
    return index;
}

void BodyTable::Remove(BodyIndex body) {
    Unlink(body);
    flags[body] = 0;
    slots.Free(body);
}

void BodyTable::Wake(BodyIndex body) {
    if (type[body] == staticBody) return;
    flags[body] = static_cast<uint16_t>(flags[body] | BodyFlag::awake);
    sleepTime[body] = 0.0f;
    List(body);
}

void BodyTable::PutToSleep(BodyIndex body) {
    flags[body] = static_cast<uint16_t>(flags[body] & ~BodyFlag::awake);
    sleepTime[body] = 0.0f;
    velocity[body] = {vec2Zero, 0.0f, 0.0f};
    ClearForce(body);
    AddShared(fellAsleep, 1);  // several threads put bodies to sleep
}

void BodyTable::Enlist(BodyIndex body) {
    isListed[body] = 1;
    listedRows.Insert(info[body].moverRow);
    m_listedChanged = true;
}

void BodyTable::Unlist(BodyIndex body) {
    isListed[body] = 0;
    listedRows.Erase(info[body].moverRow);
    m_listedChanged = true;
}

void BodyTable::RefreshListed() const {
    m_listedChanged = false;
    if (AreAllListed()) {
        m_listed.assign(movers.begin(), movers.end());
        return;
    }
    m_listed.clear();
    listedRows.ForEach([this](MoverRow row) { m_listed.push_back(movers[row]); });
}

void BodyTable::ListAll() {
    isListed.resize(info.size(), 0);
    for (const BodyIndex body : movers) {
        Enlist(body);
        NoteTarget(body);
    }
    fellAsleep = 1;
}

void BodyTable::AddResting(const IndexSet<MoverRow>& rows, std::vector<BodyIndex>& bodies) const {
    const auto listed = static_cast<ptrdiff_t>(bodies.size());
    rows.ForEach([&](MoverRow row) {
        const BodyIndex body = movers[row];
        if (isListed[body] == 0) bodies.push_back(body);
    });
    const auto before = [this](BodyIndex a, BodyIndex b) { return info[a].moverRow < info[b].moverRow; };
    if (bodies.begin() + listed != bodies.end())
        std::inplace_merge(bodies.begin(), bodies.begin() + listed, bodies.end(), before);
}

void BodyTable::NoteTarget(BodyIndex body) {
    const MoverRow row = info[body].moverRow;
    if (IsNone(row)) return;
    IsTarget(body) ? targetRows.Insert(row) : targetRows.Erase(row);
}

void BodyTable::UpdateTransform(BodyIndex body) {
    Transform& xf = transform[body];
    xf.q.Set(position[body].a);
    const float turn = position[body].aRest;
    if (Abs(turn) >= sin_cos::largestTurn) {
        xf.q = Mul(xf.q, Rot(turn));
    } else if (turn != 0.0f) {
        const float sine = xf.q.s;
        xf.q.s += turn * xf.q.c;
        xf.q.c -= turn * sine;
    }
    UpdateOrigin(body);
}

void BodyTable::UpdateFarOrigin(BodyIndex body, Vec2 arm) {
    Normalize(position[body].c, rest[body].end);
    Vec2 below = rest[body].end - arm;
    transform[body].p = position[body].c;
    Normalize(transform[body].p, below);
}

Vec2 BodyTable::GetOriginRest(BodyIndex body) const {
    if (!IsFar()) return vec2Zero;
    const Vec2 origin = transform[body].p, arm = Mul(transform[body].q, mass[body].localCenter);
    Vec2 toCentre = position[body].c, lost = -origin;
    Normalize(toCentre, lost);
    return (toCentre - arm) + (lost + rest[body].end);
}

void BodyTable::Place(BodyIndex body, Vec2 p, Vec2 originRest, float a) {
    Transform& xf = transform[body];
    const Position& before = position[body];
    const bool turns = std::bit_cast<uint32_t>(before.a) != std::bit_cast<uint32_t>(a) || before.aRest != 0.0f;
    xf.p = p;
    if (turns) xf.q.Set(a);
    position[body] = {p, a, 0.0f};
    if (IsFar()) {
        rest[body].end = originRest + Mul(xf.q, mass[body].localCenter);
        UpdateOrigin(body);
    } else {
        position[body].c = Mul(xf, mass[body].localCenter);
    }
    NoteStart(body);
}

Vec2 BodyTable::SetLocalCenter(BodyIndex body, Vec2 center) {
    const Transform& xf = transform[body];
    const Vec2 way = Mul(xf.q, center) - Mul(xf.q, mass[body].localCenter);
    const Vec2 before = position[body].c;
    const bool moves = !(GetMotion(body) == vec2Zero) || position[body].a != startPosition[body].a;
    Vec2 startWay = vec2Zero;
    if (moves) {
        const Rot startTurn(startPosition[body].a);
        startWay = Mul(startTurn, center) - Mul(startTurn, mass[body].localCenter);
    }
    mass[body].localCenter = center;
    if (IsFar()) {
        rest[body].end += way;
        Normalize(position[body].c, rest[body].end);
    } else {
        position[body].c = Mul(xf, center);
    }
    if (moves) {
        // A callback within a step may ask for this: the motion of the step stays
        // what it was.
        (IsFar() ? rest[body].start : startPosition[body].c) += startWay;
    } else {
        NoteStart(body);
    }
    return IsFar() ? way : position[body].c - before;
}

void BodyTable::ShiftOrigin(BodyIndex body, Vec2 newOrigin) {
    if (!IsFar()) {
        for (Vec2* p : {&transform[body].p, &position[body].c, &startPosition[body].c}) *p -= newOrigin;
        return;
    }
    const auto shift = [newOrigin](Vec2& c, Vec2& below) {
        Vec2 lost = -newOrigin;
        Normalize(c, lost);
        below += lost;
        Normalize(c, below);
    };
    shift(position[body].c, rest[body].end);
    shift(startPosition[body].c, rest[body].start);
    UpdateOrigin(body);
}

void BodyTable::Relist(BodyIndex body) {
    Unlink(body);
    Link(body);
}

void BodyTable::Link(BodyIndex body) {
    BodyInfo& row = info[body];
    const bool mover = type[body] != staticBody;
    // Movers enter at the head, static bodies right behind the last mover.
    const BodyIndex prev = mover ? BodyIndex::none : lastMover;
    const BodyIndex next = IsNone(prev) ? listHead : info[prev].listNext;
    row.listPrev = prev;
    row.listNext = next;
    (IsNone(prev) ? listHead : info[prev].listNext) = body;
    if (IsSome(next)) info[next].listPrev = body;
    if (mover) {
        if (IsNone(lastMover)) lastMover = body;
        row.moverRow = movers.End();
        movers.push_back(body);
        Enlist(body);
        NoteTarget(body);
        if (!Has(body, BodyFlag::awake)) fellAsleep = 1;
    } else {
        row.moverRow = MoverRow::none;
    }
}

void BodyTable::Unlink(BodyIndex body) {
    BodyInfo& row = info[body];
    (IsNone(row.listPrev) ? listHead : info[row.listPrev].listNext) = row.listNext;
    if (IsSome(row.listNext)) info[row.listNext].listPrev = row.listPrev;
    // A body is the last mover only while it is a mover, so its predecessor (if any) is one too.
    if (lastMover == body) lastMover = row.listPrev;
    if (IsSome(row.moverRow)) {
        isListed[body] = 0;
        const BodyIndex moved = movers.back();
        const auto last = ToIndex<MoverRow>(movers.size() - 1);
        for (IndexSet<MoverRow>* rows : {&listedRows, &targetRows}) {
            const bool movesIn = rows->Erase(last);
            rows->Erase(row.moverRow);
            if (movesIn && moved != body) rows->Insert(row.moverRow);
        }
        m_listedChanged = true;
        movers[row.moverRow] = moved;
        info[moved].moverRow = row.moverRow;
        movers.pop_back();
        row.moverRow = MoverRow::none;
    }
}

}  // namespace scree
