// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Rows of the body table: made, removed, woken, listed.

#include "state/bodies.h"

namespace scree {

int BodyTable::Add(WorldState* state, const BodyDef& def) {
    const int index = slots.Allocate();
    const auto i = static_cast<size_t>(index);
    EnsureRow(velocity, index);
    if (!startVelocity.empty()) EnsureRow(startVelocity, index);
    EnsureRow(position, index);
    EnsureRow(startPosition, index);
    EnsureRow(transform, index);
    EnsureRow(mass, index);
    if (!force.empty()) EnsureRow(force, index);
    EnsureRow(motion, index);
    if (!demand.empty()) EnsureRow(demand, index);
    EnsureRow(sleepTime, index);
    EnsureRow(flags, index);
    EnsureRow(type, index);
    EnsureRow(info, index);
    while (static_cast<int>(handles.size()) <= index) handles.emplace_back(state, static_cast<int>(handles.size()));

    type[i] = def.type;
    const bool isStatic = def.type == staticBody;
    velocity[i] = {isStatic ? vec2Zero : def.linearVelocity, isStatic ? 0.0f : def.angularVelocity, 0.0f};
    position[i] = {def.position, def.angle, 0.0f};
    startPosition[i] = position[i];
    transform[i].Set(def.position, def.angle);
    mass[i] = {0.0f, 0.0f, vec2Zero};
    ClearForce(index);
    motion[i] = {def.linearDamping, def.angularDamping, def.gravityScale, 0.0f};
    if (!demand.empty()) demand[i] = {};
    sleepTime[i] = 0.0f;
    flags[i] = static_cast<uint16_t>((def.awake && !isStatic ? BodyFlag::awake : 0) |
                                     (def.allowSleep ? BodyFlag::autoSleep : 0) | (def.bullet ? BodyFlag::bullet : 0) |
                                     (def.fixedRotation ? BodyFlag::fixedRotation : 0) |
                                     (def.enabled ? BodyFlag::enabled : 0));
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
}

void BodyTable::PutToSleep(int body) {
    const auto i = static_cast<size_t>(body);
    flags[i] = static_cast<uint16_t>(flags[i] & ~BodyFlag::awake);
    sleepTime[i] = 0.0f;
    velocity[i] = {vec2Zero, 0.0f, 0.0f};
    ClearForce(body);
}

void BodyTable::UpdateTransform(int body) {
    const auto i = static_cast<size_t>(body);
    Transform& xf = transform[i];
    xf.q.Set(position[i].a);
    if (const float rest = position[i].aRest; rest != 0.0f) {
        const float sine = xf.q.s;
        xf.q.s += rest * xf.q.c;
        xf.q.c -= rest * sine;
    }
    xf.p = position[i].c - Mul(xf.q, mass[i].localCenter);
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
        const int moved = movers.back();
        movers[static_cast<size_t>(row.moverRow)] = moved;
        info[static_cast<size_t>(moved)].moverRow = row.moverRow;
        movers.pop_back();
        row.moverRow = -1;
    }
}

}  // namespace scree
