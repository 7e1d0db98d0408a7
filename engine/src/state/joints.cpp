// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Rows of the joint tables, the world's list of joints and the lists of bodies.

#include "state/joints.h"

namespace scree {

void JointTable::Link(JointIndex joint, JointRow row, const JointInfo& head, Joint* handle) {
    EnsureRow(info, joint);
    EnsureRow(handles, joint);
    EnsureRow(m_births, joint);
    handles[joint] = handle;
    m_births[joint] = m_nextBirth++;
    JointInfo& added = info[joint];
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
    if (IsSome(listHead)) info[listHead].listPrev = joint;
    listHead = joint;
    LinkToBody(joint, 0);
    LinkToBody(joint, 1);
}

void JointTable::Remove(JointIndex joint) {
    const JointInfo& removed = info[joint];
    (IsNone(removed.listPrev) ? listHead : info[removed.listPrev].listNext) = removed.listNext;
    if (IsSome(removed.listNext)) info[removed.listNext].listPrev = removed.listPrev;
    UnlinkFromBody(joint, 0);
    UnlinkFromBody(joint, 1);
    WithStore(*this, removed.type, [&](auto& store) { store.slots.Free(removed.row); });
    watched.Erase(joint);
    slots.Free(joint);
}

void JointTable::SetBodies(JointIndex joint, BodyIndex bodyA, BodyIndex bodyB) {
    UnlinkFromBody(joint, 0);
    UnlinkFromBody(joint, 1);
    info[joint].bodyA = bodyA, info[joint].bodyB = bodyB;
    LinkToBody(joint, 0);
    LinkToBody(joint, 1);
}

void JointTable::LinkToBody(JointIndex joint, int side) {
    const BodyIndex body = side == 0 ? info[joint].bodyA : info[joint].bodyB;
    EnsureRow(m_first, body, -1);
    EnsureRow(m_count, body, 0);
    const int next = m_first[body];
    info[joint].link[side] = {-1, next};
    if (next >= 0) info[JointOf(next)].link[SideOf(next)].prev = EntryOf(joint, side);
    m_first[body] = EntryOf(joint, side);
    ++m_count[body];
}

void JointTable::UnlinkFromBody(JointIndex joint, int side) {
    const BodyIndex body = side == 0 ? info[joint].bodyA : info[joint].bodyB;
    const JointLink link = info[joint].link[side];
    (link.prev < 0 ? m_first[body] : info[JointOf(link.prev)].link[SideOf(link.prev)].next) = link.next;
    if (link.next >= 0) info[JointOf(link.next)].link[SideOf(link.next)].prev = link.prev;
    --m_count[body];
}

bool JointTable::Restore(WorldState* state, int bodyCount) {
    if (!slots.IsConsistent() || info.size() != ToSize(slots.Size())) return false;
    if (m_count.size() != m_first.size() || m_first.size() > ToSize(bodyCount)) return false;
    for (const JointIndex joint : slots.Rows()) {
        if (!slots.IsAlive(joint)) continue;
        const JointInfo& row = info[joint];
        for (const BodyIndex body : {row.bodyA, row.bodyB}) {
            if (!m_first.Has(body)) return false;
        }
        if (row.bodyA == row.bodyB) return false;
        if (!(row.forceThreshold >= 0.0f && row.torqueThreshold >= 0.0f)) return false;
        NoteThresholds(joint);
    }
    if (!RestoreHandles(state) || !AreListsWhole()) return false;
    CountBirths();
    return true;
}

void JointTable::CountBirths() {
    EnsureRows(m_births, info.size());
    m_nextBirth = slots.Count();
    int64_t birth = m_nextBirth;
    for (JointIndex joint = listHead; IsSome(joint); joint = info[joint].listNext) m_births[joint] = --birth;
}

bool JointTable::RestoreHandles(WorldState* state) {
    handles.assign(info.size(), nullptr);
    bool good = true;
    int64_t rows = 0;
    std::apply(
        [&](auto&... store) {
            const auto prepare = [&](auto& s) {
                good = good && s.slots.IsConsistent() && s.rows.size() == ToSize(s.slots.Size());
                rows += static_cast<int64_t>(s.slots.Count());
                for (Joint& handle : s.handles) handle.m_index = JointIndex::none;
                while (good && ToInt(s.handles.End()) < s.slots.Size())
                    s.handles.emplace_back(state, JointIndex::none, s.handles.End());
            };
            (prepare(store), ...);
        },
        stores);
    if (!good || rows != slots.Count()) return false;
    for (const JointIndex joint : slots.Rows()) {
        if (!slots.IsAlive(joint)) continue;
        const JointInfo& head = info[joint];
        WithStore(*this, head.type, [&](auto& store) {
            if (!store.slots.IsAlive(head.row)) return;
            Joint& handle = store.handles[head.row];
            if (IsSome(handle.m_index)) return;  // two joints with one row
            handle.m_index = joint;
            handles[joint] = &handle;
        });
        if (handles[joint] == nullptr) return false;
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
    for (JointIndex joint = listHead, prev = JointIndex::none; IsSome(joint);
         prev = joint, joint = info[joint].listNext, ++listed) {
        if (!slots.IsAlive(joint) || info[joint].listPrev != prev) return false;
    }
    if (listed != slots.Count()) return false;
    int entries = 0;
    for (const BodyIndex body : m_first.Rows()) {
        int count = 0;
        for (int entry = m_first[body], prev = -1; entry != -1; ++count) {
            if (entry < 0 || !slots.IsAlive(JointOf(entry))) return false;
            const JointInfo& row = info[JointOf(entry)];
            const JointLink& link = row.link[SideOf(entry)];
            if ((SideOf(entry) == 0 ? row.bodyA : row.bodyB) != body || link.prev != prev) return false;
            prev = entry;
            entry = link.next;
        }
        if (count != m_count[body]) return false;
        entries += count;
    }
    return entries == 2 * slots.Count();
}

JointIndex JointTable::NextOfBody(JointIndex joint, BodyIndex body) const {
    const JointInfo& row = info[joint];
    const int next = row.link[row.bodyA == body ? 0 : 1].next;
    return JointOf(next);
}

bool JointTable::MayCollide(BodyIndex bodyA, BodyIndex bodyB) const {
    if (!m_first.Has(bodyA) || !m_first.Has(bodyB)) return true;
    // The shorter of the two lists: a ground body can hold thousands of joints.
    const BodyIndex from = m_count[bodyA] <= m_count[bodyB] ? bodyA : bodyB;
    const BodyIndex to = from == bodyA ? bodyB : bodyA;
    for (const JointIndex j : OfBody(from)) {
        const JointInfo& row = info[j];
        const BodyIndex other = row.bodyA == from ? row.bodyB : row.bodyA;
        if (other == to && !row.collideConnected) return false;
    }
    return true;
}

void JointTable::ShiftOrigin(Vec2 newOrigin) {
    for (const JointIndex joint : slots.Rows()) {
        if (!slots.IsAlive(joint)) continue;
        const JointInfo& row = info[joint];
        WithStore(*this, row.type, [&](auto& store) { ShiftRow(store.rows[row.row], newOrigin); });
    }
}

size_t JointTable::GetMemoryBytes() const {
    size_t bytes = info.size() * (sizeof(JointInfo) + sizeof(Joint*) + sizeof(int64_t)) +
                   (m_first.size() + m_count.size()) * sizeof(int);
    std::apply(
        [&](const auto&... store) {
            ((bytes +=
              store.rows.size() * (sizeof(typename std::remove_reference_t<decltype(store.rows)>::value_type) +
                                   sizeof(typename std::remove_reference_t<decltype(store.handles)>::value_type))),
             ...);
        },
        stores);
    return bytes;
}

}  // namespace scree
