// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Rows of the joint tables and the adjacency of bodies and joints, rebuilt when joints change.

#include "state/joints.h"

#include <algorithm>

namespace scree {

int JointTable::AddRevolute(WorldState* state, const RevoluteJointDef& def) {
    const int index = slots.Allocate();
    const auto i = static_cast<size_t>(index);
    if (i >= info.size()) info.resize(i + 1);
    if (i >= handles.size()) handles.resize(i + 1);

    const int row = revoluteSlots.Allocate();
    EnsureRow(revolute, row);
    RevoluteRow r{};
    r.localAnchorA = def.localAnchorA;
    r.localAnchorB = def.localAnchorB;
    r.referenceAngle = def.referenceAngle;
    r.lowerAngle = def.lowerAngle;
    r.upperAngle = def.upperAngle;
    r.motorSpeed = def.motorSpeed;
    r.maxMotorTorque = def.maxMotorTorque;
    r.enableLimit = def.enableLimit;
    r.enableMotor = def.enableMotor;
    r.impulse = vec2Zero;
    revolute[static_cast<size_t>(row)] = r;

    info[i] = {def.type, def.collideConnected, def.bodyA->GetIndex(), def.bodyB->GetIndex(), row, -1,
               listHead, def.userData};
    if (listHead >= 0) info[static_cast<size_t>(listHead)].listPrev = index;
    listHead = index;
    handles[i] = std::make_unique<RevoluteJoint>(state, index);
    m_adjacencyValid = false;
    return index;
}

void JointTable::Remove(int joint) {
    JointInfo& j = info[static_cast<size_t>(joint)];
    (j.listPrev < 0 ? listHead : info[static_cast<size_t>(j.listPrev)].listNext) = j.listNext;
    if (j.listNext >= 0) info[static_cast<size_t>(j.listNext)].listPrev = j.listPrev;
    revoluteSlots.Free(j.row);
    handles[static_cast<size_t>(joint)].reset();
    slots.Free(joint);
    m_adjacencyValid = false;
}

void JointTable::EnsureAdjacency() {
    if (m_adjacencyValid) return;
    int bodyCount = 0;
    for (int j = listHead; j >= 0; j = info[static_cast<size_t>(j)].listNext) {
        const JointInfo& row = info[static_cast<size_t>(j)];
        bodyCount = std::max({bodyCount, row.bodyA + 1, row.bodyB + 1});
    }
    m_first.assign(static_cast<size_t>(bodyCount) + 1, 0);
    for (int j = listHead; j >= 0; j = info[static_cast<size_t>(j)].listNext) {
        ++m_first[static_cast<size_t>(info[static_cast<size_t>(j)].bodyA)];
        ++m_first[static_cast<size_t>(info[static_cast<size_t>(j)].bodyB)];
    }
    int total = 0;
    for (int& first : m_first) {
        total += first;
        first = total;  // the end for now; filling from the back turns it into the start
    }
    m_entries.resize(static_cast<size_t>(total));
    int tail = listHead;
    while (tail >= 0 && info[static_cast<size_t>(tail)].listNext >= 0) tail = info[static_cast<size_t>(tail)].listNext;
    for (int j = tail; j >= 0; j = info[static_cast<size_t>(j)].listPrev) {
        const JointInfo& row = info[static_cast<size_t>(j)];
        m_entries[static_cast<size_t>(--m_first[static_cast<size_t>(row.bodyA)])] = j;
        m_entries[static_cast<size_t>(--m_first[static_cast<size_t>(row.bodyB)])] = j;
    }
    m_adjacencyValid = true;
}

std::span<const int> JointTable::OfBody(int body) {
    EnsureAdjacency();
    const auto b = static_cast<size_t>(body);
    if (b + 1 >= m_first.size()) return {};  // beyond the last body with a joint
    return {m_entries.data() + m_first[b], static_cast<size_t>(m_first[b + 1] - m_first[b])};
}

bool JointTable::MayCollide(int bodyA, int bodyB) {
    for (const int j : OfBody(bodyA)) {
        const JointInfo& row = info[static_cast<size_t>(j)];
        const int other = row.bodyA == bodyA ? row.bodyB : row.bodyA;
        if (other == bodyB && !row.collideConnected) return false;
    }
    return true;
}

}  // namespace scree
