// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Rows of the joint tables, the world's list of joints and the lists of bodies.

#include "state/joints.h"

namespace scree {

namespace {

size_t At(int index) { return static_cast<size_t>(index); }

}  // namespace

void JointTable::Link(int joint, int row, const JointInfo& head, Joint* handle) {
    EnsureRow(info, joint);
    EnsureRow(handles, joint);
    handles[At(joint)] = handle;
    JointInfo& added = info[At(joint)];
    added = JointInfo{};
    added.type = head.type;
    added.collideConnected = head.collideConnected;
    added.bodyA = head.bodyA;
    added.bodyB = head.bodyB;
    added.userData = head.userData;
    added.forceThreshold = head.forceThreshold;
    added.torqueThreshold = head.torqueThreshold;
    added.breaks = head.breaks;
    NoteThresholds(joint);
    added.row = row;
    added.listNext = listHead;
    if (listHead >= 0) info[At(listHead)].listPrev = joint;
    listHead = joint;
    LinkToBody(joint, 0);
    LinkToBody(joint, 1);
}

void JointTable::Remove(int joint) {
    const JointInfo& removed = info[At(joint)];
    (removed.listPrev < 0 ? listHead : info[At(removed.listPrev)].listNext) = removed.listNext;
    if (removed.listNext >= 0) info[At(removed.listNext)].listPrev = removed.listPrev;
    UnlinkFromBody(joint, 0);
    UnlinkFromBody(joint, 1);
    WithStore(*this, removed.type, [&](auto& store) { store.slots.Free(removed.row); });
    watched.Erase(joint);
    slots.Free(joint);
}

void JointTable::LinkToBody(int joint, int side) {
    const int body = side == 0 ? info[At(joint)].bodyA : info[At(joint)].bodyB;
    EnsureRow(m_first, body, -1);
    EnsureRow(m_count, body, 0);
    const int next = m_first[At(body)];
    info[At(joint)].link[side] = {-1, next};
    if (next >= 0) info[At(next >> 1)].link[next & 1].prev = 2 * joint + side;
    m_first[At(body)] = 2 * joint + side;
    ++m_count[At(body)];
}

void JointTable::UnlinkFromBody(int joint, int side) {
    const int body = side == 0 ? info[At(joint)].bodyA : info[At(joint)].bodyB;
    const JointLink link = info[At(joint)].link[side];
    (link.prev < 0 ? m_first[At(body)] : info[At(link.prev >> 1)].link[link.prev & 1].next) = link.next;
    if (link.next >= 0) info[At(link.next >> 1)].link[link.next & 1].prev = link.prev;
    --m_count[At(body)];
}

bool JointTable::Restore(WorldState* state, int bodyCount) {
    if (!slots.IsConsistent() || info.size() != At(slots.Size())) return false;
    if (m_count.size() != m_first.size() || m_first.size() > At(bodyCount)) return false;
    for (int joint = 0; joint < slots.Size(); ++joint) {
        if (!slots.IsAlive(joint)) continue;
        const JointInfo& row = info[At(joint)];
        for (const int body : {row.bodyA, row.bodyB}) {
            if (body < 0 || At(body) >= m_first.size()) return false;
        }
        if (row.bodyA == row.bodyB) return false;
        if (!(row.forceThreshold >= 0.0f && row.torqueThreshold >= 0.0f)) return false;
        NoteThresholds(joint);
    }
    return RestoreHandles(state) && AreListsWhole();
}

bool JointTable::RestoreHandles(WorldState* state) {
    handles.assign(info.size(), nullptr);
    bool good = true;
    int64_t rows = 0;
    std::apply(
        [&](auto&... store) {
            const auto prepare = [&](auto& s) {
                good = good && s.slots.IsConsistent() && s.rows.size() == At(s.slots.Size());
                rows += static_cast<int64_t>(s.slots.Count());
                for (Joint& handle : s.handles) handle.m_index = -1;
                for (auto row = static_cast<int>(s.handles.size()); good && row < s.slots.Size(); ++row)
                    s.handles.emplace_back(state, -1, row);
            };
            (prepare(store), ...);
        },
        stores);
    if (!good || rows != slots.Count()) return false;
    for (int joint = 0; joint < slots.Size(); ++joint) {
        if (!slots.IsAlive(joint)) continue;
        const JointInfo& head = info[At(joint)];
        WithStore(*this, head.type, [&](auto& store) {
            if (!store.slots.IsAlive(head.row)) return;
            Joint& handle = store.handles[At(head.row)];
            if (handle.m_index >= 0) return;  // two joints with one row
            handle.m_index = joint;
            handles[At(joint)] = &handle;
        });
        if (handles[At(joint)] == nullptr) return false;
    }
    return true;
}

void JointTable::TakeHandles(WorldState* state, JointTable& old) {
    const auto take = [&](auto& store) {
        store.handles.swap(old.Store<typename std::remove_reference_t<decltype(store)>::RowType>().handles);
    };
    std::apply([&](auto&... store) { (take(store), ...); }, stores);
    (void)RestoreHandles(state);  // whose fields agreed before
}

bool JointTable::AreListsWhole() const {
    // Links that agree with their neighbours have no cycle that a walk from the head could enter.
    int listed = 0;
    for (int joint = listHead, prev = -1; joint >= 0; prev = joint, joint = info[At(joint)].listNext, ++listed) {
        if (!slots.IsAlive(joint) || info[At(joint)].listPrev != prev) return false;
    }
    if (listed != slots.Count()) return false;
    int entries = 0;
    for (size_t body = 0; body < m_first.size(); ++body) {
        int count = 0;
        for (int entry = m_first[body], prev = -1; entry != -1; ++count) {
            if (entry < 0 || !slots.IsAlive(entry >> 1)) return false;
            const JointInfo& row = info[At(entry >> 1)];
            const JointLink& link = row.link[entry & 1];
            if (At((entry & 1) == 0 ? row.bodyA : row.bodyB) != body || link.prev != prev) return false;
            prev = entry;
            entry = link.next;
        }
        if (count != m_count[body]) return false;
        entries += count;
    }
    return entries == 2 * slots.Count();
}

int JointTable::NextOfBody(int joint, int body) const {
    const JointInfo& row = info[At(joint)];
    const int next = row.link[row.bodyA == body ? 0 : 1].next;
    return next < 0 ? -1 : next >> 1;
}

bool JointTable::MayCollide(int bodyA, int bodyB) const {
    if (At(bodyA) >= m_first.size() || At(bodyB) >= m_first.size()) return true;
    // The shorter of the two lists: a ground body can hold thousands of joints.
    const int from = m_count[At(bodyA)] <= m_count[At(bodyB)] ? bodyA : bodyB;
    const int to = from == bodyA ? bodyB : bodyA;
    for (const int j : OfBody(from)) {
        const JointInfo& row = info[At(j)];
        const int other = row.bodyA == from ? row.bodyB : row.bodyA;
        if (other == to && !row.collideConnected) return false;
    }
    return true;
}

void JointTable::ShiftOrigin(Vec2 newOrigin) {
    for (int joint = 0; joint < slots.Size(); ++joint) {
        if (!slots.IsAlive(joint)) continue;
        const JointInfo& row = info[At(joint)];
        WithStore(*this, row.type, [&](auto& store) { ShiftRow(store.rows[At(row.row)], newOrigin); });
    }
}

size_t JointTable::GetMemoryBytes() const {
    size_t bytes = info.size() * (sizeof(JointInfo) + sizeof(Joint*)) + (m_first.size() + m_count.size()) * sizeof(int);
    std::apply(
        [&](const auto&... store) {
            ((bytes += store.rows.size() * (sizeof(store.rows[0]) + sizeof(store.handles[0]))), ...);
        },
        stores);
    return bytes;
}

}  // namespace scree
