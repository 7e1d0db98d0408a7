// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Rows of the body table: made, removed, woken, listed.

#include "state/bodies.h"

#include <algorithm>

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

int BodyTable::Add(WorldState* state, const BodyDef& def) {
    const int index = slots.Prepare();
    const auto i = static_cast<size_t>(index);
    // When memory runs out nothing has changed yet.
    ReserveRows(i + 1, velocity, position, startPosition, transform, mass, motion, sleepTime, flags, type, fixtureHead,
                info);
    if (!startVelocity.empty()) ReserveRows(i + 1, startVelocity);
    if (IsFar()) ReserveRows(i + 1, rest);
    if (!force.empty()) ReserveRows(i + 1, force);
    if (!demand.empty()) ReserveRows(i + 1, demand);
    ReserveRows(movers.size() + 1, movers);
    ReserveRows(i + 1, isListed, risen, risenProxies, m_listed);
    listedRows.Reserve(movers.size() + 1);
    kinematicRows.Reserve(movers.size() + 1);
    while (static_cast<int>(handles.size()) <= index) handles.emplace_back(state, static_cast<int>(handles.size()));

    slots.Allocate();
    EnsureRow(velocity, index);
    if (!startVelocity.empty()) EnsureRow(startVelocity, index);
    EnsureRow(position, index);
    EnsureRow(startPosition, index);
    if (IsFar()) EnsureRow(rest, index);
    EnsureRow(transform, index);
    EnsureRow(mass, index);
    if (!force.empty()) EnsureRow(force, index);
    EnsureRow(motion, index);
    if (!demand.empty()) EnsureRow(demand, index);
    EnsureRow(sleepTime, index);
    EnsureRow(flags, index);
    EnsureRow(type, index);
    EnsureRow(fixtureHead, index);
    EnsureRow(info, index);
    EnsureRow(isListed, index);

    type[i] = def.type;
    const bool isStatic = def.type == staticBody;
    velocity[i] = {isStatic ? vec2Zero : def.linearVelocity, isStatic ? 0.0f : def.angularVelocity, 0.0f};
    mass[i] = {0.0f, 0.0f, vec2Zero};
    Place(i, def.position, def.positionRest, def.angle);
    ClearForce(index);
    motion[i] = {def.linearDamping, def.angularDamping, def.gravityScale, 0.0f};
    if (!demand.empty()) demand[i] = {};
    sleepTime[i] = 0.0f;
    flags[i] = static_cast<uint16_t>((def.awake && !isStatic ? BodyFlag::awake : 0) |
                                     (def.allowSleep ? BodyFlag::autoSleep : 0) | (def.bullet ? BodyFlag::bullet : 0) |
                                     (def.fixedRotation || def.locks.angle ? BodyFlag::fixedRotation : 0) |
                                     (def.locks.x ? BodyFlag::lockX : 0) | (def.locks.y ? BodyFlag::lockY : 0) |
                                     (def.enabled ? BodyFlag::enabled : 0));
    fixtureHead[i] = -1;
    info[i] = BodyInfo{};
    info[i].userData = def.userData;
    Link(index);
    return index;
}

void BodyTable::Remove(int body) {
    Unlink(body);
    flags[static_cast<size_t>(body)] = 0;
    slots.Free(body);
}

void BodyTable::Wake(int body) {
    const auto i = static_cast<size_t>(body);
    if (type[i] == staticBody) return;
    flags[i] = static_cast<uint16_t>(flags[i] | BodyFlag::awake);
    sleepTime[i] = 0.0f;
    List(body);
}

void BodyTable::PutToSleep(int body) {
    const auto i = static_cast<size_t>(body);
    flags[i] = static_cast<uint16_t>(flags[i] & ~BodyFlag::awake);
    sleepTime[i] = 0.0f;
    velocity[i] = {vec2Zero, 0.0f, 0.0f};
    ClearForce(body);
    AddShared(fellAsleep, 1);  // several threads put bodies to sleep
}

void BodyTable::Enlist(int body) {
    isListed[static_cast<size_t>(body)] = 1;
    listedRows.Insert(info[static_cast<size_t>(body)].moverRow);
    m_listedChanged = true;
}

void BodyTable::Unlist(int body) {
    isListed[static_cast<size_t>(body)] = 0;
    listedRows.Erase(info[static_cast<size_t>(body)].moverRow);
    m_listedChanged = true;
}

void BodyTable::RefreshListed() const {
    m_listedChanged = false;
    if (AreAllListed()) {
        m_listed = movers;
        return;
    }
    m_listed.clear();
    listedRows.ForEach([this](int row) { m_listed.push_back(movers[static_cast<size_t>(row)]); });
}

void BodyTable::ListAll() {
    isListed.resize(info.size(), 0);
    for (const int body : movers) {
        Enlist(body);
        NoteKinematic(body);
    }
    fellAsleep = 1;
}

void BodyTable::AddRestingKinematics(std::vector<int>& bodies) const {
    const auto listed = static_cast<ptrdiff_t>(bodies.size());
    kinematicRows.ForEach([&](int row) {
        const int body = movers[static_cast<size_t>(row)];
        if (isListed[static_cast<size_t>(body)] == 0) bodies.push_back(body);
    });
    const auto before = [this](int a, int b) {
        return info[static_cast<size_t>(a)].moverRow < info[static_cast<size_t>(b)].moverRow;
    };
    if (bodies.begin() + listed != bodies.end())
        std::inplace_merge(bodies.begin(), bodies.begin() + listed, bodies.end(), before);
}

void BodyTable::NoteKinematic(int body) {
    const int row = info[static_cast<size_t>(body)].moverRow;
    if (row < 0) return;
    type[static_cast<size_t>(body)] == kinematicBody ? kinematicRows.Insert(row) : kinematicRows.Erase(row);
}

void BodyTable::UpdateTransform(int body) {
    const auto i = static_cast<size_t>(body);
    Transform& xf = transform[i];
    xf.q.Set(position[i].a);
    if (const float turn = position[i].aRest; turn != 0.0f) {
        const float sine = xf.q.s;
        xf.q.s += turn * xf.q.c;
        xf.q.c -= turn * sine;
    }
    UpdateOrigin(i);
}

void BodyTable::UpdateFarOrigin(size_t b, Vec2 arm) {
    Normalize(position[b].c, rest[b].end);
    Vec2 below = rest[b].end - arm;
    transform[b].p = position[b].c;
    Normalize(transform[b].p, below);
}

Vec2 BodyTable::GetOriginRest(int body) const {
    if (!IsFar()) return vec2Zero;
    const auto b = static_cast<size_t>(body);
    Vec2 origin = position[b].c, below = rest[b].end - Mul(transform[b].q, mass[b].localCenter);
    Normalize(origin, below);
    return below;
}

void BodyTable::Place(size_t b, Vec2 p, Vec2 originRest, float a) {
    Transform& xf = transform[b];
    xf.Set(p, a);
    position[b] = {p, a, 0.0f};
    if (IsFar()) {
        rest[b].end = originRest + Mul(xf.q, mass[b].localCenter);
        UpdateOrigin(b);
    } else {
        position[b].c = Mul(xf, mass[b].localCenter);
    }
    NoteStart(b);
}

Vec2 BodyTable::SetLocalCenter(size_t b, Vec2 center) {
    const Transform& xf = transform[b];
    const Vec2 way = Mul(xf.q, center) - Mul(xf.q, mass[b].localCenter);
    const Vec2 before = position[b].c;
    const bool moves = !(GetMotion(b) == vec2Zero) || position[b].a != startPosition[b].a;
    const Rot startTurn(startPosition[b].a);
    const Vec2 startWay = Mul(startTurn, center) - Mul(startTurn, mass[b].localCenter);
    mass[b].localCenter = center;
    if (IsFar()) {
        rest[b].end += way;
        UpdateOrigin(b);
    } else {
        position[b].c = Mul(xf, center);
    }
    if (moves) {
        // A callback within a step may ask for this: the motion of the step stays
        // what it was.
        (IsFar() ? rest[b].start : startPosition[b].c) += startWay;
    } else {
        NoteStart(b);
    }
    return IsFar() ? way : position[b].c - before;
}

void BodyTable::ShiftOrigin(size_t b, Vec2 newOrigin) {
    if (!IsFar()) {
        for (Vec2* p : {&transform[b].p, &position[b].c, &startPosition[b].c}) *p -= newOrigin;
        return;
    }
    const auto shift = [newOrigin](Vec2& c, Vec2& below) {
        Vec2 lost = -newOrigin;
        Normalize(c, lost);
        below += lost;
        Normalize(c, below);
    };
    shift(position[b].c, rest[b].end);
    shift(startPosition[b].c, rest[b].start);
    UpdateOrigin(b);
}

void BodyTable::Relist(int body) {
    Unlink(body);
    Link(body);
}

void BodyTable::Link(int body) {
    BodyInfo& row = info[static_cast<size_t>(body)];
    const bool mover = type[static_cast<size_t>(body)] != staticBody;
    // Movers enter at the head, static bodies right behind the last mover.
    const int prev = mover ? -1 : lastMover;
    const int next = prev < 0 ? listHead : info[static_cast<size_t>(prev)].listNext;
    row.listPrev = prev;
    row.listNext = next;
    (prev < 0 ? listHead : info[static_cast<size_t>(prev)].listNext) = body;
    if (next >= 0) info[static_cast<size_t>(next)].listPrev = body;
    if (mover) {
        if (lastMover < 0) lastMover = body;
        row.moverRow = static_cast<int>(movers.size());
        movers.push_back(body);
        Enlist(body);
        NoteKinematic(body);
        if (!Has(body, BodyFlag::awake)) fellAsleep = 1;
    } else {
        row.moverRow = -1;
    }
}

void BodyTable::Unlink(int body) {
    BodyInfo& row = info[static_cast<size_t>(body)];
    (row.listPrev < 0 ? listHead : info[static_cast<size_t>(row.listPrev)].listNext) = row.listNext;
    if (row.listNext >= 0) info[static_cast<size_t>(row.listNext)].listPrev = row.listPrev;
    // A body is the last mover only while it is a mover, so its predecessor (if any) is one too.
    if (lastMover == body) lastMover = row.listPrev;
    if (row.moverRow >= 0) {
        isListed[static_cast<size_t>(body)] = 0;
        const int moved = movers.back(), last = static_cast<int>(movers.size()) - 1;
        for (IndexSet* rows : {&listedRows, &kinematicRows}) {
            const bool movesIn = rows->Erase(last);
            rows->Erase(row.moverRow);
            if (movesIn && moved != body) rows->Insert(row.moverRow);
        }
        m_listedChanged = true;
        movers[static_cast<size_t>(row.moverRow)] = moved;
        info[static_cast<size_t>(moved)].moverRow = row.moverRow;
        movers.pop_back();
        row.moverRow = -1;
    }
}

}  // namespace scree
